"""The moving picture of a run: numbers of the trajectory for the page's script, which computes none of the motion."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TypeVar

from nhc.language.expressions.syntax import Binary, Name, Negate, Syntax
from nhc.language.spec import Figure
from nhc.report.svg import COLOURS
from nhc.simulate.run import Trajectory

MOST_FRAMES = 2000
Row = TypeVar("Row")


def describe_drawing(found: Trajectory) -> dict[str, object] | None:
    """Times, columns and shapes for the page; None where the spec draws nothing.

    A column is a list with one number for each time, or a single number where it stays the same; ``places`` of a shape
    index the columns as ``nhc.mechanics.resolving.drawing.Outline`` says.  Long runs are thinned by a stride.
    """
    sketch = found.job.sketch
    if not sketch.outlines or not found.drawn:
        return None
    rows = thin_rows(found.drawn, MOST_FRAMES)
    columns: list[float | list[float]] = []
    for k in range(len(sketch.nodes)):
        values = shorten([row[k] for row in rows])
        columns.append(values[0] if all(value == values[0] for value in values) else values)
    shapes = [
        {
            "kind": outline.kind,
            "name": outline.name,
            "trace": outline.trace,
            "colour": COLOURS[k % len(COLOURS)],
            "places": list(outline.places),
        }
        for k, outline in enumerate(sketch.outlines)
    ]
    return {
        "spatial": sketch.spatial,
        "axes": name_axes(found.job.system.spec.draw),
        "unit": found.job.system.spec.time_unit,
        "times": shorten(thin_rows(found.times, MOST_FRAMES)),
        "columns": columns,
        "shapes": shapes,
    }


def name_axes(figures: Sequence[Figure]) -> list[str]:
    """The letters of the picture's axes; with a minus where the shapes show minus the spec's own ``y`` or ``z``, as where its z
    points downwards.
    """
    names = []
    for axis, letter in enumerate("xyz"):
        trees = [place[axis] for figure in figures for place in (*figure.points, figure.at) if len(place) > axis]
        signs = {sign for tree in trees for name, sign in _list_terms(tree) if name == letter}
        names.append(f"\u2212{letter}" if signs == {-1} else letter)
    return names


def _list_terms(tree: Syntax) -> Iterator[tuple[str, int]]:
    """The names that are terms of a sum, with their signs."""
    stack = [(tree, 1)]
    while stack:
        node, sign = stack.pop()
        match node:
            case Name():
                yield node.name, sign
            case Negate():
                stack.append((node.operand, -sign))
            case Binary(op="+" | "-"):
                stack += [(node.left, sign), (node.right, sign if node.op == "+" else -sign)]


def thin_rows(rows: Sequence[Row], most: int) -> list[Row]:
    """Every k-th of the rows, so that they are not much more than ``most``, and the last: a motion is shown to its end."""
    return [*rows[: -1 : max(1, len(rows) // most)], *rows[-1:]]


def shorten(values: Sequence[float]) -> list[float]:
    """The values to nine digits of what they range over: more show no difference."""
    good = [value for value in values if math.isfinite(value)]
    size, span = max(map(abs, good), default=0.0), max(good, default=0.0) - min(good, default=0.0)
    digits = 9 if span <= 1e-12 * size else 9 + max(0, math.ceil(math.log10(size) - math.log10(span)))
    return [float(f"{value:.{min(digits, 17)}g}") for value in values]
