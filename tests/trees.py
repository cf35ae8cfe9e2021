"""Specs of random trees of hinged bodies: planar ones with knife edges, and spatial ones that turn and roll."""

from __future__ import annotations

import random
import re
from collections.abc import Sequence

from nhc.diagnostics import Source


def planar_tree(seed: int, *, written: bool = False) -> str:
    """Links hinged to earlier links, some with knife edges and a second mass, on an incline, with joint springs.

    With ``written`` the positions are put into T and the constraints instead of being named.
    """
    draw = random.Random(seed)
    count = draw.randrange(2, 5)
    parents = [draw.randrange(k) for k in range(1, count)]
    relative = draw.random() < 0.4
    angle = ["a0"]
    for k, parent in enumerate(parents, start=1):
        angle.append(f"({angle[parent]} + a{k})" if relative else f"a{k}")
    edges = sorted({0, *draw.sample(range(count), draw.randrange(1, count))})
    points: dict[str, tuple[str, str]] = {"base": ("x", "y")}

    def point(name: str, start: str, k: int, along: str, across: str) -> str:
        x, y = points[start]
        u, w = f"cos({angle[k]})", f"sin({angle[k]})"
        places = (f"{x} + {along}*{u} - {across}*{w}", f"{y} + {along}*{w} + {across}*{u}")
        if across == "0":
            places = (f"{x} + {along}*{u}", f"{y} + {along}*{w}")
        if written:
            points[name] = (f"({places[0]})", f"({places[1]})")
        else:
            define.append(f"  x_{name}: {places[0]}")
            define.append(f"  y_{name}: {places[1]}")
            points[name] = (f"x_{name}", f"y_{name}")
        return name

    define: list[str] = []
    square = lambda name: f"({points[name][0]})'^2 + ({points[name][1]})'^2"  # noqa: E731
    energy, potential, rows = [], [], []
    for k in range(count):
        root = "base" if k == 0 else point(f"hinge{k}", f"tip{parents[k - 1]}", k, "0.1", "0")
        mass = point(f"mass{k}", root, k, f"b{k}", draw.choice(["0", "0.05"]))
        energy.append(f"m{k}/2*({square(mass)}) + J{k}/2*({angle[k]})'^2")
        potential.append(f"m{k}*g*{points[mass][1]}")
        if draw.random() < 0.5:
            more = point(f"more{k}", root, k, "0.35", "0.2")
            energy.append(f"0.4/2*({square(more)})")
        if k in edges:
            contact = root if draw.random() < 0.5 else point(f"edge{k}", root, k, "-0.2", "0")
            x, y = points[contact]
            rows.append(f"  - edge{k}: -sin({angle[k]})*({x})' + cos({angle[k]})*({y})' = 0")
        point(f"tip{k}", root, k, "0.9", "0")
    for k in range(1, count):
        potential.append(f"s/2*a{k}^2")
    potential.append(f"0.3*{points['mass0'][0]}*cos(a{count - 1})")
    names = ", ".join(f"a{k}" for k in range(count))
    values = ", ".join(f"m{k}: {1 + k}, J{k}: 0.{k + 2}, b{k}: 0.{k + 3}" for k in range(count))
    lines = ["nhc: 1", "system: tree", f"coordinates: [x, y, {names}]", f"parameters: {{g: 3, s: 2, {values}}}"]
    if define:
        lines += ["define:", *define]
    lines += [f"T: {' + '.join(energy)}", f"V: {' + '.join(potential)}", "constraints:", *rows]
    if draw.random() < 0.5:
        lines += ["quasi_velocities:", f"  v: cos({angle[0]})*x' + sin({angle[0]})*y'"]
    return "\n".join(lines) + "\n"


def spatial_pair(seed: int) -> str:
    """A body that is turned about three axes, with two masses, and another hinged to it about an axis that stands askew.

    Its angular velocity on its own axes is written out; a point of it is held against sliding or along one direction.
    """
    draw = random.Random(seed)
    sa, ca, sb, cb, sc, cc = (f"{name}({angle})" for angle in "abc" for name in ("sin", "cos"))
    define = {  # axes of the body turned by a about z, b about x, c about y
        "e1x": f"{ca}*{cc} - {sa}*{sb}*{sc}",
        "e1y": f"{sa}*{cc} + {ca}*{sb}*{sc}",
        "e1z": f"-{cb}*{sc}",
        "e2x": f"-{sa}*{cb}",
        "e2y": f"{ca}*{cb}",
        "e2z": sb,
        "e3x": f"{ca}*{sc} + {sa}*{sb}*{cc}",
        "e3y": f"{sa}*{sc} - {ca}*{sb}*{cc}",
        "e3z": f"{cb}*{cc}",
        "w1": f"{cc}*b' - {cb}*{sc}*a'",
        "w2": f"c' + {sb}*a'",
        "w3": f"{sc}*b' + {cb}*{cc}*a'",
    }
    arm = [draw.randrange(1, 9) / 10 for _ in range(3)]
    for axis in "xyz":
        define[f"P{axis}"] = f"{axis} + {arm[0]}*e1{axis} + l*e3{axis}"
        define[f"S{axis}"] = f"{axis} + {arm[1]}*e1{axis} - {arm[2]}*e3{axis}"
        # the second body: axis s askew by the constant angle k in the plane of e1 and e3, turned by d about it
        define[f"s{axis}"] = f"sin(k)*e1{axis} + cos(k)*e3{axis}"
        define[f"f{axis}"] = f"cos(d)*(cos(k)*e1{axis} - sin(k)*e3{axis}) + sin(d)*e2{axis}"
        define[f"H{axis}"] = f"S{axis} + h*f{axis} + 0.15*s{axis}"
        define[f"K{axis}"] = f"S{axis} - 0.25*f{axis}"
    square = lambda name: " + ".join(f"{name}{axis}'^2" for axis in "xyz")  # noqa: E731
    energy = [
        f"m/2*({' + '.join(f'{axis}{chr(39)}^2' for axis in 'xyz')})",
        f"m/3*({square('P')})",
        f"n/2*({square('H')})",
        "(A*w1^2 + B*w2^2 + C*w3^2)/2",
        "B/9*(d' + sin(k)*w1 + cos(k)*w3)^2",
    ]
    if draw.random() < 0.5:
        energy.append(f"n/5*({square('K')})")
    if draw.random() < 0.5:
        rows = [f"roll_{axis}: {axis}' + R*w2*e1{axis} - R*w1*e2{axis} = 0" for axis in "xyz"]
    else:
        rows = [f"slip: e2x*{draw.choice('PS')}x' + e2y*x' + e2z*z' = 0", "spin: w3 = 0"]
    lines = ["nhc: 1", "system: pair", "coordinates: [x, y, z, a, b, c, d]"]
    lines += ["parameters: {m: 1, n: 0.7, l: 0.3, h: 0.4, k: 0.5, A: 0.3, B: 0.4, C: 0.5, R: 0.6, g: 9.81}", "define:"]
    lines += [f"  {name}: {value}" for name, value in define.items()]
    lines += [
        f"T: {' + '.join(energy)}",
        "V: g*(m*z + m*Pz + n*Hz) + Pz^2 + Hz*sin(d)",
        "constraints:",
        *(f"  - {r}" for r in rows),
    ]
    return "\n".join(lines) + "\n"


def robot_arm(seed: int, joints: int = 3) -> str:
    """An arm of bodies in space, each turned by one angle about an axis of the one before, on a base that stands still."""
    draw = random.Random(seed)
    define: dict[str, str] = {}
    axes = [{k: ["1" if i == k else "0" for i in range(3)] for k in range(3)}]
    spin, place, energy, potential = ["0"] * 3, ["0"] * 3, [], []
    for j in range(1, joints + 1):
        a = draw.randrange(3)
        b, c = (a + 1) % 3, (a + 2) % 3
        s, co, before = f"sin(q{j})", f"cos(q{j})", axes[-1]
        axes.append({k: [f"e{j}{k}{x}" for x in "xyz"] for k in range(3)})
        for i in range(3):
            define[axes[j][a][i]] = before[a][i]
            define[axes[j][b][i]] = f"{co}*{before[b][i]} + {s}*{before[c][i]}"
            define[axes[j][c][i]] = f"{co}*{before[c][i]} - {s}*{before[b][i]}"
        define |= {f"w{j}{a}": f"{spin[a]} + q{j}'", f"w{j}{b}": f"{co}*{spin[b]} + {s}*{spin[c]}"}
        define[f"w{j}{c}"] = f"{co}*{spin[c]} - {s}*{spin[b]}"
        spin = [f"w{j}{k}" for k in range(3)]
        for i, x in enumerate("xyz"):
            define[f"G{j}{x}"] = f"{place[i]} + c{j}*{axes[j][2][i]}"
            define[f"P{j}{x}"] = f"{place[i]} + l{j}*{axes[j][2][i]} + 0.1*{axes[j][0][i]}"
        place = [f"P{j}{x}" for x in "xyz"]
        energy.append(f"m{j}/2*(G{j}x'^2 + G{j}y'^2 + G{j}z'^2) + (A{j}*w{j}0^2 + B{j}*w{j}1^2 + C{j}*w{j}2^2)/2")
        potential.append(f"m{j}*g*G{j}z")
    values = ", ".join(
        f"m{j}: {j}, c{j}: 0.2, l{j}: 0.4, A{j}: 0.1, B{j}: 0.12, C{j}: 0.05" for j in range(1, joints + 1)
    )
    lines = ["nhc: 1", "system: robot", f"coordinates: [{', '.join(f'q{j}' for j in range(1, joints + 1))}]"]
    lines += [
        f"parameters: {{g: 9.81, {values}}}",
        "define:",
        *(f"  {name}: {value}" for name, value in define.items()),
    ]
    return "\n".join([*lines, f"T: {' + '.join(energy)}", f"V: {' + '.join(potential)}"]) + "\n"


def joints(count: int) -> Source:
    """Bodies on universal joints, each hung on the one before."""
    return _chain([f"x: p{i}, y: q{i}" for i in range(count)], "[0, 0, -l]", "[0, 0, -c]")


def hinges(count: int) -> Source:
    """Bodies on hinges about z, y and x in turn, with centres and hinges beside their axes."""
    return _chain([f"{'zyx'[i % 3]}: p{i}" for i in range(count)], "[0.1, 0.2, -l]", "[0.1, 0.05, -c]")


def _chain(turns: Sequence[str], at: str, centre: str) -> Source:
    names = re.findall(r"\b[pq]\d+", ", ".join(turns))
    lines = ["nhc: 1", "system: joints", f"coordinates: [{', '.join(names)}]"]
    lines += ["parameters: {m: 1, l: 1, c: 0.5, A: 0.1, B: 0.12, C: 0.05}", "bodies:"]
    for i, turn in enumerate(turns):
        place = f"parent: b{i - 1}, at: {at}" if i else "at: [0, 0, 0]"
        lines.append(f"  b{i}: {{{place}, turns: [{turn}], mass: m, centre: {centre}, inertia: [A, B, C]}}")
    lines += ["gravity: [0, 0, -9.81]", "scenes:", "  go: {initial: {p0: 0.5}, time: [0, 1]}"]
    return Source("joints.yaml", "\n".join(lines) + "\n")
