"""A step of an explicit Runge-Kutta method (``templates/c/methods/explicit.c.jinja`` in Python)."""

from __future__ import annotations

from math import sqrt

from nhc.simulate.methods.step import Step, Vector, combine
from nhc.simulate.methods.tableau import Explicit


def slopes(s: Step, method: Explicit, first: int, last: int) -> None:
    """Append the slopes ``first`` to ``last``; the last point of a step is its end."""
    for j in range(first, last + 1):
        row = method.rows[j - 1]
        point = [y + s.h * combine(row, s.k, i) for i, y in enumerate(s.y)]
        if j == method.stages:
            s.reached = point
        s.k.append(s.rhs(s.t + method.nodes[j] * s.h, point))


def attempt(s: Step, method: Explicit) -> float:
    """The square of the error relative to what is allowed; 0 for fixed steps."""
    s.k, s.shape = [s.slope], None
    slopes(s, method, 1, method.stages)
    s.arrived = s.k[method.stages]
    return again(s, method) if method.errors and s.tolerance > 0.0 else 0.0


def again(s: Step, method: Explicit) -> float:
    """The square of the error of a step that is there, relative to what is allowed."""
    allowed = s.allowed(s.reached)
    norms = [
        sum((1.0 / a * combine(row, s.k, i)) ** 2 for i, a in enumerate(allowed)) / len(allowed)
        for row in method.errors
    ]
    if len(norms) == 1:
        return s.h * s.h * norms[0]
    mixed = norms[0] + 0.01 * norms[1]  # Hairer, Nørsett and Wanner (1993), eq. (II.10.17)
    return (s.h * norms[0]) ** 2 / mixed if mixed > 0.0 else mixed  # a NaN stays one


def find_errors(s: Step, method: Explicit) -> Vector:
    """Of each entry, for a step that is there."""
    columns = [[combine(row, s.k, i) for row in method.errors] for i in range(len(s.y))]
    if len(method.errors) == 1:
        return [s.h * error for (error,) in columns]
    mixed = [sqrt(error * error + 0.01 * other * other) for error, other in columns]
    return [s.h * error * (error / m) if m > 0.0 else 0.0 for (error, _), m in zip(columns, mixed, strict=True)]


def shape(s: Step, method: Explicit) -> list[Vector]:
    """The interpolant's terms."""
    found = s.cubic()
    slopes(s, method, method.stages + 1, len(method.rows))
    return found + [[s.h * combine(row, s.k, i) for i in range(len(s.y))] for row in method.dense]
