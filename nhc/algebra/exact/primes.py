"""The primes modulo which a graph is tested: those in which its constants have their square roots.

2, 3, 5, ..., 47 are squares modulo each of PRIMES, but sqrt(53) or sqrt(3 + sqrt(2)) exist modulo every second prime only, and no
other random point changes that; so does the cosine of atan(1/10), which is 10/sqrt(101).  For a graph that holds such constants
others of the same kind are searched: modulo p with p + 1 divisible by 4 l a prime l is a square (by quadratic reciprocity, l odd),
and so is what is made of such.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cache

from nhc.algebra.exact.draw import ROOTS
from nhc.algebra.exact.field import INVERSE, FieldPoint, Unlucky
from nhc.algebra.exact.residues import FULL_TURN, PRIMES, square_root
from nhc.algebra.graph import Graph, Node
from nhc.algebra.walks import reachable

_ROOTED = (*ROOTS, *INVERSE)
_LARGEST = 2**61
_MOST_PERIOD = 2**46  # so that there are safe primes enough
_TRIED = 60_000  # multiples of the period, about one in 400 of which belongs to a safe prime
_SEEDS = 8  # of roots of constants that are random elements, such as sqrt(sin(1))
_SMALL_FACTORS = 2000
_WITNESSES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)  # enough below 3.3e24 (Sorenson and Webster 2017)


def primes_of(graph: Graph) -> tuple[int, ...]:
    """As many primes as PRIMES has, in which the roots of the graph's constants exist; PRIMES where none were found."""
    seen, roots, primes = graph.memory.get("primes", (0, (), PRIMES))
    if seen < len(graph.op):
        found = [node for node, op in enumerate(graph.op[seen:], seen) if op in _ROOTED and not graph.deps[node]]
        if found:
            roots = (*roots, *found)
            primes = _choose(graph, roots, primes)
        graph.memory["primes"] = (len(graph.op), roots, primes)
    return tuple(primes)


def _choose(graph: Graph, roots: Sequence[Node], known: Sequence[int]) -> tuple[int, ...]:
    kept = [p for p in dict.fromkeys((*known, *PRIMES)) if _fits(graph, roots, p)][: len(PRIMES)]
    if len(kept) < len(PRIMES):
        for p in _safe_primes(_period(graph, roots)):
            if p not in kept and _fits(graph, roots, p):
                kept.append(p)
            if len(kept) == len(PRIMES):
                break
    return tuple(kept) if len(kept) == len(PRIMES) else PRIMES


def _fits(graph: Graph, roots: Sequence[Node], prime: int) -> bool:
    """Whether each root exists at one point at least."""
    return all(any(_exists(graph, root, prime, seed) for seed in range(_SEEDS)) for root in roots)


def _exists(graph: Graph, root: Node, prime: int, seed: int) -> bool:
    point = FieldPoint(graph, seed, prime)
    try:
        point.evaluate([root])
        point.known_point(root)
    except Unlucky:
        return False
    return True


def _period(graph: Graph, roots: Sequence[Node]) -> int:
    """What shall divide p + 1: the parts of a turn, and four times each prime that the numbers under the roots are made of."""
    period = FULL_TURN
    for number in sorted({n for root in roots for n in (*_numbers_below(graph, root), *_sides(graph, root))}):
        for factor in _factors(number):
            if period * factor < _MOST_PERIOD:
                period = math.lcm(period, factor)
    return period


def _numbers_below(graph: Graph, root: Node) -> set[int]:
    """Numerators and denominators of the numbers that the root is made of."""
    values = [graph.value(node) for node in reachable(graph, [root])]
    return {n for value in values if value is not None for n in (abs(value.numerator), value.denominator)}


def _sides(graph: Graph, node: Node) -> tuple[int, ...]:
    """What stands under the root in the sine or cosine of an inverse function of numbers."""
    if graph.op[node] not in INVERSE:
        return ()
    values = [graph.value(x) for x in graph.children(node)]
    if None in values:
        return ()
    x, y = (Fraction(value or 0) for value in (*values, 1)[:2])
    square = 1 - x * x if graph.op[node] in ("asin", "acos") else x * x + y * y
    return abs(square.numerator), square.denominator


def _factors(number: int) -> list[int]:
    """The small prime factors, then what is left of the number."""
    found, factor = list[int](), 2
    while factor < _SMALL_FACTORS and number > 1:
        if number % factor == 0:
            found.append(factor)
            while number % factor == 0:
                number //= factor
        factor += 1
    return [*found, number] if number > 1 else found


def _safe_primes(period: int) -> Iterator[int]:
    """Primes p = 2 q + 1, q a prime, with p + 1 divisible by the period, in which the radicals of the parts of a turn exist."""
    first = _LARGEST // period
    for multiple in range(first, max(0, first - _TRIED), -1):
        p = multiple * period - 1
        if _is_prime(p // 2) and _is_prime(p) and _has_parts(p):
            yield p


def _has_parts(p: int) -> bool:
    r2, r3, r5 = (square_root(x, p) for x in (2, 3, 5))
    if r2 is None or r3 is None or r5 is None:
        return False
    return all(square_root(x % p, p) is not None for x in (2 + r2, 1 + r2, 1 + r3, 1 + r5, 10 + 2 * r5))


@cache
def _is_prime(n: int) -> bool:
    """Miller and Rabin's test with the witnesses that are enough for numbers of this size."""
    if n < 2 or any(n % w == 0 for w in _WITNESSES):
        return n in _WITNESSES
    odd, twos = n - 1, 0
    while odd % 2 == 0:
        odd, twos = odd // 2, twos + 1
    return all(_passes(n, pow(w, odd, n), twos) for w in _WITNESSES)


def _passes(n: int, x: int, twos: int) -> bool:
    if x in (1, n - 1):
        return True
    for _ in range(twos - 1):
        x = x * x % n
        if x == n - 1:
            return True
    return False
