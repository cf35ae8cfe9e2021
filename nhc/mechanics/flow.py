"""The field y' = f(y) of a formulation's equations as nodes, and its values and slopes at points of a prime field."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular, solve_columns_modulo, solve_modulo
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.associate import Equations
from nhc.mechanics.formulate import bordered_system
from nhc.mechanics.system import System


@dataclass(frozen=True)
class Flow:
    """y' = f(y), y = (q, w): q' = ``velocities``, and matrix @ (w', multipliers) = right."""

    equations: Equations
    y: tuple[Node, ...]
    velocities: tuple[Node, ...]
    matrix: tuple[tuple[Node, ...], ...]
    right: tuple[Node, ...]
    unknowns: tuple[Node, ...]

    @property
    def system(self) -> System:
        return self.equations.system

    @property
    def graph(self) -> Graph:
        return self.equations.system.graph

    @property
    def kept(self) -> int:
        """How many velocities the state holds."""
        return len(self.equations.motion.w)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The state's names: coordinates, then the kept velocities."""
        symbols = [self.graph.symbol_of(node) for node in self.y]
        return tuple(f"{s.name}'" if s.kind == "velocity" else s.name for s in symbols if s is not None)

    @cached_property
    def flat(self) -> tuple[Node, ...]:
        """The matrix row by row, then the right side."""
        return (*(x for row in self.matrix for x in row), *self.right)

    @cached_property
    def residual(self) -> tuple[Node, ...]:
        """right - matrix @ unknowns, zero on the motion."""
        g = self.graph
        return tuple(
            g.sub(value, g.dot(row, self.unknowns)) for row, value in zip(self.matrix, self.right, strict=True)
        )

    @cached_property
    def velocity_slopes(self) -> tuple[tuple[Node, ...], ...]:
        """d q'_i / d y_j."""
        return tuple(tuple(gradient(self.graph, node, self.y)) for node in self.velocities)

    @cached_property
    def residual_slopes(self) -> tuple[tuple[Node, ...], ...]:
        """d residual_k / d y_j at fixed unknowns; the rates' slopes are matrix^-1 times these."""
        return tuple(tuple(gradient(self.graph, node, self.y)) for node in self.residual)


def flow_of(equations: Equations) -> Flow:
    """The field of a formulation's equations."""
    motion = equations.motion
    if equations.multipliers:
        matrix, right = bordered_system(equations)
    else:
        matrix, right = [list(row) for row in equations.mass], list(equations.force)
    unknowns = (*motion.rates, *equations.multipliers)
    rows = tuple(tuple(row) for row in matrix)
    return Flow(equations, (*equations.system.q, *motion.w), motion.velocities, rows, tuple(right), unknowns)


def jacobian_residues(flow: Flow, point: FieldPoint) -> list[list[int]]:
    """df/dy at a point of a prime field, row by row; :class:`Unlucky` on a pole or where the model is singular."""
    size, n, p = len(flow.unknowns), flow.system.n, point.prime
    rows = [point.evaluate(row) for row in flow.velocity_slopes]
    if not size:
        return rows
    matrix = [point.evaluate(row) for row in flow.matrix]
    rates = dict(zip(flow.unknowns, solve_at(size, point.evaluate(flow.flat), p), strict=True))
    slopes = [point.evaluate(row, rates) for row in flow.residual_slopes]
    return [*rows[:n], *solve_columns_modulo(matrix, slopes, p)[: flow.kept]]


def solve_at(size: int, values: Sequence[int], prime: int) -> list[int]:
    """x with matrix @ x = right at a point, ``values`` being the residues of the matrix, row by row, and then of the right side.

    Raises:
        Unlucky: the matrix is singular there.
    """
    matrix = [values[k * size : (k + 1) * size] for k in range(size)]
    try:
        return solve_modulo(matrix, values[size * size :], prime)
    except Singular:
        raise Unlucky from None
