"""Positions that close loops: coordinates near to given ones at which the equations under ``holonomic:`` hold.

Damped Gauss-Newton steps of least length (Levenberg 1944) in units that balance the slopes, halved until the equations go to zero
along a line, so that a linkage is assembled on the branch that it was given near to.  Where a dead point lies on the way, the same
from places all around, and steps that bring the equations nearer at all; of the places that are found the nearest is taken.
What the equations leave open is then moved along them to the nearest place, in the metric of the kinetic energy.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Mapping, Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular, pivot_signs, solve_double
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
_OFF = 0.25  # of what a step changes: how far off what its slopes promise it may be where they are followed closely
_NEAR = 1e-6  # of the equations, where all steps are close
_CLOSED = 1e-9  # what may be left of them
_STRAIGHT = 1e-9  # of the way back: what of it may lie along the equations
_MOST_WAYS = 12  # coordinates along which places beside the given one are tried

_Matrix = list[list[float]]


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

    What the equations leave open moves least, in the metric of T.  Where moving ``free`` does not help any more the place that
    comes nearest is returned: who called looks whether the equations hold there.
    """
    loops = _Loops(system, free)
    here = loops.look(place) if loops.weights else None  # else no equation moves any of them
    if here is None:
        return dict(place)
    loops.balance(here)
    closed = _CLOSED * (1.0 + here.size)
    led, left = loops.solve(place, closely=True)
    if left <= closed:
        return loops.turn_back(place, loops.draw_near(place, led, closed), closed)
    passed, rest = loops.solve(place, closely=False)  # a dead point lies on the way
    if not rest <= closed:
        return loops.turn_back(place, *((passed, rest) if rest < left else (led, left)))
    others = [loops.solve(beside, closely=True) for beside in loops.list_beside(place)]
    found = [loops.turn_back(place, at, closed) for at in (passed, *(at for at, left in others if left <= closed))]
    nearest = min(found, key=lambda at: loops.distance(place, at))
    return loops.turn_back(place, loops.draw_near(place, nearest, closed), closed)


class _Loops:
    """The equations that the free coordinates move, each in the unit of its slopes where the search begins."""

    def __init__(self, system: System, free: Sequence[int]) -> None:
        g, units = system.graph, balanced_units(system)
        self.system, self.graph, self.symbols, self.units = (
            system,
            g,
            [system.q[i] for i in free],
            [units[i] for i in free],
        )
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

    def solve(self, place: Mapping[Node, float], closely: bool) -> tuple[dict[Node, float], float]:
        """Where steps from a place lead, and what is left of the equations there."""
        best, here = dict(place), self.look(place)
        assert here is not None
        for _ in range(_STEPS):
            there = self._move(best, here, closely) if here.size > 0.0 else None
            if there is None:
                break
            best, here = there
        return best, here.size

    def list_beside(self, place: Mapping[Node, float]) -> list[dict[Node, float]]:
        """Places all around, where the equations have values."""
        count = len(self.symbols)
        ways = [[float(i == k) for i in range(count)] for k in range(min(count, _MOST_WAYS))]
        ways.append([1.0] * count)
        ways.append([(-1.0) ** i for i in range(count)])
        found = [self._along(place, way, part) for way in ways for part in (0.5, -0.5, 1.5, -1.5)]
        return [beside for beside in found if self.look(beside) is not None]

    def distance(self, one: Mapping[Node, float], other: Mapping[Node, float]) -> float:
        """How far the free coordinates have moved."""
        return math.hypot(*((one[q] - other[q]) / u for q, u in zip(self.symbols, self.units, strict=True)))

    def turn_back(self, place: Mapping[Node, float], found: dict[Node, float], left: float) -> dict[Node, float]:
        """``found`` without whole turns that steps have made on the way, where no more is left of the equations without them."""
        for q in self.symbols:
            turns = round((found[q] - place[q]) / math.tau)
            less = {**found, q: found[q] - turns * math.tau}
            there = self.look(less) if turns else None
            if there is not None and there.size <= left + _CLOSED:
                found = less
        return found

    def draw_near(self, place: Mapping[Node, float], found: dict[Node, float], closed: float) -> dict[Node, float]:
        """The nearest of the places around ``found``: from it the way back, along the equations (J. B. Rosen 1961)."""
        metric = self._metric(place)
        if len(self.weights) == len(self.symbols) or metric is None:
            return found
        for _ in range(_STEPS):
            back = [(place[q] - found[q]) / u for q, u in zip(self.symbols, self.units, strict=True)]
            along = _along_equations(self.look(found), back, metric)
            if not along or _length(metric, along) <= _STRAIGHT * _length(metric, back):
                break
            moved = self._draw(place, found, along, closed, metric)
            if moved is None:
                break
            found = moved
        return found

    def _draw(
        self, place: Mapping[Node, float], found: dict[Node, float], along: list[float], closed: float, metric: _Matrix
    ) -> dict[Node, float] | None:
        """The next place on the way; None where no step leads nearer."""

        def distance(at: Mapping[Node, float]) -> float:
            return _length(metric, [(place[q] - at[q]) / u for q, u in zip(self.symbols, self.units, strict=True)])

        for halving in range(_HALVINGS):
            beside = self._along(found, along, 0.5**halving)
            if self.look(beside) is None:
                continue
            moved, left = self.solve(beside, closely=True)
            if left <= closed and distance(moved) < distance(found):
                return moved
        return None

    def _metric(self, place: Mapping[Node, float]) -> _Matrix | None:
        """T's matrix for the free coordinates at a place, in their units; None where it has none that is positive."""
        g, system = self.graph, self.system
        velocities = [system.v[system.q.index(q)] for q in self.symbols]
        still = {**place, **dict.fromkeys(system.v, 0.0)}
        rows = [gradient(g, slope, velocities) for slope in gradient(g, system.T, velocities)]
        try:
            values = [[float(x) for x in evaluate(g, row, still)] for row in rows]
        except (ArithmeticError, ValueError):
            return None
        made = [
            [x * u * w for x, w in zip(row, self.units, strict=True)] for row, u in zip(values, self.units, strict=True)
        ]
        return made if all(sign > 0 for sign in pivot_signs(made)) else None

    def _move(self, place: Mapping[Node, float], here: _Here, closely: bool) -> tuple[dict[Node, float], _Here] | None:
        """The next place and what is left there; None where no step helps.

        A step that follows the equations ``closely`` leaves of them what their slopes promise: then their values go straight to
        zero (Davidenko 1953), and no step near a dead point leads to another turn or branch.
        """
        step = _step(here)
        looks = (1.0, 0.5, 0.25) if closely and here.size >= _NEAR else ()  # of a step: its end may be close by chance
        for halving in range(_HALVINGS if step else 0):
            part = 0.5**halving
            moved = self._along(place, step, part)
            there = self.look(moved)
            if there is None or not there.size <= (1.0 - _GAIN * part) * here.size:
                continue
            if all(_is_close(here, self.look(self._along(place, step, part * x)), part * x) for x in looks):
                return moved, there
        return None

    def _along(self, place: Mapping[Node, float], step: Sequence[float], part: float) -> dict[Node, float]:
        moved = {q: place[q] + part * s * u for q, s, u in zip(self.symbols, step, self.units, strict=True)}
        return {**place, **moved}


def _length(metric: _Matrix, vector: Sequence[float]) -> float:
    return math.sqrt(
        max(0.0, sum(x * sum(map(operator.mul, row, vector)) for x, row in zip(vector, metric, strict=True)))
    )


def _along_equations(here: _Here | None, back: Sequence[float], metric: _Matrix) -> list[float]:
    """back - G^-1 J^T (J G^-1 J^T)^-1 J back: its part along the equations; empty where that has no solution."""
    try:
        ways = [solve_double(metric, list(row)) for row in here.slopes] if here is not None else []
        gram = [[sum(map(operator.mul, a, b)) for b in ways] for a in here.slopes] if here is not None else []
        across = [sum(map(operator.mul, row, back)) for row in here.slopes] if here is not None else []
        weights = solve_double(gram, across) if gram else []
    except Singular:
        return []
    return [
        x - sum(map(operator.mul, weights, column)) for x, column in zip(back, zip(*ways, strict=True), strict=True)
    ]


def _is_close(here: _Here, there: _Here | None, part: float) -> bool:
    """Whether a part of a step leaves of the equations what their slopes promise."""
    if there is None:
        return False
    off = math.hypot(*(a - (1.0 - part) * b for a, b in zip(there.left, here.left, strict=True)))
    return off <= _OFF * part * here.size


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
