"""A work-precision study as a page of its own, without anything from elsewhere."""

from __future__ import annotations

import json
from html import escape

from nhc.emit.environment import create_environment
from nhc.report.chart import draw_study
from nhc.report.chart_text import list_failures, list_omissions, provenance, runs_of, times_to_targets
from nhc.report.marks import mark_code
from nhc.report.panel import Style, style_of
from nhc.study.chart.advice import TARGETS, advise
from nhc.study.chart.case import Result, Study
from nhc.study.chart.words import LANGUAGE_NAMES, duration, name_case, setting, spell_power
from nhc.version import __version__


def make_page(study: Study) -> str:
    """The picture with readings under the pointer and choices of what shows, the recommendations, all cases."""
    style = style_of(study.results)
    context: dict[str, object] = {
        "title": escape(f"{study.system}, scene {study.scene}: work against precision"),
        "about": escape(study.about),
        "advice": [(spell_power(a.target), mark_code(a.text)) for a in advise(study)],
        "chart": draw_study(study),
        "choices": list_choices(style),
        "targets": [spell_power(target) for target in TARGETS],
        "times": [
            (
                [escape(series[0]), escape(series[1]), escape(LANGUAGE_NAMES.get(series[2], series[2]))],
                list(map(duration, times)),
            )
            for series, times in times_to_targets(study)
        ],
        "failures": [(escape(what), mark_code(why), runs_of(count)) for what, why, count in list_failures(study)],
        "omissions": [
            (escape(names), [(escape(name), mark_code(reason)) for name, reason in left])
            for names, left in list_omissions(study)
        ],
        "left_out": [(escape(what), mark_code(why)) for what, why in study.left_out],
        "sources": [escape(line) for line in provenance(study)],
        "cases": [[escape(cell) for cell in describe(result)] for result in study.results],
        "data": json.dumps([read_out(r) for r in study.results], ensure_ascii=False).replace("<", "\\u003c"),
        "version": __version__,
    }
    return create_environment().get_template("html/chart.html.jinja").render(context)


def list_choices(style: Style) -> list[tuple[str, list[tuple[str, str]]]]:
    """(kind, [(class, name)]) of everything that can be hidden."""
    kinds = (("method", "m", style.methods), ("equations", "f", style.formulations), ("run by", "l", style.languages))
    return [
        (kind, [(f"{letter}{k}", escape(style.label(LANGUAGE_NAMES.get(name, name)))) for k, name in enumerate(names)])
        for kind, letter, names in kinds
    ]


def describe(result: Result) -> list[str]:
    """A row of the table of all cases."""
    case = result.case
    head = [case.formulation, case.method, LANGUAGE_NAMES.get(case.language, case.language), setting(case)]
    if result.failed:
        return [*head, f"failed: {result.failed}", "", "", "", "", "", ""]
    numbers = [f"{x:.1e}" for x in (result.error, result.grid_error, result.energy, result.residual)]
    error = numbers[0] + (" (not resolved)" if result.unresolved else "")
    return [*head, error, *numbers[1:], str(result.calls), duration(result.best), duration(result.median)]


def read_out(result: Result) -> str:
    """What the pointer reads."""
    head = name_case(result.case)
    if result.failed:
        return f"{head}\nfailed: {result.failed}"
    lines = (
        f"error at the end {result.error:.2e}, along the motion {result.grid_error:.2e}",
        f"energy {result.energy:.1e}, constraints {result.residual:.1e}",
        f"fastest {duration(result.best)}, median {duration(result.median)} of {result.repeats}",
        f"{result.calls} right-hand sides, {result.steps} steps, {result.rejected} rejected",
    )
    return "\n".join((head, *lines))
