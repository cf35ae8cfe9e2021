"""Linearisation about a steady motion and its eigenvalues.

The Jacobian of the entries that are not cyclic is restricted to admissible perturbations (those that keep the state on
its constraints and inside its leaf), so that hidden integrals give no eigenvalues.  What is left has one zero for each
direction of the family of steady motions; these structural zeros are counted and split off before the eigenvalues are
computed.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from nhc.algebra.exact.modular import Unlucky, are_zero
from nhc.algebra.rebuilding import substitute
from nhc.records import record
from nhc.study.linearization.field import RANK, SteadyModel
from nhc.study.linearization.found import Steady
from nhc.study.linearization.roots import undecided
from nhc.study.linearization.spectrum import find_spectrum, join
from nhc.study.linearization.steady import find_steady
from nhc.study.linearization.turns import Turn
from nhc.study.linearization.units import Matrix

_NEARBY = 1e-2
_MOVED = 0.3  # of the way to a steady motion nearby: less is the search coming back
_BETWEEN, _ASTRAY = 0.37, 0.1  # a family has steady motions on the way there, too
_EPSILON = float(np.finfo(float).eps)
_FLOOR = 1e-5  # a matrix of rounding has rank 0


@record
class Linearisation:
    """``full`` is the Jacobian over ``rest``, without entries that are rounding; ``basis`` (rows over ``rest``) spans the
    admissible perturbations.  ``matrix`` is the Jacobian on it; ``core`` is that without the ``zeros`` null directions (rows of
    ``null`` over ``rest``), of which ``family`` are directions of a family of steady motions; these two are in units of their own
    (:mod:`nhc.study.linearization.units`), with ``tick`` for that of time.  ``notes`` say what could not be told.
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
    tick: float = 1.0

    @property
    def zeros(self) -> int:
        return len(self.null)


@record
class _Local:
    """A model about a steady motion, in units in which its numbers are near one: ``full`` over ``rest``, all admissible
    perturbations, and the ``basis`` of those that are no turns.  ``others`` are what ``full`` may be as well for all digits tell.
    """

    model: SteadyModel
    full: Matrix
    every: Matrix
    basis: Matrix
    notes: tuple[str, ...]
    others: tuple[Matrix, ...]

    def parted(self, count: int | None = None) -> tuple[Matrix, Matrix]:
        """Null directions of the matrix on the basis, and an orthonormal rest; see :func:`_split`."""
        matrix, *others = (self.basis @ full @ self.basis.T for full in (self.full, *self.others))
        return _split(matrix, count, others)

    @property
    def states(self) -> Matrix:
        """The units of ``rest``."""
        return np.array(self.model.outside((1.0,) * len(self.model.flow.y)))[list(self.model.rest)]


def _about(model: SteadyModel, steady: Steady, clean: bool = True) -> _Local:
    """``clean``: without entries that are rounding, which costs some evaluations; in units of its own it always is."""
    rest = list(model.rest)
    own = replace(model, turning=steady.turning, symmetries=(steady.turns,)).in_units(steady.y)
    y = own.inside(steady.y)
    jacobian = own.clean_jacobian(y) if clean or own.units is not None else own.field(y)[1]
    full = jacobian[np.ix_(rest, rest)]
    every, notes = _admissible(own, y, full)
    others = tuple(own.field(own.inside(place))[1][np.ix_(rest, rest)] for place in steady.others)
    return _Local(own, full, every, _beside_turns(every, own.symmetries[0], y, rest), notes, others)


def linearise_at(model: SteadyModel, steady: Steady, family: int | None = None) -> Linearisation:
    """The Jacobian about a steady motion; ``family`` is the dimension of the family, found where it is not given."""
    made = _about(model, steady, family is None)
    basis, states, tick = made.basis, made.states, made.model.tick
    matrix = basis @ made.full @ basis.T
    null, others = made.parted()
    if family is None:
        family = _family(model, steady, made, null @ basis)
    else:
        null, others = made.parted(family)
    core = others @ matrix @ others.T
    # what bases that are not the state's own make of entries that cancel is rounding of the whole matrix, not of the core
    core = np.where(np.abs(core) > len(matrix) * _EPSILON * np.linalg.norm(matrix), core, 0.0)
    full = made.full * states[:, None] / states / tick
    turns = len(made.every) - len(basis)
    return Linearisation(
        steady,
        model.rest,
        full,
        basis * states,
        matrix,
        core,
        null @ basis * states,
        min(family, len(null)),
        made.notes,
        turns,
        tick,
    )


def _beside_turns(basis: Matrix, turns: Sequence[Turn], y: Sequence[float], rest: Sequence[int]) -> Matrix:
    """The part of the basis across turns that nothing depends on: these are null directions, and the rest is a quotient by them."""
    moving = [turn for turn in turns if turn.moves(y, rest)]
    if not moving:
        return basis
    moved = np.array([turn.at(y) for turn in moving])[:, list(rest)]
    inside = moved @ basis.T
    # a turn may lead off the constraints: what it does there is no perturbation
    beside = moved - inside @ basis
    weights = _kernel(np.where(np.abs(beside) > RANK * np.linalg.norm(moved), beside, 0.0).T)
    return np.asarray(_kernel(weights @ inside) @ basis)


def _admissible(model: SteadyModel, y: Sequence[float], full: Matrix) -> tuple[Matrix, tuple[str, ...]]:
    """Orthonormal rows over ``rest``: perturbations on the constraints and inside the leaf."""
    size, rest = len(model.flow.y), list(model.rest)
    notes: tuple[str, ...] = ()
    across = model.normals(y)
    if across is None:
        notes = ("the leaf of the hidden constraints is not regular here: its directions are not left out",)
        across = np.zeros((0, model.flow.system.n))
    held = model.held_directions(y)
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


def _split(matrix: Matrix, count: int | None, others: Sequence[Matrix]) -> tuple[Matrix, Matrix]:
    """(null directions, an orthonormal rest) as rows; with ``count`` the directions of so many smallest singular values.

    Null is what is small beside the rest, and what the others say that the matrix might as well have as zero.
    """
    if not len(matrix):
        return matrix, matrix
    _, sizes, right = np.linalg.svd(matrix)
    if count is None:
        count = max(int(np.sum(sizes <= RANK * max(float(sizes[0]), _FLOOR))), undecided(matrix, others))
    kept = len(matrix) - count
    return right[kept:], right[:kept]


def _family(model: SteadyModel, steady: Steady, made: _Local, null: Matrix) -> int:
    """The dimension of the family of steady motions: of what the steady motions nearby span, off any special point.

    A null direction alone says little: at a root of higher order (x'' ~ x^2, a pitchfork at its threshold) there is one too, and
    the search from beside it comes back, or goes to another root.  At special points there are more of them than nearby.
    """
    smallest = zeros = len(null)
    if zeros and _rests_anywhere(model, steady, null):
        return zeros
    y, rest = np.array(made.model.inside(steady.y)), list(model.rest)
    scale = _NEARBY * (1.0 + float(np.max(np.abs(y), initial=0.0)))
    away = replace(model, turning=None, symmetries=(steady.turns,), in_doubles=True)  # as far as that a way can be told

    def beside(move: Matrix) -> tuple[Steady, Matrix]:
        guess = np.array(y)
        guess[rest] += scale * move @ null
        found = find_steady(away, made.model.outside(guess))
        return found, np.asarray(null @ (np.array(made.model.inside(found.y)) - y)[rest] / scale)

    moves = np.zeros((0, zeros))
    for direction in _directions(zeros):
        for side in (1.0, -1.0):
            try:
                found, moved = beside(side * direction)
                size = float(np.linalg.norm(moved))
                if size < _MOVED or np.linalg.norm(beside(_BETWEEN * moved)[1] - _BETWEEN * moved) > _ASTRAY * size:
                    continue
                near = _about(model, find_steady(replace(away, in_doubles=False), found.y))
            except ArithmeticError:
                continue
            smallest = min(smallest, len(near.parted()[0]))
            moves = np.vstack([moves, moved])
            break
        if np.linalg.matrix_rank(moves, tol=_MOVED) == zeros:
            break
    return min(smallest, int(np.linalg.matrix_rank(moves, tol=_MOVED))) if zeros else 0


def _rests_anywhere(model: SteadyModel, steady: Steady, null: Matrix) -> bool:
    """Whether every position is an equilibrium, exactly, and the null directions are those: of a snake without forces at rest."""
    flow, g, n = model.flow, model.flow.graph, model.flow.system.n
    moved = null[:, [place for place, i in enumerate(model.rest) if i >= n]]
    if any(steady.y[n:]) or np.max(np.abs(moved), initial=0.0) > RANK:
        return False
    absent = [node for node, value in zip(flow.system.p, model.p, strict=True) if value == 0.0]
    still = dict.fromkeys((*flow.y[n:], *absent), g.zero)
    try:
        return all(are_zero(g, substitute(g, [*flow.velocities, *flow.right], still, named=False)))
    except (Unlucky, ArithmeticError):  # it divides by a parameter that is 0
        return False


def _directions(count: int) -> Matrix:
    """Unit vectors that span the space, the first two of no special direction."""
    places = np.arange(1.0, count + 1)
    found = np.vstack([np.sqrt(places), np.cos(places), np.eye(count)]) if count > 1 else np.eye(count)
    return np.asarray(found / np.linalg.norm(found, axis=1)[:, None])


@record
class Mode:
    """An eigenvalue and what its real part must exceed to count: what rounding may make of it."""

    value: complex
    limit: float

    @property
    def grows(self) -> bool:
        return bool(self.value.real > self.limit)

    @property
    def decays(self) -> bool:
        return bool(self.value.real < -self.limit)


def modes(made: Linearisation) -> list[Mode]:
    """The eigenvalues without the structural zeros, by falling real part; critical zeros come as zeros."""
    found = [Mode(0j, 0.0)] * (made.zeros - made.family)
    if len(made.core):
        values, limits = find_spectrum(made.core, len(made.full), float(np.linalg.norm(made.matrix, 2)))
        joined = join(values, limits)
        found += [Mode(x / made.tick, limit / made.tick) for x, limit in zip(joined, limits, strict=True)]
    digits = made.tick

    def order(mode: Mode) -> tuple[float, float, float]:
        return -round(mode.value.real * digits, 9), -abs(mode.value.imag), -mode.value.imag

    return sorted(found, key=order)


def eigenvalues(made: Linearisation) -> list[complex]:
    """The values of the modes."""
    return [mode.value for mode in modes(made)]


def count_zeros(made: Linearisation) -> int:
    """How many of the modes are zero, though they belong to no family that was found."""
    return sum(abs(mode.value) <= mode.limit for mode in modes(made))


def verdict(made: Linearisation) -> str:
    """stable, unstable or marginal, to first order; ``none`` where every direction was left out and nothing is left to judge."""
    found = modes(made)
    if not found:
        return "none"
    if any(mode.grows for mode in found):
        return "unstable"
    return "stable" if all(mode.decays for mode in found) else "marginal"
