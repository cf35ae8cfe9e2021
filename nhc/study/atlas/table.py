"""All scenarios, and the table of their verdicts."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from nhc.study.atlas import (
    affine,
    bicycle,
    block,
    diagram,
    drift,
    drivers,
    falling,
    flat,
    gimbal,
    hidden,
    inconsistent,
    longtime,
    massless,
    metamorphic,
    rank,
    reversal,
    stiff,
    vectors,
)
from nhc.study.atlas.scenario import Scenario, Verdict

SCENARIOS: tuple[Scenario, ...] = tuple(
    module.SCENARIO
    for module in (
        drift,
        diagram,
        gimbal,
        block,
        rank,
        stiff,
        falling,
        flat,
        longtime,
        drivers,
        bicycle,
        reversal,
        inconsistent,
        hidden,
        massless,
        affine,
        vectors,
        metamorphic,
    )
)

Result = tuple[Scenario, Verdict]


def run_all(slow: bool, tell: Callable[[str], None]) -> list[Result]:
    """The verdicts in the catalogue's order; ``tell`` hears the title of each before it runs."""
    found = []
    for scenario in SCENARIOS:
        if slow or not scenario.slow:
            tell(f"{scenario.code}: {scenario.title}")
            found.append((scenario, scenario.run()))
    return found


def lines(results: Sequence[Result]) -> list[str]:
    """For a terminal."""
    found = []
    for scenario, verdict in results:
        head = f"{scenario.code}  {scenario.title} ({scenario.system}): {'pass' if verdict.passed else 'FAIL'}"
        found += [head, f"  naive      {verdict.naive.text}", f"  nhc        {verdict.nhc.text}"]
        found.append(f"  criterion  {verdict.criterion}")
    passed = sum(verdict.passed for _, verdict in results)
    return [*found, f"{passed} of {len(results)} pass"]


def markdown(results: Sequence[Result]) -> str:
    """For the documents: a short table, and below it what was measured, which cells have no room for."""
    rows = ["| | failure | system | nhc |", "|---|---|---|---|"]
    below: list[str] = []
    for s, v in results:
        rows.append(f"| {s.code} | {s.title} | `{s.system}` | {'pass' if v.passed else '**fail**'} |")
        below += ["", f"**{s.code}: {s.title}**", ""]
        below += [f"- naive: {v.naive.text}", f"- nhc: {v.nhc.text}", f"- criterion: {v.criterion}"]
    return "\n".join([*rows, *below]) + "\n"


def tree(results: Sequence[Result]) -> dict[str, Any]:
    """For programs."""
    return {
        "scenarios": [
            {
                "code": s.code,
                "title": s.title,
                "system": s.system,
                "naive": {"text": v.naive.text, "number": v.naive.number},
                "result": {"text": v.nhc.text, "number": v.nhc.number},
                "criterion": v.criterion,
                "passed": v.passed,
            }
            for s, v in results
        ]
    }
