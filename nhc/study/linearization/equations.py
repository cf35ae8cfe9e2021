"""The equations of a steady motion, in doubles and in many digits, and the directions in which a search may go."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from nhc.algebra.calculus import gradient
from nhc.algebra.evaluate import Mpmath, evaluate_into
from nhc.algebra.graph import Node
from nhc.algebra.walks import reachable
from nhc.study.linearization.field import RANK, Hold, SteadyModel
from nhc.study.linearization.roots import Equations
from nhc.study.linearization.turns import Turn, combined
from nhc.study.linearization.units import Matrix, Vector, normal


def turned(model: SteadyModel, turns: Sequence[Turn], y: Vector) -> tuple[list[float], SteadyModel]:
    """The state, and the model on axes that go along with its turns."""
    state, turning = _parted(model, turns, y)
    return state, model if turning is None else replace(model, turning=turning)


def _parted(model: SteadyModel, turns: Sequence[Turn], y: Vector) -> tuple[list[float], Turn | None]:
    """The state, and the turn that goes with it."""
    count = len(model.flow.y)
    state = [float(x) for x in y[:count]]
    if not turns:
        return state, None
    return state, combined(y[count:], turns)


def equations(
    model: SteadyModel, turns: Sequence[Turn], y: Vector, holds: Sequence[Hold]
) -> tuple[Vector, Matrix, float]:
    """Rates of the rest, conditions and holds, with their slopes and the size that rounding is measured by."""
    state, own = turned(model, turns, y)
    rates, jacobian = own.field(state)
    off, across = model.conditions(state)
    rest = list(model.rest)
    wanted = np.array([model.value(state, hold.node) - hold.value for hold in holds])
    rows = [model.slopes(state, hold.node) for hold in holds]
    held = np.array(rows).reshape(len(holds), len(state))
    scale = max(1.0, float(np.max(np.abs(jacobian[rest]), initial=0.0)))
    for numbers, slopes in ((off, across), (wanted, held)):
        factors = normal(slopes)
        numbers *= factors
        slopes *= factors[:, None]
    slopes = np.vstack([jacobian[rest], across, held])
    by_speed = np.zeros((len(slopes), len(turns)))
    for k, turn in enumerate(turns):
        by_speed[: len(rest), k] = -turn.at(state)[rest]
    return np.concatenate([rates[rest], off, wanted]), np.hstack([slopes, by_speed]), scale


def bound(model: SteadyModel, y: Vector, set_by: Matrix) -> Matrix:
    """Directions (rows over y) in which the steps do not go: across the leaf, but for what other equations set."""
    found = model.normals([float(x) for x in y[: len(model.flow.y)]])
    if found is None or not len(found):
        return np.zeros((0, len(y)))
    normals = np.hstack([found, np.zeros((len(found), len(y) - found.shape[1]))])
    lengths = np.linalg.norm(set_by, axis=1)
    shares = set_by @ normals.T
    own = shares[np.linalg.norm(shares, axis=1) > (1.0 - 1e-9) * lengths]
    return np.asarray(_null_rows(own) @ normals) if own.any() else normals


def _null_rows(matrix: Matrix) -> Matrix:
    """Orthonormal rows that span the null space."""
    _, sizes, right = np.linalg.svd(matrix)
    return np.asarray(right[int(np.sum(sizes > RANK * sizes[0])) :])


def all_but(across: Matrix, size: int) -> Matrix:
    """Orthonormal rows over all directions but those of ``across``."""
    return np.asarray(np.linalg.svd(across)[2][len(across) :]) if len(across) else np.eye(size)


def exact_equations(model: SteadyModel, turns: Sequence[Turn], holds: Sequence[Hold]) -> Equations:
    """Rates of the rest, conditions and holds over the state, and the speeds of ``turns`` after it, in the model's units.

    The parameters are the doubles that they are.
    """
    return _Exact(model, turns, holds).at


class _Exact:
    """The equations of a steady motion in mpmath's numbers.

    ``conditions`` are the nodes that shall have the values ``wanted``, ``across`` their slopes by the state.
    """

    def __init__(self, model: SteadyModel, turns: Sequence[Turn], holds: Sequence[Hold]) -> None:
        import mpmath

        self.mp: Any = mpmath  # imported late: most searches do without
        self.model, self.turns, flow = model, turns, model.flow
        nodes, across = model.conditions_as_nodes
        self.conditions = (*nodes, *(hold.node for hold in holds))
        self.across = (*across, *(tuple(gradient(flow.graph, hold.node, flow.y)) for hold in holds))
        self.wanted = [0.0] * len(nodes) + [hold.value for hold in holds]
        self.units = [1.0] * len(flow.y) if model.units is None else list(model.units.states)
        before = [*flow.velocities, *flow.right, *(x for row in (*flow.matrix, *self.across) for x in row)]
        self.before = reachable(flow.graph, [*before, *self.conditions])
        """What is known before the accelerations and multipliers are."""
        met, slopes = set(self.before), [x for row in (*flow.velocity_slopes, *flow.residual_slopes) for x in row]
        self.after = [node for node in reachable(flow.graph, slopes) if node not in met]

    def at(self, place: Sequence[Any]) -> tuple[list[Any], list[list[Any]]]:
        """What is left of each equation at a place, and its slopes by the state and the speeds of the turns."""
        known, rates, slopes = self._rates(place)
        values, rows = list[Any](), list[list[Any]]()
        for i in self.model.rest:
            value, row = self._still(i, place, rates[i], slopes[i])
            values.append(value)
            rows.append(row)
        no_turns = [self.mp.mpf(0)] * len(self.turns)
        for node, row_nodes, value in zip(self.conditions, self.across, self.wanted, strict=True):
            values.append(known[node] - value)
            rows.append([known[x] * unit for x, unit in zip(row_nodes, self.units, strict=True)] + no_turns)
        return values, rows

    def _rates(self, place: Sequence[Any]) -> tuple[dict[Node, Any], list[Any], list[list[Any]]]:
        """The values of all nodes at a place, the rates of the state, and their slopes by it."""
        mp, flow, arithmetic = self.mp, self.model.flow, Mpmath()
        known: dict[Node, Any] = {flow.system.t: mp.mpf(0)}
        known.update((symbol, mp.mpf(x)) for symbol, x in zip(flow.system.p, self.model.p, strict=True))
        known.update((symbol, x * unit) for symbol, x, unit in zip(flow.y, place, self.units, strict=False))
        evaluate_into(known, flow.graph, self.before, arithmetic)
        solve = _solver(mp, [[known[x] for x in row] for row in flow.matrix])
        solution = solve([known[x] for x in flow.right])
        known.update(zip(flow.unknowns, solution, strict=True))
        evaluate_into(known, flow.graph, self.after, arithmetic)
        columns = [solve([known[row[j]] for row in flow.residual_slopes]) for j in range(len(flow.y))]
        slopes = [[known[x] for x in row] for row in flow.velocity_slopes]
        slopes += [[column[k] for column in columns] for k in range(flow.kept)]
        return known, [*(known[x] for x in flow.velocities), *solution[: flow.kept]], slopes

    def _still(self, i: int, place: Sequence[Any], rate: Any, slopes: Sequence[Any]) -> tuple[Any, list[Any]]:
        """The rate of entry i on axes that go along with the turns, and its slopes by the state and by their speeds."""
        tick, unit, speeds = self.model.tick, self.units[i], place[len(self.units) :]
        along = [
            sum(
                (self.mp.mpf(float(x)) * y for x, y in zip(turn.matrix[i], place, strict=False)),
                self.mp.mpf(float(turn.shift[i])),
            )
            for turn in self.turns
        ]
        value = rate * tick / unit - sum(a * w for a, w in zip(along, speeds, strict=True))
        row = [x * tick * own / unit for x, own in zip(slopes, self.units, strict=True)]
        for turn, speed in zip(self.turns, speeds, strict=True):
            row = [x - float(turn.matrix[i, j]) * speed for j, x in enumerate(row)]
        return value, [*row, *(-a for a in along)]


def _solver(mp: Any, matrix: Sequence[Sequence[Any]]) -> Any:
    """x with matrix @ x = right, by one decomposition for all right sides."""
    if not matrix:
        return lambda right: []
    made, order = mp.mp.LU_decomp(mp.matrix([list(row) for row in matrix]))
    return lambda right: list(mp.mp.U_solve(made, mp.mp.L_solve(made, mp.matrix(right), order)))
