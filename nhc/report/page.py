"""A trajectory as one picture, and as a page of its own without anything from elsewhere."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Sequence
from html import escape
from itertools import accumulate

from nhc.algebra.evaluate import evaluate
from nhc.emit.environment import create_environment
from nhc.language.spec import reaction_name
from nhc.mechanics.frame import form_value
from nhc.mechanics.properties.conserved import power_terms
from nhc.report.drawing import describe_drawing, shorten, thin_rows
from nhc.report.marks import draw_document, mark_code
from nhc.report.svg import (
    Axis,
    Chart,
    Series,
    describe,
    draw,
    draw_inside,
    find_frame,
    legend_rows,
    make_room,
    time_axis,
)
from nhc.report.units import typeset_unit
from nhc.simulate.prepare import Job
from nhc.simulate.run import Trajectory, energy_change
from nhc.version import __version__

WIDTH, PANEL = 760, 340
TINY = 1e-20
LONGEST = 32  # letters of names beside an axis
FLAT = 30.0  # times as large as another quantity, which would seem to be zero in the same panel
MOST_STARTED = 24  # coordinates and velocities of the start that are named
ROUNDING = 1e-15  # of a velocity that follows from the constraints, relative to the largest
NOISE = 1e-13  # a residual that never leaves this is rounding
FEW = 24  # rows, each of which is marked: a line alone would claim what is between them
MOST_READ = 2000  # rows that the page carries as numbers


def list_charts(found: Trajectory) -> list[Chart]:
    """One chart of what is needed for each unit and size, so that no axis carries two units and no line lies flat."""
    units: dict[str, list[int]] = {}
    for k, column in enumerate(found.job.columns):
        units.setdefault(column.unit, []).append(k)
    charts: list[Chart] = []
    for unit, indices in [(unit, part) for unit, all_ in units.items() for part in _by_size(found, all_)]:
        label = _label(found.job, [found.headings[k] for k in indices])
        few = len(found.times) <= FEW
        series = tuple(
            Series(found.headings[k], found.times, [row[k] for row in found.rows], marked=few) for k in indices
        )
        title = f"{found.job.program.system}: {found.job.scene.name}" if not charts else ""
        shown = "" if unit == "1" else unit
        y = Axis(f"{label} [{shown}]" if shown else label, unit=shown)
        charts.append(make_room(Chart(title, time_axis(found.job.system.spec.time_unit), y, series, WIDTH, PANEL)))
    return charts


def _label(job: Job, names: Sequence[str]) -> str:
    """What an axis shows: the names, or where they are too long what they all are."""
    text = ", ".join(names)
    if len(text) <= LONGEST:
        return text
    system = job.system
    kinds = {
        "reactions": {reaction_name(form.name) for form in system.constraints},
        "coordinates": set(system.q_names),
        "velocities": {*(f"{name}'" for name in system.q_names), *(form.name for form in system.quasi)},
        "outputs": {name for name, _ in system.outputs},
    }
    return next((kind for kind, known in kinds.items() if known.issuperset(names)), "value")


def _by_size(found: Trajectory, indices: list[int]) -> list[list[int]]:
    """The columns in groups of similar size, the largest first; what is zero or has no size stays with these."""
    sizes = {k: max((abs(row[k]) for row in found.rows if math.isfinite(row[k])), default=0.0) for k in indices}
    groups: list[list[int]] = []
    rest = indices
    while rest:
        largest = max(sizes[k] for k in rest)
        same = [k for k in rest if sizes[k] * FLAT >= largest or (sizes[k] == 0.0 and not groups)]
        groups.append(same)
        rest = [k for k in rest if k not in same]
    return groups


def list_check_charts(found: Trajectory, driven: Sequence[str] = ()) -> list[Chart]:
    """The energy, and how far the constraints are off.

    Of the energy its relative change, which is an error; but T + V itself where it need not be constant, because of what is
    ``driven``.
    """
    shown = bool(driven) and any(need.kind == "energy" for need in found.job.scene.need)  # as a column already
    charts = [_draw_energy(found, bool(driven))] if _columns(found, "energy") and not shown else []
    for group, title in (
        ("residual", "residuals of the constraints"),
        ("position", "holonomic constraints: position residuals"),
    ):
        lines = _merge_noise(_columns(found, group))
        charts.append(_chart(found, title, Axis("in the spec's units", log=True), lines))
    return [chart for chart in charts if chart is not None]


def _columns(found: Trajectory, group: str) -> list[tuple[str, list[float]]]:
    """The checks of a group, row by row."""
    indices = [k for k, column in enumerate(found.job.checks) if column.group == group and found.checks]
    return [(found.job.checks[k].heading, [row[k] for row in found.checks]) for k in indices]


def _draw_energy(found: Trajectory, driven: bool) -> Chart | None:
    if not driven:
        title, axis = "energy: change relative to the largest of |T + V| and T", Axis("relative change", log=True)
        return _chart(found, title, axis, [("energy", energy_change(found))])
    unit = found.job.system.units.get("energy", "")
    axis = Axis(f"T + V [{unit}]" if unit else "T + V", unit=unit)
    return _chart(found, "energy, which is not conserved", axis, [("T + V", _columns(found, "energy")[0][1])])


def _merge_noise(lines: list[tuple[str, list[float]]]) -> list[tuple[str, list[float]]]:
    """The lines, but for several that never leave rounding: one line of their largest values says as much as all of them."""
    quiet = [(name, values) for name, values in lines if max(map(abs, values)) < NOISE]
    if len(quiet) < 2:
        return lines
    largest = [max(map(abs, row)) for row in zip(*(values for _, values in quiet), strict=True)]
    name = f"largest of {'all' if len(quiet) == len(lines) else 'the others'}"
    return [*(line for line in lines if line not in quiet), (name, largest)]


def _chart(found: Trajectory, title: str, y: Axis, lines: list[tuple[str, list[float]]]) -> Chart | None:
    """A chart of checks over time; nothing where a logarithmic axis has only zeros to show: the table says so."""
    if y.log:
        lines = [(name, [max(abs(v), TINY) if v else math.nan for v in values]) for name, values in lines]
    series = tuple(Series(name, found.times, values) for name, values in lines)
    if all(math.isnan(v) for _, values in lines for v in values):
        return None
    return make_room(Chart(title, time_axis(found.job.system.spec.time_unit), y, series, WIDTH, PANEL))


def make_picture(found: Trajectory) -> str:
    """The needed quantities over time, one panel for each unit."""
    charts = list_charts(found)
    if len(charts) == 1:
        return draw(charts[0])
    tops = [0, *accumulate(chart.height for chart in charts)]
    panels = [
        f'<g transform="translate(0 {top})">\n{draw_inside(chart)}\n</g>'
        for top, chart in zip(tops, charts, strict=False)
    ]
    return draw_document(WIDTH, tops[-1], panels, "; ".join(map(describe, charts)))


def make_page(found: Trajectory) -> str:
    """A self-contained HTML page: facts, charts with a reading of values under the pointer, checks."""
    job, outcome, driven = found.job, found.outcome, _list_drives(found)
    steps = f"{outcome.steps} steps, {outcome.rejected} rejected, {outcome.calls} right-hand sides"
    facts = [
        ("scene", f"{job.scene.name}{': ' + job.scene.about if job.scene.about else ''}"),
        ("equations", f"{job.program.formulation} ({job.program.equation})"),
        ("method", f"{found.method} as {'compiled C' if found.compiled else 'Python'}; {steps}"),
        (
            "time",
            f"{_number(found.times[0])} to {_number(found.times[-1], job.system.spec.time_unit)}, {len(found.times)} rows",
        ),
        ("parameters", _list_parameters(job) or "none"),
        ("start", _list_start(job) or "all coordinates and velocities are zero"),
        *_summary(found, driven),
        *(("note", note) for note in found.notes),
    ]
    if found.ended == "event":
        facts.append(("ended", found.reason))
    if found.ended not in ("done", "event"):
        facts.append(("incomplete", f"{found.reason} at t = {outcome.t!r}"))
    charts = (*list_charts(found), *list_check_charts(found, driven))
    drawing = describe_drawing(found)
    context = {
        "title": escape(f"{job.program.system}: {job.scene.name}"),
        "about": escape(job.program.about),
        "facts": [(escape(name), mark_code(text)) for name, text in facts],
        "charts": [draw(chart) for chart in charts],
        "data": _embed([_readable(chart) for chart in charts]),
        "drawing": "" if drawing is None else _embed(drawing),
        "version": __version__,
    }
    return create_environment().get_template("html/run.html.jinja").render(context)


def _number(value: float, unit: str = "") -> str:
    """The shortest decimal that reads back as the same double, long rows of zeros as a power of ten; its unit after it."""
    text = re.sub(r"e([+-]?)0*(?=\d)", lambda found: f"e{found[1].strip('+')}", repr(value).removesuffix(".0"))
    text = re.sub(r"0{9,}$", lambda zeros: f"e{len(zeros[0])}", text) if text.lstrip("-").isdigit() else text
    return f"{text} {typeset_unit(unit)}" if unit not in ("", "1") else text


def _list_parameters(job: Job) -> str:
    values = zip(job.program.parameters, job.p, strict=True)
    shown = (f"{parameter.name} = {_number(value, parameter.unit)}" for parameter, value in values)
    return ", ".join(text.replace(" ", "\u00a0") for text in shown)  # a line ends between two of them only


def _list_start(job: Job) -> str:
    """Coordinates and velocities at the start, but for those that are zero, or that only rounding keeps from it; of rotations the
    angular velocities, which a scene gives.
    """
    system, units = job.system, job.system.units
    angular = [form for form in system.quasi if form.name in system.angular]
    rates = evaluate(system.graph, [form_value(system, form) for form in angular], job.start.values(system))
    moving = [(f"{name}'", v) for name, v in zip(system.q_names, job.start.v, strict=True) if name not in system.turned]
    moving += [(form.name, float(rate)) for form, rate in zip(angular, rates, strict=True)]
    least = ROUNDING * max((abs(v) for _, v in moving), default=0.0)
    slow = {name for name, v in moving if abs(v) <= least}
    values = (*zip(system.q_names, job.start.q, strict=True), *moving)
    shown = [
        f"{name} = {_number(float(f'{value:.10g}'), units.get(name, ''))}".replace(" ", "\u00a0")
        for name, value in values
        if value and name not in slow
    ]
    more = [f"... and {len(shown) - MOST_STARTED} more"] if len(shown) > MOST_STARTED else []
    return ", ".join([*shown[:MOST_STARTED], *more])


def _embed(data: object) -> str:
    """JSON that ends no element of the page."""
    return json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def _list_drives(found: Trajectory) -> list[str]:
    """Why T + V is not constant in this run, in words; empty where it is, or might as well be."""
    return power_terms(found.job.system) if _columns(found, "energy") and any(energy_change(found)) else []


def _summary(found: Trajectory, driven: Sequence[str]) -> list[tuple[str, str]]:
    """What the energy does, and the largest violation of each kind of constraint."""
    facts = []
    energy = [values for _, values in _columns(found, "energy")]
    if energy and driven:
        unit = found.job.system.units.get("energy", "")
        first, last = (_number(float(f"{x:.4g}"), unit) for x in (energy[0][0], energy[0][-1]))
        text = f"T + V goes from {first} to {last}; it need not be constant, because of {', '.join(driven)}"
        facts.append(("energy", text.replace("`", "")))
    elif energy:
        facts.append(("energy", f"relative change at most {max(map(abs, energy_change(found))):.3g}"))
    for group, name in (("residual", "constraints"), ("position", "holonomic constraints")):
        worst = [abs(x) for _, values in _columns(found, group) for x in values]
        if worst:
            facts.append((name, f"off by at most {max(worst):.3g}, in the spec's units"))
    return facts


def _readable(chart: Chart) -> dict[str, object]:
    """What the page's script needs to read a value under the pointer; long series are thinned by a stride."""
    frame = find_frame(chart, len(legend_rows(chart)))
    return {
        "left": frame.left,
        "top": frame.top,
        "width": frame.x.length,
        "height": frame.y.length,
        "low": frame.x.low,
        "high": frame.x.high,
        "time": typeset_unit(chart.x.unit),
        "unit": typeset_unit(chart.y.unit),
        "names": [series.label for series in chart.series],
        "x": shorten(thin_rows(chart.series[0].x, MOST_READ)),
        "y": [[None if math.isnan(y) else y for y in shorten(thin_rows(s.y, MOST_READ))] for s in chart.series],
    }
