"""Statements have the values of the nodes that they were lowered from."""

from __future__ import annotations

from fractions import Fraction

import mpmath
from hypothesis import given
from hypothesis import strategies as st

from nhc.algebra.evaluate import Mpmath, evaluate
from nhc.algebra.graph import Graph
from nhc.program.ir import (
    Argument,
    Function,
    Let,
    Load,
    Section,
    Store,
)
from nhc.program.lowering.lower import lower_function
from nhc.program.plan import FunctionPlan, Target
from tests.ir_values import value
from tests.property.expressions import NAMES, QUIET, Tree, build, rational_trees, smooth_trees

VALUES = (Fraction(3, 7), Fraction(-5, 4), Fraction(11, 9))


@QUIET
@given(st.lists(st.one_of(rational_trees, smooth_trees), min_size=1, max_size=4), st.sets(st.integers(0, 2)))
def test_statements_have_the_values_of_their_nodes(trees: list[Tree], constant: set[int]) -> None:
    """Any of the symbols may be parameters, whose work comes first; each result stands there with its sign and the other one."""
    g = Graph()
    symbols = [g.symbol(name) for name in NAMES]
    try:
        roots = [build(g, tree) for tree in trees]
        roots += [g.neg(node) for node in roots]
        values = {symbol: mpmath.mpf(v.numerator) / v.denominator for symbol, v in zip(symbols, VALUES, strict=True)}
        expected = evaluate(g, roots, values, Mpmath())
    except ZeroDivisionError:
        return
    for chosen in (roots, roots[: len(trees)], roots[len(trees) :]):
        function = lower_function(g, _plan(g, symbols, chosen), [symbols[k] for k in constant])
        for index, found in _run(function).items():
            wanted = expected[roots.index(chosen[index])]
            assert abs(found - wanted) <= 1e-12 * (1 + abs(wanted))


def test_a_quotient_of_parameters_keeps_its_sign() -> None:
    """Its constant factor stands inside it and has no name that could take the sign."""
    g = Graph()
    x, y, z = (g.symbol(name) for name in NAMES)
    root = g.neg(g.mul(g.number(Fraction(1, 100)), g.inverse(g.mul(x, y))))
    function = lower_function(g, _plan(g, [x, y, z], [root]), [x, y, z])
    assert abs(_run(function)[0] + 1 / (100 * float(VALUES[0] * VALUES[1]))) < 1e-12


def test_roots_of_squares_and_inverse_roots() -> None:
    """sqrt(x^2) is a magnitude; 1/u takes no division where 1/sqrt(u) is at hand."""
    g = Graph()
    x, y, z = (g.symbol(name) for name in NAMES)
    u = g.add(g.power(x, 2), g.power(z, 2))
    inverse = g.inverse(g.function("sqrt", u))
    roots = [g.function("sqrt", g.power(y, 2)), g.mul(x, inverse), g.mul(z, inverse), g.mul(y, g.inverse(u))]
    function = lower_function(g, _plan(g, [x, y, z], roots), [])
    a, b, c = (float(value) for value in VALUES)
    wanted = [abs(b), a / (a * a + c * c) ** 0.5, c / (a * a + c * c) ** 0.5, b / (a * a + c * c)]
    assert all(abs(found - wanted[k]) < 1e-14 for k, found in _run(function).items())
    assert function.divisions == 1 and function.calls == 2


def _plan(g: Graph, symbols: list[int], roots: list[int]) -> FunctionPlan:
    loads = {symbol: ("y", k, "") for k, symbol in enumerate(symbols)}
    targets = tuple(Target(k, node) for k, node in enumerate(roots))
    return FunctionPlan("f", "", "", (Argument("y", 3),), Argument("out", len(roots)), loads, targets)


def _run(function: Function) -> dict[int, mpmath.mpf]:
    names: dict[str, mpmath.mpf] = {}
    found = {}
    for statement in function.body:
        match statement:
            case Load():
                given_value = VALUES[statement.index]
                names[statement.name] = mpmath.mpf(given_value.numerator) / given_value.denominator
            case Let():
                names[statement.name] = value(statement.value, names, mpmath)
            case Store():
                found[statement.index] = value(statement.value, names, mpmath)
            case _:
                assert isinstance(statement, Section)
    return found
