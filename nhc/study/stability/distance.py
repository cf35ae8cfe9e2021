"""How near a scene comes to where something it rests on is singular.

Every measure lies in [0, 1], 0 being singular: determinants relative to what their rows allow (Hadamard), smallest singular
values of matrices whose rows have length 1, smallest eigenvalues of mass matrices scaled to a diagonal of ones.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from nhc.mechanics.choosing.choose import dependent_of
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.regular.regularity import relative_determinant
from nhc.mechanics.regular.trials import velocity_units
from nhc.records import record
from nhc.simulate.run import list_times
from nhc.study.linearization.field import scaled_least
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench

NEAR = 0.03
"""Below this a choice is called weak, as in :mod:`nhc.mechanics.regular.regularity`."""
_LOOKED, _DIPS = 0.3, 3  # what is looked at between rows: distances below, and so many of the lowest
_PARTS, _ROUNDS, _GAINED = 21, 14, 0.99
SINGULAR_THERE = 1e-13
"""A distance of rounding."""


@record
class Distance:
    """``least`` along the scene, reached at ``t``; ``series`` over the scene's rows; ``used``: the run rests on it."""

    what: str
    kind: str
    least: float
    t: float
    series: tuple[float, ...]
    used: bool = True


def judge_distance(distance: Distance, sound: bool) -> str:
    """How near it is, in words; a divisor may be small against its scale only, where its coframe is ``sound``."""
    if distance.least >= NEAR or (distance.kind == "guard" and sound):
        return ""
    return ", singular" if distance.least < SINGULAR_THERE else ", weak"


Measure = Callable[[Matrix], Sequence[float]]
"""A distance at each row of a table of the bench's columns."""

_Grid = tuple[Sequence[float], Sequence[Sequence[float]], Sequence[float]]
"""Times, the states there, and a distance at each."""


def distances(bench: Bench) -> tuple[Distance, ...]:
    """Of the constraints, of the dependent choice, of the formulation's own frame, of the coordinates.

    Raises:
        ArithmeticError: the scene fails.
    """
    found, table = list[Distance](), bench.table
    n, lower = bench.equations.system.n, bench.equations.system.l

    def add(what: str, kind: str, measure: Measure, *, used: bool = True) -> None:
        series = tuple(float(x) for x in measure(table))
        least, t = _least(bench, measure, series)
        found.append(Distance(what, kind, least, t, series, used))

    if lower:
        units = np.array(velocity_units(bench.equations.system))

        def rows(table: Matrix) -> Matrix:
            return np.asarray(table[:, bench.group("row")].reshape(-1, lower, n) * units)

        add("rank of the constraints", "constraints", lambda table: [smallest_singular(a) for a in rows(table)])
        choice = _choice(bench)
        if choice:
            names = ", ".join(f"{bench.equations.system.q_names[i]}'" for i in choice)
            used = bench.formulation.dependent is not None
            add(
                f"solving for {names}{'' if used else ' (not used)'}",
                "dependent",
                lambda table: [relative_determinant(a.tolist(), choice) for a in rows(table)],
                used=used,
            )
        free = bench.group("free")
        if free:

            def frames(table: Matrix) -> Matrix:
                return np.concatenate([rows(table), table[:, free].reshape(-1, n - lower, n) * units], axis=1)

            add(
                f"coframe of {bench.formulation.name}",
                "frame",
                lambda table: [smallest_singular(a) for a in frames(table)],
            )
    for number, (value, scale) in enumerate(zip(bench.group("guard"), bench.group("scale"), strict=True), 1):
        if np.any(table[:, scale]):
            add(f"divisor {number} of the emitted code", "guard", partial(_ratio, value, scale))
    mass = bench.group("mass")
    if mass:
        add(
            "mass matrix of the coordinates",
            "mass",
            lambda table: [scaled_least(m) for m in table[:, list(mass)].reshape(-1, n, n)],
        )
    return tuple(found)


def _ratio(value: int, scale: int, table: Matrix) -> Sequence[float]:
    ratios = np.abs(table[:, value]) / np.maximum(np.abs(table[:, scale]), 1e-300)
    return [float(x) for x in ratios]


def _choice(bench: Bench) -> Sequence[int]:
    """The velocities that the formulation solves the constraints for; where it solves for none, those that one would."""
    used = bench.formulation.dependent
    try:
        return used.dependent if used is not None else dependent_of(bench.equations.system).dependent
    except NotApplicable:
        return ()


def _least(bench: Bench, measure: Measure, series: Sequence[float]) -> tuple[float, float]:
    """The least of a measure along the scene, and its time: between rows and between steps, too, beside the lowest of them."""
    place = min(range(len(series)), key=series.__getitem__)
    best = series[place], bench.times[place]
    grids: list[_Grid] = [(bench.times, bench.reference.tolist(), series)]
    try:
        times, states = bench.stations
        times = times[: len(states)]
        grids.append((times, states, measure(bench.quantities(times, states))))
    except ArithmeticError:  # it has no value at one of them
        pass
    for times, states, values in grids:
        dips = [k for k, x in enumerate(values) if x <= _LOOKED and x <= min(values[max(k - 1, 0) : k + 2])]
        for k in sorted(dips, key=values.__getitem__)[:_DIPS]:
            best = min(best, _refine(bench, measure, times, states, k))
    return best


def _refine(
    bench: Bench, measure: Measure, times: Sequence[float], states: Sequence[Sequence[float]], k: int
) -> tuple[float, float]:
    """The least of a measure beside the k-th time, and where it is."""
    best = math.inf, times[k]
    for _ in range(_ROUNDS):
        low, high = max(k - 1, 0), min(k + 1, len(times) - 1)
        y, times = states[low], list_times(times[low], times[high], _PARTS)
        try:
            states = bench.follow(times, y).states
            if len(states) < len(times):  # so near to one another that a run does not get from one to the next
                break
            values = measure(bench.quantities(times, states))
        except ArithmeticError:  # it is singular there
            break
        k = min(range(len(values)), key=values.__getitem__)
        before, best = best[0], min(best, (float(values[k]), times[k]))
        if not best[0] < _GAINED * before:
            break
    return best


def smallest_singular(matrix: Matrix) -> float:
    """Of the matrix with its rows scaled to length 1."""
    lengths = np.linalg.norm(matrix, axis=1, keepdims=True)
    return float(np.linalg.svd(matrix / np.maximum(lengths, 1e-300), compute_uv=False)[-1])
