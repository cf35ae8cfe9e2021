"""How near a scene comes to where something it rests on is singular.

Every measure lies in [0, 1], 0 being singular: determinants relative to what their rows allow (Hadamard), smallest singular
values of matrices whose rows have length 1, smallest eigenvalues of mass matrices scaled to a diagonal of ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from nhc.mechanics.choosing.choose import dependent_of
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.regular.regularity import relative_determinant
from nhc.mechanics.regular.trials import velocity_units
from nhc.records import record
from nhc.study.linearization.field import scaled_least
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench

NEAR = 0.03
"""Below this a choice is called weak, as in :mod:`nhc.mechanics.regular.regularity`."""


@record
class Distance:
    """``least`` along the scene, reached at ``t``; ``series`` over the scene's rows; ``used``: the run rests on it."""

    what: str
    kind: str
    least: float
    t: float
    series: tuple[float, ...]
    used: bool = True


def distances(bench: Bench) -> tuple[Distance, ...]:
    """Of the constraints, of the dependent choice, of the formulation's own frame, of the coordinates.

    Raises:
        ArithmeticError: the scene fails.
    """
    found, table = [], bench.table
    n, lower = bench.equations.system.n, bench.equations.system.l
    if lower:
        units = np.array(velocity_units(bench.equations.system))
        rows = table[:, bench.group("row")].reshape(-1, lower, n) * units
        found.append(_of(bench, "rank of the constraints", "constraints", [smallest_singular(a) for a in rows]))
        found += _dependent(bench, rows)
        free = bench.group("free")
        if free:
            frames = np.concatenate([rows, table[:, free].reshape(-1, n - lower, n) * units], axis=1)
            what = f"coframe of {bench.formulation.name}"
            found.append(_of(bench, what, "frame", [smallest_singular(a) for a in frames]))
    guards = zip(bench.group("guard"), bench.group("scale"), strict=True)
    for number, (value, scale) in enumerate(guards, 1):
        if not np.any(table[:, scale]):
            continue
        ratio = np.abs(table[:, value]) / np.maximum(np.abs(table[:, scale]), 1e-300)
        found.append(_of(bench, f"divisor {number} of the emitted code", "guard", [float(x) for x in ratio]))
    mass = bench.group("mass")
    if mass:
        found.append(
            _of(bench, "mass matrix of the coordinates", "mass", [scaled_least(m) for m in _square(table, mass, n)])
        )
    return tuple(found)


def _square(table: Matrix, places: Sequence[int], n: int) -> Matrix:
    return table[:, list(places)].reshape(-1, n, n)


def _dependent(bench: Bench, rows: Matrix) -> list[Distance]:
    system = bench.equations.system
    try:
        choice = dependent_of(system).dependent
    except NotApplicable:
        return []
    names = ", ".join(f"{system.q_names[i]}'" for i in choice)
    used = bench.formulation.dependent is not None
    series = [relative_determinant(a.tolist(), choice) for a in rows]
    return [replace(_of(bench, f"solving for {names}{'' if used else ' (not used)'}", "dependent", series), used=used)]


def smallest_singular(matrix: Matrix) -> float:
    """Of the matrix with its rows scaled to length 1."""
    lengths = np.linalg.norm(matrix, axis=1, keepdims=True)
    return float(np.linalg.svd(matrix / np.maximum(lengths, 1e-300), compute_uv=False)[-1])


def _of(bench: Bench, what: str, kind: str, series: Sequence[float]) -> Distance:
    place = int(np.argmin(series))
    return Distance(what, kind, float(series[place]), bench.times[place], tuple(float(x) for x in series))
