"""The balance of a run's energy: p q' - T + V less the integral of its power (III.2.2), from row to row.

The power is integrated inside the steps that the run takes, by the rule of 15 nodes of Gauss and Kronrod, whose error is told by
that of Gauss's 7 nodes among them (Piessens et al. 1983).  A power that swings fast is followed for as far as the method itself
follows it, and nodes that are nowhere equally spaced cannot agree with each other on another frequency.  Energy and power are read
off the same run: more rows may change the steps of a chaotic one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from nhc.records import record
from nhc.simulate.task import ModelError
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench

Series = NDArray[np.float64]

# nodes of the rule of 15, with its weights and those of the rule of 7 (0 where that has no node), from the end to the middle
_HALF = (
    (0.991455371120812639206854697526, 0.022935322010529224963732008059, 0.0),
    (0.949107912342758524526189684048, 0.063092092629978553290700663189, 0.129484966168869693270611432679),
    (0.864864423359769072789712788641, 0.104790010322250183839876322542, 0.0),
    (0.741531185599394439863864773281, 0.140653259715525918745189590510, 0.279705391489276667901467771424),
    (0.586087235467691130294144691259, 0.169004726639267902826583426599, 0.0),
    (0.405845151377397166906606412077, 0.190350578064785409913256402421, 0.381830050505118944950369775489),
    (0.207784955007898467600689403773, 0.204432940075298892414161999235, 0.0),
)
_MIDDLE = (0.0, 0.209482141084727828012999174892, 0.417959183673469387755102040816)
_RULE = np.array([*((-x, *rest) for x, *rest in _HALF), _MIDDLE, *reversed(_HALF)])
NODES, WEIGHTS, FEWER = _RULE.T

_PARTS, _PARTS_INTERPRETED = 400_000, 4_000  # that the power is integrated over at most, each with 15 nodes
_NUMBERS = 30_000_000  # that the states at the nodes may be
_ROUNDS = 6  # in which parts are halved where the rule errs
_AT_ONCE = 20_000  # rows whose columns are computed at a time
ENOUGH = (1e-12, 0.1)
"""Of the energy, and of the deviation: an error of the rule that is less does not hide the balance."""


@record
class Balance:
    """At each row the ``deviations`` of the energy's gain from the ``work``; by how much the integral of the power may err."""

    deviations: Series
    work: Series
    error: float


def balance(
    bench: Bench, method: str, step: float, end: float, times: Sequence[float], ends: Sequence[float]
) -> Balance:
    """That of a run to ``end`` at the rows ``times``, the last of which may come before; ``ends`` are the ends of its steps.

    Parts in which the rule errs by more than its share are halved and the run done again, unless that takes too many.  The error
    is infinite where the power has no value.
    """
    rows, most = np.array(times), _NUMBERS // ((1 + len(NODES)) * len(bench.job.y))
    most = min(most, _PARTS if bench.model.compiled else _PARTS_INTERPRETED)
    every = 1 + len(ends) // max(most - len(rows), 1)
    inner = np.array(ends, dtype=float)[::every]
    points = np.union1d(rows, inner[(inner > rows[0]) & (inner < rows[-1])])
    for _ in range(_ROUNDS):
        found, errors = _follow(bench, method, step, end, rows, points)
        enough = max(ENOUGH[0] * float(np.max(np.abs(found.work))), ENOUGH[1] * float(np.max(np.abs(found.deviations))))
        wide = errors > 0.5 * enough / len(points)
        if found.error <= enough or not math.isfinite(found.error) or not 0 < np.sum(wide) <= most - len(points):
            break
        points = np.union1d(points, (points[:-1][wide] + points[1:][wide]) / 2)
    return found


def _follow(bench: Bench, method: str, step: float, end: float, rows: Series, points: Series) -> tuple[Balance, Series]:
    """The balance by the rule in each part between two points, and the rule's error in each."""
    lengths = np.diff(points)
    inside = (points[:-1] + points[1:])[:, None] / 2 + lengths[:, None] / 2 * NODES
    looks = np.append(np.column_stack([points[:-1], inside]).ravel(), points[-1])
    states = bench.states(method, np.append(looks, end) if end > looks[-1] else looks, step)
    energies, powers = _look(bench, looks, states)
    whole = max(0, (len(energies) - 1) // (1 + len(NODES)))  # parts that the run passed
    values = powers[: whole * (1 + len(NODES))].reshape(whole, -1)[:, 1:]
    halves = lengths[:whole] / 2
    gained, errors = halves * (values @ WEIGHTS), halves * (values @ (WEIGHTS - FEWER))
    work = np.append(0.0, np.cumsum(gained))
    gains = energies[: whole * (1 + len(NODES)) + 1 : 1 + len(NODES)] - energies[:1]
    places = np.minimum(np.searchsorted(points, rows), whole)  # a row that was not passed has what the last one has
    error = estimate(errors) + 1e-15 * float(np.max(np.abs(work)))
    if whole < len(lengths) or not math.isfinite(error):
        error = math.inf
    deviations = gains - work if whole else np.zeros(1)
    return Balance(deviations[places], work[places], error), np.abs(errors)


def estimate(errors: Series) -> float:
    """By how much an integral may err on its way: what the errors of its parts come to, and what they may come to by chance."""
    return float(np.max(np.abs(np.cumsum(errors)), initial=0.0)) + 3.0 * math.sqrt(float(errors @ errors))


def _look(bench: Bench, times: Series, states: Matrix) -> tuple[Series, Series]:
    """Energy and power at the rows that have them."""
    columns = [bench.group("jacobi")[0], bench.group("power")[0]]
    found = [np.zeros((0, 2))]
    for first in range(0, min(len(times), len(states)), _AT_ONCE):
        part = states[first : first + _AT_ONCE]
        try:
            found.append(bench.quantities(times[first : first + len(part)].tolist(), part)[:, columns])
        except ModelError:
            break
    energies, powers = np.concatenate(found).T
    return energies, powers
