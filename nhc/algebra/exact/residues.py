"""Square roots and points of the circle modulo a prime p = 3 mod 4; with p + 1 divisible by FULL_TURN, its parts are points too."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import accumulate

PRIMES = (2305843006248270719, 2305843005290151599, 2305842996234052799, 2305842995637941759)
"""Safe primes p below 2**61 with p + 1 divisible by 5040, modulo each of which 2, 3, 5, ..., 47 are squares: their roots exist,
sqrt(4*x) is 2*sqrt(x) and not its negative, and the circle has points at all 5040ths of a turn.  2 + sqrt(2), 1 + sqrt(2),
1 + sqrt(3), 1 + sqrt(5) and 10 + 2 sqrt(5) are squares, too, as positive numbers should be."""

FULL_TURN = 5040
"""The circle modulo p has p + 1 points and is cyclic: it has points of each order that divides p + 1."""


def square_root(x: int, p: int) -> int | None:
    """The square root that is itself a square; None where there is none."""
    if x and pow(x, (p - 1) // 2, p) != 1:
        return None
    return pow(x, (p + 1) // 4, p)


def circle_point(u: int, p: int) -> tuple[int, int]:
    """(cosine, sine) = ((1 - u^2)/(1 + u^2), 2u/(1 + u^2)); 1 + u^2 is never zero, for -1 is no square."""
    scale = pow(1 + u * u, -1, p)
    return (1 - u * u) * scale % p, 2 * u * scale % p


def circle_points(us: Sequence[int], p: int) -> list[tuple[int, int]]:
    """:func:`circle_point` of all, with one inversion for them together."""
    scales = invert([1 + u * u for u in us], p)
    return [((1 - u * u) * scale % p, 2 * u * scale % p) for u, scale in zip(us, scales, strict=True)]


def invert(xs: Sequence[int], p: int) -> list[int]:
    """1/x of all, none of which is zero, with one inversion for them together (Montgomery 1987)."""
    products = list(accumulate(xs, lambda a, b: a * b % p, initial=1))
    inverse = pow(products.pop(), -1, p)
    found = []
    for x, before in zip(reversed(xs), reversed(products), strict=True):
        found.append(inverse * before % p)
        inverse = inverse * x % p
    return found[::-1]


def turn(c: int, s: int, k: int, p: int) -> tuple[int, int]:
    """(cosine, sine) of k times an angle."""
    if k < 0:
        s, k = -s % p, -k
    rc, rs = 1, 0
    while k:
        if k & 1:
            rc, rs = (rc * c - rs * s) % p, (rs * c + rc * s) % p
        c, s = (c * c - s * s) % p, 2 * c * s % p
        k >>= 1
    return rc, rs


@cache
def _parts(p: int) -> tuple[tuple[int, tuple[int, int]], ...]:
    """(order, point) of a 16th, 9th, 5th and 7th of a turn, such that their sines and cosines are the radicals that they are:
    cos(pi/4) = sqrt(2)/2, sin(2 pi/3) = sqrt(3)/2, cos(2 pi/5) = (sqrt(5) - 1)/4.
    """

    def root(x: int) -> int:
        found = square_root(x % p, p)
        assert found is not None
        return found

    half, quarter = pow(2, -1, p), pow(4, -1, p)
    r2, r3, r5 = root(2), root(3), root(5)
    ninth = next(h for h in _of_order(9, p) if turn(*h, 3, p) == (-half % p, r3 * half % p))
    return (
        (16, (root(2 + r2) * half % p, root(2 - r2) * half % p)),
        (9, ninth),
        (5, ((r5 - 1) * quarter % p, root(10 + 2 * r5) * quarter % p)),
        (7, next(h for h in _of_order(7, p) if square_root(h[1], p) is not None)),
    )


def _of_order(n: int, p: int) -> list[tuple[int, int]]:
    """The points of that order, a power of a prime."""
    prime = next(q for q in (2, 3, 5, 7) if n % q == 0)
    powers = (turn(*circle_point(u, p), (p + 1) // n, p) for u in range(2, p))
    one = next(h for h in powers if turn(*h, n // prime, p) != (1, 0))
    return [turn(*one, k, p) for k in range(1, n) if k % prime]


@cache
def part_of_turn(count: int, p: int) -> tuple[int, int]:
    """(cosine, sine) of ``count`` 5040ths of a turn.  p + 1 must be divisible by 5040, and the radicals above exist."""
    c, s = 1, 0
    for order, point in _parts(p):
        weight = count * pow(FULL_TURN // order, -1, order) % order
        ck, sk = turn(*point, weight, p)
        c, s = (c * ck - s * sk) % p, (s * ck + c * sk) % p
    return c, s
