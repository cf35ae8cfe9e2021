"""Random points of a prime field where the square roots of given expressions exist, found without evaluating all of them."""

from __future__ import annotations

import random
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence

from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.graph import SYM, Graph, Node
from nhc.algebra.walks import made_of, reachable

MOST_DRAWS = 20_000
_EXPONENT = 65537
ROOTS = ("sqrt", "powf")
_MOST_INDEPENDENT = 17
"""Radicands that are squares independently of each other: all of 18 are so at one point in 262144, and drawing is of no use."""
_FEW = 6
"""Independent radicands that are squares all at once sooner than symbols have been drawn one after the other."""
_STEPWISE = "roots drawn for one symbol after the other"
_MOST_AT_ONCE = 12  # roots that one symbol may complete
_PATIENCE = 16  # times the number of trials that a step takes
_HOPELESS = 3  # times that this was not enough
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
    not drawn for again.  Where too many have nothing to do with each other to be met all at once, symbols are drawn one after the
    other, each until the roots exist that it is the last to complete, and no point is drawn where these are too many.
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

    many = _count_independent(graph, radicals, draw)
    steps = _plan_steps(graph, radicals, later | graph.mask(known), many) if settle is None and many > _FEW else None
    if steps is not None:
        graph.memory.setdefault(_STEPWISE, {})[frozenset(radicals)] = steps
        yield from _draw_stepwise(graph, steps, draw, seeds)
        return
    if many > _MOST_INDEPENDENT:
        hopeless.extend([frozenset(radicals)] if free else [])
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


def _count_independent(graph: Graph, radicals: Sequence[Node], draw: Callable[[int], FieldPoint]) -> int:
    """How many of the radicands are squares independently of each other (see :mod:`.signs`), as far as that matters.

    Those that hold no other root are looked at: their quadratic characters as rows of bits, by elimination modulo 2.
    """
    nested = set(made_of(graph, radicals, radicals))
    radicands = list(dict.fromkeys(graph.a[n] for n in radicals if graph.op[n] == "sqrt" and graph.a[n] not in nested))
    if len(radicands) <= _FEW:
        return len(radicands)
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
    return len(pivots)


Step = tuple[Node, tuple[Node, ...]]
"""A symbol, and the roots that it is the last to complete."""


def _plan_steps(graph: Graph, radicals: Sequence[Node], held: int, many: int) -> list[Step] | None:
    """In which order to draw symbols: the last one is in the fewest roots, and so on; None where one completes too many, or as
    ``many`` as there are.  Symbols of the mask ``held`` have their values.
    """
    left, steps = list(radicals), list[Step]()
    symbols = {graph.deps[node]: node for node in reachable(graph, radicals) if graph.op[node] == SYM}
    while left:
        counts = {bit: sum(bool(graph.deps[root] & bit) for root in left) for bit in symbols if not bit & held}
        bit = min((bit for bit, count in counts.items() if count), key=lambda bit: (counts[bit], bit), default=None)
        if bit is None or counts[bit] > min(_MOST_AT_ONCE, many - 1):
            return None
        steps.insert(0, (symbols[bit], tuple(root for root in left if graph.deps[root] & bit)))
        left = [root for root in left if not graph.deps[root] & bit]
    return steps


def stepwise_degree(graph: Graph, roots: Collection[Node]) -> tuple[int, int]:
    """By how much roots that were drawn for one symbol after the other raise a degree, and how many of them these are.

    What is not zero is an element of a field of functions of the last symbol with the k roots that it completes; its norm has
    2^k times its degree, and 2^-k of the values of the symbol are drawn.  Coefficients that are not zero in the symbols before are
    met in the same way, one symbol after the other: the probabilities are added.
    """
    best = 1, 0
    for radicals, steps in graph.memory.get(_STEPWISE, {}).items():
        inside = radicals & set(roots)
        if len(inside) > best[1]:
            best = sum(1 << 2 * len(inside & set(group)) for _, group in steps), len(inside)
    return best


def _draw_stepwise(
    graph: Graph, steps: Sequence[Step], draw: Callable[[int], FieldPoint], seeds: Iterable[int]
) -> Iterator[tuple[int, FieldPoint]]:
    """(seed, point), until some roots were not found a few times."""
    failed = 0
    for seed in seeds:
        point = _settle_roots(graph, steps, draw(seed), seed)
        if point is not None:
            yield seed, point
            continue
        failed += 1
        if failed == _HOPELESS:
            return


def _settle_roots(graph: Graph, steps: Sequence[Step], point: FieldPoint, seed: int) -> FieldPoint | None:
    """The point with such values of the steps' symbols that all of their roots exist; None where one was not found in many times
    the trials that it should take.
    """
    numbers = random.Random(seed)
    for symbol, roots in steps:
        nodes, bit = reachable(graph, roots), graph.deps[symbol]
        moved = [node for node in nodes if graph.deps[node] & bit and node != symbol]
        try:
            point.evaluate([node for node in nodes if not graph.deps[node] & bit])
        except Unlucky:
            return None
        for _ in range(_PATIENCE << len(roots)):
            try:
                point.redraw(symbol, numbers.randrange(2, point.prime), moved)
            except Unlucky:
                continue
            break
        else:
            return None
    return point


class QuickPoint(FieldPoint):
    """A point for zero tests: its residues are never written down, so that its elements may be drawn faster."""

    def _generator(self, *key: object) -> int:
        """A power of a number that the key and the salt spell: of two keys neither is known from the other."""
        value = self._generators.get(key)
        if value is None:
            spelled = int.from_bytes(repr((self._salt, key)).encode(), "big")
            value = self._generators[key] = pow(spelled, _EXPONENT, self.prime) or 2
        return value
