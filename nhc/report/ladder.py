"""A ladder of approximate models as text, as data, and the smallest of them as a spec."""

from __future__ import annotations

from typing import Any

from nhc.study.chart.words import duration
from nhc.study.simplify.ladder import NOT_MEASURED, NOTHING_SAVED, Ladder

_LONGER = 1.2  # times the work of another model in a run, where the smallest one is said to take longer
_FEW = 3  # things that stay for one reason, up to which each has a line
_SHOWN = 6  # needed quantities with a column of their own in the table


def print_ladder(ladder: Ladder, width: int = 0) -> str:
    """The ladder as a table, then what stays and why; ``width`` is that of a terminal, 0 where lines may have any."""
    lines = [
        f"{ladder.system}, scene {ladder.scene}: needs {', '.join(ladder.needs)}, within {ladder.tolerance:g}",
        *ladder.changes,
        f"measured {print_how(ladder)}",
        "errors: the largest on the output grid, relative to each quantity's largest magnitude there; "
        "those of the full model are the reference's own",
        *_table(ladder, width),
        _confirmation(ladder),
        *note_longer(ladder),
    ]
    if len(ladder.rungs) == 1:
        lines.append("nothing can be left out within the tolerance")
    if ladder.kept:
        lines.append("kept")
        lines += _reasons(ladder)
    if ladder.bounded:
        lines.append(f"the bound of {ladder.most} runs was reached: more could perhaps be left out")
    return "\n".join(lines)


def _reasons(ladder: Ladder) -> list[str]:
    """What is missed where it is left out, then how much would save nothing and how much was not measured."""
    idle = [kept for kept in ladder.kept if kept.reason.startswith(NOTHING_SAVED)]
    unknown = [kept for kept in ladder.kept if kept.reason.startswith(NOT_MEASURED)]
    found = [f"  {kept.about}: {kept.reason}" for kept in ladder.kept if kept not in idle and kept not in unknown]
    for some, words in ((idle, NOTHING_SAVED), (unknown, f"{NOT_MEASURED}, for the bound on runs is reached")):
        if len(some) > _FEW:
            plural = words.replace("without it", "without any of them")
            found.append(f"  {len(some)} more: {plural} (`--json` has them all)")
        else:
            found += [f"  {kept.about}: {kept.reason}" for kept in some]
    return found


def _table(ladder: Ladder, width: int) -> list[str]:
    """A line for each model; where these are too wide, what is left out and the errors of each quantity stand below."""
    single = 1 < len(ladder.needs) <= _SHOWN
    head = ["", "equations", "operations", "rhs", "run", "error", *(ladder.needs if single else ()), "left out"]
    rows = [head]
    for row, rung in zip(list_rungs(ladder), ladder.rungs, strict=True):
        rows.append([*row[:-1], *(f"{error:.1e}" for error in (rung.errors if single else ())), row[-1]])
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    if 0 < width < sum(widths) + 2 * (len(head) - 1):
        return _stacked(rows, widths, len(head) - len(ladder.needs if single else ()) - 1)
    found = []
    for row in rows:
        cells = [cell.rjust(width) for cell, width in zip(row[:-1], widths, strict=False)]
        found.append("  ".join([*cells, row[-1]]))
    return found


def _stacked(rows: list[list[str]], widths: list[int], sizes: int) -> list[str]:
    """The numbers of each model on a line, then what is left out, then the errors of each quantity."""
    head = rows[0]
    found = []
    for row in rows:
        found.append("  ".join(cell.rjust(size) for cell, size in zip(row[:sizes], widths, strict=False)))
        if row is not head:
            found.append(f"   {row[-1]}")
            errors = [f"{name} {cell}" for name, cell in zip(head[sizes:-1], row[sizes:-1], strict=True)]
            found += [f"   {', '.join(errors)}"] if errors else []
    return found


def _confirmation(ladder: Ladder) -> str:
    return f"the last one again, by {ladder.confirmed}: error {max(ladder.again):.1e}"


def note_longer(ladder: Ladder) -> list[str]:
    """Where the smallest model is not the one that has the least to do in a run: it needs so many more steps."""
    work = [rung.size.run_work for rung in ladder.rungs]
    least = work.index(min(work))
    if work[-1] <= _LONGER * work[least]:
        return []
    calls, fewer = ladder.rungs[-1].size.calls, ladder.rungs[least].size.calls
    return [
        f"the smallest model is not the quickest: its run takes {calls} right-hand sides, that of number {least} only {fewer}"
    ]


def list_rungs(ladder: Ladder) -> list[list[str]]:
    """A row for each model: its number, equations, operations, time of a right-hand side and of a run, error, what is left out."""
    return [
        [
            str(k),
            str(rung.size.states),
            str(rung.size.operations),
            duration(rung.price.rhs),
            duration(rung.price.run),
            f"{rung.error:.1e}",
            rung.dropped or "nothing: the full model",
        ]
        for k, rung in enumerate(ladder.rungs)
    ]


def print_how(ladder: Ladder) -> str:
    """Method, tolerance, points, and how much was tried."""
    start, end = ladder.time
    code = "emitted C" if ladder.compiled else "emitted Python"
    back = f", {ladder.turned_back} times something put back for others" if ladder.turned_back else ""
    return (
        f"with {ladder.method} ({code}) at tolerance {ladder.run_tolerance:g} on {ladder.points} points of "
        f"t = {start:g} to {end:g}, {ladder.runs} smaller models tried{back}"
    )


def reduced_spec(ladder: Ladder) -> str:
    """The smallest model as a spec: first comments on what was left out, where, and how large the errors are."""
    last = ladder.rungs[-1]
    lines = [f"An approximate model, made by `nhc reduce --scene {ladder.scene} --tol {ladder.tolerance:g}`."]
    if ladder.dropped:
        lines.append(
            "Left out, with the error after it (largest on the output grid, relative to each quantity's size):"
        )
        lines += [f"  {rung.dropped}: error {rung.error:.1e}" for rung in ladder.rungs[1:]]
    else:
        lines.append("Nothing could be left out within this tolerance.")
    lines.append("Errors of what the scene needs:")
    lines += [f"  {need}: {error:.1e}" for need, error in zip(ladder.needs, last.errors, strict=True)]
    full = ladder.rungs[0].size
    lines.append(
        f"Size: {last.size.states} equations, {last.size.operations} operations; "
        f"the full model has {full.states} and {full.operations}."
    )
    lines.append(f"Measured {print_how(ladder)};")
    lines.append(f"measured again by {ladder.confirmed}: error {max(ladder.again):.1e}.")
    lines += [f"The scene has {change}." for change in ladder.changes]
    lines.append(f"It holds for the scene {ladder.scene} only, from its start and with its parameters:")
    lines += [f"  {name} = {value!r}" for name, value in ladder.parameters]
    lines.append("and was measured in these ranges, outside of which nothing is known of its errors:")
    lines += [
        f"  {name}: {low:.6g} to {high:.6g}{f' {unit}' if unit else ''}" for name, low, high, unit in ladder.ranges
    ]
    if ladder.bounded:
        lines.append(f"The bound of {ladder.most} runs was reached: more could perhaps be left out.")
    return "".join(f"# {line}\n" for line in lines) + ladder.spec


def ladder_data(ladder: Ladder) -> dict[str, Any]:
    """The same for JSON."""
    return {
        "system": ladder.system,
        "scene": ladder.scene,
        "time": list(ladder.time),
        "points": ladder.points,
        "method": ladder.method,
        "language": "c" if ladder.compiled else "python",
        "tolerance": ladder.tolerance,
        "run_tolerance": ladder.run_tolerance,
        "parameters": dict(ladder.parameters),
        "need": list(ladder.needs),
        "ranges": {name: [low, high] for name, low, high, _ in ladder.ranges},
        "ladder": [
            {
                "left_out": rung.dropped or None,
                "error": rung.error,
                "errors": dict(zip(ladder.needs, rung.errors, strict=True)),
                "states": rung.size.states,
                "operations": rung.size.operations,
                "calls": rung.size.calls,
                "rhs_seconds": rung.price.rhs,
                "run_seconds": rung.price.run,
            }
            for rung in ladder.rungs
        ],
        "changes": list(ladder.changes),
        "kept": [{"what": kept.about, "reason": kept.reason} for kept in ladder.kept],
        "confirmed": {"by": ladder.confirmed, "errors": dict(zip(ladder.needs, ladder.again, strict=True))},
        "machine": ladder.machine,
        "turned_back": ladder.turned_back,
        "runs": ladder.runs,
        "bounded": ladder.bounded,
        "spec": reduced_spec(ladder),
    }
