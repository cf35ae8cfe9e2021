"""YAML as this language sees it: texts, lists and mappings with their places; no types beyond that."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.diagnostics import Span
from nhc.records import record


@record
class Text:
    """A scalar; ``plain`` says that it stands without quotes.

    ``offsets[i]`` is the place of character i in the source, with one more for the end; empty where escapes hide it.
    """

    value: str
    span: Span
    plain: bool
    offsets: Sequence[int] = ()

    def locate(self, start: int, end: int) -> Span:
        """Return the place of a part of the text; the whole text where the parts have no places of their own."""
        if not self.offsets:
            return self.span
        last = len(self.offsets) - 1
        first = self.offsets[min(start, last)]
        if end <= start:
            return Span(first, first)
        stop = self.offsets[min(end, last) - 1] + 1
        return Span(first, stop) if stop > first else self.span  # parts of a text that is put together stand anywhere


@record
class Items:
    """A list."""

    items: tuple[Node, ...]
    span: Span


@record
class Table:
    """A mapping; its keys are texts, each once."""

    entries: tuple[tuple[Text, Node], ...]
    span: Span

    def get(self, key: str) -> Node | None:
        """Return the value of a key, or None."""
        for text, node in self.entries:
            if text.value == key:
                return node
        return None


Node = Text | Items | Table


def describe(node: Node) -> str:
    """Say what a node is, for a message."""
    match node:
        case Text():
            return "a number" if node.plain and _is_number(node.value) else "a text"
        case Items():
            return "a list"
        case Table():
            return "a mapping"


def _is_number(value: str) -> bool:
    try:
        float(value)
    except ValueError:
        return False
    return True
