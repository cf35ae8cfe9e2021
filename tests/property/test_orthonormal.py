"""Sums over the entries of rotations: as the matrices have them they keep their values, and they become as short as by hand."""

from __future__ import annotations

import random

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.orthonormal import Orthonormal
from nhc.algebra.walks import count
from nhc.mechanics.rotations.rotation import Rotation, make_rotation


class Setting:
    """Two rotations, their entries as symbols, and the rule."""

    def __init__(self) -> None:
        g = self.graph = Graph()
        self.rotations = [self._rotation(name) for name in "RS"]
        self.rows = [
            [[g.symbol(f"{r.name}{i}{j}", "entry") for j in range(3)] for i in range(3)] for r in self.rotations
        ]
        self.rule = Orthonormal(g, self.rows)
        pairs = zip(self.rows, self.rotations, strict=True)
        self.meaning = {
            symbol: node
            for rows, rotation in pairs
            for own, real in zip(rows, rotation.matrix, strict=True)
            for symbol, node in zip(own, real, strict=True)
        }

    def _rotation(self, name: str) -> Rotation:
        g = self.graph
        e = [g.symbol(f"{name}_{k}", "coordinate") for k in range(4)]
        v = [g.symbol(f"{name}_{k}", "velocity") for k in range(4)]
        return make_rotation(g, name, range(4), 1, e, v)

    def shorten(self, node: Node) -> Node:
        """By the rule; the value stays the same."""
        made = self.rule.shorten(node, lambda x: count(self.graph, [x]))
        real = [substitute(self.graph, [x], self.meaning, named=False)[0] for x in (node, made)]
        assert are_equal(self.graph, real[:1], real[1:])
        return made


def test_what_rows_and_columns_are() -> None:
    s = Setting()
    g, R = s.graph, s.rows[0]
    columns = [list(column) for column in zip(*R, strict=True)]
    w = [g.symbol(f"w{k}") for k in range(3)]
    for lines in (R, columns):
        for i in range(3):
            for j in range(3):
                assert s.shorten(g.dot(lines[i], lines[j])) == (g.one if i == j else g.zero)
    minor = g.sub(g.mul(R[0][0], R[1][1]), g.mul(R[0][1], R[1][0]))
    assert s.shorten(minor) == R[2][2]
    assert s.shorten(g.add(g.mul(R[0][0], R[0][1]), g.mul(R[1][0], R[1][1]))) == g.neg(g.mul(R[2][0], R[2][1]))
    square = g.sum(g.power(g.dot(row, w), 2) for row in R)  # |R w|^2
    assert s.shorten(square) == s.shorten(g.sum(g.power(x, 2) for x in w))
    turned = g.sum(g.mul(x, g.dot(row, w)) for x, row in zip(columns[0], R, strict=True))
    assert s.shorten(turned) == w[0]
    disc = g.add(g.power(R[0][0], 2), g.power(R[1][0], 2))
    assert s.shorten(disc) == g.sub(g.one, g.power(R[2][0], 2))


@pytest.mark.parametrize("seed", range(30))
def test_random_sums_keep_their_values(seed: int) -> None:
    s, draw = Setting(), random.Random(seed)
    g = s.graph
    vectors = [
        *(list(row) for rows in s.rows for row in rows),
        *(list(column) for rows in s.rows for column in zip(*rows, strict=True)),
        [g.symbol(f"w{k}") for k in range(3)],
        [g.symbol("a"), g.zero, g.number(2)],
    ]
    total = g.zero
    for _ in range(draw.randrange(2, 7)):
        x, y = draw.choice(vectors), draw.choice(vectors)
        factor = draw.choice([g.symbol("m"), *draw.choice(vectors)])
        term = g.mul(factor, g.dot(x, y)) if draw.random() < 0.6 else g.mul(g.mul(x[0], y[1]), g.sub(factor, x[2]))
        total = g.add(total, g.scale(draw.choice([1, -1, 2]), term))
    assert count(g, [s.shorten(total)]) <= count(g, [total])


def test_what_is_no_sum_of_entries_is_left() -> None:
    s = Setting()
    g, (R, S) = s.graph, s.rows
    for node in (
        g.add(g.mul(R[0][0], S[0][0]), g.mul(R[1][0], S[1][0])),  # of two rotations
        g.sum([g.mul(g.number(k + 1), g.power(x, 2)) for k, x in enumerate(R[0])]),  # with different factors
        g.add(g.mul(R[0][0], R[1][1]), g.mul(R[0][1], R[1][0])),  # no minor
    ):
        assert s.shorten(node) == node
