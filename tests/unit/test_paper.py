"""The derivation on paper: what it says, that it says it exactly, and that both printers read the same data."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Collection, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Node
from nhc.emit.latex.document import render as render_latex
from nhc.emit.layout import Piece, fill
from nhc.emit.terms import flatten_product, flatten_sum
from nhc.emit.text import derivation_json, print_derivation, print_equations, print_form, print_program
from nhc.language import Source, decode, read
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.ir import Binary, Negate, Number, Power, Ref
from nhc.program.model import build_program
from nhc.program.paper import SHEETS, Derivation, Statement, derivation
from nhc.program.sheets import formulas
from nhc.program.sheets import tidy as tidying
from nhc.program.sheets.draft import Desk, Draft, DraftSheet
from nhc.program.sheets.model import Formula, Mark
from nhc.program.sheets.tidy import list_roots, tidy
from tests.ir_values import value

SPECS = Path(__file__).resolve().parents[2] / "specs"
GALLERY = sorted(path.stem for path in SPECS.glob("*.yaml"))


@cache
def derive(name: str, formulation: str = "") -> tuple[Derivation, Equations]:
    system = resolve(decode(read(str(SPECS / f"{name}.yaml"))))
    chosen = formulate(system, formulation)
    equations = equations_of(system, chosen)
    return derivation(system, chosen, equations), equations


def sheet_items(made: Derivation, key: str) -> list[Statement]:
    (sheet,) = [sheet for sheet in made.sheets if sheet.key == key]
    return [item for item in sheet.items if isinstance(item, Statement)]


# --- general formulas -----------------------------------------------------------------------------------------


def list_formulas() -> list[Formula]:
    groups = (formulas.NOTATION, formulas.OMEGA, formulas.EQUATIONS)
    lone = [value for value in vars(formulas).values() if isinstance(value, Formula)]
    return [*lone, *(formula for group in groups for formula in group.values())]


def test_an_index_has_one_name_in_both_spellings() -> None:
    """No `m` that is mu here and m there: what LaTeX calls mu, the text calls mu, and no other index stands where it has none."""
    for formula in list_formulas():
        for index in ("alpha", "beta", "mu", "nu"):
            in_text = re.search(rf"(?<=[_{{,]){index}(?![a-z])", formula.text) is not None
            assert in_text == (f"\\{index}" in formula.latex), formula.text


# --- the text -------------------------------------------------------------------------------------------------


def test_sleigh_reads_like_the_thesis() -> None:
    text = print_derivation(derive("chaplygin_sleigh")[0])
    for line in (
        "  dpi_slip = -sin(theta) dx + cos(theta) dy   (I.2.3)",
        "  y' = cos(theta) omega_slip + sin(theta) v",
        "  gamma^slip_{v,w} = 1   (I.2.11)",
        "  p*_slip = m*a*w",
        "  dpi_v:  m*(v' - a*w^2) = 0   (III.1.1)",
        "  m v' = m*a*w^2   (I.2.15)",
        "  (J + m*a^2) w' = -m*a*v*w",
        "  w' = -m*a*v*w/(J + m*a^2)",
        "  lambda_slip = m*a w' + m*v*w   (I.4.1)",
        "Of its 5 rows 2 hold automatically (checked exactly), those of the velocities' differentials.",
    ):
        assert line in text.splitlines(), line


def test_broken_hypotheses_are_said() -> None:
    text = print_derivation(derive("ball_on_table")[0])
    assert "- the constraints are not homogeneous (b_alpha is not zero)." in text
    assert "E' = -y*Omega lambda_roll_x + x*Omega lambda_roll_y" in text


def test_energy_that_is_not_conserved_is_said() -> None:
    text = print_derivation(derive("bead_on_rod")[0])
    assert "T is not homogeneous quadratic" in text
    assert "which is constant:" in text


def test_parts_bring_their_abbreviations() -> None:
    made, _ = derive("voronec_particle")
    known = set(made.lets)
    for text in (print_form(made), print_equations(made)):
        lines = text.splitlines()
        defined = {line.split(" = ")[0].strip() for line in lines if line.startswith("  ") and " = " in line}
        for name in known:
            used = any(f"{name}*" in line or f"*{name}" in line for line in lines)
            assert not used or name in defined, name


@pytest.mark.sample(4)
@pytest.mark.parametrize("name", GALLERY)
def test_every_system_has_its_sheets(name: str) -> None:
    made, equations = derive(name)
    keys = [sheet.key for sheet in made.sheets]
    assert keys == [key for key in SHEETS if key in keys]
    assert {"data", "formulation", "form", "associated", "motion", "energy"} <= set(keys)
    rates = [s for s in sheet_items(made, "motion") if s.equation == equations.number]
    assert len(rates) >= len(equations.motion.w)
    text = print_derivation(made)
    assert max(len(line) for line in text.splitlines()[4:]) <= 100
    data = derivation_json(made)
    assert (data["schema"], data["nhc_derivation"]) == ("nhc.derivation/1", 1)
    assert [sheet["key"] for sheet in data["sheets"]] == keys
    assert json.loads(json.dumps(data)) == data


# --- exactness ------------------------------------------------------------------------------------------------


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", GALLERY)
def test_printed_equations_are_the_program_s(name: str) -> None:
    """Mass and force of the motion sheet, evaluated through all abbreviations, equal those of the associated system."""
    made, equations = derive(name)
    g, system, rng = equations.system.graph, equations.system, random.Random(3)
    symbols = (*system.q, *equations.motion.w, *system.p, system.t)
    place = {symbol: rng.uniform(0.4, 0.9) for symbol in symbols}
    marks = {}
    for symbol, number in place.items():
        kind = g.symbol_of(symbol)
        assert kind is not None
        marks[(kind.name, 1 if kind.kind == "velocity" else 0)] = number
    known = {
        name: marks[(s.mark.base, s.mark.dots)]
        for name, s in made.symbols.items()
        if (s.mark.base, s.mark.dots) in marks
    }
    given = {
        s.left[0].factors[0].base: s for s in sheet_items(made, "data") if s.left[0].factors
    }  # entries of rotations
    named = {name: given[s.mark.base] for name, s in made.symbols.items() if s.mark.base in given and not s.mark.dots}
    for let, statement in [*made.lets.items(), *named.items(), *made.lets.items()]:
        if let not in known:
            try:
                known[let] = value(statement.right[0].coefficient, known)
            except KeyError:
                continue  # it needs rates, velocities that are not kept, or the constraints' own
    rows = [s for s in sheet_items(made, "motion") if s.equation == equations.number][: len(equations.motion.w)]
    wanted = evaluate(g, [n for row in equations.mass for n in row] + list(equations.force), place)
    size = len(rows)
    for k, row in enumerate(rows):
        mass = [float(x) for x in wanted[k * size : (k + 1) * size]]
        printed = [value(term.coefficient, known) for term in row.left]
        assert sum(printed) == pytest.approx(sum(mass), rel=1e-9, abs=1e-9)
        force = sum(value(term.coefficient, known) for term in row.right if not term.factors)
        assert force == pytest.approx(float(wanted[size * size + k]), rel=1e-9, abs=1e-9)


def test_a_big_system_stays_short() -> None:
    made, _ = derive("bicycle")
    assert sum(len(sheet.lets) for sheet in made.sheets) < 1500
    assert "would fill pages" in " ".join(print_form(made).split())


def test_names_of_the_user_come_back() -> None:
    made, _ = derive("chaplygin_sleigh")
    assert "  X' = x' - a*theta'*sin(theta)" in print_derivation(made).splitlines()


def test_automatic_letters_avoid_the_spec_s() -> None:
    text = (
        "nhc: 1\nsystem: letters\ncoordinates: [z, k]\nparameters: {h: 1, s: 2}\n"
        "T: (z'^2*(1 + h*cos(z) + s*sin(k) + h*s*cos(z*k))^2 + k'^2*(1 + h*cos(z) + s*sin(k) + h*s*cos(z*k))^4)/2\n"
    )
    system = resolve(decode(Source("letters.yaml", text)))
    chosen = formulate(system)
    made = derivation(system, chosen, equations_of(system, chosen))
    assert made.lets
    assert all(not name.startswith(("z", "k", "h", "s")) for name in made.lets)


# --- reading order --------------------------------------------------------------------------------------------


def test_sums_start_with_a_positive_term() -> None:
    x, y = Ref("x"), Ref("y")
    assert flatten_sum(Binary("+", Negate(x), y)) == [(False, y), (True, x)]
    assert flatten_sum(Binary("-", x, Binary("-", y, Number(Fraction(2))))) == [
        (False, x),
        (True, y),
        (False, Number(Fraction(2))),
    ]


def test_equal_terms_are_added() -> None:
    x, y = Ref("x"), Ref("y")
    twice = Binary("+", Binary("+", Binary("*", x, y), x), Binary("*", y, x))
    assert flatten_sum(twice) == [(False, Binary("*", Binary("*", Number(Fraction(2)), x), y)), (False, x)]
    assert flatten_sum(Binary("-", x, x)) == [(False, Number(Fraction(0)))]
    assert flatten_sum(Binary("-", Binary("+", x, y), x)) == [(False, y)]


def test_equal_factors_become_a_power() -> None:
    made, _ = derive("chaplygin_sleigh")
    a = next(name for name, symbol in made.symbols.items() if symbol.mark.base == "a")
    product = flatten_product(Binary("*", Ref(a), Binary("*", Negate(Ref(a)), Number(Fraction(3)))), made.symbols)
    assert (product.negative, product.number, product.over, product.under) == (True, 3, (Power(Ref(a), 2),), ())


def test_lines_end_outside_parentheses_where_they_can() -> None:
    pieces = [Piece("aaaa", 4), Piece(" + bb", 5, 1), Piece(" + (c", 5, 1), Piece(" + d)", 5, 2)]
    assert fill(pieces, 15, 15) == ["aaaa + bb", " + (c + d)"]
    assert fill(pieces, 15, 9) == ["aaaa + bb", " + (c", " + d)"]
    assert fill([Piece("x" * 30, 30)], 10, 10) == ["x" * 30]
    assert fill([], 10, 10) == [""]


# --- the program ----------------------------------------------------------------------------------------------


def test_a_program_prints_one_statement_a_line() -> None:
    made, equations = derive("chaplygin_sleigh")
    program = build_program(equations.system, formulate(equations.system), equations)
    text = print_program(program)
    lines = text.splitlines()
    assert lines[0] == "program chaplygin_sleigh"
    assert "constraints: slip" in lines
    heads = [line for line in lines if line.startswith("function ")]
    assert [head.split("(")[0].split()[1] for head in heads] == [function.name for function in program.functions]
    assert all(" calls" in head for head in heads)
    statements = sum(len(function.body) for function in program.functions)
    assert sum(line.startswith("  ") for line in lines) >= statements
    assert made.system is equations.system


def test_a_dense_solve_is_printed_row_by_row() -> None:
    _, equations = derive("rolling_disk", "multipliers")
    program = build_program(equations.system, formulate(equations.system, "multipliers"), equations, only=("rhs",))
    lines = print_program(program).splitlines()
    (head,) = [k for k, line in enumerate(lines) if line.startswith("  solve size ")]
    size = equations.system.n + equations.system.l
    assert all(line.startswith("    row [") for line in lines[head + 1 : head + 1 + size])


def test_sums_that_vanish_are_not_printed() -> None:
    """(x + y) (x - y) - x^2 + y^2 is zero, and nothing in the node says so."""
    system = resolve(decode(read(str(SPECS / "point_mass.yaml"))))
    formulation = formulate(system)
    g, (x, y) = system.graph, system.q[:2]
    squares = g.sub(g.power(y, 2), g.power(x, 2))
    nothing = g.add(g.mul(g.add(x, y), g.sub(x, y)), squares)
    assert nothing != g.zero
    right = ((g.add(x, nothing), (Mark("x"),)), (g.mul(y, nothing), (Mark("y"),)))
    item = Draft(((nothing, ()),), right)
    desk = Desk(system, formulation, equations_of(system, formulation))
    (sheet,) = tidy(desk, [DraftSheet("motion", "Motion", [item])])
    (found,) = sheet.items
    assert isinstance(found, Draft)
    assert found.left == ((g.zero, ()),) and found.right == ((x, (Mark("x"),)),)


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", ["chaplygin_ball", "n_snake3", "snakeboard", "affine_voronec", "rattleback"])
def test_shorter_parts_keep_every_value(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Exact: before and after differ by what vanishes modulo primes; and there is less to read."""
    seen: list[tuple[Desk, list[Node], list[Node]]] = []

    def record(
        shortener: tidying._Shortener, drafts: Sequence[DraftSheet], owners: Collection[Node], share: Fraction
    ) -> tuple[DraftSheet, ...]:
        made = shorten(shortener, drafts, owners, share)
        seen.append((shortener.desk, list_roots(drafts), list_roots(made)))
        return made

    shorten = tidying._shorten_parts
    monkeypatch.setattr(tidying, "_shorten_parts", record)
    derive.__wrapped__(name)
    for desk, before, after in seen:
        g = desk.graph
        assert all(are_zero(g, [g.sub(x, y) for x, y in zip(before, after, strict=True)]))
    desk, before, after = seen[0]
    assert before != after
    assert sum(map(desk.size, after)) < sum(map(desk.size, before))


def test_no_abbreviation_hides_a_circle_or_a_cancelled_factor() -> None:
    """I1 (w1 cos^2 + w1 sin^2) and sin(theta)/sin(theta) stood in this derivation."""
    text = print_derivation(derive("chaplygin_ball")[0])
    assert not re.search(r"((?:\w+\*)?)cos\((\w+)\)\^2 \+ \1sin\(\2\)\^2", text)
    assert not re.search(r"(\w+\(\w+\))\*?[^ ]*/\1(?!\^)", text)


def test_a_quotient_before_a_velocity_stands_in_parentheses() -> None:
    text = print_derivation(derive("rolling_disk")[0])
    assert "  phi' = (1/sin(theta)) w_u\n  theta' = w_t\n  psi' = -(cos(theta)/sin(theta)) w_u + w_n\n" in text


def test_a_vector_field_has_a_letter_of_its_own() -> None:
    """The sleigh has positions X and Y, Newton's equations have forces X_i; the index mu of its rows is introduced."""
    for name, formulation, letter in (
        ("chaplygin_sleigh", "", "Z"),
        ("pendulum", "", "X"),
        ("point_mass", "newton", "Y"),
    ):
        made = derive(name, formulation)[0]
        text, latex = print_derivation(made), render_latex(made)
        assert f"  dt({letter}) = 1" in text and f"i_{letter} Omega = A_mu({letter}) eta_mu" in text
        assert re.search(r"In the general formulas [^.]*\bmu\b", text)
        assert f"a vector field ${letter}$ that" in latex and f"i_{letter} \\boldsymbol" in latex


def test_symbols_of_the_theory_give_way_to_names_of_the_spec() -> None:
    text = """nhc: 1
system: shared
coordinates: [x, y, theta]
parameters: {E: 2, U: 1, Q_x: 3, lambda_slip: 1, omega_slip: 1, m: 1}
T: m/2*(x'^2 + y'^2) + omega_slip*theta'^2/2
V: E*x + U*y
forces: {x: -Q_x*x' + lambda_slip}
constraints: [slip: -sin(theta)*x' + cos(theta)*y' = 0]
"""
    system = resolve(decode(Source("shared.yaml", text)))
    formulation = formulate(system)
    made = derivation(system, formulation, equations_of(system, formulation))
    plain, latex = print_derivation(made), render_latex(made)
    assert "  <U> = -E*x - U*y" in plain and "  <Q>_x = lambda_slip - Q_x*x'" in plain
    assert "<lambda>_slip = " in plain and "<omega>_slip" in plain
    assert (
        r"\mathcal{E} &= " in latex and r"\Lambda_{\mathit{slip}} &= " in latex and r"\varpi_{\mathit{slip}}" in latex
    )
    assert re.search(r"theory's are written\n  <U> +force function\n  <Q>_x +force of x\n", plain)
    assert r"$\Lambda_{\mathit{slip}}$ & reaction of slip \\" in latex and r"$\mathcal{E}$ & energy \\" in latex
    clean = print_derivation(derive("chaplygin_sleigh")[0])
    assert "<E>" not in clean and "the theory's" not in clean


@pytest.mark.parametrize("name", ["veselova", "n_trailer3", "rattleback", "bodies/car_trailer"])
def test_what_has_one_value_has_one_name(name: str) -> None:
    """Sums in another order, or products with other factors in front, are other nodes, which look the same on paper."""
    made, _ = derive(name)
    draw = random.Random(name)
    values = {symbol: draw.uniform(0.5, 1.5) for symbol in made.symbols if symbol not in made.lets}
    for key, statement in made.lets.items():
        ((right,),) = (statement.right,)
        values[key] = value(right.coefficient, values)
    own = [key for key, statement in made.lets.items() if re.fullmatch(r"[a-zA-Z]+\d+", key)]
    assert len(own) > 5 and len({f"{values[key]:.11e}" for key in own}) == len(own)
