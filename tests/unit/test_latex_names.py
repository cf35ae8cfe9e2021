"""Names in LaTeX: no two look alike, and none is too long for a line."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from nhc.emit.latex import render
from nhc.emit.latex.math import LatexMath
from nhc.emit.latex.names import WIDEST, name_document
from nhc.emit.latex.spelling import count_shown, escape, escape_breakable, escape_exactly, split_shown
from nhc.emit.latex.width import estimate
from nhc.emit.layout import LAST, Piece, fill
from nhc.emit.text import print_derivation
from nhc.language import Source
from nhc.program.ir import Binary, Expr, Ref
from nhc.program.paper import Derivation, Mark
from nhc.program.sheets.model import Symbol
from tests.unit.test_latex import check_clean, compile_document, derive

LATEX = shutil.which("pdflatex")
ALIKE = """nhc: 1
system: alike
coordinates: [x1, x_1, y_, y]
parameters: {I_a: 1, I__a: 2, theta_1: 1, theta1: 2, A: 3, Alpha: 2, omicron: 1, o: 1, a_b_c: 1, a_b__c: 3, dy: 2, z_1: 1, m: 1}
T: (I_a*x1'^2 + I__a*x_1'^2 + z_1*m*y_'^2*(theta_1*sin(y)^2 + theta1 + omicron + o + Alpha*A) + y'^2*(a_b_c + a_b__c + dy))/2
constraints: [slip: "x1' - sin(x_1)*y_' = 0", slip_: "y' - dy*sin(x1)*x_1' = 0"]
"""
LONG = """nhc: 1
system: long
about: A cart whose names are those of a program, with a_name_that_is_quite_long_and_then_goes_on_without_any_blank_at_all.
coordinates: {cart_position: {unit: m}, pendulum_angle: {unit: rad}, second_pendulum_angle: {unit: rad}}
parameters: {cart_mass_including_motor: 1, pendulum_moment_of_inertia: 2, pendulum_arm_length: 3, second_moment_of_inertia: 2,
  MANY: 1, жёлтые_шары: 0.1}
T: cart_mass_including_motor*cart_position'^2/2 + pendulum_moment_of_inertia*pendulum_angle'^2/2
  + cart_mass_including_motor*pendulum_arm_length*cos(pendulum_angle)*cart_position'*pendulum_angle'
  + second_moment_of_inertia*second_pendulum_angle'^2*(1+sin(pendulum_angle)^2)
V: cart_mass_including_motor*MANY*жёлтые_шары*pendulum_arm_length*cos(pendulum_angle)
constraints: [a_constraint_with_a_name_that_nobody_would_like: "second_pendulum_angle' = sin(pendulum_angle)*cart_position'"]
""".replace("MANY", "many" * 250)


def load(text: str, formulation: str = "") -> Derivation:
    return derive(Source("names.yaml", text), formulation)


def look(text: str) -> str:
    """What is seen by a reader who does not tell upright from italic."""
    return re.sub(r"\\math(?:rm|it)", "", text).replace("{", "").replace("}", "")


def test_indices_of_the_forms_are_no_names() -> None:
    """`d` is set apart from the differential's d; the d of Omega_d is that of the thesis (dynamic), and stays."""
    text = (
        "nhc: 1\nsystem: apart\ncoordinates: [x, y]\nparameters: {d: 1, c: 2, r: 3}\nV: d*x*c*r\nT: (x'^2 + d*y'^2)/2\n"
    )
    page = render(load(text))
    assert r"\mathtt{d}" in page
    assert r"\boldsymbol{\Omega}_{c} &=" in page
    assert r"\boldsymbol{\Omega}_{d} &=" in page


def test_no_two_names_look_alike() -> None:
    made = load(ALIKE)
    spec = made.system.spec
    names = [entry.name for group in (spec.coordinates, spec.parameters) for entry in group]
    spelling = name_document(made)
    assert len({look(spelling.print_mark(Mark(name))) for name in names}) == len(names)
    constraints = [spelling.print_mark(Mark("lambda", (form.name,))) for form in made.system.constraints]
    assert len({look(text) for text in constraints}) == 2
    for name, wanted in (
        ("x1", "x_{1}"),
        ("x_1", r"\mathtt{x\_1}"),
        ("y", "y"),
        ("y_", r"\mathtt{y\_}"),
        ("A", "A"),
        ("Alpha", r"\mathtt{Alpha}"),
        ("dy", r"\mathtt{dy}"),
        ("m", "m"),
    ):
        assert spelling.print_mark(Mark(name)) == wanted
    assert spelling.print_mark(Mark("x_1", dots=1, prefix="d")) == r"d\dot{\mathtt{x\_1}}"


def test_what_is_set_in_another_way_is_listed() -> None:
    text = render(load(ALIKE))
    listed = text[text.index("They are written so:") : text.index(r"\section{")]
    for row in (
        r"$x_{1}$ & x1 \\",
        r"$\mathtt{x\_1}$ & x\_1 \\",
        r"$\mathtt{slip\_}$ & slip\_ \\",
        r"$\mathtt{dy}$ & dy \\",
    ):
        assert row in listed
    assert "$m$" not in listed


def test_nhc_s_letters_are_none_of_the_spec_s() -> None:
    """An abbreviation z_1 beside the parameter, and the second name of a determinant."""
    made = load(ALIKE.replace("z_1", "z__1"))
    assert made.lets and not any(name.startswith("z") for name in made.lets)
    taken = load(ALIKE.replace("dy", "Delta").replace("y' - Delta", "(2 + sin(x1))*y' - Delta"))
    assert r"\mathcal{D} &= " in render(taken) and "<Delta> = " in print_derivation(taken)


def test_a_capital_of_two_alphabets_is_taken() -> None:
    assert r"\mathcal{E} &= " in render(load(ALIKE.replace("Alpha", "Epsilon")))


def test_greek_with_accents_keeps_them_in_the_list() -> None:
    assert escape_exactly("ά") == r"\textless{}U+03AC\textgreater{}"
    assert escape_exactly("с") == r"\textless{}U+0441\textgreater{}"
    assert escape_exactly("x_ø") == r"x\_\o{}"


def test_long_names_get_a_number() -> None:
    spelling = name_document(load(LONG))
    long = "many" * 250
    assert spelling.print_mark(Mark(long)) == r"\mathit{manymanymany}_{\langle 1\rangle}"
    assert long in spelling.listed
    assert max(estimate(spelling.print_mark(Mark(name))) for name in spelling.names) <= WIDEST


def test_a_line_of_a_product_ends_between_factors_where_there_is_no_other_place() -> None:
    factors = [Ref(f"{letter}_{'n' * 12}_{'o' * 12}") for letter in "abcdefgh"]
    product: Expr = factors[0]
    for factor in factors[1:]:
        product = Binary("*", product, factor)
    symbols = {factor.name: Symbol(Mark(factor.name), k) for k, factor in enumerate(factors)}
    lines = fill(LatexMath(symbols).pieces(product), 388.0, 364.0)
    assert len(lines) > 1 and max(map(estimate, lines)) <= 388.0
    assert all(line.startswith(r"\cdot ") for line in lines[1:])
    assert fill([Piece("a", 5), Piece("*", 5, LAST, "."), Piece("b", 5), Piece("+c", 5, 1)], 15, 15) == ["a*b", "+c"]


def test_long_words_in_texts_may_be_broken() -> None:
    text = escape_breakable("see " + "x" * 60)
    assert text.replace(r"\allowbreak{}", "") == "see " + "x" * 60 and text.count(r"\allowbreak{}") == 5
    assert count_shown("雪x") == 9


if LATEX is not None:

    @pytest.mark.parametrize("formulation", ["", "multipliers", "voronec"])
    @pytest.mark.parametrize("text", [ALIKE, LONG])
    def test_pdflatex_runs_clean_on_all_names(text: str, formulation: str, tmp_path: Path) -> None:
        check_clean(compile_document(render(load(text, formulation)), tmp_path))


def test_digits_of_other_scripts(tmp_path: Path) -> None:
    """A name may hold them; the fonts do not."""
    text = "nhc: 1\nsystem: digits\ncoordinates: [x, x\u0661, y_\u0967]\nT: (x'^2 + x\u0661'^2 + y_\u0967'^2*(2 + sin(x)))/2\n"
    document = render(derive(Source("digits.yaml", text)))
    body = document.partition("begin{document}")[2]
    assert all(c.isascii() or not c.isdigit() for line in body.splitlines() if "%" not in line for c in line)
    if LATEX:
        check_clean(compile_document(document, tmp_path))


def test_a_name_that_is_the_d_of_differentials_is_set_apart() -> None:
    """d times the velocity x' is no differential."""
    text = "nhc: 1\nsystem: case\ncoordinates: [x, y]\nparameters: {d: 2}\nT: (x'^2 + d*x'*y' + y'^2)/2\n"
    text = render(load(text + "constraints: [s: y' - d*sin(x)*x' = 0]\n", "voronec"))
    assert r"\mathtt{d}\,\dot{x}" in text and r"d\dot{x}" in text and r" d\,\dot{x}" not in text
    assert r"$\mathtt{d}$ & d" in text[text.index("They are written so:") :]


def test_options_and_quotes_are_no_ligatures() -> None:
    assert escape("nhc check --explain, x'' and a,,b ---") == "nhc check -{}-explain, x'{}' and a,{},b -{}-{}-"
    assert escape_breakable("it''s") == "it'{}'s"
    assert "".join(split_shown("--" * 9, 4)).replace("{}", "") == "--" * 9
    assert "--" not in r"\allowbreak{}".join(split_shown("--" * 9, 4))


def test_no_parameter_looks_like_a_function() -> None:
    """`sin_` beside x would be a sine of x."""
    text = "nhc: 1\nsystem: s\ncoordinates: [x]\nparameters: {sin_: 1, log_: 2, ln: 3}\nT: x'^2/2\n"
    page = render(load(f"{text}V: sin_*x^2/2 + sin(x)*log_ + x*ln\n"))
    for name in (r"sin\_", r"log\_", "ln"):
        assert rf"\mathtt{{{name}}}" in page
    assert not re.search(r"\\mathit\{(?:sin|log|ln)\}", page)
