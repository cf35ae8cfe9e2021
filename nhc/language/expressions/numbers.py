"""Exact numbers from their texts."""

from __future__ import annotations

import re
from fractions import Fraction

_MOST_DIGITS = 400  # far beyond what a double can tell apart, far below what makes exact arithmetic slow
_DECIMAL = re.compile(r"([-+]?)([0-9]*)(?:\.([0-9]*))?(?:[eE]([-+]?[0-9]+))?")
_LARGEST = 308
_SMALLEST = -307
DOUBLES = "write a number from 1e-307 up to less than 1e308, with some hundred digits at most, or choose other units"


def exact(text: str) -> Fraction | None:
    """Return the value of a decimal number such as ``-010``, ``.5``, ``1e-3``; None where the text is no such number.

    Raises ``ValueError`` with the reason where a double could not hold the number.
    """
    found = _DECIMAL.fullmatch(text)
    if not found:
        return None
    sign, whole, fraction, exponent = found.group(1), found.group(2), found.group(3) or "", found.group(4) or "0"
    if not whole and not fraction:
        return None
    digits = (whole + fraction).lstrip("0")
    if len(digits) > _MOST_DIGITS or len(exponent) > 8 or len(fraction) > 2 * _MOST_DIGITS:
        if not digits:
            return Fraction(0)
        raise ValueError("has too many digits")
    if not digits:
        return Fraction(0)
    power = int(exponent) - len(fraction)
    size = power + len(digits) - 1  # the power of ten of the first digit
    if size >= _LARGEST:
        raise ValueError("is too large for a double")
    if size < _SMALLEST:
        raise ValueError("is too small for a double")
    value = Fraction(int(digits)) * Fraction(10) ** power
    return -value if sign == "-" else value
