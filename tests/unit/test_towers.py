"""Short texts with long consequences: towers of powers, dozens of nested roots."""

from __future__ import annotations

import math
from fractions import Fraction

import mpmath
import pytest

from nhc.algebra.evaluate import Mpmath, evaluate
from nhc.algebra.graph import Graph
from nhc.diagnostics import Source, SpecError
from nhc.pipeline import Options, check, emit
from tests.support import python_model


def spec(force: str) -> Source:
    text = f'nhc: 1\nsystem: deep\ncoordinates: [x]\nT: "x\'^2/2"\nforces:\n  x: "{force}"\n'
    return Source("deep.yaml", text)


@pytest.mark.parametrize("text", ["(" * 20 + "3" + "^2)" * 20, "((9^999)^999)^999", "(2*x)^1000 * (2^1000)^999"])
def test_long_constants_are_refused(text: str) -> None:
    with pytest.raises(SpecError) as caught:
        check(spec(text))
    assert {d.code for d in caught.value.diagnostics} == {"E0210"}


def test_nested_roots_are_compiled() -> None:
    text = "x"
    for _ in range(50):
        text = f"sqrt(1 + {text})"
    assert any("not decided" in fact for fact in check(spec(text)).facts)
    for language in ("c", "python", "latex"):
        assert emit(spec(text), language, Options())


@pytest.mark.parametrize("text", ["10^400", "2^2000", "10^(-400)"])
def test_constants_that_no_double_holds_are_refused(text: str) -> None:
    with pytest.raises(SpecError) as caught:
        check(spec(f"{text}*x"))
    assert {d.code for d in caught.value.diagnostics} == {"E0210"}


@pytest.mark.parametrize("text", ["sqrt(-3)", "(-1)^0.5", "log(0)", "asin(2)", "exp(1000)", "sqrt(2 - 5) + 1"])
def test_constants_without_a_value_are_refused(text: str) -> None:
    """The good terms beside them were once dropped with them."""
    with pytest.raises(SpecError) as caught:
        check(spec(f"({text})*x + x"))
    assert {d.code for d in caught.value.diagnostics} == {"E0313"}


@pytest.mark.parametrize("count", [9, 12, 14])
def test_many_roots_are_not_taken_for_zero(count: int) -> None:
    """A point of the field has all of them at one of 2^count draws, and most real points have none."""
    force = " + ".join(f"sqrt(x - {k + 5})" for k in range(count))
    module = python_model(emit(spec(force), "python", Options())["deep.py"], "deep")
    found = module.rhs(0.0, [30.0, 0.0])[1]
    assert found == pytest.approx(sum(math.sqrt(25 - k) for k in range(count)), rel=1e-14)


@pytest.mark.parametrize("help", ["`sin(x)`", "`sin(x)^2`", "`1/tan(x)`", "`dot(x)`"])
def test_what_was_meant_by_a_function(help: str) -> None:
    text = {"`sin(x)`": "sin x", "`sin(x)^2`": "sin^2(x)", "`1/tan(x)`": "cot(x)", "`dot(x)`": "dot x"}[help]
    with pytest.raises(SpecError) as caught:
        check(spec(text))
    assert [d.help for d in caught.value.diagnostics] == [(f"write {help}",)]


@pytest.mark.parametrize("exponent", ["n", "(3/7)", "x"])
def test_powers_that_are_not_real_everywhere_are_compiled(exponent: str) -> None:
    """Sample points lie on both sides of zero, and Python's own power of a negative number is complex."""
    text = "nhc: 1\nsystem: deep\ncoordinates: [x, y]\nparameters: {m: 1, n: 1.5}\n"
    source = Source("deep.yaml", f"{text}T: m/2*(x'^2 + y'^2*(2 + y^{exponent}))\n")
    assert not check(source).diagnostics
    assert emit(source, "c", Options())


def test_angles_of_what_is_not_real_are_refused() -> None:
    """mpmath's roots of negative numbers are complex, and its angle of them was an AttributeError."""
    graph = Graph()
    x = graph.symbol("x")
    angle = graph.function("atan2", graph.one, graph.function("powf", x, graph.number(Fraction(1, 4))))
    with pytest.raises(ValueError, match="not real"):
        evaluate(graph, [angle], {x: mpmath.mpf(-2)}, Mpmath())
    assert evaluate(graph, [angle], {x: mpmath.mpf(1)}, Mpmath())[0] == pytest.approx(math.pi / 4)
