"""What the models of scenes save: ``python -m benchmarks.scenes`` measures the gallery and rewrites a table of docs/scenes.md."""

from __future__ import annotations

import re
from dataclasses import dataclass

from benchmarks.systems import ROOT
from nhc.language import decode, read
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.program.scene_model import scene_model
from nhc.resources import find_specs
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.reduced import job_of
from nhc.simulate.task import DONE, Task
from nhc.study.chart.measure import describe_machine, time_repeats
from nhc.study.chart.model import ChartModel, compile_chart

PAGE = ROOT / "docs" / "scenes.md"
PART = re.compile(r"^<!-- measured: scenes -->\n.*?^<!-- end -->$", re.MULTILINE | re.DOTALL)
METHOD, TOLERANCE, MOST, BUDGET, ROUNDS = "dop853", 1e-9, 2_000_000, 0.05, 3


@dataclass(frozen=True)
class Cost:
    """Seconds of a right-hand side and of a run (infinite where it fails), and the right-hand sides of that run."""

    rhs: float
    run: float
    calls: int


@dataclass(frozen=True)
class Pair:
    """A scene with the full job and the reduced one."""

    name: str
    scene: str
    full: Job
    reduced: Job


def list_pairs() -> list[Pair]:
    """The gallery's scenes whose model is not the full one."""
    found = []
    for path in sorted(find_specs().glob("*.yaml")):
        spec = decode(read(str(path)))
        system = resolve(spec)
        base = formulate(system)
        for scene in spec.scenes:
            made = scene_model(system, base, scene, only_base=spec.formulation not in ("", "auto"))
            if not made.reduction.left and not made.chosen:
                continue
            start = start_of(system, scene)
            full = prepare(Recipe(equations_of(system, base), hold=False), base, start)
            found.append(Pair(path.stem, scene.name, full, job_of(made.planner, start, jacobian=False)))
    return found


def measure(pair: Pair) -> tuple[Cost, Cost]:
    """The costs of both, measured in turn, the least of each."""
    models = [(job, ChartModel(compile_chart(job, METHOD), job)) for job in (pair.full, pair.reduced)]
    rounds = [[take(job, model) for job, model in models] for _ in range(ROUNDS)]
    first, second = (
        Cost(min(cost.rhs for cost in costs), min(cost.run for cost in costs), costs[0].calls)
        for costs in zip(*rounds, strict=True)
    )
    return first, second


def take(job: Job, model: ChartModel) -> Cost:
    """One measurement; an infinite time where the run does not reach its end."""
    task = Task(job.p, job.y, job.time, TOLERANCE, 0.0, MOST)
    outcome = model.integrate(task, METHOD, model.news())
    rhs = time_repeats(model.rhs_at(job.time[:1], (job.y,), job.p), BUDGET)[0]
    if outcome.kind != DONE:
        return Cost(rhs, float("inf"), outcome.calls)
    return Cost(rhs, time_repeats(lambda n: model.repeat(task, METHOD, n), BUDGET)[0], outcome.calls)


def print_row(pair: Pair, full: Cost, reduced: Cost) -> str:
    """A row of the table."""
    sizes = f"{len(pair.full.y)} → {len(pair.reduced.y)}"
    runs = f"{1e6 * full.run:.3g} | {1e6 * reduced.run:.3g} | {full.run / reduced.run:.2f}"
    return f"| {pair.name} | {pair.scene} | {sizes} | {1e9 * full.rhs:.3g} | {1e9 * reduced.rhs:.3g} | {runs} |"


def print_table() -> str:
    """The table with its head and the machine."""
    heads = ("system", "scene", "n", "rhs full (ns)", "rhs reduced (ns)", "run full (µs)", "run reduced (µs)", "faster")
    rows = [f"| {' | '.join(heads)} |", "|" + "---|" * len(heads)]
    rows += [print_row(pair, *measure(pair)) for pair in list_pairs()]
    return "\n".join([*rows, "", f"Machine: {describe_machine().line}."])


def main() -> None:
    """Rewrite the part of the page between its marks."""
    text = PAGE.read_text()
    assert PART.search(text), f"{PAGE} has lost its marks"
    table = print_table()
    PAGE.write_text(PART.sub(lambda _: f"<!-- measured: scenes -->\n{table}\n<!-- end -->", text))


if __name__ == "__main__":
    main()
