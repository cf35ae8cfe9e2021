"""One panel of a work-precision chart: lines of cases on two logarithmic axes."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from nhc.records import record
from nhc.report.labels import SIZE as SMALL
from nhc.report.labels import Box, place_names
from nhc.report.marks import SHAPES, draw_axes, draw_box, draw_marker, draw_text
from nhc.report.svg import COLOURS, dash_of
from nhc.report.ticks import Scale, log_scale
from nhc.study.chart.case import Case, Result
from nhc.study.chart.words import LANGUAGE_NAMES

DASHES = {"c": "", "python": "7 4", "scipy": "2 3", "heyoka": "9 3 2 3", "sundials": "4 3", "diffrax": "1 3 5 3"}
OTHER_DASH = "1 5"
SIZE = 3.4
METHOD_COLOURS = (*COLOURS, "#882255", "#117733", "#6a3d9a", "#999999", "#b15928", "#88ccee")
ROUNDING = 1e-13  # relative deviations below it in all runs are not worth a picture
Value = Callable[[Result], float]


@record
class Style:
    """Colours say the method, shapes the formulation, dashes the language; ``foreign`` are (method, its maker).

    ``single``: dashes say the method, too, as those of a chart's lines do.
    """

    methods: tuple[str, ...]
    formulations: tuple[str, ...]
    languages: tuple[str, ...]
    foreign: tuple[tuple[str, str], ...]
    single: bool = False

    def colour(self, method: str) -> str:
        return METHOD_COLOURS[self.methods.index(method) % len(METHOD_COLOURS)]

    def shape(self, formulation: str) -> str:
        return SHAPES[self.formulations.index(formulation) % len(SHAPES)]

    def label(self, method: str) -> str:
        """A method's name, with its maker where that is not nhc."""
        return next((f"{method} ({LANGUAGE_NAMES[maker]})" for name, maker in self.foreign if name == method), method)

    def dash(self, language: str) -> str:
        return DASHES.get(language, OTHER_DASH)

    def line(self, case: Case) -> str:
        """The attribute that dashes a line of cases."""
        if self.single:
            return dash_of(self.methods.index(case.method))
        dash = self.dash(case.language)
        return f' stroke-dasharray="{dash}"' if dash else ""

    def classes(self, result: Result) -> str:
        """Class names by which a page shows and hides."""
        case = result.case
        places = (self.methods.index(case.method), self.formulations.index(case.formulation))
        return f"m{places[0]} f{places[1]} l{self.languages.index(case.language)}"


def style_of(results: Sequence[Result]) -> Style:
    """The methods, formulations and languages of the cases, each in order of first appearance, which choose colours and marks."""
    cases = [result.case for result in results]
    return Style(
        tuple(dict.fromkeys(c.method for c in cases)),
        tuple(dict.fromkeys(c.formulation for c in cases)),
        tuple(dict.fromkeys(c.language for c in cases)),
        tuple(dict.fromkeys((c.method, c.language) for c in cases if c.language not in ("c", "python"))),
    )


@record
class Panel:
    """Where a panel stands, in pixels of the whole picture, and what its axes carry.

    ``floor``: errors left of it are not resolved by the reference (0: no such limit); ``noise``: where no case is above it there is
    nothing to see; ``absent``: what to say where no case has such a value; ``named``: the lines have their methods beside them.
    """

    title: str
    x_label: str
    y_label: str
    x: Value
    y: Value
    left: float
    top: float
    width: float
    height: float
    floor: float = 0.0
    front: bool = False
    noise: float = 0.0
    absent: str = "nothing to show"
    named: bool = False


def draw_panel(panel: Panel, results: Sequence[Result], style: Style) -> list[str]:
    """The panel's elements; cases without a value on either axis do not show."""
    shown = [(k, r) for k, r in enumerate(results) if not r.failed and _is_good(panel.x(r)) and _is_good(panel.y(r))]
    xs, ys = [panel.x(r) for _, r in shown], [panel.y(r) for _, r in shown]
    x = log_scale(min(xs, default=1e-3), max(xs, default=1.0), panel.width, max(3, int(panel.width // 62)))
    y = log_scale(min(ys, default=1e-3), max(ys, default=1.0), panel.height, max(3, int(panel.height // 34)))
    if not shown:
        return _draw_empty(panel, results)
    parts = _draw_frame(panel, x, y)
    if max(xs) < panel.noise:
        text = f"rounding in all runs: at most {max(xs):.1e}"
        return [*parts, draw_text(panel.left + panel.width / 2, panel.top + panel.height / 2, text, "middle")]
    parts += _draw_floor(panel, x)
    if panel.front:
        parts += _draw_front(panel, [r for _, r in shown], x, y)
    lines: dict[tuple[str, str, str], list[tuple[int, Result]]] = {}
    for k, result in shown:
        lines.setdefault(result.case.series, []).append((k, result))
    for line in lines.values():
        parts += _draw_line(panel, style, line, x, y)
    return [*parts, *_draw_names(panel, style, lines, x, y)] if panel.named else parts


def _draw_empty(panel: Panel, results: Sequence[Result]) -> list[str]:
    """A frame without axes, and why it is empty."""
    some = any(not r.failed and math.isfinite(panel.x(r)) for r in results)
    text = "nothing but zeros" if some else panel.absent
    return [
        draw_text(panel.left, panel.top - 9, panel.title, more=' font-weight="bold"'),
        draw_box(panel.left, panel.top, panel.width, panel.height, "none", "#555555"),
        draw_text(panel.left + panel.width / 2, panel.top + panel.height / 2, text, "middle"),
    ]


def _draw_names(
    panel: Panel, style: Style, lines: dict[tuple[str, str, str], list[tuple[int, Result]]], x: Scale, y: Scale
) -> list[str]:
    """The method beside the lines of each method and language, compiled ones first."""
    kinds: dict[tuple[str, str], list[tuple[str, str, str]]] = {}
    for series in lines:
        kinds.setdefault(series[1:], []).append(series)
    order = sorted(kinds, key=lambda kind: kind[1] == "python")
    texts = {kind: kind[0] if kind[1] == "c" else f"{kind[0]}, {LANGUAGE_NAMES[kind[1]]}" for kind in order}
    places = [
        (texts[kind], [[_place(panel, r, x, y) for _, r in lines[series]] for series in kinds[kind]]) for kind in order
    ]
    frame = Box(panel.left, panel.top, panel.left + panel.width, panel.top + panel.height)
    look = f' font-size="{SMALL}" paint-order="stroke" stroke="#ffffff" stroke-width="2.5"'
    groups = {texts[kind]: " ".join(style.classes(lines[kinds[kind][0]][0][1]).split()[::2]) for kind in order}
    return [
        draw_text(name.x, name.y, name.text, more=f'{look} class="{groups[name.text]}"', colour="#333333")
        for name in place_names(places, frame)
    ]


def _is_good(value: float) -> bool:
    return math.isfinite(value) and value > 0


def _place(panel: Panel, result: Result, x: Scale, y: Scale) -> tuple[float, float]:
    return panel.left + x.place(panel.x(result)), panel.top + panel.height - y.place(panel.y(result))


def _draw_line(panel: Panel, style: Style, line: Sequence[tuple[int, Result]], x: Scale, y: Scale) -> list[str]:
    first = line[0][1].case
    colour = style.colour(first.method)
    places = [_place(panel, result, x, y) for _, result in line]
    parts = [f'<g class="{style.classes(line[0][1])}">']
    if len(places) > 1:
        path = " ".join(f"{a:.2f},{b:.2f}" for a, b in places)
        look = f'fill="none" stroke="{colour}" stroke-width="1.4" stroke-linejoin="round"{style.line(first)}'
        parts.append(f'<polyline points="{path}" {look}/>')
    for (k, result), (a, b) in zip(line, places, strict=True):
        more = f' class="point" data-k="{k}"'
        faint = panel.floor > 0 and not panel.x(result) >= panel.floor
        parts.append(draw_marker(style.shape(first.formulation), a, b, SIZE, colour, faint, more))
    return [*parts, "</g>"]


def _draw_frame(panel: Panel, x: Scale, y: Scale) -> list[str]:
    parts = [draw_text(panel.left, panel.top - 9, panel.title, more=' font-weight="bold"')]
    parts += draw_axes(panel.left, panel.top, x, y)
    parts.append(draw_text(panel.left + panel.width / 2, panel.top + panel.height + 33, panel.x_label, "middle"))
    middle, side = panel.top + panel.height / 2, panel.left - 48
    turned = f' transform="rotate(-90 {side:.2f} {middle:.2f})"'
    return [*parts, draw_text(side, middle, panel.y_label, "middle", turned)]


def _draw_floor(panel: Panel, x: Scale) -> list[str]:
    """Grey where the reference does not resolve the errors."""
    if not panel.floor > 0:
        return []
    width = min(max(x.place(panel.floor), 0.0), panel.width)
    if width < 1:
        return []
    return [draw_box(panel.left, panel.top, width, panel.height, "#000000", more=' fill-opacity="0.06"')]


def _draw_front(panel: Panel, results: Sequence[Result], x: Scale, y: Scale) -> list[str]:
    """A broad grey line through the cases that nothing beats in both error and time.

    What the reference does not resolve has no place on it, and yet beats all that is resolved and takes longer.
    """
    least = min((panel.y(r) for r in results if r.unresolved), default=math.inf)
    resolved = [r for r in results if not r.unresolved and panel.y(r) < least]
    front: list[Result] = []
    for result in sorted(resolved, key=lambda r: (panel.y(r), panel.x(r))):
        if not front or panel.x(result) < panel.x(front[-1]):
            front.append(result)
    if len(front) < 2:
        return []
    path = " ".join(f"{a:.2f},{b:.2f}" for a, b in (_place(panel, result, x, y) for result in front))
    look = 'fill="none" stroke="#bbbbbb" stroke-opacity="0.55" stroke-width="9" stroke-linejoin="round"'
    return [f'<polyline points="{path}" {look} stroke-linecap="round"/>']
