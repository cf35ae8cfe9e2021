"""A work-precision study as JSON and as Markdown."""

from __future__ import annotations

import json
import math
from dataclasses import asdict

from nhc.study.chart.advice import TARGETS, advise, fastest
from nhc.study.chart.case import RESOLVED, Result, Study
from nhc.study.chart.words import LANGUAGE_NAMES, describe_question, duration, spell_power
from nhc.version import __version__

SCHEMA = "nhc.chart/1"


def to_data(study: Study) -> dict[str, object]:
    """The study as plain data; null where there is no number."""
    advice = [
        {"target": a.target, "text": a.text, "case": None if a.best is None else asdict(a.best.case)}
        for a in advise(study)
    ]
    return {
        "schema": SCHEMA,
        "nhc": __version__,
        "system": study.system,
        "scene": study.scene,
        "time": list(study.time),
        "needs": list(study.needs),
        "tolerances": list(study.tolerances),
        "grid_points": study.points,
        "reference": {name: _plain(value) for name, value in asdict(study.reference).items()},
        "resolved": f"errors of at least {RESOLVED:g} times the reference's own",
        "machine": {**asdict(study.machine), "line": study.machine.line},
        "formulations": [{name: _plain(value) for name, value in asdict(cost).items()} for cost in study.costs],
        "results": [_result(result) for result in study.results],
        "left_out": [{"what": what, "why": why} for what, why in study.left_out],
        "notes": list(study.notes),
        "recommendations": advice,
    }


def to_json(study: Study) -> str:
    """The study as JSON with a versioned schema."""
    return json.dumps(to_data(study), indent=1, ensure_ascii=False) + "\n"


def _result(result: Result) -> dict[str, object]:
    values = {name: _plain(value) for name, value in asdict(result).items() if name != "case"}
    return {**asdict(result.case), **values}


def _plain(value: object) -> object:
    return None if isinstance(value, float) and not math.isfinite(value) else value


def to_markdown(study: Study) -> str:
    """Recommendations in words, then tables: the time to each accuracy, the formulations, failures, where it comes from."""
    advice = [f"- **{spell_power(a.target)}**: {a.text}" for a in advise(study)]
    parts = [
        f"# {study.system}, scene `{study.scene}`: work against precision",
        f"{describe_question(study)}.",
        "## Which to take",
        "\n".join(advice),
        "## Time of one run to an error at the end",
        *([_table_of_times(study)]),
        "## One right-hand side",
        _table_of_costs(study),
        *_omissions(study),
        *_failures(study),
        *_left_out(study),
        "## Where the numbers come from",
        "\n".join(f"- {line}" for line in provenance(study)),
    ]
    return "\n\n".join(parts) + "\n"


def provenance(study: Study) -> list[str]:
    """Reference, measure of errors, measure of time, machine."""
    about = study.reference
    lines = [
        f"reference: {about.method} in {about.arithmetic}, confirmed by {about.confirmed_by}; the two differ by "
        f"{about.error:.1e}, which is taken for the reference's own error",
        f"errors below {RESOLVED:g} times that are marked as not resolved",
        "errors are relative to each quantity's largest magnitude along the motion; an accuracy counts as reached when all "
        "tighter cases of the same line reach it as well",
        f"times are the processor's, of whole runs that keep the end only, repeated inside compiled code after a warm-up, the "
        f"fastest of the repeats; along the motion errors are taken at {study.points} rows",
        "a tolerance is what the integrator is given for each step (`nhc run --tol` gives it a hundredth of what is asked)",
        f"machine: {study.machine.line}",
    ]
    return [*lines, *study.notes]


def series_of(study: Study) -> dict[tuple[str, str, str], list[Result]]:
    """The cases of each line, in the study's order."""
    lines: dict[tuple[str, str, str], list[Result]] = {}
    for result in study.results:
        lines.setdefault(result.case.series, []).append(result)
    return lines


def times_to_targets(study: Study) -> list[tuple[tuple[str, str, str], list[float]]]:
    """For each line that reaches anything the least time to each of the targets, not a number where it is not reached."""
    rows = []
    for series, line in series_of(study).items():
        found = [fastest(line, target, study.reference.error) for target in TARGETS]
        if any(found):
            rows.append((series, [math.nan if r is None else r.best for r in found]))
    return rows


def list_omissions(study: Study) -> list[tuple[str, list[tuple[str, str]]]]:
    """(which models, [(entry, reason)]) of what the scene's models leave out of the state; the same list stands once."""
    found: dict[tuple[tuple[str, str], ...], list[str]] = {}
    for cost in study.costs:
        if cost.left:
            found.setdefault(cost.left, []).append(f"{cost.formulation} ({cost.states} of {cost.full_states} states)")
    return [(", ".join(names), list(left)) for left, names in found.items()]


def _omissions(study: Study) -> list[str]:
    parts = [
        f"{names}\n\n" + "\n".join(f"- `{name}`: {reason}" for name, reason in left)
        for names, left in list_omissions(study)
    ]
    return ["## What the scene does not need", *parts] if parts else []


def _table_of_times(study: Study) -> str:
    head = ["equations", "method", "run by", *(spell_power(target) for target in TARGETS)]
    rows = [
        [series[0], series[1], LANGUAGE_NAMES.get(series[2], series[2]), *(duration(t) for t in times)]
        for series, times in times_to_targets(study)
    ]
    return table(head, rows, left=3)


def _table_of_costs(study: Study) -> str:
    head = ["equations", "number", "why", "states", "operations", "C", "Python"]
    rows = [
        [c.formulation, c.number, c.reason, str(c.states), c.operations]
        + ([f"as {c.twin}"] * 2 if c.twin else [duration(c.c), duration(c.python)])
        for c in study.costs
    ]
    return table(head, rows, left=5)


def table(head: list[str], rows: list[list[str]], left: int) -> str:
    """A Markdown table; columns from ``left`` on are set to the right."""
    rule = ["---" if k < left else "---:" for k in range(len(head))]
    lines = [head, rule, *([cell.replace("|", "\\|") for cell in row] for row in rows)]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def list_failures(study: Study) -> list[tuple[str, str, int]]:
    """(formulation and method, reason, number of runs), one for each reason without the place where it struck."""
    found: dict[tuple[str, str], list[Result]] = {}
    for result in study.results:
        if result.failed:
            reason = result.failed.rsplit(" (t = ", 1)[0]
            reason = reason.split(" (step ", 1)[0]
            found.setdefault((result.case.formulation, reason), []).append(result)
    rows = []
    for (formulation, reason), results in found.items():
        methods = ", ".join(dict.fromkeys(r.case.method for r in results))
        rows.append((f"{formulation} with {methods}", reason, len(results)))
    return rows


def _failures(study: Study) -> list[str]:
    rows = list_failures(study)
    if not rows:
        return []
    return ["## Failed runs", "\n".join(f"- {what}: {why} ({runs_of(count)})" for what, why, count in rows)]


def runs_of(count: int) -> str:
    """A number of runs."""
    return f"{count} run" if count == 1 else f"{count} runs"


def _left_out(study: Study) -> list[str]:
    if not study.left_out:
        return []
    return ["## Left out", "\n".join(f"- {what}: {why}" for what, why in study.left_out)]
