"""Numbers, strings and comments of C."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import lru_cache

from nhc.emit.options import EmitError
from nhc.emit.prose import clean, fold_ascii

PI = "3.141592653589793"  # the double nearest to pi; M_PI is not C99


def print_double(value: Fraction) -> str:
    """The shortest decimal that reads back as the double nearest to ``value``: ``2.0``, ``1e22``, ``-0.1``."""
    try:
        number = float(value)
    except OverflowError:
        raise EmitError("a number of the spec is too large for a double (1.8e308)", "choose other units") from None
    return repr(number).replace("e+", "e")


NAN, INFINITY = "(double)NAN", "(double)INFINITY"  # C's own are floats, and clang warns where floats become doubles


def print_float(value: float) -> str:
    """A double of a table, where NaN says that there is no value."""
    if value != value:
        return NAN
    if value in (float("inf"), float("-inf")):
        return INFINITY if value > 0 else f"-{INFINITY}"
    return repr(value).replace("e+", "e")


def print_string(text: str) -> str:
    """A string literal in ASCII: UTF-8 bytes as octal escapes, no trigraph."""
    return '"' + "".join(_print_byte(byte) for byte in text.encode()) + '"'


def _print_byte(byte: int) -> str:
    character = chr(byte)
    if character in '"\\?':
        return "\\" + character
    return character if 32 <= byte < 127 else f"\\{byte:03o}"


@lru_cache(maxsize=1 << 12)
def print_comment(text: str) -> str:
    """Text that may stand in a comment: it cannot close it, open another, continue a line or hold a trigraph."""
    text = fold_ascii(clean(text))
    text = re.sub(r"\?(?=\?)", "? ", text)
    text = re.sub(r"\*(?=/)", "* ", text)
    text = re.sub(r"/(?=\*)", "/ ", text)
    return re.sub(r"\\+(?= |$)", "", text).strip()
