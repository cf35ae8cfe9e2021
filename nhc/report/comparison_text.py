"""Models held against the finest one, as JSON and as Markdown, and in words."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from dataclasses import asdict

from nhc.report.chart_text import table
from nhc.study.chart.advice import fastest
from nhc.study.chart.case import Result
from nhc.study.chart.fidelity import Comparison, Rung
from nhc.study.chart.words import duration, setting, spell_power
from nhc.version import __version__

SCHEMA = "nhc.comparison/1"
TARGETS = (0.3, 0.1, 0.03, 1e-2, 1e-3, 1e-6, 1e-9)
NOT_ITS_OWN = 0.1
"""Of a model's error: the most that its integrator may have of it for the number to be the model's."""


def advise_models(made: Comparison) -> list[tuple[float, Result | None, str]]:
    """(accuracy, run, words): the fastest run of any model for each accuracy; neighbours with the same run are one line."""
    found: list[tuple[float, Result | None, str]] = []
    for target in TARGETS:
        best = fastest(made.results, target, made.reference.error)
        if found and best is not None and best == found[-1][1]:
            found.pop()
        if best is None:
            if any(result.failed for result in made.results) or not found or found[-1][1] is not None:
                found.append((target, None, f"no run of these models comes within {spell_power(target)}"))
            continue
        found.append((target, best, _words(made, best, target)))
    return found


def _words(made: Comparison, best: Result, target: float) -> str:
    case = best.case
    text = f"{case.formulation} with {case.method} at {setting(case)}: error {best.error:.1e}, {duration(best.best)}"
    reasons = []
    for rung in made.rungs:
        if rung.name == case.formulation:
            continue
        own = [r for r in made.results if r.case.formulation == rung.name]
        other = fastest(own, target, made.reference.error)
        if other is not None:
            reasons.append(f"{rung.name} takes {other.best / best.best:.1f} times as long")
        elif rung.error > target:
            reasons.append(f"{rung.name} is {rung.error:.1e} away from {made.finest}")
        else:
            reasons.append(f"{rung.name} does not reach it")
    return "; ".join([text, *reasons])


def observations(made: Comparison) -> list[str]:
    """Models that are not worth their price: another one is nearer to the finest and not dearer, or as near and cheaper."""
    found = []
    for rung in made.rungs:
        if rung.name == made.finest or not math.isfinite(rung.error):
            continue
        better = [other for other in made.rungs if other is not rung and _beats(other, rung)]
        if better:
            best = min(better, key=lambda other: (other.error, other.operations))
            found.append(
                f"on this scene {rung.name} is not worth its price: {best.name} errs by {best.error:.1e} against "
                f"{rung.error:.1e}, with {_size(best)} against {_size(rung)}"
            )
    return found


def _size(rung: Rung) -> str:
    return f"{rung.operations} operations in {rung.states} equation{'s' if rung.states != 1 else ''}"


def _beats(a: Rung, b: Rung) -> bool:
    """By what is counted, not by what is timed."""
    smaller = a.operations <= b.operations and a.states <= b.states
    as_near = a.error == b.error or (_is_integration(a) and _is_integration(b))
    if as_near:
        return smaller and (a.operations, a.states) != (b.operations, b.states)
    return smaller and a.error < b.error


def _is_integration(rung: Rung) -> bool:
    """Whether what is seen of a model's error is that of its runs."""
    return not rung.own <= NOT_ITS_OWN * rung.error


def to_data(made: Comparison) -> dict[str, object]:
    """The comparison as plain data; null where there is no number."""
    return {
        "schema": SCHEMA,
        "nhc": __version__,
        "scene": made.scene,
        "against": made.finest,
        "time": list(made.time),
        "tolerance": made.tolerance,
        "needs": list(made.needs),
        "grid_points": len(made.times),
        "sizes": list(made.sizes),
        "reference": {name: plain(value) for name, value in asdict(made.reference).items()},
        "machine": {**asdict(made.machine), "line": made.machine.line},
        "models": [_rung(rung, made.needs) for rung in made.rungs],
        "results": [
            {
                "model": result.case.formulation,
                **{name: plain(getattr(result.case, name)) for name in ("method", "language", "tolerance", "step")},
                **{name: plain(value) for name, value in asdict(result).items() if name != "case"},
            }
            for result in made.results
        ],
        "times": list(made.times),
        "motions": {
            rung.name: {need: _column(rung.rows, k) for k, need in enumerate(made.needs)} for rung in made.rungs
        },
        "recommendations": [
            {
                "target": target,
                "text": text,
                "model": best.case.formulation if best else None,
                "tolerance": best.case.tolerance if best else None,
            }
            for target, best, text in advise_models(made)
        ],
        "observations": observations(made),
        "notes": list(made.notes),
    }


def _column(rows: Sequence[Sequence[float]], k: int) -> list[float]:
    return [row[k] for row in rows]


def plain(value: object) -> object:
    """None for what is no number."""
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _rung(rung: Rung, needs: Sequence[str]) -> dict[str, object]:
    names = ("name", "path", "system", "about", "formulation", "reason", "method", "why", "states", "full_states")
    return {
        **{name: getattr(rung, name) for name in names},
        "operations": rung.operations,
        "rhs_seconds": plain(rung.rhs),
        "run_seconds": plain(rung.run),
        "errors": {need: plain(error) for need, error in zip(needs, rung.errors, strict=True)},
        "integration_error": plain(rung.own),
        "left_out": [{"name": name, "reason": reason} for name, reason in rung.left],
    }


def to_json(made: Comparison) -> str:
    """The comparison as JSON with a versioned schema."""
    return json.dumps(to_data(made), indent=1, ensure_ascii=False) + "\n"


def to_markdown(made: Comparison) -> str:
    """What to take for which accuracy, then the table of models, failures, where the numbers come from."""
    head, rows = table_of_models(made)
    failures = list_failures(made)
    parts = [
        f"# Scene `{made.scene}`: models against `{made.finest}`",
        f"Quantities: {', '.join(made.needs)}; t from {made.time[0]:g} to {made.time[1]:g}.",
        "## Which to take",
        "\n".join(f"- **{spell_power(target)}**: {text}" for target, _, text in advise_models(made)),
        *observations(made),
        "## Models",
        table(head, rows, left=2),
        *_omissions(made),
        *(["## Failed runs", "\n".join(f"- {line}" for line in failures)] if failures else []),
        "## Where the numbers come from",
        "\n".join(f"- {line}" for line in provenance(made)),
    ]
    return "\n\n".join(parts) + "\n"


def table_of_models(made: Comparison) -> tuple[list[str], list[list[str]]]:
    """A row for each model: its size, its costs, the error of each quantity."""
    head = ["model", "equations", "state", "operations", "right-hand side", "run", *made.needs]
    rows = []
    for rung in made.rungs:
        rows.append(
            [
                rung.name,
                rung.formulation,
                f"{rung.states} of {rung.full_states}",
                str(rung.operations),
                duration(rung.rhs),
                duration(rung.run),
                *(spell_error(made, rung, error) for error in rung.errors),
            ]
        )
    return head, rows


def spell_error(made: Comparison, rung: Rung, error: float) -> str:
    """An error of a model; that of the finest is its integrator's."""
    if not math.isfinite(error):
        return "-"
    if rung.name == made.finest:
        return "exact by definition"
    return f"{error:.1e}" + ("" if rung.own <= NOT_ITS_OWN * error else f" (integrator {rung.own:.0e})")


def _omissions(made: Comparison) -> list[str]:
    lines = [f"- {rung.name}: `{name}`: {reason}" for rung in made.rungs for name, reason in rung.left]
    return ["## What the scene does not need", "\n".join(lines)] if lines else []


def list_failures(made: Comparison) -> list[str]:
    """A line for each run that did not come to the end."""
    return [
        f"{r.case.formulation} with {r.case.method} at {setting(r.case)}: {r.failed}" for r in made.results if r.failed
    ]


def provenance(made: Comparison) -> list[str]:
    """Reference, measure of errors, measure of time, machine."""
    about = made.reference
    methods = "; ".join(f"{rung.name} by {rung.method} ({rung.why})" for rung in made.rungs)
    return [
        f"reference: {made.finest} by {about.method} in {about.arithmetic}, confirmed by {about.confirmed_by}; the two differ "
        f"by {about.error:.1e}",
        f"an error is the largest distance from the reference on {len(made.times)} equally spaced times, relative to the "
        "quantity's largest magnitude there; of several quantities the worst counts",
        f"a model's own error is that of its run at the tightest tolerance; methods: {methods}",
        "each model runs on the smallest state that the quantities depend on; times are those of whole runs that keep the end "
        "only, repeated inside compiled code, the fastest of the repeats; the table's `run` is the fastest whose integrator "
        f"errs by no more than the scene's tolerance ({made.tolerance:g}): so far from the model's own tightest run",
        f"machine: {made.machine.line}",
        *made.notes,
    ]
