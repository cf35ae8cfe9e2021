"""A work-precision study as the content of a file."""

from __future__ import annotations

from nhc.study.chart.case import Study


def make_file(study: Study, suffix: str) -> str:
    """The text of a .svg, .html, .json or .md file."""
    if suffix in (".json", ".md"):
        from nhc.report.chart_text import to_json, to_markdown

        return to_json(study) if suffix == ".json" else to_markdown(study)
    if suffix == ".svg":
        from nhc.report.chart import draw_study

        return draw_study(study)
    from nhc.report.chart_page import make_page

    return make_page(study)
