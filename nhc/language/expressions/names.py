"""The names of the language: functions, constants, Greek letters, and how a written name is folded."""

from __future__ import annotations

import unicodedata

# function -> number of arguments it takes: least and most
FUNCTIONS: dict[str, tuple[int, int]] = {
    "sin": (1, 1),
    "cos": (1, 1),
    "tan": (1, 1),
    "asin": (1, 1),
    "acos": (1, 1),
    "atan": (1, 1),
    "atan2": (2, 2),
    "sinh": (1, 1),
    "cosh": (1, 1),
    "tanh": (1, 1),
    "exp": (1, 1),
    "log": (1, 1),
    "sqrt": (1, 1),
    "abs": (1, 1),
    "sign": (1, 1),
    "min": (2, 2),
    "max": (2, 2),
}
DOT = "dot"  # dot(X) is the total time derivative of X
TIME = "t"
PI = "pi"
RESERVED = frozenset((*FUNCTIONS, DOT, TIME, PI))
ENERGIES = ("T", "U", "V", "energy")  # names of what nhc knows by itself; outputs may use them

_LOWER = (
    *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu", "nu"),
    *("xi", "omicron", "pi", "rho", "sigma", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega"),
)
_FINAL_SIGMA = 17  # it has no capital
GREEK: dict[str, str] = {chr(0x3B1 + index): name for index, name in enumerate(_LOWER)}
GREEK.update({chr(0x391 + index): name.capitalize() for index, name in enumerate(_LOWER) if index != _FINAL_SIGMA})
_TABLE = str.maketrans(GREEK)


def fold(name: str) -> str:
    """Return the one spelling of a name: NFKC, Greek letters by their English names (``θ1`` is ``theta1``)."""
    if name.isascii():
        return name
    # twice: a mark that combines with no Greek letter may combine with the last letter of its English name
    return unicodedata.normalize("NFKC", unicodedata.normalize("NFKC", name).translate(_TABLE))


def fold_typed(text: str) -> str:
    """The one spelling of a name or velocity as it is typed beside a spec: in an option, a table, a scene's ``need``."""
    return fold(text.replace("\u2032", "'").strip())


def starts_name(character: str) -> bool:
    """Say whether a name may start with this character: a letter of any script or ``_``."""
    return character == "_" or character.isalpha()


def continues_name(character: str) -> bool:
    """Say whether a name may go on with this character: a letter, a digit, ``_`` or a combining mark."""
    if character.isascii():
        return character == "_" or character.isalnum()
    return character.isalpha() or character.isdecimal() or unicodedata.category(character) in ("Mn", "Mc")


def is_name(text: str) -> bool:
    """Say whether a whole text is a name (folded or not); one whose folding is none, such as ``L·``, is not."""
    return _is_plain(text) and is_folded(fold(text))


def is_folded(name: str) -> bool:
    """Say whether a folded text is a name, so that it can be written and read again."""
    return _is_plain(name) and name.isidentifier()


def _is_plain(text: str) -> bool:
    return bool(text) and starts_name(text[0]) and all(continues_name(character) for character in text)
