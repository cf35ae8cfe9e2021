"""Brackets with one field along a path that it leads: whether they fill the space.

Along dx/ds = G(x), where G is a combination of the fields with random constants, [G, W] = dW/ds - DG W.  So the brackets
ad_G^k V at the start of the path follow from the series of V along it by k derivatives and products with the Jacobian
matrix DG, of which only its product with a vector is formed.  Those of all fields but one are enough, for G has no bracket with
itself.  A number holds all coefficients of a series, one after another, so that a product of series is one of numbers
(Kronecker 1882).  How many brackets are needed is not known: a few are tried, then as many as they promise.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from nhc.algebra.calculus import tangent
from nhc.algebra.dense import Echelon, extend_echelon, pack, unpack
from nhc.algebra.exact.field import FieldPoint
from nhc.algebra.exact.jets import WIDTH, Jets, Series, make_box, plan_jets
from nhc.algebra.graph import ADD, MUL, Graph, Node
from nhc.mechanics.properties.backwards import LinearSteps

_FIRST = 4  # terms of the first series

Field = tuple[Node, ...]


class Forwards:
    """``mixed`` is the combination of the fields, whose weights are symbols without a derivative."""

    def __init__(self, graph: Graph, variables: Sequence[Node], fields: Sequence[Field], mixed: Field) -> None:
        self.graph, self.variables, self.fields, self.mixed = graph, tuple(variables), tuple(fields), mixed
        held = [graph.symbol(f"column {k}", "other") for k in range(len(variables))]
        self.linear = LinearSteps(graph, tangent(graph, mixed, dict(zip(variables, held, strict=True))), held)
        entries = [x for field in (*self.fields, mixed) for x in field]
        self.plan = plan_jets(graph, [*entries, *self.linear.factors], self.variables)

    def fills(self, point: FieldPoint) -> bool:
        """Whether the brackets of the mixed field with the fields span as many directions as there are variables.

        Raises:
            Unlucky: the point lies on a pole.
        """
        terms, size = _FIRST, len(self.variables)
        while True:
            terms = min(terms, size)
            ranks = self._span(point, terms)
            grows = len(ranks) == 1 or ranks[-1] > ranks[-2]
            if ranks[-1] == size or not grows or terms == size:
                return ranks[-1] == size
            last = ranks[-1] - (ranks[-2] if len(ranks) > 1 else 0)
            terms = max(2 * terms, terms + -(-(size - ranks[-1]) // last))

    def _span(self, point: FieldPoint, terms: int) -> list[int]:
        """The ranks that brackets of one field, of up to two and so on have, until they fill the space or do not grow."""
        rows: Echelon = []
        jets, ranks = self._follow(point, terms), list[int]()
        lifts = self.linear.lifts(terms, point.prime)
        vectors = [[jets.series[entry][0] for entry in field] for field in self.fields]
        packed = {y: pack(jets.series[y][0], WIDTH) for y in self._turning}
        for count in range(terms, 0, -1):
            for vector in vectors:
                extend_echelon(rows, [series[0] for series in vector], point.prime)
            ranks.append(len(rows))
            if len(rows) == len(self.variables) or ranks[-2:] == [len(rows)] * 2:
                break
            if count > 1:
                vectors = [
                    self._bracket(vector, packed, lifts, jets, count) for vector in vectors[: len(self.fields) - 1]
                ]
        return ranks

    @cached_property
    def _turning(self) -> list[Node]:
        """The factors that change along the path."""
        moving = self.graph.mask(self.variables)
        return [y for y in self.linear.factors if self.graph.deps[y] & moving]

    def _follow(self, point: FieldPoint, terms: int) -> Jets:
        """The series of everything along the path from the point."""
        place: list[Series] = [[[x]] for x in point.evaluate(self.variables)]
        jets = Jets(self.plan, point, place, make_box(()))
        jets.extend(0)
        for k in range(1, terms):
            scale = pow(k, -1, point.prime)
            for own, node in zip(place, self.mixed, strict=True):
                own[0].append(jets.series[node][0][k - 1] * scale % point.prime)
            jets.extend(k)
        return jets

    def _bracket(
        self,
        vector: Sequence[Sequence[int]],
        packed: dict[Node, int],
        lifts: dict[Node, int],
        jets: Jets,
        count: int,
    ) -> list[list[int]]:
        """dW/ds - DG W, of one term less than the ``count`` of W."""
        linear, prime, left = self.linear, jets.prime, count - 1
        lowest = (1 << 8 * WIDTH * left) - 1
        values = {
            symbol: pack(series[:left], WIDTH) if any(series) else 0
            for symbol, series in zip(linear.held, vector, strict=True)
        }
        for kind, node, x, y in linear.steps:
            own = values[x]
            if kind == MUL:
                factor = packed.get(y)
                made = own * jets.values[y] if factor is None else (own * (factor & lowest)) & lowest
            elif kind == ADD:
                made = own + values[y]
            else:
                made = (lifts[node] - own) & lowest if own else 0
            if made and node in linear.squeezed:
                made = pack([c % prime for c in unpack(made, left, WIDTH)], WIDTH)
            values[node] = made
        found = []
        for series, root in zip(vector, linear.roots, strict=True):
            slope = [(k + 1) * c for k, c in enumerate(series[1:])]
            number = values.get(root, 0)
            turned = unpack(number, left, WIDTH) if number else [0] * left
            found.append([(a - b) % prime for a, b in zip(slope, turned, strict=True)])
        return found
