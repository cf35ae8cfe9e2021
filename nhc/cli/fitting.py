"""Texts for people, fitted to the width of a terminal: what a pipe or a file gets is never touched.

Lines are broken between words.  What goes on under a column stays in its column where there is room, else it takes lines of
its own.  Tables in Markdown become columns, and records one under the other where even narrow columns are too wide.
"""

from __future__ import annotations

import re

LEAST = 30  # columns; on a narrower terminal lines are of this width
_ROOM = 24  # columns that a last column needs for its text to stay in it
_CELL = 10  # columns to which the cells of a table are narrowed at most
_GAP = re.compile(r" {2,}")
_COLOUR = re.compile(r"\x1b\[[0-9;]*m")
_PREFIX = re.compile(r"(?:= \w+: |[-*] )")
_AS_IT_IS = re.compile(r"\s*\d* ?\|[ ^]|\s*\d* \|$|\s*-+> ")  # a line of a spec with what marks its place
_BAR = re.compile(r"(?<!\\)\|")


def fit(text: str, width: int, hanging: int | None = None) -> str:
    """``text`` on lines no wider than ``width``, as far as its words allow.

    ``hanging`` is the indent of what goes on a further line, found from each line where it is left out.
    """
    width = max(width, LEAST)
    lines: list[str] = []
    rows: list[str] = []
    for line in text.split("\n"):
        if line.startswith("| ") and line.endswith(" |"):
            rows.append(line)
            continue
        lines += _fit_table(rows, width)
        rows = []
        lines += _fit_line(line, width, hanging)
    return "\n".join([*lines, *_fit_table(rows, width)])


def measure(text: str) -> int:
    """The columns that a text takes."""
    return len(_COLOUR.sub("", text))


def _fit_line(line: str, width: int, hanging: int | None) -> list[str]:
    if measure(line) <= width or _AS_IT_IS.match(_COLOUR.sub("", line)):
        return [line]
    body = line.lstrip(" ")
    indent = len(line) - len(body)
    prefix = _PREFIX.match(_COLOUR.sub("", body))
    if hanging is None:
        hanging = indent + (prefix.end() if prefix else 2)
    if width - hanging < _ROOM:
        hanging = 4
    return _place(body, indent, hanging, width)


def _place(body: str, indent: int, hanging: int, width: int) -> list[str]:
    """The columns of a line, each where it stands if it fits there, else below."""
    cells = _GAP.split(body)
    starts = [indent, *(indent + measure(body[: gap.end()]) for gap in _GAP.finditer(body))]
    lines = _wrap(" " * indent, cells[0], hanging, width)
    for k in range(1, len(cells)):
        under = max((start for start in starts[1 : k + 1] if _has_room(cells[k], width - start)), default=hanging)
        here = max(starts[k], measure(lines[-1]) + 2) if len(lines) == 1 else measure(lines[-1]) + 2
        last = k == len(cells) - 1
        if here + measure(cells[k]) <= width or (last and here == starts[k] and _has_room(cells[k], width - here)):
            head = lines.pop()
            lines += _wrap(head + " " * (here - measure(head)), cells[k], here, width)
        else:
            lines += _wrap(" " * under, cells[k], under, width)
    return lines


def _has_room(text: str, columns: int) -> bool:
    return columns >= max(_ROOM, max(map(measure, text.split(" "))))


def _wrap(head: str, text: str, hanging: int, width: int) -> list[str]:
    lines = [head]
    fresh = True
    for word in text.split(" "):
        if fresh:
            lines[-1] += word
        elif measure(lines[-1]) + 1 + measure(word) <= width:
            lines[-1] += " " + word
        else:
            lines.append(" " * hanging + word)
        fresh = False
    return lines


def _fit_table(rows: list[str], width: int) -> list[str]:
    """A table in Markdown as columns; those of words are narrowed, the widest first."""
    if len(rows) < 2:
        return rows
    cells = [[cell.strip().replace("\\|", "|") for cell in _BAR.split(row)[1:-1]] for row in rows]
    right = [cell.endswith(":") for cell in cells[1]]
    head, body = cells[0], cells[2:]
    widths = [max(len(row[k]) for row in [head, *body]) for k in range(len(head))]
    while sum(widths) + 2 * (len(widths) - 1) > width:
        wide = max(range(len(widths)), key=lambda k: 0 if right[k] else widths[k])
        words = (word for row in [head, *body] for word in row[wide].split(" "))
        if right[wide] or widths[wide] <= max(_CELL, max(map(len, words))):
            return _stack(head, body, width)
        widths[wide] -= 1
    rule = "  ".join("-" * size for size in widths)
    return [*_row(head, widths, right), rule, *(line for row in body for line in _row(row, widths, right))]


def _row(row: list[str], widths: list[int], right: list[bool]) -> list[str]:
    columns = [_wrap("", cell, 0, size) for cell, size in zip(row, widths, strict=True)]
    lines = []
    for k in range(max(map(len, columns))):
        parts = [column[k] if k < len(column) else "" for column in columns]
        lines.append("  ".join(p.rjust(n) if r else p.ljust(n) for p, n, r in zip(parts, widths, right, strict=True)))
    return [line.rstrip() for line in lines]


def _stack(head: list[str], body: list[list[str]], width: int) -> list[str]:
    """A record for each row: its first cell, then the others with their names."""
    lines = []
    for row in body:
        lines += _wrap("", row[0], 2, width)
        others = "; ".join(f"{name} {cell}" for name, cell in zip(head[1:], row[1:], strict=True))
        lines += _wrap("  ", others, 2, width)
    return lines
