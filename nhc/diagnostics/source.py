"""A source text and places in it."""

from __future__ import annotations

from bisect import bisect_right
from functools import cached_property

from nhc.records import record


@record
class Span:
    """A half-open range ``[start, end)`` of character offsets into one source's text."""

    start: int
    end: int


@record
class Source:
    """A text with the path that it is to be named by (``<stdin>`` for standard input).

    ``bases`` are the texts that a spec extends, the nearest first; their offsets follow on those of the text, one apart.
    """

    path: str
    text: str
    bases: tuple[Source, ...] = ()

    def find(self, offset: int) -> tuple[Source, int]:
        """Return the text that an offset falls into, this one or one of its bases, and the offset of its start."""
        start = 0
        for part in (self, *self.bases):
            if offset <= start + len(part.text):
                return part, start
            start += len(part.text) + 1
        return self, 0

    @cached_property
    def _starts(self) -> tuple[int, ...]:
        starts = [0]
        at = self.text.find("\n")
        while at >= 0:
            starts.append(at + 1)
            at = self.text.find("\n", at + 1)
        return tuple(starts)

    def position(self, offset: int) -> tuple[int, int]:
        """Return the line and the column of an offset, both counted from 1, in characters; in its own base's text."""
        part, start = self.find(offset)
        if part is not self:
            return part.position(offset - start)
        offset = max(0, min(offset, len(self.text)))
        line = bisect_right(self._starts, offset)
        return line, offset - self._starts[line - 1] + 1

    def line(self, number: int) -> str:
        """Return a line by its number (from 1), without its end; empty outside of the text."""
        if not 1 <= number <= len(self._starts):
            return ""
        start = self._starts[number - 1]
        end = self._starts[number] - 1 if number < len(self._starts) else len(self.text)
        return self.text[start:end].rstrip("\r")
