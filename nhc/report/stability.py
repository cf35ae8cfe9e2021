"""A laboratory's findings as one self-contained HTML page: the table, and a picture for each study."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from html import escape

from nhc.emit.environment import create_environment
from nhc.report.marks import mark_code
from nhc.report.svg import Axis, Chart, Series, draw, make_room, time_axis
from nhc.study.linearization.linearize import eigenvalues
from nhc.study.stability.laboratory import Laboratory
from nhc.study.stability.table import sections, time_of, with_unit
from nhc.version import __version__

WIDTH, PANEL = 760, 340
_TINY = 1e-18
_MOST = 8  # lines of one picture
_BINS = 200  # points of a drift's line
_BELOW = 1.5  # how far below zero growth is drawn, in terms of the fastest growth
ROUNDING = 1e-13
"""Deviations that never leave this are left out of a picture."""


def list_charts(lab: Laboratory) -> list[Chart]:
    """The pictures, in the order of the table."""
    unit = lab.bench.job.system.spec.time_unit
    rate = f" [1/{unit}]" if unit else ""
    charts = [*_sweep(lab, rate), *_spectrum(lab, rate)]
    t = time_axis(unit)
    for run in lab.runs:
        chosen = [d for d in run.drifts if max(d.series, default=0.0) > 0.0]
        chosen = [d for d in chosen if max(d.series) > ROUNDING] or chosen[:1]
        series = tuple(
            Series(d.what if d.relative else f"{d.what} (absolute)", *_envelope(run.times, d.series))
            for d in chosen[:_MOST]
        )
        if series:
            how = run.method if not run.step else f"{run.method}, steps of {time_of(run.step, unit, 3)}"
            title = f"drift by {how}: largest of every {max(1, len(run.times) // _BINS)} rows"
            charts.append(_chart(title, t, Axis("relative deviation", log=True), series))
    if lab.sensitivity is not None:
        growth = lab.sensitivity
        points = sorted({*zip(growth.times, growth.norms, strict=True), (growth.peak, growth.largest)})
        series = (Series("growth", [t for t, _ in points], _positive(norm for _, norm in points)),)
        charts.append(
            _chart(
                "growth of perturbations of the start", t, Axis("growth of relative perturbations", log=True), series
            )
        )
    if lab.distances:
        times = lab.bench.times
        series = tuple(Series(d.what, times, _positive(d.series)) for d in lab.distances[:_MOST])
        title = "distance from singular points"
        charts.append(_chart(title, t, Axis("0: singular, 1: far", log=True), series))
    return charts


def _chart(title: str, x: Axis, y: Axis, series: tuple[Series, ...]) -> Chart:
    return make_room(Chart(title, x, y, series, WIDTH, PANEL))


def _envelope(times: Sequence[float], values: Sequence[float]) -> tuple[list[float], list[float]]:
    """The largest of each bin: noise about rounding is no line that can be read."""
    size = max(1, len(times) // _BINS)
    starts = range(0, len(times), size)
    return [times[k] for k in starts], _positive(max(values[k : k + size]) for k in starts)


def _positive(values: Iterable[float]) -> list[float]:
    """For a logarithmic axis; what is exactly zero has no place on it."""
    return [max(abs(v), _TINY) if v else math.nan for v in values]


def _sweep(lab: Laboratory, rate: str) -> list[Chart]:
    """Real and imaginary parts over what was swept; each line is the k-th eigenvalue by real part."""
    if lab.motion is None or lab.motion.swept is None:
        return []
    swept = lab.motion.swept
    found = [eigenvalues(point) for point in swept.points]
    most = max(map(len, found))
    charts = []
    for kind, title, part in (
        ("real", "real parts: growth", False),
        ("imaginary", "imaginary parts: angular frequency", True),
    ):
        xs, ys = [], []
        for k in range(most):
            for value, row in zip(swept.values, found, strict=True):
                if k < len(row):
                    xs.append(value)  # no lines: which belongs to which is not known
                    ys.append(row[k].imag if part else row[k].real)
        lines = [Series("eigenvalues", xs, ys, dots=True)]
        if not part:
            reach = max((y for y in ys if math.isfinite(y)), default=0.0)
            if reach > 0.0:  # what decays fast would press the crossings flat
                kept = _at_least(-_BELOW * reach, xs, ys)
                if len(kept[0]) < len(xs):
                    title = f"{title} (what lies below {-_BELOW * reach:.3g} is not drawn)"
                xs, ys = kept
                lines = [Series("eigenvalues", xs, ys, dots=True)]
            else:
                reach = max((abs(y) for y in ys if math.isfinite(y)), default=1.0)
            lines += [
                Series(f"crossing at {c.value:.5g}", [c.value, c.value], [-reach, reach]) for c in swept.crossings
            ]
        charts.append(
            _chart(title, Axis(with_unit(lab, lab.motion.along), exact=True), Axis(f"{kind} part{rate}"), tuple(lines))
        )
    return charts


def _at_least(low: float, xs: list[float], ys: list[float]) -> tuple[list[float], list[float]]:
    kept = [(x, y) for x, y in zip(xs, ys, strict=True) if not y < low]
    return [x for x, _ in kept], [y for _, y in kept]


def _spectrum(lab: Laboratory, rate: str) -> list[Chart]:
    if lab.spectrum is None:
        return []
    flat = [complex(x) for row in lab.spectrum.values for x in row]
    title = "eigenvalues of the Jacobian along the scene"
    points = (Series("", [x.real for x in flat], [x.imag for x in flat], dots=True),)
    return [_chart(title, Axis(f"real part{rate}"), Axis(f"imaginary part{rate}"), points)]


def make_page(lab: Laboratory) -> str:
    """The page."""
    bench = lab.bench
    parts = [
        (escape(part.title), [tuple(map(_set_cell, (row.what, row.value, row.remark))) for row in part.rows])
        for part in sections(lab)
    ]
    context = {
        "title": escape(f"{bench.equations.system.name}: stability of {bench.job.scene.name}"),
        "about": mark_code(_describe(lab)),
        "sections": parts,
        "charts": [draw(chart) for chart in list_charts(lab)],
        "version": __version__,
    }
    return create_environment().get_template("html/stability.html.jinja").render(context)


def _describe(lab: Laboratory) -> str:
    """What the system is and what happens in the scene, as far as the spec says so, and what was changed."""
    job = lab.bench.job
    system, scene = job.program.about, job.scene.about
    told = f"The scene `{job.scene.name}`: {scene.rstrip('.')}." if scene else ""
    whole = f"{system.rstrip('.')}. {told}" if system and told else system or told
    changes = "; ".join(change[:1].upper() + change[1:] for change in lab.changes)
    return f"{whole.rstrip('.')}. {changes}" if whole and changes else whole or changes


def _set_cell(text: str) -> str:
    """As HTML; a number is not parted from its percent sign."""
    return mark_code(text).replace(" %", "&nbsp;%")
