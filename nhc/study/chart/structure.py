"""Structure-preserving methods in a chart: each by itself, on the natural system with all its velocities."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nhc.language.spec import Scene
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.system import System
from nhc.simulate.methods import STRUCTURE
from nhc.simulate.natural import NaturalModel
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.study.chart.case import Case, Result
from nhc.study.chart.case_runner import CaseRunner, Left
from nhc.study.chart.grid import MOST_PYTHON, Runs
from nhc.study.chart.model import RepeatedModel, compile_natural
from nhc.study.chart.reference import Solution
from nhc.study.chart.single import Rig

MOST_STEPS = 60_000
"""Fixed steps of second order beyond which a run says nothing that its coarser ones do not."""


def prepare_natural(system: System, scene: Scene, needs: Sequence[str]) -> Job:
    """The job of a scene as structure-preserving methods take it; its ``structure`` says what is lacking."""
    form = formulate(system, "multipliers" if system.constraints else "")
    start = start_of(system, scene)
    return prepare(Recipe(equations_of(system, form), tuple(needs), checks=True), form, start, natural=True)


def choose_schemes(job: Job, wanted: Sequence[str]) -> tuple[list[str], Left]:
    """The methods that apply, and why others do not."""
    found, left = [], Left()
    for name in wanted:
        lacking = job.structure.lacking
        if not lacking and STRUCTURE[name].constant_mass and not job.structure.constant_mass:
            lacking = "its mass matrix is not constant"
        if lacking:
            left.append((name, f"does not apply: {lacking}"))
        else:
            found.append(name)
    return found, left


def count_steps(wish: float, rows: int) -> int:
    """A number of steps that meet every row: what these methods keep, they keep at their steps."""
    return rows * max(math.ceil(wish / rows), 1)


def list_steps(tolerances: Sequence[float], anchor: int, order: int, rows: int) -> list[tuple[int, float]]:
    """(number of steps, tolerance that it stands for), each number once."""
    found: dict[int, float] = {}
    for tolerance in tolerances:
        found.setdefault(count_steps(anchor * (1e-3 / tolerance) ** (1.0 / order), rows), tolerance)
    return list(found.items())


def run_schemes(
    job: Job,
    wanted: Sequence[str],
    runs: Runs,
    times: Sequence[float],
    solution: Solution,
    anchor: int,
) -> tuple[list[Result], Left]:
    """All cases of the methods that apply, on ladders of fixed steps; what was left out, with the reason."""
    schemes, left = choose_schemes(job, wanted)
    found: list[Result] = []
    slow: list[str] = []
    for name in schemes:
        compiled = {name: RepeatedModel(compile_natural(job, name), job)} if "c" in runs.languages else {}
        rig = Rig(job.formulation.name, job, tuple(times), solution, compiled, NaturalModel(job.program))
        runner = CaseRunner(rig, runs.explicit, runs.budget)
        ladder = list_steps(runs.tolerances, anchor, STRUCTURE[name].order, len(times) - 1)
        for language in runs.languages:
            most = MOST_STEPS if language == "c" else MOST_PYTHON // 8  # a step of these costs several right-hand sides
            for rung, (count, tolerance) in enumerate(ladder):
                if count > most:
                    slow.append(f"{name} in {'C' if language == 'c' else 'Python'}")
                    continue
                step = abs(times[-1] - times[0]) / count
                found += runner.run(Case(rig.name, name, language, tolerance, step), rung)
        left += runner.left()
    if slow:
        left.append((", ".join(dict.fromkeys(slow)), "of second order: its finer tolerances take too many steps"))
    return found, left
