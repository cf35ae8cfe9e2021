"""Numbers, strings and texts of Python, spelt as ruff's formatter leaves them."""

from __future__ import annotations

from fractions import Fraction

from nhc.emit.options import EmitError
from nhc.emit.prose import clean


def print_float(value: Fraction | float) -> str:
    """The shortest decimal that reads back as the nearest double: ``2.0``, ``1e22``, ``1e-05``."""
    try:
        number = float(value)
    except OverflowError:
        raise EmitError("a number of the spec is too large for a double (1.8e308)", "choose other units") from None
    if number != number:
        return "math.nan"
    if number in (float("inf"), float("-inf")):
        return "math.inf" if number > 0 else "-math.inf"
    return repr(number).replace("e+", "e")


def print_string(text: str) -> str:
    """A string literal in double quotes; quotes inside become single ones, as no name of a spec holds any."""
    return '"' + clean(text).replace("\\", "\\\\").replace('"', "'") + '"'


def print_comment(text: str) -> str:
    """Text that may follow ``#``: one line."""
    return clean(text)


def print_docstring(text: str) -> str:
    """Text that may stand in a docstring: it cannot end it and holds no escape."""
    return clean(text).replace("\\", "\\\\").replace('"', "'")
