"""Random points of a prime field where the square roots of given expressions exist, found without evaluating all of them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from nhc.algebra.graph import Graph, Node
from nhc.algebra.modular import FieldPoint, Unlucky, list_radicals

MOST_DRAWS = 20_000


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
    radicals = [n for n in list_radicals(graph, roots) if not graph.deps[n] & later]
    known, announced = dict(fixed or {}), FieldPoint(graph, 0, prime)
    announced.prepare(roots)
    for seed in seeds:
        point = FieldPoint(graph, seed, prime)
        point.prepare_like(announced)
        point.evaluate([], known)
        try:
            for node in radicals:
                point.evaluate([node])
        except Unlucky:
            continue
        yield seed, point
