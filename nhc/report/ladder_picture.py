"""A ladder of approximate models as a picture: size and time against error; and as a page of its own."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import replace
from html import escape

from nhc.emit.environment import create_environment
from nhc.report.labels import Box, place_numbers
from nhc.report.ladder import list_rungs, note_longer, print_how, reduced_spec
from nhc.report.marks import (
    draw_axes,
    draw_document,
    draw_foot,
    draw_line,
    draw_marker,
    draw_text,
    draw_title,
    mark_code,
)
from nhc.report.ticks import linear_scale, log_scale
from nhc.study.chart.words import duration
from nhc.study.simplify.ladder import Ladder, Rung
from nhc.version import __version__

WIDTH, LEFT, TOP = 1060, 70, 66
PLOT_WIDTH, PLOT_HEIGHT, SECOND = 420, 290, 606
HEADROOM = 1.08  # above the largest model, for its number
LEAST = 1e-16  # errors that are zero stand here on the logarithmic axis
MODEL, LIMIT = "#0072b2", "#d55e00"
BOLD = ' font-weight="bold"'


def draw_ladder(ladder: Ladder, listed: bool = True) -> str:
    """Operations and time of a run against the error, each model with its number; below them, where they are to be ``listed``, what
    the numbers stand for.
    """
    title = f"{ladder.system}, scene {ladder.scene}: size of the model against its error"
    parts = [draw_title(WIDTH / 2, 26, title, WIDTH - 20)]
    parts += _draw_plot(ladder, LEFT, "operations of the right-hand side", lambda r: float(r.size.operations))
    unit, name = _unit(max(rung.price.run for rung in ladder.rungs))
    parts += _draw_plot(ladder, SECOND, f"processor time of one run [{name}]", lambda r: r.price.run / unit)
    below = TOP + PLOT_HEIGHT + 66.0
    if listed:
        lines, below = _draw_list(ladder, below)
        parts += lines
    lines, below = _draw_notes(ladder, below)
    return draw_document(WIDTH, below + 16, [*parts, *lines], title)


def _unit(seconds: float) -> tuple[float, str]:
    return next(((s, u) for s, u in ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs")) if seconds >= s), (1e-9, "ns"))


def _draw_plot(ladder: Ladder, left: float, label: str, value: Callable[[Rung], float]) -> list[str]:
    errors = [max(rung.error, LEAST) for rung in ladder.rungs]
    values = [value(rung) for rung in ladder.rungs]
    x = log_scale(min(errors), max(*errors, ladder.tolerance), PLOT_WIDTH, 8)
    y = linear_scale(0.0, max(values) * HEADROOM, PLOT_HEIGHT, 6)
    bottom = TOP + PLOT_HEIGHT
    label = f"{label} ({y.note})" if y.note else label
    parts = [*draw_axes(left, TOP, x, replace(y, note="")), draw_text(left, TOP - 9, label, more=BOLD)]
    below = "largest error of what is needed, relative"
    parts.append(draw_text(left + PLOT_WIDTH / 2, bottom + 34, below, "middle"))
    limit = left + x.place(ladder.tolerance)
    parts.append(draw_line(limit, TOP, limit, bottom, LIMIT, ' stroke-width="1.6" stroke-dasharray="6 3"'))
    parts.append(draw_text(limit - 5, TOP + 14, "tolerance", "end", colour=LIMIT))
    places = [(left + x.place(e), bottom - y.place(v)) for e, v in zip(errors, values, strict=True)]
    path = " ".join(f"{a:.2f},{b:.2f}" for a, b in places)
    parts.append(f'<polyline points="{path}" fill="none" stroke="{MODEL}" stroke-width="1.6"/>')
    parts += [
        draw_marker("circle", a, b, 4.2, MODEL, k == 0, f' class="point" data-k="{k}"')
        for k, (a, b) in enumerate(places)
    ]
    frame = Box(left, TOP, left + PLOT_WIDTH + 20, bottom)
    numbers = place_numbers(
        [str(k) for k in range(len(places))], places, [places, [(limit, bottom), (limit, float(TOP))]], frame
    )
    return [*parts, *(draw_text(n.x, n.y, n.text, more=BOLD) for n in numbers if n is not None)]


def _draw_list(ladder: Ladder, top: float) -> tuple[list[str], float]:
    columns = (LEFT - 40, LEFT - 10, LEFT + 70, LEFT + 155, LEFT + 272, LEFT + 338, LEFT + 408)
    head = ("", "equations", "operations", "right-hand side", "run", "error", "left out")
    parts = [draw_text(x, top, text, more=BOLD) for x, text in zip(columns, head, strict=True)]
    at = top + 18
    for row in list_rungs(ladder):
        cells = [*row[:-1], row[-1] if len(row[-1]) <= 88 else f"{row[-1][:85]}..."]
        parts += [draw_text(x, at, text) for x, text in zip(columns, cells, strict=True)]
        at += 18
    return parts, at + 10


def _draw_notes(ladder: Ladder, top: float) -> tuple[list[str], float]:
    foot = (
        f"measured {print_how(ladder)}; confirmed by {ladder.confirmed}",
        "0, hollow: the full model, at the reference's own error",
        f"machine: {ladder.machine}",
    )
    return draw_foot(LEFT - 40, top, WIDTH - 2 * (LEFT - 40), foot)


def make_ladder_page(ladder: Ladder) -> str:
    """The picture with readings under the pointer, the ladder as a table, what stays and why, and the smallest spec."""
    context: dict[str, object] = {
        "title": escape(f"{ladder.system}, scene {ladder.scene}: models within {ladder.tolerance:g}"),
        "how": escape(
            " ".join(
                [
                    f"Needed: {', '.join(ladder.needs)}. Measured {print_how(ladder)}; confirmed by {ladder.confirmed}.",
                    *(f"{note[0].upper()}{note[1:]}." for note in note_longer(ladder)),
                ]
            )
        ),
        "chart": draw_ladder(ladder, listed=False),
        "needs": [escape(need) for need in ladder.needs],
        "rungs": [
            ([mark_code(cell) for cell in row], [f"{error:.1e}" for error in rung.errors])
            for row, rung in zip(list_rungs(ladder), ladder.rungs, strict=True)
        ],
        "kept": [(mark_code(kept.about), mark_code(kept.reason)) for kept in ladder.kept],
        "spec": escape(reduced_spec(ladder)),
        "data": json.dumps(_readings(ladder.rungs, ladder.needs), ensure_ascii=False).replace("<", "\\u003c"),
        "version": __version__,
    }
    return create_environment().get_template("html/ladder.html.jinja").render(context)


def _readings(rungs: Sequence[Rung], needs: Sequence[str]) -> list[str]:
    return [
        "\n".join(
            (
                f"{k}: without {rung.dropped}"
                if rung.dropped
                else "0: the full model; its errors are the reference's own",
                f"{rung.size.states} equations, {rung.size.operations} operations",
                f"right-hand side {duration(rung.price.rhs)}, run {duration(rung.price.run)}, {rung.size.calls} calls",
                *(f"error of {need}: {error:.1e}" for need, error in zip(needs, rung.errors, strict=True)),
            )
        )
        for k, rung in enumerate(rungs)
    ]
