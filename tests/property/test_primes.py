"""Roots of constants exist in the fields that a graph is tested in."""

from __future__ import annotations

from itertools import combinations

import pytest
import sympy

from nhc.algebra.exact.draw import draw_points
from nhc.algebra.exact.field import PRIMES, FieldPoint
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.residues import FULL_TURN, part_of_turn
from nhc.algebra.graph import Graph, Node
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.properties.integrability import classify
from nhc.mechanics.resolving.resolve import resolve


def root(graph: Graph, number: int, node: Node | None = None) -> Node:
    """sqrt(number), or sqrt(number + node)."""
    known = graph.number(number)
    return graph.function("sqrt", known if node is None else graph.add(known, node))


@pytest.mark.parametrize("numbers", [(53,), (53, 59, 61, 67, 71), (97, 101, 103, 107, 109, 113), (10**9 + 7,)])
def test_square_roots_of_numbers_exist_modulo_all_primes_of_a_graph(numbers: tuple[int, ...]) -> None:
    g = Graph()
    roots = [root(g, number) for number in numbers]
    primes = primes_of(g)
    assert len(set(primes)) == len(PRIMES)
    for p in primes:
        assert p < 2**61
        assert sympy.isprime(p)
        assert sympy.isprime(p // 2)
        assert (p + 1) % FULL_TURN == 0
        assert all(sympy.ntheory.is_quad_residue(number, p) for number in numbers)
        assert [x * x % p for x in FieldPoint(g, 3, p).evaluate(roots)] == list(numbers)
        c, s = part_of_turn(FULL_TURN // 8, p)
        assert (c * c + s * s) % p == 1
        assert 2 * c * c % p == 1


def test_nested_roots_exist_and_multiply() -> None:
    """sqrt(9 + sqrt(53)) sqrt(9 - sqrt(53)) = sqrt(28) and not its negative."""
    g = Graph()
    inner = root(g, 53)
    product = g.mul(root(g, 9, inner), root(g, 9, g.neg(inner)))
    assert are_zero(g, [g.sub(product, root(g, 28)), g.add(product, root(g, 28))]) == [True, False]


def test_sines_of_inverse_functions_are_the_roots_that_they_are() -> None:
    """cos(atan(1/10)) = 10/sqrt(101), sin(2 asin(31/100)) = 62 sqrt(9039)/10000."""
    g = Graph()
    flat = g.function("cos", g.function("atan", g.div(g.one, g.number(10))))
    steep = g.function("sin", g.mul(g.number(2), g.function("asin", g.div(g.number(31), g.number(100)))))
    others = [g.div(g.number(10), root(g, 101)), g.div(g.mul(g.number(62), root(g, 9039)), g.number(10_000))]
    assert are_zero(g, [g.sub(flat, others[0]), g.sub(steep, others[1])]) == [True, True]


def test_a_graph_without_such_constants_keeps_the_primes() -> None:
    g = Graph()
    root(g, 47, g.symbol("x"))
    root(g, 30)
    assert primes_of(g) == PRIMES
    root(g, 53)
    assert primes_of(g) != PRIMES


@pytest.mark.parametrize(("kind", "drawn"), [("products", True), ("symbols", True), ("sums", False)])
def test_roots_are_too_many_where_they_are_independent(kind: str, drawn: bool) -> None:
    """Where x and y are squares x y is one: of 21 products of 6 symbols 6 are left to hope for, and each of 21 symbols is drawn by
    itself; but that x + 1, ..., x + 21 are squares hangs on a single one.
    """
    g = Graph()
    x = [g.symbol(f"x{k}") for k in range(21)]
    radicands = {
        "products": [*x[:6], *(g.mul(a, b) for a, b in combinations(x[:6], 2))],
        "symbols": x,
        "sums": [g.add(x[0], g.number(k)) for k in range(1, 22)],
    }[kind]
    assert len(radicands) == 21
    points = draw_points(g, [g.function("sqrt", radicand) for radicand in radicands], PRIMES[0], range(2000))
    assert (next(points, None) is not None) is drawn


ROOTS = ("sqrt(53)", "sqrt(1.37)", "sqrt(3 + sqrt(2))", "sqrt(sqrt(103) - sqrt(101))", "5.9^1.5")
ANGLES = (
    "cos(atan(0.1))",
    "sin(1 + x/9 + asin(0.31))^2",
    "sin(2*atan2(1, 7.3))",
    "(1 + cos(acos(0.3)))",
    "sin(atan(sqrt(5.9)))",
)


@pytest.mark.parametrize("number", [*ROOTS, *ANGLES])
def test_specs_with_roots_of_numbers_are_tested_exactly(number: str) -> None:
    """Every second of these was refused: the exact test found no point where the root exists."""
    text = f"""\
nhc: 1
system: test
coordinates: [x, y, z]
T: (x'^2 + {number}*y'^2 + z'^2)/2
V: x^2
constraints:
  - z' = {number}*y*x' + k*x*y'
parameters: {{k: 2}}
"""
    system = resolve(decode(Source("test.yaml", text)))
    assert classify(system).growth == (2, 3)
    assert all(entry.accelerations for entry in certify(system).agreements)
