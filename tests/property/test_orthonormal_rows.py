"""Three rows at right angles are solved by their transpose, whatever stands in front of them, and others are not."""

from __future__ import annotations

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph, Node
from nhc.algebra.solving.blocks import solve_block
from nhc.algebra.solving.orthonormal import solve_orthonormal


def rows_of(g: Graph) -> list[list[Node]]:
    """Down, around and out of a sphere."""
    (a, b) = (g.symbol(name, "coordinate") for name in "ab")
    (s, c), (u, v) = ((g.function("sin", x), g.function("cos", x)) for x in (a, b))
    return [
        [g.mul(c, v), g.mul(c, u), g.neg(s)],
        [g.neg(u), v, g.zero],
        [g.mul(s, v), g.mul(s, u), c],
    ]


FACTORS = (("1", "1", "1"), ("k", "2", "1"), ("k", "r", "k"), ("-3", "x", "1"))


@pytest.mark.parametrize("names", FACTORS)
def test_rows_with_factors(names: tuple[str, str, str]) -> None:
    g = Graph()
    kinds = {"k": "parameter", "r": "parameter", "x": "coordinate"}
    factors = [g.symbol(name, kinds[name]) if name in kinds else g.number(int(name)) for name in names]
    block = [[g.mul(f, x) for x in row] for f, row in zip(factors, rows_of(g), strict=True)]
    right = [g.symbol(f"f{k}", "parameter") for k in range(3)]
    found = solve_orthonormal(g, block, [right], None)
    assert found is not None
    (solved,), guards = found
    assert are_equal(g, [g.dot(row, solved) for row in block], right)
    product = g.product(factors)
    squares = [(g.power(guard, 2), g.power(product, 2)) for guard, _ in guards]
    assert bool(guards) == (g.value(product) is None)
    for own, wanted in squares:
        assert g.value(g.div(own, wanted)) is not None


def test_what_cancels_is_seen() -> None:
    """Entries as rolling along tangents leaves them: a sin(a) sin(b) sin(a) + a cos(a) sin(b) cos(a) is a sin(b)."""
    g = Graph()
    (down, around, out), k = rows_of(g), g.symbol("k", "parameter")
    written = [g.sub(g.mul(k, g.mul(x, down[0])), g.zero) for x in down]
    squares = g.add(g.power(down[0], 2), g.add(g.power(down[1], 2), g.power(down[2], 2)))
    long = [g.mul(k, g.mul(squares, x)) for x in around]
    right = [g.symbol(f"f{i}", "parameter") for i in range(3)]
    found = solve_orthonormal(g, [written, long, out], [right], None)
    assert found is not None
    assert are_equal(g, [g.dot(row, found[0][0]) for row in (written, long, out)], right)


def test_rows_that_lean_or_grow_are_solved_as_others() -> None:
    g = Graph()
    down, around, out = rows_of(g)
    right = [g.symbol(f"f{k}", "parameter") for k in range(3)]
    for block in (
        [down, around, [g.add(x, y) for x, y in zip(out, down, strict=True)]],
        [down, around, [g.one, g.zero, g.zero]],
    ):
        assert solve_orthonormal(g, block, [right], None) is None
        (solved,), _ = solve_block(g, block, [right])
        assert are_equal(g, [g.dot(row, solved) for row in block], right)
