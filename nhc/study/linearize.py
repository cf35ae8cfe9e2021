"""Linearisation about a steady motion, its eigenvalues, and where they cross the imaginary axis.

The Jacobian of the entries that are not cyclic is restricted to admissible perturbations (those that keep the state on
its constraints and inside its leaf), so that hidden integrals give no eigenvalues.  What is left has one zero for each
direction of the family of steady motions; these structural zeros are counted and split off before the eigenvalues are
computed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from nhc.records import record
from nhc.study.steady import RANK, Hold, Matrix, NotSteady, Steady, SteadyModel, find_steady

MARGINAL = 1e-8
"""Real parts below this, relative to the matrix, count as zero."""
_NEARBY = 1e-2
_FLOOR = 1e-5  # a matrix of rounding has rank 0
_BISECTIONS = 60


@record
class Linearisation:
    """``full`` is the Jacobian over ``rest``; ``basis`` (rows over ``rest``) spans the admissible perturbations and
    ``matrix`` is the Jacobian on it; ``core`` is that without the ``zeros`` null directions (rows of ``null`` over
    ``rest``), of which ``family`` are directions of a family of steady motions.  ``notes`` say what could not be told.
    """

    steady: Steady
    rest: tuple[int, ...]
    full: Matrix
    basis: Matrix
    matrix: Matrix
    core: Matrix
    null: Matrix
    family: int
    notes: tuple[str, ...]
    turns: int = 0
    """How many directions are left out because steady motions differ along them by a turn only."""

    @property
    def zeros(self) -> int:
        return len(self.null)


def linearise_at(model: SteadyModel, steady: Steady, family: int | None = None) -> Linearisation:
    """The Jacobian about a steady motion; ``family`` is the dimension of the family, found where it is not given."""
    rest = list(model.rest)
    model = replace(model, turning=steady.turning)
    full = model.field(steady.y)[1][np.ix_(rest, rest)]
    every, notes = _admissible(model, steady, full)
    basis = _beside_turns(every, steady, rest)
    matrix = basis @ full @ basis.T
    null, others = _split(matrix)
    if family is None:
        family = _family(model, steady, null @ basis, len(null))
    else:
        null, others = _split(matrix, family)
    core = others @ matrix @ others.T
    turns = len(every) - len(basis)
    return Linearisation(
        steady, model.rest, full, basis, matrix, core, null @ basis, min(family, len(null)), notes, turns
    )


def _beside_turns(basis: Matrix, steady: Steady, rest: Sequence[int]) -> Matrix:
    """The part of the basis across turns that nothing depends on: these are null directions, and the rest is a quotient by them."""
    if not steady.turns:
        return basis
    along = np.array([turn @ np.array(steady.y) for turn in steady.turns])[:, list(rest)] @ basis.T
    return np.asarray(_kernel(along) @ basis)


def _admissible(model: SteadyModel, steady: Steady, full: Matrix) -> tuple[Matrix, tuple[str, ...]]:
    """Orthonormal rows over ``rest``: perturbations on the constraints and inside the leaf."""
    size, rest = len(model.flow.y), list(model.rest)
    notes: tuple[str, ...] = ()
    across = model.normals(steady.y)
    if across is None:
        notes = ("the leaf of the hidden constraints is not regular here: its directions are not left out",)
        across = np.zeros((0, model.flow.system.n))
    held = model.conditions(steady.y)[1]
    basis = _seen(np.vstack([np.hstack([across, np.zeros((len(across), size - across.shape[1]))]), held]), rest)
    if len(across):
        allowed = _seen(held, rest)
        beside = allowed - allowed @ basis.T @ basis
        _, sizes, right = np.linalg.svd(beside, full_matrices=False)
        left = right[sizes > 1e-9]
        # an integral that is regular stands still: what moves across the leaf is no perturbation of its value
        if np.linalg.norm(left @ full @ left.T) > 1e-7 * (1.0 + np.linalg.norm(full)):
            notes = ("the integrals of the hidden constraints are not regular here: their directions are not left out",)
            basis = allowed
    if len(basis) == len(rest):
        return np.eye(len(rest)), notes
    moved = full @ basis.T
    if np.linalg.norm(moved - basis.T @ (basis @ moved)) > 1e-7 * (1.0 + np.linalg.norm(full)):
        return np.eye(len(rest)), (
            *notes,
            "the admissible perturbations depend on the cyclic coordinates: all are kept",
        )
    return basis, notes


def _seen(rows: Matrix, rest: Sequence[int]) -> Matrix:
    """Orthonormal rows over ``rest`` that span what is seen there of the null space."""
    _, sizes, right = np.linalg.svd(_kernel(rows)[:, rest], full_matrices=False)
    return np.asarray(right[sizes > 1e-9])


def _kernel(matrix: Matrix) -> Matrix:
    """Orthonormal rows that span the null space."""
    if not len(matrix):
        return np.eye(matrix.shape[1])
    _, sizes, right = np.linalg.svd(matrix)
    return np.asarray(right[int(np.sum(sizes > RANK * max(float(sizes[0]), 1e-300))) :])


def _split(matrix: Matrix, count: int | None = None) -> tuple[Matrix, Matrix]:
    """(null directions, an orthonormal rest) as rows; with ``count`` the directions of so many smallest singular values."""
    if not len(matrix):
        return matrix, matrix
    _, sizes, right = np.linalg.svd(matrix)
    if count is None:
        count = int(np.sum(sizes <= RANK * max(float(sizes[0]), _FLOOR)))
    kept = len(matrix) - count
    return right[kept:], right[:kept]


def _family(model: SteadyModel, steady: Steady, null: Matrix, zeros: int) -> int:
    """The dimension of the family: the null directions that are left at steady motions nearby, off any special point."""
    smallest, rest = zeros, list(model.rest)
    if not zeros:
        return 0
    scale = _NEARBY * (1.0 + max(abs(x) for x in steady.y))
    for weights in (np.sqrt(np.arange(1.0, zeros + 1)), np.cos(np.arange(1.0, zeros + 1))):
        guess = np.array(steady.y)
        guess[rest] += scale * (weights / np.linalg.norm(weights)) @ null
        try:
            near = find_steady(replace(model, turning=None, symmetries=(steady.turns,)), [float(x) for x in guess])
            full = replace(model, turning=near.turning).field(near.y)[1][np.ix_(rest, rest)]
            basis = _beside_turns(_admissible(model, near, full)[0], near, rest)
        except ArithmeticError:
            continue
        smallest = min(smallest, len(_split(basis @ full @ basis.T)[0]))
    return smallest


def eigenvalues(made: Linearisation) -> list[complex]:
    """The eigenvalues without the structural zeros, by falling real part; critical zeros come as zeros."""
    found = [complex(x) for x in np.linalg.eigvals(made.core)] if len(made.core) else []
    found += [0j] * (made.zeros - made.family)
    return sorted(found, key=lambda x: (-round(x.real, 9), -abs(x.imag), -x.imag))


def threshold(made: Linearisation) -> float:
    """What a real part must exceed to count."""
    return MARGINAL * max(1.0, float(np.max(np.abs(made.matrix), initial=0.0)))


def verdict(made: Linearisation) -> str:
    """stable, unstable or marginal, to first order."""
    parts = [x.real for x in eigenvalues(made)]
    limit = threshold(made)
    if any(x > limit for x in parts):
        return "unstable"
    return "marginal" if any(x >= -limit for x in parts) else "stable"


# --- along a parameter ---------------------------------------------------------------------------------------


@record
class Crossing:
    """At ``value`` an eigenvalue (``frequency`` 0) or a pair (rad per unit of time) crosses the imaginary axis.

    ``error`` is the width of the last interval; ``unstable_above`` says on which side more eigenvalues have a positive real part.
    """

    value: float
    kind: str
    frequency: float
    error: float
    unstable_above: bool


@record
class Sweep:
    """Linearisations at ``values`` and the crossings between them."""

    values: tuple[float, ...]
    points: tuple[Linearisation, ...]
    crossings: tuple[Crossing, ...]


class Branch:
    """Steady motions along one number, each found from the nearest one before."""

    def __init__(self, model: Callable[[float], tuple[SteadyModel, tuple[Hold, ...]]], guess: Sequence[float]) -> None:
        self._model = model
        self._known: dict[float, tuple[float, ...]] = {}
        self._guess = tuple(guess)
        self.family: int | None = None
        self._turns: tuple[Matrix, ...] | None = None

    def __call__(self, value: float) -> Linearisation:
        """The linearisation at a value.

        Raises:
            NotSteady: the branch ends before.
        """
        model, holds = self._model(value)
        near = min(self._known, key=lambda known: abs(known - value), default=None)
        if self._turns is not None:
            model = replace(model, symmetries=(self._turns,))
        steady = find_steady(model, self._guess if near is None else self._known[near], holds)
        self._known[value], self._turns = steady.y, steady.turns
        return linearise_at(model, steady, self.family)


def sweep(branch: Branch, values: Sequence[float]) -> Sweep:
    """Linearise at the values and look for crossings between neighbours.

    Raises:
        NotSteady: with the value where the branch ends.
    """
    points = []
    for value in values:
        try:
            points.append(branch(value))
        except NotSteady as error:
            raise NotSteady(f"at {value:.10g}: {error}", error.residual) from None
    branch.family = min((point.family for point in points), default=0)
    points = [linearise_at(branch._model(v)[0], p.steady, branch.family) for v, p in zip(values, points, strict=True)]
    return Sweep(tuple(values), tuple(points), crossings(branch, values, points))


def crossings(branch: Branch, values: Sequence[float], points: Sequence[Linearisation]) -> tuple[Crossing, ...]:
    """Where the sign of the core's determinant or the number of growing oscillations changes, by bisection."""
    found = []
    for low, high, a, b in zip(values, values[1:], points, points[1:], strict=False):
        found += [*_static(branch, low, high, a, b), *_oscillatory(branch, low, high, a, b)]
    return tuple(sorted(found, key=lambda crossing: crossing.value))


def _sign(made: Linearisation) -> float:
    return float(np.linalg.slogdet(made.core)[0]) if len(made.core) else 1.0


def _static(branch: Branch, low: float, high: float, a: Linearisation, b: Linearisation) -> list[Crossing]:
    first = _sign(a)
    if first * _sign(b) >= 0:
        return []
    low, high = _bisect(lambda value: _sign(branch(value)) == first, low, high)
    above = sum(x.real > threshold(b) for x in eigenvalues(b)) > sum(x.real > threshold(a) for x in eigenvalues(a))
    return [Crossing((low + high) / 2, "an eigenvalue passes zero", 0.0, high - low, above)]


def _pairs(made: Linearisation, limit: float) -> list[complex]:
    """Growing oscillations, the fastest first."""
    least = threshold(made)
    return [x for x in eigenvalues(made) if x.imag > least and x.real > limit]


def _oscillatory(branch: Branch, low: float, high: float, a: Linearisation, b: Linearisation) -> list[Crossing]:
    before, after = len(_pairs(a, threshold(a))), len(_pairs(b, threshold(b)))
    if before == after:
        return []
    conservative = any(abs(x.real) <= threshold(m) and x.imag > threshold(m) for m in (a, b) for x in eigenvalues(m))
    least = max(before, after)

    def grows(value: float) -> bool:
        made = branch(value)
        return len(_pairs(made, threshold(made) if conservative else 0.0)) >= least

    first = before == least
    start, (low, high) = (low, high), _bisect(lambda value: grows(value) == first, low, high)
    inner = branch(low if first else high)
    pairs = sorted(_pairs(inner, 0.0), key=lambda x: x.real)
    # where a pair becomes two real eigenvalues it does not cross the axis
    if not pairs or (not conservative and pairs[0].real > 1e-6 * (1.0 + abs(pairs[0])) * (start[1] - start[0])):
        return []
    kind = "two pairs meet on the axis" if conservative else "a pair crosses the axis"
    return [Crossing((low + high) / 2, kind, abs(pairs[0].imag), high - low, after > before)]


def _bisect(like_low: Callable[[float], bool], low: float, high: float) -> tuple[float, float]:
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        if like_low(middle):
            low = middle
        else:
            high = middle
    return low, high
