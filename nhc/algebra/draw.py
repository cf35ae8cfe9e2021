"""Random points of a prime field where the square roots of given expressions exist, found without evaluating all of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from nhc.algebra.calculus import reachable
from nhc.algebra.graph import Graph, Node
from nhc.algebra.modular import FieldPoint, Unlucky

MOST_DRAWS = 20_000
_ROOTS = ("sqrt", "powf")


def draw_points(
    graph: Graph,
    roots: Sequence[Node],
    prime: int,
    seeds: Iterable[int],
    fixed: Mapping[Node, int] | None = None,
    later: int = 0,
) -> Iterator[tuple[int, FieldPoint]]:
    """(seed, point) for the seeds at which the square roots under the nodes exist; poles may still be met.

    ``fixed`` gives symbols a value; roots of what contains a symbol of the mask ``later`` are not looked at.  Each point is
    prepared for the nodes, so that they may be evaluated in several calls.
    """
    radicals = [n for n in reachable(graph, roots) if graph.op[n] in _ROOTS and not graph.deps[n] & later]
    known = dict(fixed or {})
    for seed in seeds:
        trial = FieldPoint(graph, seed, prime)
        trial.evaluate([], known)
        try:
            for node in radicals:
                trial.evaluate([node])
        except Unlucky:
            continue
        point = FieldPoint(graph, seed, prime)
        point.evaluate([], known)
        try:
            point.prepare(roots)
        except Unlucky:
            continue
        yield seed, point
