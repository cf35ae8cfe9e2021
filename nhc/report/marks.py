"""Markers that are told apart by their shape, axes, and small SVG elements."""

from __future__ import annotations

import re
from collections.abc import Iterable
from html import escape
from textwrap import wrap

from nhc.report.ticks import Scale

_FOOT, _APART, _WIDE = 10.5, 17, 0.56  # size of small lines, from one to the next, width of a letter in sizes
_BROAD, _LEAST = 0.64, 8.0  # width of a bold letter in sizes; the smallest size of a title
SHAPES = ("circle", "square", "up", "diamond", "down", "hexagon")
_POINTS = {
    "square": ((-1, -1), (1, -1), (1, 1), (-1, 1)),
    "up": ((0, -1.3), (1.2, 0.9), (-1.2, 0.9)),
    "down": ((0, 1.3), (1.2, -0.9), (-1.2, -0.9)),
    "diamond": ((0, -1.4), (1.4, 0), (0, 1.4), (-1.4, 0)),
    "hexagon": ((-1.2, 0), (-0.6, -1.1), (0.6, -1.1), (1.2, 0), (0.6, 1.1), (-0.6, 1.1)),
}


def draw_marker(shape: str, x: float, y: float, size: float, colour: str, hollow: bool = False, more: str = "") -> str:
    """A marker about a point; a hollow one is white inside."""
    fill = "#ffffff" if hollow else colour
    look = f'fill="{fill}" stroke="{colour}" stroke-width="1.3"{more}'
    if shape == "circle":
        return f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{size:.2f}" {look}/>'
    points = " ".join(f"{x + a * size:.2f},{y + b * size:.2f}" for a, b in _POINTS[shape])
    return f'<polygon points="{points}" {look}/>'


def draw_cross(x: float, y: float, size: float, colour: str, more: str = "") -> str:
    """A cross: a run that failed."""
    a, b, c, d = x - size, y - size, x + size, y + size
    path = f"M{a:.2f} {b:.2f}L{c:.2f} {d:.2f}M{a:.2f} {d:.2f}L{c:.2f} {b:.2f}"
    return f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="2"{more}/>'


def draw_line(x1: float, y1: float, x2: float, y2: float, colour: str, more: str = "") -> str:
    """A straight line."""
    return f'<line x1="{x1:.2f}" y1="{y1:.2f}" x2="{x2:.2f}" y2="{y2:.2f}" stroke="{colour}"{more}/>'


def mark_code(text: str) -> str:
    """The text as HTML, with what stands between back-ticks in typewriter."""
    return re.sub(r"`([^`]*)`", r"<code>\1</code>", escape(text))


def draw_text(x: float, y: float, text: str, anchor: str = "start", more: str = "", colour: str = "#222222") -> str:
    """Text whose base line stands at y."""
    return f'<text x="{x:.2f}" y="{y:.2f}" text-anchor="{anchor}" fill="{colour}"{more}>{escape(text)}</text>'


def fit_size(letters: int, width: float, size: float) -> float:
    """The size, or the smaller one at which a line of so many letters is no wider than ``width``."""
    return min(size, width / (_WIDE * max(letters, 1)))


def draw_title(x: float, y: float, text: str, width: float, size: float = 17.0) -> str:
    """A bold title about x; one that is wider is set smaller, and of one that is wider still the middle is left out."""
    size = max(_LEAST, min(size, width / (_BROAD * max(len(text), 1))))
    most = int(width / (_BROAD * size))
    if len(text) > most:
        half = (most - 1) // 2
        text = f"{text[:half]}\u2026{text[-half:]}"
    return draw_text(x, y, text, "middle", f' font-size="{size:.3g}" font-weight="bold"')


def draw_box(x: float, y: float, width: float, height: float, fill: str, stroke: str = "none", more: str = "") -> str:
    """A rectangle."""
    place = f'x="{x:.2f}" y="{y:.2f}" width="{width:.2f}" height="{height:.2f}"'
    return f'<rect {place} fill="{fill}" stroke="{stroke}"{more}/>'


def draw_document(width: float, height: float, parts: Iterable[str], about: str) -> str:
    """A whole SVG document on white; ``about`` is read out to those who do not see it."""
    size = f"{width:.0f}", f"{height:.0f}"
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]}" height="{size[1]}" viewBox="0 0 {size[0]} {size[1]}" '
        f'font-family="sans-serif" font-size="12" role="img" aria-label="{escape(about)}">'
    )
    return "\n".join([head, '<rect width="100%" height="100%" fill="#ffffff"/>', *parts, "</svg>\n"])


def draw_foot(x: float, y: float, width: float, lines: Iterable[str]) -> tuple[list[str], float]:
    """Small grey lines below a picture, folded where one is longer than ``width``; and where the next one would stand."""
    most = int(width / (_FOOT * _WIDE))
    folded = [
        part for line in lines for part in wrap(line, most, subsequent_indent=4 * "\u00a0", break_on_hyphens=False)
    ]
    look = f' font-size="{_FOOT}"'
    parts = [draw_text(x, y + _APART * k, line, more=look, colour="#555555") for k, line in enumerate(folded)]
    return parts, y + _APART * len(folded)


def draw_axes(left: float, top: float, x: Scale, y: Scale) -> list[str]:
    """A plot's grid, its ticks' labels, its frame, and what makes values of the labels."""
    right, bottom = left + x.length, top + y.length
    parts = []
    for place, text in x.ticks:
        parts.append(draw_line(left + place, top, left + place, bottom, "#e4e4e4"))
        parts.append(draw_text(left + place, bottom + 16, text, "middle"))
    for place, text in y.ticks:
        parts.append(draw_line(left, bottom - place, right, bottom - place, "#e4e4e4"))
        parts.append(draw_text(left - 6, bottom - place + 4, text, "end"))
    parts.append(draw_box(left, top, x.length, y.length, "none", "#555555"))
    notes = ((left, top - 5, y.note, "start"), (right, bottom + 34, x.note, "end"))
    return [*parts, *(draw_text(a, b, text, anchor) for a, b, text, anchor in notes if text)]
