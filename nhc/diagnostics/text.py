"""Diagnostics for a person: with the lines of the source, or one line each."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable

from .data import Diagnostic, Label, Severity, localize
from .source import Source

_TAB = "    "
_WIDEST = 140  # columns of a source line that are shown; longer lines are cut around the mark
_COLOURS = {Severity.ERROR: "\x1b[1;31m", Severity.WARNING: "\x1b[1;33m", Severity.NOTE: "\x1b[1;36m"}
_BLUE, _BOLD, _PLAIN = "\x1b[1;34m", "\x1b[1m", "\x1b[0m"


def _show(character: str) -> tuple[str, int]:
    """Return what to print for a character and how many columns it takes; controls never reach the terminal."""
    if character == "\t":
        return _TAB, len(_TAB)
    category = unicodedata.category(character)
    if category in ("Cc", "Cf", "Zl", "Zp", "Cs"):
        return "\ufffd", 1
    if category in ("Mn", "Me"):
        return character, 0
    return character, 2 if unicodedata.east_asian_width(character) in "WF" else 1


def _clean(text: str) -> str:
    return "".join(_show(character)[0] if character != "\n" else "\n" for character in text)


class _Line:
    """One source line made printable, with the column at which each of its characters starts."""

    def __init__(self, text: str, focus: int) -> None:
        first = max(0, focus - _WIDEST // 2) if len(text) > _WIDEST else 0
        last = min(len(text), first + _WIDEST)
        self._first = first
        prefix = "..." if first else ""
        shown, self._columns, column = [prefix], [], len(prefix)
        for character in text[first:last]:
            self._columns.append(column)
            printed, width = _show(character)
            shown.append(printed)
            column += width
        self._columns.append(column)
        self.text = "".join(shown) + ("..." if last < len(text) else "")

    def column(self, index: int) -> int:
        return self._columns[max(0, min(index - self._first, len(self._columns) - 1))]


class _Paint:
    def __init__(self, colour: bool) -> None:
        self._colour = colour

    def __call__(self, code: str, text: str) -> str:
        return f"{code}{text}{_PLAIN}" if self._colour and text else text


def _mark(source: Source, label: Label, line: _Line, start_column: int) -> tuple[int, int]:
    """Return the printed column and the width of a label's mark in the line where it starts."""
    end_line, end_column = source.position(label.span.end)
    start_line, _ = source.position(label.span.start)
    last = end_column - 1 if end_line == start_line else len(source.line(start_line))
    start = line.column(start_column - 1)
    return start, max(1, line.column(last) - start)


def _snippet(source: Source, diagnostic: Diagnostic, paint: _Paint, gutter: int) -> list[str]:
    colour = _COLOURS[diagnostic.severity]
    bar = paint(_BLUE, " " * gutter + " |")
    placed: dict[int, list[tuple[Label, int, bool]]] = {}
    for index, label in enumerate(diagnostic.labels):
        number, column = source.position(label.span.start)
        placed.setdefault(number, []).append((label, column, index == 0))
    out, previous = [bar], 0
    for number in sorted(placed):
        if previous and number > previous + 1:
            out.append(paint(_BLUE, "..."))
        previous = number
        labels = placed[number]
        line = _Line(source.line(number), min(column for _, column, _ in labels) - 1)
        out.append(f"{paint(_BLUE, f'{number:>{gutter}} |')} {line.text}".rstrip())
        for label, column, primary in labels:
            start, width = _mark(source, label, line, column)
            mark = ("^" if primary else "-") * width
            words = f"{mark} {_clean(label.text)}".rstrip()
            out.append(f"{bar} {' ' * start}{paint(colour if primary else _BLUE, words)}")
    return out


def _render_one(source: Source, diagnostic: Diagnostic, paint: _Paint) -> str:
    source, diagnostic = localize(source, diagnostic)
    line, column = source.position(diagnostic.span.start)
    last = max(source.position(label.span.start)[0] for label in diagnostic.labels)
    gutter = len(str(last))
    head = paint(_COLOURS[diagnostic.severity], f"{diagnostic.severity.value}[{diagnostic.code}]")
    out = [f"{head}{paint(_BOLD, ': ' + _clean(diagnostic.message))}"]
    out.append(f"{' ' * gutter}{paint(_BLUE, '-->')} {_clean(source.path)}:{line}:{column}")
    if source.text:
        out.extend(_snippet(source, diagnostic, paint, gutter))
    tail = [("note", note) for note in diagnostic.notes] + [("help", text) for text in diagnostic.help]
    if tail and source.text:
        out.append(paint(_BLUE, " " * gutter + " |"))
    for kind, text in tail:
        indent = "\n" + " " * (gutter + 9)
        words = _clean(text).replace("\n", indent)
        out.append(f"{paint(_BLUE, ' ' * gutter + ' =')} {paint(_BOLD, kind + ':')} {words}")
    return "\n".join(out)


def render_text(source: Source, diagnostics: Iterable[Diagnostic], colour: bool = False) -> str:
    """Return the diagnostics with the lines they speak of; ends with a line end unless there are none."""
    paint = _Paint(colour)
    parts = [_render_one(source, diagnostic, paint) for diagnostic in diagnostics]
    return "\n\n".join(parts) + "\n" if parts else ""


def render_concise(source: Source, diagnostics: Iterable[Diagnostic]) -> str:
    """Return one line ``file:line:column: severity[code]: message`` for each diagnostic."""
    out = []
    for diagnostic in diagnostics:
        line, column = source.position(diagnostic.span.start)
        message = _clean(diagnostic.message).replace("\n", " ")
        place = f"{_clean(source.find(diagnostic.span.start)[0].path)}:{line}:{column}"
        out.append(f"{place}: {diagnostic.severity.value}[{diagnostic.code}]: {message}\n")
    return "".join(out)
