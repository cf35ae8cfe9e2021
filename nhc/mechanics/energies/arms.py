"""Squares of sums of parameters that were multiplied out: (l - b)^2 of a mass that stands beside a joint's end."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import isqrt

from nhc.algebra.expand import Coefficient, Monomial, Polynomial

Part = tuple[Monomial, Fraction]
"""A product of parameters and the number in front of it."""


def linear_root(p: Polynomial) -> Sequence[Part]:
    """Parts, the first with the number 1, where p is a number times the square of their sum; none where it is no such square, or of
    one part alone.
    """
    squares = [m for m, c in sorted(p.items()) if c > 0 and m and all(e > 0 and e % 2 == 0 for _, e in m)]
    if len(squares) < 2 or len(p) != len(squares) * (len(squares) + 1) // 2:
        return ()
    first, factor = _half(squares[0]), p[squares[0]]
    parts: list[Part] = [(first, Fraction(1))]
    for square in squares[1:]:
        number, half = _root(Fraction(p[square]) / factor), _half(square)
        mixed = p.get(_times(first, half), 0)
        if number is None or abs(mixed) != 2 * number * factor:
            return ()
        parts.append((half, number if mixed > 0 else -number))
    made = dict[Monomial, Coefficient]()
    for a, x in parts:
        for b, y in parts:
            product = _times(a, b)
            made[product] = made.get(product, 0) + factor * x * y
    return parts if made == p else ()


def _half(m: Monomial) -> Monomial:
    return tuple((f, e // 2) for f, e in m)


def _times(a: Monomial, b: Monomial) -> Monomial:
    powers = dict(a)
    for f, e in b:
        powers[f] = powers.get(f, 0) + e
    return tuple(sorted(powers.items()))


def _root(ratio: Fraction) -> Fraction | None:
    found = Fraction(isqrt(ratio.numerator), isqrt(ratio.denominator))
    return found if found**2 == ratio else None
