"""Units: their texts, their dimensions and, apart from these, their scales: ``km`` and ``m`` are both a length."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from types import MappingProxyType

from nhc.records import structure

_BASE = ("m", "kg", "s", "A", "K", "mol", "cd")
Dimension = tuple[int | Fraction, ...]  # the powers of metre, kilogram, second, ampere, kelvin, mole, candela


def _dimension(m: int = 0, kg: int = 0, s: int = 0, A: int = 0, K: int = 0, mol: int = 0, cd: int = 0) -> Dimension:
    return m, kg, s, A, K, mol, cd


ONE = _dimension()
SECOND = _dimension(s=1)
ENERGY = _dimension(m=2, kg=1, s=-2)

# International System of Units, 9th brochure (2019), tables 2, 4 and 8
_UNITS: dict[str, Dimension] = {
    "1": ONE,
    "rad": ONE,
    "sr": ONE,
    "deg": ONE,
    "m": _dimension(m=1),
    "g": _dimension(kg=1),
    "s": SECOND,
    "min": SECOND,
    "h": SECOND,
    "A": _dimension(A=1),
    "K": _dimension(K=1),
    "mol": _dimension(mol=1),
    "cd": _dimension(cd=1),
    "N": _dimension(m=1, kg=1, s=-2),
    "J": ENERGY,
    "eV": ENERGY,
    "W": _dimension(m=2, kg=1, s=-3),
    "Pa": _dimension(m=-1, kg=1, s=-2),
    "bar": _dimension(m=-1, kg=1, s=-2),
    "Hz": _dimension(s=-1),
    "C": _dimension(s=1, A=1),
    "V": _dimension(m=2, kg=1, s=-3, A=-1),
    "F": _dimension(m=-2, kg=-1, s=4, A=2),
    "ohm": _dimension(m=2, kg=1, s=-3, A=-2),
    "S": _dimension(m=-2, kg=-1, s=3, A=2),
    "Wb": _dimension(m=2, kg=1, s=-2, A=-1),
    "T": _dimension(kg=1, s=-2, A=-1),
    "H": _dimension(m=2, kg=1, s=-2, A=-2),
    "L": _dimension(m=3),
    "l": _dimension(m=3),
    "t": _dimension(kg=1),
}
# products of base units
_COHERENT = ("1", "rad", "sr", "N", "J", "W", "Pa", "Hz", "C", "V", "F", "ohm", "S", "Wb", "T", "H")
_PREFIXES = {
    **{
        "da": 1,
        "Q": 30,
        "R": 27,
        "Y": 24,
        "Z": 21,
        "E": 18,
        "P": 15,
        "T": 12,
        "G": 9,
        "M": 6,
        "k": 3,
        "h": 2,
        "d": -1,
        "c": -2,
    },
    **{"m": -3, "u": -6, "n": -9, "p": -12, "f": -15, "a": -18, "z": -21, "y": -24, "r": -27, "q": -30},
    **{"\u00b5": -6, "\u03bc": -6},
}  # with their powers of ten
_FACTORS = (2.0, 3.0, 5.0, math.pi, 1.602176634e-19)
Scale = tuple[int | Fraction, ...]  # powers of these factors
# of the product of base units; 1 for others
_SCALES: dict[str, Scale] = {
    "deg": (-2, -2, -1, 1, 0),
    "g": (-3, 0, -3, 0, 0),
    "t": (3, 0, 3, 0, 0),
    "min": (2, 1, 1, 0, 0),
    "h": (4, 2, 2, 0, 0),
    "eV": (0, 0, 0, 0, 1),
    "bar": (5, 0, 5, 0, 0),
    "L": (-3, 0, -3, 0, 0),
    "l": (-3, 0, -3, 0, 0),
}
_UNPREFIXED = ("1", "min", "h", "deg")
_ENLARGED = {"t": ("da", *"QRYZEPTGMkh")}  # `ft` is a foot to those who write it, and no unit here
_LETTERS = r"[A-Za-z\u00b5\u03bc\u03a9\u2126]+|1"
_WORD = re.compile(rf"\s*(?:({_LETTERS})|(\*\*|[*/^()\u00b7\u22c5])|([-+]?[0-9]+)|([\u00b2\u00b3]))")
_EXPONENT = re.compile(r"\s*([-+]?[0-9]+)")
_ORDER = {"kg": 0, "m": 1}  # mass and length are written first
SPELLING = "units are written like `kg*m^2/s^2`, `N*m`, `rad`, `1`"


_WORDS = {
    **dict.fromkeys(("sec", "secs", "second", "seconds"), "s"),
    **dict.fromkeys(("meter", "meters", "metre", "metres"), "m"),
    **dict.fromkeys(("kilogram", "kilograms"), "kg"),
    **dict.fromkeys(("gram", "grams", "gm"), "g"),
    **dict.fromkeys(("minute", "minutes"), "min"),
    **dict.fromkeys(("hour", "hours"), "h"),
    **dict.fromkeys(("radian", "radians", "rads"), "rad"),
    **dict.fromkeys(("degree", "degrees"), "deg"),
    **{"newton": "N", "joule": "J", "watt": "W", "hertz": "Hz", "pascal": "Pa", "kelvin": "K", "ampere": "A", "volt": "V"},
    **{"newtons": "N", "joules": "J", "watts": "W", "volts": "V", "amperes": "A", "none": "1"},
}  # fmt: skip
_TOLD = {
    **dict.fromkeys(("rpm", "rev", "turn", "turns"), "write `rad` or `rad/s`, and values times 2*pi: none is converted"),
    **dict.fromkeys(("degc", "degf", "celsius", "fahrenheit"), "write `K`: a unit has no zero of its own here"),
}  # fmt: skip


class UnitError(Exception):
    """A text is no unit; ``start`` and ``end`` are offsets in it; ``help`` says what to write."""

    def __init__(self, message: str, start: int, end: int, help: str = SPELLING) -> None:
        super().__init__(message)
        self.message = message
        self.start = start
        self.end = end
        self.help = help


@cache
def multiply(left: Dimension, right: Dimension) -> Dimension:
    """Return the dimension of a product."""
    return tuple(first + second for first, second in zip(left, right, strict=True))


@cache
def raise_to(base: Dimension, power: int | Fraction) -> Dimension:
    """Return the dimension of a power."""
    raised = [part * power for part in base]
    return tuple(part.numerator if part.denominator == 1 else part for part in raised)


def factor(scale: Scale) -> float:
    """The number that a scale stands for."""
    return math.prod(math.pow(base, power) for base, power in zip(_FACTORS, scale, strict=True))


def show(dimension: Dimension, words: Mapping[str, str] = MappingProxyType({})) -> str:
    """Return a dimension as a product of base units: ``kg*m^2/s^2``; ``1`` for none.  ``words``: other words for some of these."""
    named = sorted(zip(_BASE, dimension, strict=True), key=lambda item: _ORDER.get(item[0], 2))
    above = [_power(words.get(name, name), power) for name, power in named if power > 0]
    below = [_power(words.get(name, name), -power) for name, power in named if power < 0]
    return "/".join(["*".join(above) or "1", *below])


def _power(name: str, power: int | Fraction) -> str:
    if power == 1:
        return name
    return f"{name}^{power}" if power.denominator == 1 else f"{name}^({power})"


def _unit(text: str, start: int) -> Dimension:
    known = _known_unit(text)
    if known is not None:
        return known
    if text.casefold() in _TOLD:
        raise UnitError(f"unknown unit `{text}`", start, start + len(text), _TOLD[text.casefold()])
    meant = _WORDS.get(text.casefold(), "")
    for k in range(1, len(text)):
        if not meant and _known_unit(text[:k]) is not None and text[k:] in _UNITS:
            meant = f"{text[:k]}*{text[k:]}"
    raise UnitError(f"unknown unit `{text}`", start, start + len(text), f"write `{meant}`" if meant else SPELLING)


def _known_unit(text: str) -> Dimension | None:
    prefix, name = _cut(text)
    return None if prefix is None else _UNITS[name]


def _cut(text: str) -> tuple[str | None, str]:
    """The prefix of a unit and its name without; (None, "") for what is no unit."""
    name = text.replace("\u03a9", "ohm").replace("\u2126", "ohm")
    if name in _UNITS:
        return "", name
    for prefix in _PREFIXES:
        rest = name.removeprefix(prefix)
        if rest != name and rest in _UNITS and rest not in _UNPREFIXED and prefix in _ENLARGED.get(rest, _PREFIXES):
            return prefix, rest
    return None, ""


def _scale(text: str, _: int) -> Scale:
    prefix, name = _cut(text)
    scale, ten = _SCALES.get(name, (0,) * len(_FACTORS)), _PREFIXES.get(prefix or "", 0)
    return multiply(scale, (ten, 0, ten, 0, 0))


@structure
class _Word:
    kind: str  # unit, sign, power
    text: str
    start: int
    end: int


def _split(text: str) -> list[_Word]:
    words: list[_Word] = []
    at, size = 0, len(text.rstrip())
    while at < size:
        found = _WORD.match(text, at)
        after_power = bool(words) and words[-1].text in ("^", "**")
        number = _EXPONENT.match(text, at) if after_power else None
        if number:
            words.append(_Word("power", number.group(1), number.start(1), number.end(1)))
            at = number.end()
            continue
        if not found:
            while text[at] == " ":
                at += 1
            raise UnitError(f"unexpected `{text[at]}` in a unit", at, at + 1)
        kind = ("unit", "sign", "power", "power")[(found.lastindex or 1) - 1]
        group = found.lastindex or 1
        words.append(_Word(kind, found.group(group), found.start(group), found.end(group)))
        at = found.end()
    return words


def base_words(texts: Sequence[str]) -> dict[str, str] | None:
    """The words that units have for the base units: those of ``km/s`` and ``g`` are {"m": "km", "s": "s", "kg": "g"}.

    None where two differ (``m`` and ``cm``), where time is not in seconds, and where one is no product of base units (``kN``).
    """
    found: dict[str, str] = {"s": "s"}
    bases = {_UNITS[base]: base for base in _BASE if base != "kg"} | {_UNITS["g"]: "kg"}
    for name in {word.text for text in texts for word in _split(text) if word.kind == "unit"}:
        dimension = _unit(name, 0)
        if dimension in bases:
            own = {bases[dimension]: name}
        elif name in _COHERENT:
            own = {base: base for base, power in zip(_BASE, dimension, strict=True) if power}
        else:
            return None
        if any(found.setdefault(base, word) != word for base, word in own.items()):
            return None
    return found


def _may_stand(before: list[_Word], power: str = "^") -> bool:
    """Whether a power may stand behind these words: a number behind `^`; `^` or a raised one behind a unit or a parenthesis."""
    last = before[-1] if before else None
    if last is None or power in "^\u00b2\u00b3":
        return last is not None and (last.kind == "unit" or last.text == ")")
    return last.text in ("^", "**")


def parse_unit(text: str) -> Dimension:
    """Return the dimension of a unit's text; raises ``UnitError``.

    A product is written with ``*``, a space or a middle dot; ``/`` divides by the one factor after it; ``^`` takes an
    integer.
    """
    return _measure(text, ONE, _unit)


def parse_scale(text: str) -> Scale:
    """Return what a unit is of the product of base units: powers of 2, 3, 5, pi and the 1.602176634e-19 of an electronvolt."""
    return _measure(text, (0,) * len(_FACTORS), _scale)


def is_turned(scale: Scale) -> bool:
    """Say whether a unit of this scale is one of degrees."""
    return scale[_FACTORS.index(math.pi)] != 0


def _measure(text: str, one: Dimension, unit: Callable[[str, int], Dimension]) -> Dimension:
    """The powers that belong to a unit's text, given those of its factors."""
    words = _split(text)
    stack: list[tuple[Dimension, int]] = []  # what stands before each open parenthesis, and the sign of its power
    total, sign, last = one, 1, one
    wants = True
    for index, word in enumerate(words):
        follower = words[index + 1].text if index + 1 < len(words) else ""
        if word.kind == "unit":
            last = raise_to(unit(word.text, word.start), sign)
            total, sign, wants = multiply(total, last), 1, False
        elif word.text == "(":
            stack.append((total, sign))
            total, sign, wants = one, 1, True
        elif word.text == ")" and stack and not wants:
            before, sign = stack.pop()
            last = raise_to(total, sign)
            total, sign = multiply(before, last), 1
        elif word.kind == "power" and _may_stand(words[:index], word.text):
            power = {"\u00b2": 2, "\u00b3": 3}.get(word.text) or int(word.text)
            total = multiply(total, raise_to(last, power - 1))
        elif word.text in ("^", "**") and _may_stand(words[:index]) and follower.lstrip("+-").isdigit():
            continue
        elif word.text in ("*", "/", "\u00b7", "\u22c5") and not wants:
            sign, wants = (-1 if word.text == "/" else 1), True
        else:
            raise UnitError(f"unexpected `{word.text}` in a unit", word.start, word.end)
    if wants or stack:
        raise UnitError("a unit is incomplete", 0, len(text))
    return total
