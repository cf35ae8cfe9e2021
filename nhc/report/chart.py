"""A work-precision study as one picture."""

from __future__ import annotations

import math

from nhc.report.marks import (
    draw_box,
    draw_cross,
    draw_document,
    draw_foot,
    draw_line,
    draw_marker,
    draw_text,
    draw_title,
    fit_size,
)
from nhc.report.panel import ROUNDING, Panel, Style, draw_panel, style_of
from nhc.report.ticks import log_scale
from nhc.study.chart.case import RESOLVED, Result, Study
from nhc.study.chart.words import LANGUAGE_NAMES, describe_question, duration

WIDTH, LEFT = 1060, 74
MAIN_WIDTH, MAIN_HEIGHT = 800, 500
SMALL_WIDTH, SMALL_HEIGHT = 425, 260
SMALLEST = 4.0
BOLD = ' font-weight="bold"'


def draw_study(study: Study) -> str:
    """The whole SVG document: the same text for the same study."""
    style = style_of(study.results)
    legend, below = _draw_legend(study, style, 72)
    top = below + 30
    floor = RESOLVED * study.reference.error
    main = Panel(
        "time against error at the end",
        "error at the end, relative to each quantity's largest magnitude",
        "processor time of one run [s], the fastest of the repeats",
        lambda r: r.error,
        lambda r: r.best,
        *(LEFT, top, MAIN_WIDTH, MAIN_HEIGHT, floor, True),
        named=True,
    )
    parts = [*legend, *draw_panel(main, study.results, style), *_draw_hint(main), *_draw_strip(main, study, style)]
    at = top + MAIN_HEIGHT + 82
    small = _small_panels(at, floor, RESOLVED * study.reference.energy_error)
    for panel in small:
        parts += draw_panel(panel, study.results, style)
    at = small[-1].top + small[-1].height + 80
    bars, height = _draw_costs(study, at)
    parts += bars
    foot, below = _draw_foot(study, height + 30)
    parts += foot
    total = below + 20
    title = f"{study.system}, scene {study.scene}: work against precision"
    question = describe_question(study)
    size = f' font-size="{fit_size(len(question), WIDTH - 20, 12.0):.1f}"'
    head = [draw_title(WIDTH / 2, 26, title, WIDTH - 20), draw_text(WIDTH / 2, 46, question, "middle", size)]
    return draw_document(WIDTH, total, [*head, *parts], title)


def _small_panels(top: float, floor: float, energy_floor: float) -> tuple[Panel, ...]:
    second, lower, seconds = LEFT + SMALL_WIDTH + 108, top + SMALL_HEIGHT + 82, "processor time of one run [s]"
    size = (SMALL_WIDTH, SMALL_HEIGHT)
    grid = "root mean square of the relative errors on the output grid"
    energy = "largest energy error, relative to the energy"
    calls = "right-hand sides"
    end = "error at the end, relative"

    def work(result: Result) -> float:
        return float(result.calls)

    return (
        Panel(
            "error along the motion", grid, seconds, lambda r: r.grid_error, lambda r: r.best, LEFT, top, *size, floor
        ),
        Panel(
            "energy",
            energy,
            seconds,
            lambda r: r.energy,
            lambda r: r.best,
            *(second, top, *size, energy_floor),
            noise=ROUNDING,
            absent="no energy is known",
        ),
        Panel(
            "constraints (exact zeros do not show)",
            "largest left minus right side of a constraint, in the spec's units",
            seconds,
            lambda r: r.residual,
            lambda r: r.best,
            *(LEFT, lower, *size),
            noise=ROUNDING,
            absent="the system has no constraints",
        ),
        Panel("work without the clock", end, calls, lambda r: r.error, work, second, lower, *size, floor),
    )


def _draw_legend(study: Study, style: Style, top: float) -> tuple[list[str], float]:
    """Three rows: colours, shapes, dashes; never on the data."""
    parts: list[str] = []
    rows = (("method", style.methods), ("equations", style.formulations), ("run by", style.languages))
    at = top
    for kind, names in rows:
        x = LEFT + 78.0
        parts.append(draw_text(LEFT, at, kind, more=BOLD))
        for name in names:
            label = LANGUAGE_NAMES.get(name, name) if kind == "run by" else style.label(name)
            if x + 40 + 7.4 * len(label) > WIDTH - 20:
                x, at = LEFT + 78.0, at + 20
            parts += _draw_key(kind, name, label, x, at, style)
            x += 48 + 7.4 * len(label)
        at += 20
    x = LEFT + 78
    parts.append(draw_text(LEFT, at, "marks", more=BOLD))
    parts.append(draw_marker("circle", x + 6, at - 4, 4, "#444444", True))
    parts.append(draw_text(x + 18, at, f"hollow, on grey: below {RESOLVED:.0f} times the reference's own error"))
    parts.append(draw_cross(x + 386, at - 4, 4, "#444444"))
    parts.append(draw_text(x + 397, at, "failed"))
    parts.append(draw_line(x + 452, at - 4, x + 478, at - 4, "#cccccc", ' stroke-width="9" stroke-linecap="round"'))
    parts.append(draw_text(x + 490, at, "nothing beats these in both error and time"))
    return parts, at


def _draw_key(kind: str, name: str, label: str, x: float, y: float, style: Style) -> list[str]:
    text = draw_text(x + 32, y, label)
    if kind == "method":
        return [draw_line(x, y - 4, x + 26, y - 4, style.colour(name), ' stroke-width="3"'), text]
    if kind == "equations":
        return [draw_marker(style.shape(name), x + 18, y - 4, 4.4, "#444444"), text]
    dash = style.dash(name)
    more = ' stroke-width="1.8"' + (f' stroke-dasharray="{dash}"' if dash else "")
    return [draw_line(x - 4, y - 4, x + 26, y - 4, "#444444", more), text]


def _draw_hint(panel: Panel) -> list[str]:
    """Which way is better, in the corner where no case can be."""
    x, y = panel.left + 14, panel.top + panel.height - 14
    arrow = f"M{x + 24:.2f} {y - 24:.2f}L{x:.2f} {y:.2f}M{x:.2f} {y - 9:.2f}L{x:.2f} {y:.2f}L{x + 9:.2f} {y:.2f}"
    return [
        f'<path d="{arrow}" fill="none" stroke="#555555" stroke-width="2"/>',
        draw_text(x + 30, y - 4, "down and left is better", colour="#555555", more=' font-style="italic"'),
    ]


def _draw_strip(panel: Panel, study: Study, style: Style) -> list[str]:
    """Beside the plot: a cross for each line of cases with failures, and how many of its runs failed."""
    failed: dict[tuple[str, str, str], list[tuple[int, Result]]] = {}
    counts: dict[tuple[str, str, str], int] = {}
    for k, result in enumerate(study.results):
        counts[result.case.series] = counts.get(result.case.series, 0) + 1
        if result.failed:
            failed.setdefault(result.case.series, []).append((k, result))
    if not failed:
        return []
    left = panel.left + panel.width + 14
    width = WIDTH - left - 14
    space = min(19.0, (panel.height - 12) / len(failed))
    rows = [
        (*_name_failed(series, len(results), counts[series]), series, results[0]) for series, results in failed.items()
    ]
    letters = max(len(name) + len(share) for name, share, _, _ in rows) + 2
    size = f' font-size="{fit_size(letters, width - 44, min(12.0, max(5.0, space - 3))):.1f}"'
    parts = [
        draw_text(left, panel.top - 9, "failed runs", more=BOLD),
        draw_box(left, panel.top, width, panel.height, "#fafafa", "#bbbbbb"),
    ]
    for row, (name, share, series, (k, result)) in enumerate(rows):
        y = panel.top + 6 + space * (row + 0.5)
        colour = style.colour(series[1])
        parts.append(f'<g class="{style.classes(result)}">')
        parts.append(draw_cross(left + 12, y, min(4.0, space / 3), colour, f' class="point" data-k="{k}"'))
        parts.append(draw_marker(style.shape(series[0]), left + 27, y, min(SMALLEST, space / 3), colour))
        parts.append(draw_text(left + 38, y + 4, name, more=size))
        parts.append(draw_text(left + width - 6, y + 4, share, "end", size))
        parts.append("</g>")
    return parts


def _name_failed(series: tuple[str, str, str], failed: int, count: int) -> tuple[str, str]:
    _, method, language = series
    return f"{method}, {LANGUAGE_NAMES.get(language, language)}", "all" if failed == count else f"{failed}/{count}"


def _draw_costs(study: Study, top: float) -> tuple[list[str], float]:
    """One right-hand side of each formulation: places on an axis of times, and where they end."""
    x = LEFT + 80.0
    times = [t for cost in study.costs for t in (cost.c, cost.python) if math.isfinite(t)]
    scale = log_scale(min(times, default=1e-9), max(times, default=1e-6), MAIN_WIDTH - 280.0)
    height = sum(16.0 if cost.twin else 34.0 for cost in study.costs) + 8
    parts = [draw_text(LEFT, top - 9, "time of one right-hand side [s]", more=BOLD)]
    for place, text in scale.ticks:
        parts.append(draw_line(x + place, top, x + place, top + height, "#e4e4e4"))
        parts.append(draw_text(x + place, top + height + 14, text, "middle"))
    at = top + 4
    for cost in study.costs:
        parts.append(draw_text(x - 8, at + 12, cost.formulation, "end"))
        if cost.twin:
            parts.append(draw_text(x + 8, at + 12, f"the same code as {cost.twin}", more=' font-size="11"'))
            at += 16
            continue
        for language, value in (("c", cost.c), ("python", cost.python)):
            if math.isfinite(value):
                words = f"{LANGUAGE_NAMES[language]}: {duration(value)}"
                more = f", {cost.operations}, {cost.states} states" if language == "c" else ""
                place = x + scale.place(value)  # a bar: colours and shapes stand for methods and equations above
                parts.append(draw_line(place, at + 3, place, at + 13, "#444444", ' stroke-width="3"'))
                parts.append(draw_text(place + 10, at + 12, words + more, more=' font-size="11"'))
            at += 17
    return parts, top + height + 18


def _draw_foot(study: Study, y: float) -> tuple[list[str], float]:
    """Method, tolerance, reference and machine of the numbers above."""
    about = study.reference
    lines = (
        f"reference: {about.method} in {about.arithmetic}, confirmed by {about.confirmed_by}; they differ by {about.error:.1e}",
        f"machine: {study.machine.line}",
        *study.notes,
    )
    return draw_foot(LEFT - 54, y, WIDTH - 2 * (LEFT - 54), lines)
