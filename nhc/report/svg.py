"""Line charts as SVG: axes, ticks, lines, markers, legend; the same text for the same data."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from nhc.records import record
from nhc.report.marks import draw_axes, draw_document, draw_line, draw_text, draw_title, fit_size
from nhc.report.ticks import Scale, linear_scale, log_scale
from nhc.report.units import typeset_label

# Okabe and Ito: told apart by most eyes
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#8c6d1f")
DASHES = ("", "7 3", "2 2", "9 3 2 3", "12 4")  # colours are not all that tells lines apart: on paper they may be grey
MOST = 2000  # points of a line; more do not show
LEFT, RIGHT, TOP, BOTTOM, ROW = 68, 24, 30, 46, 17
LEAST = 200  # height of a plot, whatever its legend takes


@record
class Series:
    """A line, or ``dots`` alone; ``marked``: a line with a dot at each value, between which nothing is known."""

    label: str
    x: Sequence[float]
    y: Sequence[float]
    dots: bool = False
    marked: bool = False


@record
class Axis:
    """``log``: logarithmic; ``exact``: ends where the data end; ``unit``, which the label has too: of a number read from it."""

    label: str
    log: bool = False
    exact: bool = False
    unit: str = ""


def time_axis(unit: str) -> Axis:
    """The time from the first to the last."""
    return Axis(f"t [{unit}]" if unit else "t", exact=True, unit=unit)


@record
class Chart:
    """Series over common axes, in a picture of this size."""

    title: str
    x: Axis
    y: Axis
    series: tuple[Series, ...]
    width: int = 720
    height: int = 380


@record
class Frame:
    """Where a chart's plot stands in the picture."""

    left: float
    top: float
    x: Scale
    y: Scale

    def point(self, x: float, y: float) -> tuple[float, float]:
        """Pixels from the picture's upper left corner."""
        return self.left + self.x.place(x), self.top + self.y.length - self.y.place(y)


def make_room(chart: Chart) -> Chart:
    """The chart, higher where its legend would leave too little of the plot."""
    least = LEAST + TOP + BOTTOM + ROW * len(legend_rows(chart))
    return replace(chart, height=max(chart.height, least))


def draw(chart: Chart) -> str:
    """A whole SVG document."""
    return draw_document(chart.width, chart.height, [draw_inside(chart)], describe(chart))


def describe(chart: Chart) -> str:
    """The chart in words: its title, what it shows over what, and the names of its lines where no label has them."""
    names = [series.label for series in chart.series if series.label and series.label not in chart.y.label]
    shown = f"{typeset_label(chart.y.label)} over {typeset_label(chart.x.label)}" + (
        f" ({', '.join(names)})" if names else ""
    )
    return f"{chart.title}: {shown}" if chart.title else shown


def draw_inside(chart: Chart) -> str:
    """The SVG elements of a chart, without the enclosing ``svg`` element, to be placed in a larger picture."""
    legend = legend_rows(chart)
    frame = find_frame(chart, len(legend))
    parts = [draw_title(chart.width / 2, 18, chart.title, chart.width - 16, 14)]
    parts += _draw_axes(chart, frame)
    for k, series in enumerate(chart.series):
        parts += _draw_series(series, frame, k)
    parts += _draw_legend(chart, legend)
    return "\n".join(parts)


def find_frame(chart: Chart, legend_rows: int) -> Frame:
    """The plot's place and its scales."""
    width = chart.width - LEFT - RIGHT
    height = chart.height - TOP - BOTTOM - ROW * legend_rows
    xs = [v for s in chart.series for v in s.x]
    ys = [v for s in chart.series for v in s.y]
    return Frame(LEFT, TOP, _scale(chart.x, xs, width, 8), _scale(chart.y, ys, height, 6))


def _scale(axis: Axis, values: Sequence[float], length: float, count: int) -> Scale:
    good = [v for v in values if math.isfinite(v) and (v > 0 or not axis.log)]
    if axis.log:
        return log_scale(min(good, default=0.1), max(good, default=1.0), length)
    return linear_scale(min(good, default=0.0), max(good, default=1.0), length, count, axis.exact)


def thin(xs: Sequence[float], ys: Sequence[float]) -> list[tuple[float, float]]:
    """At most about ``MOST`` points that look the same: of each stretch the first, the lowest, the highest and the last."""
    points = list(zip(xs, ys, strict=True))
    if len(points) <= MOST:
        return points
    size = math.ceil(4 * len(points) / MOST)
    kept: list[tuple[float, float]] = []
    for start in range(0, len(points), size):
        part = points[start : start + size]
        order = range(len(part))
        chosen = {0, len(part) - 1, min(order, key=lambda i: part[i][1]), max(order, key=lambda i: part[i][1])}
        kept += [part[i] for i in sorted(chosen)]
    return kept


def colour_of(index: int) -> str:
    """That of a chart's line."""
    return COLOURS[index % len(COLOURS)]


def dash_of(index: int) -> str:
    """The ``stroke-dasharray`` of a chart's line, as an attribute with a blank before it; nothing for a solid one."""
    dash = DASHES[index % len(DASHES)]
    return f' stroke-dasharray="{dash}"' if dash else ""


def _draw_series(series: Series, frame: Frame, index: int) -> list[str]:
    colour, style = colour_of(index), dash_of(index)
    runs: list[list[tuple[float, float]]] = [[]]
    for x, y in thin(series.x, series.y):
        place = frame.point(x, y)
        if all(map(math.isfinite, place)):
            runs[-1].append(place)
        elif runs[-1]:
            runs.append([])
    parts = []
    for run in runs:
        if len(run) > 1 and not series.dots:
            path = " ".join(f"{x:.2f},{y:.2f}" for x, y in run)
            parts.append(
                f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.6" stroke-linejoin="round"{style}/>'
            )
        if len(run) == 1 or series.dots or series.marked:
            parts += [f'<circle cx="{x:.2f}" cy="{y:.2f}" r="2.8" fill="{colour}"/>' for x, y in run]
    return parts


def _draw_axes(chart: Chart, frame: Frame) -> list[str]:
    x, y = frame.x, frame.y
    parts = draw_axes(frame.left, frame.top, x, y)
    parts.append(
        draw_text(frame.left + x.length / 2, frame.top + y.length + 34, typeset_label(chart.x.label), "middle")
    )
    middle = frame.top + y.length / 2
    if chart.y.label:
        turned = f' transform="rotate(-90 14 {middle:.2f})"'
        parts.append(draw_text(14, middle, typeset_label(chart.y.label), "middle", turned))
    return parts


def legend_rows(chart: Chart) -> list[list[tuple[int, str, float]]]:
    """(series, text, place from the left) in rows; nothing for one line that the axis's label or the title names already."""
    if len(chart.series) == 1 and chart.series[0].label in (
        "",
        chart.y.label.split(" [")[0],
        chart.title.split(":")[0],
    ):
        return []
    rows: list[list[tuple[int, str, float]]] = [[]]
    at = float(LEFT)
    for k, series in enumerate(chart.series):
        if not series.label:  # its colour is explained elsewhere
            continue
        letters = len(series.label)
        # a long name may have more wide letters than its narrow ones make up for
        width = max(44 + 6.6 * letters, 36 + 7.2 * letters)
        if rows[-1] and at + width > chart.width - RIGHT:
            rows.append([])
            at = float(LEFT)
        rows[-1].append((k, series.label, at))
        at += width
    return rows if rows[-1] else []


def _draw_legend(chart: Chart, rows: list[list[tuple[int, str, float]]]) -> list[str]:
    parts = []
    for r, row in enumerate(rows):
        y = chart.height - ROW * (len(rows) - r) + 8
        for k, text, x in row:
            if chart.series[k].dots:
                parts.append(f'<circle cx="{x + 13:.2f}" cy="{y - 4:.2f}" r="2.8" fill="{colour_of(k)}"/>')
            else:
                parts.append(draw_line(x, y - 4, x + 26, y - 4, colour_of(k), f' stroke-width="2"{dash_of(k)}'))
            size = fit_size(len(text), chart.width - x - 40, 12.0)
            parts.append(draw_text(x + 31, y, text, more="" if size == 12.0 else f' font-size="{size:.1f}"'))
    return parts
