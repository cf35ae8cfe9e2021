"""Names written beside the lines of a panel, where they cover nothing: colours are lost on grey paper and to some eyes."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from nhc.records import record

SIZE = 10.5
_WIDE = 0.56  # of a letter, in sizes
_APART = 7.0  # pixels from a name to lines that are not its own
_STEP = 4.0  # pixels between the places that stand for a line
_LARGE, _MARK = 12.0, 4.2  # the size of numbers, and half of what stands at their places
_AROUND = ((7, -7), (-7, -7), (7, 15), (-7, 15), (9, 4), (-9, 4), (0, -8), (0, 17))
"""Where a number may stand: to the right of its place, or to the left, and by how much its base line is below it."""
Place = tuple[float, float]


@record
class Box:
    """What a name covers, in pixels."""

    left: float
    top: float
    right: float
    bottom: float

    def holds(self, place: Place) -> bool:
        return self.left <= place[0] <= self.right and self.top <= place[1] <= self.bottom

    def meets(self, other: Box) -> bool:
        across = self.left < other.right and other.left < self.right
        return across and self.top < other.bottom and other.top < self.bottom

    def within(self, other: Box) -> bool:
        across = other.left <= self.left and self.right <= other.right
        return across and other.top <= self.top and self.bottom <= other.bottom


@record
class Name:
    """A text whose base line begins at (x, y)."""

    text: str
    x: float
    y: float


def place_names(kinds: Sequence[tuple[str, Sequence[Sequence[Place]]]], frame: Box) -> list[Name]:
    """The name of each kind of lines, above or below a point or a middle of one of them, where it covers no line and no other name.

    It stands nearer to lines of its kind than to others.  Kinds come in the order of their importance, as their lines do; one that
    has no room beside its lines keeps none.
    """
    followed = [[place for line in lines for place in _follow(line)] for _, lines in kinds]
    made: list[Name] = []
    boxes: list[Box] = []
    for k, (text, lines) in enumerate(kinds):
        half = _WIDE * SIZE * len(text) / 2
        foreign = [place for j, places in enumerate(followed) if j != k for place in places]
        anchors = [place for line in lines for place in _anchors(line)]
        for name in (Name(text, x - half, y + below) for x, y in anchors for below in (-9.0, 16.0)):
            box = Box(name.x - 2, name.y - SIZE + 1, name.x + 2 * half + 2, name.y + 3)
            if box.within(frame) and _is_free(box, followed[k], foreign, boxes):
                boxes.append(box)
                made.append(name)
                break
    return made


def place_numbers(
    texts: Sequence[str], places: Sequence[Place], lines: Sequence[Sequence[Place]], frame: Box
) -> list[Name | None]:
    """A text beside each of the places, where it covers no other text and no place, and lines as little as may be; None where there
    is no room.
    """
    drawn = [place for line in lines for place in _follow(line)]
    marks = [Box(x - _MARK, y - _MARK, x + _MARK, y + _MARK) for x, y in places]
    boxes, made = list[Box](), list[Name | None]()
    for text, (x, y) in zip(texts, places, strict=True):
        wide = _WIDE * _LARGE * len(text)
        best: tuple[int, Name, Box] | None = None
        for right, below in _AROUND:
            left = x + (right if right > 0 else right - wide if right < 0 else -wide / 2)
            box = Box(left - 1, y + below - _LARGE + 2, left + wide + 1, y + below + 1)
            if not box.within(frame) or any(map(box.meets, (*boxes, *marks))):
                continue
            covered = sum(map(box.holds, drawn))
            if best is None or covered < best[0]:
                best = covered, Name(text, left, y + below), box
        made.append(best[1] if best else None)
        boxes += [best[2]] if best else []
    return made


def _is_free(box: Box, own: Sequence[Place], foreign: Sequence[Place], boxes: Sequence[Box]) -> bool:
    if any(map(box.meets, boxes)) or any(map(box.holds, own)):
        return False
    wide = Box(box.left - _APART, box.top - _APART, box.right + _APART, box.bottom + _APART)
    return not any(map(wide.holds, foreign))


def _anchors(line: Sequence[Place]) -> list[Place]:
    """Its ends, then its other points and the middles between them."""
    middles = [((a + c) / 2, (b + d) / 2) for (a, b), (c, d) in pairwise(line)]
    return [*dict.fromkeys((line[0], line[-1])), *line[1:-1], *middles]


def _follow(line: Sequence[Place]) -> list[Place]:
    """Places along a line that are close together."""
    found = list(line)
    for (a, b), (c, d) in pairwise(line):
        count = int(max(abs(c - a), abs(d - b)) / _STEP)
        found += [(a + (c - a) * k / (count + 1), b + (d - b) * k / (count + 1)) for k in range(1, count + 1)]
    return found
