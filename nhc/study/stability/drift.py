"""Long-run drift: energy, constraints and integrals over several lengths of a scene.

Each series is a deviation from the start; its size is compared in the first and in the last tenth, which tells
growth.  Where the energy is not conserved its balance takes its place: p q' - T + V less
the integral of its power (III.2.2), by a rule of fourth order, with the rule's own error beside it: where that hides the balance,
more rows are taken.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nhc.mechanics.properties.constancy import has_jumps
from nhc.records import record
from nhc.simulate.run import list_times
from nhc.simulate.task import DONE, ModelError, Outcome
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench

LENGTHS = 10
_ROWS, _FINER, _FINEST = 2001, 16001, 128001
ROUNDING = 1e-14
_FEW = 100  # rows to each of those that are few
Series = NDArray[np.float64]


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
        return self.floor <= max(1e-12, 0.1 * max(self.series, default=0.0))

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
    most = _FINEST if bench.model.compiled else _FINER
    for count in (_ROWS, _FINER, _FINEST):
        times = list_times(start, wanted, count)
        outcome = bench.integrate(method, times, step=step)
        rows, table = _rows(bench, times, outcome)
        drifts = tuple(drifts_of(bench, times[:rows], table)) if rows >= 20 else ()
        if all(drift.resolved for drift in drifts) or count == most:
            break
    why = "" if outcome.kind == DONE and rows == len(times) else bench.reason(outcome)
    reached = wanted if not why else (outcome.t if rows == len(outcome.states) else times[rows - 1])
    every = (count - 1) // (_ROWS - 1)
    drifts = tuple(replace(drift, series=_thinned(drift.series, every)) for drift in drifts)
    return LongRun(method, step, tuple(times[:rows:every]), drifts, reached, wanted, why)


def _thinned(series: Sequence[float], every: int) -> tuple[float, ...]:
    """The largest of so many rows each."""
    return tuple(series) if every == 1 else tuple(max(series[k : k + every]) for k in range(0, len(series), every))


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


def drifts_of(bench: Bench, times: Sequence[float], table: Matrix) -> list[Drift]:
    """Every conserved quantity and every residual of a run."""
    found = [_energy(bench, times, table)]
    for group in ("integral", "hidden"):
        for k in bench.group(group):
            heading = bench.columns[k].heading
            if group == "hidden" and has_jumps(bench.equations.system, [bench.columns[k].node]):
                continue  # it is another constant after a whole turn
            if heading not in ("E", "(T + V)", "(p q' - T + V)"):
                found.append(_relative(bench, k, heading, group, table[:, k]))
    for group in ("residual", "position"):
        for k in bench.group(group):
            found.append(_drift(bench.columns[k].heading, group, False, table[:, k], ROUNDING))
    return found


def _energy(bench: Bench, times: Sequence[float], table: Matrix) -> Drift:
    kept = bench.conserved
    if kept.energy:
        place = bench.group("energy")[0]
        return _relative(bench, place, "T + V", "energy", table[:, place])
    place = bench.group("jacobi")[0]
    general = table[:, place]
    if kept.jacobi:
        return _relative(bench, place, "p q' - T + V", "energy", general)
    work, error = accumulate(times, table[:, bench.group("power")[0]])
    error = max(error, find_leaps(general - general[0] - work))
    early = work[: max(2, len(work) // 10)]  # a run that blows up is not measured by what it comes to
    scale = max(float(bench.typical_sizes[place]), float(np.max(np.abs(early), initial=0.0))) or 1.0
    return _drift("p q' - T + V less the work", "balance", True, (general - general[0] - work) / scale, error / scale)


def find_leaps(deviations: Series) -> float:
    """What arises between few neighbouring rows, if that is half of all that arises: a motion that leaps between two rows, as Van
    der Pol's does, leaps between every second and every fourth, too, so that the rule's own estimate does not see it.
    """
    steps = np.sort(np.abs(np.diff(deviations)))
    few = float(steps[-max(1, len(steps) // _FEW) :].sum())
    return few if few > 0.5 * float(steps.sum()) else 0.0


def accumulate(times: Sequence[float], values: Series) -> tuple[Series, float]:
    """The integral from the start to each row by cubics through neighbouring rows, and the estimate of its error.

    Rows are equally spaced; the error is that of the same rule on every second row.  A fifteenth of it is left on all rows if it is
    of fourth order, which every fourth row tells: the rule knows nothing of what decays faster than from row to row.
    """
    h = times[1] - times[0]
    fine, coarse, coarsest = (_cumulative(values[::every], every * h) for every in (1, 2, 4))
    error = float(np.max(np.abs(coarse - fine[::2]), initial=0.0))
    fourth = 8.0 * error < float(np.max(np.abs(coarsest - coarse[::2]), initial=0.0))
    return fine, (error / 15 if fourth else error) + 1e-15 * float(np.max(np.abs(fine)))


def _cumulative(f: Series, h: float) -> Series:
    """Each interval by the cubic through four rows (Newton and Cotes); the ends by the one-sided cubic."""
    if len(f) < 4:
        parts = h * (f[1:] + f[:-1]) / 2
    else:
        inner = h / 24 * (-f[:-3] + 13 * f[1:-2] + 13 * f[2:-1] - f[3:])
        first = h / 24 * (9 * f[0] + 19 * f[1] - 5 * f[2] + f[3])
        last = h / 24 * (9 * f[-1] + 19 * f[-2] - 5 * f[-3] + f[-4])
        parts = np.concatenate([[first], inner, [last]])
    return np.concatenate([[0.0], np.cumsum(parts)])


def _relative(bench: Bench, place: int, what: str, kind: str, values: Series) -> Drift:
    scale, most = float(bench.typical_sizes[place]), float(bench.column_sizes[place])
    floor = ROUNDING * max(most / scale, 1.0) if scale > 0 else ROUNDING
    return _drift(what, kind, scale > 0, (values - values[0]) / (scale or 1.0), floor)


def _drift(what: str, kind: str, relative: bool, deviations: Series, floor: float) -> Drift:
    size, tenth = np.abs(deviations), max(1, len(deviations) // 10)
    first, last = float(size[:tenth].max()), float(size[-tenth:].max())
    return Drift(what, kind, relative, first, last, floor, tuple(size.tolist()))
