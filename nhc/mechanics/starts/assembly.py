"""Positions that close loops: the coordinates nearest to given ones at which the equations under ``holonomic:`` hold.

Damped Gauss-Newton steps of least length (Levenberg 1944) in units that balance the slopes, halved until they bring the equations
nearer, so that a linkage is assembled on the branch that it was given near to.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Mapping, Sequence

from nhc.algebra.dense import Singular, solve_double
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.mechanics.regular.trials import balanced_units
from nhc.mechanics.system import System
from nhc.records import record

_STEPS = 200
_HALVINGS = 40
_DAMPING = 1e-3  # at most, beside slopes of 1; it goes with the square of what is left of the equations
_ROUNDING = 1e-15
_GAIN = 1e-4  # of what a step promises (Armijo 1966)


@record
class _Here:
    """What is left of the equations, and their slopes by the free coordinates."""

    left: list[float]
    slopes: list[list[float]]

    @property
    def size(self) -> float:
        return math.hypot(*self.left)


def assemble(system: System, place: Mapping[Node, float], free: Sequence[int]) -> dict[Node, float]:
    """``place`` with the coordinates of the indices ``free`` moved to where the holonomic constraints hold, as far as they can.

    What the equations leave open moves least.  Where moving ``free`` does not help any more the place that comes nearest is
    returned: who called looks whether the equations hold there.
    """
    loops, best = _Loops(system, free), dict(place)
    here = loops.look(best)
    if here is not None:
        loops.balance(here)
        here = loops.look(best)
    for _ in range(_STEPS):
        if here is None or not here.size > 0.0:
            break
        there = loops.move(best, here)
        if there is None:
            break
        best, here = there
    return best


class _Loops:
    """The equations that the free coordinates move, each in the unit of its slopes where the search begins."""

    def __init__(self, system: System, free: Sequence[int]) -> None:
        g, units = system.graph, balanced_units(system)
        self.graph, self.symbols, self.units = g, [system.q[i] for i in free], [units[i] for i in free]
        self.nodes = list[Node]()
        self.weights = list[float]()
        for form in system.constraints:
            slopes = [form.coefficients[i] for i in free]
            if form.equation is not None and any(slope != g.zero for slope in slopes):
                self.nodes += [form.equation, *slopes]
                self.weights.append(1.0)

    def look(self, place: Mapping[Node, float]) -> _Here | None:
        """None outside the domain of the equations."""
        try:
            values = [float(x) for x in evaluate(self.graph, self.nodes, place)]
        except (ArithmeticError, ValueError):
            return None
        if not all(map(math.isfinite, values)):
            return None
        width = len(self.symbols) + 1
        rows = [values[k * width : (k + 1) * width] for k in range(len(self.weights))]
        return _Here(
            [row[0] * w for row, w in zip(rows, self.weights, strict=True)],
            [
                [x * u * w for x, u in zip(row[1:], self.units, strict=True)]
                for row, w in zip(rows, self.weights, strict=True)
            ],
        )

    def balance(self, here: _Here) -> None:
        self.weights = [1.0 / (math.hypot(*row) or 1.0) for row in here.slopes]

    def move(self, place: Mapping[Node, float], here: _Here) -> tuple[dict[Node, float], _Here] | None:
        """The next place and what is left there; None where no step helps."""
        step = _step(here)
        for halving in range(_HALVINGS if step else 0):
            part = 0.5**halving
            moved = dict(place)
            for q, s, u in zip(self.symbols, step, self.units, strict=True):
                moved[q] += part * s * u
            there = self.look(moved)
            if there is not None and there.size <= (1.0 - _GAIN * part) * here.size:
                return moved, there
        return None


def _step(here: _Here) -> list[float]:
    """J^T (J J^T + mu 1)^-1 (-r); empty where that has no solution."""
    damping = min(_DAMPING, here.size**2) + _ROUNDING
    gram = [[sum(map(operator.mul, a, b)) for b in here.slopes] for a in here.slopes]
    for k, row in enumerate(gram):
        row[k] += damping
    try:
        weights = solve_double(gram, [-x for x in here.left])
    except Singular:
        return []
    return [sum(map(operator.mul, weights, column)) for column in zip(*here.slopes, strict=True)]
