"""Models held against the finest one, as one picture."""

from __future__ import annotations

import math
from dataclasses import replace

from nhc.report.marks import (
    draw_cross,
    draw_document,
    draw_foot,
    draw_line,
    draw_marker,
    draw_text,
    draw_title,
    fit_size,
)
from nhc.report.panel import Panel, Style, draw_panel, style_of
from nhc.report.svg import Axis, Chart, Series, dash_of, draw_inside, time_axis
from nhc.study.chart.case import RESOLVED, Result
from nhc.study.chart.fidelity import Comparison
from nhc.study.chart.words import duration

WIDTH, LEFT = 1060, 74
MAIN_WIDTH, MAIN_HEIGHT = 955, 400
CURVE_WIDTH, CURVE_HEIGHT = 505, 270
BOLD = ' font-weight="bold"'
MOST_CURVES = 12


def draw_comparison(made: Comparison) -> str:
    """The whole SVG document: time against error, then the needed quantities of all models."""
    results = swap_names(made)
    style = replace(style_of(results), single=True)
    legend, below = _draw_models(made, style, 54)
    main = Panel(
        f"time against error, held against {made.finest}",
        f"largest error of {', '.join(made.needs)} on the scene, relative to each quantity's largest magnitude",
        "processor time of one run [s], the fastest of the repeats",
        lambda r: r.error,
        lambda r: r.best,
        *(LEFT, below + 34, MAIN_WIDTH, MAIN_HEIGHT, RESOLVED * made.reference.error, True),
    )
    parts = [*legend, *draw_panel(main, results, style), *_draw_failures(results, style, main)]
    at = main.top + MAIN_HEIGHT + 66
    curves, bottom = _draw_curves(made, at)
    foot, below = _draw_foot(made, bottom + 20)
    parts += [*curves, *foot]
    total = below + 8
    title = f"scene {made.scene}: models against {made.finest}"
    return draw_document(WIDTH, total, [draw_title(WIDTH / 2, 26, title, WIDTH - 20), *parts], title)


def swap_names(made: Comparison) -> tuple[Result, ...]:
    """The results with the model in the place of the method: colours tell models apart here, shapes methods."""
    return tuple(
        replace(r, case=replace(r.case, formulation=r.case.method, method=r.case.formulation)) for r in made.results
    )


def _draw_models(made: Comparison, style: Style, top: float) -> tuple[list[str], float]:
    """A row for each model, and the shapes where there are several methods."""
    columns = (LEFT, LEFT + 300, LEFT + 390, LEFT + 490, LEFT + 610)
    heads = ("model", "state", "operations", "right-hand side", "run at the scene's tolerance")
    parts = [draw_text(x, top, text, more=BOLD) for x, text in zip(columns, heads, strict=True)]
    worst = LEFT + 820
    parts.append(draw_text(worst, top, "error", more=BOLD))
    at = top + 19
    for rung in made.rungs:
        colour = style.colour(rung.name)
        error = "0 by definition" if rung.name == made.finest else f"{rung.error:.1e}"
        cells = (
            f"{rung.states} of {rung.full_states}",
            str(rung.operations),
            duration(rung.rhs),
            duration(rung.run),
        )
        dash = dash_of(style.methods.index(rung.name))
        parts.append(draw_line(LEFT, at - 4, LEFT + 30, at - 4, colour, f' stroke-width="2.5"{dash}'))
        size = fit_size(len(rung.name), 258, 12)
        parts.append(draw_text(LEFT + 38, at, rung.name, more=f' font-size="{size:.3g}"'))
        parts += [draw_text(x, at, text) for x, text in zip(columns[1:], cells, strict=True)]
        parts.append(draw_text(worst, at, error if math.isfinite(rung.error) else "-"))
        at += 19
    if len(style.formulations) > 1:
        x = LEFT
        for name in style.formulations:
            parts.append(draw_marker(style.shape(name), x + 8, at - 4, 4.4, "#444444"))
            parts.append(draw_text(x + 20, at, name))
            x += 60 + 7 * len(name)
        at += 19
    return parts, at - 10


def _draw_failures(results: tuple[Result, ...], style: Style, panel: Panel) -> list[str]:
    """A cross with the reason at the upper edge of the plot for each model that failed somewhere."""
    parts, at = [], panel.top + 18.0
    for name in style.methods:
        failed = [(k, r) for k, r in enumerate(results) if r.failed and r.case.method == name]
        if failed:
            k, first = failed[0]
            x = panel.left + panel.width - 12
            parts.append(draw_cross(x, at - 4, 4, style.colour(name), f' class="point" data-k="{k}"'))
            parts.append(draw_text(x - 10, at, f"{name}: {len(failed)} failed runs: {first.failed[:80]}", "end"))
            at += 17
    return parts


def _draw_curves(made: Comparison, top: float) -> tuple[list[str], float]:
    """The needed quantities of all models over time, two in a row; and where they end."""
    parts: list[str] = []
    bottom = top
    for k, need in enumerate(made.needs[:MOST_CURVES]):
        series = tuple(Series("", made.times[: len(rung.rows)], [row[k] for row in rung.rows]) for rung in made.rungs)
        label = f"{need} [{made.units[k]}]" if made.units[k] not in ("", "1") else need
        chart = Chart(label, time_axis(made.time_unit), Axis(""), series, CURVE_WIDTH, CURVE_HEIGHT)
        x, y = 12 + (k % 2) * (CURVE_WIDTH + 14), top + (k // 2) * (CURVE_HEIGHT + 8)
        parts.append(f'<g transform="translate({x:.0f} {y:.0f})">\n{draw_inside(chart)}\n</g>')
        bottom = y + CURVE_HEIGHT
    return parts, bottom


def _draw_foot(made: Comparison, y: float) -> tuple[list[str], float]:
    about = made.reference
    lines = (
        f"reference: {made.finest} by {about.method} in {about.arithmetic}, confirmed by {about.confirmed_by}; "
        f"they differ by {about.error:.1e}",
        f"machine: {made.machine.line}",
        *made.notes,
    )
    return draw_foot(LEFT - 54, y, WIDTH - 2 * (LEFT - 54), lines)
