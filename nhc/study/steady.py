"""Steady motions as numbers: the field of a model at a point, and the nearest steady motion to a guess."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import Node
from nhc.mechanics.flow import Flow
from nhc.mechanics.frame import Frame, form_value
from nhc.mechanics.linearize import Leaf
from nhc.mechanics.regularity import relative_determinant, sampled_rows
from nhc.records import record
from nhc.study.tape import Tapes

Vector = NDArray[np.float64]
Matrix = NDArray[np.float64]

RANK = 1e-9
"""Singular values below this part of the largest one count as zero."""
_STEPS, _HALVINGS, _LEAST = 100, 40, 0.05
_LEAST_FRAME = 0.01  # of the coframe's relative determinant, per constraint


class NotSteady(ArithmeticError):
    """No steady motion was found; ``residual`` is the best that was reached, ``place`` the state where it was.

    ``advice`` says what to do about it.
    """

    def __init__(self, message: str, residual: float, place: Sequence[float] | Vector = (), advice: str = "") -> None:
        super().__init__(message)
        self.residual, self.place = residual, tuple(float(x) for x in place)
        self.advice = advice or "let `--about` name another state, or give the parameters other values with `--set`"
        if math.isfinite(residual):
            self.advice = "start nearer to a steady motion, or fix more of it with `--hold`"


class SingularFrame(NotSteady):
    """The coframe is singular at the steady motion, which its equations can neither find nor judge, or on the way to it."""


@record
class Hold:
    """A quantity that a steady motion shall have: ``node`` over the state equals ``value``."""

    name: str
    node: Node
    value: float


@dataclass(frozen=True)
class SteadyModel:
    """A field with its parameters' values; ``rest`` are the entries of the state that are not cyclic.

    ``symmetries`` are groups of turns, matrices over the state, that a steady motion may go along: it stands still in axes
    that turn with it, by ``turning``.
    """

    flow: Flow
    frame: Frame | None
    leaf: Leaf
    cyclic: tuple[int, ...]
    p: tuple[float, ...]
    tapes: Tapes
    symmetries: tuple[tuple[Matrix, ...], ...] = ()
    turning: Matrix | None = None

    @cached_property
    def rest(self) -> tuple[int, ...]:
        return tuple(i for i in range(len(self.flow.y)) if i not in self.cyclic)

    def with_parameter(self, index: int, value: float) -> SteadyModel:
        return replace(self, p=(*self.p[:index], value, *self.p[index + 1 :]))

    def values(self, y: Sequence[float]) -> dict[Node, float]:
        """Each symbol of the state, the parameters and the time with its value."""
        system = self.flow.system
        return {
            system.t: 0.0,  # the field does not depend on it
            **dict(zip(system.p, self.p, strict=True)),
            **{node: float(x) for node, x in zip(self.flow.y, y, strict=True)},
        }

    def field(self, y: Sequence[float]) -> tuple[Vector, Matrix]:
        """f(y) of shape (NY,) and df/dy of shape (NY, NY) on turning axes, exact but for rounding.

        Raises:
            ArithmeticError: the model is singular at y.
        """
        flow, values = self.flow, self.values(y)
        size, unknowns, kept = len(flow.y), len(flow.unknowns), flow.kept
        heads = [*flow.velocities, *flow.right, *(x for row in flow.matrix for x in row)]
        numbers = self.tapes.numbers(heads, values)
        n = len(flow.velocities)
        matrix = numbers[n + unknowns :].reshape(unknowns, unknowns)
        solution = _solve(matrix, numbers[n : n + unknowns])
        values.update(zip(flow.unknowns, (float(x) for x in solution), strict=True))
        tails = [x for row in (*flow.velocity_slopes, *flow.residual_slopes) for x in row]
        slopes = self.tapes.numbers(tails, values).reshape(n + unknowns, size)
        rates = _solve(matrix, slopes[n:])[:kept]
        field, jacobian = np.concatenate([numbers[:n], solution[:kept]]), np.vstack([slopes[:n], rates])
        if self.turning is not None:
            field, jacobian = field - self.turning @ np.asarray(y), jacobian - self.turning
        return field, jacobian

    def mass(self, y: Sequence[float]) -> Matrix:
        """The matrix of the kept velocities' rates at y (with multipliers: the bordered one)."""
        size = len(self.flow.unknowns)
        flat = [x for row in self.flow.matrix for x in row]
        return self.tapes.numbers(flat, self.values(y)).reshape(size, size)

    def value(self, y: Sequence[float], node: Node) -> float:
        """A function of the state."""
        return float(self.tapes.numbers([node], self.values(y))[0])

    @cached_property
    def _conditions(self) -> tuple[tuple[Node, ...], tuple[tuple[Node, ...], ...]]:
        """Constraints that the state itself has to meet: positions, and velocities where all of them are kept."""
        flow, system = self.flow, self.flow.system
        nodes = [form.equation for form in system.constraints if form.equation is not None]
        if self.frame is None:
            nodes += [form_value(flow.graph, form, system.v) for form in system.constraints]
        return tuple(nodes), tuple(tuple(gradient(flow.graph, node, flow.y)) for node in nodes)

    def conditions(self, y: Sequence[float]) -> tuple[Vector, Matrix]:
        """Residuals of shape (K,) of the constraints on the state, and their slopes (K, NY)."""
        nodes, slopes = self._conditions
        values = self.values(y)
        flat = self.tapes.numbers([x for row in slopes for x in row], values)
        return self.tapes.numbers(nodes, values), flat.reshape(len(nodes), len(self.flow.y))

    def normals(self, y: Sequence[float]) -> Matrix | None:
        """Orthonormal rows (over q) across the leaf through y; None where the brackets do not span the leaf there."""
        n, leaf = self.flow.system.n, self.leaf
        if leaf.dimension == n:
            return np.zeros((0, n))
        rows = leaf.normals or leaf.fields
        try:
            flat = self.tapes.numbers([x for row in rows for x in row], self.values(y)).reshape(len(rows), n)
        except ArithmeticError:
            return None
        lengths = np.linalg.norm(flat, axis=1, keepdims=True)
        _, sizes, right = np.linalg.svd(flat / np.maximum(lengths, 1e-300))
        found = int(np.sum(sizes > 1e-8 * sizes[0]))
        if leaf.normals:
            return right[:found] if found == n - leaf.dimension else None
        return right[found:] if found == leaf.dimension else None


def _solve(matrix: Matrix, right: Matrix) -> Matrix:
    if not matrix.size:
        return right
    try:
        return np.asarray(np.linalg.solve(matrix, right))
    except np.linalg.LinAlgError:
        raise ArithmeticError("the accelerations are not determined") from None


@dataclass(frozen=True)
class Steady:
    """A steady motion: the state, the largest rate that is left of what should stand still, the steps taken.

    ``turning`` is the turn that goes with it, made of ``turns``; both are matrices over the state.
    """

    y: tuple[float, ...]
    residual: float
    steps: int
    equilibrium: bool
    turning: Matrix | None = field(default=None, compare=False)
    turns: tuple[Matrix, ...] = field(default=(), compare=False)


def find_steady(model: SteadyModel, guess: Sequence[float], holds: Sequence[Hold] = ()) -> Steady:
    """The steady motion near the guess: damped Gauss-Newton (Levenberg) steps of least norm.

    Without ``holds`` the nearest member of the family of steady motions is found; the steps keep to the leaf of the guess (to first
    order in each step), so that what a hidden holonomic constraint holds stays what it was, unless a hold or a holonomic constraint
    sets it.

    Raises:
        NotSteady: the iteration ends elsewhere, or the model is singular on the way, or at the motion itself.
    """
    y = np.array(guess, dtype=float)
    found: list[tuple[float, Steady]] = []
    failed: list[NotSteady] = []
    for turns in model.symmetries or ((),):
        try:
            made = _iterate(model, turns, np.concatenate([y, _first_turn(model, turns, y)]), holds)
        except ArithmeticError as error:
            # only the guess itself can have no equations: steps keep to where there are some
            told = NotSteady(f"the model is singular on the way: {error}", float("inf"), y)
            failed.append(error if isinstance(error, NotSteady) else told)
            continue
        found.append((round(float(np.linalg.norm(np.array(made.y) - y)), 6), made))
    if not found:
        check_frame(model, failed[0].place, "where the search for a steady motion ends")
        raise failed[0] from None
    best = min(found, key=lambda one: one[0])[1]  # of equally near ones that with fewer turns
    check_frame(model, best.y, "at the steady motion")
    return best


def check_frame(model: SteadyModel, y: Sequence[float], where: str) -> None:
    """Nothing where the coframe is sound at the state y.

    Raises:
        SingularFrame: it is singular there, or so nearly that its equations are worth nothing.
    """
    if model.frame is None or not y:
        return
    rows = sampled_rows(model.flow.system, model.frame.forms, [model.values(y)])
    power = len(model.frame.forms) / max(model.flow.system.l, 1)
    sound = min((relative_determinant(row, range(len(row))) ** power for row in rows), default=0.0)
    if sound < _LEAST_FRAME:
        raise SingularFrame(f"the coframe is singular {where} (conditioning {sound:.2g})", float("inf"))


def _first_turn(model: SteadyModel, turns: Sequence[Matrix], y: Vector) -> Vector:
    """How fast the guess turns: what leaves the least of its rates."""
    if not turns:
        return np.zeros(0)
    rest = list(model.rest)
    along = np.array([turn @ y for turn in turns])[:, rest]
    return np.asarray(np.linalg.lstsq(along.T, model.field([float(x) for x in y])[0][rest], rcond=None)[0])


def _iterate(model: SteadyModel, turns: Sequence[Matrix], y: Vector, holds: Sequence[Hold]) -> Steady:
    """``y`` is the state, with the speed of each turn after it."""
    value, slopes, scale = _equations(model, turns, y, holds)
    before, damping = np.zeros_like(y), 1.0
    for step in range(_STEPS + 1):
        size = float(np.max(np.abs(value), initial=0.0))
        move = _step(value, slopes, _bound(model, y, slopes[len(model.rest) :]), damping)
        if size == 0.0 or float(np.linalg.norm(move)) <= 1e-14 * (1.0 + float(np.linalg.norm(y))):
            return _accept(model, turns, y, size, scale, step)
        factor = 2.0 if _halves(before, move) else 1.0
        for _ in range(_HALVINGS):
            trial = y + factor * move
            try:
                next_value, next_slopes, next_scale = _equations(model, turns, trial, holds)
            except ArithmeticError:
                factor /= 2
                continue
            if float(np.linalg.norm(next_value)) < (1.0 - 1e-4 * min(1.0, factor)) * float(np.linalg.norm(value)):
                break
            factor /= 2
        else:
            if damping == 0.0 or size <= 1e-12 * scale:
                return _accept(model, turns, y, size, scale, step)
            damping = 0.0  # what is left lies along weak directions: plain Gauss-Newton from here on
            continue
        before = move
        if damping:
            damping = max(damping / 3, _LEAST) if factor >= 1.0 else min(damping * 3, 1.0)
        y, value, slopes, scale = trial, next_value, next_slopes, next_scale
    raise NotSteady(f"no steady motion after {_STEPS} steps from there", size, y[: len(model.flow.y)])


def _step(value: Vector, slopes: Matrix, across: Matrix, damping: float) -> Vector:
    """Levenberg's step with ``damping`` |value|, within ``across``: quadratic also where solutions are not isolated, as in a
    family of steady motions, whose own directions are weak near it and must not be taken for wanted (Yamashita and Fukushima 2001).
    """
    inside = np.eye(slopes.shape[1])
    if len(across):
        inside = np.linalg.svd(across)[2][len(across) :]
    left, sizes, right = np.linalg.svd(slopes @ inside.T, full_matrices=False)
    damping *= float(np.linalg.norm(value))
    weights = np.where(sizes > RANK * sizes.max(initial=0.0), sizes / np.maximum(sizes**2 + damping**2, 1e-300), 0.0)
    return np.asarray(-(weights * (left.T @ value)) @ right @ inside)


def _halves(before: Vector, move: Vector) -> bool:
    """Steps that halve again and again lead to a double root: twice the step is right."""
    size, last = float(np.linalg.norm(move)), float(np.linalg.norm(before))
    return 0.45 * last < size < 0.55 * last and float(before @ move) > 0.99 * size * last


def _accept(model: SteadyModel, turns: Sequence[Matrix], y: Vector, size: float, scale: float, steps: int) -> Steady:
    """The iteration can do no better: either rounding is all that is left, or there is nothing to find."""
    if size > 1e-9 * scale:
        raise NotSteady("the iteration stops where the motion is not steady", size, y[: len(model.flow.y)])
    n = model.flow.system.n
    state, turning = _parted(model, turns, y)
    still = bool(np.max(np.abs(model.field(state)[0][:n]), initial=0.0) <= 1e-9 * scale)
    return Steady(tuple(state), size, steps, still, turning, tuple(turns))


def _parted(model: SteadyModel, turns: Sequence[Matrix], y: Vector) -> tuple[list[float], Matrix | None]:
    """The state, and the turn that goes with it."""
    count = len(model.flow.y)
    state = [float(x) for x in y[:count]]
    if not turns:
        return state, None
    return state, np.asarray(sum(speed * turn for speed, turn in zip(y[count:], turns, strict=True)))


def _equations(
    model: SteadyModel, turns: Sequence[Matrix], y: Vector, holds: Sequence[Hold]
) -> tuple[Vector, Matrix, float]:
    """Rates of the rest, conditions and holds, with their slopes and the size that rounding is measured by."""
    state, turning = _parted(model, turns, y)
    rates, jacobian = (model if turning is None else replace(model, turning=turning)).field(state)
    off, across = model.conditions(state)
    rest = list(model.rest)
    values = model.values(state)
    wanted = np.array([model.value(state, hold.node) - hold.value for hold in holds])
    rows = [model.tapes.slopes(hold.node, values) for hold in holds]
    held = np.array(rows).reshape(len(holds), len(state))
    scale = max(1.0, float(np.max(np.abs(jacobian[rest]), initial=0.0)))
    slopes = np.vstack([jacobian[rest], across, held])
    by_speed = np.zeros((len(slopes), len(turns)))
    for k, turn in enumerate(turns):
        by_speed[: len(rest), k] = -(turn @ np.array(state))[rest]
    return np.concatenate([rates[rest], off, wanted]), np.hstack([slopes, by_speed]), scale


def _bound(model: SteadyModel, y: Vector, set_by: Matrix) -> Matrix:
    """Directions (rows over y) in which the steps do not go: across the leaf, but for what other equations set."""
    found = model.normals([float(x) for x in y[: len(model.flow.y)]])
    if found is None or not len(found):
        return np.zeros((0, len(y)))
    normals = np.hstack([found, np.zeros((len(found), len(y) - found.shape[1]))])
    lengths = np.linalg.norm(set_by, axis=1)
    shares = set_by @ normals.T
    own = shares[np.linalg.norm(shares, axis=1) > (1.0 - 1e-9) * lengths]
    return np.asarray(_null_rows(own) @ normals) if own.any() else normals


def _null_rows(matrix: Matrix) -> Matrix:
    """Orthonormal rows that span the null space."""
    _, sizes, right = np.linalg.svd(matrix)
    return np.asarray(right[int(np.sum(sizes > RANK * sizes[0])) :])
