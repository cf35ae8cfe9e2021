"""States a little beside the jumps of dry friction, where a motion goes on that nothing holds any more."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from math import copysign, sqrt

from nhc.simulate.methods import linear

Slip = tuple[float, list[float], list[float]]
"""What a friction may hold, its slopes by time and positions, and those by the velocities that a job keeps."""
_ASIDE = 1e-12  # of the largest entry of a state
_DEPENDENT = 1e-12  # of its square, what is left of a row
_HALVINGS = 100
_LEVELS = (1.0, 3.0, 9.0, 27.0)  # distances from jumps
_MANY = 12  # of these in all, for all slips that do not follow from others
_CLEAR = 1e-3  # of the least distance, what is beside a jump


def list_asides(y: Sequence[float], n: int, slopes: Sequence[Slip]) -> Iterator[tuple[tuple[float, ...], list[float]]]:
    """The sides of all slips, 1 or -1, and a state near by that has them, for each way to be beside all jumps.

    What follows from others is on one side or the other by how far these are from their jumps: several distances are tried.
    """
    size = _ASIDE * (max(map(abs, y), default=0.0) or 1.0)
    free = _list_independent([by for _, _, by in slopes])
    levels = _LEVELS[: max(2, _MANY // max(len(free), 1))]
    known = set[tuple[float, ...]]()
    for aims in product([side * level for level in levels for side in (1.0, -1.0)], repeat=len(free)):
        w = reach(y[n:], [slopes[i] for i in free], [size * aim for aim in aims])
        if w is None:
            continue
        moved = [b - a for a, b in zip(y[n:], w, strict=True)]
        slips = [slip + sum(a * b for a, b in zip(by, moved, strict=True)) for slip, _, by in slopes]
        if any(abs(x) < _CLEAR * size * max(map(abs, by)) for x, (_, _, by) in zip(slips, slopes, strict=True)):
            continue
        sides = tuple(copysign(1.0, x) for x in slips)
        if sides not in known:
            known.add(sides)
            yield sides, [*y[:n], *w]


def _list_independent(rows: Sequence[Sequence[float]]) -> list[int]:
    """The first rows that do not follow from those before them."""
    found, basis = list[int](), list[list[float]]()
    for i, row in enumerate(rows):
        left = take_out(row, basis)
        square = sum(a * a for a in left)
        if square > _DEPENDENT * sum(a * a for a in row):
            found.append(i)
            basis.append([a / sqrt(square) for a in left])
    return found


def take_out(row: Sequence[float], basis: Sequence[Sequence[float]]) -> list[float]:
    """What is left of a row without its parts along orthonormal ones."""
    left = list(row)
    for one in basis:
        part = sum(a * b for a, b in zip(left, one, strict=True))
        left = [a - part * b for a, b in zip(left, one, strict=True)]
    return left


def reach(begin: Sequence[float], slopes: Sequence[Slip], aims: Sequence[float]) -> list[float] | None:
    """Velocities at which each slip is its aim times the largest of its slopes; None where one follows from others."""
    w, basis = list(begin), list[list[float]]()
    for aim, (slip, _, by) in zip(aims, slopes, strict=True):
        left = take_out(by, basis)
        square = sum(a * a for a in left)
        if not square > _DEPENDENT * sum(a * a for a in by):
            return None
        now = slip + sum(a * (b - c) for a, b, c in zip(by, w, begin, strict=True))
        step = (aim * max(map(abs, by)) - now) / square
        w = [a + step * b for a, b in zip(w, left, strict=True)]
        basis.append([a / sqrt(square) for a in left])
    return w


def find_way(ahead: Sequence[Sequence[float]], behind: Sequence[Sequence[float]], slight: float) -> list[float] | None:
    """The direction in which a slip grows, by its rates where it is along each unit vector and against it; None where friction is
    more than it takes, but for a ``slight`` part.

    The rates of a slip s are a - C s/|s|: where these are k s/|s|, (C + k) s/|s| = a, and the length of that is 1 for one k.
    """
    count = len(ahead)
    right = [0.5 * (a + b) for a, b in zip(ahead[0], behind[0], strict=True)]
    matrix = [[0.5 * (behind[j][i] - ahead[j][i]) for j in range(count)] for i in range(count)]

    def solve(k: float) -> list[float]:
        moved = [[x + (k if i == j else 0.0) for j, x in enumerate(row)] for i, row in enumerate(matrix)]
        return linear.solve(moved, right)

    def length(k: float) -> float:
        return sqrt(sum(part * part for part in solve(k)))

    try:
        if length(0.0) < 1.0 - slight:
            return None
        low, high = 0.0, 2.0 * count * max(map(abs, right), default=0.0)
        for _ in range(_HALVINGS):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if length(middle) > 1.0 else (low, middle)
        return solve(high)
    except ArithmeticError:
        return None
