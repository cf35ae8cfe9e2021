"""The statements of a program as nodes again: what they compute, whatever was done to the equations before."""

from __future__ import annotations

from collections.abc import Mapping

from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.program.ir import (
    Binary,
    Call,
    Evaluate,
    Expr,
    Function,
    Let,
    Load,
    Negate,
    Number,
    Pi,
    Power,
    Ref,
    Result,
    Solve,
    Store,
    Sweep,
)
from nhc.records import record

Place = tuple[str, int]
"""An array and an index."""
Environment = dict[str, Node]
_FUNCTIONS = {"pow": "powf"}


@record
class Stage:
    """``matrix @ symbols[c] = columns[c]``, solved by the program when it runs."""

    matrix: tuple[tuple[Node, ...], ...]
    columns: tuple[tuple[Node, ...], ...]
    symbols: tuple[tuple[Node, ...], ...]


@record
class Read:
    """``written`` by index, zero where nothing is; a scalar ``result``; both hold the symbols of the ``stages``."""

    written: dict[int, Node]
    result: Node | None
    stages: tuple[Stage, ...]


class Reader:
    """Reads functions over the symbols that stand at the places of their arrays."""

    def __init__(self, graph: Graph, functions: Mapping[str, Function], places: Mapping[Place, Node]) -> None:
        self.graph, self.functions, self.places = graph, functions, places
        self._known = dict[str, Read]()

    def read(self, name: str) -> Read:
        """What the function of this name computes."""
        if name not in self._known:
            self._known[name] = self._read(self.functions[name])
        return self._known[name]

    def _read(self, function: Function) -> Read:
        env, places = Environment(), dict(self.places)
        written, stages = dict[int, Node](), list[Stage]()
        result = None
        for statement in function.body:
            if isinstance(statement, Evaluate):
                inner = self.read(statement.function)
                places |= {(statement.array, k): inner.written.get(k, self.graph.zero) for k in range(statement.size)}
                stages += [stage for stage in inner.stages if stage not in stages]
            elif isinstance(statement, Load):
                env[statement.name] = places[statement.array, statement.index]
            elif isinstance(statement, Let):
                env[statement.name] = self._node(statement.value, env)
            elif isinstance(statement, Solve):
                stages.append(self._stage(function.name, statement, env))
            elif isinstance(statement, Store):
                written[statement.index] = self._node(statement.value, env)
            elif isinstance(statement, Sweep):
                written |= self._sweep(statement, env)
            elif isinstance(statement, Result):
                result = self._node(statement.value, env)
        return Read(written, result, tuple(stages))

    def _stage(self, function: str, solve: Solve, env: Environment) -> Stage:
        for name in (name for column in solve.names for name in column):
            env[name] = self.graph.symbol(f"{function}.{name}", "unknown")
        return Stage(
            tuple(tuple(self._node(x, env) for x in row) for row in solve.matrix),
            tuple(tuple(self._node(x, env) for x in column) for column in solve.columns),
            tuple(tuple(env[name] for name in column) for column in solve.names),
        )

    def _sweep(self, sweep: Sweep, env: Environment) -> dict[int, Node]:
        """What all passes write."""
        g, inner, stores = self.graph, dict(env), list[tuple[int, Node]]()
        seeds = [g.symbol(f"seed.{name}", "direction") for name in sweep.seeds]
        inner.update(zip(sweep.seeds, seeds, strict=True))
        for statement in sweep.body:
            value = self._node(statement.value, inner)
            if isinstance(statement, Let):
                inner[statement.name] = value
            else:
                stores.append((statement.index, value))
        written = dict[int, Node]()
        for seed, offset in zip(seeds, sweep.offsets, strict=True):
            values = substitute(g, [node for _, node in stores], {x: g.one if x == seed else g.zero for x in seeds})
            written.update(zip((offset + index for index, _ in stores), values, strict=True))
        return written

    def _node(self, expr: Expr, env: Environment) -> Node:
        g = self.graph
        if isinstance(expr, Ref):
            return env[expr.name]
        if isinstance(expr, Number):
            return g.number(expr.value)
        if isinstance(expr, Pi):
            return g.pi()
        if isinstance(expr, Negate):
            return g.neg(self._node(expr.operand, env))
        if isinstance(expr, Power):
            return g.power(self._node(expr.base, env), expr.exponent)
        if isinstance(expr, Call):
            arguments = [self._node(x, env) for x in expr.arguments]
            return g.function(_FUNCTIONS.get(expr.function, expr.function), *arguments)
        return self._binary(expr, env)

    def _binary(self, expr: Binary, env: Environment) -> Node:
        g, x, y = self.graph, self._node(expr.left, env), self._node(expr.right, env)
        if expr.op == "+":
            return g.add(x, y)
        if expr.op == "-":
            return g.sub(x, y)
        return g.mul(x, y) if expr.op == "*" else g.div(x, y)
