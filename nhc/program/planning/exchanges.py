"""A model's functions with exchanges of rows: they stand in for those whose coframe is solved in a fixed order of elimination.

More than four coupled rows are eliminated in an order that is chosen when the equations are derived, and its pivots vanish at
places where the rows are independent: no order is good everywhere.  Near such a place the order is found while the code runs: one
elimination for the velocities, and one of the multiplier equations for the accelerations and the reactions.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from nhc.algebra.calculus import gradient, pullback_gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.peel import coefficients
from nhc.language.spec import reaction_name
from nhc.mechanics.choosing.choose import build
from nhc.mechanics.formulate import bordered_system, equations_of
from nhc.mechanics.frame import form_value, total_derivative
from nhc.mechanics.motion import Motion
from nhc.mechanics.rotations.turning import from_base, moving
from nhc.program.ir import Function
from nhc.program.plan import Entry, FunctionPlan, GuardPlan, SolvePlan, SweepPlan, Target
from nhc.program.planning.base import SINGULAR_FRAME
from nhc.program.planning.planner import Planner
from nhc.program.planning.scene import ScenePlanner

_TOLERANCE = 1e-13


@dataclass(eq=False, repr=False)
class ExchangePlanner(Planner):
    """Plans over the same state: q' are unknowns of a first solve, q'' and lambda those of a second one."""

    base: Planner = field(kw_only=True)

    def _arrange(self) -> None:
        base = self.base
        self.parameters, self.state_loads = base.parameters, base.state_loads
        # what was left out because nothing that is kept depends on it stands in the rows all the same
        entries = (*self.system.q, *self.equations.motion.w)
        self.put_in = {x: self.graph.zero for x in entries if x not in base.state_loads} | base.put_in
        self.kept_q, self.kept_w, self.y_nodes, self.y, self.p = base.kept_q, base.kept_w, base.y_nodes, base.y, base.p

    def _fix(self, nodes: Sequence[Node]) -> list[Node]:
        return substitute(self.graph, nodes, self.put_in) if self.put_in else list(nodes)

    def on_motion(self, nodes: Sequence[Node]) -> list[Node]:
        return self._fix(super().on_motion(nodes))

    @property
    def exchanges(self) -> None:
        return None

    def _solve(self) -> None:
        g, system, equations = self.graph, self.system, self.equations
        velocities = self._solve_for_velocities()
        on = moving(system, velocities)
        whole = equations_of(system, build(system, "multipliers"))
        matrix, right = bordered_system(whole)
        size = len(right)
        flat = self._fix(substitute(g, [*(x for row in matrix for x in row), *right], on))
        rows = [flat[k * size : (k + 1) * size] for k in range(size)]
        self.accelerated = whole.motion.rates
        unknowns = (*self.accelerated, *whole.multipliers)
        self.solves = (self._first, self.plan_dense_solve(rows, [flat[size * size :]], [unknowns]))
        changes = dict(zip(system.v, self.accelerated, strict=True))
        forms = self.kept_forms()
        rates = [total_derivative(system, form_value(system, form), system.v, changes) for form in forms]
        pairs = zip(equations.motion.rates, self._fix(substitute(g, rates, on)), strict=True)
        self.solved = {rate: value for rate, value in pairs if rate != value}
        motion = Motion(equations.motion.w, equations.motion.rates, velocities, equations.motion.vectors)
        self.equations = replace(
            equations, motion=motion, multipliers=whole.multipliers, guards=(), kinetic=lambda: None, tree=None
        )

    def _solve_for_velocities(self) -> tuple[Node, ...]:
        """q' in terms of the first solve's unknowns: the velocities themselves, but for what is kept and for rotations."""
        g, system, frame = self.graph, self.system, self.formulation.frame
        assert frame is not None and frame.rows is not None
        rows, unknowns = frame.rows()
        turned = {k for rotation in frame.turned for k in rotation.places}
        own = [x if i in turned else v for i, (x, v) in enumerate(zip(unknowns, system.v, strict=True))]
        rows = substitute(g, rows, dict(zip(unknowns, own, strict=True)), named=False)
        rows = [row for row in self._fix(rows) if row != g.zero]  # of a velocity that is kept
        sought = tuple(x for x in own if x not in self.equations.motion.w)
        matrix = tuple(tuple(coefficients(g, row, sought)) for row in rows)
        right = substitute(g, rows, dict.fromkeys(sought, g.zero), named=False)
        column = tuple(g.neg(node) for node in right)
        self._first = SolvePlan(matrix, (column,), (sought,), _TOLERANCE, SINGULAR_FRAME, self.frame_what(), plain=True)
        return tuple(self._fix(from_base(system, own, frame.bases)))

    def calls_rhs(self, name: str) -> bool:
        return False

    def rhs(self) -> FunctionPlan:
        return self._with_solves(super().rhs())

    def velocities(self) -> FunctionPlan:
        return self._with_solves(super().velocities())

    def accelerations(self) -> FunctionPlan:
        names = [f"{name}''" for name in self.system.q_names]
        entries = [Entry(a, name) for a, name in zip(self.accelerated, names, strict=True)]
        about, number = "all accelerations q'' on the motion", self.equations.number
        return self._with_solves(self.plan("accelerations", about, number, entries))

    def reactions(self) -> FunctionPlan:
        return self._with_solves(super().reactions())

    def energy(self) -> FunctionPlan:
        return self._with_solves(super().energy())

    def outputs(self) -> FunctionPlan:
        if not isinstance(self.base, ScenePlanner):
            return self._with_solves(super().outputs())
        names = [column.name for column in self.base.reduction.outputs]
        entries = [Entry(node, name) for node, name in zip(self.needed_nodes(names), names, strict=True)]
        return self._with_solves(self.plan("outputs", "what the scene needs", "", entries))

    def needed_nodes(self, names: Sequence[str]) -> list[Node]:
        """The columns of a scene by their names."""
        system = self.system
        reactions = zip(system.constraints, self.equations.multipliers, strict=True)
        known = {reaction_name(form.name): node for form, node in reactions} | {"energy": system.energy}
        known |= dict(system.outputs) | {form.name: form_value(system, form) for form in system.quasi}
        known |= {f"{name}'": v for name, v in zip(system.q_names, system.v, strict=True)}
        known |= dict(zip(system.q_names, system.q, strict=True))
        return self.on_motion([known[name] for name in names])

    def jacobian(self) -> FunctionPlan:
        """In two sweeps: a column of the velocities' rows in each pass, and a row of the rates' in each pass.

        The first solve has the columns of its inverse beside the velocities, the second one rows of its own inverse, which the
        rates weigh: nothing is eliminated within the passes.
        """
        g, size = self.graph, self.y.size
        first, second = self.solves
        count = range(len(first.matrix))
        inverse = [[g.symbol(f"i{k}_{j}", "unknown") for j in count] for k in count]
        units = [tuple(g.one if i == k else g.zero for i in count) for k in count]
        rates = self.known([self.equations.motion.rates[k] for k in self.kept_w])
        slopes = [tuple(gradient(g, rate, second.symbols[0])) for rate in rates]
        weights = [[g.symbol(f"w{k}_{i}", "unknown") for i in range(len(second.matrix))] for k in range(len(rates))]
        solves = (
            replace(first, columns=(*first.columns, *units), symbols=(*first.symbols, *map(tuple, inverse))),
            replace(second, columns=(*second.columns, *slopes), symbols=(*second.symbols, *map(tuple, weights))),
        )
        sweeps = (self._sweep_velocities(inverse), self._sweep_rates(rates, weights, inverse))
        about = "Jacobian matrix of rhs, d rhs_i / d y_j"
        plan = self.plan("jacobian", about, self.equations.number, (), (), solves, size=size * size)
        return replace(plan, sweeps=tuple(sweep for sweep in sweeps if sweep.targets))

    def _sweep_velocities(self, inverse: Sequence[Sequence[Node]]) -> SweepPlan:
        """``inverse[k]`` is the k-th column of the first solve's inverse."""
        g, size, first = self.graph, self.y.size, self.solves[0]
        seeds = {entry: g.symbol(f"turn_{j}", "direction") for j, entry in enumerate(self.y_nodes)}
        turned = tangent(g, _residual(g, first), seeds)
        found = [
            g.sum([g.mul(column[j], x) for column, x in zip(inverse, turned, strict=True)]) for j in range(len(turned))
        ]
        velocities = [self.equations.motion.velocities[i] for i in self.kept_q]
        nodes = tangent(g, velocities, seeds | dict(zip(first.symbols[0], found, strict=True)))
        about = "one entry of the state in each pass: a column of the velocities' rows"
        return SweepPlan(about, tuple(seeds.values()), tuple(range(size)), _targets(g, nodes, size))

    def _sweep_rates(
        self, rates: Sequence[Node], weights: Sequence[Sequence[Node]], inverse: Sequence[Sequence[Node]]
    ) -> SweepPlan:
        """Backwards through both solves: ``weights`` are rows of the inverse of the second one, which is symmetric."""
        g, size, (first, second) = self.graph, self.y.size, self.solves
        seeds = [g.symbol(f"row_{k}", "direction") for k in range(len(rates))]
        own = [g.dot(seeds, [row[i] for row in weights]) for i in range(len(second.matrix))]
        pairs = [*zip(rates, seeds, strict=True), *zip(_residual(g, second), own, strict=True)]
        slopes = pullback_gradient(g, pairs, (*self.y_nodes, *first.symbols[0]))
        back = [g.dot(column, slopes[size:]) for column in inverse]
        more = pullback_gradient(g, list(zip(_residual(g, first), back, strict=True)), self.y_nodes)
        nodes = [g.add(x, y) for x, y in zip(slopes, more, strict=False)]
        offsets = tuple((len(self.kept_q) + k) * size for k in range(len(rates)))
        return SweepPlan("one rate in each pass: its row of the matrix", tuple(seeds), offsets, _targets(g, nodes, 1))

    def lower_out(
        self,
        name: str,
        about: str,
        nodes: Sequence[Node],
        texts: Sequence[str] = (),
        guards: tuple[GuardPlan, ...] = (),
        solves: tuple[SolvePlan, ...] = (),
    ) -> Function:
        return super().lower_out(name, about, nodes, texts, (), self._needed(nodes))

    def _with_solves(self, plan: FunctionPlan) -> FunctionPlan:
        targets: list[Target] = list(plan.targets)
        nodes = [target.node for target in targets] + ([] if plan.result is None else [plan.result])
        return replace(plan, guards=(), solves=self._needed(nodes))

    def _needed(self, nodes: Sequence[Node]) -> tuple[SolvePlan, ...]:
        """The solves whose unknowns are in the nodes; the second one needs the first."""
        masks = [self.graph.mask(solve.symbols[0]) for solve in self.solves]
        last = max((k + 1 for k, mask in enumerate(masks) for node in nodes if self.graph.deps[node] & mask), default=0)
        return self.solves[:last]


def _residual(graph: Graph, solve: SolvePlan) -> list[Node]:
    """right - matrix x, row by row."""
    rows = zip(solve.matrix, solve.columns[0], strict=True)
    return [graph.sub(value, graph.dot(row, solve.symbols[0])) for row, value in rows]


def _targets(graph: Graph, nodes: Sequence[Node], step: int) -> tuple[Target, ...]:
    return tuple(Target(k * step, node) for k, node in enumerate(nodes) if node != graph.zero)
