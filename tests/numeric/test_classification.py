"""What kind of constraint is this, what is conserved: answers known beforehand, and claims tested along other ways."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import product

import numpy as np
import pytest
import sympy

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import rank
from nhc.algebra.exact.relations import find_relations, rational, without
from nhc.algebra.exact.residues import PRIMES
from nhc.algebra.graph import Graph
from nhc.diagnostics import Bag, Source, SpecError
from nhc.language import decode, read
from nhc.mechanics.choosing.choose import dependent_of, formulate
from nhc.mechanics.frame import coordinate_frame, total_derivative
from nhc.mechanics.properties import sampling
from nhc.mechanics.properties.candidates import Candidate, combine, spell
from nhc.mechanics.properties.conserved import find_conserved, generalized_energy, power
from nhc.mechanics.properties.facts import Facts, describe
from nhc.mechanics.properties.integrability import classify
from nhc.mechanics.properties.integrals import find_position_integrals
from nhc.mechanics.properties.sampling import Sampler
from nhc.mechanics.properties.singular import find_rank_loss
from nhc.mechanics.properties.timed import timed_parts
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.pipeline import check
from tests.support import GALLERY, spec_path

# growth vector of ker A and number of holonomic constraints in disguise
GROWTH = {
    "cartesian_pendulum": ((1,), 1),
    "chaplygin_sleigh": ((2, 3), 0),
    "nh_particle": ((2, 3), 0),
    "contact_oscillator": ((2, 3), 0),
    "cvt": ((2, 3), 0),
    "suslov": ((2, 3), 0),
    "veselova": ((2, 3), 0),
    "chaotic": ((6, 7), 0),
    "vertical_disk": ((2, 3, 4), 0),
    "roller_racer": ((2, 3, 4), 0),
    "rolling_disk": ((3, 4, 5), 0),
    "chaplygin_ball": ((3, 5), 0),
    "snakeboard": ((4, 6), 0),
    "n_trailer3": ((2, 3, 4, 5, 6), 0),
    "diff_drive": ((2, 3, 4), 1),
    "rattleback": ((3, 5), 1),
    "disk_chain2": ((4, 6, 8), 0),
    "bicycle": ((3, 5, 7), 2),
}

INTEGRALS = {
    "cartesian_pendulum": ["rod"],
    "holonomic_pendulum": ["rod"],
    "diff_drive": ["roll_R roll_L"],
    "rattleback": ["roll_z"],
    "bicycle": ["rear_z", "front_z"],
}


def build(text: str) -> System:
    return resolve(decode(Source("test.yaml", text)))


def constrained(coordinates: str, *rows: str, parameters: str = "{}", T: str = "") -> System:
    energy = T or "(" + " + ".join(f"{name.strip()}'^2" for name in coordinates.split(",")) + ")/2"
    lines = "\n".join(f"  - {row}" for row in rows)
    text = f"nhc: 1\nsystem: test\ncoordinates: [{coordinates}]\n"
    if parameters != "{}":
        text += f"parameters: {parameters}\n"
    return build(f"{text}T: {energy}\nconstraints:\n{lines}\n")


@cache
def system_of(name: str) -> System:
    return resolve(decode(read(str(spec_path(name)))))


@cache
def facts_of(name: str) -> Facts:
    system = system_of(name)
    return describe(system, formulate(system), Bag(system.spec.origin))


def frame_of(system: System):  # type: ignore[no-untyped-def]
    return coordinate_frame(system, dependent_of(system).dependent) if system.l else None


# --- integrability ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", sorted(GROWTH))
def test_growth_vectors(name: str) -> None:
    found = classify(system_of(name))
    assert (found.growth, found.hidden) == GROWTH[name]


def test_one_letter_decides() -> None:
    """x' + y.z' = 0 is nonholonomic, x' + z.z' = 0 is not."""
    good = constrained("x, y, z, w, u", "c: x' + y*z' + w*u' = 0")
    bad = constrained("x, y, z, w, u", "c: x' + z*z' + u*u' = 0")
    assert (classify(good).growth, classify(good).hidden) == ((4, 5), 0)
    assert (classify(bad).growth, classify(bad).hidden, classify(bad).closed) == ((4,), 1, ("c",))
    (integral,) = find_position_integrals(bad, frame_of(bad), 1, ("c",))
    assert integral.text in ("u^2 + 2*x + z^2", "2*x + z^2 + u^2", "z^2 + 2*x + u^2", "u^2 + z^2 + 2*x")


@pytest.mark.parametrize("name", sorted(GROWTH))
def test_what_is_hidden_is_known_without_the_growth_vector(name: str) -> None:
    found, whole = classify(system_of(name), levels=False), classify(system_of(name))
    assert found.growth in ((), whole.growth)
    assert replace(found, growth=whole.growth) == whole


@pytest.mark.parametrize("roots", [19, 60])
def test_many_roots_are_no_reason_to_fail(roots: int) -> None:
    """Their radicands are all squares at one point in 2**roots: nothing is decided there, and thousands are not drawn."""
    terms = " + ".join(f"sqrt(1 + (x - {k})^2)" for k in range(roots))
    text = f"nhc: 1\nsystem: rooted\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nconstraints: [\"z' = ({terms})*y'\"]\n"
    report = check(Source("rooted.yaml", text))
    assert not report.diagnostics
    assert "integrability: not decided (too many nested roots for the exact test)" in report.facts
    assert not check(Source("rooted.yaml", text), explain=False).diagnostics


@pytest.mark.parametrize("name", sorted(INTEGRALS))
def test_integrals_of_the_gallery_imply_the_constraints(name: str) -> None:
    """df is a combination of the constraint forms that are named, and of no others."""
    system = system_of(name)
    g, kinds = system.graph, classify(system)
    found = find_position_integrals(system, frame_of(system), kinds.hidden, kinds.closed)
    assert [" ".join(i.names) for i in found] == INTEGRALS[name]
    for integral in found:
        slope = gradient(g, integral.node, (*system.q, system.t))
        own = [[*f.coefficients, f.constant] for f in system.constraints if f.name in integral.names]
        assert rank(g, [*own, slope]) == len(own)
        assert rank(g, [slope]) == 1


@pytest.mark.parametrize(
    ("coordinates", "row", "expected"),
    [
        ("x, y", "c: y*x' + x*y' = 0", "x*y"),
        ("x, y", "c: x*y' - y*x' = 0", "y/x"),
        ("x, y", "c: cos(x)*y*x' + sin(x)*y' = 0", "y*sin(x)"),
        ("x, y", "c: x' = 2*t", "x - t^2"),
        ("x, y", "c: x' = cos(t)", "x - sin(t)"),
        ("x, y", "c: x' = 3", "x - 3*t"),
        ("x, y", "c: x*x' + y' = 0", "x^2 + 2*y"),
        ("x, y, z", "c: x*z*y' + y*z*x' + x*y*z' = 0", "log(abs(x)) + log(abs(y)) + log(abs(z))"),
        ("x, y, z", "c: (x^2 + y^2)*z' = 3*(x*y' - y*x')", "z - 3*atan2(y, x)"),
        ("x, y, z", "c: (x^2 + y^2)*z' = x*x' + y*y'", "z - log(x^2 + y^2)/2"),
        ("x, y, z", "c: x*x' + y*y' = x*y' - y*x'", "log(x^2 + y^2)/2 - atan2(y, x)"),
    ],
)
def test_elementary_integrals(coordinates: str, row: str, expected: str) -> None:
    system = constrained(coordinates, row)
    g = system.graph
    kinds = classify(system)
    found = find_position_integrals(system, frame_of(system), kinds.hidden, kinds.closed)
    assert kinds.hidden == len(found) == 1, (kinds, expected)
    slope = gradient(g, found[0].node, (*system.q, system.t))
    (form,) = system.constraints
    assert rank(g, [slope, [*form.coefficients, form.constant]]) == 1
    assert rank(g, [slope]) == 1


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("rows", "integral"),
    [
        (("cos(b)*u' + sin(b)*z' + R*b' = 0", "cos(b)*z' = sin(b)*u'"), "z - R*cos(b)"),  # height of a leaning disk
        (("u' = R*z'", "b' = R*(1 - exp(-t))"), "b - R*t - R*exp(-t)"),  # a motor that comes up to speed
        (("z' = b*u' + u*b' + R", "w' = u*b'"), "z - b*u - R*t"),
        (("z' = z*(R*b' + u')", "w' = u*b'"), "log(abs(z)) - R*b - u"),
        (("z' = u*b'", "w' = b*u' + R*sin(3*t)"), "z + w - u*b + R*cos(3*t)/3"),  # neither row alone, and driven
        (("z' = 3*R*b^2*u*b' + R*b^3*u' + R^2*t^2", "w' = u*z'"), "z - R*b^3*u - R^2*t^3/3"),  # all of one degree
        (("z' = R*cos(u + R*t)*u' + R^2*cos(u + R*t)",), "z - R*sin(u + R*t)"),  # on a wave that passes
    ],
)
def test_integrals_with_a_parameter_beside_a_function(rows: tuple[str, ...], integral: str) -> None:
    system = constrained("b, u, z, w", *rows, parameters="{R: 0.4}")
    facts = describe(system, formulate(system), Bag(system.spec.origin))
    assert "not found" not in facts.marked["integrals"]
    b, u, z, w, R, t = sympy.symbols("b u z w R t", real=True)
    wanted = sympy.sympify(integral, names := {"b": b, "u": u, "z": z, "w": w, "R": R, "t": t})
    found = [sympy.sympify(e["integral"].replace("^", "**"), names) for e in facts.data["integrals"]]
    ratios = [
        [sympy.simplify(sympy.diff(f, x) - k * sympy.diff(wanted, x)) for x in (b, u, z, w, t)]
        for f in found
        for k in (1, -1, 3, -3)
    ]
    assert [0, 0, 0, 0, 0] in ratios, found


@pytest.mark.parametrize("row", ["y' = R*y", "x' = y'/y", "sin(y)*x' = cos(y)*y'", "x*y' + y*x' = R*x*y"])
@pytest.mark.parametrize("y", [1.3, -1.3])
def test_logarithms_are_constant_on_either_branch(row: str, y: float) -> None:
    """y' = R y holds at y < 0 too: log(y) has no value there, log(abs(y)) has one."""
    system = constrained("x, y", f"c: {row}", parameters="{R: 0.4}")
    g, kinds, frame = system.graph, classify(system), frame_of(system)
    (integral,) = find_position_integrals(system, frame, kinds.hidden, kinds.closed)
    assert "log(abs(" in integral.text
    known = {system.q[0]: -0.7, system.q[1]: y, system.t: 0.2, system.p[0]: 0.4}
    rates = [tangent(g, [integral.node], dict(zip(system.q, e, strict=True)))[0] for e in frame.free_vectors]
    rates += tangent(g, [integral.node], {**dict(zip(system.q, frame.drift, strict=True)), system.t: g.one})
    value, *found = evaluate(g, [integral.node, *rates], known)
    assert math.isfinite(value)
    assert found == pytest.approx([0.0] * len(found), abs=1e-12)


def test_an_integral_that_is_not_elementary_is_said_to_be_missing() -> None:
    system = constrained("x, y", "c: exp(-x^2)*x' + exp(-y^4)*y' = 0")
    bag = Bag(system.spec.origin)
    facts = describe(system, formulate(system), bag)
    assert facts.data["hidden"] == 1
    assert facts.data["integrals"] == []
    assert "integrals: 1 not found in elementary functions" in facts.lines
    assert [d.code for d in bag.diagnostics].count("W0410") == 1


def test_affine_constraints_count_time() -> None:
    steady = classify(constrained("x, y, z", "c: z' - y*x' = 1"))
    assert (steady.affine, steady.rheonomic, steady.hidden) == (True, False, 0)
    moving = classify(constrained("x, y", "c: x' = cos(t)"))
    assert (moving.affine, moving.rheonomic, moving.hidden, moving.closed) == (True, True, 1, ("c",))


@pytest.mark.parametrize(
    ("values", "row", "integral"),
    [
        ("{a: 0.5, b: 0.5}", "z' = a*y*x' + b*x*y'", "2*z - x*y"),
        ("{a: 0, b: 2}", "z' = a*y*x' + b*y'", "2*y - z"),
        ("{a: 0.5, b: 0.25}", "z' = a*y*x' + b*x*y'", ""),
        ("{a: pi/4, b: pi/4}", "z' = a*y*x' + b*x*y'", ""),  # no rational numbers: stays as it is
    ],
)
def test_rows_that_are_integrable_for_the_values_given_only(values: str, row: str, integral: str) -> None:
    """d(z - x y/2) = dz - (y dx + x dy)/2; without the first term only y and z are left."""
    system = constrained("x, y, z", row, parameters=values)
    bag = Bag(system.spec.origin)
    facts = describe(system, formulate(system), bag)
    assert facts.data["hidden"] == 0
    assert facts.data.get("hidden_as_given", 0) == bool(integral)
    found = facts.data.get("integrals_as_given", [])
    assert [entry["integral"] for entry in found] == ([integral] if integral else [])
    said = "the constraint `c1` is integrable with the values under `parameters:`: it is a holonomic constraint in disguise"
    assert [d.message for d in bag.diagnostics if d.code == "W0410"] == ([said] if integral else [])


def test_each_constraint_in_disguise_is_told_its_own_integral() -> None:
    """Of z = x y and w = sin(x) as rates, each with its own function; the sleigh's edge between them has none."""
    rows = ("first: z' = y*x' + x*y'", "edge: u' = y*x'", "second: w' = cos(x)*x'")
    system = constrained("x, y, z, u, w", *rows)
    bag = Bag(system.spec.origin)
    describe(system, formulate(system), bag)
    found = {d.message.split("`")[1]: d.notes for d in bag.diagnostics if d.code == "W0410"}
    assert set(found) == {"first", "second"}
    wanted = {"first": "z - x*y", "second": "w - sin(x)"}
    for name, (note,) in found.items():
        text = note.removeprefix("its integral is `").removesuffix(" = const`")
        ratio = sympy.simplify(sympy.sympify(text.replace("^", "**")) / sympy.sympify(wanted[name]))
        assert ratio.is_number and ratio != 0, text


def test_an_integral_found_with_those_of_others_is_told_as_that_of_its_own_constraint() -> None:
    """Planetary gears: both meshes are integrable, and so is each combination of them."""
    rows = ("sun: 20*(s' - c') + 15*(p' - c') = 0", "ring: 50*(r' - c') - 15*(p' - c') = 0")
    system = constrained("s, c, r, p", *rows)
    bag = Bag(system.spec.origin)
    describe(system, formulate(system), bag)
    notes = [note for d in bag.diagnostics if d.code == "W0410" for note in d.notes]
    assert len(notes) == 2 and all(note.startswith("its integral is `") for note in notes)
    first, second = (sympy.sympify(note.split("`")[-2].removesuffix(" = const")) for note in notes)
    s, c, r, p = sympy.symbols("s c r p")
    assert not first.has(r) and not second.has(s)
    motion = {r: c + (c - s) * sympy.Rational(2, 5), p: c + (c - s) * sympy.Rational(4, 3)}
    assert sympy.simplify(first.subs(motion)) == sympy.simplify(second.subs(motion)) == 0


@pytest.mark.parametrize(
    ("row", "wanted"), [("r*f' = x' - y'", "r*f - x + y"), ("r*f' = x*x' - cos(y)*y'", "r*f - x**2/2 + sin(y)")]
)
def test_an_integral_is_told_beside_a_holonomic_constraint(row: str, wanted: str) -> None:
    """On x + y = 1 there are others, as r f - 2 x, which need that constraint."""
    text = (
        "nhc: 1\nsystem: pulley\ncoordinates: [x, y, f]\nparameters: {r: 0.2}\nT: (x'^2 + y'^2 + f'^2)/2\n"
        f"constraints:\n  - cord: {row}\nholonomic: [x + y = 1]\n"
    )
    system = resolve(decode(Source("pulley.yaml", text)))
    bag = Bag(system.spec.origin)
    facts = describe(system, formulate(system), bag)
    (found,) = [d for d in bag.diagnostics if d.code == "W0410"]
    (note,) = found.notes
    shown = sympy.sympify(note.removeprefix("its integral is `").removesuffix(" = const`").replace("^", "**"))
    ratio = sympy.simplify(shown / sympy.sympify(wanted))
    assert ratio.is_number and ratio != 0, note
    assert "found none" not in found.help[0]
    assert [entry["constraints"] for entry in facts.data["integrals"]] == [["h1"], ["cord"]]


def test_what_is_declared_holonomic_is_not_in_disguise() -> None:
    """The length of a quaternion and a `holonomic:` equation are integrable by the user's own word; x' = 2 y' is not."""
    text = """
nhc: 1
system: declared
coordinates: [x, y, z]
rotation: {R: {velocities: [u, v, w]}}
T: (x'^2 + y'^2 + z'^2 + u^2 + 2*v^2 + 3*w^2)/2
constraints: [ROW u + R_z1*w = 0]
holonomic: [z = sqrt(2*R_z1^2 + 3*R_z2^2 + R_z3^2)*(R_z1 + R_z2*R_z3) + R_x1*R_x2]
"""
    said = []
    for row in ("", "x' = 2*y', "):
        system = resolve(decode(Source("declared.yaml", text.replace("ROW ", row))))
        facts = describe(system, formulate(system), Bag(system.spec.origin))
        lines = facts.lines
        (own,) = [found["integral"] for found in facts.data["integrals"] if found["constraints"] == ["h1"]]
        assert "…" not in own and len(own) > 160  # a program reads all of it
        said += [line for line in lines if line.startswith("integrability")]
        assert "that of `h1`, as declared" in next(line for line in lines if line.startswith("integrals"))
    assert said == [
        "integrability: 2 of 3 constraints integrable (as declared), the others truly nonholonomic",
        "integrability: 3 of 4 constraints integrable (2 as declared, 1 holonomic in disguise), the others truly nonholonomic",
    ]


# --- singular sets ----------------------------------------------------------------------------------------


def test_where_constraints_lose_rank_is_found() -> None:
    assert find_rank_loss(system_of("snakeboard")).regular is False
    assert len(find_rank_loss(system_of("snakeboard")).minors) == 3
    assert facts_of("cartesian_pendulum").data["rank"] == {"full": False, "lost_where_all_vanish": ["x", "y"]}
    for name in ("chaplygin_sleigh", "roller_racer", "rolling_disk", "diff_drive", "rattleback"):
        assert find_rank_loss(system_of(name)).regular is True, name


def test_rank_is_lost_where_a_factor_of_all_minors_vanishes() -> None:
    """Without their factor cos(th) the rows have rank 2 everywhere, by x' and y'."""
    rows = ["cos(th)*((2 + sin(th))*x' + z') = 0", "cos(th)*(y' + cos(z)*z') = 0"]
    system = constrained("x, y, z, th", *rows)
    found = find_rank_loss(system)
    g, th = system.graph, system.q[3]
    assert (found.regular, found.minors) == (False, (g.function("cos", th),))
    lines = describe(system, formulate(system), Bag(system.spec.origin)).lines
    assert "rank of the constraints: lost where cos(th) = 0: the motion is undefined there" in lines


CAR = ("x, y, th, de", "rear: sin(th)*x' = cos(th)*y'", "front: sin(th+de)*x' - cos(th+de)*y' = cos(de)*th'")
SKATE_ON_SPHERE = "-sin(ps)*th' + cos(ps)*sin(th)*ph' = 0"
TRIKKE = (
    "x, y, th, al, ph",
    "sin(th+al)*x' = cos(th+al)*y'",
    "sin(th+ph)*x' - cos(th+ph)*y' = (cos(ph) - sin(ph)/2)*th'",
)


def rank_of(*spec: str) -> tuple[object, str]:
    system = constrained(*spec)
    facts = describe(system, formulate(system), Bag(system.spec.origin))
    return facts.data["rank"]["full"], facts.marked["rank"].replace("$", "")


def test_of_many_minors_a_few_are_written_out() -> None:
    """Six links that hang at both ends: 15 minors, which vanish where all are in line."""
    links = [f"a{i}" for i in range(1, 7)]
    rows = (" + ".join(f"{of}({a})*{a}'" for a in links) + " = 0" for of in ("sin", "cos"))
    full, text = rank_of(", ".join(links), *rows)
    assert full is False
    assert text.count("sin(a1 - a") == 5 and "-sin" not in text
    assert text.endswith(" = 0, where 9 other minors vanish, too: the motion is undefined there")


@pytest.mark.parametrize(
    ("coordinates", "row", "said"),
    [
        ("{th: {range: [0.3, 2.8]}, ph: {}, ps: {}}", SKATE_ON_SPHERE, "full everywhere in the declared ranges"),
        ("{th: {}, ph: {}, ps: {}}", SKATE_ON_SPHERE, "lost where"),
        ("{th: {range: [0, pi]}, ph: {}, ps: {}}", "sin(th)*ph' - cos(th)*ps' = 0", "full everywhere"),
    ],
)
def test_a_rank_that_is_full_only_within_declared_ranges_says_so(coordinates: str, row: str, said: str) -> None:
    """At the poles of a sphere a skate on it is not held; in the plane there are none, whatever the range."""
    system = build(
        f"nhc: 1\nsystem: test\ncoordinates: {coordinates}\nT: (th'^2 + ph'^2 + ps'^2)/2\nconstraints:\n  - {row}\n"
    )
    text = describe(system, formulate(system), Bag(system.spec.origin)).marked["rank"]
    assert text.startswith(f"rank of the constraints: {said}")
    assert ("declared" in text) == ("declared" in said)


def test_minors_that_never_vanish_at_once_lose_no_rank() -> None:
    """The rear wheel of a car forbids what the front one allows: A A^T has the eigenvalue 1 at least where sin(de) = 0."""
    for th, de in product(np.linspace(0, 7, 40), np.linspace(0, 7, 40)):
        front = [np.sin(th + de), -np.cos(th + de), -np.cos(de)]
        assert np.linalg.svd([[np.sin(th), -np.cos(th), 0], front], compute_uv=False)[-1] > 0.4
    assert rank_of(*CAR) == (True, "rank of the constraints: full everywhere")


def test_rank_is_said_to_be_lost_where_it_is() -> None:
    """Front and rear wheels of a Trikke are parallel, and the rear axle's line passes the pivot: al = ph = atan(2)."""
    full, line = rank_of(*TRIKKE)
    assert full is False
    assert line.endswith("= 0: the motion is undefined there")


def test_a_loss_of_rank_that_is_found_nowhere_is_not_claimed() -> None:
    full, line = rank_of("x, y, z", "(x^2 - x + 1)*y' + (x^2 - 2*x + 2)*z' = 0")
    assert full is None
    assert line.startswith("rank of the constraints: full wherever it was tried; it would be lost where")


def test_rows_of_a_turning_body_that_lose_no_rank() -> None:
    """A ball in a cone: the rows have the lengths^2 1 + a^2 and r^2 + a^2, whatever the ball's orientation, and are orthogonal."""
    assert find_rank_loss(resolve(decode(Source("cone.yaml", CONE)))).regular is True


CONE = """\
nhc: 1
system: cone
rotation: {R: {velocities: [p, q, w]}}
coordinates: [s, ph]
parameters: {a: 0.1, al: 0.6}
define:
  ox: R_x1*p + R_x2*q + R_x3*w
  oy: R_y1*p + R_y2*q + R_y3*w
  oz: R_z1*p + R_z2*q + R_z3*w
  r: s*sin(al) - a*cos(al)
T: (s'^2 + r^2*ph'^2 + p^2 + q^2 + w^2)/2
constraints:
  - s' - a*(cos(ph)*oy - sin(ph)*ox) = 0
  - r*ph' + a*(sin(al)*(cos(ph)*ox + sin(ph)*oy) + cos(al)*oz) = s
"""


# --- what is conserved ------------------------------------------------------------------------------------


def conserved(name: str) -> dict[str, tuple[str, ...]]:
    return {entry["integral"]: tuple(entry["where_zero"]) for entry in facts_of(name).data["conserved"]}


def test_the_moving_energy_of_the_ball_on_a_table() -> None:
    """E - Omega (m (x y' - y x') + I omega_z) for a steady table; omega_z is constant by itself."""
    found = conserved("ball_on_table")
    assert found["p_phi"] == ()
    assert found["E - Omega0 (x p_y - y p_x)"] == ("Omega1",)
    assert [e["moving_energy"] for e in facts_of("ball_on_table").data["conserved"]] == [False, False, True]
    assert not facts_of("ball_on_table").data["energy"]["conserved"]


def test_conserved_momenta() -> None:
    assert {"p_phi", "p_psi", "E"} <= set(conserved("heavy_top"))
    assert {"p_x", "p_y", "p_psi", "(x p_y - y p_x) + p_phi", "E"} == set(conserved("smooth_tippe_top"))
    assert set(conserved("vertical_disk")) == {"p_phi", "p_theta"}  # the energy is a function of them
    assert set(conserved("snakeboard")) == {"p_p_f + p_p_b"}
    assert set(conserved("chaplygin_sleigh")) == {"E"}  # x and y are cyclic, their momenta change
    assert facts_of("chaplygin_sleigh").data["cyclic"] == ["x", "y"]


def test_further_integrals() -> None:
    assert facts_of("contact_oscillator").data["constant_outputs"] == ["H_y", "R"]
    assert "y^2 + y'^2" in conserved("contact_oscillator")
    assert facts_of("routh_sphere").data["constant_outputs"] == ["jellett", "routh"]
    assert facts_of("veselova").data["constant_outputs"] == ["L_x", "L_y"]


def test_names_of_constants_are_nothing_elses() -> None:
    """A sleigh on a turntable whose rate is called E, with a parameter p_th."""
    system = build(
        "nhc: 1\nsystem: table\ncoordinates: [x, y, th]\nparameters: {E: 2, p_th: 1, m: 1}\nT: m/2*(x'^2 + y'^2) + p_th/2*th'^2\n"
        "constraints: [\"-sin(th)*(x' + E*y) + cos(th)*(y' - E*x) = 0\"]\n"
    )
    found = find_conserved(system, frame_of(system), formulate(system).frame)
    assert [i.text for i in found.integrals] == ["dT/dth'", "(T + V) - E (x p_y - y p_x)"]


def test_the_generalized_energy_of_a_bead_on_a_rod() -> None:
    data = facts_of("bead_on_rod").data["energy"]
    assert (data["conserved"], data["generalized"]) == (False, True)
    assert "(p q' - T + V)" in conserved("bead_on_rod")


def test_the_generalized_energy_where_signs_are_too_many_for_points() -> None:
    """T that is not homogeneous, beside kinks: the theorem of energy says what points of a field cannot."""
    text = (
        "nhc: 1\nsystem: kinks\ncoordinates: [x, y]\nT: (x' + 0.4*abs(x)*y' + x)^2/2 + (y' + abs(y)*x')^2\n"
        "V: max(0, x + y)^2 + 2*sqrt((y + 2)^2) + max(x, y)^3\nconstraints: [\"x' = (2 + abs(x))*y' + abs(y - x)*y'\"]\n"
    )
    system = resolve(decode(Source("kinks.yaml", text)))
    found = find_conserved(system, frame_of(system), formulate(system).frame)
    assert (found.energy, found.jacobi) == (False, True)
    assert [i.text for i in found.integrals] == ["(p q' - T + V)"]


BRAKE = """nhc: 1
system: brake
coordinates: [{s}]
parameters: {{{a}: 3, {b}: 4, c: 2, m: 1}}
define: {{X: "{a}*{s}", Y: "{b}*{s}", speed: "sqrt(X'^2 + Y'^2)"}}
T: m/2*(X'^2 + Y'^2)
forces: {{{s}: "c*(speed - {s}'*sqrt({a}^2 + {b}^2))"}}
"""


@pytest.mark.parametrize("s", ["x", "q", "theta", "xi"])
@pytest.mark.parametrize(("a", "b"), [("b", "d"), ("h", "l"), ("dx", "dy"), ("n1", "n2"), ("lx", "ly")])
def test_a_force_with_a_hidden_sign_takes_energy(s: str, a: str, b: str) -> None:
    system = resolve(decode(Source("brake.yaml", BRAKE.format(s=s, a=a, b=b))))
    found = find_conserved(system, None)
    assert (found.energy, found.power) == (False, (f"the force on `{s}`",))


def test_where_no_motion_is_determined_none_is_sought_long(monkeypatch: pytest.MonkeyPatch) -> None:
    """l = 0 is for scenes to replace; with it the mass matrix is zero, at one point as at twenty thousand."""
    points = []
    exactly = sampling.solve_exactly
    monkeypatch.setattr(sampling, "solve_exactly", lambda *given: points.append(given) or exactly(*given))
    text = "nhc: 1\nsystem: e\ncoordinates: [theta]\nparameters: {m: 1, l: 0, g: 9.81}\nT: m*l^2/2*theta'^2\nV: -m*g*l*cos(theta)\n"
    found = find_conserved(resolve(decode(Source("e.yaml", text))), None)
    assert [(integral.text, integral.where) for integral in found.integrals] == [("E", ())]
    assert len(points) < 100


@pytest.mark.parametrize(
    ("coordinates", "forces", "power"),
    [
        ("x", "{x: P/x'}", ("x",)),
        ("x, y", "{x: P*x'/(x'^2 + y'^2), y: P*y'/(x'^2 + y'^2)}", ("x", "y")),
        ("x, y", "{x: P/x', y: -P/y'}", ()),
        ("x, y", "{x: P/x', y: -P/y' - c*y'}", ("x", "y")),
        ("x, y", "{x: P*y', y: -P*x' - c*y'}", ("y",)),
        ("x, y", "{x: P/x', y: P*y'/(2 + y'^2)}", ("x", "y")),
        ("x, y", "{x: P*sign(x')/x'}", ("x",)),
    ],
)
def test_a_force_of_constant_power_takes_energy(coordinates: str, forces: str, power: tuple[str, ...]) -> None:
    """The work of an engine has no slope along the velocity, but it is work: d/dt (m q'^2/2) = P."""
    head = f"nhc: 1\nsystem: engine\ncoordinates: [{coordinates}]\nparameters: {{P: 2, c: 0.1}}\n"
    squares = " + ".join(f"{name}'^2/2" for name in coordinates.split(", "))
    found = find_conserved(resolve(decode(Source("e.yaml", f"{head}T: {squares}\nforces: {forces}\n"))), None)
    assert found.power == tuple(f"the force on `{name}`" for name in power)
    assert found.energy == (not power)
    assert not (power and any(integral.text == "E" for integral in found.integrals))


def test_outputs_that_jump_are_not_constant() -> None:
    """All have rate zero where they have one; what holds constants of the motion only, or is continuous, does not jump."""
    jumping = (
        "abs(x)/x",
        "x/sqrt(x^2)",
        "atan2(a*x, b*x)",
        "cos(atan2(0, x))",
        "min(x, 0)/x",
        "sqrt(x^2*y^2)/(x*y)",
        "atan(tan(x)) - x",
        "sign(x)*z'",
        "atan(x') + atan(1/x')",
        "(x - 77)/abs(x - 77)",
        "sqrt((x + 2.5e6)^2)/(x + 2.5e6)",
    )
    constant = (
        "atan2(z', a)",
        "abs(z')",
        "sign(z')",
        "1/z'",
        "E",
        "sqrt(1 + E^2)/(1 + abs(z'))",
        "x'^2/2 + k*sqrt(x^2)",
    )
    lines = [f"  o{k}: {text}" for k, text in enumerate((*jumping, *constant))]
    text = (
        "nhc: 1\nsystem: outputs\ncoordinates: [x, y, z]\nparameters: {k: 1, a: 1, b: 2}\n"
        "define: {E: x'^2/2 + k*sqrt(x^2)}\nT: (x'^2 + y'^2 + z'^2)/2\nV: k*sqrt(x^2) + y^2\noutputs:\n"
    )
    found = find_conserved(resolve(decode(Source("outputs.yaml", text + "\n".join(lines) + "\n"))), None)
    assert found.energy
    assert found.outputs == tuple(f"o{len(jumping) + k}" for k in range(len(constant)))


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("constraints: [\"y' + atan2(a*x', b*x') = 0\"]", "E0401"),
        ("constraints: [\"y' + atan(x') + atan(1/x') = 0\"]", "E0401"),
        ("V: atan(x') + atan(1/x')", "E0405"),
    ],
)
def test_steps_of_angles_are_no_constants(line: str, code: str) -> None:
    head = "nhc: 1\nsystem: steps\ncoordinates: [x, y]\nparameters: {a: 1, b: 2}\nT: (x'^2 + y'^2)/2\n"
    with pytest.raises(SpecError) as refused:
        resolve(decode(Source("steps.yaml", head + line + "\n")))
    assert [d.code for d in refused.value.diagnostics] == [code]


@pytest.mark.parametrize("name", [n for n in GALLERY if n != "bicycle"])
def test_the_power_balance_is_exact(name: str) -> None:
    """d/dt (p q' - T - U) = Q q' - dT/dt - dU/dt - lambda a_0 on the motion, modulo two primes."""
    system = system_of(name)
    sampler = Sampler(system, frame_of(system))
    moving = dict(zip(system.v, sampler.rates, strict=True))
    rate = total_derivative(system, generalized_energy(system), system.v, moving)
    gap = system.graph.sub(rate, power(system, sampler.multipliers))
    for prime in PRIMES[:2]:
        assert sampler.residues([gap], 2, prime) == [[0], [0]]


@pytest.mark.parametrize("name", ["ball_on_table", "smooth_tippe_top", "nh_particle", "heavy_top"])
def test_integrals_do_not_change_and_are_independent(name: str) -> None:
    system = system_of(name)
    formulation = formulate(system)
    found = find_conserved(system, frame_of(system), formulation.frame)
    zero = [s for s in system.p if any(system.symbol_name(s) in i.where for i in found.integrals)]
    sampler = Sampler(system, frame_of(system), zero)
    moving = dict(zip(system.v, sampler.rates, strict=True))
    rates = [total_derivative(system, i.node, system.v, moving) for i in found.integrals]
    assert sampler.residues(rates, 1, PRIMES[2], seed=5) == [[0] * len(rates)]
    assert rank(system.graph, [gradient(system.graph, i.node, (*system.q, *system.v)) for i in found.integrals]) == len(
        rates
    )


def test_rational_relations_are_read_off_residues() -> None:
    p = PRIMES[0]
    assert str(rational(-7 * pow(3, -1, p) % p, p)) == "-7/3"
    assert rational(123456789012345678, p) is None
    rows = [[x, y, 2 * x - 3 * y] for x, y in ((1, 2), (5, 3), (7, 11), (13, 4))]
    (vector,) = find_relations(rows, 3, p)
    assert [str(x) for x in vector] == ["-2", "3", "1"]
    assert without([vector], [vector]) == []
    assert without([vector], []) == [vector]


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", GALLERY)
def test_facts_are_the_same_as_lines_and_data(name: str) -> None:
    facts = facts_of(name)
    assert {"degrees", "energy", "conserved", "cyclic", "applicable", "formulation"} <= set(facts.data)
    assert all("\n" not in line and line for line in facts.lines)
    if system_of(name).l:
        assert [k["name"] for k in facts.data["kinds"]] == [f.name for f in system_of(name).constraints]
        assert len(facts.data["integrals"] if facts.data["hidden"] else []) == facts.data["hidden"]


@pytest.mark.parametrize(
    ("vector", "wanted"),
    [
        ((1, 0, 0), "a"),
        ((0, 0, -1), "-c"),
        ((-2, 0, 1), "c - 2 a"),
        ((1, 1, Fraction(-1, 2)), "-1/2 c + b + a"),
        ((Fraction(3, 4), -1, 5), "5 c - b + 3/4 a"),
    ],
)
def test_a_combination_is_spelt_as_it_is_made(vector: tuple[Fraction, ...], wanted: str) -> None:
    g = Graph()
    candidates = [Candidate(name, g.symbol(name)) for name in "abc"]
    weights = [g.number(k) for k in vector]
    assert spell(g, weights, candidates) == wanted
    values = dict(zip((c.node for c in candidates), (2.0, 3.0, 7.0), strict=True))
    known = {"a": 2, "b": 3, "c": 7}
    text = re.sub(r"(\d) ([abc])", r"\1*\2", wanted)
    exact = sympy.sympify(text, {name: sympy.Integer(k) for name, k in known.items()})
    assert evaluate(g, [combine(g, weights, candidates)], values)[0] == pytest.approx(float(exact), rel=1e-15)


def test_coefficients_that_are_functions_of_the_parameters() -> None:
    """Three gears: a turn of all of them by their radii changes neither T nor V, whatever the inertias are."""
    text = """nhc: 1
system: gears
coordinates: [a, b, c]
parameters: {r1: 1, r2: 2, r3: 3, J: 4, K: 5, k: 6}
T: (J*a'^2 + K*b'^2 + c'^2)/2
V: k/2*((r1*a - r2*b)^2 + COUPLED)
"""

    def tell(coupled: str) -> str:
        system = resolve(decode(Source("s.yaml", coupled)))
        return "\n".join(describe(system, formulate(system), Bag(system.spec.origin)).lines)

    turning = tell(text.replace("COUPLED", "(r2*b - r3*c)^2"))
    assert "constants of the motion: E, r1*r2 p_c + r1*r3 p_b + r2*r3 p_a (" in turning
    assert "constants of the motion: E (" in tell(text.replace("COUPLED", "(r2*b - r3*c)^2 + a^2"))
    summed = text.replace("COUPLED", "0*c^2").replace("r2*b", "(r2 + r3)*b").replace(" + c'^2", " + J*c'^2")
    assert "(r2 + r3) p_a" in tell(summed)


@pytest.mark.parametrize("function", ["sin", "cos", "sinh", "cosh", "exp"])
def test_integrals_behind_a_factor(function: str) -> None:
    """x f(x) x' + x y' = 0 is x times d(y + integral of f): no term of it is a differential, and none is needed."""
    system = constrained("x, y, z", f"c: x*{function}(x)*x' + x*y' = 0")
    facts = describe(system, formulate(system), Bag(system.spec.origin))
    (found,) = [sympy.sympify(e["integral"].replace("^", "**")) for e in facts.data["integrals"]]
    x, y = sympy.symbols("x y")
    assert sympy.simplify(sympy.diff(found, x) / sympy.diff(found, y) - getattr(sympy, function)(x)) == 0


@pytest.mark.parametrize(
    ("forces", "power"),
    [
        ("{v: F}", ("v",)),
        ("{v: F, theta: -F*theta'}", ("v", "theta")),
        ("{v: F, tip: -F}", ("v", "tip")),
        ("{v: F, x: F}", ("x", "v")),
        ("{v: F*u, u: -F*v}", ()),
    ],
)
def test_work_is_done_by_what_the_spec_names(forces: str, power: tuple[str, ...]) -> None:
    """A force on a velocity or a position pushes along coordinates, of which the spec says nothing."""
    text = f"""nhc: 1
system: sled
coordinates: [x, y, theta]
parameters: {{F: 2}}
define: {{v: x'*cos(theta) + y'*sin(theta), u: y'*cos(theta) - x'*sin(theta), tip: x + cos(theta)}}
T: (x'^2 + y'^2 + theta'^2)/2
forces: {forces}
"""
    found = find_conserved(resolve(decode(Source("sled.yaml", text))), None)
    assert found.power == tuple(f"the force on `{name}`" for name in power)


def test_where_the_time_is_written() -> None:
    text = """nhc: 1
system: timed
coordinates: [x, y]
rotation: {R: {velocities: [p, q, r]}}
parameters: {F: 2, w: 0}
define: {u: x' + y'}
T: (1 + t^2)*x'^2/2 + y'^2/2 + p^2 + q^2 + r^2
V: F*y*cos(t)
forces: {u: F*t, q: F*sin(w*t)}
constraints: [c: y' = t*x']
"""
    system = resolve(decode(Source("timed.yaml", text)))
    assert timed_parts(system) == ["T", "V", "the force on `u`", "the torque on `R`", "the constraint `c`"]
    still = resolve(
        decode(
            Source("still.yaml", text.replace("t^2", "y^2").replace("cos(t)", "y").replace("*t", "").replace("t*", ""))
        )
    )
    assert timed_parts(still) == []


def test_the_time_in_a_square_that_does_not_depend_on_it_is_not_told() -> None:
    """A bead on a rod in a frame that turns at W: |v|^2 = r'^2 + r^2 W^2, but the potential, seen from that frame, has t in it."""
    text = (
        "nhc: 1\nsystem: turned\ncoordinates: [r]\nparameters: {W: 0.7, k: 1, g: 9.81}\ndefine: {x: r*cos(W*t), y: r*sin(W*t)}\n"
        "T: (x'^2 + y'^2)/2\nV: VALUE\n"
    )
    for potential, timed in (("g*y", True), ("k*(x^2 + y^2)/2", False)):
        system = resolve(decode(Source("turned.yaml", text.replace("VALUE", potential))))
        assert system.graph.depends(system.T, system.graph.deps[system.t])  # by sight
        facts = describe(system, formulate(system), Bag(system.spec.origin))
        (line,) = [line for line in facts.lines if line.startswith("T: ")]
        assert facts.data["rheonomic"] is False and line.endswith("(without velocities (W*r)^2/2)"), line
        (energy,) = [line for line in facts.lines if line.startswith("energy: ")]
        assert ("contains the time" in energy) == timed and timed_parts(system) == (["V"] if timed else [])
    late = text.replace("cos(W*t)", "cos(W*t^2)").replace("sin(W*t)", "sin(W*t^2)").replace("VALUE", "0*r")
    system = resolve(decode(Source("turned.yaml", late)))
    assert describe(system, formulate(system), Bag(system.spec.origin)).data["rheonomic"] is True
