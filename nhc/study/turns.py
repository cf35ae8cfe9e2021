"""Fields S y + s over the state that a steady motion may go along: turns, shifts, and both together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from nhc.study.units import Matrix, Vector


@dataclass(frozen=True, eq=False)
class Turn:
    """``matrix`` S of shape (NY, NY) and ``shift`` s of shape (NY,)."""

    matrix: Matrix
    shift: Vector

    def at(self, y: Sequence[float] | Vector) -> Vector:
        """S y + s."""
        return np.asarray(self.matrix @ np.asarray(y) + self.shift)

    def inside(self, states: Vector, time: float = 1.0) -> Turn:
        """The same over a state and a time that are measured in these units."""
        return Turn(self.matrix * time * states / states[:, None], self.shift * time / states)

    def outside(self, states: Vector, time: float = 1.0) -> Turn:
        """The reverse of :meth:`inside`."""
        return Turn(self.matrix * states[:, None] / states / time, self.shift * states / time)


def turn_of(generator: Mapping[tuple[int, int], Fraction], size: int) -> Turn:
    """From the entries (row, column) of S, with those of s in the column ``size``."""
    made = np.zeros((size, size + 1))
    for place, x in generator.items():
        made[place] = float(x)
    return Turn(made[:, :size], made[:, size])


def combined(speeds: Sequence[float] | Vector, turns: Sequence[Turn]) -> Turn:
    """The turns together, each at its speed."""
    matrix = sum(speed * turn.matrix for speed, turn in zip(speeds, turns, strict=True))
    shift = sum(speed * turn.shift for speed, turn in zip(speeds, turns, strict=True))
    return Turn(np.asarray(matrix), np.asarray(shift))
