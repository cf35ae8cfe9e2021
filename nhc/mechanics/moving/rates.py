"""Values, weights and rates of what stands on moving axes, along the motion."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from nhc.algebra.calculus import Derivation, tangent
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import Replacement, substitute
from nhc.algebra.solving.linear import NamedBlock
from nhc.mechanics.moving.axes import Setting
from nhc.mechanics.moving.vectors import Chained, Part
from nhc.mechanics.rotations.turns import Path, Vector, add_vectors, climb, cross
from nhc.records import fresh, record


@record
class Solution:
    """The velocities over the held symbols, and over the symbols of blocks of equations that were solved together.

    A block's symbols are put in for its values where a result is finished, so that their rates come from the block's equations.
    """

    setting: Setting
    found: dict[Node, Node]  # of the velocities, and of the turned equations' symbols
    blocks: tuple[NamedBlock, ...]
    _derivations: dict[Node, Derivation] = fresh(factory=dict)

    @cached_property
    def _solved(self) -> Replacement:
        return Replacement(self.setting.graph, self.found)

    def put(self, values: Sequence[Node]) -> list[Node]:
        """Values with the velocities put in."""
        return self._solved.of(values)

    def along(self, symbol: Node) -> dict[Node, Node]:
        """Seeds of the derivative by a held symbol."""
        seeds = {symbol: self.setting.graph.one}
        for block in self.blocks:
            columns = tangent(self.setting.graph, block.values, seeds)
            seeds.update(zip(block.symbols, columns, strict=True))
        return seeds

    def columns(self, values: Sequence[Node], symbols: Sequence[Node]) -> list[list[Node]]:
        """The derivatives of the values by each of the held symbols."""
        found = []
        for symbol in symbols:
            derivation = self._derivations.get(symbol)
            if derivation is None:
                derivation = self._derivations[symbol] = Derivation(self.setting.graph, self.along(symbol))
            found.append([derivation.of(value) for value in values])
        return found

    def finish(self, values: Sequence[Node], on_motion: dict[Node, Node]) -> list[Node]:
        """Values with the blocks' symbols replaced by what they stand for."""
        g = self.setting.graph
        for block in reversed(self.blocks):
            own = substitute(g, block.values, on_motion)
            values = substitute(g, values, dict(zip(block.symbols, own, strict=True)))
        return list(values)


class OnMotion:
    """Values over the held symbols on the motion; what is proportional to one speed as the product with its weight.

    The weight is there already, and its rate is cheaper than that of a product of products.
    """

    def __init__(self, solution: Solution, held: dict[Node, Node]) -> None:
        setting, g = solution.setting, solution.setting.graph
        self.solution, self.held = solution, held
        self._free = setting.held[setting.system.l :]
        self.there = Replacement(g, held)
        self._rest = Replacement(g, {held[symbol]: g.zero for symbol in self._free}, named=False)

    def of(self, values: Sequence[Node]) -> list[Node]:
        """The values on the motion."""
        g, held = self.solution.setting.graph, self.held
        columns = self.solution.columns(values, self._free)
        there = self.there.of(values)
        rest = self._rest.of(there)
        new = []
        for k, value in enumerate(there):
            own = [(column[k], held[symbol]) for column, symbol in zip(columns, self._free, strict=True) if column[k]]
            new.append(g.mul(*own[0]) if len(own) == 1 and not rest[k] else value)
        return new


class Rates:
    """Accelerations of placed vectors on their home axes, with the rates of the kept velocities left out."""

    def __init__(self, on_motion: OnMotion, q_rates: Sequence[Node]) -> None:
        solution = on_motion.solution
        setting = solution.setting
        system, g = setting.system, setting.graph
        self.setting, self.solution, self._on_motion = setting, solution, on_motion
        self.seeds = {**dict(zip(system.q, q_rates, strict=True)), system.t: g.one}
        for block in solution.blocks:
            here = block.mapped(on_motion.there.of)
            self.seeds.update(zip(block.symbols, here.rates(g, self.seeds), strict=True))
        self._known: dict[tuple[bool, Vector], Vector] = {}
        self._derivation = Derivation(g, self.seeds)

    def value(self, vector: Vector) -> Vector:
        """Components on the motion."""
        x, y, z = self.on_motion(self.solution.put(vector))
        return x, y, z

    def on_motion(self, values: Sequence[Node]) -> list[Node]:
        """Values over the held symbols on the motion; what is proportional to one speed as the product with its weight."""
        return self._on_motion.of(values)

    def rate(self, vector: Vector) -> Vector:
        x, y, z = (self._derivation.of(node) for node in vector)
        return x, y, z

    def acceleration(self, vector: Chained, is_position: bool) -> Vector:
        key = (is_position, vector.components)
        if key not in self._known:
            self._known[key] = self._find(vector, is_position)
        return self._known[key]

    def _carried(self, velocity: Vector, path: Path) -> Vector:
        """d/dt of the components + Omega x components."""
        g = self.setting.graph
        return add_vectors(g, self.rate(velocity), cross(g, self.value(self.setting.spin(path)), velocity))

    def _find(self, vector: Chained, is_position: bool) -> Vector:
        setting, g = self.setting, self.setting.graph
        home = setting.home(vector, is_position)
        if home.settled or vector.base is None:
            return self._carried(self.value(home.velocity), home.path)
        at = setting.home(vector.base, is_position).path
        start = self.acceleration(vector.base, is_position)
        local = [(part.path, self._local(part, is_position)) for part in vector.parts]
        return climb(g, start, at, home.path, local)

    def _local(self, part: Part, is_position: bool) -> Vector:
        return self._carried(self.value(self.setting.local_velocity(part, is_position)), part.path)
