"""Floats with bounds say that something is not zero, or independent, only where it is."""

from __future__ import annotations

import random

import pytest

from nhc.algebra.exact.field import FieldPoint
from nhc.algebra.exact.modular import rank
from nhc.algebra.graph import Graph, Node
from nhc.algebra.probe import Probe


@pytest.mark.parametrize("power", range(12, 30))
def test_what_rounding_makes_independent(power: int) -> None:
    """a and (a + e^(power + b)) - e^power e^b are the same; in floats they differ by more than what counts as a pivot elsewhere."""
    g = Graph()
    a, b, c = (g.symbol(name, "coordinate") for name in "abc")
    large = g.function("exp", g.add(g.number(power), b))
    same = g.sub(g.add(a, large), g.mul(g.function("exp", g.number(power)), g.function("exp", b)))
    assert not Probe(g).has_full_rank([[a, c], [same, c]])
    assert rank(g, [[a, c], [same, c]]) == 1
    assert rank(g, [[a, c], [same, g.add(b, c)]]) == 2


@pytest.mark.parametrize("seed", range(60))
def test_dependent_rows(seed: int) -> None:
    """The last row is a combination of the others, written in another way, with magnitudes from 1e-9 to 1e9."""
    rng, g = random.Random(seed), Graph()
    size = rng.randrange(2, 7)
    symbols = [g.symbol(f"x{k}", "coordinate") for k in range(6)]

    def entry() -> Node:
        scale = g.number(10 ** rng.randrange(10))
        scale = scale if rng.random() < 0.5 else g.inverse(scale)
        angle = g.sum([g.mul(g.number(rng.randrange(1, 9)), x) for x in rng.sample(symbols, 2)])
        return g.mul(scale, g.add(g.power(g.function("sin", angle), rng.randrange(1, 4)), rng.choice(symbols)))

    rows = [[entry() for _ in range(size)] for _ in range(size - 1)]
    weights = [entry() for _ in rows]
    whole = g.sum(weights)
    last = []
    for column in zip(*rows, strict=True):
        first = g.sum([g.mul(g.sub(w, whole), x) for w, x in zip(weights, column, strict=True)])
        last.append(g.add(first, g.sum([g.mul(whole, x) for x in column])))
    probe = Probe(g)
    assert not probe.has_full_rank([*rows, last])
    assert rank(g, [*rows, last]) <= size - 1
    point = FieldPoint(g, seed)
    clear = [x for row in (*rows, last) for x in row if probe.is_clear(x)]
    assert all(point.evaluate(clear))
