"""The velocities from which bodies in space are built up, along a motion: of coordinates, and angular ones of rotations.

While vectors are read, the entries of a rotation's matrix and its angular velocity are symbols, as in the reverse sweeps.  On the
motion each velocity is one of the kept ones or a form over these, which a constraint gives: where the constraint is local to one
body, so is its form, and the recursion goes on from it.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import tangent
from nhc.algebra.graph import SYM, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import linear_form
from nhc.mechanics.motion import Motion
from nhc.mechanics.rotations.turns import Vector, cross
from nhc.mechanics.system import System
from nhc.mechanics.trees.covectors import Sweeps
from nhc.mechanics.trees.recursion import Terms


class Rates:
    """``symbols`` are the velocities of coordinates that belong to no rotation, then the angular ones; ``entries`` are the
    matrices by their rows.
    """

    def __init__(self, system: System, motion: Motion) -> None:
        self.system, self.motion = system, motion
        g = self.graph = system.graph
        self._sweeps = sweeps = Sweeps(system, motion.velocities)
        self.entries: list[list[Vector]] = [
            [(own[3 * i], own[3 * i + 1], own[3 * i + 2]) for i in range(3)] for own in sweeps.entries
        ]
        self.omega: list[Vector] = [(own[0], own[1], own[2]) for own in sweeps.omega]
        matrices = [entry for r in system.rotations for row in r.matrix for entry in row]
        flat = [entry for own in sweeps.entries for entry in own]
        turns = [w for own in self.omega for w in own]
        plain = [k for k in range(system.n) if k not in sweeps.quaternions]
        self.symbols = (*(system.v[k] for k in plain), *turns)
        values = [*(motion.velocities[k] for k in plain), *(w for turning in sweeps.turning for w in turning)]
        self.values = dict(zip(self.symbols, values, strict=True))
        self.meaning = {**dict(zip(flat, matrices, strict=True)), **self.values}
        self.unbound = dict(
            zip((*flat, *turns), (*matrices, *(w for r in system.rotations for w in r.omega)), strict=True)
        )
        self.moving = g.mask((*(system.q[k] for k in plain), system.t, *flat))
        self._turned_by = g.mask(flat)
        self._quaternions = g.mask([x for r in system.rotations for x in (*r.e, *r.v)])
        self.seeds = {**{system.q[k]: system.v[k] for k in plain}, system.t: g.one}
        for k, (matrix, omega) in enumerate(zip(self.entries, self.omega, strict=True)):
            self.seeds.update(self._turned(matrix, omega, system.rotations[k].sign))

    def _turned(self, matrix: Sequence[Vector], omega: Vector, sign: int) -> dict[Node, Node]:
        """R' = R [omega] or [omega] R over the symbols."""
        g = self.graph
        if sign > 0:
            rows = [cross(g, row, omega) for row in matrix]
            return {a: b for row, moved in zip(matrix, rows, strict=True) for a, b in zip(row, moved, strict=True)}
        columns = [(matrix[0][j], matrix[1][j], matrix[2][j]) for j in range(3)]
        pairs = [(column, cross(g, omega, column)) for column in columns]
        return {a: b for column, moved in pairs for a, b in zip(column, moved, strict=True)}

    def named(self, nodes: Sequence[Node]) -> list[Node] | None:
        """The nodes over the symbols; None where they have more of a quaternion than these."""
        found = substitute(self.graph, nodes, self._sweeps.words) if self._sweeps.words else list(nodes)
        return None if any(self.graph.depends(node, self._quaternions) for node in found) else found

    def is_entry(self, node: Node) -> bool:
        """Whether it is one of the symbols."""
        return self.graph.op[node] == SYM and self.has_entries(node)

    def has_entries(self, node: Node) -> bool:
        """Whether a rotation turns it."""
        return self.graph.depends(node, self._turned_by)

    def on_motion(self, nodes: Sequence[Node]) -> list[Node]:
        """The nodes over coordinates and kept velocities."""
        return substitute(self.graph, nodes, self.meaning, named=False)

    def form(self, symbol: Node) -> tuple[Terms, Node, Node]:
        """A velocity over the kept ones, its constant, and its rate where these have none.

        Raises:
            NotLinear: it is not seen to be linear.
        """
        g, value = self.graph, self.values[symbol]
        coefficients, constant = linear_form(g, value, self.motion.w)
        (turn,) = tangent(g, [value], self._sweeps.seeds)
        return {i: a for i, a in enumerate(coefficients) if a != g.zero}, constant, turn
