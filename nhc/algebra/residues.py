"""Square roots and points of the circle modulo a prime p = 3 mod 4."""

from __future__ import annotations


def square_root(x: int, p: int) -> int | None:
    """The square root that is itself a square; None where there is none."""
    if x and pow(x, (p - 1) // 2, p) != 1:
        return None
    return pow(x, (p + 1) // 4, p)


def circle_point(u: int, p: int) -> tuple[int, int]:
    """(cosine, sine) = ((1 - u^2)/(1 + u^2), 2u/(1 + u^2)); 1 + u^2 is never zero, for -1 is no square."""
    scale = pow(1 + u * u, -1, p)
    return (1 - u * u) * scale % p, 2 * u * scale % p


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
