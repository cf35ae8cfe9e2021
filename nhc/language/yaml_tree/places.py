"""Which character of a YAML scalar stands where in the source."""

from __future__ import annotations

from collections.abc import Sequence

_WIDTHS = {"x": 4, "u": 6, "U": 10}
"""Characters of an escape by its letter; all others take two."""


def align(text: str, start: int, end: int, value: str, style: str) -> Sequence[int]:
    """Return the offset in ``text`` of each character of a scalar's ``value``, and one for its end.

    ``[start, end)`` is the scalar's place with its quotes or block header. Line folding only trades white space, so all
    other characters are met in their order. Empty where that is not so (a line end that is escaped in double quotes).
    """
    if style in ("'", '"'):
        start, end = start + 1, end - 1
    elif style in ("|", ">"):
        line = text.find("\n", start)
        start = line + 1 if 0 <= line < end else end
    elif text[start:end] == value:
        return range(start, end + 1)
    offsets: list[int] = []
    at = start
    for character in value:
        if style == '"' and text[at : at + 1] == "\\":
            if text[at + 1] == "\n":
                return ()
            offsets.append(at)
            at += _WIDTHS.get(text[at + 1], 2)
            continue
        if character in " \t\n":
            offsets.append(min(at, end))
            if at < end and text[at] in " \t\n":
                at += 1
            continue
        while at < end and text[at] in " \t\n":
            at += 1
        if at >= end or text[at] != character:
            return ()
        offsets.append(at)
        at += 2 if style == "'" and character == "'" else 1
    return (*offsets, at)
