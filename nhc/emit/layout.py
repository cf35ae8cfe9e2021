"""Lines of limited width from a run of pieces."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

_ENOUGH = 0.45
"""Share of a line that must be full before a break at a better place is preferred to a later one."""

_DEEP = 100
"""As many parentheses as no expression has."""


LAST = 10_000
"""Of places where a line ends only if it has no other, such as between the factors of a product; deeper than any expression."""


class Piece(NamedTuple):
    """A text with its width; ``breaks`` is 0, or the depth of parentheses (1: none) of a place where a line may end before it.

    ``opens`` stands in place of the text where it opens a line: a factor that goes on there needs a sign.
    """

    text: str
    width: float
    breaks: int = 0
    opens: str = ""


def add_term(found: list[Piece], negative: bool, term: Sequence[Piece], width: Callable[[str], float]) -> None:
    """Put a term of a sum behind those that are there; a line may end before its sign."""
    if len(term) > 1 and term[0].text == "-":  # a minus inside a product that the sum did not see
        negative, term = not negative, term[1:]
    if found:
        sign = " - " if negative else " + "
        found.append(Piece(sign, width(sign), 1))
    elif negative:
        found.append(Piece("-", width("-")))
    found += term


def nest(pieces: Iterable[Piece]) -> list[Piece]:
    """The pieces one pair of parentheses deeper."""
    return [piece._replace(breaks=piece.breaks + 1) if piece.breaks else piece for piece in pieces]


def hold(pieces: Sequence[Piece], narrow: float) -> list[Piece]:
    """What stands in the parentheses of a function: a narrow argument is broken only where nothing else is."""
    deep = _DEEP if total(pieces) <= narrow else 1
    return [piece._replace(breaks=piece.breaks + deep) if piece.breaks else piece for piece in pieces]


def fill(pieces: Sequence[Piece], first: float, rest: float) -> list[str]:
    """The pieces on lines no wider than ``first`` and ``rest``, unless a single unbreakable run is.

    A line ends where the parentheses are least deep, as long as it is reasonably full.
    """
    lines: list[str] = []
    start, limit = 0, first
    while start < len(pieces):
        end = _line_end(pieces, start, limit)
        head = (pieces[start].opens if start else "") or pieces[start].text
        lines.append(head + "".join(piece.text for piece in pieces[start + 1 : end]))
        start, limit = end, rest
    return lines or [""]


def _line_end(pieces: Sequence[Piece], start: int, limit: float) -> int:
    used = 0.0
    places: list[tuple[int, float]] = []
    spare = 0  # the last place that is taken only where there is no other
    for k in range(start, len(pieces)):
        if pieces[k].breaks >= LAST and k > start:
            spare = k
        elif pieces[k].breaks and k > start:
            places.append((k, used))
        used += pieces[k].width
        if used > limit and (places or spare):
            break
    else:
        return len(pieces)
    if not places:
        return spare
    full = [place for place in places if place[1] >= _ENOUGH * limit] or places[-1:]
    return min(full, key=lambda place: (pieces[place[0]].breaks, -place[0]))[0]


def total(pieces: Iterable[Piece]) -> float:
    """The width of the pieces on one line."""
    return sum(piece.width for piece in pieces)
