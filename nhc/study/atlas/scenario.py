"""What every scenario offers, and the tools that they share."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from nhc.algebra.rewriting.rules import WithoutRules
from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.mechanics.about import scene_about
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.mechanics.system import System
from nhc.program.runs.watch import Watch
from nhc.records import record
from nhc.resources import find_specs
from nhc.simulate.methods import RUNGE_KUTTA
from nhc.simulate.methods.tableau import Collocation
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.task import Outcome, Task
from nhc.simulate.workshop import Model, load
from nhc.study.linearization.units import Matrix


@record
class Measure:
    """``number`` is what was measured, ``text`` says what it is."""

    text: str
    number: float


@record
class Verdict:
    """The result of one scenario: it has ``passed`` if the naive way fails as expected and nhc meets the ``criterion``."""

    naive: Measure
    nhc: Measure
    criterion: str
    passed: bool


@record
class Scenario:
    """``code`` is that of the catalogue of failures; ``slow`` ones run by ``make atlas`` only."""

    code: str
    title: str
    system: str
    run: Callable[[], Verdict]
    slow: bool = False


def spec_path(name: str) -> Path:
    """The file of a gallery system, or of one of the atlas's own."""
    folder = find_specs()
    own = folder / "atlas" / f"{name}.yaml"
    return own if own.is_file() else folder / f"{name}.yaml"


def open_system(name: str, without: Sequence[str] = ()) -> System:
    """A gallery system, or one of the atlas's own; derived ``without`` some rewriting rules, as one would write it by hand."""
    return resolve(decode(read(str(spec_path(name)))), WithoutRules(without) if without else None)


def edit_spec(name: str, drop: Sequence[str], add: str) -> Source:
    """The text of a gallery system without the lines that begin with ``drop``, and with ``add`` at its end."""
    text = spec_path(name).read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not (drop and line.startswith(tuple(drop)))]
    return Source(f"{name}.yaml", "\n".join([*lines, add, ""]))


@record
class Runner:
    """A formulation of a system from one start, with one method loaded."""

    job: Job
    model: Model
    method: str

    def run(
        self, times: Sequence[float], step: float = 0.0, tolerance: float = 1e-12, y: Sequence[float] | None = None
    ) -> Outcome:
        """Integrate over ``times``."""
        task = Task(self.job.p, self.job.y if y is None else y, times, tolerance, step, stops=self.job.stops)
        return self.model.integrate(task, self.method, self.model.news())

    def checks(self, times: Sequence[float], outcome: Outcome, group: str) -> Matrix:
        """Columns of a group of checks (energy, residual, position) at the rows that were reached."""
        rows = np.array(self.model.quantities(times[: len(outcome.states)], outcome.states, self.job.p))
        offset = len(self.job.columns)
        places = [offset + k for k, column in enumerate(self.job.checks) if column.group == group]
        return np.asarray(rows[:, places])


def open_runner(
    system: System,
    about: str,
    method: str,
    formulation: str = "",
    settings: Sequence[str] = (),
    needs: Sequence[str] = (),
    watch: bool = True,
    start: Start | None = None,
    hold: bool = True,
) -> Runner:
    """``hold`` False: states are not brought back to their constraints.  ``watch`` False takes the determinants' watch out, as code
    that knows nothing of them would run.
    """
    form = formulate(system, formulation)
    begin = start or start_of(system, scene_about(system.spec, about, settings))
    implicit = isinstance(RUNGE_KUTTA[method], Collocation)
    wanted = needs or system.q_names
    recipe = Recipe(equations_of(system, form), tuple(wanted), jacobian=implicit, hold=hold, checks=True)
    job = prepare(recipe, form, begin)
    if not watch:
        functions = tuple(f for f in job.program.functions if f.name != "watch")
        job = replace(job, program=replace(job.program, functions=functions), watch=Watch())
    model, _ = load(job, method)
    return Runner(job, model, method)


def grid(end: float, rows: int) -> tuple[float, ...]:
    """Equally spaced times from 0, the last exactly the end."""
    return (*(end * k / (rows - 1) for k in range(rows - 1)), end)
