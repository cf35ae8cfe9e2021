"""What jumps: energies that are other ones beyond, constraints that no motion follows, momenta that are no states."""

from __future__ import annotations

import math
from typing import Any

import pytest

from nhc.algebra.bounds.jumps import _Lines, jumps
from nhc.diagnostics import Bag, Diagnostic
from nhc.language import Source, decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.properties.conserved import find_conserved
from nhc.mechanics.properties.facts import describe
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.pipeline import Options, check, reduce_scene
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run

pytestmark = pytest.mark.usefixtures("optimised_models")
HEAD = "nhc: 1\nsystem: jump\ncoordinates: [x, y]\nparameters: {k: 0.5, e: 1e-3}\n"
ENDS = "scenes: {a: {initial: {x: -1, y: 0.3, x': 3, y': 0.2}, time: [0, 2], need: [energy]}}\n"
JUMPING = (
    "sign(x)",
    "atan(1/x)",
    "tanh(1/x)",
    "atan(tan(2*x))",
    "max(x, 0)/x",
    "sign(x^2 + y^2 - 0.3)",
    "sqrt(x^2*(1 + y^2))/x",
    "k*(sign(x)/2 + y*(1/(x - 3) + sign(x)))",
)
CONTINUOUS = (
    "k/sqrt(x^2 + y^2)",
    "k/sqrt(x^2 + y^2) - 1/sqrt((x - 1)^2 + (y - 2)^2)",
    "x/(x^2 + y^2)^(3/2)",
    "x*sign(x)",
    "x/sqrt(x^2 + e^2)",
    "tanh(x/e)",
    "abs(x)",
    "sin(x)/x",
    "1/x^2 + k*abs(x)",
    "acos(cos(x))",
    "sqrt(2 - 2*cos(x - y))",
    "sign(x) - sign(x^3) + 1/(x - 2)",
    "y*(sign(x) - sign(x^3)) + x^2",
)


def system_of(text: str) -> System:
    return resolve(decode(Source("jump.yaml", text)))


def is_conserved(V: str) -> bool:
    return find_conserved(system_of(f"{HEAD}T: (x'^2 + y'^2)/2\nV: {V}\n"), None).energy


@pytest.mark.sample(4)
@pytest.mark.parametrize("V", JUMPING)
def test_an_energy_that_jumps_is_not_conserved(V: str) -> None:
    """The motion passes the jump: T + V at the ends of a run tell it."""
    assert not is_conserved(V)
    found = motion(f"{HEAD}T: (x'^2 + y'^2)/2\nV: {V}\n{ENDS}")
    energies = [row[0] for row in found.rows]
    assert max(energies) - min(energies) > 0.5


def test_a_run_ends_where_an_energy_jumps_out_of_sight() -> None:
    """Beside the jump at x = 0 the exponential is more than any double, and the force no number: the run says where."""
    V = "1/(1 + exp(1/x))"
    assert not is_conserved(V)
    found = motion(f"{HEAD}T: (x'^2 + y'^2)/2\nV: {V}\n{ENDS}")
    assert found.ended == "failed" and "not finite" in found.reason
    assert found.outcome.t == pytest.approx(0.33908228, abs=1e-6)


def test_a_jump_behind_poles_that_cancel_is_found() -> None:
    """1/x and 1/sin(x) have a pole each, and only together a jump."""
    assert not is_conserved("(1 - abs(x))/sin(x) - 1/x")
    assert is_conserved("(1 - x)/sin(x) - 1/x")


@pytest.mark.parametrize("term", ["1/(x - {})", "1/sqrt((x - {})^2 + y^2)", "k*abs(x - {})^3/(x - {}/2)"])
def test_a_sum_of_fractions_takes_time_in_proportion_to_their_number(
    term: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    work: list[int] = []
    spend = _Lines._spend
    monkeypatch.setattr(_Lines, "_spend", lambda lines, more: (work.append(more), spend(lines, more))[1])

    def evaluated(count: int) -> int:
        work.clear()
        total = " + ".join(term.replace("{}", str(k)) for k in range(1, count + 1))
        system = system_of(f"{HEAD}T: (x'^2 + y'^2)/2\nV: {total}\n")
        moving = (*system.q, *system.v, system.t)
        assert not jumps(system.graph, system.energy, moving, {p: 0.5 for p in system.p}, lambda inner: False)
        return sum(work)

    assert evaluated(40) < 2.5 * evaluated(20)


@pytest.mark.parametrize("V", CONTINUOUS)
def test_an_energy_with_poles_and_kinks_is_conserved(V: str) -> None:
    assert is_conserved(V)


BOWL = """
nhc: 1
system: ball_in_bowl
coordinates: [phi, theta]
rotation: {B: {frame: space, velocities: [wx, wy, wz]}}
parameters: {m: 0.2, a: 0.05, L: 0.45, g: 9.81}
define: {nx: sin(theta)*cos(phi), ny: sin(theta)*sin(phi), nz: -cos(theta), X: L*nx, Y: L*ny, Z: L*nz}
T: m/2*(X'^2 + Y'^2 + Z'^2) + m*a^2/5*(wx^2 + wy^2 + wz^2)
V: m*g*Z
constraints: ["X' + a*(wy*nz - wz*ny) = 0", "Y' + a*(wz*nx - wx*nz) = 0"]
outputs: {K_z: 2*m*a^2/5*wz - a/L*m*(X*Y' - Y*X')}
scenes: {around: {initial: {theta: 0.8, wz: 4}, time: [0, 5]}}
"""


def test_what_varies_fast_near_a_quaternion_of_length_zero_does_not_jump() -> None:
    """From I w' = a n x F and m v' = F + m g, v = L n': I w_z - a m L (n x n')_z is constant, and the spin about the normal n."""
    _, lines, _ = described(BOWL)
    assert "constants of the motion: p*_v, E, L L_B_z - a p_phi " in lines
    assert "outputs that are constant: K_z" in lines


def test_what_is_a_constant_of_the_motion_breaks_nothing() -> None:
    system = system_of(f"{HEAD}T: (x'^2 + y'^2)/2\nV: k*x^2\noutputs: {{o: sign(y'), p: sign(x')*y'}}\n")
    assert find_conserved(system, None).outputs == ("o",)
    values = dict(zip(system.p, (0.5, 1e-3), strict=True))
    assert jumps(system.graph, system.outputs[0][1], system.v, values, lambda node: False)
    assert not jumps(system.graph, system.outputs[0][1], system.v, values, lambda node: True)


def test_momenta_that_jump_are_no_constants_and_no_states() -> None:
    """The velocities are continuous in every model, so these momenta are not."""
    text = (
        f"{HEAD}T: ((x' + sign(y)*y')^2 + 2*y'^2)/2\nV: x^2/2\n"
        "scenes: {a: {initial: {x: -1, y: -0.5, x': 1, y': 1}, time: [0, 2], need: [x, y]}}\n"
    )
    found = find_conserved(system_of(text), None)
    assert "p_y" not in " ".join(integral.text for integral in found.integrals)
    assert found.power == ("T jumps",)
    assert reduce_scene(Source("jump.yaml", text), Options(scene="a")).planner.reduction.state == ("x", "y", "x'", "y'")


BEARING = """nhc: 1
system: bearing
coordinates: [x, y, theta]
T: (x'^2 + y'^2 + theta'^2)/2
V: (x^2 + y^2)/2
holonomic: ["theta - {angle} = 0"]
scenes: {{a: {{initial: {{x: 1, y': 1}}, time: [0, {end}]}}}}
"""


def motion(text: str, **settings: object) -> Trajectory:
    formulation, method = str(settings.pop("formulation", "")), str(settings.get("method", "auto"))
    stay = bool(settings.pop("stay", False))
    job = open_scene(Source("jump.yaml", text), formulation=formulation, method=method, stay=stay)
    return run(job, Settings(points=21, **settings))  # type: ignore[arg-type]


@pytest.mark.sample(3)
@pytest.mark.parametrize("formulation", ["chaplygin", "multipliers"])
@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(("method", "step"), [("dop853", 0.0), ("radau5", 0.0), ("rk4", 0.01)])
def test_a_run_ends_where_a_holonomic_constraint_jumps(
    formulation: str, compiled: bool, method: str, step: float
) -> None:
    """theta = t, so atan2 jumps at t = pi: up to there the circle, beyond it nothing, where it was another motion."""
    text = BEARING.format(angle="atan2(y, x)", end=4)
    found = motion(text, formulation=formulation, method=method, step=step, compiled=compiled)
    assert found.ended == "failed"
    assert "a constraint jumps here" in found.reason
    assert found.outcome.t == pytest.approx(math.pi, abs=max(step, 1e-8))
    for t, row in zip(found.times, found.rows, strict=True):
        assert row == pytest.approx((math.cos(t), math.sin(t), t), abs=1e-6)
    assert len(found.times) == 16  # up to t = 3


@pytest.mark.parametrize("compiled", [False, True])
def test_steps_that_are_too_long_are_not_blamed_on_a_jump(compiled: bool) -> None:
    """The constraint is smooth: a table with a hole, and a string through it whose other end hangs."""
    text = """nhc: 1
system: string
coordinates: [x, y, z]
T: (x'^2 + y'^2)/2 + z'^2
V: 19.62*z
holonomic: ["sqrt(x^2 + y^2) - z = 2"]
scenes: {a: {initial: {x: 1, z: -1, y': 4.5}, time: [0, 5]}}
"""
    found = motion(text, method="rk4", step=1.0, compiled=compiled)
    assert found.ended == "failed"
    assert "jump" not in found.reason and "it is too long" in found.reason


@pytest.mark.sample(4)
@pytest.mark.parametrize("formulation", ["chaplygin", "multipliers"])
@pytest.mark.parametrize(("method", "step"), [("dop853", 0.0), ("rk4", 0.2)])
def test_a_run_goes_on_where_the_angle_has_no_cut(formulation: str, method: str, step: float) -> None:
    text = BEARING.format(angle="2*atan(y/(x + sqrt(x^2 + y^2)))", end=3)
    found = motion(text, formulation=formulation, method=method, step=step)
    assert found.ended == "done"
    assert found.rows[-1] == pytest.approx((math.cos(3), math.sin(3), 3), abs=1e-7 if not step else 1e-3)


def test_no_model_takes_an_angle_from_its_branch() -> None:
    text = BEARING.format(angle="atan2(y, x)", end=3)
    assert "theta" in reduce_scene(Source("jump.yaml", text), Options(scene="a")).planner.reduction.state


def test_the_warning_names_what_jumps() -> None:
    text = f"{HEAD}T: (x'^2 + y'^2)/2\nV: atan(1/x)\n"
    (warning,) = check(Source("jump.yaml", text)).diagnostics
    assert warning.code == "W0416"
    assert warning.message.startswith("`V` jumps")


STICKING = [(method, compiled) for method in ("auto", "dopri5", "radau5") for compiled in (False, True)]


@pytest.mark.sample(2)
@pytest.mark.parametrize(("method", "compiled"), STICKING)
def test_a_run_ends_where_dry_friction_sticks(method: str, compiled: bool) -> None:
    """x' = 1 - 0.3 t until it is at rest; beyond, the rates jump to and fro.  (Other runs go on: see test_sticking.)"""
    text = (
        "nhc: 1\nsystem: sliding\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\nforces: {x: -0.3*sign(x'), y: 1}\n"
        "scenes: {a: {initial: {x': 1}, time: [0, 5]}}\n"
    )
    found = motion(text, method=method, compiled=compiled, stay=True)
    assert found.ended == "failed" and "held where `x'` is zero" in found.reason and "sticks" in found.reason
    assert found.outcome.steps + found.outcome.rejected < 1000
    assert found.outcome.t == pytest.approx(10 / 3, abs=1e-8)
    assert found.rows[-1][0] == pytest.approx(found.times[-1] - 0.15 * found.times[-1] ** 2, rel=1e-7)


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize(
    ("force", "y", "end"),
    [
        ("1 - 1e6*max(x', 0)", -1.0, 3.0),  # a damper on one side, as stiff as it may be: x' = 1e-6 beyond
        ("-4*x - 0.5*sign(x')", 1.0, 2.0),  # driven through rest by its spring
        ("-9*x + 0.2*sign(x' - 1)", 1.0, 2.0),
        ("-x + 0.5*abs(x' - 1)", 0.0, 4.0),
    ],
)
def test_what_goes_through_a_corner_is_not_held(force: str, y: float, end: float, compiled: bool) -> None:
    text = (
        f'nhc: 1\nsystem: through\ncoordinates: [x]\nT: x\'^2/2\nforces: {{x: "{force}"}}\n'
        f"scenes: {{a: {{initial: {{x: {abs(y)}, x': {min(y, 0.0)}}}, time: [0, {end}]}}}}\n"
    )
    assert motion(text, compiled=compiled).ended == "done"


STEPS = """nhc: 1
system: steps
coordinates: [x, y, z]
parameters: {a: 1, b: 0.4}
T: (x'^2 + y'^2 + z'^2)/2
V: V_OF
constraints: [row: "ROW"]
"""


def described(text: str) -> tuple[dict[str, Any], str, list[Diagnostic]]:
    system = resolve(decode(Source("steps.yaml", text)))
    bag = Bag(system.spec.origin)
    facts = describe(system, formulate(system), bag)
    return facts.data, "\n".join(facts.lines), list(bag.diagnostics)


def test_a_row_that_jumps_is_integrable_at_each_side_only() -> None:
    """z + sign(x) y is constant at each side of x = 0, with two values that nothing ties: there is nothing to be held to."""
    _, lines, told = described(STEPS.replace("V_OF", "0").replace("ROW", "sign(x)*y' + z' = 0"))
    assert "at each side of where row jumps" in lines
    (found,) = [d for d in told if d.code == "W0410"]
    assert "it jumps" in found.message and "disguise" not in found.message
    assert not any("holonomic:" in text for text in found.help)
    assert [d.code for d in told].count("W0416") == 1
    _, lines, told = described(STEPS.replace("V_OF", "0").replace("ROW", "x*y' + y*x' + z' = 0"))
    assert "jump" not in lines and "in disguise" in told[0].message


def test_claims_about_jumps_are_for_values_that_are_given() -> None:
    """atan(b/(x^2 + a)) has a pole in its argument for negative a only; a scene may be the one that has it."""
    smooth = STEPS.replace("V_OF", "atan(b/(x^2 + a))").replace("ROW", "z' = y*x'")
    data, lines, told = described(smooth)
    assert data["energy"]["conserved"] and data["energy"]["torn_elsewhere"] == ["V"]
    assert "V may jump for others" in lines
    assert "W0416" not in [d.code for d in told]
    data, lines, told = described(smooth + "scenes: {deep: {time: [0, 1], parameters: {a: -0.5}}}\n")
    assert not data["energy"]["conserved"] and data["energy"]["power"] == ["V jumps"]
    assert "W0416" in [d.code for d in told]
    data, _, _ = described(STEPS.replace("V_OF", "a*atan(b*x)").replace("ROW", "z' = y*x'"))
    assert data["energy"]["conserved"] and data["energy"]["torn_elsewhere"] == []


@pytest.mark.parametrize(
    ("potential", "row", "ranges", "said"),
    [
        ("abs(x)", "z' = y*x'", {}, ["V"]),
        ("abs(x)", "z' = y*x'", {"x": "[0.5, 2]"}, []),
        ("abs(x)", "z' = y*x'", {"x": "[-0.5, 2]"}, ["V"]),
        ("abs(x)", "z' = y*x'", {"y": "[0.5, 2]"}, ["V"]),
        ("max(x, y)", "z' = y*x'", {"x": "[1, 2]", "y": "[3, 4]"}, []),
        ("max(x, y)", "z' = y*x'", {"x": "[1, 2]", "y": "[1.5, 4]"}, ["V"]),
        ("abs(a - 2)*x", "z' = y*x'", {}, []),  # a kink of a parameter is none of a motion's
        ("sign(x)", "z' = y*x'", {"x": "[-2, -1]"}, []),
        ("atan2(y, x)", "z' = y*x'", {}, ["V"]),
        ("atan2(y, x)", "z' = y*x'", {"x": "[0.1, 2]"}, []),  # y may vanish, but not on the branch cut
        ("atan2(y, x)", "z' = y*x'", {"x": "[-2, 2]"}, ["V"]),
        ("0", "sign(x)*y' + z' = 0", {"x": "[1, 2]"}, []),
        ("0", "sign(x)*y' + z' = 0", {"x": "[-1, 2]"}, ["row"]),
    ],
)
def test_warnings_keep_to_the_ranges_that_a_spec_expects(
    potential: str, row: str, ranges: dict[str, str], said: list[str]
) -> None:
    names = ", ".join(f"{q}: {{range: {ranges[q]}}}" if q in ranges else f"{q}: {{}}" for q in "xyz")
    text = STEPS.replace("[x, y, z]", f"{{{names}}}").replace("V_OF", potential).replace("ROW", row)
    _, _, told = described(text)
    assert [d.message.split("`")[1] for d in told if d.code == "W0416"] == said


SLIDE = """nhc: 1
system: slide
coordinates: [x, y]
parameters: {{k: 4, mu: 0.5}}
T: (x'^2 + y'^2)/2
V: k*x^2/2
forces: {{x: {force}}}
scenes: {{a: {{initial: {{x: 1, y': 1}}, time: [0, 5]}}}}
"""


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize(
    ("force", "method", "step", "changes"),
    [
        ("-mu*sign(x')", "rk4", 0.01, 3),
        ("-mu*sign(x')", "gauss6", 0.02, 3),
        ("-mu*sign(x')", "dop853", 0.0, 0),
        ("-mu*x'^2*sign(x')", "rk4", 0.01, 0),
        ("-mu*sign(y')", "rk4", 0.01, 0),
    ],
)
def test_fixed_steps_tell_what_they_go_over(force: str, method: str, step: float, changes: int, compiled: bool) -> None:
    """Friction by the sign of a velocity: sliding to and fro, and on one side only; drag whose sign is at rest where it changes."""
    job = open_scene(Source("slide.yaml", SLIDE.format(force=force)), method=method)
    notes = [note for note in run(job, Settings(method, 1e-6, step, 201, compiled)).notes if "forces jump" in note]
    assert len(notes) == (changes > 0)
    assert all(f"`x'`, which changes {changes} times" in note for note in notes)


PULSE = """nhc: 1
system: pulse
coordinates: [x]
T: x'^2/2
forces: {x: "max(0, 0.01 - abs(t - 5))*1e4"}
scenes: {go: {time: [0, 10]}}
"""


@pytest.mark.parametrize(("method", "seen"), [("dop853", True), ("scipy-dop853", False), ("scipy-bdf", False)])
def test_a_solver_from_elsewhere_does_not_know_of_pulses_and_that_is_said(method: str, seen: bool) -> None:
    found = run(open_scene(Source("pulse.yaml", PULSE), method=method), Settings(method, points=3))
    (told,) = found.notes or ("",)
    assert told.startswith("functions of the time jump, bend or pulse at t = 4.99, 5, 5.01,") is not seen
    assert found.rows[-1][0] == (pytest.approx(5.0, rel=1e-8) if seen else 0.0)


def test_where_nothing_pulses_nothing_is_said() -> None:
    spec = PULSE.replace("max(0, 0.01 - abs(t - 5))*1e4", "cos(t)")
    found = run(open_scene(Source("pulse.yaml", spec), method="scipy-dop853"), Settings("scipy-dop853", points=3))
    assert found.notes == ()
