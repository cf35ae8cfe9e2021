"""Specs of the benchmark systems, as text.

Each system is written in two styles: ``positions`` (named positions, nhc differentiates them) and ``expanded``
(the kinetic energy and the constraints written out in the velocities, as a textbook prints them); and with or
without quasi-velocities.  Without them nhc has to choose its own.
"""

from __future__ import annotations

import re
from pathlib import Path

STYLES = ("positions", "expanded")
ROOT = Path(__file__).resolve().parent.parent
GALLERY = {path.stem: path for path in sorted((ROOT / "specs").glob("*.yaml"))}

Section = tuple[str, list[str] | str]


def spec(name: str, style: str = "positions", *, velocities: bool = True) -> str:
    """The YAML text of ``sleigh``, ``disk``, ``bicycle``, ``trailers<N>``, ``snake<N>``, ``pendulum<N>``, ``atoms<N>``,
    ``ball_arm<N>``, ``satellite<N>``, ``arm<N>``, ``bowl``, ``belt_egg``, ``submarine``,
    ``written_out_top``, ``written_out_arm<N>``, ``flat_arm<N>``, ``spherical<N>``, ``turned_top``,
    ``dome`` or ``turret``.

    ``bicycle`` is the gallery's own file with three rates named as quasi-velocities, and has one style.  Other systems of the
    gallery have one style too.

    Raises:
        KeyError: no such system or style.
    """
    family, count = split_name(name)
    if style not in STYLES:
        raise KeyError(style)
    if family not in _FAMILIES and name in GALLERY:
        text = GALLERY[name].read_text(encoding="utf-8")
    else:
        text = _FAMILIES[family](count, style == "expanded")
    return text if velocities else drop_section(text, "quasi_velocities")


def split_name(name: str) -> tuple[str, int]:
    """``trailers5`` -> ``("trailers", 5)``; a system without a size has 0."""
    found = re.fullmatch(r"([a-z_]+)(\d*)", name)
    if found is None:
        raise KeyError(name)
    return found[1], int(found[2] or 0)


def drop_section(text: str, key: str) -> str:
    """The spec without one of its top-level sections."""
    return re.sub(rf"(?m)^{key}:.*\n(?:[ -].*\n)*", "", text)


def _assemble(name: str, sections: list[Section]) -> str:
    lines = ["nhc: 1", f"system: {name}"]
    for key, body in sections:
        if isinstance(body, str):
            lines.append(f"{key}: {body}")
        elif body:
            lines += [f"{key}:", *(f"  {line}" for line in body)]
    return "\n".join(lines) + "\n"


def _scene(initial: str) -> Section:
    """A start at rest away from symmetric points."""
    return "scenes", ["start:", f"  initial: {{{initial}}}", "  time: [0, 1]"]


def _sleigh(_: int, expanded: bool) -> str:
    positions: list[Section] = [
        ("define", ["X: x + a*cos(theta)", "Y: y + a*sin(theta)"]),
        ("T", "m/2*(X'^2 + Y'^2) + J/2*theta'^2"),
    ]
    long = "m/2*(x'^2 + y'^2) + (J + m*a^2)/2*theta'^2 + m*a*theta'*(cos(theta)*y' - sin(theta)*x')"
    return _assemble(
        "sleigh",
        [
            ("coordinates", "[x, y, theta]"),
            ("parameters", "{m: 1, J: 0.5, a: 0.7}"),
            *([("T", long)] if expanded else positions),
            ("constraints", ["- slip: -sin(theta)*x' + cos(theta)*y' = 0"]),
            ("quasi_velocities", ["v: cos(theta)*x' + sin(theta)*y'", "w: theta'"]),
            _scene("theta: 0.1"),
        ],
    )


def _disk(_: int, expanded: bool) -> str:
    spin = "(psi' + cos(theta)*phi')"
    long = f"m/2*(x'^2 + y'^2 + R^2*cos(theta)^2*theta'^2) + A/2*(theta'^2 + sin(theta)^2*phi'^2) + C/2*{spin}^2"
    short = "m/2*(x'^2 + y'^2 + z'^2) + A/2*(theta'^2 + w_u^2) + C/2*w_n^2"
    return _assemble(
        "disk",
        [
            ("coordinates", "[x, y, phi, theta, psi]"),
            ("parameters", "{m: 1, R: 0.5, A: 0.0625, C: 0.125, g: 9.81}"),
            *([] if expanded else [("define", ["z: R*sin(theta)"])]),
            ("T", long if expanded else short.replace("w_u", "(sin(theta)*phi')").replace("w_n", spin)),
            ("V", "m*g*R*sin(theta)" if expanded else "m*g*z"),
            (
                "constraints",
                [
                    f"- roll_x: x' + R*cos(phi)*{spin} - R*sin(theta)*sin(phi)*theta' = 0",
                    f"- roll_y: y' + R*sin(phi)*{spin} + R*sin(theta)*cos(phi)*theta' = 0",
                ],
            ),
            ("quasi_velocities", ["w_t: theta'", "w_u: sin(theta)*phi'", "w_n: psi' + cos(theta)*phi'"]),
            _scene("phi: 0.1, theta: 1.2"),
        ],
    )


def _trailers(count: int, expanded: bool) -> str:
    """A car of wheelbase L with a steered front axle, and trailers hitched axle to axle."""
    axles = range(1, count + 1)
    define, squares = [], ["x'^2 + y'^2"]
    rows = [
        "- rear: -sin(theta0)*x' + cos(theta0)*y' = 0",
        "- front: -sin(theta0 + phi)*x' + cos(theta0 + phi)*y' + L*cos(phi)*theta0' = 0"
        if expanded
        else "- front: -sin(theta0 + phi)*xf' + cos(theta0 + phi)*yf' = 0",
    ]
    if not expanded:
        define = ["xf: x + L*cos(theta0)", "yf: y + L*sin(theta0)"]
    turns = "".join(f" + theta{i}'^2" for i in axles)
    for i in axles:
        before = i - 1 or ""
        if expanded:
            along = "".join(f" + L*sin(theta{j})*theta{j}'" for j in range(1, i + 1))
            across = "".join(f" - L*cos(theta{j})*theta{j}'" for j in range(1, i + 1))
            squares.append(f"(x'{along})^2 + (y'{across})^2")
            arms = "".join(f" - L*cos(theta{i} - theta{j})*theta{j}'" for j in range(1, i))
            rows.append(f"- axle{i}: -sin(theta{i})*x' + cos(theta{i})*y'{arms} - L*theta{i}' = 0")
        else:
            define += [f"x{i}: x{before} - L*cos(theta{i})", f"y{i}: y{before} - L*sin(theta{i})"]
            squares.append(f"x{i}'^2 + y{i}'^2")
            rows.append(f"- axle{i}: -sin(theta{i})*x{i}' + cos(theta{i})*y{i}' = 0")
    trailers = " + ".join(squares[1:])
    return _assemble(
        f"trailers{count}",
        [
            ("coordinates", "[x, y, theta0, phi, " + ", ".join(f"theta{i}" for i in axles) + "]"),
            ("parameters", "{m0: 1, J0: 0.1, Js: 0.02, m: 0.5, J: 0.05, L: 0.8}"),
            ("define", define),
            (
                "T",
                f"m0/2*({squares[0]}) + J0/2*theta0'^2 + Js/2*(theta0' + phi')^2 + m/2*({trailers})"
                f" + J/2*({turns[3:]})",
            ),
            ("constraints", rows),
            ("quasi_velocities", ["v: cos(theta0)*x' + sin(theta0)*y'", "w: phi'"]),
            _scene("phi: 0.2, " + ", ".join(f"theta{i}: {0.05 * (i % 7 + 1):.2f}" for i in axles)),
        ],
    )


def _snake(count: int, expanded: bool) -> str:
    """Links hinged in a row, a knife edge under the middle of each."""
    links = range(1, count + 1)
    define, squares, rows = [], ["x'^2 + y'^2"], ["- edge1: -sin(theta1)*x' + cos(theta1)*y' = 0"]
    for i in links[1:]:
        before = i - 1 if i > 2 else ""
        if expanded:
            arms = [(1, 1), *((j, 2) for j in range(2, i)), (i, 1)]
            factor = {1: "a", 2: "2*a"}
            along = "".join(f" + {factor[k]}*sin(theta{j})*theta{j}'" for j, k in arms)
            across = "".join(f" - {factor[k]}*cos(theta{j})*theta{j}'" for j, k in arms)
            squares.append(f"(x'{along})^2 + (y'{across})^2")
            lever = "".join(f" - {factor[k]}*cos(theta{i} - theta{j})*theta{j}'" for j, k in arms[:-1])
            rows.append(f"- edge{i}: -sin(theta{i})*x' + cos(theta{i})*y'{lever} - a*theta{i}' = 0")
        else:
            last = i - 1
            define += [
                f"x{i}: x{before} - a*cos(theta{last}) - a*cos(theta{i})",
                f"y{i}: y{before} - a*sin(theta{last}) - a*sin(theta{i})",
            ]
            squares.append(f"x{i}'^2 + y{i}'^2")
            rows.append(f"- edge{i}: -sin(theta{i})*x{i}' + cos(theta{i})*y{i}' = 0")
    turns = " + ".join(f"theta{i}'^2" for i in links)
    return _assemble(
        f"snake{count}",
        [
            ("coordinates", "[x, y, " + ", ".join(f"theta{i}" for i in links) + "]"),
            ("parameters", "{m: 1, J: 0.1, a: 0.5}"),
            ("define", define),
            ("T", f"m/2*({' + '.join(squares)}) + J/2*({turns})"),
            ("constraints", rows),
            ("quasi_velocities", ["v: cos(theta1)*x' + sin(theta1)*y'", "w: theta1'"]),
            _scene(", ".join(f"theta{i}: {0.3 * (-1) ** i / (i % 3 + 1):.3f}" for i in links)),
        ],
    )


def _pendulum(count: int, expanded: bool) -> str:
    """Point masses on massless rods in a row under a cart on a rail; angles from the vertical."""
    bobs = range(1, count + 1)
    define, squares, heights = [], [], []
    for i in bobs:
        before = i - 1 if i > 1 else ""
        if expanded:
            along = "".join(f" + l*cos(theta{j})*theta{j}'" for j in range(1, i + 1))
            across = "".join(f" + l*sin(theta{j})*theta{j}'" for j in range(1, i + 1))
            squares.append(f"(x'{along})^2 + ({across[3:]})^2")
            heights.append(f"{count - i + 1}*cos(theta{i})")
        else:
            define.append(f"x{i}: x{before} + l*sin(theta{i})")
            define.append(f"y{i}: " + (f"y{before} - l*cos(theta{i})" if i > 1 else "-l*cos(theta1)"))
            squares.append(f"x{i}'^2 + y{i}'^2")
    potential = f"-m*g*l*({' + '.join(heights)})" if expanded else f"m*g*({' + '.join(f'y{i}' for i in bobs)})"
    return _assemble(
        f"pendulum{count}",
        [
            ("coordinates", "[x, " + ", ".join(f"theta{i}" for i in bobs) + "]"),
            ("parameters", "{M: 1.5, m: 0.5, l: 0.7, g: 9.81}"),
            ("define", define),
            ("T", f"M/2*x'^2 + m/2*({' + '.join(squares)})"),
            ("V", potential),
            _scene(", ".join(f"theta{i}: {0.1 * (i % 5 + 1):.1f}" for i in bobs)),
        ],
    )


def _atoms(count: int, expanded: bool) -> str:
    """Point masses in a plane, any two with the potential of Lennard-Jones."""
    pairs = [(i, j) for j in range(1, count + 1) for i in range(1, j)]
    define, terms = [], []
    for i, j in pairs:
        square = f"(x{j} - x{i})^2 + (y{j} - y{i})^2"
        if expanded:
            terms.append(f"s^12/({square})^6 - s^6/({square})^3")
        else:
            define.append(f"r{i}{j}: sqrt({square})")
            terms.append(f"(s/r{i}{j})^12 - (s/r{i}{j})^6")
    atoms = range(1, count + 1)
    squares = " + ".join(f"x{i}'^2 + y{i}'^2" for i in atoms)
    return _assemble(
        f"atoms{count}",
        [
            ("coordinates", "[" + ", ".join(f"x{i}, y{i}" for i in atoms) + "]"),
            ("parameters", "{m: 1, e: 1, s: 1}"),
            ("define", define),
            ("T", f"m/2*({squares})"),
            ("V", f"4*e*({' + '.join(terms)})"),
            _scene(", ".join(f"x{i}: {1.1 * (i % 3):.1f}, y{i}: {0.9 * (i // 3) + 0.2 * (i % 2):.1f}" for i in atoms)),
        ],
    )


def _ball_arm(count: int, _: bool) -> str:
    """A ball that rolls, and on it an arm of universal joints, each by two angles from the body before."""
    entries = [[f"R_{a}{j}" for j in (1, 2, 3)] for a in "xyz"]
    spin, foot, define = ["p", "q", "r"], ["x", "y", "0"], []
    kinetic = ["M/2*(x'^2 + y'^2) + K/2*(p^2 + q^2 + r^2)"]
    for k in range(1, count + 1):
        define += [f"o{k}{a}: {at} + l*{row[2]}" for a, at, row in zip("xyz", foot, entries, strict=True)]
        foot = [f"o{k}{a}" for a in "xyz"]
        for axis, angle in enumerate((f"a{k}", f"b{k}")):
            i, j = (axis + 1) % 3, (axis + 2) % 3
            old, before = [list(row) for row in entries], list(spin)
            for a, row in zip("xyz", old, strict=True):
                define.append(f"{angle}_{a}{i + 1}: {row[i]}*cos({angle}) + {row[j]}*sin({angle})")
                define.append(f"{angle}_{a}{j + 1}: {row[j]}*cos({angle}) - {row[i]}*sin({angle})")
            define.append(f"{angle}_w{i + 1}: {before[i]}*cos({angle}) + {before[j]}*sin({angle})")
            define.append(f"{angle}_w{j + 1}: {before[j]}*cos({angle}) - {before[i]}*sin({angle})")
            define.append(f"{angle}_w{axis + 1}: {before[axis]} + {angle}'")
            for n, a in enumerate("xyz"):
                entries[n][i], entries[n][j] = f"{angle}_{a}{i + 1}", f"{angle}_{a}{j + 1}"
            spin = [f"{angle}_w{n}" for n in (1, 2, 3)]
        define += [f"c{k}{a}: {at} + c*{row[2]}" for a, at, row in zip("xyz", foot, entries, strict=True)]
        kinetic.append(f"m/2*(c{k}x'^2 + c{k}y'^2 + c{k}z'^2)")
        kinetic += [f"{inertia}/2*{w}^2" for inertia, w in zip("ABC", spin, strict=True)]
    return _assemble(
        f"ball_arm{count}",
        [
            ("coordinates", "[x, y, " + ", ".join(f"a{k}, b{k}" for k in range(1, count + 1)) + "]"),
            ("rotation", ["R: {velocities: [p, q, r]}"]),
            ("parameters", "{g: 9.81, M: 3, K: 0.3, d: 0.5, l: 0.4, c: 0.2, m: 1, A: 0.1, B: 0.12, C: 0.02}"),
            ("define", define),
            ("T", " + ".join(kinetic)),
            ("V", "m*g*(" + " + ".join(f"c{k}z" for k in range(1, count + 1)) + ")"),
            ("constraints", ["- x' - d*(R_y1*p + R_y2*q + R_y3*r) = 0", "- y' + d*(R_x1*p + R_x2*q + R_x3*r) = 0"]),
            _scene("p: 0.5, a1: 0.3"),
        ],
    )


def _satellite(count: int, _: bool) -> str:
    """A body by three angles, without an axis of symmetry, and wheels that are driven on its axes."""
    names = [f"w{k}" for k in range(1, count + 1)]
    wheels = []
    for k, name in enumerate(names):
        axis, inertia = "xyz"[k % 3], ", ".join("J" if i == k % 3 else "K" for i in range(3))
        wheels.append(f"{name}: {{parent: base, turns: [{axis}: q{name}], inertia: [{inertia}]}}")
    angles = ["yaw", "pitch", "roll"]
    return _assemble(
        f"satellite{count}",
        [
            ("coordinates", f"[{', '.join([*angles, *(f'q{name}' for name in names)])}]"),
            ("parameters", "{A: 0.4, B: 0.5, C: 0.6, D: 0.01, E: 0.02, F: 0.03, J: 0.01, K: 0.006, torque: 0.01}"),
            (
                "bodies",
                [
                    "base:",
                    "  turns: [z: yaw, y: pitch, x: roll]",
                    "  inertia: {xx: A, yy: B, zz: C, xy: D, xz: E, yz: F}",
                    *wheels,
                ],
            ),
            ("forces", [f"q{name}: torque" for name in names]),
            _scene("roll': 0.3, pitch': 0.1"),
        ],
    )


def _bowl(_: int, __: bool) -> str:
    """A ball rolls in a spherical bowl; its angular velocity is on its own axes."""
    normal = ["sin(theta)*cos(phi)", "sin(theta)*sin(phi)", "-cos(theta)"]
    return _assemble(
        "bowl",
        [
            ("coordinates", "[phi, theta]"),
            ("rotation", ["B: {velocities: [p, q, r]}"]),
            ("parameters", "{m: 1, a: 0.2, J: 0.016, R: 1, g: 9.81}"),
            (
                "bodies",
                [f"ball: {{at: [{', '.join(f'(R-a)*{n}' for n in normal)}], rotation: B, mass: m, inertia: J}}"],
            ),
            ("gravity", "[0, 0, -g]"),
            ("points", [f"contact: {{of: ball, at: [{', '.join(f'R*{n}' for n in normal)}]}}"]),
            (
                "constraints",
                [
                    "- contact_vy*cos(phi) - contact_vx*sin(phi) = 0",
                    "- (contact_vx*cos(phi) + contact_vy*sin(phi))*cos(theta) + contact_vz*sin(theta) = 0",
                ],
            ),
            _scene("theta: 0.4, r: 2"),
        ],
    )


def _dome(_: int, __: bool) -> str:
    """A ball that rolls on a fixed sphere, by two coordinates of its centre and its angular velocity."""
    return _assemble(
        "dome",
        [
            ("coordinates", "[x, y]"),
            ("rotation", ["R: {velocities: [wx, wy, wz], frame: space}"]),
            ("parameters", "{m: 1, a: 0.1, b: 2.5, g: 9.81}"),
            ("define", ["z: sqrt((a + b)^2 - x^2 - y^2)", "nx: x/(a + b)", "ny: y/(a + b)", "nz: z/(a + b)"]),
            ("T", "m/2*(x'^2 + y'^2 + z'^2) + m*a^2/5*(wx^2 + wy^2 + wz^2)"),
            ("V", "m*g*z"),
            ("constraints", ["- x' - a*(wy*nz - wz*ny) = 0", "- y' - a*(wz*nx - wx*nz) = 0"]),
            _scene("wz: 150"),
        ],
    )


def _turret(_: int, __: bool) -> str:
    """A weight slides in a turning tube and carries a pendulum, without gravity."""
    return _assemble(
        "turret",
        [
            ("coordinates", "[th, r, a]"),
            ("parameters", "{I: 0.3, m1: 0.4, m2: 0.5, l2: 0.6, k: 0.7, l1: 0.8}"),
            ("define", ["x: r*cos(th)", "y: r*sin(th)", "X: x + l2*cos(a + th)", "Y: y + l2*sin(a + th)"]),
            ("T", "m1/2*(x'^2 + y'^2) + m2/2*(X'^2 + Y'^2) + I*th'^2/2"),
            ("V", "k*(r - l1)^2/2"),
            _scene("th: 0.3, r: 1, a: 0.4, th': 1"),
        ],
    )


def _turned_top(_: int, __: bool) -> str:
    """A heavy top whose quasi-velocities are on its own axes, written with the angular velocity in space."""
    own = [f"B_x{k}*p + B_y{k}*q + B_z{k}*r" for k in (1, 2, 3)]
    return _assemble(
        "turned_top",
        [
            ("rotation", ["B: {velocities: [p, q, r], frame: space}"]),
            ("parameters", "{J1: 1, J2: 2, J3: 2.5, m: 1, g: 9.81, h: 0.3}"),
            ("define", [f"w{k}: {value}" for k, value in enumerate(own, 1)]),
            ("T", "(J1*w1^2 + J2*w2^2 + J3*w3^2)/2"),
            ("V", "m*g*h*B_z3"),
            ("quasi_velocities", [f"u{k}: w{k}" for k in (1, 2, 3)]),
            _scene("u1: 0.3, u3: 5"),
        ],
    )


def _arm(count: int, _: bool) -> str:
    """An arm of hinges about z, every second one at right angles to the one before it."""
    bodies = []
    for k in range(1, count + 1):
        place = f"parent: b{k - 1}, at: [l, 0, 0], " if k > 1 else ""
        turns = f"z: q{k}" if k % 2 else f"x: pi/2, z: q{k}"
        bodies.append(f"b{k}: {{{place}turns: [{turns}], mass: m, centre: [c, 0, 0], inertia: [A, B, C]}}")
    return _assemble(
        f"arm{count}",
        [
            ("coordinates", f"[{', '.join(f'q{k}' for k in range(1, count + 1))}]"),
            ("parameters", "{g: 9.81, l: 0.4, c: 0.15, m: 1.2, A: 0.01, B: 0.03, C: 0.04}"),
            ("bodies", bodies),
            ("gravity", "[0, 0, -g]"),
            _scene("q1: 0.3, q2: 0.5"),
        ],
    )


def _belt_egg(_: int, __: bool) -> str:
    """An ellipsoid of revolution rolls on a belt; its contact is written on the axes of the ground below it."""
    return _assemble(
        "belt_egg",
        [
            ("coordinates", "[x, y, phi, th, psi]"),
            ("parameters", "{m: 1, a: 0.5, b: 0.3, A: 0.08, C: 0.1, g: 9.81, v: 0.7}"),
            ("define", ["h: sqrt(a^2*sin(th)^2 + b^2*cos(th)^2)"]),
            (
                "bodies",
                [
                    "frame: {at: [x, y, h], turns: [z: phi, x: th]}",
                    "egg: {parent: frame, turns: [z: psi], mass: m, inertia: [A, A, C]}",
                    "ground: {at: [x, y, h], turns: [z: phi]}",
                ],
            ),
            ("points", ["P: {parent: ground, of: egg, at: [0, (b^2 - a^2)*sin(th)*cos(th)/h, -h]}"]),
            ("gravity", "[0, 0, -g]"),
            ("constraints", ["- P_v1 = v*cos(phi)", "- P_v2 = -v*sin(phi)"]),
            _scene("th: 1.2, psi': 3"),
        ],
    )


def _submarine(_: int, __: bool) -> str:
    """A vessel under water in velocities on its own axes, with added masses and its weight below its buoyancy."""
    lines = {k: f"{name}: R_x{k}*x' + R_y{k}*y' + R_z{k}*z'" for k, name in enumerate("uvw", start=1)}
    return _assemble(
        "submarine",
        [
            ("coordinates", "[x, y, z]"),
            ("rotation", "{R: {velocities: [p, q, r]}}"),
            (
                "parameters",
                "{m1: 11, m2: 18, m3: 20, A: 1, B: 2, C: 2.2, b: 0.5, c: 0.4, W: 98, G: 99, h: 0.05, F: 20, d: 5}",
            ),
            ("quasi_velocities", list(lines.values())),
            ("T", "(m1*u^2 + m2*v^2 + m3*w^2 + A*p^2 + B*q^2 + C*r^2)/2 + b*(u*q - v*p) + c*(v*r - w*q)"),
            ("V", "(W - G)*z - W*h*R_z3"),
            ("forces", ["u: F - d*u*abs(u)", "v: -d*v*abs(v)", "w: -d*w*abs(w)", "p: -d*p", "q: -d*q", "r: -d*r"]),
            _scene("u: 1, r: 0.1"),
        ],
    )


def _written_out_top(_: int, __: bool) -> str:
    """A heavy top, its T multiplied out as one finds it in books."""
    return _assemble(
        "written_out_top",
        [
            ("coordinates", "[phi, theta, psi]"),
            ("parameters", "{A: 0.3, C: 0.2, m: 1, g: 9.81, l: 0.2}"),
            (
                "T",
                "A/2*theta'^2 + (A*sin(theta)^2 + C*cos(theta)^2)/2*phi'^2 + C/2*psi'^2 + C*cos(theta)*phi'*psi'",
            ),
            ("V", "m*g*l*cos(theta)"),
            _scene("theta: 0.5, psi': 20"),
        ],
    )


def _written_out_arm(count: int, _: bool) -> str:
    """Links in a plane by the angles of their joints, energies multiplied out as books on robots have them."""
    links = range(1, count + 1)
    rate = {k: "(" + " + ".join(f"q{i}'" for i in range(1, k + 1)) + ")" for k in links}
    angle = {(i, k): " + ".join(f"q{j}" for j in range(i, k + 1)) for k in links for i in range(1, k + 1)}
    kinetic, potential = list[str](), list[str]()
    for k in links:
        reach = {i: f"s{i}" if i == k else f"l{i}" for i in range(1, k + 1)}
        terms = [f"{a}^2*{rate[i]}^2" for i, a in reach.items()]
        terms += [
            f"2*{reach[i]}*{reach[j]}*cos({angle[i + 1, j]})*{rate[i]}*{rate[j]}" for j in reach for i in range(1, j)
        ]
        kinetic += [f"m{k}/2*({' + '.join(terms)})", f"I{k}/2*{rate[k]}^2"]
        potential.append(f"m{k}*g*({' + '.join(f'{a}*sin({angle[1, i]})' for i, a in reach.items())})")
    return _arm_of_links(f"written_out_arm{count}", count, [("T", " + ".join(kinetic)), ("V", " + ".join(potential))])


def _flat_arm(count: int, _: bool) -> str:
    """Links by the angles of their joints in a plane without weight, as in a robot that places parts."""
    define, kinetic = list[str](), list[str]()
    for k in range(1, count + 1):
        angle, before = " + ".join(f"q{i}" for i in range(1, k + 1)), f"{k - 1} + " if k > 1 else ""
        for axis, name in (("x", "cos"), ("y", "sin")):
            foot = f"{axis}{before}" if before else ""
            define += [f"{axis}{k}: {foot}l{k}*{name}({angle})", f"c{axis}{k}: {foot}s{k}*{name}({angle})"]
        define.append(f"A{k}: {angle}")
        kinetic.append(f"m{k}/2*(cx{k}'^2 + cy{k}'^2) + I{k}/2*A{k}'^2")
    forces = ", ".join(f"q{k}: {k}" for k in range(1, count + 1))
    sections: list[Section] = [("define", define), ("T", " + ".join(kinetic)), ("forces", f"{{{forces}}}")]
    return _arm_of_links(f"flat_arm{count}", count, sections)


def _spherical(count: int, _: bool) -> str:
    """Links in space by angles, each with its mass between its ends."""
    links = range(1, count + 1)
    define, kinetic, heights = list[str](), list[str](), list[str]()
    for k in links:
        turned = {"x": f"sin(a{k})*cos(b{k})", "y": f"sin(a{k})*sin(b{k})", "z": f"-cos(a{k})"}
        for axis, unit in turned.items():
            foot = f"{axis}{k - 1} + " if k > 1 else ""
            define += [f"{axis}{k}: {foot}l{k}*({unit})", f"c{axis}{k}: {foot}s{k}*({unit})"]
        kinetic.append(f"m{k}/2*(cx{k}'^2 + cy{k}'^2 + cz{k}'^2)")
        heights.append(f"m{k}*g*cz{k}")
    values = ", ".join(f"m{k}: {1 + k / 10}, l{k}: {0.5 + k / 10}, s{k}: {0.2 + k / 10}" for k in links)
    return _assemble(
        f"spherical{count}",
        [
            ("coordinates", f"[{', '.join(f'a{k}, b{k}' for k in links)}]"),
            ("parameters", f"{{g: 9.81, {values}}}"),
            ("define", define),
            ("T", " + ".join(kinetic)),
            ("V", " + ".join(heights)),
            _scene("a1: 0.5, b1': 2"),
        ],
    )


def _arm_of_links(name: str, count: int, sections: list[Section]) -> str:
    """Its joints q, masses m, moments of inertia I, lengths l and distances s of the centres from the joints."""
    links, gravity = range(1, count + 1), ["g: 9.81"] if any(key == "V" for key, _ in sections) else []
    values = (f"m{k}: {1 + k / 10}, I{k}: {0.1 + k / 100}, l{k}: {0.5 + k / 10}, s{k}: {0.2 + k / 10}" for k in links)
    return _assemble(
        name,
        [
            ("coordinates", f"[{', '.join(f'q{k}' for k in links)}]"),
            ("parameters", f"{{{', '.join([*gravity, *values])}}}"),
            *sections,
            _scene("q1: 0.3, q2: 0.5"),
        ],
    )


def _bicycle(_: int, __: bool) -> str:
    given = "quasi_velocities:\n  u_roll: roll'\n  u_steer: steer'\n  u_rear: thR'\n"
    text = (ROOT / "specs" / "bicycle.yaml").read_text(encoding="utf-8")
    return text.replace("dependent: [", given + "dependent: [", 1)


_FAMILIES = {
    "sleigh": _sleigh,
    "disk": _disk,
    "trailers": _trailers,
    "snake": _snake,
    "pendulum": _pendulum,
    "atoms": _atoms,
    "ball_arm": _ball_arm,
    "satellite": _satellite,
    "bicycle": _bicycle,
    "bowl": _bowl,
    "turned_top": _turned_top,
    "dome": _dome,
    "turret": _turret,
    "arm": _arm,
    "belt_egg": _belt_egg,
    "submarine": _submarine,
    "written_out_top": _written_out_top,
    "written_out_arm": _written_out_arm,
    "flat_arm": _flat_arm,
    "spherical": _spherical,
}
