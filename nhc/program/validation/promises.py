"""What each function has to give, as nodes that vanish: from T, U and the constraints, by no way that a program takes."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import tangent
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.formulate import rate_symbols
from nhc.mechanics.formulations import multipliers
from nhc.mechanics.frame import form_value, total_derivative
from nhc.program.planning.planner import Planner
from nhc.program.validation.reading_back import Reader, Stage
from nhc.records import record


@record
class Promise:
    """``nodes`` vanish at every state if a function keeps what it promises, its symbols solved for in ``stages``."""

    function: str
    nodes: tuple[Node, ...]
    stages: tuple[Stage, ...] = ()


class Promises:
    """Those of all functions that a reader has; ``planner`` says which velocities the state keeps."""

    def __init__(self, planner: Planner, reader: Reader) -> None:
        self.planner, self.reader = planner, reader
        self.system, self.graph = planner.system, planner.graph

    def collect(self) -> list[Promise]:
        """In the order of the functions."""
        found = {
            "rhs": self.rhs,
            "velocities": self.velocities,
            "accelerations": self.accelerations,
            "state": self.state,
            "residuals": self.residuals,
            "positions": self.positions,
            "reactions": self.reactions,
            "energy": self.energy,
            "jacobian": self.jacobian,
            "outputs": self.outputs,
        }
        return [make() for name, make in found.items() if name in self.reader.functions]

    def rhs(self) -> Promise:
        """q' are the velocities; w' are the rates of the kept forms along q' and q''."""
        system, n = self.system, self.system.n
        q1, q2, rates = self._rows("velocities", n), self._rows("accelerations", n), rate_symbols(system, system.v)
        values = [form_value(system, form) for form in self.planner.kept_forms()]
        seeds = dict(zip(system.v, rates, strict=True))
        along = [total_derivative(system, value, system.v, seeds) for value in values]
        expected = [*q1, *self._put(along, dict(zip(rates, q2, strict=True)))]
        return self._equal("rhs", expected, "velocities", "accelerations")

    def velocities(self) -> Promise:
        """The kept forms have the values that the state gives, and the constraints hold where velocities are left out."""
        system = self.system
        kept = self.planner.kept_forms()
        forms = [*kept, *(system.constraints if len(kept) < system.n else ())]
        nodes = self._put([form_value(system, form) for form in forms])
        for k, value in enumerate(self.planner.y_nodes[system.n :]):
            nodes[k] = self.graph.sub(nodes[k], value)
        return Promise("velocities", tuple(nodes), self._stages("velocities"))

    def accelerations(self) -> Promise:
        """d/dt of the constraints."""
        system = self.system
        rates = rate_symbols(system, system.v)
        rows = multipliers.constraint_rates(system, rates)
        return self._rows_vanish("accelerations", rows, rates, ())

    def reactions(self) -> Promise:
        """(I.4.1), straight from T: of the accelerations, too."""
        system = self.system
        rates, symbols = rate_symbols(system, system.v), multipliers.multiplier_symbols(system)
        return self._rows_vanish("reactions", multipliers.printed_rows(system, rates), rates, symbols)

    def _rows_vanish(self, name: str, rows: Sequence[Node], rates: Sequence[Node], symbols: Sequence[Node]) -> Promise:
        known = dict(zip(rates, self._rows("accelerations", self.system.n), strict=True))
        known |= dict(zip(symbols, self._rows(name, len(symbols)), strict=True))
        names = dict.fromkeys(("velocities", "accelerations", name))
        return Promise(name, tuple(self._put(rows, known)), self._stages(*names))

    def state(self) -> Promise:
        system = self.system
        kept = [form_value(system, form) for form in self.planner.kept_forms()]
        return self._equal("state", [*system.q, *kept])

    def residuals(self) -> Promise:
        return self._equal("residuals", [form_value(self.system, form) for form in self.system.constraints])

    def positions(self) -> Promise:
        equations = [form.equation for form in self.system.constraints]
        return self._equal("positions", [node for node in equations if node is not None])

    def energy(self) -> Promise:
        """T - U by all velocities."""
        system, found = self.system, self.reader.read("energy")
        assert found.result is not None
        node = self.graph.sub(found.result, self._put([self.graph.sub(system.T, system.U)])[0])
        return Promise("energy", (node,), self._stages("velocities", "energy"))

    def outputs(self) -> Promise:
        return self._equal("outputs", self._put([node for _, node in self.system.outputs]), "velocities")

    def jacobian(self) -> Promise:
        """Its product with a direction is the derivative of the right-hand side along that, through what is solved for."""
        g, y = self.graph, self.planner.y_nodes
        direction = [g.symbol(f"direction.{k}", "direction") for k in range(len(y))]
        rates, seeds = self.reader.read("rhs"), dict(zip(y, direction, strict=True))
        stages = [self._differentiate(stage, seeds) for stage in rates.stages]
        along = tangent(g, self._rows("rhs", len(y)), seeds)
        matrix, size = self.reader.read("jacobian"), len(y)
        rows = [[matrix.written.get(i * size + j, g.zero) for j in range(size)] for i in range(size)]
        nodes = [g.sub(g.dot(row, direction), slope) for row, slope in zip(rows, along, strict=True)]
        return Promise("jacobian", tuple(nodes), (*self._stages("rhs", "jacobian"), *stages))

    def _differentiate(self, stage: Stage, seeds: dict[Node, Node]) -> Stage:
        """The stage that gives the derivatives of a stage's symbols along the seeds, which they join."""
        g = self.graph
        turned = [tangent(g, row, seeds) for row in stage.matrix]
        slopes = [tangent(g, column, seeds) for column in stage.columns]
        columns = tuple(
            tuple(g.sub(own, g.dot(row, symbols)) for own, row in zip(slope, turned, strict=True))
            for slope, symbols in zip(slopes, stage.symbols, strict=True)
        )
        symbols = tuple(
            tuple(g.symbol(f"slope of {self._name(x)}", "unknown") for x in column) for column in stage.symbols
        )
        for old, new in zip(stage.symbols, symbols, strict=True):
            seeds.update(zip(old, new, strict=True))
        return Stage(stage.matrix, columns, symbols)

    # --- what they have in common -----------------------------------------------------------------------------

    def _name(self, symbol: Node) -> str:
        found = self.graph.symbol_of(symbol)
        assert found is not None
        return found.name

    def _rows(self, name: str, size: int) -> list[Node]:
        written = self.reader.read(name).written
        return [written.get(k, self.graph.zero) for k in range(size)]

    def _put(self, nodes: Sequence[Node], known: dict[Node, Node] | None = None) -> list[Node]:
        """Nodes over all velocities with those that the program computes, and what is ``known`` beside them."""
        q1 = dict(zip(self.system.v, self._rows("velocities", self.system.n), strict=True))
        return substitute(self.graph, nodes, {**q1, **(known or {})})

    def _stages(self, *names: str) -> tuple[Stage, ...]:
        return tuple(dict.fromkeys(stage for name in names for stage in self.reader.read(name).stages))

    def _equal(self, name: str, expected: Sequence[Node], *others: str) -> Promise:
        """What the function writes is what is expected, by what other functions give."""
        found = self._rows(name, len(expected))
        nodes = tuple(self.graph.sub(x, y) for x, y in zip(found, expected, strict=True))
        return Promise(name, nodes, self._stages(*others, name))
