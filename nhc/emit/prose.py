"""Texts of the user on their way into comments and docstrings: cleaned, folded to ASCII, wrapped."""

from __future__ import annotations

import re
import textwrap
import unicodedata
from fractions import Fraction

from nhc.program.ir import Guard, Load, Number, Origin

PUNCTUATION = {
    "\u2010": "-", "\u2011": "-", "\u2012": "-", "\u2013": "-", "\u2014": "-", "\u2212": "-",
    "\u2018": "'", "\u2019": "'", "\u201c": "'", "\u201d": "'", "\u2032": "'", "\u2033": "''",
    "\u00b7": "*", "\u22c5": "*", "\u00d7": "x", "\u00df": "ss", "\u00f8": "o", "\u00d8": "O",
    "\u0142": "l", "\u0141": "L", "\u00e6": "ae", "\u2265": ">=", "\u2264": "<=", "\u2026": "...",
    "\u00b5": "u", "\u2044": "/",
}  # fmt: skip
SHORT = 24  # characters of a value that a comment repeats
RAISED = re.compile("[\u207a\u207b\u2070\u00b9\u00b2\u00b3\u2074-\u2079]+")  # signs and digits of exponents


def clean(text: str) -> str:
    """One line without control, format (bidirectional!) and unassigned characters; runs of blanks become one."""
    visible = (" " if c.isspace() else c for c in text if c.isspace() or not unicodedata.category(c).startswith("C"))
    return " ".join("".join(visible).split())


def fold_ascii(text: str) -> str:
    """ASCII for a text: accents are dropped, Greek letters named, exponents stay exponents (as ``m/s^2``).

    What is left is written by its code, as <U+4E2D>.
    """
    text = RAISED.sub(lambda raised: "^" + unicodedata.normalize("NFKC", raised[0]), text)
    return "".join(_fold_character(character) for character in text)


def _fold_character(character: str) -> str:
    if character.isascii():
        return character
    if character in PUNCTUATION:
        return PUNCTUATION[character]
    name = unicodedata.name(character, "")
    greek = re.fullmatch(r"GREEK (SMALL|CAPITAL) LETTER (\w+)( WITH .*)?", name)
    if greek:
        return greek[2].lower() if greek[1] == "SMALL" else greek[2].capitalize()
    decomposed = unicodedata.normalize("NFKD", character)
    kept = "".join(c for c in decomposed if not unicodedata.combining(c))
    return kept if kept.isascii() else f"<U+{ord(character):04X}>"


def wrap(text: str, width: int, hanging: str = "") -> list[str]:
    """Lines of at most ``width`` characters (a longer word stays whole); ``hanging`` indents all but the first."""
    if 0 < len(text) <= width and text.isprintable() and text == text.strip():
        return [text]  # most are short, and looking for places to break takes long
    return textwrap.wrap(
        text, width, subsequent_indent=hanging, break_long_words=False, break_on_hyphens=False, expand_tabs=False
    )


def describe_load(load: Load, spelling: str) -> str:
    """What the remark of a load says: its name in the spec where the code's ``spelling`` is another, what it is, and its unit."""
    if load.quantity in ("", spelling):
        return load.about
    colon = ":" if load.about and not load.about.startswith("[") else ""
    return f"{load.quantity}{colon} {load.about}".strip()


def describe_guard(guard: Guard, value: str) -> str:
    """What a guard's comment says: what is singular, and by which value where its text in the code is short."""
    if not 0 < len(value) <= SHORT:
        return guard.what
    nearly = "" if guard.scale == Number(Fraction(0)) else "nearly "
    return f"{guard.what}, if {value} is {nearly}0"


def show_origin(origin: Origin) -> str:
    """``(I.2.15) chaplygin_sleigh.yaml:14:4``, or nothing."""
    return f"({origin.equation}) {origin.place}".rstrip() if origin.equation else origin.place
