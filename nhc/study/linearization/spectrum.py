"""Eigenvalues of a matrix that is known to rounding, with the size of their error."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nhc.study.linearization.units import Matrix, Vector, balance

ROUNDING = 1e-13
"""By how much, relative to its size, a matrix may be off."""
_EPSILON = float(np.finfo(float).eps)


def join(values: NDArray[np.complex128], limits: Vector) -> list[complex]:
    """Roots that are several times the same come as some that rounding has parted: their mean is known better than they are."""
    left, found = list(range(len(values))), [complex(x) for x in values]
    while left:
        group = [left.pop(0)]
        for i in group:  # which grows on the way
            near = [j for j in left if abs(values[i] - values[j]) <= 2.0 * min(limits[i], limits[j])]
            group += near
            left = [j for j in left if j not in near]
        if len(group) > 1:
            mean = complex(np.mean(values[group]))
            together = complex(mean.real, 0.0 if abs(mean.imag) <= max(limits[group]) else mean.imag)
            for i in group:
                found[i] = together
    return found


def find_spectrum(core: Matrix, whole: int, around: float) -> tuple[NDArray[np.complex128], Vector]:
    """Eigenvalues with the size of their error: that of the matrix, which comes from one of ``whole`` rows, times the eigenvalue's
    condition, which is 1 over the cosine between its left and right vectors; where several meet, the root of it (Wilkinson 1965,
    ch. 2; L. Elsner, Linear Algebra Appl. 71 (1985) 77).

    ``around``: the norm of the matrix whose part the core is; its rounding is that of each entry, before the core is balanced.
    """
    scale = balance(core)
    even = core * scale / scale[:, None]
    values, right = np.linalg.eig(even)
    size = float(np.linalg.norm(even, 2))
    limits = _limits(right, size, ROUNDING * max(len(core), whole) * size)
    turned = _limits(right * scale[:, None], float(np.linalg.norm(core, 2)), _EPSILON * whole * around)
    return np.asarray(values, dtype=np.complex128), np.maximum(limits, turned)


def _limits(right: Matrix, size: float, error: float) -> Vector:
    """What an error of a matrix of this size makes of its eigenvalues, by its right vectors, as columns."""
    if not size:
        return np.zeros(len(right))
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # vectors that are the same have an infinite condition
            condition = np.linalg.norm(np.linalg.inv(right), axis=1) * np.linalg.norm(right, axis=0)
    except np.linalg.LinAlgError:
        condition = np.full(len(right), np.inf)
    condition = np.where(np.isfinite(condition), condition, np.inf)
    several = np.where(condition < 1e9, (2 * size * error) ** (1 / 2), (4 * size**2 * error) ** (1 / 3))
    return np.asarray(np.minimum(condition * error, several), dtype=np.float64)
