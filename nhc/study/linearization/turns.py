"""Fields S y + s over the state that a steady motion may go along: turns, shifts, and both together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.flow import Flow
from nhc.mechanics.properties.symmetry import Generator
from nhc.study.linearization.units import Matrix, Vector

AXIS = 1e-9
"""Of the way of a turn over a state of the usual size: what goes less lies on its axis."""


@dataclass(frozen=True, eq=False)
class Turn:
    """``matrix`` S of shape (NY, NY) and ``shift`` s of shape (NY,)."""

    matrix: Matrix
    shift: Vector

    def at(self, y: Sequence[float] | Vector) -> Vector:
        """S y + s."""
        return np.asarray(self.matrix @ np.asarray(y) + self.shift)

    def moves(self, y: Sequence[float] | Vector, rest: Sequence[int]) -> bool:
        """Whether it moves these entries of a state: what lies on its axis, as well as that is found, it does not."""
        reach = np.linalg.norm(self.matrix) * (1.0 + np.linalg.norm(y)) + np.linalg.norm(self.shift)
        return bool(np.linalg.norm(self.at(y)[list(rest)]) > AXIS * reach)

    def inside(self, states: Vector, time: float = 1.0) -> Turn:
        """The same over a state and a time that are measured in these units."""
        return Turn(self.matrix * time * states / states[:, None], self.shift * time / states)

    def outside(self, states: Vector, time: float = 1.0) -> Turn:
        """The reverse of :meth:`inside`."""
        return Turn(self.matrix * states[:, None] / states / time, self.shift * states / time)


def turn_of(graph: Graph, generator: Generator, size: int, parameters: Mapping[Node, float]) -> Turn:
    """From the entries (row, column) of S, with those of s in the column ``size``, at the parameters' values.

    Parameters that make all entries small, or large, do not make the turn so.
    """
    made = np.zeros((size, size + 1))
    for place, x in zip(generator, evaluate(graph, list(generator.values()), dict(parameters)), strict=True):
        made[place] = float(x)
    if any(graph.deps[x] for x in generator.values()):
        made /= np.max(np.abs(made)) or 1.0
    return Turn(made[:, :size], made[:, size])


def combined(speeds: Sequence[float] | Vector, turns: Sequence[Turn]) -> Turn:
    """The turns together, each at its speed."""
    matrix = sum(speed * turn.matrix for speed, turn in zip(speeds, turns, strict=True))
    shift = sum(speed * turn.shift for speed, turn in zip(speeds, turns, strict=True))
    return Turn(np.asarray(matrix), np.asarray(shift))


def list_rates(turn: Turn | None, flow: Flow) -> list[tuple[tuple[str, ...], float]]:
    """What axes that go along a turn do: a coordinate moves, a pair of entries of the state turns, at a rate.

    Turns of quaternions are left out; their angular velocities stand in the state.
    """
    if turn is None:
        return []
    count, names = len(flow.y), flow.names
    quaternions = {flow.system.q_names[i] for rotation in flow.system.rotations for i in rotation.places}
    entries: list[tuple[tuple[int, ...], float]] = [((i,), turn.shift[i]) for i in range(count)]
    entries += [((c, r), turn.matrix[r, c]) for r in range(count) for c in range(r)]
    least = 1e-9 * max((abs(rate) for _, rate in entries), default=0.0)
    return [
        (tuple(names[i] for i in places), float(rate))
        for places, rate in entries
        if abs(rate) > least and not {names[i].removesuffix("'") for i in places} & quaternions
    ]
