"""What nhc chooses by itself for systems that outside users brought: skates in a row, wheels at the corners, legs of a platform."""

from __future__ import annotations

import itertools
import math
import random
from pathlib import Path

import pytest

from nhc.algebra.evaluate import evaluate
from nhc.algebra.minors import float_determinant
from nhc.diagnostics import Source
from nhc.mechanics.added_forms import describe_added
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.regular.regularity import choose_dependent, judge, relative_determinant, score
from nhc.mechanics.regular.trials import ordinary_points, sampled_rows, trial_points
from nhc.pipeline import Options, check, emit, model, program
from tests.support import compile_c, python_model


def skates(count: int) -> Source:
    """Skates that springs join, each with a knife edge of its own."""
    names = [f"{c}{k}" for k in range(count) for c in ("x", "y", "t")]
    kinetic = " + ".join(f"(x{k}'^2 + y{k}'^2 + t{k}'^2)/2" for k in range(count))
    springs = " + ".join(f"((x{k} - x{k + 1} + 1)^2 + (y{k} - y{k + 1})^2)/2" for k in range(count - 1))
    edges = "\n".join(f"  - \"-sin(t{k})*x{k}' + cos(t{k})*y{k}' = 0\"" for k in range(count))
    text = f"nhc: 1\nsystem: skates\ncoordinates: [{', '.join(names)}]\nT: {kinetic}\nV: {springs}\nconstraints:\n{edges}\n"
    return Source("skates.yaml", text)


@pytest.mark.parametrize("count", [4, 12])
def test_skates_have_each_a_velocity_along_its_edge(count: int) -> None:
    """They share no coordinate: each is completed by itself, and never singular."""
    made = model(skates(count))
    assert made.formulation.name == "euler-lagrange"
    (rhs,) = program(skates(count), Options(only=("rhs",))).functions
    assert rhs.adds + rhs.multiplications <= 40 * count
    if count == 4:
        assert all(a.accelerations and a.reactions for a in certify(made.system, points=1).agreements)


def test_wheels_that_stand_in_one_row_each_are_dependent() -> None:
    """A mecanum platform: the wheels' turns follow from the platform's motion, with nothing to solve."""
    rows = "\n".join(
        f"  - \"r*f{k}' = {a}*(x'*cos(th) + y'*sin(th)) + {b}*(-x'*sin(th) + y'*cos(th)) + {c}*l*th'\""
        for k, (a, b, c) in enumerate([(1, -1, -1), (1, 1, 1), (1, 1, -1), (1, -1, 1)], 1)
    )
    text = f"""nhc: 1
system: mecanum
coordinates: [x, y, th, f1, f2, f3, f4]
parameters: {{m: 10, J: 1, I: 0.01, r: 0.08, l: 0.5}}
T: m/2*(x'^2 + y'^2) + J/2*th'^2 + I/2*(f1'^2 + f2'^2 + f3'^2 + f4'^2)
constraints:
{rows}
"""
    made = model(Source("mecanum.yaml", text))
    assert [made.system.q_names[i] for i in choose_dependent(made.system).dependent] == ["f1", "f2", "f3", "f4"]
    assert choose_dependent(made.system).regular


def wheelchair(casters: int) -> Source:
    """Two driven wheels, and casters that trail behind their pivots: two constraints each."""
    across = [
        "th'*0.45*cos(s{k}) + b{k}*th'*sin(s{k}) + (-sin(th + s{k})*x' + cos(th + s{k})*y') - d*(th' + s{k}') = 0"
    ]
    along = ["cos(th + s{k})*x' + sin(th + s{k})*y' + th'*0.45*sin(s{k}) - b{k}*th'*cos(s{k}) - c*r{k}' = 0"]
    rows = ["-sin(th)*x' + cos(th)*y' = 0"]
    rows += [
        f"cos(th)*x' + sin(th)*y' {sign} w*th' - r*{wheel}' = 0" for sign, wheel in (("-", "left"), ("+", "right"))
    ]
    rows += [row.format(k=k) for k in range(casters) for row in (*across, *along)]
    listed = "\n".join(f'  - "{row}"' for row in rows)
    names = ["x", "y", "th", "left", "right", *(f"{c}{k}" for k in range(casters) for c in "sr")]
    places = ", ".join(f"b{k}: {0.3 - 0.4 * k}" for k in range(casters))
    turns = " + ".join(f"0.01*(th' + s{k}')^2 + 0.002*r{k}'^2" for k in range(casters))
    text = f"""nhc: 1
system: wheelchair
coordinates: [{", ".join(names)}]
parameters: {{m: 80, J: 6, I: 0.07, w: 0.3, r: 0.3, c: 0.08, d: 0.06, {places}}}
T: (m*(x'^2 + y'^2) + J*th'^2 + I*(left'^2 + right'^2) + {turns})/2
constraints:
{listed}
"""
    return Source("wheelchair.yaml", text)


@pytest.mark.parametrize("casters", [1, 2, 3])
def test_casters_follow_from_the_wheels_that_drive(casters: int) -> None:
    """Any two velocities could be free; those of the driven wheels leave the same determinant at all states."""
    made = model(wheelchair(casters))
    system, choice = made.system, choose_dependent(made.system)
    g, determinant = system.graph, choice.determinant
    assert system.l == 3 + 2 * casters and choice.regular and made.formulation.name == "voronec"
    assert {system.q_names[i] for i in range(system.n) if i not in choice.dependent} == {"left", "right"}
    assert determinant is not None and not g.deps[determinant] & g.mask(system.q)
    assert certify(system, points=1).holds


def test_the_determinant_of_many_rows_is_a_product_with_its_sign() -> None:
    """For every choice of dependent velocities of seven rows, against elimination at one state."""
    system, found = model(wheelchair(2)).system, 0
    (point, *_) = trial_points(system)
    (rows, *_) = sampled_rows(system, system.constraints, [point])
    for columns in itertools.combinations(range(system.n), system.l):
        choice = judge(system, columns)
        if choice.determinant is not None:
            expected = float_determinant([[row[j] for j in columns] for row in rows])
            assert float(evaluate(system.graph, [choice.determinant], point)[0]) == pytest.approx(expected, abs=1e-12)
            found += 1
    assert found > 10


def test_many_subsets_are_judged_at_the_starts_first() -> None:
    """A platform on six legs that stands level has thousands of subsets: the chosen velocities follow at its start."""
    corners = [(math.cos(a), math.sin(a)) for a in (0.0, 0.6, 2.1, 2.7, 4.2, 4.8)]
    feet = [(1.6 * math.cos(a), 1.6 * math.sin(a)) for a in (-0.2, 0.8, 1.9, 2.9, 4.0, 5.0)]
    lines, start = [], []
    for k, ((a, b), (c, d)) in enumerate(zip(corners, feet, strict=True)):
        across = f"(x + R_x1*{a:.3f} + R_x2*{b:.3f} - {c:.3f})^2 + (y + R_y1*{a:.3f} + R_y2*{b:.3f} - {d:.3f})^2"
        lines.append(f"  - leg{k}: {across} + (z + R_z1*{a:.3f} + R_z2*{b:.3f})^2 = l{k}^2")
        start.append(f"l{k}: sqrt(({a:.3f} - {c:.3f})^2 + ({b:.3f} - {d:.3f})^2 + 1)")
    legs = [f"l{k}" for k in range(6)]
    text = f"""nhc: 1
system: platform
coordinates: [x, y, z, {", ".join(legs)}]
rotation: {{R: {{velocities: [p, q, r]}}}}
T: (x'^2 + y'^2 + z'^2 + p^2 + q^2 + 2*r^2 + {" + ".join(f"{leg}'^2/9" for leg in legs)})/2
holonomic:
{chr(10).join(lines)}
scenes: {{level: {{time: [0, 1], initial: {{z: 1, {", ".join(start)}}}}}}}
"""
    system = model(Source("platform.yaml", text)).system
    assert math.comb(system.n, system.l) > 250
    dependent = choose_dependent(system).dependent
    (at_start,) = sampled_rows(system, system.constraints, ordinary_points(system)[:1])
    assert relative_determinant(at_start, dependent) > 0.2


def test_loads_that_only_a_sweep_reads_are_not_repeated(tmp_path: Path) -> None:
    """A Jacobian with one straight part and sweeps: -Wall -Werror finds nothing unused."""
    text = skates(8).text.replace("constraints:", "quasi_velocities: {QUASI}\nconstraints:")
    quasi = ", ".join(f"v{k}: x{k}'*cos(t{k}) + y{k}'*sin(t{k}), w{k}: t{k}'" for k in range(8))
    files = emit(Source("skates.yaml", text.replace("{QUASI}", f"{{{quasi}}}")), "c")
    compile_c(files, tmp_path, "skates", ("-O1", "-Wall", "-Wextra", "-Wpedantic", "-Werror"))


def test_many_coordinates_are_completed_at_one_stroke(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first velocities of each pool do; a rank for each of them took half a minute for 200 coordinates."""
    from nhc.mechanics.choosing import adapt

    asked: list[int] = []
    rank = adapt.rank
    monkeypatch.setattr(adapt, "rank", lambda graph, rows: asked.append(len(rows)) or rank(graph, rows))
    names = [f"x{k}" for k in range(40)]
    kinetic = " + ".join(f"{name}'^2" for name in names)
    text = f"nhc: 1\nsystem: many\ncoordinates: [{', '.join(names)}]\nT: {kinetic}\n"
    made = check(Source("many.yaml", text))
    assert any("euler-lagrange" in fact for fact in made.facts)
    assert asked and len(asked) < 8


def equal_rows(pairs: int) -> Source:
    """Pairs of rows that are the same for the values of a and b, and independent for others."""
    names = [f"{letter}{k}" for k in range(pairs) for letter in "xyz"]
    rows = [f"  - z{k}' = {p}*y{k}*x{k}'" for k in range(pairs) for p in "ab"]
    energy = " + ".join(f"{name}'^2" for name in names)
    head = f"nhc: 1\nsystem: test\ncoordinates: [{', '.join(names)}]\nparameters: {{a: 0.5, b: 0.5}}\n"
    return Source("test.yaml", f"{head}T: ({energy})/2\nconstraints:\n" + "\n".join(rows) + "\n")


@pytest.mark.parametrize("pairs", [1, 2, 5])
def test_rows_that_the_given_values_make_equal_are_solved_for_others(pairs: int) -> None:
    """No sample with a = b has a regular block: the choice fell on velocities whose determinant is zero everywhere."""
    made = model(equal_rows(pairs), Options("voronec"))
    chosen = {made.system.q_names[i] for i in choose_dependent(made.system).dependent}
    assert chosen == {f"{letter}{k}" for k in range(pairs) for letter in "xz"}
    assert certify(made.system).holds


@pytest.mark.parametrize("enough", [1, 8, 20])
def test_what_is_left_out_of_a_score_comes_behind_what_is_wanted(enough: int) -> None:
    """Entries of -1, 0 and 1 make many candidates singular at the starts; the best of all are those that stay."""
    draw = random.Random(enough)
    candidates = [list(columns) for columns in itertools.combinations(range(6), 3)]
    for _ in range(40):
        starts = [[[draw.choice((-1.0, 0.0, 0.0, 1.0)) for _ in range(6)] for _ in range(3)] for _ in range(2)]
        samples = [[[draw.uniform(-1, 1) for _ in range(6)] for _ in range(3)] for _ in range(5)]
        every = score(candidates, samples, starts, len(candidates))
        assert len(every) == len(candidates) and score(candidates, samples, starts, enough)[:enough] == every[:enough]
    assert score([], samples, starts, enough) == []


BOARD = """nhc: 1
system: skateboard
coordinates: [x, y, th, lean]
parameters: {m: 60, J: 1, I: 0.5, a: 0.4, b: 0.3, h: 0.9, p: 0.8, k: 900}
define: {X: x + h*sin(lean)*sin(th), Y: y - h*sin(lean)*cos(th), Z: h*cos(lean), f: FRONT, r: -REAR}
T: m/2*(X'^2 + Y'^2 + Z'^2) + J/2*th'^2 + I/2*lean'^2
V: m*9.81*Z + k/2*lean^2
constraints:
  - -sin(th + f)*x' + cos(th + f)*y' + a*cos(f)*th' = 0
  - -sin(th + r)*x' + cos(th + r)*y' - b*cos(r)*th' = 0
"""


@pytest.mark.parametrize(("steering", "along"), [("atan(p*sin(lean))", True), ("p*lean", False)])
def test_axles_that_cannot_stand_across_are_completed_by_the_velocity_along_the_body(
    steering: str, along: bool
) -> None:
    """The row of minors is left where an axle could turn by a quarter, and both wheels would roll sideways."""
    source = Source("skateboard.yaml", BOARD.replace("FRONT", steering).replace("REAR", steering))
    made = model(source)
    assert made.formulation.frame is not None
    form = made.formulation.frame.forms[made.system.l]
    g, (x, y, th, _) = made.system.graph, form.coefficients
    heading = made.system.q[2]
    assert ((x, y, th) == (g.function("cos", heading), g.function("sin", heading), g.zero)) == along
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert (rhs.adds + rhs.multiplications < 110) == along
    assert all(a.accelerations and a.reactions for a in certify(made.system, points=1).agreements)


KEEL = """nhc: 1
system: keel
coordinates: [x, y, th]
parameters: {m: 2, I: 0.4, a: 0.3, e: 0.5}
define: {al: th + e*sin(2*t)}
T: m/2*(x'^2 + y'^2) + I/2*th'^2
constraints:
  - keel: -sin(al)*x' + cos(al)*y' - a*th' = 0
quasi_velocities: {v: cos(al)*x' + sin(al)*y'}
"""


@pytest.mark.parametrize("rudder", ["th + e*sin(2*t)", "th"])
def test_a_speed_is_completed_by_a_dependent_velocity_where_the_free_ones_are_singular(rudder: str) -> None:
    """The keel is solved for the yaw rate; along it the rates of both coordinates fail, and the yaw rate never does."""
    source = Source("keel.yaml", KEEL.replace("th + e*sin(2*t)", rudder))
    made = model(source)
    assert [made.system.q_names[i] for i in choose_dependent(made.system).dependent] == ["th"]
    assert made.formulation.added == ("th'",)
    assert not check(source).diagnostics
    assert all(a.accelerations and a.reactions for a in certify(made.system, points=1).agreements)


EDGE = """nhc: 1
system: edge
coordinates: [x, y, th]
parameters: {m: 2, I: 0.4, a: 0.3}
T: m/2*(x'^2 + y'^2) + I/2*th'^2
constraints:
  - -sin(th)*x' + cos(th)*y' - a*th' = 0
scenes: {s: {initial: {th: 0.3}, time: [0, 1]}}
"""


@pytest.mark.parametrize(
    ("coordinates", "given", "added"),
    [
        ("x, y, th", "v: cos(th)*x' + sin(th)*y', w: th'", "y'*cos(th) - x'*sin(th)"),
        ("x, y, th", "s: y'*cos(th) - x'*sin(th)", "-x'*cos(th) - y'*sin(th)"),  # to the left of that, it is backwards
        ("x, y, th, a", "u: cos(th + a)*x' + sin(th + a)*y', w: th' + a'", "y'*cos(th + a) - x'*sin(th + a)"),
    ],
)
def test_a_velocity_along_a_free_body_is_completed_by_the_one_across(coordinates: str, given: str, added: str) -> None:
    kinetic = " + ".join(f"{c}'^2" for c in coordinates.split(", "))
    text = f"nhc: 1\nsystem: body\ncoordinates: [{coordinates}]\nT: {kinetic}\nquasi_velocities: {{{given}}}\nV: x*cos(th)\n"
    found = check(Source("body.yaml", text))
    assert [diagnostic.code for diagnostic in found.diagnostics] == []
    made = model(Source("body.yaml", text))
    assert made.formulation.name == "euler-lagrange"
    assert next(iter(describe_added(made.system, made.formulation.frame).values())) == added
    assert all(a.accelerations for a in certify(made.system, points=1).agreements)


@pytest.mark.parametrize("distance", ["0.3", "1e-7"])
def test_along_a_knife_edge_beside_the_point_of_the_coordinates(distance: str) -> None:
    """In v and th' the mass matrix is constant; with x' and y' kept it has I/a^2."""
    source = Source("edge.yaml", EDGE.replace("a: 0.3", f"a: {distance}"))
    made = model(source)
    assert made.formulation.frame is not None
    assert [form.name for form in made.formulation.frame.forms[made.system.l :]] == ["v", "th"]
    assert all(a.accelerations and a.reactions for a in certify(made.system, points=1).agreements)
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.adds + rhs.multiplications + rhs.divisions < 16


@pytest.mark.parametrize(("distance", "name"), [("0.3", "voronec"), ("1e-3", "euler-lagrange")])
def test_a_velocity_over_a_small_parameter_is_not_solved_for(distance: str, name: str) -> None:
    """The row has no heading of one length: by the energy that is left of x' and y', of which digits would be lost."""
    made = model(Source("edge.yaml", EDGE.replace("a: 0.3", f"a: {distance}").replace("-sin(th)*x'", "-2*sin(th)*x'")))
    assert made.formulation.name == name
    assert all(a.accelerations and a.reactions for a in certify(made.system, points=1).agreements)


PLATFORM = """nhc: 1
system: platform
coordinates: [x, y, a, l1, l2, l3]
parameters: {m: 2, J: 0.3, k: 0.5, g: 9.81}
bodies:
  plate: {at: [x, y], turns: [z: a], mass: m, inertia: J}
points: {A: {parent: plate, at: [-0.3, -0.2]}, B: {parent: plate, at: [0.3, -0.2]}, C: {parent: plate, at: [0, 0.4]}}
T: k/2*(l1'^2 + l2'^2 + l3'^2)
gravity: [0, -g]
dependent: [l1, l2, l3]
holonomic:
  - A_x^2 + A_y^2 = l1^2
  - (B_x - 2)^2 + B_y^2 = l2^2
  - (C_x - 1)^2 + (C_y - 2)^2 = l3^2
scenes: {s: {initial: {x: 1, y: 0.8, a: 0.1, l1: {near: 1}, l2: {near: 1}, l3: {near: 1}}, time: [0, 0.5]}}
"""


def test_the_dependent_velocities_of_a_spec_are_taken_where_they_stay_regular() -> None:
    """Lengths may vanish somewhere, but not at the positions that a motion goes through."""
    formulation = model(Source("platform.yaml", PLATFORM)).formulation
    assert formulation.name == "voronec"
    assert "of the spec" in formulation.reason


TROUGH = """nhc: 1
system: trough
coordinates: [x, y, th, u]
parameters: {m: 1, J: 0.08, a: 0.3, b: 0.2, rho: 1.5, A: 0.1, w: 2, g: 9.81}
define:
  X0: A*sin(w*t)
  kx: x + cos(th)*a*cos(u) - sin(th)*b*sin(u)
  ky: y + sin(th)*a*cos(u) + cos(th)*b*sin(u)
  nx: cos(th)*b*cos(u) - sin(th)*a*sin(u)
  ny: sin(th)*b*cos(u) + cos(th)*a*sin(u)
T: m/2*(x'^2 + y'^2) + J/2*th'^2
V: m*g*y
constraints:
  - roll: -ny*(x' - (ky - y)*th' - X0') + nx*(y' + (kx - x)*th') = 0
holonomic:
  - touch: (kx - X0)^2 + ky^2 = rho^2
  - tangent: (kx - X0)*ny - ky*nx = 0
scenes:
  go: {initial: {u: {near: -1.2}, th: 0.1, x: {near: 0.3}, y: {near: -1.3}}, time: [0, 3]}
"""
"""An elliptic cylinder in a trough that swings, the angle to its contact among the coordinates."""


def test_expanded_minors_of_long_rows_are_no_velocity() -> None:
    source = Source("trough.yaml", TROUGH)
    chosen = model(source, Options()).formulation
    assert chosen.name == "multipliers" and "many times as long" in chosen.reason
    short, long = (
        sum((f.adds, f.multiplications, f.divisions))
        for name in ("auto", "euler-lagrange")
        for f in program(source, Options(formulation=name, only=("rhs",))).functions
    )
    assert 2 * short < long


WAGON = """nhc: 1
system: wagon
coordinates: [x, y, heading, u, w]
rotation: {B: {velocities: [p, q, r]}}
parameters: {M: 5, I: 0.8, m: 0.6, a: 0.1, J: 0.0024, c: 0.3}
bodies:
  wagon: {at: [x, y, 0], turns: [z: heading], mass: M, centre: [c, 0, 0], inertia: I}
  ball: {parent: wagon, at: [u, w, a], mass: m}
  shell: {at: [ball_x, ball_y, ball_z], rotation: B, inertia: J}
points:
  axle: {parent: wagon, at: [0, 0, 0]}
  top: {parent: wagon, at: [u, w, 0]}
  under: {parent: wagon, of: shell, at: [u, w, 0]}
constraints:
  - EDGE
  - roll_1: top_v1 = under_v1
  - roll_2: top_v2 = under_v2
scenes:
  go: {initial: {u: 0.2, r: 0.5}, time: [0, 3]}
"""
"""A ball rolls on a wagon that cannot slip sideways: beside the ball's angular velocity two more velocities are free."""


@pytest.mark.parametrize(
    ("edge", "added"), [("edge: axle_v2 = 0", ["v", "heading"]), ("edge: x' = u*heading'", ["y", "heading"])]
)
def test_beside_angular_velocities_the_velocity_along_a_knife_edge(edge: str, added: list[str]) -> None:
    """x' would be singular where the wagon stands across; what is regular anyway stays as it is."""
    source = Source("wagon.yaml", WAGON.replace("EDGE", edge))
    found = model(source, Options())
    assert found.formulation.frame is not None
    assert [form.name for form in found.formulation.frame.forms[found.system.l :]] == ["p", "q", "r", *added]
    assert not [one for one in check(source, explain=False).diagnostics if one.code == "W0408"]


TUG = """nhc: 1
system: tug
coordinates: [x, y, AHEAD, swing, stretch]
parameters: {m: 9, I: 1.1, M: 4, K: 0.5, d: 0.2, e: 0.4, l: 0.8, k: 90, c: 5, F: 3}
define:
  theta: HEADING
  hitch: SWING
bodies:
  tug: {at: [x, y], turns: [z: theta], mass: m, inertia: I}
  bar: {parent: tug, at: [-e, 0], turns: [z: hitch]}
  cart: {parent: bar, at: [-l - stretch, 0], mass: M, inertia: K}
points:
  keel: {parent: tug, at: [d, 0]}
  axle: {parent: cart, at: [0, 0]}
V: k/2*stretch^2
forces: {keel_v1: F, stretch: -c*stretch'}
constraints: [keel_v2 = 0, axle_v2 = 0]
scenes:
  go: {initial: {swing: 0.3}, time: [0, 3]}
"""
"""The lines of its two axles may coincide at some angle of the hitch, so no completion is regular everywhere."""


@pytest.mark.parametrize(
    ("heading", "swing", "free"),
    [
        ("course", "swing", ["v", "course", "stretch"]),
        ("course + 0.3", "swing", ["v", "course", "stretch"]),
        ("course", "swing - course", ["v", "course", "stretch"]),  # both angles turn with all
        ("course + x", "swing", ["course", "swing", "stretch"]),  # not the same on its axes
    ],
)
def test_what_turns_in_the_plane_is_led_along_its_axis(heading: str, swing: str, free: list[str]) -> None:
    """x' would be singular where it stands across, at two headings of every turn."""
    text = TUG.replace("AHEAD", "course").replace("HEADING", heading).replace("SWING", swing)
    found = model(Source("tug.yaml", text))
    assert found.formulation.frame is not None
    assert [form.name for form in found.formulation.frame.forms[found.system.l :]] == free


@pytest.mark.parametrize("swing", ["swing", "swing - course"])
@pytest.mark.parametrize("across", [0.0, math.pi / 2, math.pi, -math.pi / 2, 2.0])
def test_a_tug_turns_all_the_way(across: float, swing: str) -> None:
    """The accelerations are those of the multiplier equations at every heading, also where it stands across."""
    source = Source("tug.yaml", TUG.replace("AHEAD", "course").replace("HEADING", "course").replace("SWING", swing))
    led, whole = (
        python_model(next(iter(emit(source, "python", options=Options(formulation=name)).values())), f"tug_{name}")
        for name in ("auto", "multipliers")
    )
    place = [0.3, -0.2, across, 0.4 if swing == "swing" else across + 0.4, 0.05]
    speeds = led.velocities(0.0, [*place, 0.7, -0.3, 0.2])
    assert speeds[0] ** 2 + speeds[1] ** 2 > 0.4
    own = led.accelerations(0.0, led.state(0.0, place, speeds))
    assert own == pytest.approx(whole.accelerations(0.0, whole.state(0.0, place, speeds)), rel=1e-12, abs=1e-12)


OMNI = """nhc: 1
system: omni
coordinates: [x, y, th, p1, p2, p3]
parameters: {m: 10, I: 0.7, J: 0.02, L: 0.3, R: 0.1, c: 0.05}
T: m/2*((x' - c*sin(th)*th')^2 + (y' + c*cos(th)*th')^2) + I/2*th'^2 + J/2*(p1'^2 + p2'^2 + p3'^2)
forces: {p1: 1, p2: sin(t), p3: -0.1*p3'}
constraints:
  - R*p1' = -sin(th)*x' + cos(th)*y' + L*th'
  - R*p2' = -sin(th + 2*pi/3)*x' + cos(th + 2*pi/3)*y' + L*th'
  - R*p3' = -sin(th + 4*pi/3)*x' + cos(th + 4*pi/3)*y' + L*th'
"""
"""A robot on three wheels that roll in all directions."""
CART = """  - -sin(ps)*(x' + 0.4*sin(th)*th') + cos(ps)*(y' - 0.4*cos(th)*th') = 0.6*ps'
"""


@pytest.mark.parametrize(
    ("old", "new", "free"),
    [
        ("c: 0.05", "c: 0.05", ["v", "v2", "th'"]),
        ("c: 0.05", "c: 0", ["x'", "y'", "th'"]),  # T is the same at all headings by x' and y', too
        ("c*sin(th)", "c*sin(th + x)", ["x'", "y'", "th'"]),  # not the same on its axes
        ("p3]", "p3, ps]", ["v", "v2", "th'"]),  # with a cart, whose angle counts from the same direction
        ("L: 0.3", "v: 0.3, L: 0.3", ["v2", "v3", "th'"]),
    ],
)
def test_a_robot_is_led_on_its_axes_where_its_energy_is_the_same_there(old: str, new: str, free: list[str]) -> None:
    text = OMNI.replace(old, new)
    if "ps]" in new:
        text = text.replace("p3'^2)\nforces", "p3'^2) + ps'^2/5\nforces") + CART
    source = Source("omni.yaml", text)
    found = model(source)
    assert found.formulation.frame is not None
    assert [
        f"{form.name}'" * (form.name in found.system.q_names) or form.name
        for form in found.formulation.frame.forms[found.system.l :]
    ] == free
    own, whole = (
        python_model(next(iter(emit(source, "python", options=Options(formulation=name)).values())), f"omni_{name}")
        for name in ("auto", "multipliers")
    )
    draw = random.Random(new)
    for _ in range(5):
        q = [draw.uniform(-3, 3) for _ in own.COORDINATES]
        qdot = own.velocities(0.3, [*q, *(draw.uniform(-1, 1) for _ in free)])
        one, two = (each.accelerations(0.3, each.state(0.3, q, qdot)) for each in (own, whole))
        assert one == pytest.approx(two, rel=1e-11, abs=1e-11)


CAR = """nhc: 1
system: car
coordinates: {x: {}, y: {}, th: {}, d: {RANGE}}
parameters: {m: 2, I: 1, a: 0.5, b: 1.2, J: 0.05}
define: {X: x + a*cos(th), Y: y + a*sin(th)}
T: m/2*(X'^2 + Y'^2) + I/2*th'^2 + J/2*(th' + d')^2
constraints:
  - rear: -sin(th)*x' + cos(th)*y' = 0
  - front: -sin(th + d)*x' + cos(th + d)*y' + b*cos(d)*th' = 0
scenes:
  s: {initial: {d: START, x': 1}, time: [0, 2]}
"""


@pytest.mark.parametrize("bounds", ["", "range: [-0.6, 0.6]", "range: [-0.1, 1.4]"])
@pytest.mark.parametrize("start", ["0", "0.01", "0.2"])
@pytest.mark.parametrize("formulation", ["auto", "euler-lagrange"])
def test_a_car_is_led_by_its_speed_wherever_its_wheel_may_stand(bounds: str, start: str, formulation: str) -> None:
    """Beyond its range a wheel across says nothing, and th', singular straight ahead, is no choice for a start in a bend."""
    found = model(
        Source("car.yaml", CAR.replace("RANGE", bounds).replace("START", start)), Options(formulation=formulation)
    )
    assert found.formulation.name == "euler-lagrange" and found.formulation.added == ("v", "d'")


@pytest.mark.parametrize("bend", ["0", "0.1"])
def test_a_start_in_a_bend_does_not_hide_what_is_singular_straight_ahead(bend: str) -> None:
    """Two steered cars: rates of angles are seldom singular at random states, but they are at the ordinary one."""
    text = CAR.replace("d: {RANGE}", "d: {}, ps: {}, e: {}").replace("START", f"0, ps: {bend}, e: {bend}")
    text = text.replace("J/2*(th' + d')^2", "J/2*(th' + d')^2 + (ps'^2 + (ps' + e')^2)/2 + (P'^2 + Q'^2)/2")
    text = text.replace(
        "Y: y + a*sin(th)}", "Y: y + a*sin(th), P: x - a*cos(th) - cos(ps), Q: y - a*sin(th) - sin(ps)}"
    )
    text = text.replace("scenes:", "  - hind: -sin(ps + e)*P' + cos(ps + e)*Q' = 0\nscenes:")
    found = model(Source("train.yaml", text))
    assert found.formulation.added == ("v", "d'", "e'")


SADDLE = """nhc: 1
system: saddle
coordinates: [x, y, z, th]
parameters: {m: 3, I: 0.2, a: 0.3, g: 9.81, L: 4, w: 5}
T: m/2*(x'^2 + y'^2 + z'^2) + I/2*th'^2
V: m*g*z
holonomic:
  - floor: z = a*x*y
  - rope: (x - w)^2 + y^2 + z^2 = (L - t/5)^2
constraints:
  - blade: sin(th)*x' - cos(th)*y' = 0
forces: {th: 0.3 - th'/2}
scenes:
  pull: {initial: {x: {near: 1.2}, y: 0.3, z: {near: 0.1}, th: 0.2}, time: [0, 3]}
"""
"""A skate that a rope pulls: its blade and the rope may stand across each other, and nothing determines its motion there."""


def test_where_the_constraints_themselves_lose_rank_no_coframe_is_given_up() -> None:
    found = model(Source("saddle.yaml", SADDLE))
    assert found.formulation.name == "euler-lagrange" and found.formulation.added == ("th'",)
    assert certify(found.system).holds
