"""Values, weights and rates of what stands on moving axes, along the motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from nhc.algebra.calculus import substitute, tangent
from nhc.algebra.graph import Node
from nhc.algebra.linear import NamedBlock
from nhc.mechanics.moving import Scene
from nhc.mechanics.turns import Path, Vector, add_vectors, change_axes, cross
from nhc.mechanics.vectors import Chained, Part


@dataclass(frozen=True)
class Solution:
    """The velocities over the held symbols, and over the symbols of blocks of equations that were solved together.

    A block's symbols are put in for its values where a result is finished, so that their rates come from the block's equations.
    """

    scene: Scene
    found: dict[Node, Node]  # of the velocities, and of the turned equations' symbols
    blocks: tuple[NamedBlock, ...]

    def along(self, symbol: Node) -> dict[Node, Node]:
        """Seeds of the derivative by a held symbol."""
        seeds = {symbol: self.scene.graph.one}
        for block in self.blocks:
            columns = tangent(self.scene.graph, block.values, seeds)
            seeds.update(zip(block.symbols, columns, strict=True))
        return seeds

    def columns(self, values: Sequence[Node], symbols: Sequence[Node]) -> list[list[Node]]:
        """The derivatives of the values by each of the held symbols."""
        return [tangent(self.scene.graph, values, self.along(symbol)) for symbol in symbols]

    def finish(self, values: Sequence[Node], on_motion: dict[Node, Node]) -> list[Node]:
        """Values with the blocks' symbols replaced by what they stand for."""
        g = self.scene.graph
        for block in reversed(self.blocks):
            own = substitute(g, block.values, on_motion)
            values = substitute(g, values, dict(zip(block.symbols, own, strict=True)))
        return list(values)


def on_motion(solution: Solution, held: dict[Node, Node], values: Sequence[Node]) -> list[Node]:
    """Values over the held symbols on the motion; what is proportional to one speed as the product with its weight.

    The weight is there already, and its rate is cheaper than that of a product of products.
    """
    scene, g = solution.scene, solution.scene.graph
    free = scene.held[scene.system.l :]
    columns = solution.columns(values, free)
    there = substitute(g, values, held)
    rest = substitute(g, there, {held[symbol]: g.zero for symbol in free})
    new = []
    for k, value in enumerate(there):
        own = [(column[k], held[symbol]) for column, symbol in zip(columns, free, strict=True) if column[k] != g.zero]
        new.append(g.mul(*own[0]) if len(own) == 1 and rest[k] == g.zero else value)
    return new


class Rates:
    """Accelerations of placed vectors on their home axes, with the rates of the kept velocities left out."""

    def __init__(self, solution: Solution, on_motion: dict[Node, Node], q_rates: Sequence[Node]) -> None:
        scene = solution.scene
        system, g = scene.system, scene.graph
        self.scene, self.solution, self._on_motion = scene, solution, on_motion
        self.seeds = {**dict(zip(system.q, q_rates, strict=True)), system.t: g.one}
        for block in solution.blocks:
            here = block.mapped(lambda nodes: substitute(g, nodes, on_motion))
            self.seeds.update(zip(block.symbols, here.rates(g, self.seeds), strict=True))
        self._known: dict[tuple[bool, Vector], Vector] = {}

    def value(self, vector: Vector) -> Vector:
        """Components on the motion."""
        x, y, z = self.on_motion(substitute(self.scene.graph, vector, self.solution.found))
        return x, y, z

    def on_motion(self, values: Sequence[Node]) -> list[Node]:
        """Values over the held symbols on the motion; what is proportional to one speed as the product with its weight."""
        return on_motion(self.solution, self._on_motion, values)

    def rate(self, vector: Vector) -> Vector:
        x, y, z = tangent(self.scene.graph, vector, self.seeds)
        return x, y, z

    def acceleration(self, vector: Chained, is_position: bool) -> Vector:
        key = (is_position, vector.components)
        if key not in self._known:
            self._known[key] = self._find(vector, is_position)
        return self._known[key]

    def _carried(self, velocity: Vector, path: Path) -> Vector:
        """d/dt of the components + Omega x components."""
        g = self.scene.graph
        return add_vectors(g, self.rate(velocity), cross(g, self.value(self.scene.spin(path)), velocity))

    def _find(self, vector: Chained, is_position: bool) -> Vector:
        scene, g = self.scene, self.scene.graph
        home = scene.home(vector, is_position)
        if home.settled or vector.base is None:
            return self._carried(self.value(home.velocity), home.path)
        at = scene.home(vector.base, is_position).path
        total = self.acceleration(vector.base, is_position)
        parts = list(vector.parts)
        for there in (at, home.path):
            total = change_axes(g, total, at, there)
            at = there
            for part in [p for p in parts if p.path == there]:
                total = add_vectors(g, total, self._local(part, is_position))
                parts.remove(part)
        for part in parts:
            total = add_vectors(g, total, change_axes(g, self._local(part, is_position), part.path, home.path))
        return total

    def _local(self, part: Part, is_position: bool) -> Vector:
        return self._carried(self.value(self.scene.local_velocity(part, is_position)), part.path)
