"""How well a root is known: Kantorovich's statement in doubles, and Newton's method in many digits where it does not hold.

A root of multiplicity m is found in doubles to the m-th root of their rounding only (Wilkinson 1963, ch. 2), and the slopes there
are those of a place beside it.  By the theorem of Newton and Kantorovich a root is simple, and as near as one step of Newton's
method says, if the slopes change by less than half of what they are along that step (Ortega and Rheinboldt 1970, 12.6.2).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from nhc.study.linearization.units import Matrix, Vector

Equations = Callable[[Sequence[Any]], tuple[Sequence[Any], Sequence[Sequence[Any]]]]
"""Values, and their slopes as rows, at a place in mpmath's numbers."""

_NOISE = 1e-14
"""Singular values below this part of the largest are rounding: directions along which roots lie side by side."""
_FARTHEST = 0.03  # of 1 + |y|: no step says more than that the root may lie anywhere near
_DIGITS = 200  # the slopes at a root of multiplicity m vanish as the (m-1)th power of the distance, and are squared
_CLOSE = 1e-25
_STEPS, _HALVINGS = 60, 40
_LEAST, _MOST = 0.3, 0.97  # the ratios of neighbouring steps that tell a multiplicity


def newton_step(value: Vector, slopes: Matrix, y: Vector) -> Vector:
    """Newton's step of least norm from y, of shape (NY,), along all directions that are no rounding, none of them far."""
    left, sizes, right = np.linalg.svd(slopes, full_matrices=False)
    real = sizes > _NOISE * np.max(sizes, initial=0.0)
    along = np.where(real, (left.T @ value) / np.where(real, sizes, 1.0), 0.0)
    most = _FARTHEST * (1.0 + float(np.max(np.abs(y), initial=0.0)))
    return np.asarray(-np.clip(along, -most, most) @ right)


def undecided(matrix: Matrix, others: Sequence[Matrix]) -> int:
    """How many of the least singular values of a matrix are not told by it, if it may as well be one of the others: they and all
    smaller ones change by more than half of what they are.  Those that are rounding are not asked, but counted if larger ones are.
    """
    left, sizes, right = np.linalg.svd(matrix)
    real = [k for k in range(len(sizes)) if sizes[k] > _NOISE * sizes[0]]
    found = 0
    for k in reversed(real):
        kept = slice(k, len(real))
        change = max(
            (float(np.linalg.norm(left.T[kept] @ (b - matrix) @ right[kept].T, 2)) for b in others), default=0.0
        )
        if sizes[k] <= 2.0 * change:
            found = len(sizes) - k
    return found


def refined(equations: Equations, inside: Matrix, y: Vector) -> Vector | None:
    """The root near y, in its affine space along the rows of ``inside``, to the last digit of a double; None if there is none.

    Levenberg's steps as in :mod:`nhc.study.linearization.steady`, in many digits.  At a root of multiplicity m each is 1 - 1/m
    of the one before, and m times such a step is right up to its square (Ralston and Rabinowitz 1978, 8.6).
    """
    import mpmath

    with mpmath.workdps(_DIGITS):
        place = [mpmath.mpf(float(x)) for x in y]
        ways = mpmath.matrix(inside.tolist())
        before: Any = None
        try:
            value, slopes = equations(place)
            for _ in range(_STEPS):
                size = mpmath.norm(mpmath.matrix(value)) if len(value) else mpmath.mpf(0)
                move = _step(mpmath, value, slopes, ways, size)
                length = mpmath.norm(move)
                if length <= _CLOSE * (1 + max(abs(x) for x in place)):
                    return np.array([float(x + d) for x, d in zip(place, move, strict=True)])
                tried = _better(mpmath, equations, place, move, size)
                if tried is None:
                    return None
                factor, state = tried
                times = _multiplicity(before, move) if factor == 1 else 1
                if times > 1:
                    more = _better(mpmath, equations, place, times * move, state[3], 1)
                    factor, state = (0, more[1]) if more is not None else (factor, state)
                before = move if factor == 1 else None
                place, value, slopes, _ = state
        except (ArithmeticError, ValueError, TypeError):  # TypeError: a root of a negative number
            return None
    return None


_State = tuple[list[Any], Sequence[Any], Sequence[Sequence[Any]], Any]


def _step(mp: Any, value: Sequence[Any], slopes: Sequence[Sequence[Any]], ways: Any, size: Any) -> Any:
    if not size:
        return mp.matrix(ways.cols, 1)
    along = mp.matrix(slopes) * ways.T
    normal = along.T * along + mp.diag([min(size, 1) ** 2] * ways.rows)
    return -(ways.T * mp.lu_solve(normal, along.T * mp.matrix(value)))


def _better(
    mp: Any, equations: Equations, place: list[Any], move: Any, size: Any, halvings: int = _HALVINGS
) -> tuple[Any, _State] | None:
    """The first of the step's halves at which less is left than ``size``."""
    factor = mp.mpf(1)
    for _ in range(halvings):
        trial = [x + factor * d for x, d in zip(place, move, strict=True)]
        value, slopes = equations(trial)
        left = mp.norm(mp.matrix(value))
        if left < size:
            return factor, (trial, value, slopes, left)
        factor /= 2
    return None


def _multiplicity(before: Any, move: Any) -> int:
    """That of the root that two steps after one another lead to; 1 where they tell none."""
    if before is None:
        return 1
    products = [
        sum(a * b for a, b in zip(first, second, strict=True)) for first, second in ((before, before), (before, move))
    ]
    sizes = products[0], sum(x * x for x in move)
    if not sizes[0] or products[1] ** 2 < 0.98 * sizes[0] * sizes[1]:
        return 1
    ratio = products[1] / products[0]
    return round(1 / (1 - ratio)) if _LEAST < ratio < _MOST else 1
