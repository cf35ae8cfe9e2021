"""States a little beside the jumps of dry friction, where a motion goes on that nothing holds any more."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from math import sqrt

from nhc.simulate.methods import linear

Slip = tuple[float, list[float], list[float]]
"""What a friction may hold, its slopes by time and positions, and those by the velocities that a job keeps."""
_ASIDE = 1e-12  # of the largest entry of a state
_DEPENDENT = 1e-12  # of its square, what is left of a row
_HALVINGS = 100


def put_aside(y: Sequence[float], n: int, slopes: Sequence[Slip], sides: Sequence[float]) -> list[float] | None:
    """A state near by with each slip on its side; None where there is none.

    What follows from others is on one side or the other by how far these are from their jumps.
    """
    size = _ASIDE * (max(map(abs, y), default=0.0) or 1.0)
    for lengths in product((1.0, 3.0), repeat=len(slopes)):
        aims = [side * length * size for side, length in zip(sides, lengths, strict=True)]
        w = reach(y[n:], slopes, aims)
        if w is not None:
            return [*y[:n], *w]
    return None


def reach(begin: Sequence[float], slopes: Sequence[Slip], aims: Sequence[float]) -> list[float] | None:
    """Velocities at which each slip is its aim times the largest of its slopes, or has that sign where it follows from others."""
    w, basis = list(begin), list[list[float]]()
    for aim, (slip, _, by) in zip(aims, slopes, strict=True):
        left = list(by)
        for one in basis:
            part = sum(a * b for a, b in zip(left, one, strict=True))
            left = [a - part * b for a, b in zip(left, one, strict=True)]
        square = sum(a * a for a in left)
        now = slip + sum(a * (b - c) for a, b, c in zip(by, w, begin, strict=True))
        if square > _DEPENDENT * sum(a * a for a in by):
            step = (aim * max(map(abs, by)) - now) / square
            w = [a + step * b for a, b in zip(w, left, strict=True)]
            basis.append([a / square**0.5 for a in left])
        elif not aim * now > 0.0:
            return None
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
