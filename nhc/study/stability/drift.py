"""Long-run drift: energy, constraints and integrals over several lengths of a scene.

Each series is a deviation from the start; its size is compared in the first and in the last tenth, which tells
growth.  Where the energy is not conserved its balance takes its place (:mod:`nhc.study.stability.work`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from nhc.algebra.exact.modular import is_zero
from nhc.mechanics.properties.constancy import has_jumps
from nhc.records import record
from nhc.simulate.run import list_times
from nhc.simulate.task import DONE, ModelError, Outcome
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench
from nhc.study.stability.work import ENOUGH, Series, balance

LENGTHS = 10
_ROWS = 2001
ROUNDING = 1e-14


@record
class Drift:
    """``first`` and ``last``: the largest deviations in the first and the last tenth; ``floor``: what is rounding.

    ``relative``: to the quantity's largest magnitude in the scene, an energy's also to that of T; one that is zero by cancellation
    is not measured against its own rounding, but against what it can be, its slopes times the sizes of the state.
    """

    what: str
    kind: str
    relative: bool
    first: float
    last: float
    floor: float
    series: tuple[float, ...]

    @property
    def resolved(self) -> bool:
        """Whether the rule that a balance is integrated by does not hide it."""
        return self.floor <= max(ENOUGH[0], ENOUGH[1] * max(self.series, default=0.0))

    @property
    def grows(self) -> bool:
        return self.last > 2.0 * max(self.first, self.floor)


@record
class LongRun:
    """``reached`` of the ``wanted`` end, and ``why`` not further."""

    method: str
    step: float
    times: tuple[float, ...]
    drifts: tuple[Drift, ...]
    reached: float
    wanted: float
    why: str


def long_run(bench: Bench, lengths: float, method: str = "dop853", step: float = 0.0) -> LongRun:
    """Run ``lengths`` times the scene's time with one method and look at what should stay as it was."""
    start, end = bench.job.time
    wanted = start + lengths * (end - start)
    times = list_times(start, wanted, _ROWS)
    outcome = bench.integrate(method, times, step=step, logged=True)
    rows, table = _rows(bench, times, outcome)
    why = "" if outcome.kind == DONE and rows == len(times) else bench.reason(outcome)
    reached = wanted if not why else (outcome.t if rows == len(outcome.states) else times[rows - 1])
    run = LongRun(method, step, tuple(times[:rows]), (), reached, wanted, why)
    if rows < 20:
        return run
    return replace(run, drifts=(_energy(bench, run, table, outcome.ends), *_others(bench, table)))


def _rows(bench: Bench, times: Sequence[float], outcome: Outcome) -> tuple[int, Matrix]:
    """The columns at the rows that have values."""
    states = np.array(outcome.states, dtype=float).reshape(len(outcome.states), -1)
    states = states[np.isfinite(states).all(axis=1)]
    count = len(states)
    while count:
        try:
            return count, bench.quantities(times[:count], states[:count])
        except ModelError as error:
            count = min(error.row, count - 1)
    return 0, np.zeros((0, len(bench.columns)))


def _others(bench: Bench, table: Matrix) -> list[Drift]:
    """Every conserved quantity but the energy, and every residual of a run, each fact once."""
    found = []
    for group in ("integral", "hidden"):
        for k in bench.group(group):
            if _is_position(bench, k):
                continue
            heading = bench.columns[k].heading
            if group == "hidden" and has_jumps(bench.equations.system, [bench.columns[k].node]):
                continue  # it is another constant after a whole turn
            if heading not in ("E", "(T + V)", "(p q' - T + V)"):
                found.append(_relative(bench, k, heading, group, table[:, k]))
    for group in ("residual", "position"):
        for k in bench.group(group):
            if not _says_nothing(bench, k):
                found.append(_drift(bench.columns[k].heading, group, False, table[:, k], ROUNDING))
    return found


def _is_position(bench: Bench, place: int) -> bool:
    """Whether a conserved quantity is, but for its sign, the left side of a holonomic constraint, which has a row of its own."""
    g, node = bench.equations.system.graph, bench.columns[place].node
    sides = [bench.columns[k].node for k in bench.group("position")]
    return any(is_zero(g, g.sub(node, side)) or is_zero(g, g.add(node, side)) for side in sides)


def _says_nothing(bench: Bench, place: int) -> bool:
    """Whether this is the residual of a holonomic constraint that is zero in any state, as with the velocities of a rotation."""
    column, system = bench.columns[place], bench.equations.system
    held = {form.name for form in system.constraints if form.equation is not None}
    return column.group == "residual" and column.heading in held and column.node == system.graph.zero


def _energy(bench: Bench, run: LongRun, table: Matrix, ends: Sequence[float]) -> Drift:
    kept = bench.conserved
    if kept.energy:
        place = bench.group("energy")[0]
        return _relative(bench, place, "T + V", "energy", table[:, place])
    place = bench.group("jacobi")[0]
    if kept.jacobi:
        return _relative(bench, place, "p q' - T + V", "energy", table[:, place])
    found = balance(bench, run.method, run.step, run.wanted, run.times, ends)
    early = found.work[: max(2, len(found.work) // 10)]  # a run that blows up is not measured by what it comes to
    scale = max(float(bench.typical_sizes[place]), float(np.max(np.abs(early), initial=0.0))) or 1.0
    return _drift("p q' - T + V less the work", "balance", True, found.deviations / scale, found.error / scale)


def _relative(bench: Bench, place: int, what: str, kind: str, values: Series) -> Drift:
    scale, most = float(bench.typical_sizes[place]), float(bench.column_sizes[place])
    floor = ROUNDING * max(most / scale, 1.0) if scale > 0 else ROUNDING
    return _drift(what, kind, scale > 0, (values - values[0]) / (scale or 1.0), floor)


def _drift(what: str, kind: str, relative: bool, deviations: Series, floor: float) -> Drift:
    size, tenth = np.abs(deviations), max(1, len(deviations) // 10)
    first, last = float(size[:tenth].max()), float(size[-tenth:].max())
    return Drift(what, kind, relative, first, last, floor, tuple(size.tolist()))
