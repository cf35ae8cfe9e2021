"""Random points of a prime field where the square roots of given expressions exist, found without evaluating all of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.graph import Graph, Node
from nhc.algebra.walks import made_of, reachable

MOST_DRAWS = 20_000
_EXPONENT = 65537
ROOTS = ("sqrt", "powf")
_MOST_INDEPENDENT = 17
"""Radicands that are squares independently of each other: all of 18 are so at one point in 262144, and drawing is of no use."""
_CHARACTERS = 2 * _MOST_INDEPENDENT  # points at which it is seen how independent they are


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
    not drawn for again, and not at all where they are too many that have nothing to do with each other.
    """
    radicals = [n for n in reachable(graph, roots) if graph.op[n] in ROOTS and not graph.deps[n] & later]
    hopeless: list[frozenset[Node]] = graph.memory.setdefault("roots without points", [])
    free = not fixed and settle is None
    if free and any(together <= set(radicals) for together in hopeless):
        return
    known, announced = dict(fixed or {}), kind(graph, 0, prime)
    announced.prepare(roots)

    def draw(seed: int) -> FieldPoint:
        point = kind(graph, seed, prime)
        point.prepare_like(announced)
        point.evaluate([], known)
        if settle is not None:
            settle(point)
        return point

    if _are_too_many(graph, radicals, draw):
        if free:
            hopeless.append(frozenset(radicals))
        return
    tried, found = 0, False
    for seed in seeds:
        tried += 1
        try:
            point = draw(seed)
            for node in radicals:
                point.evaluate([node])
        except Unlucky:
            continue
        found = True
        yield seed, point
    if radicals and free and not found and tried >= MOST_DRAWS:
        hopeless.append(frozenset(radicals))


def _are_too_many(graph: Graph, radicals: Sequence[Node], draw: Callable[[int], FieldPoint]) -> bool:
    """Whether more of the radicands than one may hope for are squares independently of each other (see :mod:`.signs`).

    Those that hold no other root are looked at: their quadratic characters as rows of bits, by elimination modulo 2.
    """
    nested = set(made_of(graph, radicals, radicals))
    radicands = list(dict.fromkeys(graph.a[n] for n in radicals if graph.op[n] == "sqrt" and graph.a[n] not in nested))
    if len(radicands) <= _MOST_INDEPENDENT:
        return False
    characters, seen = [0] * len(radicands), 0
    for seed in range(_CHARACTERS):
        try:
            point = draw(seed)
            values = point.evaluate(radicands)
        except Unlucky:
            continue
        for k, x in enumerate(values):
            characters[k] |= (x != 0 and pow(x, (point.prime - 1) // 2, point.prime) != 1) << seen
        seen += 1
    pivots: dict[int, int] = {}
    for row in characters:
        while row and (pivot := pivots.setdefault(row.bit_length(), row)) != row:
            row ^= pivot
    return len(pivots) > _MOST_INDEPENDENT


class QuickPoint(FieldPoint):
    """A point for zero tests: its residues are never written down, so that its elements may be drawn faster."""

    def _generator(self, *key: object) -> int:
        """A power of a number that the key and the salt spell: of two keys neither is known from the other."""
        value = self._generators.get(key)
        if value is None:
            spelled = int.from_bytes(repr((self._salt, key)).encode(), "big")
            value = self._generators[key] = pow(spelled, _EXPONENT, self.prime) or 2
        return value
