"""The moving picture of a run: numbers of the trajectory for the page's script, which computes none of the motion."""

from __future__ import annotations

from nhc.report.svg import COLOURS
from nhc.simulate.run import Trajectory

MOST_FRAMES = 2000


def describe_drawing(found: Trajectory) -> dict[str, object] | None:
    """Times, columns and shapes for the page; None where the spec draws nothing.

    A column is a list with one number for each time, or a single number where it stays the same; ``places`` of a shape
    index the columns as ``nhc.mechanics.drawing.Outline`` says.  Long runs are thinned by a stride.
    """
    sketch = found.job.sketch
    if not sketch.outlines or not found.drawn:
        return None
    stride = max(1, len(found.times) // MOST_FRAMES)
    rows = found.drawn[::stride]
    columns: list[float | list[float]] = []
    for k in range(len(sketch.nodes)):
        values = [_short(row[k]) for row in rows]
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
    times = [_short(t) for t in found.times[::stride]]
    return {"spatial": sketch.spatial, "times": times, "columns": columns, "shapes": shapes}


def _short(value: float) -> float:
    """Nine digits show no difference."""
    return float(f"{value:.9g}")
