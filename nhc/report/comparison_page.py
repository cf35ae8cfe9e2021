"""Models held against the finest one as a page of its own, without anything from elsewhere; and the file of any kind."""

from __future__ import annotations

import json
from html import escape

from nhc.emit.environment import create_environment
from nhc.report.chart_page import list_choices
from nhc.report.comparison import draw_comparison, swap_names
from nhc.report.comparison_text import (
    advise_models,
    list_failures,
    observations,
    provenance,
    table_of_models,
    to_json,
    to_markdown,
)
from nhc.report.marks import mark_code
from nhc.report.panel import style_of
from nhc.study.chart.case import Result
from nhc.study.chart.fidelity import Comparison
from nhc.study.chart.words import duration, name_case, spell_power
from nhc.version import __version__


def make_comparison_file(made: Comparison, suffix: str) -> str:
    """The text of a .svg, .html, .json or .md file."""
    makers = {".svg": draw_comparison, ".html": make_comparison_page, ".json": to_json, ".md": to_markdown}
    return makers[suffix](made)


def make_comparison_page(made: Comparison) -> str:
    """The picture with readings under the pointer, the recommendations, the table of models."""
    head, rows = table_of_models(made)
    choices = [
        ("model" if kind == "method" else "method" if kind == "equations" else kind, entries)
        for kind, entries in list_choices(style_of(swap_names(made)))
    ]
    context: dict[str, object] = {
        "title": escape(f"scene {made.scene}: models against {made.finest}"),
        "abouts": [(escape(rung.name), escape(rung.about)) for rung in made.rungs if rung.about],
        "advice": [(spell_power(target), mark_code(text)) for target, _, text in advise_models(made)],
        "observations": [mark_code(line) for line in observations(made)],
        "chart": draw_comparison(made),
        "choices": [(kind, entries) for kind, entries in choices if len(entries) > 1],
        "head": [escape(cell) for cell in head],
        "rows": [[escape(cell) for cell in row] for row in rows],
        "omissions": [
            (escape(rung.name), escape(name), mark_code(reason)) for rung in made.rungs for name, reason in rung.left
        ],
        "failures": [mark_code(line) for line in list_failures(made)],
        "sources": [escape(line) for line in provenance(made)],
        "data": json.dumps([read_out(r) for r in made.results], ensure_ascii=False).replace("<", "\\u003c"),
        "version": __version__,
    }
    return create_environment().get_template("html/comparison.html.jinja").render(context)


def read_out(result: Result) -> str:
    """What the pointer reads."""
    head = name_case(result.case)
    if result.failed:
        return f"{head}\nfailed: {result.failed}"
    lines = (
        f"largest error on the scene {result.error:.2e}",
        f"fastest {duration(result.best)}, median {duration(result.median)} of {result.repeats}",
        f"{result.calls} right-hand sides, {result.steps} steps",
    )
    return "\n".join((head, *lines))
