"""Random points of a prime field where the square roots of given expressions exist, found without evaluating all of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from nhc.algebra.calculus import reachable
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.graph import Graph, Node

MOST_DRAWS = 20_000
_EXPONENT = 65537
ROOTS = ("sqrt", "powf")


def draw_points(
    graph: Graph,
    roots: Sequence[Node],
    prime: int,
    seeds: Iterable[int],
    fixed: Mapping[Node, int] | None = None,
    later: int = 0,
    kind: type[FieldPoint] = FieldPoint,
    settle: Callable[[FieldPoint], object] | None = None,
) -> Iterator[tuple[int, FieldPoint]]:
    """(seed, point) for the seeds at which the square roots under the nodes exist; poles may still be met.

    ``fixed`` gives symbols a value; roots of what contains a symbol of the mask ``later`` are not looked at; ``settle`` gives
    symbols their values at a point before, and raises Unlucky where there are none.  Each point is
    prepared for the nodes, so that they may be evaluated in several calls.  Roots for which thousands of seeds had no point are
    not drawn for again.
    """
    radicals = [n for n in reachable(graph, roots) if graph.op[n] in ROOTS and not graph.deps[n] & later]
    hopeless: list[frozenset[Node]] = graph.memory.setdefault("roots without points", [])
    free = not fixed and settle is None
    if free and any(together <= set(radicals) for together in hopeless):
        return
    known, announced = dict(fixed or {}), kind(graph, 0, prime)
    announced.prepare(roots)
    tried, found = 0, False
    for seed in seeds:
        tried += 1
        point = kind(graph, seed, prime)
        point.prepare_like(announced)
        point.evaluate([], known)
        try:
            if settle is not None:
                settle(point)
            for node in radicals:
                point.evaluate([node])
        except Unlucky:
            continue
        found = True
        yield seed, point
    if radicals and free and not found and tried >= MOST_DRAWS:
        hopeless.append(frozenset(radicals))


class QuickPoint(FieldPoint):
    """A point for zero tests: its residues are never written down, so that its elements may be drawn faster."""

    def _generator(self, *key: object) -> int:
        """A power of a number that the key and the salt spell: of two keys neither is known from the other."""
        value = self._generators.get(key)
        if value is None:
            spelled = int.from_bytes(repr((self._salt, key)).encode(), "big")
            value = self._generators[key] = pow(spelled, _EXPONENT, self.prime) or 2
        return value
