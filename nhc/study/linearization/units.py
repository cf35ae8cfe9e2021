"""Units in which the numbers of a field are near one, so that what counts as zero does not hang on the spec's units.

Orbits in metres and seconds and resonators of a megahertz have rates that differ from one by many powers of ten; a tolerance
beside 1 then takes what is slow for rounding, and what is small beside something fast.  The states' units come from balancing the
Jacobian (Osborne 1960) and the unit of time from its size.  Where all of it lies within a factor of 1000 of one, the spec's
units stay.  All of them are powers of two, so that nothing is rounded.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from nhc.records import record

Vector = NDArray[np.float64]
Matrix = NDArray[np.float64]

SMALL = 1e-13
"""By how much, relative to its size, a state or a parameter is taken to be uncertain."""
_NEAR = 1000.0
_ZERO = 1e-12  # what is smaller is a zero that was rounded
_SWEEPS, _GAIN = 200, 0.95
_TRIALS = 3
_LEAST_SIZE = 1e-3
_REACH = 1e-7  # how far a double root may be, as the rates are rounded


@record
class Units:
    """``states``: the unit of each entry of the state; ``time``: that of time, both in the spec's units."""

    states: tuple[float, ...]
    time: float

    @property
    def own(self) -> bool:
        """Whether these are the spec's."""
        return self.time == 1.0 and set(self.states) <= {1.0}


def trials(y: Sequence[float], p: Sequence[float]) -> list[tuple[list[float], tuple[float, ...]]]:
    """States and parameters that differ from the given ones by what rounding may have done to them."""
    found = []
    for trial in range(1, _TRIALS + 1):
        nudges = iter(math.cos(trial * (k + 1.0) ** 1.5) for k in range(len(y) + len(p)))
        near = [x + SMALL * (abs(x) if abs(x) > SMALL else 1.0) * next(nudges) for x in y]
        found.append((near, tuple(x * (1.0 + SMALL * next(nudges)) for x in p)))
    return found


def beside(y: Sequence[float]) -> list[list[float]]:
    """States all around a given one, as near as they can be told from it: a kink or a jump lies between some of them."""
    found = []
    for trial in range(2 * _TRIALS):
        signs = [1.0 if math.cos((trial // 2 + 1) * (k + 1.0) ** 1.5) > 0.0 else -1.0 for k in range(len(y))]
        side = 1.0 if trial % 2 else -1.0
        steps = [SMALL * abs(x) if abs(x) > SMALL else 4.0 * abs(x) + 1e-30 for x in y]
        found.append([x + side * sign * step for x, sign, step in zip(y, signs, steps, strict=True)])
    return found


def cleaned(matrix: Matrix, others: Sequence[Matrix]) -> Matrix:
    """The matrix without the entries that are no larger than what they change by from one trial to the next."""
    change = np.max([np.abs(other - matrix) for other in others], axis=0, initial=0.0) if others else np.zeros(1)
    return np.where(np.abs(matrix) <= 8.0 * change, 0.0, matrix)


def choose_units(
    jacobian: Matrix,
    y: Sequence[float],
    rest: Sequence[int],
    together: Sequence[Sequence[int]],
    angles: Sequence[int],
) -> Units:
    """Units for a state ``y``; ``rest`` are the entries that matter.

    ``jacobian`` (NY, NY) holds no rounding that looks like a number.  ``together``: entries that stand in one condition on the
    state, so that the size of one tells that of the others.  ``angles``: entries in radians, which have their unit: along
    a chain of trailers, of which each turns the next, balancing would make the last one's angle as large as it likes.
    """
    states, inner = np.ones(len(y)), list(rest)
    fixed = {inner.index(k) for k in angles if k in inner}
    own = np.abs(jacobian[np.ix_(inner, inner)])
    scale = balance(own, fixed)
    met = np.array(own)
    for group in together:
        places = [inner.index(k) for k in group if k in inner]
        met[np.ix_(places, places)] += 1.0
    for part in _parts(met):
        if not fixed.isdisjoint(part):
            continue
        factor = max((abs(y[inner[k]]) / scale[k] for k in part), default=0.0)
        scale[part] *= _power(factor) if factor > _NEAR or _ZERO < factor < 1.0 / _NEAR else 1.0
    speed = float(np.max(np.sum(own * scale / scale[:, None], axis=1))) if inner else 0.0
    fast = speed > 0.0 and not 1.0 / _NEAR <= speed <= _NEAR
    if fast or np.max(np.maximum(scale, 1.0 / scale), initial=1.0) > _NEAR:
        states[inner] = scale
    for k in set(range(len(y))) - set(inner):
        states[k] = _power(y[k]) if abs(y[k]) > _NEAR else 1.0
    return Units(tuple(float(x) for x in states), _power(1.0 / speed) if fast else 1.0)


def normal(rows: Matrix) -> Vector:
    """Factors that bring rows of slopes to about 1, as far as they are not near it."""
    lengths = np.max(np.abs(rows), axis=1, initial=0.0)
    far = (lengths > _NEAR) | ((lengths < 1.0 / _NEAR) & (lengths > 0.0))
    return np.asarray(1.0 / np.where(far, lengths, 1.0))


def _power(x: float) -> float:
    """The power of two nearest to a size."""
    return float(2.0 ** round(math.log2(abs(x))))


def balance(matrix: Matrix, fixed: Collection[int] = ()) -> Vector:
    """The diagonal D, powers of two, for which D^-1 A D has rows and columns of the same length, as far as there is one.

    It is 1 at ``fixed`` places.
    """
    made, scale = np.abs(matrix), np.ones(len(matrix))
    np.fill_diagonal(made, 0.0)
    for _ in range(_SWEEPS):
        still = True
        for k in range(len(made)):
            if k in fixed:
                continue
            column, row = float(np.sum(made[:, k])), float(np.sum(made[k]))
            if column == 0.0 or row == 0.0:
                continue
            factor = _power(math.sqrt(row / column))
            if factor != 1.0 and column * factor + row / factor < _GAIN * (column + row):
                made[:, k] *= factor
                made[k] /= factor
                scale[k] *= factor
                still = False
        if still:
            break
    for part in _parts(matrix):
        if not any(k in fixed for k in part):
            scale[part] /= _power(math.exp(float(np.mean(np.log(scale[part])))))
    return scale


def _parts(matrix: Matrix) -> list[list[int]]:
    """Places that are joined by entries, directly or through others."""
    joined = (matrix != 0.0) | (matrix.T != 0.0)
    left, found = set(range(len(matrix))), list[list[int]]()
    while left:
        part, waiting = set[int](), [min(left)]
        while waiting:
            k = waiting.pop()
            if k not in part:
                part.add(k)
                waiting += [int(j) for j in np.flatnonzero(joined[k])]
        left -= part
        found.append(sorted(part))
    return found


def sizes_of(largest: Vector, slopes: Matrix, duration: float, coordinates: int) -> Vector:
    """What is large for each entry of a state: ``largest`` is its largest magnitude in a scene of that ``duration``.

    What stays (almost) zero is measured by entries that it goes back and forth with, at a thousandth, in the units in which their
    ``slopes`` (NY, NY; magnitudes of d rhs / d y) are balanced; what is only integrated from others, by these and the duration.
    Where all of these stay zero, the smallest other coordinate (of the first ``coordinates`` entries) or velocity is taken.
    """
    found, alone = np.array(largest), list[list[int]]()
    for part in _loops(slopes):
        scale = balance(slopes[np.ix_(part, part)])
        found[part] = np.maximum(found[part], _LEAST_SIZE * scale * np.max(found[part] / scale))
        if not np.all(found[part] > 0.0):
            alone.append(part)
    for part in alone * len(alone):
        if len(part) == 1:
            found[part] = np.maximum(found[part], _LEAST_SIZE * duration * (slopes[part] @ found))
    for part in alone:
        if not np.all(found[part] > 0.0):
            scale = balance(slopes[np.ix_(part, part)])
            like = [k for k in range(len(found)) if (k < coordinates) == (part[0] < coordinates) and largest[k] > 0.0]
            found[part] = _LEAST_SIZE * min((float(largest[k]) for k in like), default=1.0) * scale / scale[0]
    return found


def _loops(slopes: Matrix) -> list[list[int]]:
    """Entries that depend on each other, directly or through others (strongly connected)."""
    size = len(slopes)
    reach = (slopes != 0.0) | np.eye(size, dtype=bool)
    for _ in range(max(size, 2).bit_length()):
        reach = (reach.astype(float) @ reach) > 0.0
    both = reach & reach.T
    return [[int(j) for j in np.flatnonzero(both[k])] for k in range(size) if not np.any(both[k, :k])]


def is_steady(value: Vector, slopes: Matrix, y: Vector, others: Callable[[], Sequence[Vector]]) -> bool:
    """Whether rates are zero up to what 1e-7 in the state (where they have a double root) and rounding make of them.

    ``slopes`` are those of the rates; ``others`` gives the rates of the trials.  What a step of that length does not remove is
    left: far out on a force that fades away the slopes are as small as the rates, and the root is not near.
    """
    left, sizes, _ = np.linalg.svd(slopes, full_matrices=False)
    most = _REACH * (1.0 + float(np.max(np.abs(y), initial=0.0)))
    step = (left.T @ value) / np.maximum(sizes, 1e-300)
    remains = value - left @ (sizes * np.clip(step, -most, most))
    allowed = np.full(len(value), 1e-14 * max(1.0, float(np.max(np.abs(slopes), initial=0.0))))
    if np.all(np.abs(remains) <= allowed):
        return True
    change = np.max([np.abs(other - value) for other in others()], axis=0, initial=0.0)
    return bool(np.all(np.abs(remains) <= allowed + 100.0 * change))
