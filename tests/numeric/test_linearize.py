"""Linearisation about steady motions: published numbers, closed forms, and what is refused.

Meijaard, Papadopoulos, Ruina and Schwab 2007 (bicycle); O'Reilly 1996 and the catalogue's formulas (disk); Kane and Levinson 1982
(rattleback); Neimark and Fufaev 1972 (ball on a turntable, sleigh).
"""

from __future__ import annotations

import cmath
import json
import math
import re
import warnings
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph
from nhc.cli import main
from nhc.diagnostics import Source, SpecError
from nhc.language import decode, read
from nhc.mechanics.about import scene_about
from nhc.mechanics.values import constant_value
from nhc.pipeline import Options, linearize, model
from nhc.study.linearization import absent as absent_module
from nhc.study.linearization import linearize as linearize_module
from nhc.study.linearization.branch import Branch
from nhc.study.linearization.field import Hold, SteadyModel
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import eigenvalues, verdict
from nhc.study.linearization.motion import Findings, Request, named_quantity, steady_model
from nhc.study.linearization.steady import find_steady
from nhc.study.linearization.tape import Tape
from nhc.study.stability.motions import Search, steady_motion
from tests.support import hide_numpy, seldom, spec_path


@cache
def find(
    name: str,
    about: str,
    formulation: str = "",
    settings: tuple[str, ...] = (),
    holds: tuple[str, ...] = (),
    sweep: tuple[str, float, float, int] | None = None,
) -> Findings:
    request = Request(about, settings, holds, sweep)
    return linearize(read(str(spec_path(name))), request, Options(formulation=formulation))


def cyclic(found: Findings) -> list[str]:
    return [found.flow.names[i] for i in found.model.cyclic]


def matches(found: list[complex], expected: list[complex], tolerance: float) -> bool:
    """The same numbers, in any order, relative to the larger of 1 and each of them."""
    left = list(found)
    for x in expected:
        near = min(left, key=lambda y: abs(y - x), default=math.inf)
        if abs(near - x) > tolerance * max(1.0, abs(x)):
            return False
        left.remove(near)
    return not left


# --- the bicycle: M, C1, K0, K2, eigenvalues and speeds of the benchmark ----------------------------------------

M = np.array([[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]])
C1 = np.array([[0.0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]])
K0 = np.array([[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]])
K2 = np.array([[0.0, 76.59734589573222], [0.0, 2.65431523794604]])
AT_5 = [
    -14.0783896927982473,
    complex(-0.775341882195841832, 4.46486771378822507),
    complex(-0.775341882195841832, -4.46486771378822507),
    -0.322866429004087157,
]
STRAIGHT = "z=-0.3, thR'=-5/r_R"


@pytest.mark.parametrize("formulation", [seldom("voronec"), "euler-lagrange", "multipliers"])
def test_the_bicycle_has_the_published_eigenvalues(formulation: str) -> None:
    found = find("bicycle", STRAIGHT, formulation)
    assert found.linearisation.steady.residual < 1e-12
    assert matches(eigenvalues(found.linearisation), AT_5, 1e-11)
    assert verdict(found.linearisation) == "stable"


def test_the_bicycle_leaves_out_what_its_hidden_constraints_forbid() -> None:
    found = find("bicycle", STRAIGHT, "voronec")
    assert cyclic(found) == ["x", "y", "z", "yaw", "thR", "thF"]
    made = found.linearisation
    assert len(made.rest) == 6 and len(made.basis) == 5  # the pitch hangs on roll and steer
    assert made.family == 1  # any speed
    assert abs(abs(made.null[0][list(made.rest).index(11)]) - 1.0) < 1e-12  # along thR'


@pytest.mark.parametrize("speed", [0.0, seldom(4.0), 5.0, seldom(8.0)])
def test_the_bicycle_has_the_published_matrices(speed: float) -> None:
    """M q'' + v C1 q' + (g K0 + v^2 K2) q = 0 over q = (lean, steer)."""
    found = find("bicycle", f"z=-0.3, thR'=-{speed}/r_R", "voronec")
    y = found.linearisation.steady.y
    mass = found.model.mass(y)[:2, :2]
    assert np.abs(mass - M).max() < 1e-10
    names = [found.flow.names[i] for i in found.linearisation.rest]
    lean_steer, rates = ([names.index(x) for x in pair] for pair in (["roll", "steer"], ["roll'", "steer'"]))
    full = found.linearisation.full
    stiffness, damping = -mass @ full[np.ix_(rates, lean_steer)], -mass @ full[np.ix_(rates, rates)]
    assert np.abs(stiffness - (9.81 * K0 + speed**2 * K2)).max() < 1e-9
    assert np.abs(damping - speed * C1).max() < 1e-10


def test_the_bicycle_has_the_published_speeds_of_weave_and_capsize() -> None:
    found = find("bicycle", STRAIGHT, "voronec", sweep=("speed", 1.0, 8.0, 8))
    assert found.swept is not None
    weave, capsize = found.swept.crossings
    assert weave.value == pytest.approx(4.2923825363411040675, abs=1e-10)
    assert weave.frequency > 3 and not weave.unstable_above
    assert capsize.value == pytest.approx(6.0242620153883590426, abs=1e-10)
    assert capsize.frequency == 0 and capsize.unstable_above


@pytest.mark.slow
def test_two_real_eigenvalues_that_meet_are_no_crossing() -> None:
    """At 0.684 m/s two growing real eigenvalues of the bicycle become the weave pair; nothing crosses the axis."""
    found = find("bicycle", STRAIGHT, "voronec", sweep=("speed", 0.4, 1.2, 5))
    assert found.swept is not None and found.swept.crossings == ()


@pytest.mark.slow
def test_a_bicycle_turns_steadily_without_hands() -> None:
    found = find(
        "bicycle", "z=-0.3, roll=0.1, thR'=-7/r_R", "voronec", holds=("roll=0.1, front_height=0, rear_height=0",)
    )
    made = found.linearisation
    y = dict(zip(found.flow.names, made.steady.y, strict=True))
    assert made.steady.residual < 1e-9 and abs(y["roll"] - 0.1) < 1e-12
    assert abs(y["steer"]) > 1e-3 and 3 < -0.3 * y["thR'"] < 10
    assert abs(found.model.value(made.steady.y, named_quantity(found.flow, "front_height", "--hold"))) < 1e-12
    assert abs(found.model.field(made.steady.y)[0][3]) > 0.01  # the heading turns


# --- the rolling disk: critical speeds in closed form --------------------------------------------------------

DISK = {"m": 1.0, "R": 0.5, "A": 0.0625, "C": 0.125, "g": 9.81}


@pytest.mark.parametrize(("A", "C"), [(0.0625, 0.125), (0.125, 0.25), (0.07, 0.11)])
def test_the_disk_needs_its_speed_to_roll_upright(A: float, C: float) -> None:
    found = find("rolling_disk", "theta=pi/2", settings=(f"A={A}, C={C}",), sweep=("w_n", 0.5, 8.0, 4))
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    expected = math.sqrt(A * 9.81 * 0.5 / (C * (C + 0.25)))
    assert crossing.value == pytest.approx(expected, abs=1e-9)
    assert not crossing.unstable_above


@pytest.mark.parametrize("holds", [(), ("w_u",)])
@pytest.mark.parametrize("A", [0.0625, 0.125])
def test_the_disk_needs_its_speed_to_spin_upright(A: float, holds: tuple[str, ...]) -> None:
    """What is swept is held at each of its values, whatever it was to be held at."""
    found = find("rolling_disk", "theta=pi/2", settings=(f"A={A}",), holds=holds, sweep=("w_u", 0.5, 8.0, 4))
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    assert crossing.value == pytest.approx(math.sqrt(9.81 * 0.5 / (A + 0.25)), abs=1e-9)


TOP = """\
nhc: 1
system: top_side
coordinates: {phi: {range: [pi/2, 3*pi/2]}}
T: phi'^2/2
U: cos(phi)
"""


@pytest.mark.parametrize("start", ["1.575", "1.6", "2"])
def test_a_search_that_leaves_the_range_of_a_coordinate_begins_again_within_it(start: str) -> None:
    found = linearize(Source("top.yaml", TOP), Request(f"phi={start}"), Options())
    assert found.linearisation.steady.y[0] == pytest.approx(math.pi, abs=1e-12)
    # without the range it ends far away from 1.575, where sin(phi) has nearly no slope
    free = linearize(
        Source("top.yaml", TOP.replace("[pi/2, 3*pi/2]", "[-1000, 1000]")), Request("phi=1.575"), Options()
    )
    assert abs(free.linearisation.steady.y[0] - math.pi) > 1
    made = model(Source("top.yaml", TOP))
    motion = steady_motion(made.equations, made.formulation, Search(f"phi={start}"))  # of `nhc stability`
    assert motion.linearisation.steady.y[0] == pytest.approx(math.pi, abs=1e-12)


FIN = """\
nhc: 1
system: fin
about: a plate in a fluid; its tensor of added masses couples sliding to gliding (Fedorov and Garcia-Naranjo 2010)
coordinates: [x, y, th]
quasi_velocities: {v: cos(th)*x' + sin(th)*y', w: th'}
define: {u: -sin(th)*x' + cos(th)*y'}
T: (3*v^2 - 0.8*v*u + 2.5*u^2 + 0.85*w^2)/2 + w*(0.15*u + 0.2*v)
constraints: [u = 0]
scenes: {go: {initial: {v: 1, w: 0.5}, time: [0, 10]}}
"""


def test_a_field_that_a_parameter_makes_singular_does_not_depend_on_the_time() -> None:
    """w = L th' says nothing of th where L = 0: the motion is found in another coframe."""
    text = FIN.replace("w: th'}", "w: L*th'}\nparameters: {L: 0}").replace("0.85*w^2)/2 + w*", "0.85*th'^2)/2 + th'*")
    found = linearize(Source("fin.yaml", text.replace("w: 0.5", "th': 0.5")), Request("go"), Options())
    assert found.linearisation.steady.residual < 1e-9


def test_both_verbs_find_the_motion_with_the_speed_that_a_scene_starts_with() -> None:
    """p_u w = 0 leaves rest, and turns on which p_u = -0.4 v + 0.15 w vanishes: rest is nearer, but has lost the speed."""
    found = linearize(Source("fin.yaml", FIN), Request("go"), Options())
    made = model(Source("fin.yaml", FIN))
    motion = steady_motion(made.equations, made.formulation, Search("go"))
    for steady in (found.linearisation.steady, motion.linearisation.steady):
        assert steady.y[3:] == pytest.approx((1, 0.4 / 0.15), abs=1e-9)


@pytest.mark.parametrize(
    ("potential", "what"),
    [
        ("log(x)", "`log(x)` has no real, finite value where"),
        ("asin(k)*x", "`asin(k)` has no real, finite value where"),
        ("x^0.5", "`V` has no finite value, or slope, where"),
    ],
)
def test_a_start_without_a_value_is_told_in_the_words_of_the_spec(potential: str, what: str) -> None:
    text = f"nhc: 1\nsystem: s\ncoordinates: [x]\nparameters: {{k: 2}}\nT: x'^2/2\nV: {potential}\n"
    with pytest.raises(NotSteady, match=re.escape(what)):
        linearize(Source("s.yaml", text), Request("x=0"), Options())


def test_a_motion_outside_the_range_of_a_coordinate_is_noted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = tmp_path / "top.yaml"
    spec.write_text(TOP, encoding="utf-8")
    assert main(["linearize", str(spec), "--about", "phi=0.2"]) == 0
    assert "outside its range in the spec: `phi`" in capsys.readouterr().out
    assert main(["linearize", str(spec), "--about", "phi=2"]) == 0
    assert "outside its range" not in capsys.readouterr().out


def test_a_crossing_along_a_parameter() -> None:
    """The same threshold solved for R: w^2 = A m g R / (C (C + m R^2))."""
    found = find("rolling_disk", "theta=pi/2, w_n=2", holds=("w_n",), sweep=("g", 1.0, 9.0, 3))
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    assert crossing.value == pytest.approx(4.0 * 0.125 * 0.375 / (0.0625 * 0.5), abs=1e-9)


SHAFT = """
nhc: 1
system: shaft
about: A rotor on an elastic shaft with friction inside and outside, and a weight on a spring without friction (Crandall 1970).
coordinates: [x, y, z]
parameters: {m: 1, k: 4, ci: 0.2, ce: 0.3, W: 3}
T: m/2*(x'^2 + y'^2) + z'^2
V: k/2*(x^2 + y^2) + z^2
forces: {x: -ce*x' - ci*(x' + W*y), y: -ce*y' - ci*(y' - W*x)}
"""


@pytest.mark.parametrize("count", [10, 11])
def test_a_rotor_whirls_beyond_its_critical_speed(count: int) -> None:
    """W = sqrt(k/m) (1 + ce/ci) = 5, one pair at sqrt(k/m), also where a value of the sweep meets it; z stays on the axis."""
    found = linearize(Source("s.yaml", SHAFT), Request("x=0", sweep=("W", 1.0, 10.0, count)), Options())
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    assert crossing.value == pytest.approx(5.0, abs=1e-9) and crossing.frequency == pytest.approx(2.0, abs=1e-9)
    assert crossing.kind == "a pair crosses the axis" and crossing.unstable_above


ZIEGLER = """
nhc: 1
system: ziegler
coordinates: [a, d]
parameters: {m: 1, l: 1, k: 1, P: 1, c: 0}
bodies:
  one: {turns: [z: a], mass: 2*m, centre: [l, 0]}
  two: {parent: one, at: [l, 0], turns: [z: d], mass: m, centre: [l, 0]}
points: {tip: {parent: two, at: [l, 0]}}
V: k/2*(a^2 + d^2)
forces: {tip_v1: -P, a: -c*a', d: -c*d'}
"""


@pytest.mark.parametrize(
    "c, load, kind",
    [("0", 3.5 - math.sqrt(2.0), "two pairs meet on the axis"), ("1e-5", 41 / 28, "a pair crosses the axis")],
)
def test_a_column_under_a_follower_load(c: str, load: float, kind: str) -> None:
    """Ziegler 1952: 7/2 - sqrt(2) without friction, 41/28 with the least of it."""
    request = Request("a=0", (f"c={c}",), sweep=("P", 1.0, 3.0, 9))
    found = linearize(Source("s.yaml", ZIEGLER), request, Options())
    assert found.swept is not None
    (crossing,) = found.swept.crossings
    assert crossing.value == pytest.approx(load, abs=1e-8) and crossing.kind == kind and crossing.unstable_above


CONE = """
nhc: 1
system: cone
coordinates: [phi, psi]
parameters: {m: 2, h: 0.5, al: 0.4, g: 9.81, be: 0.3}
define: {b: h*tan(al), J: 3/20*m*(b^2 + h^2/4)}
bodies:
  line: {turns: [z: phi, y: -al]}
  cone: {parent: line, turns: [x: psi], mass: m, centre: [3/4*h, 0, 0], inertia: [3/10*m*b^2, J, J]}
points:
  rim: {parent: line, of: cone, at: [h, 0, -b]}
constraints: [rim_v2 = 0]
gravity: [g*sin(be), 0, -g*cos(be)]
"""


def test_a_cone_rolls_about_its_apex_and_has_its_matrix_as_expressions() -> None:
    """5 g sin(be) cos(al)/(h (1 + 5 cos(al)^2)), from 3/40 m h^2 phi'^2 (1 + 5 cos(al)^2) of Landau and Lifshitz, section 32.

    The search rolls it back from phi = 0.1, and psi, which is cyclic, ends at no round number.
    """
    found = linearize(Source("s.yaml", CONE), Request("phi=0.1"), Options())
    expected = 5 * 9.81 * math.sin(0.3) * math.cos(0.4) / (0.5 * (1 + 5 * math.cos(0.4) ** 2))
    assert matches(list(eigenvalues(found.linearisation)), [1j * math.sqrt(expected), -1j * math.sqrt(expected)], 1e-9)
    assert "g*" in " ".join(entry for row in found.paper for entry in row), found.why


@pytest.mark.parametrize("formulation", ["euler-lagrange", "chaplygin", "voronec"])
def test_the_disk_rolls_in_steady_circles(formulation: str) -> None:
    """(C + m R^2) w_n W sin = A W^2 sin cos - m g R cos, with W the rate of the heading."""
    found = find("rolling_disk", "theta=1.2, phi'=-1.5, psi'=3.5", formulation, holds=("theta",))
    made = found.linearisation
    assert made.steady.residual < 1e-10 and not made.steady.equilibrium
    assert cyclic(found) == ["x", "y", "phi", "psi"]
    y = made.steady.y
    turn = found.model.field(y)[0]
    d = DISK
    w_n, heading, s, c = turn[4] + turn[2] * math.cos(y[3]), turn[2], math.sin(y[3]), math.cos(y[3])
    left = (d["C"] + d["m"] * d["R"] ** 2) * w_n * heading * s
    assert left == pytest.approx(d["A"] * heading**2 * s * c - d["m"] * d["g"] * d["R"] * c, abs=1e-9)
    assert made.family == 2 and len(eigenvalues(made)) == 2


def test_the_matrix_of_the_disk_is_printed_in_symbols() -> None:
    found = find("rolling_disk", "theta=pi/2, w_n=3")
    assert found.held == (("theta", "pi/2"), ("w_t", "0"), ("w_u", "0"), ("w_n", "w_n"))
    assert found.paper[0] == ("0", "1", "0", "0")
    values = {**DISK, "w_n": 3.0}
    numbers = [[_number(text, values) for text in row] for row in found.paper]
    assert np.abs(np.array(numbers) - found.linearisation.full).max() < 1e-12


def _number(text: str, values: dict[str, float]) -> float:
    """A printed entry, read back by the language's own parser."""
    from nhc.diagnostics import Bag, Span
    from nhc.language.expressions.parser import parse_expression
    from nhc.mechanics.values import constant_value

    bag = Bag(Source("entry", text))
    tree = parse_expression(text, lambda start, end: Span(start, end), bag)
    bag.raise_if_errors()
    assert tree is not None
    return constant_value(tree, values)


# --- rattleback, ball, sleigh, pendulums -----------------------------------------------------------------------


@pytest.mark.parametrize(("spin", "sign"), [(-5, 1), (5, -1)])
def test_the_rattleback_prefers_a_sense(spin: int, sign: int) -> None:
    found = find("rattleback", f"w3={spin}")
    a, b = complex(-0.202521 * sign, 34.143692), complex(2.120692 * sign, 109.392323)
    made = found.linearisation
    assert cyclic(found) == ["x", "y", "z", "gamma"]
    assert made.family == 1
    assert all(min(abs(x - e) for x in eigenvalues(made)) < 1e-6 for e in (a, b, a.conjugate(), b.conjugate()))
    assert len(eigenvalues(made)) == 4 and verdict(made) == "unstable"


def test_the_rattleback_in_other_velocities() -> None:
    expected = eigenvalues(find("rattleback", "w3=-5").linearisation)
    found = find("rattleback", "gamma'=-5", "voronec").linearisation
    assert matches(eigenvalues(found), expected, 1e-9)


def test_a_turning_motion_is_steady_with_multipliers_too() -> None:
    """x' and y' turn with the heading there, and so do the axes in which the spin is at rest."""
    whole = find("rattleback", "gamma'=-5", "multipliers").linearisation
    kept = find("rattleback", "w3=-5").linearisation
    assert not whole.steady.equilibrium and not kept.steady.equilibrium
    assert matches(eigenvalues(whole), eigenvalues(kept), 1e-9)


def test_the_ball_on_the_turntable_circles_at_two_sevenths() -> None:
    found = find("ball_on_table", "theta=1", holds=("x, y, theta, phi, psi",))
    made = found.linearisation
    assert made.steady.equilibrium
    fast = [x for x in eigenvalues(made) if abs(x) > 1e-6]
    assert matches(fast, [0.4j, -0.4j], 1e-12)  # 2/7 of 1.4


@pytest.mark.parametrize(("push", "expected"), [(1.0, "stable"), (-1.0, "unstable")])
def test_the_sleigh_is_stable_when_pulled(push: float, expected: str) -> None:
    """w' = -m a v w/(J + m a^2): one eigenvalue, its sign that of -v."""
    found = find("chaplygin_sleigh", f"x'={push}", "voronec")
    made = found.linearisation
    values = dict(zip((p.name for p in found.flow.system.spec.parameters), found.model.p, strict=True))
    m, a, J = values["m"], values["a"], values["J"]
    assert matches(eigenvalues(made), [-m * a * push / (J + m * a * a)], 1e-12)
    assert verdict(made) == expected and made.family == 2  # any heading, any speed


def test_the_pendulum_up_and_down() -> None:
    down, up = find("pendulum", "theta=0.3"), find("pendulum", "theta=2.9")
    assert down.linearisation.steady.equilibrium and abs(down.linearisation.steady.y[0]) < 1e-12
    assert abs(up.linearisation.steady.y[0] - math.pi) < 1e-12
    assert verdict(down.linearisation) == "marginal" and verdict(up.linearisation) == "unstable"
    assert down.paper[1][0] == "-g/l" and up.paper[1][0] == "g/l"


def test_a_held_pendulum_in_cartesian_coordinates() -> None:
    """A holonomic constraint: positions stay on it, and the perturbation across it is left out."""
    found = find("holonomic_pendulum", "x=0.6, y=-0.8", "multipliers")
    made = found.linearisation
    assert float(np.abs(found.model.conditions(made.steady.y)[0]).max()) < 1e-10
    assert len(made.rest) == 4 and len(made.basis) == 2
    frequency = max(abs(x) for x in eigenvalues(made))
    assert frequency == pytest.approx(math.sqrt(9.81), rel=1e-9)


def test_a_rotating_body_is_unstable_about_its_middle_axis() -> None:
    for axis, expected in ((1, "marginal"), (2, "unstable"), (3, "marginal")):
        found = find("free_rigid_body", f"theta=1, {_spin_name(axis)}=2")
        assert cyclic(found) == ["phi", "theta", "psi"]
        assert verdict(found.linearisation) == expected
        assert found.linearisation.family == 1


def _spin_name(axis: int) -> str:
    spec = model(read(str(spec_path("free_rigid_body")))).spec
    return spec.quasi_velocities[axis - 1].name


# --- what is refused --------------------------------------------------------------------------------------------


def test_no_verdict_where_no_eigenvalue_is_left(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    """Every motion of a free particle and of a sleigh about its edge is steady: nothing decays, nothing grows."""
    sleigh = """coordinates: [x, y, theta]
T: (x'^2 + y'^2 + theta'^2)/2
constraints: [cos(theta)*y' - sin(theta)*x' = 0]
quasi_velocities: {v: cos(theta)*x' + sin(theta)*y', w: theta'}
scenes: {go: {initial: {v: 1, w: 0.2}, time: [0, 1]}}
"""
    particle = "coordinates: [x]\nT: x'^2/2\nscenes: {go: {initial: {x': 1}, time: [0, 1]}}\n"
    for text in (sleigh, particle):
        path = tmp_path / "free.yaml"
        path.write_text(f"nhc: 1\nsystem: free\n{text}", encoding="utf-8")
        assert main(["linearize", str(path), "--about", "go"]) == 0
        assert "verdict: none: no eigenvalue is left to judge by" in capsys.readouterr().out
    assert main(["stability", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["steady"]["verdict"] == "none"


def test_what_never_stands_still_is_refused() -> None:
    with pytest.raises(NotSteady) as caught:
        find("skate_incline", "reference")
    assert caught.value.residual == pytest.approx(4.9, abs=0.1)
    with pytest.raises(NotSteady, match="depend on the time"):
        find("pumped_pendulum", "reference")


STEPPED = """nhc: 1
system: stepped
coordinates: [x, y]
parameters: {m: 1, k: 4, f: 2, c: 1}
T: m/2*(x'^2 + y'^2)
V: k/2*y^2
forces:
  y: f*STEP - c*y'
"""


@pytest.mark.parametrize("step", ["sign(x)", "abs(x)/x", "sqrt(x^2)/x", "x/(abs(x) + 0*y)"])
def test_a_coordinate_that_only_a_step_contains_is_not_cyclic(step: str) -> None:
    """y stands at f/k while x > 0 and at -f/k while x < 0: a motion that passes x = 0 is not steady, though no slope tells."""
    source = Source("stepped.yaml", STEPPED.replace("STEP", step))
    found = linearize(source, Request("x=1, x'=-1, y=0.5"))
    assert cyclic(found) == []
    assert found.linearisation.steady.y == pytest.approx([1.0, 0.5, 0.0, 0.0], abs=1e-9)
    free = linearize(Source("free.yaml", STEPPED.replace("STEP", "1")), Request("x=1, x'=-1, y=0.5"))
    assert cyclic(free) == ["x"]
    assert free.linearisation.steady.y == pytest.approx([1.0, 0.5, -1.0, 0.0], abs=1e-9)


SPINNING = """nhc: 1
system: spinning
rotation: {R: {velocities: [w1, w2, w3], frame: body}}
parameters: {I1: 2, I3: 1, f: 3, c: 1}
T: (I1*(w1^2 + w2^2) + I3*w3^2)/2
forces: {w3: f*STEP - c*w3, w1: -c*w1, w2: -c*w2}
"""


def test_a_turn_that_a_step_sees_is_no_symmetry() -> None:
    """About the body's third axis R_x1 changes its sign and with it the torque, R_x1^2 + R_x2^2 does not change at all."""
    start = "R_0=0.8, R_1=0.6, w3=3"
    steady = linearize(Source("spinning.yaml", SPINNING.replace("STEP", "sign(R_x1^2 + R_x2^2)")), Request(start))
    assert steady.linearisation.steady.y[-1] == pytest.approx(3.0) and steady.model.symmetries
    with pytest.raises(NotSteady):
        linearize(Source("spinning.yaml", SPINNING.replace("STEP", "sign(R_x1)")), Request(start))


def test_a_force_that_is_switched_on_makes_nothing_steady() -> None:
    with pytest.raises(NotSteady, match="depend on the time"):
        linearize(Source("switched.yaml", STEPPED.replace("STEP", "sign(t - 1)")), Request("y=0.5"))


@pytest.mark.parametrize(
    ("request_", "codes"),
    [
        (Request("nothing"), "E0503"),
        (Request("thete=1"), "E0419"),
        (Request("theta=oops"), "E0302"),
        (Request("theta"), "E0503"),
        (Request("theta=1, 2"), "E0208"),
        (Request("1, theta=1=2, 2"), "E0208 E0208 E0208"),
        (Request("theta=1", settings=("m=l",)), "E0314"),
        (Request("theta=1", holds=("nothing",)), "E0419"),
        (Request("theta=1", sweep=("nothing", 0.0, 1.0, 3)), "E0419"),
    ],
)
def test_requests_are_checked(request_: Request, codes: str) -> None:
    """Everything that is wrong is said at once."""
    with pytest.raises(SpecError) as caught:
        linearize(read(str(spec_path("pendulum"))), request_)
    assert [d.code for d in caught.value.diagnostics] == codes.split()


@pytest.mark.parametrize("start", ["theta=0.5, psi'=6, phi'=2", "theta=1, psi'=6, phi'=2"])
def test_no_verdict_where_the_coordinates_are_singular(start: str) -> None:
    """The top upright in Euler's angles: its slopes were printed, with a frequency that is rounding."""
    with pytest.raises(NotSteady, match="coordinates are singular") as caught:
        find("heavy_top", start)
    assert "rotation" in caught.value.advice


@pytest.mark.parametrize("start", ["theta=2.2, phi'=4", "theta=2.5, phi'=4", "theta=2.2"])
def test_no_verdict_at_the_pole_of_a_sphere(start: str) -> None:
    """Upright, where a pendulum is unstable and its azimuth means nothing: it was called marginal, with eigenvalues 0 +- 3.3 i."""
    with pytest.raises(NotSteady, match="coordinates are singular"):
        find("spherical_pendulum", start)


@pytest.mark.parametrize("radius", [1e-9, 1.0, 1e9])
def test_a_small_circle_is_no_pole(radius: float, tmp_path: Path) -> None:
    """A mass on a spring that turns about a pin: the radius oscillates with (k + 3 m phi'^2)/m."""
    text = (
        "nhc: 1\nsystem: pin\ncoordinates: [r, phi]\nparameters: {k: 5, a: RADIUS}\nT: r'^2/2 + r^2*phi'^2/2\n"
        "V: k*(r - a)^2/2\nscenes: {go: {initial: {r: START, phi': 1}, time: [0, 1]}}\n"
    ).replace("RADIUS", repr(radius))
    path = tmp_path / "pin.yaml"
    path.write_text(text.replace("START", repr(1.3 * radius)), encoding="utf-8")
    made = linearize(read(str(path)), Request("go", holds=("phi'",))).linearisation
    assert made.steady.y[0] == pytest.approx(1.25 * radius, rel=1e-9)
    assert max(value.imag for value in eigenvalues(made)) == pytest.approx(math.sqrt(5 + 3), rel=1e-6)


def test_a_lock_in_quasi_velocities_that_other_formulations_do_not_have() -> None:
    """The start is read once: other coframes do not know the name `w1`."""
    with pytest.raises(NotSteady):
        find("suslov", "w1=1")


def test_coordinates_without_mass_are_not_singular() -> None:
    """Wheels without inertia are determined by their constraints: the bordered matrix is regular where M is not."""
    about = "x=0"
    settings = ("J_w=0, tau_R=0, tau_L=0",)
    found = find("diff_drive", about, "multipliers", settings=settings)
    assert found.model.regularity(found.linearisation.steady.y) > 1e-3


def test_a_hold_that_nothing_meets_is_refused() -> None:
    with pytest.raises(NotSteady):
        find("pendulum", "theta=1", holds=("theta=1",))


def test_the_field_is_the_emitted_one() -> None:
    """Field and slopes against the emitted Python at a state that is not steady."""
    from tests.support import emitted_python, error, reference

    made = model(read(str(spec_path("rolling_disk"))), Options(formulation="voronec"))
    emitted = emitted_python("rolling_disk", "voronec")
    numbers: SteadyModel = steady_model(made.equations, made.formulation, emitted.DEFAULTS)
    states = next(e["states"] for e in reference("pointwise") if e["system"] == "rolling_disk")
    for state in states:
        y = emitted.state(0.0, [float(x) for x in state["q"]], [float(x) for x in state["v"]])
        rates, slopes = numbers.field(y)
        assert error(rates, emitted.rhs(0.0, y)) < 1e-12
        assert error(slopes.ravel(), [x for row in emitted.jacobian(0.0, y) for x in row]) < 1e-11


LEAF = """nhc: 1
system: s
coordinates: [x, y, z]
T: (x'^2 + y'^2 + z'^2)/2
V: z
constraints: [level: z' = 2*x*x' + 3*y*y']
"""


CARRIAGE = """
nhc: 1
system: carriage
about: a pendulum on two wheels
parameters: {M: 5.0, m: 0.3, R: 0.1, b: 0.25, h: 0.3, A: 0.1, B: 0.12, C: 0.05, Jw: 0.002, Jd: 0.001, g: 9.81}
coordinates: [x, y, psi, th, left, right]
T: >
  M/2*((x' + h*(th'*cos(th)*cos(psi) - psi'*sin(th)*sin(psi)))^2
  + (y' + h*(th'*cos(th)*sin(psi) + psi'*sin(th)*cos(psi)))^2 + h^2*th'^2*sin(th)^2)
  + 1/2*(A*psi'^2*sin(th)^2 + B*th'^2 + C*psi'^2*cos(th)^2)
  + m*(x'^2 + y'^2) + (m*b^2 + Jd)*psi'^2 + Jw/2*(left'^2 + right'^2)
U: -M*g*h*cos(th)
constraints:
  - -x'*sin(psi) + y'*cos(psi) = 0
  - x'*cos(psi) + y'*sin(psi) - b*psi' = R*left'
  - x'*cos(psi) + y'*sin(psi) + b*psi' = R*right'
scenes:
  roll: {initial: {th: 0.05, psi: 0.3, psi': 0.4, left': 2}, time: [0, 2]}
"""


def test_what_only_rounding_has_moved_is_as_it_was_given() -> None:
    found = linearize(Source("carriage.yaml", CARRIAGE), Request("roll"))
    steady = dict(zip(found.flow.names, found.linearisation.steady.y, strict=True))
    assert (steady["psi"], steady["psi'"]) == (0.3, 0.4)
    assert abs(steady["th"]) < 1e-11  # this was a disturbance
    made = model(Source("carriage.yaml", CARRIAGE))
    assert (
        steady_motion(made.equations, made.formulation, Search("roll")).linearisation.steady.y[4:]
        == (found.linearisation.steady.y[4:])
    )


def test_velocities_that_the_state_does_not_keep_give_it_expressions() -> None:
    """The disk's rolling speed x' = -R w_n in place of w_n."""
    kept = find("rolling_disk", "theta=pi/2, w_n=-3")
    given = find("rolling_disk", "theta=pi/2, x'=1.5")
    assert given.linearisation.steady.y == pytest.approx(kept.linearisation.steady.y, abs=1e-14)
    assert given.paper == kept.paper and any(entry not in ("0", "1") for row in given.paper for entry in row)


def test_a_negative_mass_is_no_gimbal_lock() -> None:
    """T < 0 for some motion is warned of elsewhere; the equations of a skate are what they are."""
    spec = "nhc: 1\nsystem: odd\nparameters: {m: -1}\ncoordinates: [x, y, th]\nT: m/2*(x'^2 + y'^2) + th'^2/2\n"
    spec += "constraints: [\"sin(th)*x' = cos(th)*y'\"]\n"
    found = linearize(Source("odd.yaml", spec), Request("x'=1"))
    assert found.linearisation.steady.y[3:] == (1.0, 0.0)


@pytest.mark.parametrize("force", ["F", "F*cos(t)"])
def test_a_force_without_amplitude_leaves_the_expressions(force: str) -> None:
    """They hold where it is 0, and say so; with any other amplitude nothing is steady there, or the place is another."""
    spec = "nhc: 1\nsystem: rail\nparameters: {m: 2, k: 3, c: 0.5, F: 0}\ncoordinates: [x]\nT: m/2*x'^2\nV: k/2*x^2\n"
    source = Source("rail.yaml", spec + f"forces: {{x: {force} - c*x'}}\n")
    found = linearize(source, Request("x=0"))
    assert found.paper == (("0", "1"), ("-k/m", "-c/m")) and found.held == (("x", "0"), ("x'", "0"), ("F", "0"))
    found = linearize(source, Request("x=0", settings=("c=0",)))
    assert found.paper[1] == ("-k/m", "0") and found.held[2:] == (("c", "0"), ("F", "0"))


def test_a_start_that_is_completed_in_another_way_has_no_expressions() -> None:
    """One given velocity of two that are free: which of the kept ones it is about is not for a formula to say."""
    source = Source(
        "pair.yaml",
        "nhc: 1\nsystem: pair\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nU: -x^2\nconstraints: [z' = x' + y']\n",
    )
    found = linearize(source, Request("z'=1"), Options(formulation="voronec"))
    assert found.paper == () and found.why == "nhc finds no expression in the parameters for the place of the motion"


def test_an_unknown_name_in_a_value_of_a_motion_is_named() -> None:
    with pytest.raises(SpecError) as caught:
        find("rolling_disk", "theta=pi/2, x'=r*3")
    (one,) = caught.value.diagnostics
    assert (one.code, one.message, one.help) == ("E0302", "unknown name `r`", ("did you mean `R`?",))
    with pytest.raises(SpecError) as caught:
        find("rolling_disk", "theta=pi/2, x'=theta")
    assert caught.value.diagnostics[0].code == "E0314"


def test_a_search_that_runs_off_says_so() -> None:
    """On a leaf z = x^2 + 3/2 y^2 + c rates grow up to x = 1/2 and fall beyond: from there they fall away from the equilibrium."""
    with pytest.raises(NotSteady, match=r"runs off, to z = .*but do not vanish") as caught:
        linearize(Source("s.yaml", LEAF), Request(about="x=1, y=0.5"))
    assert "there may be none" in caught.value.advice and 0.0 < caught.value.residual < 0.1
    found = linearize(Source("s.yaml", LEAF), Request(about="x=0.3, y=0.1")).linearisation
    assert found.steady.y[:2] == pytest.approx((0.0, 0.0), abs=1e-12)


def test_a_quaternion_may_be_given_in_part_and_of_any_length() -> None:
    """As in a scene; it had been refused as off a constraint `R_norm` that no spec declares."""
    top = read(spec_path("heavy_top_quaternion"))
    one, other = (linearize(top, Request(about=f"{given}, w3=3")) for given in ("R_1=0.1", "R_0=10, R_1=1"))
    assert one.linearisation.steady.y == pytest.approx(other.linearisation.steady.y, abs=1e-9)
    start = scene_about(decode(top), "R_1=0.1", ("R_2=0.2",))
    values = {entry.name: constant_value(entry.value, {}) for entry in start.initial}
    length = math.sqrt(1.05)
    assert values == pytest.approx({"R_0": 1 / length, "R_1": 0.1 / length, "R_2": 0.2 / length, "R_3": 0.0})
    with pytest.raises(SpecError, match=r"(?s)E0313|must not be zero"):
        linearize(top, Request(about="R_0=0"))


def test_steps_keep_to_the_leaf() -> None:
    """Without a hold the front wheel of the bicycle stays on the ground to first order; with one, exactly."""
    made = model(read(str(spec_path("bicycle"))), Options(formulation="voronec"))
    found = find("bicycle", STRAIGHT, "voronec")
    guess = list(found.linearisation.steady.y)
    guess[6] = 0.02  # a little steer
    height = named_quantity(found.flow, "front_height", "--hold")
    held = find_steady(found.model, guess, [Hold("front_height", height, 0.0)])
    assert abs(found.model.value(held.y, height)) < 1e-12
    free = find_steady(found.model, guess)
    before = found.model.value(guess, height)
    assert abs(found.model.value(free.y, height) - before) < 2e-3
    assert made.system.l == 6


def test_the_command_line_gives_the_same_in_full(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["linearize", "rolling_disk", "--about", "theta=pi/2, w_n=3", "--sweep", "w_n=1:4:2", "--json"]
    assert main(arguments) == 0
    tree = json.loads(capsys.readouterr().out)
    made = find("rolling_disk", "theta=pi/2, w_n=3").linearisation
    assert tree["schema"] == "nhc.linearize/1"
    assert tree["matrix"] == made.full.tolist() and tree["structural_zeros"] == made.family == 2
    assert [complex(x["real"], x["imag"]) for x in tree["eigenvalues"]] == eigenvalues(made)
    assert tree["crossings"][0]["value"] == pytest.approx(2.557342370508877, abs=1e-12)
    assert [point["value"] for point in tree["sweep"]] == [1.0, 4.0]


def test_values_without_a_size_are_no_warning_of_numpy(capsys: pytest.CaptureFixture[str]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert main(["linearize", "rolling_disk", "--sweep", "w_n=1:1e308:3"]) == 0
    told = capsys.readouterr().out
    assert "5e+307         no steady motion found: the iteration stops" in told
    assert main(["linearize", "rolling_disk", "--sweep", "w_n=5e307:1e308:2"]) == 3
    assert "error: at w_n = 5e+307: the iteration stops" in capsys.readouterr().err


FOLD = """\
nhc: 1
system: fold
coordinates: [x]
parameters: {mu: 1, c: 0.1}
T: x'^2/2
V: x^3/3 - mu*x
forces: {x: -c*x'}
scenes: {s: {initial: {x: 0.9}, time: [0, 5]}}
"""


def test_a_sweep_over_a_fold_ends_there(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """x = sqrt(mu), lambda^2 + c lambda + 2 sqrt(mu) = 0: nothing is steady below mu = 0."""
    source = Source("fold.yaml", FOLD)
    swept = linearize(source, Request("s", (), (), ("mu", -1.0, 1.0, 8)), Options()).swept
    assert swept is not None and len(swept.values) == len(swept.missing) == 4
    for mu, point in zip(swept.values, swept.points, strict=True):
        assert point.steady.y[0] == pytest.approx(math.sqrt(mu), rel=1e-9)
        assert abs(eigenvalues(point)[0]) ** 2 == pytest.approx(2 * math.sqrt(mu), rel=1e-7)
    ((inside, outside),) = swept.ends
    assert -1e-5 < outside <= inside < 1e-3
    path = tmp_path / "fold.yaml"
    path.write_text(FOLD, encoding="utf-8")
    assert main(["linearize", str(path), "--sweep", "mu=-1:1:8"]) == 0
    told = capsys.readouterr().out
    assert "the steady motions end between mu = " in told and told.count("no steady motion found") == 4
    assert main(["stability", str(path), "--about", "s", "--sweep", "mu=-1:1:8"]) == 0
    assert "the steady motions end" in capsys.readouterr().out


def test_without_numpy_the_packages_are_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    hide_numpy(monkeypatch)
    assert main(["linearize", "pendulum", "--about", "theta=0"]) == 2
    error = capsys.readouterr().err
    assert "needs numpy" in error and "`python -m pip install numpy scipy`" in error


def test_rare_functions_on_a_tape() -> None:
    """Each function of the language against the plain evaluator, and poles as arithmetic errors."""
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    unary = ("sin", "cos", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt", "abs", "sign")
    nodes = [g.function(name, x) for name in unary]
    nodes += [g.function(name, x, y) for name in ("atan2", "min", "max", "powf")]
    nodes += [g.neg(g.mul(x, y)), g.power(x, -3), g.mul(g.pi(), g.add(x, y)), g.number(7)]
    at = {x: 0.3, y: 0.7}
    assert list(Tape(g, nodes)(at)) == pytest.approx(evaluate(g, nodes, at), rel=1e-15)
    for node in (
        g.inverse(x),
        g.function("log", x),
        g.function("sqrt", g.sub(x, y)),
        g.function("powf", g.sub(x, y), y),
    ):
        with pytest.raises(ArithmeticError):
            Tape(g, [node])({x: 0.0, y: 0.7})


def test_a_coframe_that_is_singular_at_the_steady_motion_gives_way_to_multipliers() -> None:
    """A slider-crank hangs at its lower quarter turn: 16/3 c'' + 10 c' + 14.715 c = 0; the choice for its range fails there."""
    text = """nhc: 1
system: crank
coordinates: {c: {range: [0.2, 1.2]}, b: {}, s: {range: [1.5, 3]}}
define: {bx: cos(c) + 1.25*cos(b), by: sin(c) - 1.25*sin(b)}
T: c'^2/6 + bx'^2 + by'^2 + 6.25/12*b'^2 + 3/2*s'^2
V: 9.81*(sin(c)/2 + 2*by)
forces: {s: -10*s'}
holonomic: ["cos(c) + 2.5*cos(b) - s = 0", "sin(c) = 2.5*sin(b)"]
scenes: {turn: {initial: {s: 3.5, c': 4}, time: [0, 3]}}
"""
    source = Source("crank.yaml", text)
    found = linearize(source, Request("turn"))
    assert found.formulation.name == "multipliers"
    root = cmath.sqrt(100 - 4 * 16 / 3 * 14.715)
    wanted = sorted(((-10 + sign * root) * 3 / 32 for sign in (1, -1)), key=lambda x: x.imag)
    assert sorted(eigenvalues(found.linearisation), key=lambda x: x.imag) == pytest.approx(wanted, rel=1e-6)
    with pytest.raises(NotSteady, match="coframe is singular at the steady motion"):
        linearize(source, Request("turn"), Options(formulation="voronec"))


EDGE = """nhc: 1
system: edge
coordinates: [x, y, th]
T: (x'^2 + y'^2 + 2*th'^2)/2
V: (x^2 + y^2 + th^2)/2
constraints: ["-sin(th)*x' + cos(th)*y' = 0"]
quasi_velocities: {u: y', w: th'}
"""
TURNED = """nhc: 1
system: turned
rotation: {R: {velocities: [p, q, r]}}
coordinates: [x, y, z]
T: (x'^2 + y'^2 + z'^2 + p^2 + 2*q^2 + 3*r^2)/2
V: (x^2 + y^2 + 2*z^2)/2 - R_x1 - R_y2
constraints: ["x'*R_x2 + y'*R_y2 + z'*R_z2 = 0"]
scenes: {turned: {initial: {R: {axis: [1, 0, 0], angle: pi/2}}, time: [0, 1]}}
"""


@pytest.mark.parametrize(
    ("text", "about", "holds", "squares"),
    [
        (EDGE, "x=0.1", (), (1, 1 / 2)),
        (EDGE, "x=0.1", ("x'",), (1, 1 / 2)),
        (TURNED, "x=0.1", (), (2, 1, 1, 2 / 3, 1 / 2)),
    ],
    ids=["edge", "held", "turned"],
)
def test_a_coframe_that_is_singular_where_the_search_begins_gives_way_too(
    text: str, about: str, holds: tuple[str, ...], squares: tuple[float, ...]
) -> None:
    """It has no equations there; the steady motion with its eigenvalues has nothing to do with it."""
    source, request = Source("weak.yaml", text), Request(about, holds=holds)
    found = linearize(source, request)
    assert found.formulation.name == "multipliers"
    expected = [complex(0, sign * math.sqrt(square)) for square in squares for sign in (1, -1)]
    assert matches(eigenvalues(found.linearisation), expected, 1e-6)
    with pytest.raises(NotSteady, match="coframe is singular where the search"):
        linearize(source, request, Options(formulation="euler-lagrange"))


TOWED = """nhc: 1
system: towed
coordinates: [x, y, theta]
parameters: {m: 1, J: 0.5, a: 0.3, F: 2, c: 0.7, M: 0.6, k: 0.2}
define: {X: x + a*cos(theta), Y: y + a*sin(theta), v: cos(theta)*x' + sin(theta)*y'}
T: m/2*(X'^2 + Y'^2) + J/2*theta'^2
forces: {x: (F - c*v)*cos(theta), y: (F - c*v)*sin(theta), theta: M - k*theta'}
constraints: ["-sin(theta)*x' + cos(theta)*y' = 0"]
quasi_velocities: {u: y', w: theta'}
scenes: {turn: {initial: {x': 2.9, theta': 0.6}, time: [0, 5]}}
"""


def test_steady_turning_is_found_where_the_quasi_velocities_are_singular() -> None:
    """m v' = m a w^2 + F - c v, (J + m a^2) w' = -m a v w + M - k w: in y' no motion that turns is steady."""
    m, J, a, F, c, M, k = 1, 0.5, 0.3, 2, 0.7, 0.6, 0.2
    found = linearize(Source("towed.yaml", TOWED), Request("turn"))
    v, w = (found.model.value(found.linearisation.steady.y, found.flow.velocities[i]) for i in (0, 2))
    assert (m * a * w**2 + F - c * v, M - k * w - m * a * v * w) == pytest.approx((0, 0), abs=1e-12)
    assert abs(v - 2.9) + abs(w - 0.6) < 0.2
    trace, det = (
        -c / m - (k + m * a * v) / (J + m * a**2),
        (c * (k + m * a * v) + 2 * (m * a * w) ** 2) / (m * (J + m * a**2)),
    )
    roots = [(trace + sign * cmath.sqrt(trace**2 - 4 * det)) / 2 for sign in (1, -1)]
    assert matches(eigenvalues(found.linearisation), roots, 1e-9)
    with pytest.raises(NotSteady):
        linearize(Source("towed.yaml", TOWED), Request("turn"), Options(formulation="voronec"))
    whole = linearize(Source("towed.yaml", TOWED), Request("turn"), Options(formulation="multipliers"))
    assert matches(eigenvalues(whole.linearisation), roots, 1e-9)
    made = model(Source("towed.yaml", TOWED))
    motion = steady_motion(made.equations, made.formulation, Search("turn"))
    assert matches(eigenvalues(motion.linearisation), roots, 1e-9)


@pytest.mark.parametrize("cone", [0.05, -0.05])
def test_a_wheelset_on_its_cones(cone: float) -> None:
    """Klingel 1883: it weaves with v sqrt(cone/(a r)), and leaves the track where the cones are reversed.

    Its hidden constraint has an integral that is not regular on the straight track: to leave out the directions across it
    would be to leave out the motion itself.
    """
    text = f"""nhc: 1
system: wheelset
coordinates: [x, y, psi, phi]
parameters: {{m: 1000, Iz: 600, Iy: 100, r: 0.45, a: 0.75, cone: {cone}}}
T: m/2*(x'^2 + y'^2) + Iz/2*psi'^2 + Iy/2*phi'^2
constraints:
  - left: cos(psi)*x' + sin(psi)*y' - a*psi' - (r + cone*y)*phi' = 0
  - right: cos(psi)*x' + sin(psi)*y' + a*psi' - (r - cone*y)*phi' = 0
  - lateral: -sin(psi)*x' + cos(psi)*y' = 0
scenes: {{straight: {{time: [0, 1], initial: {{phi': 40}}}}}}
"""
    found = linearize(Source("wheelset.yaml", text), Request("straight"))
    pair = 40 * 0.45 * cmath.sqrt(-cone / (0.75 * 0.45))
    assert matches(eigenvalues(found.linearisation), [pair, -pair], 1e-9)
    assert verdict(found.linearisation) == ("marginal" if cone > 0 else "unstable")


CRANK = """nhc: 1
system: crank
coordinates: [a, b, x]
parameters: [l]
T: l*(a'^2 + b'^2 + x'^2)/2
holonomic: ["cos(a) + 3*cos(b) = x", "sin(a) - 3*sin(b) = 0"]
"""


@pytest.mark.parametrize(
    ("about", "said"),
    [
        (
            "a=0.3, l=1",
            ("the motion of `--about` starts off 2 constraints", "--> s.yaml:3:1", "`--about` gives no", "`a="),
        ),
        ("x=4, a'=1, b'=1, l=1", ("the initial velocities of the motion of `--about` violate", "--> s.yaml:3:1")),
        ("x=4", ("the motion of `--about` gives no value to the parameter `l`", "write `l=...` beside it")),
    ],
)
def test_what_is_wrong_with_a_motion_is_said_of_it(
    about: str,
    said: tuple[str, ...],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Values on the command line are no scene of the spec, and are mended there."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "s.yaml").write_text(CRANK)
    assert main(["linearize", "s.yaml", "--about", about]) == 1
    told = capsys.readouterr().err
    assert not [text for text in said if text not in told], told
    assert "the scene" not in told
    assert "near:" not in told


IN_A_CYLINDER = """nhc: 1
system: ball_in_cylinder
coordinates: [phi, z]
parameters: {m: 1, a: 0.2, R: 1, g: 9.81}
rotation: {S: {velocities: [wx, wy, wz], frame: space}}
T: m/2*((R - a)^2*phi'^2 + z'^2) + m*a^2/5*(wx^2 + wy^2 + wz^2)
V: m*g*z
constraints:
  - (R - a)*phi' + a*wz = 0
  - z' + a*(wx*sin(phi) - wy*cos(phi)) = 0
quasi_velocities:
  wr: wx*cos(phi) + wy*sin(phi)
  wt: -wx*sin(phi) + wy*cos(phi)
  wn: wz
"""


@pytest.mark.parametrize(("about", "speed"), [("phi'=3", 3.0), ("wn=-2", 0.5), ("phi'=3, wt=0.1", 3.0)])
def test_of_a_family_the_motion_with_the_speed_that_was_asked_for_is_taken(about: str, speed: float) -> None:
    """A ball that rolls inside a vertical cylinder sways up and down at sqrt(2/7) of the speed at which it goes round (Neimark and
    Fufaev 1972); the member of the family that is nearest in the whole state goes round at nearly twice that speed.
    """
    found = linearize(Source("cylinder.yaml", IN_A_CYLINDER), Request(about))
    flow, steady = found.flow, found.linearisation.steady
    assert found.model.value(steady.y, named_quantity(flow, "phi'", "")) == pytest.approx(speed, rel=1e-12)
    pair = cmath.sqrt(-2 / 7) * speed
    assert matches(eigenvalues(found.linearisation), [pair, -pair], 1e-9)
    assert not found.halted


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("name", "scene", "kept"),
    [
        ("free_rigid_body_quaternion", "flip", {"w1": 0.0, "w2": 1.0}),
        ("heavy_top_quaternion", "upright", {"w1": 0.0, "w3": 1.5}),
        ("bicycle", "reference", {"roll'": 0.0, "thF'": -4.6 / 0.35}),
        ("chaplygin_sleigh", "glide", {"v": 1.0, "w": 0.0}),
    ],
)
def test_of_a_scene_the_speed_is_kept_and_not_the_disturbance(name: str, scene: str, kept: dict[str, float]) -> None:
    """The scenes start beside their steady motions, and what they add to these is a thousandth of the energy or less."""
    found = find(name, scene)
    y = found.linearisation.steady.y
    for velocity, value in kept.items():
        there = found.model.value(y, named_quantity(found.flow, velocity, ""))
        assert there == pytest.approx(value, rel=1e-11, abs=1e-11)


def test_a_scene_far_from_steady_motions_does_not_lead_farther() -> None:
    """Rates of Euler's angles can all be had far away, of a spin about another axis than the one that the scene nearly has."""
    found = find("free_rigid_body", "reference")
    w = [found.model.value(found.linearisation.steady.y, named_quantity(found.flow, f"w{k}", "")) for k in (1, 2, 3)]
    assert w == pytest.approx([0.0, 0.0, 0.9], abs=1e-9)


@pytest.mark.slow
def test_what_hidden_constraints_hold_stays_what_it_was() -> None:
    """Long steps from a scene that is hit from the side lifted the bicycle by a millimetre, and changed its crossings."""
    found = find("bicycle", "reference")
    assert found.linearisation.steady.y[:9] == pytest.approx([0, 0, -0.3, 0, 0, 0, 0, 0, 0], abs=1e-13)
    assert [hold.name for hold in found.model.leaf_holds] == ["rear_height", "front_height"]
    assert [hold.value for hold in found.model.leaf_holds] == pytest.approx([0.0, 0.0], abs=1e-15)
    lifted = find("bicycle", "reference", settings=("z=-0.301",))  # the start's own leaf, wherever that is
    assert [hold.value for hold in lifted.model.leaf_holds] == pytest.approx([-0.001, -0.001], abs=1e-12)
    assert lifted.linearisation.steady.y[2] == pytest.approx(-0.301, abs=1e-12)


@pytest.mark.slow
def test_a_crossing_takes_few_steady_motions(monkeypatch: pytest.MonkeyPatch) -> None:
    """Two crossings, and a pair that becomes real without crossing: some ten looks each, where bisection took fifty."""
    looks: list[float] = []
    call = Branch.__call__

    def counted(branch: Branch, value: float) -> object:
        looks.append(value)
        return call(branch, value)

    monkeypatch.setattr(Branch, "__call__", counted)
    text = spec_path("bicycle").read_text(encoding="utf-8")
    text = text.replace("c: {value: 0.08,", "c: {value: 0.088,").replace("m_B: {value: 85,", "m_B: {value: 93.5,")
    swept = linearize(Source("s.yaml", text), Request("reference", sweep=("speed", 0.0, 10.0, 21)), Options()).swept
    assert swept is not None and [c.kind for c in swept.crossings] == [
        "a pair crosses the axis",
        "an eigenvalue passes zero",
    ]
    # the linear equations of Meijaard et al. (2007), of a bicycle that stands on the ground
    assert [c.value for c in swept.crossings] == pytest.approx([4.514634439282, 6.478541875346], rel=1e-11)
    assert all(c.error <= 1e-12 for c in swept.crossings)
    assert len(looks) <= 21 + 60


def test_a_tape_remembers_and_tells_zeros_apart() -> None:
    g = Graph()
    y, x = g.symbol("y"), g.symbol("x")
    tape = Tape(g, [g.function("atan2", y, x)])
    for _ in range(2):
        assert tape({y: 0.0, x: -1.0})[0] == math.pi and tape({y: -0.0, x: -1.0})[0] == -math.pi
    tape({y: 1.0, x: 1.0})[0] = 5.0
    assert tape({y: 1.0, x: 1.0})[0] == math.pi / 4


SNAKE = """nhc: 1
system: snake
coordinates: [x, y, a, b, c]
parameters: {l: 1.5, k: 0}
define: {X: x - l*cos(b), Y: y - l*sin(b), U1: X - l*cos(b) - cos(c), U2: Y - l*sin(b) - sin(c)}
T: x'^2 + y'^2 + a'^2/3 + X'^2 + Y'^2 + b'^2/5 + U1'^2 + U2'^2 + c'^2
V: k*((a - b)^2 + (b - c)^2)
constraints: ["-sin(a)*x' + cos(a)*y' = 0", "-sin(b)*X' + cos(b)*Y' = 0", "-sin(c)*U1' + cos(c)*U2' = 0"]
scenes: {rest: {initial: {a: 0.4, b: 0.1, c: 0.5}, time: [0, 1]}}
"""


def test_where_every_position_is_an_equilibrium_no_neighbours_are_sought(monkeypatch: pytest.MonkeyPatch) -> None:
    """All positions of three skates without forces; with springs only those in a row, which take the search."""
    searched = []
    whole = linearize_module.find_steady

    def search(*arguments: Any) -> Any:
        searched.append(arguments)
        return whole(*arguments)

    monkeypatch.setattr(linearize_module, "find_steady", search)
    monkeypatch.setattr(absent_module, "leave_zeros_out", lambda *_: None)  # with k, which is 0, among the equations
    free, spring = (
        linearize(Source("snake.yaml", SNAKE), Request("rest", settings), Options()).linearisation
        for settings in ((), ("k=1", "a=0.1", "c=0.1"))
    )
    assert (free.family, free.zeros, spring.family) == (2, 2, 1)
    assert {about.p for about, *_ in searched} == {(1.5, 1.0)}
    searched.clear()
    monkeypatch.setattr(linearize_module, "_rests_anywhere", lambda *_: False)
    again = linearize(Source("snake.yaml", SNAKE), Request("rest"), Options()).linearisation
    assert (again.family, again.zeros) == (2, 2) and len(searched) > 0
