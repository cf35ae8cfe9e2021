"""What ``nhc run`` does on a scene: changes of formulation and method, what it warns of, where it stops."""

from __future__ import annotations

from nhc.simulate.prepare import Recipe, prepare
from nhc.simulate.run import Settings, run
from nhc.study.stability.bench import Bench


def conduct(bench: Bench) -> tuple[str, ...]:
    """The notes of a run without a method of its own from the bench's start, and why it stops where it does not end."""
    names = bench.equations.system.q_names
    job = prepare(Recipe(bench.equations, names, weak=True), bench.formulation, bench.start)
    found = run(job, Settings(points=2, compiled=bench.model.compiled))
    if found.ended == "done":
        return found.notes
    return (*found.notes, f"it stops at t = {found.outcome.t:.9g} with exit code 3: {found.reason}")
