"""Plan -> Function: nodes become lets and expressions, in an order in which everything is known when it is used.

A node gets a name when it is used twice, when the user named it, or when the expression would become too long to
read.  Parameter-only work comes first, under its own section.  Dead code does not arise: only what the targets,
guards and solves need is visited.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from fractions import Fraction

from nhc.algebra.graph import ADD, BINARY, MUL, NEG, NUM, PI, POW, SYM, UNARY, Graph, Node
from nhc.algebra.walks import reachable
from nhc.program.contents import count_operations
from nhc.program.ir import (
    Binary,
    Call,
    Evaluate,
    Expr,
    Function,
    Guard,
    Let,
    Load,
    Negate,
    Number,
    Pi,
    Power,
    Ref,
    Result,
    Section,
    Solve,
    Statement,
    Store,
    Sweep,
)
from nhc.program.lowering.named_nodes import choose_names, find_constants, find_shared, find_turned
from nhc.program.lowering.naming import Namer
from nhc.program.lowering.powers import part_powers
from nhc.program.plan import FunctionPlan, GuardPlan, SolvePlan, SweepPlan

_MANY = 150  # lets beyond which results are stored as soon as they are known
_ONE = Fraction(1)
PRIMES = {"velocity": "'", "rate": "'", "acceleration": "''"}
"""What the spec writes behind the name of a symbol of that kind."""


class Lowering:
    """Lowers one plan."""

    def __init__(self, graph: Graph, plan: FunctionPlan, parameters: Iterable[Node]) -> None:
        self.graph, self.plan = graph, plan
        self.parameter_mask = graph.mask(tuple(parameters))
        reserved = {argument.name for argument in plan.inputs} | ({plan.output.name} if plan.output else set())
        reserved |= {array for _, array, _ in plan.calls}
        self.namer = Namer(graph, reserved)
        self.names: dict[Node, str] = {}
        self.body: list[Statement] = []
        self.needed, self.kids = self._arrange(reachable(graph, plan.roots()))
        self.waiting: set[Node] = set()
        self.turned: dict[Node, Node] = {}
        self._done: set[Node] = set()
        self.swept = graph.mask([seed for sweep in plan.sweeps for seed in sweep.seeds])
        self._unknowns = [graph.mask([s for column in solve.symbols for s in column]) for solve in plan.solves]
        self._refs: dict[str, Ref] = {}

    def _arrange(self, needed: list[Node]) -> tuple[Sequence[Node], Sequence[tuple[Node, ...]]]:
        """What is needed in an order in which it can be computed, and the operands of all nodes."""
        return part_powers(self.graph, needed)

    # --- which nodes get a name -----------------------------------------------------------------------------

    def _stage(self, guard: GuardPlan) -> int:
        """0 before any solve, k + 1 for what uses the unknowns of solve k."""
        deps = self.graph.deps[guard.value] | self.graph.deps[guard.scale]
        return max((k + 1 for k, mask in enumerate(self._unknowns) if deps & mask), default=0)

    def _constant(self, node: Node) -> bool:
        deps = self.graph.deps[node]
        return not deps & ~self.parameter_mask and (deps != 0 or bool(self.graph.kids[node]))

    def choose_names(self) -> list[Node]:
        """The nodes that become lets, in increasing order."""
        boundary = set[Node]()
        if "shared reciprocals" not in self.graph.off:
            boundary = find_constants(self.graph, self.kids, self.needed, self.parameter_mask)
        if self.swept:
            boundary |= find_shared(self.graph, self.needed, self.swept)
        return choose_names(self.graph, self.kids, self.needed, self.plan.roots(), boundary)

    # --- statements ---------------------------------------------------------------------------------------

    def lower(self) -> Function:
        """Each let stands where it is first needed, so that few values live at once; guards come before the results."""
        self._load()
        lets = self.choose_names()
        self._turn(set(lets))
        self._parameter_section([n for n in lets if self._constant(n)])
        self.waiting = {n for n in lets if not self._constant(n)}
        for stage in range(len(self.plan.solves) + 1):
            if stage:
                solve = self.plan.solves[stage - 1]
                self._prepare([n for row in (*solve.matrix, *solve.columns) for n in row])
                self._solve(solve)
            for guard in dict.fromkeys(self.plan.guards):  # several rates may be divided by one mass
                if self._stage(guard) == stage:
                    self._prepare([guard.value, guard.scale])
                    self._guard(guard)
        self._store(interleaved=len(self.waiting) > _MANY)
        for sweep in self.plan.sweeps:
            self._sweep(sweep)
        return self._function()

    def _turn(self, named: Collection[Node]) -> None:
        targets = [target.node for target in self.plan.targets]
        self.turned = find_turned(self.graph, self.kids, targets, self.plan.roots(), self.needed, named, self._constant)

    def _prepare(self, roots: Iterable[Node]) -> None:
        """Write the lets that the roots need and that are not written yet, each after those that it needs itself."""
        kids, names, done = self.kids, self.names, self._done
        for root in roots:
            if root in done:
                continue
            stack = [root]
            while stack:
                node = stack[-1]
                ready = True
                for child in reversed(kids[node]):
                    if child not in done and kids[child] and child not in names:
                        stack.append(child)
                        ready = False
                if not ready:
                    continue
                stack.pop()
                if node in done:
                    continue
                done.add(node)
                if node in self.waiting:
                    self.waiting.discard(node)
                    self._let(node)

    def _load(self) -> None:
        self.body += [Evaluate(*call) for call in self.plan.calls]
        present = set(self.needed)
        wanted = [(symbol, place) for symbol, place in self.plan.loads.items() if symbol in present]
        for symbol, (array, index, about) in wanted:
            self.names[symbol] = array if index < 0 else self.namer.symbol(symbol)  # a scalar argument is its own name
            self.body.append(Load(self.names[symbol], array, index, about, self._written(symbol)))

    def _written(self, symbol: Node) -> str:
        """The symbol as the spec writes it."""
        found = self.graph.symbol_of(symbol)
        assert found is not None
        return found.name + PRIMES.get(found.kind, "")

    def _parameter_section(self, lets: list[Node]) -> None:
        if lets:
            self.body.append(Section("from the parameters alone"))
            for node in lets:
                self._let(node)
        inputs = {argument.name for argument in self.plan.inputs}
        known = "coordinates and velocities" if "qdot" in inputs else "coordinates" if "q" in inputs else "state"
        self.body.append(Section(f"from the {known}"))

    def _let(self, node: Node) -> None:
        value = self._opposite(node) if node in self.turned.values() else self._whole(node)
        self.names[node] = self.namer.node(node, self._constant(node))
        self.body.append(Let(self.names[node], value))

    def _guard(self, guard: GuardPlan) -> None:
        value, scale = self.expression(guard.value), self.expression(guard.scale)
        self.body.append(Guard(value, scale, guard.tolerance, guard.status, guard.what))

    def _solve(self, solve: SolvePlan) -> None:
        names = []
        for column in solve.symbols:
            for symbol in column:
                self.names[symbol] = self.namer.symbol(symbol)
            names.append(tuple(self.names[symbol] for symbol in column))
        self.body.append(
            Solve(
                tuple(tuple(self.expression(n) for n in row) for row in solve.matrix),
                tuple(tuple(self.expression(n) for n in column) for column in solve.columns),
                tuple(names),
                solve.tolerance,
                solve.status,
                solve.what,
                solve.plain,
            )
        )

    def _store(self, *, interleaved: bool) -> None:
        """The results: together at the end, or in a long function each as soon as it is known."""
        plan = self.plan
        if not interleaved:
            self._prepare([target.node for target in plan.targets])
        for target in plan.targets:
            assert plan.output is not None
            self._prepare([target.node])
            value = self._whole(target.node)
            self.body.append(Store(plan.output.name, target.index, value, target.about, target.origin))
        if plan.result is not None:
            self._prepare([plan.result])
            self.body.append(Result(self.expression(plan.result)))

    def _sweep(self, sweep: SweepPlan) -> None:
        """Everything the passes share, then the sweep with its own lets."""
        own = reachable(self.graph, [target.node for target in sweep.targets], self.graph.mask(sweep.seeds))
        kids, deps, swept = self.graph.kids, self.graph.deps, self.swept
        self._prepare([child for node in own for child in kids[node] if not deps[child] & swept])
        for seed in sweep.seeds:
            self.names[seed] = self.namer.symbol(seed)
        outer, self.body = self.body, []
        for target in sweep.targets:
            self._prepare([target.node])
            value = self.expression(target.node)
            assert self.plan.output is not None
            self.body.append(Store(self.plan.output.name, target.index, value, target.about, target.origin))
        inner, self.body = self.body, outer
        names = tuple(self.names[seed] for seed in sweep.seeds)
        kept = tuple(statement for statement in inner if isinstance(statement, Let | Store))
        self.body.append(Sweep(sweep.about, names, sweep.offsets, kept))

    def _function(self) -> Function:
        plan, body = self.plan, tuple(self.body)
        return Function(plan.name, plan.about, plan.inputs, plan.output, body, plan.equation, *count_operations(body))

    # --- expressions ----------------------------------------------------------------------------------------

    def expression(self, node: Node) -> Expr:
        """The node in terms of names; depth is bounded because long expressions were given names."""
        name = self.names.get(node)
        if name is not None:
            known = self._refs.get(name)
            if known is None:
                known = self._refs[name] = Ref(name)
            return known
        g, op = self.graph, self.graph.op[node]
        if op == ADD:
            return self._sum(g.a[node], g.b[node])
        if op == MUL:
            return self._product(g.a[node], g.b[node])
        if op == NEG:
            return self._negated(g.a[node])
        if op == NUM:
            value = g.value(node)
            assert value is not None
            return Number(value)
        if op == PI:
            return Pi()
        if op == SYM:
            raise KeyError(f"`{g.symbols[g.a[node]].name}` is not an argument of `{self.plan.name}`")
        if op == POW:
            return self._power_of(node)
        assert op in UNARY or op in BINARY
        inner = g.a[node]
        if op == "sqrt" and g.op[inner] == POW and g.b[inner] == 2 and inner not in self.names:
            # what exact tests take for a root, doubles may know better
            return Call("abs", (self.expression(g.a[inner]),))
        return Call("pow" if op == "powf" else op, tuple(self.expression(c) for c in g.children(node)))

    def _whole(self, node: Node) -> Expr:
        """The expression of a statement; ``x * v * v`` needs no copy of v where x is not needed again, ``x * (v * v)`` does."""
        g = self.graph
        if g.op[node] == MUL and node not in self.names:
            for x, y in (g.kids[node], g.kids[node][::-1]):
                if g.op[y] == POW and y not in self.names and g.b[y] == 2:
                    factor = self.expression(g.a[y])
                    return Binary("*", Binary("*", self.expression(x), factor), factor)
        return self.expression(node)

    def _opposite(self, node: Node) -> Expr:
        """Minus a node, the sign at its first factor."""
        value = self.expression(node)
        return (
            Binary(value.op, Negate(value.left), value.right)
            if isinstance(value, Binary) and value.op in "*/"
            else Negate(value)
        )

    def _negated(self, inner: Node) -> Expr:
        g = self.graph
        if inner in self.turned and inner not in self.names:
            return self.expression(inner)  # the constant among its factors has the sign
        if self._is_difference(inner):
            return self._swapped(inner)
        if g.op[inner] == MUL and inner not in self.names:
            for x, y in (g.kids[inner], g.kids[inner][::-1]):
                if self._is_difference(x):
                    by = self._denominator(y)
                    return (
                        Binary("/", self._swapped(x), by) if by else Binary("*", self._swapped(x), self.expression(y))
                    )
        return Negate(self.expression(inner))

    def _is_difference(self, node: Node) -> bool:
        g = self.graph
        return g.op[node] == ADD and node not in self.names and g.op[g.b[node]] == NEG

    def _swapped(self, difference: Node) -> Expr:
        """-(x - y) = y - x."""
        g = self.graph
        return Binary("-", self.expression(g.a[g.b[difference]]), self.expression(g.a[difference]))

    def _sum(self, x: Node, y: Node) -> Expr:
        g = self.graph
        if g.op[y] == NEG and y not in self.names:
            return Binary("-", self.expression(x), self.expression(g.a[y]))
        return Binary("+", self.expression(x), self.expression(y))

    def _product(self, x: Node, y: Node) -> Expr:
        op = self.graph.op
        by = self._denominator(y) if op[y] == POW else None
        if by is not None:
            return Binary("/", self.expression(x), by)
        bx = self._denominator(x) if op[x] == POW else None
        if bx is not None:
            return Binary("/", self.expression(y), bx)
        return Binary("*", self.expression(x), self.expression(y))

    def _denominator(self, node: Node) -> Expr | None:
        """d where the node is 1/d and has no name of its own."""
        g, parts = self.graph, self.kids[node]
        if g.op[node] != POW or g.b[node] > 0 or node in self.names or len(parts) > 1:
            return None
        return self._power(g.a[node], -g.b[node]) if parts[0] == g.a[node] else self.expression(parts[0])

    def _power_of(self, node: Node) -> Expr:
        g, parts = self.graph, self.kids[node]
        if len(parts) > 1:
            return Binary("*", self.expression(parts[0]), self.expression(parts[1]))
        if parts[0] == g.a[node]:
            return self._power(g.a[node], g.b[node])
        return Binary("/", Number(_ONE), self.expression(parts[0]))

    def _power(self, base: Node, n: int) -> Expr:
        if n < 0:
            return Binary("/", Number(_ONE), self._power(base, -n))
        inner = self.expression(base)
        return inner if n == 1 else Binary("*", inner, inner) if n == 2 else Power(inner, n)


def lower_function(graph: Graph, plan: FunctionPlan, parameters: Iterable[Node]) -> Function:
    """The plan's function; ``parameters`` are the symbols whose work comes first."""
    return Lowering(graph, plan, parameters).lower()
