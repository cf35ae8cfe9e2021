"""Coordinates without inertia at a start."""

from __future__ import annotations

from nhc.algebra.evaluate import evaluate
from nhc.mechanics.associate import Equations
from nhc.mechanics.frame import Frame, kept_forms
from nhc.mechanics.starts.scenes import Start, kept_velocities


def is_massless(equations: Equations, frame: Frame | None, start: Start) -> bool:
    """Whether the mass matrix is singular at the start with a diagonal entry that is zero: of a coordinate without inertia.

    Equations whose parts are solved by themselves may not feel it, for a mass cancels in ``m x'' = -m g``.
    """
    if equations.tree is not None:
        return False
    system, w = equations.system, equations.motion.w
    rates = kept_velocities(system, kept_forms(system, frame), start)
    values = {**start.values(system), **dict(zip(w, rates, strict=True))}
    try:
        diagonal = evaluate(system.graph, [equations.mass[k][k] for k in range(len(w))], values)
    except (ArithmeticError, ValueError, KeyError):
        return False
    return not all(float(x) for x in diagonal)
