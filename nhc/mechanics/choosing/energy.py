"""The kinetic energy in the free velocities at a place, and how well it is conditioned there."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular, solve_double, symmetric_eigenvalues
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.mechanics.frame import Frame, coordinate_form
from nhc.mechanics.regular.trials import ordinary_points
from nhc.mechanics.system import Form, System

Place = dict[Node, float]
Rows = list[list[float]]
SOUND_ENERGY = 1e-2
"""The least eigenvalue of the matrix of the energy, scaled to a diagonal of ones, from which it is no hindrance."""


def evaluate_rows(system: System, forms: Sequence[Form], place: Place) -> Rows:
    """The directions of forms at a place."""
    flat = [float(x) for x in evaluate(system.graph, [a for form in forms for a in form.direction], place)]
    return [flat[k * system.n : (k + 1) * system.n] for k in range(len(forms))]


def least_energy(system: System, frame: Frame) -> float:
    """How well the energy of the free velocities is conditioned, at the worst of the ordinary states."""
    return min((least_eigenvalue(free_energy(system, frame, p)) for p in ordinary_points(system)), default=1.0)


def least_eigenvalue(gram: Rows) -> float:
    """Of the matrix scaled to a diagonal of ones; 0 where that is not to be had."""
    if not gram or any(row[k] <= 0.0 for k, row in enumerate(gram)):
        return 0.0
    scaled = [[x / sqrt(gram[i][i] * gram[k][k]) for k, x in enumerate(row)] for i, row in enumerate(gram)]
    return max(min(symmetric_eigenvalues(scaled), default=1.0), 0.0)


def free_energy(system: System, frame: Frame | None, place: Place) -> Rows:
    """The matrix of the kinetic energy in the free velocities of a frame, or in all; empty where it has no value."""
    n = system.n
    forms = frame.forms if frame is not None else [coordinate_form(system, i) for i in range(n)]
    try:
        rows = evaluate_rows(system, forms, place)
        values = [float(x) for x in evaluate(system.graph, _mass(system), place)]
        first = system.l if frame else 0
        vectors = [solve_double(rows, [float(i == k) for i in range(n)]) for k in range(first, n)]
    except (Singular, ArithmeticError, ValueError):
        return []
    mass = [values[k * n : (k + 1) * n] for k in range(n)]
    moved = [[sum(a * x for a, x in zip(row, e, strict=True)) for row in mass] for e in vectors]
    return [[sum(a * b for a, b in zip(e, m, strict=True)) for m in moved] for e in vectors]


def _mass(system: System) -> list[Node]:
    """The entries of T's matrix in all velocities, row by row; the graph keeps them for the next place."""
    known: dict[Node, list[Node]] = system.graph.memory.setdefault("masses", {})
    if system.T not in known:
        momenta = gradient(system.graph, system.T, system.v)
        known[system.T] = [x for p in momenta for x in gradient(system.graph, p, system.v)]
    return known[system.T]
