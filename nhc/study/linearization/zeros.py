"""Zeros among the eigenvalues of a matrix, what is left beside them, and the sign of its determinant."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from nhc.study.linearization.field import RANK
from nhc.study.linearization.spectrum import ROUNDING
from nhc.study.linearization.units import Matrix


def chain_of(core: Matrix) -> list[int]:
    """How many null directions a matrix has, then what is left of it beside these, and so on: all of its zeros."""
    found, left = list[int](), core
    while len(left):
        sizes = np.linalg.svd(left, compute_uv=False)
        count = int(np.sum(sizes <= RANK * sizes[0]))
        if not count:
            break
        found.append(count)
        left = without(left, [count])
    return found


def without(core: Matrix, zeros: Sequence[int]) -> Matrix:
    """What is left of a matrix beside as many null directions, then beside those of that."""
    for count in zeros:
        kept = np.linalg.svd(core)[2][: len(core) - count]
        core = np.asarray(kept @ core @ kept.T)
    return core


def sign_of(core: Matrix) -> float:
    """The sign of a matrix's determinant, that of rounding where it is singular; 1 of nothing."""
    return float(np.linalg.slogdet(core)[0]) if len(core) else 1.0


def told_sign(core: Matrix) -> float:
    """The sign of a determinant; 0 where it is singular up to rounding, for there the sign is that of rounding."""
    sizes = np.linalg.svd(core, compute_uv=False) if len(core) else np.ones(1)
    return sign_of(core) if sizes[-1] > 100.0 * ROUNDING * sizes[0] else 0.0


def size_of(core: Matrix) -> float:
    """The core's determinant beside what a matrix of its size has at most: a measure, not a sign."""
    sizes = np.linalg.svd(core, compute_uv=False) if len(core) else np.ones(1)
    return float(np.prod(sizes / max(sizes[0], 1e-300)))
