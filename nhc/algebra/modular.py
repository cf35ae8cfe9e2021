"""The exact identity test, and generic ranks: evaluation at random points of a prime field (:mod:`nhc.algebra.field`).

Equal expressions that the field's rules cover have equal values; unequal ones of degree d agree at a random point with probability
at most d/p (Schwartz 1980, Zippel 1979), where no sign and no root of a square occurs; where one does, one half takes the place of
d/p and more points are drawn.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Sequence
from itertools import chain, islice
from weakref import WeakKeyDictionary

from nhc.algebra.calculus import reachable
from nhc.algebra.draw import MOST_DRAWS, ROOTS, draw_points
from nhc.algebra.evaluate import Mpmath, evaluate
from nhc.algebra.field import PRIMES, FieldPoint, QuickPoint, Unlucky
from nhc.algebra.graph import Graph, Node
from nhc.algebra.probe import probe_of

__all__ = ["PRIMES", "FieldPoint", "Unlucky", "are_equal", "are_zero", "is_zero", "rank", "sample"]

_SIGNED = ("sign", "abs", "min", "max")
_SQUARES: WeakKeyDictionary[Graph, dict[Node, bool]] = WeakKeyDictionary()
_RANK_POINTS = 8
_DRAWS = 60  # a root has a value at every second point; beyond so many draws in a row roots are looked at one by one
_SEEDS = 1_000_003  # of a question's points, so that no two questions draw the same ones
_REAL_DRAWS = 200  # of real points, where there is no point of the field
_SCALES = (1, 2, 40, 1000)  # of their numbers
_SIGNED_POINTS = 48  # a sign is right by chance at every second point


def sample(
    graph: Graph, roots: Sequence[Node], count: int = 2, seed: int = 1, kind: type[FieldPoint] = FieldPoint
) -> list[list[int]]:
    """Residues of the roots at ``count`` random points, each modulo its own prime; unlucky points are drawn again.

    Raises:
        Unlucky: after many unlucky draws in a row (an expression that is singular everywhere, or dozens of nested roots).
    """
    results: list[list[int]] = []
    known: dict[tuple[int, int], FieldPoint] = {}
    if kind is QuickPoint:  # these stay, and know what was evaluated before
        known = graph.memory.setdefault("points", known)
    attempt = unlucky = 0
    while len(results) < count:
        attempt += 1
        if unlucky > _DRAWS:
            return results + _sample_open(graph, roots, range(len(results), count), seed, kind, known)
        key = seed * _SEEDS + attempt, PRIMES[len(results) % len(PRIMES)]
        point = known.get(key) or kind(graph, *key)
        try:
            results.append(point.evaluate(roots))
        except Unlucky:
            known.pop(key, None)
            unlucky += 1
            continue
        known[key], unlucky = point, 0
    return results


def _sample_open(
    graph: Graph,
    roots: Sequence[Node],
    places: Iterable[int],
    seed: int,
    kind: type[FieldPoint],
    known: dict[tuple[int, int], FieldPoint],
) -> list[list[int]]:
    """Residues at points where the square roots exist: those of this seed that are known, then such as are looked for.

    Raises:
        Unlucky: none was found.
    """
    results, used = [], set[tuple[int, int]]()
    seeds = iter(range(seed * _SEEDS + _DRAWS + 2, (seed + 1) * _SEEDS))
    for place in places:
        prime = PRIMES[place % len(PRIMES)]
        old = [key for key in known if key[1] == prime and key[0] // _SEEDS == seed]
        drawn = draw_points(graph, roots, prime, islice(seeds, MOST_DRAWS), kind=kind)
        found = chain(((key, known[key]) for key in old), (((at, prime), point) for at, point in drawn))
        for key, point in islice(found, len(old) + _DRAWS):  # more are poles of something else
            if key in used:
                continue
            used.add(key)
            try:
                results.append(point.evaluate(roots))
            except Unlucky:
                continue
            known[key] = point
            break
        else:
            raise Unlucky
    return results


def are_zero(graph: Graph, nodes: Sequence[Node], count: int = 2, seed: int = 1) -> list[bool]:
    """For each node whether it vanishes identically (wrong with probability at most (degree/p)**count)."""
    probe = probe_of(graph)
    pending = [n for n in dict.fromkeys(nodes) if n != graph.zero and not probe.is_clear(n)]
    if not pending:
        return [n == graph.zero for n in nodes]
    alive = _vanishing(graph, pending, count, seed)
    more = enough_points(graph, alive, count)
    if more > count:  # only what has vanished so far, and holds signs, needs the further points
        alive = _vanishing(graph, alive, more - count, seed + 1)
    vanishing = {graph.zero, *alive}
    return [n in vanishing for n in nodes]


def _vanishing(graph: Graph, nodes: Sequence[Node], count: int, seed: int) -> list[Node]:
    """Those of the nodes that are zero at all of ``count`` points."""
    try:
        rows = sample(graph, nodes, count, seed, QuickPoint) if nodes else []
    except Unlucky:
        return [n for n in nodes if _vanishes_numerically(graph, n, seed)]
    return [n for k, n in enumerate(nodes) if all(row[k] == 0 for row in rows)]


def _vanishes_numerically(graph: Graph, node: Node, seed: int) -> bool:
    """For what has no field points (dozens of nested roots): zero to 40 of 60 digits at three real points.

    Where it is not real nothing is known, and what has no real point that was found is not taken for zero.
    """
    import mpmath

    seen = 0
    for attempt in range(_REAL_DRAWS):
        draw = random.Random(seed * 7919 + attempt)
        scale, low = _SCALES[attempt % len(_SCALES)], -(10**6) if attempt % 3 == 2 else 1
        with mpmath.workdps(60):
            place = {s: scale * mpmath.mpf(draw.randrange(low, 10**6)) / 400_000 for s in graph.symbols_in(node)}
            try:
                value = evaluate(graph, [node], place, Mpmath())[0]
            except (ArithmeticError, ValueError, TypeError):
                continue
            if mpmath.im(value) != 0 or not mpmath.isfinite(value):
                continue
            if abs(value) > mpmath.mpf(10) ** -40:
                return False
        seen += 1
        if seen == 3:
            return True
    return False


def enough_points(graph: Graph, nodes: Sequence[Node], count: int) -> int:
    """More points where signs occur: with n of them the answer is wrong with probability 2**-n and not (degree/p)**n.

    The root of a square is a sign in disguise: sqrt(x^2) is x at every second point.
    """
    for node in reachable(graph, nodes):
        op = graph.op[node]
        if op in _SIGNED or (op in ROOTS and graph.deps[node] and _is_square(graph, graph.a[node])):
            return max(count, _SIGNED_POINTS)
    return count


def _is_square(graph: Graph, node: Node) -> bool:
    """Whether the node's values are squares at every one of some random points (known from then on)."""
    known = _SQUARES.setdefault(graph, {})
    if node not in known:
        known[node] = _squares_only(graph, node)
    return known[node]


def _squares_only(graph: Graph, node: Node) -> bool:
    seen = 0
    for attempt in range(400):
        prime = PRIMES[attempt % len(PRIMES)]
        try:
            value = FieldPoint(graph, 5_000_011 + attempt, prime).evaluate([node])[0]
        except Unlucky:
            continue
        if value and pow(value, (prime - 1) // 2, prime) != 1:
            return False
        seen += 1
        if seen == 24:
            break
    return True


def is_zero(graph: Graph, node: Node) -> bool:
    """Whether the node vanishes identically."""
    return node == graph.zero or (not probe_of(graph).is_clear(node) and are_zero(graph, [node])[0])


def are_equal(graph: Graph, left: Sequence[Node], right: Sequence[Node], count: int = 2) -> bool:
    """Whether the two lists agree entry by entry."""
    return all(are_zero(graph, [graph.sub(x, y) for x, y in zip(left, right, strict=True)], count))


def rank(graph: Graph, rows: Sequence[Sequence[Node]], seed: int = 1) -> int:
    """Generic rank of a matrix of nodes."""
    if not rows or not rows[0]:
        return 0
    width = len(rows[0])
    if probe_of(graph).has_full_rank(rows):
        return min(len(rows), width)
    flat = [entry for row in rows for entry in row]
    # a rank is too small only at special points; signs make half of the points special for an entry
    points = sample(graph, flat, min(enough_points(graph, flat, 1), _RANK_POINTS), seed)
    matrices = [[values[i * width : (i + 1) * width] for i in range(len(rows))] for values in points]
    return max(_rank_modulo(matrix, PRIMES[k % len(PRIMES)]) for k, matrix in enumerate(matrices))


def _rank_modulo(matrix: list[list[int]], p: int) -> int:
    matrix = [list(row) for row in matrix]
    found = 0
    for column in range(len(matrix[0])):
        pivot = next((i for i in range(found, len(matrix)) if matrix[i][column] % p), None)
        if pivot is None:
            continue
        matrix[found], matrix[pivot] = matrix[pivot], matrix[found]
        inverse = pow(matrix[found][column], -1, p)
        for i in range(found + 1, len(matrix)):
            factor = matrix[i][column] * inverse % p
            if factor:
                matrix[i] = [(x - factor * y) % p for x, y in zip(matrix[i], matrix[found], strict=True)]
        found += 1
        if found == len(matrix):
            break
    return found
