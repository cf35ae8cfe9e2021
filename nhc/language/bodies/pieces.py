"""Texts of expressions put together from parts, each character with its place in the spec.

What a spec says in short (``bodies``) is written out in the language itself.  Mistakes in the parts that a user wrote are then
reported where they stand, and everything that reads or edits specs reads what it always does.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from fractions import Fraction

from nhc.diagnostics import Span
from nhc.language.expressions.names import FUNCTIONS, continues_name, fold, starts_name
from nhc.language.expressions.syntax import Binary, Name, Negate, Number, Syntax
from nhc.language.shape import literal
from nhc.language.yaml_tree.nodes import Text
from nhc.records import record

SUM, PRODUCT, ATOM = range(3)
_WORD = re.compile(r"(?<![\w.])[^\W\d]\w*")  # what follows a digit or a point belongs to a number, as in 1e5
Triple = tuple["Piece", "Piece", "Piece"]


@record
class Piece:
    """A text without the ``minus`` in front of it; ``places`` has one offset for each character, ``binds`` is SUM to ATOM.

    ``number`` is its value where it is a number.
    """

    text: str
    places: tuple[int, ...]
    binds: int = ATOM
    minus: bool = False
    number: Fraction | None = None

    @property
    def is_zero(self) -> bool:
        """Whether it is the number 0."""
        return self.number == 0

    @property
    def is_name(self) -> bool:
        """Whether it is a name and nothing else."""
        return self.binds == ATOM and not self.minus and self.number is None and self.text.isidentifier()

    @property
    def shown(self) -> Piece:
        """The same with its minus as a part of the text; it stands before the whole of a sum."""
        if not self.minus:
            return self
        whole = self.within(PRODUCT)
        binds = SUM if whole.binds == ATOM else whole.binds
        return Piece(f"-{whole.text}", (whole.places[0], *whole.places), binds, number=self.number)

    def negative(self) -> Piece:
        """The same with the other sign."""
        number = -self.number if self.number is not None else None
        return self if self.is_zero else Piece(self.text, self.places, self.binds, not self.minus, number)

    def within(self, least: int) -> Piece:
        """The text, in parentheses where it binds less than ``least``."""
        if self.binds >= least:
            return self
        places = (self.places[0], *self.places, self.places[-1])
        return Piece(f"({self.text})", places, ATOM, self.minus, self.number)

    def as_text(self, span: Span) -> Text:
        """A node of the spec; ``span`` stands for what has no place."""
        made = self.shown
        return Text(made.text, span, True, (*made.places, made.places[-1] + 1))


def write(text: str, place: int, binds: int = ATOM) -> Piece:
    """A text that stands for what is declared at ``place``."""
    number = Fraction(text) if text.isdigit() else None
    return Piece(text, (place,) * len(text), binds, number=number)


def piece_of(text: Text, tree: Syntax) -> Piece:
    """What a user wrote, and the tree of it."""
    start = len(text.value) - len(text.value.lstrip())
    shown = text.value.strip()
    places = tuple(text.offsets[start : start + len(shown)]) if text.offsets else (text.span.start,) * len(shown)
    number, binds = literal(tree), _binding(tree, shown)
    minus = shown[0] == "-" and binds != SUM
    if minus:
        cut = len(shown) - len(shown[1:].lstrip())
        return Piece(shown[cut:], places[cut:], binds, True, number)
    return Piece(shown, places, binds, number=number)


def names_in_text(text: str) -> set[str]:
    """The names in an expression, without those of functions; read off its letters, which is quick."""
    words = _WORD.findall(text) if text.isascii() else _words_of(text)
    return {fold(word) for word in words} - FUNCTIONS.keys()


def _words_of(text: str) -> list[str]:
    """The same where a name may hold combining marks, which are no letters to a regular expression."""
    found, start = list[str](), -1
    for k, character in enumerate(f"{text} "):
        if not continues_name(character):
            word = text[start:k] if start >= 0 else ""
            if word and starts_name(word[0]) and text[start - 1 : start] != ".":
                found.append(word)
            start = -1
        elif start < 0:
            start = k
    return found


def _binding(tree: Syntax, text: str) -> int:
    match tree:
        case Binary():
            return SUM if tree.op in "+-" else PRODUCT
        case Negate():
            return ATOM if text[0] == "(" or isinstance(tree.operand, Number | Name) else PRODUCT
        case _:
            return ATOM


# --- arithmetic -----------------------------------------------------------------------------------------------


def join(parts: Sequence[str | Piece], binds: int, place: int, minus: bool = False) -> Piece:
    """Parts one behind the other; what is written between has ``place``."""
    pieces = [write(part, place) if isinstance(part, str) else part for part in parts]
    return Piece("".join(p.text for p in pieces), tuple(k for p in pieces for k in p.places), binds, minus)


def add(terms: Sequence[Piece], place: int) -> Piece:
    """The sum of the terms that are not 0; a sign between them has the place of the term that it stands before."""
    kept = [term for term in terms if not term.is_zero]
    if not kept:
        return write("0", place)
    if len(kept) == 1:
        return kept[0]
    parts: list[str | Piece] = [kept[0].shown]
    for term in kept[1:]:
        inner = term.within(ATOM) if term.text[0] == "-" else term
        shown = inner.within(PRODUCT) if term.minus else inner
        parts += [write(" - " if term.minus else " + ", shown.places[0]), shown]
    return join(parts, SUM, place)


def multiply(first: Piece, second: Piece, place: int) -> Piece:
    """The product; a factor 0 or 1 is not written."""
    for factor, other in ((first, second), (second, first)):
        if factor.is_zero:
            return factor
        if factor.number == 1:
            return other
        if factor.number == -1:
            return other.negative()
    return join([first.within(PRODUCT), "*", second.within(PRODUCT)], PRODUCT, place, first.minus != second.minus)


def halve(piece: Piece, place: int) -> Piece:
    """Half of it."""
    return piece if piece.is_zero else join([piece.within(PRODUCT), "/2"], PRODUCT, place, piece.minus)


def square(piece: Piece, place: int) -> Piece:
    """Its square."""
    return piece if piece.is_zero else join([piece.within(ATOM), "^2"], PRODUCT, place)


def rate(piece: Piece, place: int) -> Piece:
    """The time derivative of a position."""
    return join([piece if piece.is_name else piece.shown.within(ATOM + 1), "'"], ATOM, place)


def cosine(angle: Piece, place: int) -> Piece:
    """cos(angle), which knows no sign."""
    return write("1", place) if angle.is_zero else join(["cos(", angle, ")"], ATOM, place)


def sine(angle: Piece, place: int) -> Piece:
    """sin(angle), which takes the sign in front of it."""
    return angle if angle.is_zero else join(["sin(", angle, ")"], ATOM, place, angle.minus)


# --- vectors --------------------------------------------------------------------------------------------------


def each(make: Callable[[int], Piece]) -> Triple:
    """Three components."""
    return make(0), make(1), make(2)


def plus(first: Triple, second: Triple, place: int) -> Triple:
    """The sum of two vectors."""
    return each(lambda k: add([first[k], second[k]], place))


def minus(first: Triple, second: Triple, place: int) -> Triple:
    """Their difference."""
    return each(lambda k: add([first[k], second[k].negative()], place))


def dot(first: Triple, second: Triple, place: int) -> Piece:
    """The scalar product."""
    return add([multiply(a, b, place) for a, b in zip(first, second, strict=True)], place)


def cross(first: Triple, second: Triple, place: int) -> Triple:
    """The vector product."""

    def component(k: int) -> Piece:
        i, j = (k + 1) % 3, (k + 2) % 3
        return add([multiply(first[i], second[j], place), multiply(first[j], second[i], place).negative()], place)

    return each(component)


def turn(components: Triple, axis: int, angle: Piece, place: int) -> Triple:
    """The components of a vector on axes that are turned by ``angle`` about one of them."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    c, s = cosine(angle, place), sine(angle, place)
    made = list(components)
    made[i] = add([multiply(c, components[i], place), multiply(s, components[j], place)], place)
    made[j] = add([multiply(c, components[j], place), multiply(s, components[i], place).negative()], place)
    return made[0], made[1], made[2]
