"""Expressions inside of sentences: their LaTeX, and that pdflatex would accept its braces."""

from __future__ import annotations

import pytest

from nhc.emit.latex.inline import print_inline
from nhc.emit.latex.names import PLAIN, Names

CASES = {
    "theta*b - r*(p_R - p_L)/2 = const": r"$\theta\,b - r\,(p_{R} - p_{L})/2 = \text{const}$",
    "y'^2 + x'^2": r"$\dot{y}^{2} + \dot{x}^{2}$",
    "E - Omega0 (x p_y - y p_x)": r"$E - \Omega_{0}\,(x\,p_{y} - y\,p_{x})$",
    "p*_v^2": r"${p^{*}_{v}}^{2}$",
    "dT/dx' + 2 y": r"$\partial T/\partial \dot{x} + 2\,y$",
    "x^(a + 1)*sqrt(1 + x^2)": r"$x^{a + 1}\,\sqrt{1 + x^{2}}$",
    "x^-1 - cos(2*phi)": r"$x^{-1} - \cos(2\,\varphi)$",
    "l*cos(a) - cos(b)^2 + sin(a) cos(b)": r"$l\,\cos a - \cos^{2} b + \sin a\,\cos b$",
    "cos(a)*b + sin(a) b' + cos(b)/2": r"$\cos(a)\,b + \sin(a)\,\dot{b} + \cos(b)/2$",
    "cos(a)^n*cos(b)*(a + 1) + sqrt(sin(a))": r"$\cos(a)^{n}\,\cos(b)\,(a + 1) + \sqrt{\sin a}$",
    "log(x)/…": r"$\ln(x)/\dots$",
    "(2, 3)": "$(2, 3)$",
}


@pytest.mark.parametrize("text", CASES)
def test_an_expression_inside_a_sentence(text: str) -> None:
    assert print_inline(text, PLAIN) == CASES[text]


def test_names_are_those_of_the_document() -> None:
    names = Names({"x_1": (r"\mathtt{x\_1}", ())})
    assert print_inline("x_1' + x1", names) == r"$\dot{\mathtt{x\_1}} + x_{1}$"


def test_a_momentum_has_the_name_of_its_coordinate_below() -> None:
    names = Names({}, ("rider_x", "phi_1", "p_0"))
    assert print_inline("p_rider_x + p_phi_1 - p_0", names) == r"$p_{\mathit{rider}\,x} + p_{\varphi_{1}} - p_{0}$"


@pytest.mark.parametrize("text", ["50 % of x", "a & b", r"x\y", "$"])
def test_what_is_no_expression_stays_text(text: str) -> None:
    shown = print_inline(text, PLAIN)
    assert not shown.startswith("$")
    assert shown.count("{") == shown.count("}")


@pytest.mark.parametrize("text", ["sqrt(x", "x^(2", "x^", "(", "x)", "^2", "sqrt"])
def test_what_is_cut_short_has_balanced_braces(text: str) -> None:
    shown = print_inline(text, PLAIN)
    assert shown.count("{") == shown.count("}")
