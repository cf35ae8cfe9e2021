"""Dry friction: a run goes on with what it holds as one more constraint, until it breaks loose."""

from __future__ import annotations

import json
import math
import random
from itertools import combinations
from pathlib import Path

import numpy
import pytest
from scipy.optimize import linprog

from nhc.cli import main
from nhc.language import Source
from nhc.pipeline import check
from nhc.simulate.changes import Changes
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run

pytestmark = pytest.mark.usefixtures("optimised_models")
BOTH = pytest.mark.parametrize("compiled", [False, True])

THROWN = """nhc: 1
system: thrown
coordinates: [x, th]
parameters: {m: 1.5, r: 0.7, J: 0.4, mu: 0.3, g: 9.81, F: 0}
define: {slip: x' - r*th'}
T: m*x'^2/2 + J*th'^2/2
forces: {x: F - mu*m*g*sign(slip), th: r*mu*m*g*sign(slip)}
outputs: {friction: -mu*m*g*sign(slip)}
scenes:
  throw: {initial: {x': 4, th': 1}, time: [0, 5], need: [x, th, x', th', friction]}
  pull: {parameters: {F: 2}, time: [0, 5], need: [x, th, x', th', friction]}
"""
STACK = """nhc: 1
system: stack
coordinates: [X, x]
parameters: {M: 2, m: 1, c1: 3, c2: 0.8, a: 1.5}
T: M*X'^2/2 + m*x'^2/2
define: {u: X - x}
forces: {X: a*t - c1*sign(X'), u: -c2*sign(u')}
outputs: {ground: -c1*sign(X'), between: -c2*sign(u')}
scenes: {pull: {time: [0, 8], need: [X, x, X', x', ground, between]}}
"""
BELT = """nhc: 1
system: belt
coordinates: [x]
parameters: {m: 1, k: 20, c: 3, V: 0.4, d: 0.6}
T: m*x'^2/2
V: k*x^2/2
forces: {x: "-d*x' + FRICTION"}
scenes: {a: {time: [0, 6], need: [x, x']}}
"""
SKATE = """nhc: 1
system: braked
coordinates: [x, y, th]
parameters: {m: 2, J: 0.3, a: 0.1, c: 0.4, d: 0.2}
define: {v: cos(th)*x' + sin(th)*y'}
T: m*((x' - a*th'*sin(th))^2 + (y' + a*th'*cos(th))^2)/2 + J*th'^2/2
constraints: [x'*sin(th) = y'*cos(th)]
forces: {v: -c*sign(v), th: -d*sign(th')}
scenes: {go: {initial: {th: 0.3, x': 2*cos(0.3), y': 2*sin(0.3), th': 1.5}, time: [0, 12], need: [x, y, th]}}
"""


def motion(text: str, scene: str = "", compiled: bool = False, **settings: object) -> Trajectory:
    job = open_scene(
        Source("sticking.yaml", text),
        scene,
        formulation=str(settings.pop("formulation", "")),
        until=str(settings.pop("until", "")),
        stay=bool(settings.pop("stay", False)),
        method=str(settings.get("method", "auto")),
    )
    return run(job, Settings(points=21, compiled=compiled, **settings))  # type: ignore[arg-type]


@BOTH
@pytest.mark.parametrize("method", ["auto", "dopri5", "radau5"])
def test_a_body_that_is_thrown_slides_until_it_rolls(method: str, compiled: bool) -> None:
    """The slip falls by mu g (1 + m r^2/J) each second; then it rolls, and no friction is left."""
    found = motion(THROWN, "throw", compiled, method=method)
    assert found.ended == "done"
    rolls = (4 - 0.7) / (0.3 * 9.81 * (1 + 1.5 * 0.7**2 / 0.4))
    (note,) = found.notes
    assert note == f"from t = {float(note.split()[3]):.9g} on dry friction holds `slip` at zero"
    assert float(note.split()[3]) == pytest.approx(rolls, rel=1e-7)
    speed = 4 - 0.3 * 9.81 * rolls
    x, th, xp, thp, friction = found.rows[-1]
    assert (xp, thp) == pytest.approx((speed, speed / 0.7), rel=1e-7)
    assert x == pytest.approx(4 * rolls - 0.15 * 9.81 * rolls**2 + speed * (5 - rolls), rel=1e-7)
    assert th == pytest.approx(
        rolls + 0.5 * 0.3 * 9.81 * 1.5 * 0.7 / 0.4 * rolls**2 + speed / 0.7 * (5 - rolls), rel=1e-7
    )
    assert friction == pytest.approx(0.0, abs=1e-9)
    assert found.rows[0][4] == pytest.approx(-0.3 * 1.5 * 9.81)


def test_friction_is_what_it_takes_to_roll() -> None:
    """Pulled by F it rolls from the start: x'' = F/(m + J/r^2), and friction gives the rim what it takes, -J x''/r^2."""
    found = motion(THROWN, "pull")
    speeding = 2 / (1.5 + 0.4 / 0.7**2)
    assert found.notes == ("from t = 0 on dry friction holds `slip` at zero",)
    for t, row in zip(found.times, found.rows, strict=True):
        assert row[:2] == pytest.approx((speeding * t**2 / 2, speeding * t**2 / 1.4), abs=1e-9)
        if t > 0.0:
            assert row[4] == pytest.approx(-0.4 * speeding / 0.7**2, rel=1e-9)


@BOTH
def test_two_blocks_break_loose_one_after_the_other(compiled: bool) -> None:
    """The lower one where a t = c1; the upper one where its share of the force is c2: t = (c1 + c2 (M + m)/m)/a."""
    found = motion(STACK, compiled=compiled)
    assert [note.split("`")[1::2] for note in found.notes] == [["X'", "u'"], ["X'"], ["u'"]]
    assert found.job.formulation.name == "lagrange"  # the spec's own, and not what is held at the start
    assert [float(note.split()[3]) for note in found.notes] == pytest.approx([0.0, 2.0, 3.6], abs=1e-7)
    for t, row in zip(found.times, found.rows, strict=True):
        if t < 2.0:
            expected = (0.0, 0.0, 0.0, 0.0, -1.5 * t, 0.0)
        elif t < 3.6:
            speed = 0.25 * (t - 2) ** 2
            expected = ((t - 2) ** 3 / 12, (t - 2) ** 3 / 12, speed, speed, -3.0, -0.5 * (t - 2))
        else:
            s, begin, speed = t - 3.6, 1.6**3 / 12, 0.25 * 1.6**2
            lower = speed + 0.8 * s + 0.375 * s**2  # M X'' = a t - c1 - c2
            upper = speed + 0.8 * s
            expected = (
                begin + speed * s + 0.4 * s**2 + 0.125 * s**3,
                begin + speed * s + 0.4 * s**2,
                lower,
                upper,
                -3,
                -0.8,
            )
        assert row == pytest.approx(expected, abs=2e-7)


@BOTH
def test_a_block_on_a_belt_sticks_and_slips(compiled: bool) -> None:
    """Beside friction without a jump, which is stiff and creeps by as little as its slope is steep."""
    found = motion(BELT.replace("FRICTION", "c*sign(V - x')"), compiled=compiled)
    beside = motion(BELT.replace("FRICTION", "c*tanh((V - x')/1e-7)"), compiled=True, method="radau5")
    assert found.ended == beside.ended == "done"
    assert (
        sum("holds" in note for note in found.notes) >= 1 and sum("breaks loose" in note for note in found.notes) >= 1
    )
    for row, other in zip(found.rows, beside.rows, strict=True):
        assert row == pytest.approx(other, abs=2e-6)


def test_a_skate_that_brakes_stops_in_every_formulation() -> None:
    """m v' = -c + m a th'^2 and (J + m a^2) th'' = -d - m a v th' until th' is held, then v."""
    whole = [motion(SKATE, formulation=name) for name in ("chaplygin", "voronec", "multipliers", "euler-lagrange")]
    for found in whole:
        assert found.ended == "done" and len(found.notes) == 2
        assert "`th'`" in found.notes[0] and "`v`" in found.notes[1]
        assert found.rows[-1] == pytest.approx(whole[0].rows[-1], rel=1e-8)
    stops = float(whole[0].notes[1].split()[3])
    held = float(whole[0].notes[0].split()[3])
    y, h = [2.0, 1.5], 1e-4  # by classical steps up to just before th' is held, then along a line
    steps = int(held / h)

    def slopes(v: float, w: float) -> tuple[float, float]:
        return (0.1 * w**2 - 0.2, -(0.2 + 0.2 * v * w) / (0.3 + 0.02))

    for _ in range(steps):
        k1 = slopes(*y)
        k2 = slopes(y[0] + h / 2 * k1[0], y[1] + h / 2 * k1[1])
        k3 = slopes(y[0] + h / 2 * k2[0], y[1] + h / 2 * k2[1])
        k4 = slopes(y[0] + h * k3[0], y[1] + h * k3[1])
        y = [y[i] + h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]) for i in (0, 1)]
    left = held - steps * h
    v, w = (y[i] + left * slopes(*y)[i] for i in (0, 1))
    assert w == pytest.approx(0.0, abs=1e-6)
    assert stops == pytest.approx(held + v / 0.2, abs=1e-6)


def test_reactions_and_checks_are_those_of_the_spec() -> None:
    """Not of what friction holds: columns are the same from the start to the end; a cart's rail holds it up."""
    text = SKATE.replace("need: [x, y, th]", "need: [reactions, energy, v]").replace(
        "constraints:", "outputs: {v: v}\nconstraints:"
    )
    text = text.replace("outputs: {v: v}", "outputs: {speed: v}").replace("energy, v]", "energy, speed]")
    job = open_scene(Source("sticking.yaml", text), checks=True)
    found = run(job, Settings(points=41, compiled=False))
    assert found.ended == "done" and len(found.notes) == 2
    assert found.headings == ("lambda_c1", "energy", "speed")
    assert {len(row) for row in found.rows} == {3} and {len(row) for row in found.checks} == {3}
    assert found.rows[-1][1:] == pytest.approx((0.0, 0.0), abs=1e-9)
    assert max(abs(row[2]) for row in found.checks) < 1e-9


def test_a_user_ends_a_run_while_something_is_held() -> None:
    found = motion(STACK, until="x - 0.01")
    assert found.ended == "event" and found.rows[-1][1] == pytest.approx(0.01, abs=1e-9)
    assert found.outcome.t == pytest.approx(2 + 0.12 ** (1 / 3), abs=1e-7)
    assert motion(STACK, until="X' - x' - 0.1").outcome.t > 3.6


@pytest.mark.parametrize(
    ("force", "why"),
    [
        ("{x: -0.3*sign(x' + y')}", "a force on x alone does not act along x' + y'"),
        ("{x: -0.3*sign(x'*(2 + y'^2) - x), y: 0.1}", "what is held is not linear in the velocities"),
    ],
)
def test_what_is_no_friction_along_what_it_holds_ends_a_run(force: str, why: str) -> None:
    text = (
        f"nhc: 1\nsystem: other\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\nforces: {force}\n"
        "scenes: {a: {initial: {x': 1, y': -0.5}, time: [0, 9]}}\n"
    )
    found = motion(text)
    assert found.ended == "failed" and "the motion is held where" in found.reason, why


@BOTH
def test_friction_by_the_normal_force_holds_by_what_that_is(compiled: bool) -> None:
    """A bead on a hoop in a shaken plane: N = m (g cos(th) + R th'^2), and the plane breaks it loose again and again."""
    text = (
        "nhc: 1\nsystem: hoop\ncoordinates: [th]\nparameters: {m: 1, R: 0.5, g: 9.81, mu: 0.5, A: 6, w: 3}\n"
        "T: m*R^2*th'^2/2\nV: -m*g*R*cos(th)\nforces: {th: A*R*m*sin(w*t) - mu*R*m*(g*cos(th) + R*th'^2)*FRICTION}\n"
        "scenes: {a: {initial: {th: 0.4}, time: [0, 6], need: [th, th']}}\n"
    )
    found = motion(text.replace("FRICTION", "sign(th')"), compiled=compiled)
    beside = motion(text.replace("FRICTION", "tanh(th'/1e-7)"), compiled=True, method="radau5")
    assert found.ended == beside.ended == "done"
    assert len(found.notes) >= 7 and "more times" in found.notes[-1]
    for row, other in zip(found.rows, beside.rows, strict=True):
        assert row == pytest.approx(other, abs=5e-6)


def test_angular_and_quasi_velocities_are_held() -> None:
    """wz of a top by friction in its pivot: with wz = 0 the others stay; quasi-velocities, of which none is left."""
    top = """nhc: 1
system: top
rotation: {B: {frame: body, velocities: [wx, wy, wz]}}
parameters: {A: 0.2, D: 0.3, C: 0.4, c: 0.1}
T: (A*wx^2 + D*wy^2 + C*wz^2)/2
forces: {wz: -c*sign(wz)}
scenes: {a: {initial: {wx: 0.1, wy: 0.05, wz: 0.5}, time: [0, 8], need: [wx, wy, wz]}}
"""
    found = motion(top)
    beside = motion(top.replace("sign(wz)", "tanh(wz/1e-7)"), compiled=True, method="radau5")
    (note,) = found.notes
    assert note.endswith("dry friction holds `wz` at zero") and found.rows[-1][2] == pytest.approx(0.0, abs=1e-12)
    for row, other in zip(found.rows, beside.rows, strict=True):
        assert row == pytest.approx(other, abs=1e-6)
    quasi = SKATE.replace("define: {v:", "quasi_velocities: {w: th', v:").replace("th: -d*sign(th')", "w: -d*sign(w)")
    held, other = motion(quasi), motion(SKATE)
    assert [note.split("`")[1] for note in held.notes] == ["w", "v"]
    assert held.rows[-1] == pytest.approx(other.rows[-1], rel=1e-8)


def test_frictions_along_one_velocity_add_up() -> None:
    """1 - 0.7 + 0.5 hold until t = 0.8; where a constraint ties x' to 2 y', 1 + 0.7/2 do."""
    text = (
        "nhc: 1\nsystem: several\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\nTIED"
        "forces: FORCES\nscenes: {a: {time: [0, 3], need: [x, x']}}\n"
    )
    found = motion(text.replace("TIED", "").replace("FORCES", "{x: t - sign(x') - 0.7*sign(-2*x') - 0.5*sign(3*x')}"))
    assert found.ended == "done" and "at t = 0.8 " in found.notes[1]
    assert found.rows[-1][1] == pytest.approx(2.2**2 / 2, rel=1e-7)
    tied = text.replace("TIED", "constraints: [x' = 2*y']\n").replace("FORCES", "{x: t - sign(x'), y: -0.7*sign(y')}")
    found = motion(tied)
    assert found.ended == "done" and "at t = 1.35 `x'` and `y'` break loose" in found.notes[1]
    assert found.rows[-1][1] == pytest.approx(1.65**2 / 2 / 1.25, rel=1e-7)


def find_limit(loads: numpy.ndarray, sizes: list[float], rows: numpy.ndarray) -> tuple[float, numpy.ndarray]:
    """The largest k for which k ``loads`` is a sum of s_f c_f times each friction's row with |s_f| <= 1, and these s."""
    count = len(sizes)
    equal = numpy.column_stack([(numpy.array(sizes)[:, None] * rows).T, -loads])
    solved = linprog(
        [0.0] * count + [-1.0], A_eq=equal, b_eq=[0.0] * len(loads), bounds=[(-1, 1)] * count + [(0, None)]
    )
    assert solved.success
    return float(solved.x[-1]), solved.x[:-1]


@pytest.mark.parametrize("seed", range(8))
def test_frictions_that_follow_from_each_other_share_a_load(seed: int) -> None:
    """Blocks on the ground and against each other rest until a linear program finds no shares that carry the load any more."""
    rng = random.Random(seed)
    count = 2 + seed % 2
    names = ["x", "y", "z"][:count]
    pairs = [pair for pair in combinations(range(count), 2) if rng.random() < 0.8]
    rows = numpy.array([*numpy.eye(count), *(numpy.eye(count)[i] - numpy.eye(count)[j] for i, j in pairs)])
    slips = {
        **{name: name for name in names},
        **{f"d{k}": f"{names[i]} - {names[j]}" for k, (i, j) in enumerate(pairs)},
    }
    sizes = [round(rng.uniform(0.3, 2.0), 2) for _ in rows]
    loads = numpy.array([round(rng.uniform(-1.0, 1.0), 2) for _ in names])
    limit, shares = find_limit(loads, sizes, rows)
    frictions = {what: f"{size}*sign({what}')" for what, size in zip(slips, sizes, strict=True)}
    pulls = {**dict.fromkeys(slips, "0"), **{name: f"{load}*t" for name, load in zip(names, loads, strict=True)}}
    scene = {"time": [0, limit + 0.5], "need": [*names, *(f"f_{what}" for what in slips)]}
    spec = {
        "nhc": 1,
        "system": "shared",
        "coordinates": names,
        "T": " + ".join(f"{name}'^2/2" for name in names),
        "define": {what: slips[what] for what in slips if what not in names},
        "forces": {what: f"{pulls[what]} - {frictions[what]}" for what in slips},
        "outputs": {f"f_{what}": friction for what, friction in frictions.items()},
        "scenes": {"a": scene},
    }
    text = json.dumps({key: value for key, value in spec.items() if value})
    found = motion(text)
    assert found.ended == "done"
    assert float(found.notes[1].split()[3]) == pytest.approx(limit, rel=1e-6) and "loose" in found.notes[1]
    for t, row in zip(found.times, found.rows, strict=True):
        if t < limit:
            assert row[:count] == pytest.approx([0.0] * count, abs=1e-9)
            assert numpy.array(row[count:]) @ rows == pytest.approx(
                loads * t, abs=1e-9
            )  # whatever the shares, they carry it
    # what slips is what every solution of the linear program has at its bound
    loose = set(found.notes[1].split("`")[1::2])
    for share, what in zip(shares, slips, strict=True):
        assert f"{what}'" not in loose or abs(share) == pytest.approx(1.0)


LEGS = """nhc: 1
system: legs
coordinates: [a, b]
parameters: {f1: 1, f2: 2, p: 3}
T: (a'^2 + b'^2)/2
constraints: [gear: a' = p*b']
forces: {a: "t - f1*sign(a')", b: "-f2*(1 + 0.5*sin(3*t))*sign(b')"}
outputs: {sa: sign(a'), sb: sign(b')}
scenes: {go: {time: [0, 3], need: [a, sa, sb, lambda_gear]}}
"""


def test_reactions_are_those_beside_the_shares_that_are_shown() -> None:
    """What a friction that follows from others cannot give along them, the constraint takes: t - f1 sa + lambda = a''."""
    found = motion(LEGS)
    loose = next(t for t in (float(note.split()[3]) for note in found.notes if "loose" in note))
    for t, (_, sa, sb, reaction) in zip(found.times, found.rows, strict=True):
        if t < loose:
            second = 2 * (1 + 0.5 * math.sin(3 * t))
            assert t - sa + reaction == pytest.approx(0.0, abs=1e-9)
            assert -second * sb - 3 * reaction == pytest.approx(0.0, abs=1e-9)
            assert sa == pytest.approx(sb) and 0 <= sa <= 1
    assert loose == pytest.approx(1 + 2 * (1 + 0.5 * math.sin(3 * loose)) / 3, abs=1e-7)


PLANE = """nhc: 1
system: plane
coordinates: [x, y]
parameters: {c: 1}
define: {s: sqrt(x'^2 + y'^2)}
T: (x'^2 + y'^2)/2
forces: {x: -c*x'/s + 0.5*t, y: -c*y'/s + 0.2}
outputs: {fx: -c*x'/s}
scenes: {go: {time: [0, 3], need: [x, y, fx]}}
"""


MOVING = """nhc: 1
system: moving
coordinates: [x, y]
parameters: {c: 2.9}
define: {vx: SLIP, s: sqrt(vx^2 + y'^2)}
T: (x'^2 + y'^2)/2
forces: {vx: -c*vx/s, y: -c*y'/s + 0.4*t, x: "1.5*sin(0.5*t) - SHAKE"}
scenes: {go: {time: [0, 5], need: [y, y']}}
"""


def test_friction_on_a_ground_that_moves_is_that_on_one_at_rest() -> None:
    """A slip that is what is left of two velocities begins with their rounding; seen from the ground it has none."""
    found = motion(MOVING.replace("SLIP", "x' - 0.6*sin(2*t)").replace("SHAKE", "0"), compiled=True)
    beside = motion(MOVING.replace("SLIP", "x'").replace("SHAKE", "1.2*cos(2*t)"), compiled=True)
    assert found.ended == beside.ended == "done" and found.rows[-1][0] > 1e-3
    for row, other in zip(found.rows, beside.rows, strict=True):
        assert row == pytest.approx(other, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize(("text", "until", "when"), [(LEGS, "sa - 0.6", None), (PLANE, "fx + 0.4", 0.8)])
def test_a_run_ends_by_the_part_of_a_friction_that_holds(text: str, until: str, when: float | None) -> None:
    scene = open_scene(Source("<string>", text), until=until)
    found = run(scene, Settings(points=3))
    value = found.rows[-1][1] if when is None else -found.rows[-1][2]
    assert found.ended == "event" and value == pytest.approx(0.6 if when is None else 0.4, abs=1e-9)
    assert when is None or found.times[-1] == pytest.approx(when, abs=1e-9)


BELTS = """nhc: 1
system: belts
coordinates: [x]
parameters: {c: 2, d: 0.5, V: 0.6, W: -0.4, k: 3}
define: {p: x - V*t, q: x - W*sin(t)}
T: x'^2/2
V: k*x^2/2
forces: {p: -c*S(p'), q: -d*S(q')}
scenes: {s: {initial: {x': -1}, time: [0, 12], need: [x, x']}}
"""


@pytest.mark.parametrize("low", [-0.4, 0.9])
def test_slips_on_belts_do_not_follow_from_each_other(low: float) -> None:
    """One velocity, two slips: while one is held the other is what the belts differ by, which vanishes at times where W is 0.9."""
    text = BELTS.replace("W: -0.4", f"W: {low}")
    found = motion(text.replace("S(", "sign("))
    smooth = text.replace("S(p')", "tanh(p'/1e-7)").replace("S(q')", "tanh(q'/1e-7)")
    beside = motion(smooth, compiled=True, method="radau5")
    assert found.ended == beside.ended == "done" and len(found.notes) > 2
    for row, other in zip(found.rows, beside.rows, strict=True):
        assert row == pytest.approx(other, abs=5e-6)


def test_a_slip_that_constraints_hold_somewhere_by_themselves_leads_no_others() -> None:
    """Of x' and u = cos(a) x' + sin(a) y' under sin(a) x' = cos(a) y', u is held: x' is zero by itself where a = pi/2."""
    text = (
        "nhc: 1\nsystem: turned\ncoordinates: [x, y, a]\ndefine: {u: cos(a)*x' + sin(a)*y'}\nT: (x'^2 + y'^2 + a'^2)/2\n"
        "constraints: [sin(a)*x' = cos(a)*y']\nforces: {x: 0.3*sin(t) - sign(x'), u: -sign(u), y: 0.1*t}\n"
        "scenes: {go: {initial: {a: 0.5, a': 1}, time: [0, 4], need: [x, y, a]}}\n"
    )
    found = motion(text)
    assert found.ended == "done" and found.rows[-1] == pytest.approx((0.0, 0.0, 4.5), abs=1e-9)


def shake(seed: int, friction: str) -> str:
    """A spec of two or three blocks on springs, with a ``friction`` of V on the ground and between any two, which are shaken."""
    rng = random.Random(seed)

    def draw(low: float, high: float) -> float:
        return round(rng.uniform(low, high), 2)

    names = ["x", "y", "z"][: 2 + seed % 2]
    pairs = list(combinations(names, 2))
    slips = {**{name: name for name in names}, **{f"d{k}": f"{a}-{b}" for k, (a, b) in enumerate(pairs)}}
    sizes = {what: draw(0.1, 1.0) for what in slips if rng.random() < 0.85}
    inertia = [f"{draw(0.5, 2)}*{name}'^2/2" for name in names]
    springs = [f"{draw(0.5, 6)}*{name}^2/2" for name in names]
    springs += [f"{draw(0.5, 5)}*({a}-{b})^2/2" for a, b in pairs]
    forces = {name: f"{draw(-2, 2)}*sin({draw(0.5, 2)}*t)" for name in names}
    start = {**{name: draw(-1, 1) for name in names}, **{f"{name}'": draw(-1, 1) for name in names}}
    for what, size in sizes.items():
        forces[what] = f"{forces.get(what, 0)} - {size}*{friction.replace('V', f'{what}{chr(39)}')}"
    return json.dumps(
        {
            "nhc": 1,
            "system": "shaken",
            "coordinates": names,
            "T": " + ".join(inertia),
            "V": " + ".join(springs),
            "define": {f"d{k}": f"{a}-{b}" for k, (a, b) in enumerate(pairs)},
            "forces": forces,
            "scenes": {"a": {"initial": start, "time": [0, 8], "need": [*names, *(f"{name}'" for name in names)]}},
        }
    )


@pytest.mark.parametrize("seed", [13, 75, 91])
def test_many_frictions_at_a_time(seed: int) -> None:
    """Beside friction that has no jump and creeps.  In 75 all start to slip at once, each faster than the next; 91
    becomes stiff while something is held.
    """
    found = motion(shake(seed, "sign(V)"))
    beside = motion(shake(seed, "tanh(V/1e-6)"), compiled=True, method="radau5")
    assert found.ended == beside.ended == "done" and len(found.notes) > 3
    for row, other in zip(found.rows, beside.rows, strict=True):
        assert row == pytest.approx(other, abs=2e-5)


def test_the_joints_of_a_linkage_hold_together() -> None:
    """A four-bar whose three joints have friction, under a torque that grows: by virtual work, at k1 + k2 |b'/a'| + k3 |c'/a'|."""
    text = (
        "nhc: 1\nsystem: fourbar\ncoordinates: [a, b, c]\nparameters: {k1: 0.5, k2: 0.7, k3: 0.4}\n"
        "T: a'^2/6 + b'^2/2 + c'^2/3\nholonomic: [cos(a) + 2.5*cos(b) = 3 + 2*cos(c), sin(a) + 2.5*sin(b) = 2*sin(c)]\n"
        "forces: {a: t - k1*sign(a'), b: -k2*sign(b'), c: -k3*sign(c')}\n"
        "scenes: {s: {initial: {a: 1.2, b: {near: 0.4}, c: {near: 1.7}}, time: [0, 3], need: [a, b, c]}}\n"
    )
    found = motion(text)
    a, b, c = found.rows[0]
    # cos(a) + 2.5 cos(b) - 2 cos(c) and the sines: -sin(a) a' - 2.5 sin(b) b' + 2 sin(c) c' = 0 and so on
    by, cy = numpy.linalg.solve(
        [[-2.5 * math.sin(b), 2 * math.sin(c)], [2.5 * math.cos(b), -2 * math.cos(c)]], [math.sin(a), -math.cos(a)]
    )
    limit = 0.5 + 0.7 * abs(by) + 0.4 * abs(cy)
    assert found.ended == "done" and [len(note.split("`")) // 2 for note in found.notes[:2]] == [3, 3]
    assert float(found.notes[1].split()[3]) == pytest.approx(limit, rel=1e-6)
    assert found.rows[-1][0] > a + 0.01


def test_two_frictions_that_change_at_one_time() -> None:
    """The upper block comes to rest on the lower one, which rests: friction between them turns, and the lower one breaks loose."""
    text = (
        "nhc: 1\nsystem: pair\ncoordinates: [x, y]\nT: 0.96*x'^2/2 + 0.87*y'^2/2 + 0.3*x'*y'*cos(x - y)\n"
        "V: 2.97*x^2/2 + 7.88*y^2/2 + 4.14*(x - y)^2/2\ndefine: {u: x - y}\n"
        "forces: {x: -0.81*S(x') + 1.87*sin(1.57*t), u: -0.32*S(u')}\n"
        "scenes: {a: {initial: {x: 0.69, x': 0.79, y: -0.39, y': -0.33}, time: [0, 6], need: [x, y, x', y']}}\n"
    )
    found = motion(text.replace("S(", "sign("))
    beside = motion(
        text.replace("S(x')", "tanh(x'/1e-7)").replace("S(u')", "tanh(u'/1e-7)"), compiled=True, method="radau5"
    )
    assert found.ended == beside.ended == "done"
    assert [note.split("`")[1] for note in found.notes] == ["x'", "x'", "u'", "u'"]
    for row, other in zip(found.rows, beside.rows, strict=True):
        assert row == pytest.approx(other, abs=5e-6)


BILLIARD = """nhc: 1
system: billiard
coordinates: [x, y]
rotation: {B: {frame: space, velocities: [wx, wy, wz]}}
parameters: {m: 0.17, a: 0.028, mu: 0.2, g: 9.81}
define: {sx: x' - a*wy, sy: y' + a*wx, s: sqrt(sx^2 + sy^2)}
T: m*(x'^2 + y'^2)/2 + m*a^2/5*(wx^2 + wy^2 + wz^2)
forces: {x: -mu*m*g*sx/s, y: -mu*m*g*sy/s, wx: -mu*m*g*a*sy/s, wy: mu*m*g*a*sx/s}
scenes: {a: {initial: {x': 2, wx: 30, wy: -20, wz: 5}, time: [0, 2], need: [x, y, x', y', wx, wy, wz]}}
"""


@BOTH
def test_a_billiard_ball_slides_along_a_parabola_and_rolls_along_a_line(compiled: bool) -> None:
    """Its slip keeps its direction and falls by 7/2 mu g each second; 5/7 of its speed and 2/7 of its rim's are left."""
    found = motion(BILLIARD, compiled=compiled)
    assert found.ended == "done" and len(found.notes) == 1 and found.notes[0].endswith("holds `s` at zero")
    slip = (2 + 0.56, 0.84)
    rolls = math.hypot(*slip) / (3.5 * 0.2 * 9.81)
    assert float(found.notes[0].split()[3]) == pytest.approx(rolls, rel=1e-5)
    speed = (5 / 7 * 2 - 2 / 7 * 0.028 * 20, -2 / 7 * 0.028 * 30)
    last = found.rows[-1]
    assert last[2:4] == pytest.approx(speed, abs=1e-10)
    assert last[4:] == pytest.approx((-speed[1] / 0.028, speed[0] / 0.028, 5.0), abs=1e-8)
    pull = [-0.2 * 9.81 * part / math.hypot(*slip) for part in slip]
    x = 2 * rolls + pull[0] * rolls**2 / 2 + speed[0] * (2 - rolls)
    y = pull[1] * rolls**2 / 2 + speed[1] * (2 - rolls)
    assert last[:2] == pytest.approx((x, y), abs=1e-8)


def test_friction_in_a_plane_holds_and_lets_go() -> None:
    """Beside sqrt(v^2 + w^2 + 1e-18), with which the mass creeps by some 1e-9 each second."""
    text = """nhc: 1
system: plane
coordinates: [x, y]
parameters: {m: 1.2, c: 1.7, k: 6, A: 0.3, B: 0.2}
define: {s: sqrt(x'^2 + y'^2 + EPS)}
T: m*(x'^2 + y'^2)/2
V: k/2*((x - A*sin(0.7*t))^2 + (y - B*cos(1.1*t))^2)
forces: {x: -c*x'/s, y: -c*y'/s}
outputs: {fx: -c*x'/s, fy: -c*y'/s, slip: s}
scenes: {a: {initial: {x': 0.3, y': 0.4}, time: [0, 14], need: [x, y, fx, fy, slip]}}
"""
    found = motion(text.replace(" + EPS", ""), compiled=True)
    beside = motion(text.replace("EPS", "1e-18"), compiled=True, method="radau5", tolerance=1e-10)
    assert found.ended == beside.ended == "done"
    told = [note for note in found.notes if "`s`" in note]
    assert [("holds" in note, "loose" in note) for note in told] == [(True, False), (False, True)] * 3
    for t, row, other in zip(found.times, found.rows, beside.rows, strict=True):
        assert row[:2] == pytest.approx(other[:2], abs=1e-7)
        assert math.hypot(*row[2:4]) <= 1.7 * (1 + 1e-9)
        if row[4] == 0.0:  # the springs' forces, which it holds
            springs = (6 * (row[0] - 0.3 * math.sin(0.7 * t)), 6 * (row[1] - 0.2 * math.cos(1.1 * t)))
            assert row[2:4] == pytest.approx(springs, abs=1e-12)
        else:
            assert row[2:] == pytest.approx(other[2:], abs=1e-6)
    assert sum(row[4] == 0.0 for row in found.rows) > 5


def test_a_motion_starts_at_rest_in_a_plane() -> None:
    """x pulls by a t from the start, and c/a is when it breaks loose; what functions refuse is said with what runs."""
    text = (
        "nhc: 1\nsystem: puck\ncoordinates: [x, y]\nparameters: {m: 2, c: 1.5, a: 0.5}\ndefine: {s: sqrt(x'^2 + y'^2)}\n"
        "T: m*(x'^2 + y'^2)/2\nforces: {x: -c*x'/s + 0.6*a*t, y: -c*y'/s + 0.8*a*t}\noutputs: {fx: -c*x'/s}\n"
        "scenes: {a: {time: [0, 5], need: [x, y, fx]}}\n"
    )
    found = motion(text)
    assert found.ended == "done" and float(found.notes[1].split()[3]) == pytest.approx(3.0, abs=1e-7)
    assert found.rows[8] == pytest.approx((0.0, 0.0, -0.6), abs=1e-12)
    far = 0.5 / 2 * 2**3 / 6
    assert found.rows[-1] == pytest.approx((0.6 * far, 0.8 * far, -0.9), abs=1e-7)
    pulled = text.replace("0.6*a*t", "1.8").replace("0.8*a*t", "2.4")  # more than friction from the start
    found = motion(pulled)
    assert found.ended == "done" and not found.notes
    assert found.rows[-1] == pytest.approx((0.6 * 9.375, 0.8 * 9.375, -0.9), rel=1e-7)
    (told,) = check(Source("puck.yaml", text)).diagnostics
    assert told.code == "W0421" and "emitted functions refuse" in told.message and "friction holds it" in told.help[0]


def test_a_run_that_is_to_stay_in_its_formulation_ends_where_friction_sticks() -> None:
    found = motion(THROWN, "throw", stay=True)
    assert found.ended == "failed" and "the motion is held where `slip` is zero" in found.reason


def test_a_pendulum_with_dry_friction_comes_to_rest_beside_its_lowest_place() -> None:
    """Each half swing loses 2 c/(m g l) of the amplitude where it is small; it rests where m g l sin(th) <= c."""
    text = (
        "nhc: 1\nsystem: rusty\ncoordinates: [th]\nparameters: {m: 1, l: 0.5, g: 9.81, c: 0.1}\nT: m*l^2*th'^2/2\n"
        "V: -m*g*l*cos(th)\nforces: {th: -c*sign(th')}\nscenes: {a: {initial: {th: 0.5}, time: [0, 30], need: [th, th']}}\n"
    )
    found = motion(text)
    assert found.ended == "done" and found.notes[-1].endswith("holds `th'` at zero")
    th, speed = found.rows[-1]
    assert abs(4.905 * math.sin(th)) <= 0.1 + 1e-9 and speed == 0.0
    fine = motion(text, tolerance=1e-11)
    assert th == pytest.approx(fine.rows[-1][0], abs=1e-7)
    angle = 0.5  # turning points by energy: m g l (cos b - cos a) = c (a + b)
    for _ in range(100):
        if 4.905 * math.sin(angle) <= 0.1:
            break
        low, high = -angle, angle
        for _ in range(200):
            middle = 0.5 * (low + high)
            loses = 4.905 * (math.cos(middle) - math.cos(angle)) > 0.1 * (angle + middle)
            low, high = (middle, high) if loses else (low, middle)
        angle = 0.5 * (low + high)
    assert abs(th) == pytest.approx(abs(angle), abs=1e-6)


def test_starts_of_an_ensemble_stick(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Each with its own friction and start, as single runs do; a start that never sticks is left as it is."""
    spec, table = tmp_path / "thrown.yaml", tmp_path / "starts.csv"
    spec.write_text(THROWN)
    table.write_text("x',th',mu\n4,1,0.3\n3,1,0.2\n1,-10,0.1\n4,1,0.01\n")
    assert main(["run", str(spec), "--scene", "throw", "--ensemble", str(table)]) == 0
    found, said = capsys.readouterr()
    assert "note: 3 starts, 1 the first, have runs of their own: " in said
    ends = [[*map(float, line.split(",")[2:])] for line in found.split()[2::2]]
    plane = tmp_path / "plane.yaml"
    plane.write_text(PLANE)
    (tmp_path / "rest.csv").write_text("y',c\n0,1\n0.5,0.3\n")
    assert main(["run", str(plane), "--ensemble", str(tmp_path / "rest.csv"), "--need", "x,y"]) == 0
    assert "note: start 1 has a run of its own: " in capsys.readouterr().err
    for line, row in zip(table.read_text().split()[1:], ends, strict=True):
        values = (f"{name}={value}" for name, value in zip(("x'", "th'", "mu"), line.split(","), strict=True))
        single = open_scene(Source("<string>", THROWN), "throw", changes=Changes(tuple(values), ""))
        assert row == pytest.approx(run(single, Settings(points=2)).rows[-1], rel=1e-6, abs=1e-9)
