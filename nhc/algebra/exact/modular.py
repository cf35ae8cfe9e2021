"""The exact identity test, and generic ranks: evaluation at random points of a prime field (:mod:`nhc.algebra.exact.field`).

Equal expressions that the field's rules cover have equal values; unequal ones of degree d agree at a random point with probability
at most d/p (Schwartz 1980, Zippel 1979), where no sign and no root of a square occurs; where some do, one half or more takes
the place of d/p and more points are drawn (:mod:`nhc.algebra.exact.signs`).
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Sequence
from itertools import chain, islice

from nhc.algebra.dense import rank_modulo
from nhc.algebra.evaluate import Mpmath, evaluate
from nhc.algebra.exact.both_signs import vanish_for_both_signs
from nhc.algebra.exact.draw import MOST_DRAWS, QuickPoint, draw_points
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.residues import PRIMES
from nhc.algebra.exact.signs import MOST, Signs, degree_in_signs, may_hold, points_for
from nhc.algebra.graph import Graph, Node
from nhc.algebra.probe import probe_of, signed_probes

__all__ = ["PRIMES", "FieldPoint", "Unlucky", "are_equal", "are_zero", "is_zero", "rank", "sample"]

_RANK_POINTS = 8  # before it is asked whether more are needed
_DRAWS = 60  # a root has a value at every second point; beyond so many draws in a row roots are looked at one by one
_SEEDS = 1_000_003  # of a question's points, so that no two questions draw the same ones
_REAL_DRAWS = 200  # of real points, where there is no point of the field
_SCALES = (1, 2, 40, 1000)  # of their numbers
_KEPT_POINTS = 48


def sample(
    graph: Graph, roots: Sequence[Node], count: int = 2, seed: int = 1, kind: type[FieldPoint] = FieldPoint
) -> list[list[int]]:
    """Residues of the roots at ``count`` random points, each modulo its own prime; unlucky points are drawn again.

    Raises:
        Unlucky: after many unlucky draws in a row (an expression that is singular everywhere, or dozens of nested roots).
    """
    return [row for _, row in _sampled(graph, roots, count, seed, kind)]


_Sampled = tuple[FieldPoint, list[int]]


def _sampled(graph: Graph, roots: Sequence[Node], count: int, seed: int, kind: type[FieldPoint]) -> list[_Sampled]:
    """Points with the residues of the roots."""
    results: list[_Sampled] = []
    known: dict[tuple[int, int], FieldPoint] = {}
    if kind is QuickPoint and count <= _KEPT_POINTS:  # these stay, and know what was evaluated before
        known = graph.memory.setdefault("points", known)
    attempt, unlucky, primes = 0, 0, primes_of(graph)
    while len(results) < count:
        attempt += 1
        if unlucky > _DRAWS:
            return results + _sample_open(graph, roots, range(len(results), count), seed, kind, known)
        key = seed * _SEEDS + attempt, primes[len(results) % len(primes)]
        point = known.get(key) or kind(graph, *key)
        try:
            results.append((point, point.evaluate(roots)))
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
) -> list[_Sampled]:
    """Points where the square roots exist: those of this seed that are known, then such as are looked for.

    Raises:
        Unlucky: none was found.
    """
    results, used = list[_Sampled](), set[tuple[int, int]]()
    seeds = iter(range(seed * _SEEDS + _DRAWS + 2, (seed + 1) * _SEEDS))
    primes = primes_of(graph)
    for place in places:
        prime = primes[place % len(primes)]
        old = [key for key in known if key[1] == prime and key[0] // _SEEDS == seed]
        drawn = draw_points(graph, roots, prime, islice(seeds, MOST_DRAWS), kind=kind)
        found = chain(((key, known[key]) for key in old), (((at, prime), point) for at, point in drawn))
        for key, point in islice(found, len(old) + _DRAWS):  # more are poles of something else
            if key in used:
                continue
            used.add(key)
            try:
                results.append((point, point.evaluate(roots)))
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
    if may_hold(graph, alive):  # only what has vanished so far, and holds signs, needs the further points
        alive = _vanishing_with_signs(graph, alive, count, seed)
    vanishing = {graph.zero, *alive}
    return [n in vanishing for n in nodes]


def _vanishing_with_signs(graph: Graph, nodes: Sequence[Node], done: int, seed: int) -> list[Node]:
    """Those of the nodes that are zero at as many more points as their signs need.

    What holds too many signs is not taken for zero: it is better kept than lost.
    """
    held = [n for n in nodes if not may_hold(graph, [n])]
    open_ = [n for n in nodes if n not in set(held) and not any(probe.is_clear(n) for probe in signed_probes(graph))]
    signs = Signs(graph, open_)
    degrees = {n: signs.degree([n]) for n in open_}
    settled = _vanishing_for_both(graph, signs, [n for n in open_ if degrees[n]], done, seed)
    held += settled
    alive = [n for n in open_ if degrees[n] <= MOST and n not in settled]
    for round_, degree in enumerate(sorted({degrees[n] for n in alive} - {0}), start=1):
        held += [n for n in alive if degrees[n] < degree]
        alive = [n for n in alive if degrees[n] >= degree]
        needed = points_for(degree, done)
        alive, done = _vanishing(graph, alive, needed - done, seed + round_), needed
    return held + alive


def _vanishing_for_both(graph: Graph, signs: Signs, nodes: Sequence[Node], count: int, seed: int) -> list[Node]:
    """Those of the nodes that vanish for both values of each of their signs, which need no further points."""
    try:
        sampled = _sampled(graph, nodes, count, seed, QuickPoint) if nodes else []
    except Unlucky:
        return []
    zero = [n for k, n in enumerate(nodes) if not any(row[k] for _, row in sampled)]
    found = vanish_for_both_signs(signs, zero, [point for point, _ in sampled])
    return [n for n in nodes if n in found]


def _vanishing(graph: Graph, nodes: Sequence[Node], count: int, seed: int) -> list[Node]:
    """Those of the nodes that are zero at all of ``count`` points."""
    try:
        rows = sample(graph, nodes, count, seed, QuickPoint) if nodes else []
    except Unlucky:
        return [n for n in nodes if vanishes_numerically(graph, n, seed)]
    return [n for k, n in enumerate(nodes) if all(row[k] == 0 for row in rows)]


def vanishes_numerically(graph: Graph, node: Node, seed: int) -> bool:
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


def enough_points(graph: Graph, nodes: Sequence[Node]) -> int:
    """One point, more where signs occur; a sign is right by chance at every second point."""
    return points_for(min(MOST, degree_in_signs(graph, nodes)), 1)


def is_zero(graph: Graph, node: Node) -> bool:
    """Whether the node vanishes identically."""
    return node == graph.zero or (not probe_of(graph).is_clear(node) and are_zero(graph, [node])[0])


def are_equal(graph: Graph, left: Sequence[Node], right: Sequence[Node]) -> bool:
    """Whether the two lists agree entry by entry."""
    return all(are_zero(graph, [graph.sub(x, y) for x, y in zip(left, right, strict=True)]))


def rank(graph: Graph, rows: Sequence[Sequence[Node]], seed: int = 1) -> int:
    """Generic rank of a matrix of nodes."""
    if not rows or not rows[0]:
        return 0
    width = len(rows[0])
    if probe_of(graph).has_full_rank(rows):
        return min(len(rows), width)
    flat = [entry for row in rows for entry in row]
    full = min(len(rows), width)
    primes = primes_of(graph)

    def rank_at(points: Sequence[Sequence[int]]) -> int:
        """The largest rank at these points."""
        matrices = ([values[i * width : (i + 1) * width] for i in range(len(rows))] for values in points)
        return max(rank_modulo(matrix, primes[k % len(primes)]) for k, matrix in enumerate(matrices))

    found = rank_at(sample(graph, flat, 1, seed))
    if found == full:
        return found
    # a rank is too small only at special points; signs make half of the points special for an entry
    enough = enough_points(graph, flat)
    if enough > 1:
        found = max(found, rank_at(sample(graph, flat, min(enough, _RANK_POINTS), seed)))
    if enough > _RANK_POINTS and found < full:
        found = max(found, rank_at(sample(graph, flat, enough - _RANK_POINTS, seed + 1)))
    return found
