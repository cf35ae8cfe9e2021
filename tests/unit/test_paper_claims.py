"""What a derivation says in words, and the numbers beside its formulas."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from pathlib import Path

import pytest

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph
from nhc.diagnostics import Bag
from nhc.emit.latex.document import render
from nhc.emit.terms import split_number
from nhc.emit.text import print_derivation
from nhc.language import Source, decode
from nhc.mechanics.choosing.choose import applicable, formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.properties.facts import describe
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.program.contents import walk
from nhc.program.ir import Ref
from nhc.program.paper import Derivation, Statement, derivation
from nhc.program.sheets.model import Mark
from nhc.program.sheets.tidy import _with_squares

SPECS = Path(__file__).resolve().parents[2] / "specs"
HEAD = "nhc: 1\nsystem: case\nparameters: {m: 1, c: 0.4}\n"
PLANE = HEAD + "coordinates: [x, y]\nT: m/2*(x'^2 + y'^2)\n"
SPACE = HEAD + "coordinates: [x, y, z]\nT: m/2*(x'^2 + y'^2 + z'^2)\n"
PARTICLE = SPACE + "constraints: [slip: z' - y*x' = 0]\n"
QUADRATIC = "T is homogeneous quadratic in the velocities and nothing depends on the time: the energy E is constant."


def load(text: str) -> System:
    return resolve(decode(Source("case.yaml", text)))


def derive(text: str, formulation: str = "") -> Derivation:
    system = load(text)
    chosen = formulate(system, formulation)
    return derivation(system, chosen, equations_of(system, chosen))


def said(made: Derivation) -> str:
    """The words of a derivation on one line."""
    return " ".join(print_derivation(made).split())


def says(text: str, key: str) -> str:
    system = load(text)
    return describe(system, formulate(system), Bag(system.spec.origin)).marked[key].replace("$", "")


# --- the energy -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("formulation", ["", "multipliers"])
def test_plain_reasons_for_a_constant_energy(formulation: str) -> None:
    assert QUADRATIC in said(derive(PARTICLE, formulation))


@pytest.mark.parametrize(
    "text",
    [
        PLANE + "constraints: [slip: -sin(c*t)*x' + cos(c*t)*y' = 0]\n",  # homogeneous, but it turns
        PLANE + "forces: {x: cos(t)*y', y: -cos(t)*x'}\n",  # a gyroscopic force that changes
        PLANE + "forces: {x: c*y', y: -c*x'}\n",
    ],
)
def test_a_constant_energy_is_not_explained_by_what_is_not_so(text: str) -> None:
    found = said(derive(text))
    assert QUADRATIC not in found
    assert "The left side is the rate of E, and on the right side no term is left on the motion" in found
    assert "the energy E is constant." in found


def test_terms_of_first_degree_that_vanish_on_the_constraints_are_seen() -> None:
    text = PARTICLE.replace("z'^2)", "z'^2) + c*x*(z' - y*x')")
    found = said(derive(text))
    assert QUADRATIC not in found
    assert "On the constraints the left side is the rate of E" in found
    assert "what the theorem speaks of is H" not in found


def test_a_force_whose_work_another_cancels_is_no_reason() -> None:
    text = SPACE + "forces: {x: c*z*y', y: -c*z*x', z: -c*z'}\n"
    assert says(text, "energy") == "energy: T + V is not conserved, because of: the force on `z`"


@pytest.mark.parametrize(
    ("more", "second"),
    [("", "is"), ("V: x^2*cos(t)\n", "is not conserved either"), ("forces: {x: -c*x'}\n", "is not conserved either")],
)
def test_the_generalized_energy_is_told_where_it_is_another_one(more: str, second: str) -> None:
    rod = HEAD + "coordinates: [x]\nT: m/2*(x'^2 + (c*x)^2)\n"
    assert says(rod + more, "energy").split("; ")[1:] == [f"p q' - T + V {second}"]
    assert ";" not in says(PLANE + more, "energy")


@pytest.mark.parametrize("kind", ["U", "V"])
def test_a_potential_that_moves_is_called_as_the_spec_calls_it(kind: str) -> None:
    text = SPACE + f"{kind}: c*x*sin(t)\n"
    assert says(text, "energy") == f"energy: T + V is not conserved, because of: {kind} contains the time"


def test_forces_may_contain_the_time_under_caplygins_hypotheses() -> None:
    """I.3 speaks of L and the constraints only."""
    found = said(derive(PARTICLE + "forces: {x: c*cos(t)}\n", "chaplygin"))
    assert "The hypotheses of I.3 hold" in found
    assert "forces contain neither" not in found


def test_caplygins_hypotheses_see_steps() -> None:
    """A sign depends on its argument, though its slope is zero; I.3 asks that no force contains z."""
    text = PARTICLE + "dependent: [z]\n"
    named = "the force on `x` contains the dependent coordinate `z`"
    assert says(text + "forces: {x: c*sign(y)}\n", "chaplygin").endswith("all hold")
    assert named in says(text + "forces: {x: c*sign(z)}\n", "chaplygin")
    assert named in says(text + "forces: {x: c*z}\n", "chaplygin")


# --- numbers --------------------------------------------------------------------------------------------------

KINETIC = {  # the thesis numbers the terms of the kinetic part, not their sum, where there are constraints to use
    "euler-lagrange": "III.2.2 to III.2.4",
    "chaplygin": "III.3.2 to III.3.7",
    "voronec": "III.4.2 to III.4.5",
}
NUMBERS = {  # of Omega_c, Omega_d, Omega
    "newton": ("II.1.4", "II.1.5", "II.1.3"),
    "lagrange": ("II.3.1", "II.2.3", "II.3"),
    "multipliers": ("II.3.1", "II.2.3", "II.3"),
    "euler-lagrange": ("", "III.2.1", "III.2.5"),
    "chaplygin": ("", "III.3.1", "III.3"),
    "voronec": ("", "III.4.1", "III.4"),
}


@pytest.mark.parametrize("text", [PARTICLE + "V: c*x^2\n", PLANE + "V: c*x^2\n"])
def test_numbers_of_the_forms(text: str) -> None:
    seen = set()
    for formulation in applicable(load(text)):
        made = derive(text, formulation.name)
        tags = {
            (item.left[0].factors[0].base, *item.left[0].factors[0].lower): item.equation
            for sheet in made.sheets
            for item in sheet.items
            if isinstance(item, Statement) and item.left and item.left[0].factors
        }
        forms = (("Omega form", "c"), ("Omega form", "d"), ("Omega form",))
        assert tuple(tags[form] for form in forms) == NUMBERS[formulation.name]
        assert tags["Theta form",] == "II.2.2"
        assert tags["E",] == "" and tags.get(("T",), "") == ""
        assert formulation.name not in KINETIC or f"derivative ({KINETIC[formulation.name]})" in said(made)
        seen.add(formulation.name)
    assert len(seen) >= 4


# --- words ----------------------------------------------------------------------------------------------------


def test_one_is_not_several() -> None:
    made = said(derive(HEAD + "coordinates: [x]\nT: m/2*x'^2\n"))
    assert "the system has one degree of freedom." in made
    assert "Of its 3 rows one holds automatically (checked exactly), that of the velocity's differential." in made
    assert says(HEAD + "coordinates: [x]\nT: m/2*x'^2\n", "degrees") == "1 coordinate, 0 constraints, 1 free velocity"
    assert says(PARTICLE, "degrees") == "3 coordinates, 1 constraint, 2 free velocities"


def test_a_form_gives_way_to_a_quantity_of_its_name() -> None:
    text = PLANE.replace("c: 0.4", "Theta: 1, Omega: 2") + "V: Theta*x^2 + Omega*y^2\n"
    made = derive(text)
    lines = print_derivation(made).splitlines()
    assert any(line.startswith("  <Theta> = ") for line in lines)
    assert any(line.startswith("  <Omega> = ") for line in lines)
    assert not any(line.startswith("  Theta = m") for line in lines)
    assert r"\boldsymbol{\Omega} &= " in render(made)
    assert Mark("Theta form") in {
        factor
        for sheet in derive(PLANE).sheets
        for item in sheet.items
        if isinstance(item, Statement)
        for term in item.left
        for factor in term.factors
    }


# --- what is pleasant to read ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        ("981/100", ("9.81", "")),
        ("3/250", ("0.012", "")),
        ("1/20", ("0.05", "")),
        ("100.05", ("100.05", "")),
        ("1/4", ("", "4")),
        ("3/10", ("3", "10")),
        ("1/64", ("", "64")),
        ("7/30", ("7", "30")),
        ("1/5000", ("", "5000")),
        ("1", ("", "")),
        ("12", ("12", "")),
    ],
)
def test_awkward_fractions_are_decimals(value: str, shown: tuple[str, str]) -> None:
    assert split_number(Fraction(value)) == shown


def test_decimals_stand_above_the_line() -> None:
    made = derive(PLANE + "V: 9.81*m*y/(1 + x^2)\n")
    assert "U = -9.81*m*y/(1 + x^2)" in print_derivation(made)
    assert r"\frac{9.81\,m\,y}{1 + x^{2}}" in render(made)


def test_a_coefficient_that_stands_alone_needs_no_name_for_its_sign() -> None:
    """Omega has -(I1 sin^2 + I3 cos^2) as a coefficient, and a row has the sum once: no abbreviation for it."""
    made = derive((SPECS / "heavy_top.yaml").read_text())
    used = Counter(
        part.name
        for sheet in made.sheets
        for item in (*sheet.lets, *sheet.items)
        if isinstance(item, Statement)
        for term in (*item.right, *(item.left if item in sheet.items else ()))
        for part in walk(term.coefficient)
        if isinstance(part, Ref)
    )
    own = {entry.name for entry in made.system.spec.definitions}
    assert {name for name in made.lets if name not in own and used[name] < 2} == set()


def test_squares_of_cosines_are_written_as_such() -> None:
    made = derive((SPECS / "heavy_top.yaml").read_text())
    text = print_derivation(made)
    assert "1 - sin(theta)^2" not in text
    assert "(I1*sin(theta)^2 + I3*cos(theta)^2) phi''" in text


def test_a_sum_with_a_square_of_a_sine() -> None:
    """n - n sin^2 = n cos^2 wherever it stands in a sum, and nothing else changes."""
    g = Graph()
    x, y = g.symbol("x"), g.symbol("y")
    square = g.power(g.function("sin", x), 2)
    cases = [
        (g.sum([y, g.number(3), g.neg(g.mul(g.number(3), square))]), True),
        (g.sub(square, g.one), True),
        (g.sub(g.number(2), square), False),
        (g.sub(y, square), False),
    ]
    for node, changes in cases:
        made = _with_squares(g, node)
        assert (made != node) == changes
        assert are_zero(g, [g.sub(made, node)]) == [True]


# --- the coframe and the matrix -------------------------------------------------------------------------------


def test_forms_are_called_closed_only_where_all_of_gamma_was_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    """(1 + x^2)(dz - 2y dy) is integrable and not closed: gamma^s_{s,x} is not zero, between free forms nothing is left."""
    text = SPACE + "constraints: [s: (1 + x^2)*(z' - 2*y*y') = 0]\n"
    whole = said(derive(text, "euler-lagrange"))
    assert "gamma^s_{s,x}" in whole and "closed" not in whole
    monkeypatch.setattr("nhc.program.sheets.frames._HEAVY", 0)
    part = said(derive(text, "euler-lagrange"))
    assert (
        "closed" not in part
        and "gamma and epsilon between free quasi-velocities, all that the motion needs, vanish" in part
    )
    assert "the forms are closed" in said(
        derive(SPACE + "quasi_velocities: {u: x' + y', v: y', w: z'}\n", "euler-lagrange")
    )


def test_what_determines_the_accelerations_is_said_in_full() -> None:
    """A wheel that has no mass and no constraint leaves them open, although the constraints are independent."""
    words = said(derive(PARTICLE, "multipliers"))
    assert (
        "where the constraints are independent and T, its part of second degree, is not degenerate on the velocities"
        in words
    )
    assert "symmetric" not in words


@pytest.mark.parametrize(("sign", "wanted"), [("+", True), ("-", False)])
def test_a_matrix_is_called_positive_for_the_values_in_the_spec(sign: str, wanted: bool) -> None:
    coordinates = ", ".join(f"q{k}" for k in range(1, 8))
    chain = " + ".join(f"(q{k}' + cos(q{k + 1})*q{k + 1}')^2" for k in range(1, 7))
    text = f"{HEAD}coordinates: [{coordinates}]\nT: m/2*({chain} {sign} q7'^2/2)\n"
    words = said(derive(text, "lagrange"))
    assert (
        "for the values of the parameters in the spec and its scenes, positive wherever the motion is regular" in words
    ) is wanted
    assert ("not positive everywhere for the values of the parameters" in words) is not wanted


def test_a_derivation_says_where_an_energy_with_jumps_is_constant() -> None:
    assert "the energy E is constant where it does not jump." in said(derive(PLANE + "U: atan(tan(x)) - x + y^2\n"))
    assert QUADRATIC in said(derive(PLANE + "U: abs(x) + y^2\n"))


def test_the_theorem_of_energy_holds_for_many_signs() -> None:
    """The rate on the motion holds too many of them to be tested there: it was said not to vanish, for no reason."""
    text = (
        SPACE
        + "U: sqrt((x - y)^2) - max(x, y) + min(x, y)\nconstraints: [slip: z' - (x^2)^(1/2)*y' + abs(x + c)*y' = 0]\n"
    )
    assert says(text, "energy") == "energy: T + V is conserved"


@pytest.mark.parametrize("formulation", ["voronec", "chaplygin", "euler-lagrange", "multipliers"])
def test_a_name_stands_for_what_it_was_given_to(formulation: str) -> None:
    """With y' = 0 the rate of Y is b*p'*cos(p), a part of the sum that is named: before the constraints Y' is the sum."""
    text = HEAD + (
        "coordinates: [p, x, y]\n"
        "define: {Y: y + c*sin(p)}\n"
        "T: (p'^2 + x'^2 + m*Y'^2 + (1 + Y'^2)^2/9)/2\n"
        "constraints: [level: y' = 0, slip: x' - sin(p)*p' = 0]\n"
    )
    found = said(derive(text, formulation))
    assert "Y' = c*p'*cos(p) + y'" in found
    assert "y' + Y'" not in found


def test_no_sentence_announces_what_is_not_there() -> None:
    """A coframe of the coordinates' own differentials has no form and no inverse that would be worth a line."""
    plain = print_derivation(derive(PLANE, "euler-lagrange"))
    assert "The quasi-velocities are the velocities of the coordinates: all gamma and epsilon" in plain
    assert "are\nThey are" not in plain and "They are inverted to" not in plain
    assert "They are inverted to\n  z' = " in print_derivation(derive(PARTICLE, "euler-lagrange"))


def test_forces_that_cancel_are_no_force() -> None:
    """A drag along a trailer has no torque about its hitch, by sin^2 and cos^2."""
    words = said(
        derive(
            HEAD + "coordinates: [x, hitch]\nbodies: {trailer: {at: [x, 0], turns: [z: hitch], mass: m, inertia: 1}}\n"
            "points: {axle: {parent: trailer, at: [-c, 0]}}\nforces: {axle_v1: -axle_v1}\n"
        )
    )
    assert "Q_x = -" in words and "Q_hitch" not in words


def test_what_a_body_is_stands_in_its_sentence() -> None:
    words = said(derive(HEAD + "coordinates: [x]\nbodies: {cart: {at: [x, 0], mass: m, about: a cart on rails.}}\n"))
    assert "mass m (a cart on rails)." in words


def test_what_facts_name_is_said() -> None:
    """A definition may be written out everywhere but in the facts."""
    text = """nhc: 1
system: table
coordinates: [x, y, theta]
parameters: {m: 1, J: 0.2, Omega: 0.7, eps: 0.1}
define: {u: 1 + eps*sin(t), w: Omega*u, idle: Omega^2}
T: m/2*(x'^2 + y'^2) + J/2*theta'^2
constraints:
  - edge: -sin(theta)*(x' + w*y) + cos(theta)*(y' - w*x) = 0
"""
    told = said(derive(text))
    assert "(without velocities -cos(theta)*x*w - sin(theta)*y*w in `edge`)" in told
    assert "Here u = 1 + eps*sin(t), w = Omega*u, as the spec defines them." in told
