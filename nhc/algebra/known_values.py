"""Exact values of functions at rational arguments."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from nhc.algebra.nodes import Rational

_AT_ZERO = {
    "sin": 0,
    "cos": 1,
    "asin": 0,
    "atan": 0,
    "sinh": 0,
    "cosh": 1,
    "tanh": 0,
    "exp": 1,
    "sqrt": 0,
    "abs": 0,
    "sign": 0,
}


def known_value(name: str, x: Fraction) -> Rational | None:
    """The function's value at x where it is rational and known; else None."""
    if x == 0 and name in _AT_ZERO:
        return _AT_ZERO[name]
    if name == "log" and x == 1:
        return 0
    if name == "sqrt" and x > 0:
        top, bottom = isqrt(x.numerator), isqrt(x.denominator)
        if top * top == x.numerator and bottom * bottom == x.denominator:
            return Fraction(top, bottom)
    if name == "abs":
        return abs(x)
    if name == "sign":
        return (x > 0) - (x < 0)
    return None
