"""A matrix of series times the Jacobian matrix of a field, by one reverse sweep over the field in place of the matrix' entries.

Row vectors are carried along a path by the field's Jacobian matrix.  All its entries, n^2 for a chain of n bodies, stand in fields
that have a few nodes for each body, so all rows go through these together: a number holds a coefficient of all rows, one after
another (Kronecker 1882).
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul

from nhc.algebra.calculus import pullback_gradient
from nhc.algebra.dense import pack, unpack
from nhc.algebra.exact.jets import WIDTH, Box, Jets, Series
from nhc.algebra.graph import ADD, MUL, NEG, Graph, Node
from nhc.algebra.walks import reachable

_WIDEST = 76
"""Bits of a factor's entries: a sum of two times 2^20 products with residues is less than 256^WIDTH."""
_RESIDUE, _SUM = 61, 20


class LinearSteps:
    """How roots that are linear in ``held`` symbols are computed where a number stands for each of these, many entries one after
    another; ``factors`` are the nodes that they are multiplied with.
    """

    def __init__(self, graph: Graph, roots: Sequence[Node], held: Sequence[Node]) -> None:
        self.graph, self.roots, self.held = graph, list(roots), list(held)
        mask, deps = graph.mask(self.held), graph.deps
        self.steps: list[tuple[str, Node, Node, Node]] = []
        self.bits, self.squeezed = dict.fromkeys(self.held, _RESIDUE), set[Node]()
        factors = dict[Node, None]()
        for node in reachable(graph, [root for root in self.roots if deps[root] & mask], mask):
            kind, x, y = graph.op[node], graph.a[node], graph.b[node]
            if node in self.bits:
                continue
            if kind == MUL:
                x, y = (x, y) if deps[x] & mask else (y, x)
                factors[y] = None
                self._narrow(x)
                self.bits[node] = self.bits[x] + _RESIDUE + _SUM
            elif kind == ADD:
                self.bits[node] = max(self.bits[x], self.bits[y]) + 1
            else:
                assert kind == NEG, f"a linear form has no `{kind}`"
                y = x
                self.bits[node] = self.bits[x] + 1
            self.steps.append((kind, node, x, y))
            if self.bits[node] > 8 * WIDTH - 2:
                self._narrow(node)
        self.factors = tuple(factors)

    def _narrow(self, node: Node) -> None:
        """Its entries are brought below the prime where they are made."""
        if self.bits[node] > _WIDEST:
            self.squeezed.add(node)
            self.bits[node] = _RESIDUE

    def lifts(self, size: int, prime: int) -> dict[Node, int]:
        """For what is a negative: multiples of the prime in each of ``size`` entries from which it is taken."""
        ones = pack([1] * size, WIDTH)
        return {
            node: ones * (prime << max(self.bits[x] - prime.bit_length() + 1, 0))
            for kind, node, x, _ in self.steps
            if kind == NEG
        }


class Backwards(LinearSteps):
    """The sweep; ``factors`` are the nodes whose series it takes, ``held`` the symbols of a row's entries."""

    def __init__(self, graph: Graph, field: Sequence[Node], variables: Sequence[Node]) -> None:
        held = [graph.symbol(f"row {k}", "other") for k in range(len(variables))]
        super().__init__(graph, pullback_gradient(graph, list(zip(field, held, strict=True)), variables), held)


class Sweep:
    """The sweep along one path: ``rows`` are the series of each column of the matrix, to which terms are added from outside."""

    def __init__(self, plan: Backwards, jets: Jets, rows: Sequence[Series], box: Box, moving: int) -> None:
        self.plan, self.box, self.prime, self.size = plan, box, jets.prime, len(rows)
        self.series: dict[Node, Series] = dict(zip(plan.held, rows, strict=True))
        self.series |= {node: [[] for _ in box.parts] for _, node, _, _ in plan.steps}
        graph, values = plan.graph, jets.values
        self.jets = {y: jets.series[y] for y in plan.factors if graph.deps[y] & moving}
        self.still = {y: values[y] for y in plan.factors if y not in self.jets}
        self.lifts = plan.lifts(self.size, jets.prime)

    def extend(self, k: int) -> list[list[list[int]]]:
        """The coefficients of z^k of the matrix times each column of the Jacobian matrix: by column, monomial and row."""
        series, lifts, squeezed = self.series, self.lifts, self.plan.squeezed
        for kind, node, x, y in self.plan.steps:
            own, made = series[x], series[node]
            if kind == MUL:
                factor = self.jets.get(y)
                if factor is None:
                    found = [self.still[y] * powers[k] for powers in own]
                else:
                    found = [sum(sum(map(mul, own[i], factor[j][k::-1])) for i, j in pairs) for pairs in self.box.parts]
            elif kind == ADD:
                found = [a[k] + b[k] for a, b in zip(own, series[y], strict=True)]
            else:
                found = [lifts[node] - a[k] if a[k] else 0 for a in own]
            for powers, number in zip(made, found, strict=True):
                powers.append(pack(self._residues(number), WIDTH) if node in squeezed and number else number)
        return [self._column(root, k) for root in self.plan.roots]

    def _column(self, root: Node, k: int) -> list[list[int]]:
        known = self.series.get(root)
        return (
            [self._residues(powers[k]) if powers[k] else [] for powers in known]
            if known
            else [[] for _ in self.box.parts]
        )

    def _residues(self, number: int) -> list[int]:
        p = self.prime
        return [x % p for x in unpack(number, self.size, WIDTH)]
