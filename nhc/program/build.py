"""Equations -> Program: the plans of all emitted functions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from nhc.algebra.calculus import gradient, substitute
from nhc.algebra.graph import Node
from nhc.algebra.shorten import shorten
from nhc.mechanics.associate import Equations
from nhc.mechanics.choose import Formulation
from nhc.mechanics.formulate import accelerations, bordered_system, reaction_values
from nhc.mechanics.frame import coordinate_form, form_value
from nhc.mechanics.system import Form, System
from nhc.program.ir import Argument, Function, Origin
from nhc.program.lower import lower_function
from nhc.program.plan import FunctionPlan, GuardPlan, SolvePlan, Target, factor, solve_factored

FUNCTIONS = (
    "rhs",
    "velocities",
    "accelerations",
    "state",
    "residuals",
    "positions",
    "reactions",
    "energy",
    "jacobian",
    "outputs",
)
SINGULAR_FRAME, SINGULAR_MASS = 1, 2
_FRAME_TOLERANCE, _MASS_TOLERANCE, _BORDERED_TOLERANCE = 1e-12, 1e-14, 1e-13
_T = Argument("t", -1)


@dataclass
class Planner:
    """Plans of one model; nodes that several functions need are made once."""

    equations: Equations
    formulation: Formulation
    solved: dict[Node, Node] = field(default_factory=dict)
    mass_guards: tuple[GuardPlan, ...] = ()
    solves: tuple[SolvePlan, ...] = ()

    def __post_init__(self) -> None:
        system = self.system
        self.graph = system.graph
        self.parameters: tuple[Node, ...] = system.p
        self.kept_q: tuple[int, ...] = tuple(range(system.n))
        self.kept_w: tuple[int, ...] = tuple(range(len(self.equations.motion.w)))
        self._arrange()
        self.motion_loads = {
            system.t: ("t", -1, "time"),
            **{node: ("q", i, _about(system, i)) for i, node in enumerate(system.q)},
            **{node: ("qdot", i, "") for i, node in enumerate(system.v)},
            **self._parameter_loads(),
        }
        self._solve()

    def _arrange(self) -> None:
        """The arguments y and p of functions of the state, from the coordinates and velocities that are kept."""
        system, w = self.system, self.equations.motion.w
        self.y_nodes = (*(system.q[i] for i in self.kept_q), *(w[k] for k in self.kept_w))
        self.y = Argument("y", len(self.y_nodes))
        self.p = Argument("p", len(self.parameters))
        abouts = [*(_about(system, i) for i in self.kept_q), *("" for _ in self.kept_w)]
        self.state_loads = {
            system.t: ("t", -1, "time"),
            **{node: ("y", k, about) for k, (node, about) in enumerate(zip(self.y_nodes, abouts, strict=True))},
            **self._parameter_loads(),
        }

    @property
    def system(self) -> System:
        return self.equations.system

    def _parameter_loads(self) -> dict[Node, tuple[str, int, str]]:
        found = {}
        for k, (node, parameter) in enumerate(zip(self.system.p, self.system.spec.parameters, strict=True)):
            unit = f" [{parameter.unit}]" if parameter.unit else ""
            found[node] = ("p", k, f"{parameter.about}{unit}".strip())
        return found

    # --- the rates ------------------------------------------------------------------------------------------

    def _solve(self) -> None:
        """Express the rates: by the unrolled factorization, or as unknowns of a dense solve with pivoting."""
        equations, g = self.equations, self.graph
        rates = equations.motion.rates
        if not rates:
            return
        if equations.definite:
            self.factors = factor(g, equations.mass)
            values = shorten(g, solve_factored(g, self.factors, equations.force))
            self.solved = dict(zip(rates, values, strict=True))
            what = "the mass matrix is singular"
            self.mass_guards = tuple(
                GuardPlan(pivot, self._mass_scale(pivot, equations.mass[k][k]), _MASS_TOLERANCE, SINGULAR_MASS, what)
                for k, pivot in enumerate(self.factors.pivots)
                if not self._constant_positive(pivot)
            )
            return
        matrix, right = self._dense()
        unknowns = (*rates, *equations.multipliers)
        self.solves = (self._dense_solve(matrix, [right], [unknowns]),)

    def _mass_scale(self, pivot: Node, entry: Node) -> Node:
        """The diagonal entry that a pivot came from; zero where they are the same (then only zero is refused)."""
        return self.graph.zero if pivot == entry else entry

    def _constant_positive(self, pivot: Node) -> bool:
        """A number, or a parameter standing alone: no guard is worth its cost."""
        return self.graph.value(pivot) is not None

    def _dense(self) -> tuple[list[list[Node]], list[Node]]:
        if self.equations.multipliers:
            return bordered_system(self.equations)
        return [list(row) for row in self.equations.mass], list(self.equations.force)

    def _dense_solve(
        self, matrix: Sequence[Sequence[Node]], columns: Sequence[Sequence[Node]], symbols: Sequence[Sequence[Node]]
    ) -> SolvePlan:
        what = "the constraints and the mass matrix do not determine the accelerations"
        return SolvePlan(
            tuple(tuple(row) for row in matrix),
            tuple(tuple(column) for column in columns),
            tuple(tuple(column) for column in symbols),
            _BORDERED_TOLERANCE,
            SINGULAR_MASS,
            what,
        )

    def frame_guards(self) -> tuple[GuardPlan, ...]:
        what = "the coframe is singular"
        if self.formulation.dependent is not None:
            names = ", ".join(f"{self.system.q_names[i]}'" for i in self.formulation.dependent.dependent)
            what = f"the constraints cannot be solved for {names}"
        # a constant determinant is only held against zero: its scale would be work for nothing
        return tuple(
            GuardPlan(
                value,
                self.graph.zero if self._is_constant(value) else scale,
                _FRAME_TOLERANCE,
                SINGULAR_FRAME,
                what,
            )
            for value, scale in self.equations.guards
        )

    def _is_constant(self, node: Node) -> bool:
        """Made of parameters and numbers only."""
        return not self.graph.deps[node] & ~self.graph.mask(self.parameters)

    def on_motion(self, nodes: Sequence[Node]) -> list[Node]:
        """Functions of (q, q', t) in terms of the kept state, shortened."""
        on = dict(zip(self.system.v, self.equations.motion.velocities, strict=True))
        return shorten(self.graph, substitute(self.graph, nodes, on))

    def known(self, nodes: Sequence[Node]) -> list[Node]:
        """Nodes with the rates' symbols replaced by their values (dense unknowns stay symbols)."""
        return substitute(self.graph, nodes, self.solved) if self.solved else list(nodes)

    # --- plans ------------------------------------------------------------------------------------------------

    def plan(
        self,
        name: str,
        about: str,
        equation: str,
        size: int,
        nodes: Sequence[tuple[Node, str, str]],
        guards: tuple[GuardPlan, ...] = (),
        solves: tuple[SolvePlan, ...] = (),
    ) -> FunctionPlan:
        """A function of (t, y, p) that writes ``nodes`` (value, about, place) into its output array."""
        output = {
            "rhs": "dydt",
            "velocities": "qdot",
            "accelerations": "qddot",
            "reactions": "lambda",
            "jacobian": "J",
            "outputs": "out",
        }[name]
        targets = tuple(
            Target(k, node, about_, Origin(equation, place)) for k, (node, about_, place) in enumerate(nodes)
        )
        return FunctionPlan(
            name,
            about,
            equation,
            (_T, self.y, self.p),
            Argument(output, size),
            self.state_loads,
            targets,
            None,
            guards,
            solves,
        )

    def rhs(self) -> FunctionPlan:
        system, motion = self.system, self.equations.motion
        rates = self.known(motion.rates)
        names, q_names = self.kept_names(), system.q_names
        nodes = [(motion.velocities[i], f"{q_names[i]}'", "") for i in self.kept_q]
        nodes += [(rates[k], f"{names[k]}'", system.places["T"]) for k in self.kept_w]
        return self.plan(
            "rhs",
            "right-hand side dy/dt = f(t, y; p)",
            self.equations.number,
            self.y.size,
            nodes,
            self.frame_guards() + self.mass_guards,
            self.solves,
        )

    def kept_names(self) -> list[str]:
        found = []
        for node in self.equations.motion.w:
            symbol = self.graph.symbol_of(node)
            assert symbol is not None
            found.append(f"{symbol.name}'" if symbol.kind == "velocity" else symbol.name)
        return found

    def velocities(self) -> FunctionPlan:
        system = self.system
        nodes = [(v, f"{name}'", "") for v, name in zip(self.equations.motion.velocities, system.q_names, strict=True)]
        return self.plan(
            "velocities", "all velocities q' from the state", "I.2.4", system.n, nodes, self.frame_guards()
        )

    def accelerations(self) -> FunctionPlan:
        system = self.system
        values = shorten(self.graph, self.known(accelerations(self.equations)))
        nodes = [(a, f"{name}''", "") for a, name in zip(values, system.q_names, strict=True)]
        return self.plan(
            "accelerations",
            "all accelerations q'' on the motion",
            self.equations.number,
            system.n,
            nodes,
            self.frame_guards() + self.mass_guards,
            self.solves,
        )

    def reactions(self) -> FunctionPlan:
        system = self.system
        values: Sequence[Node] = self.equations.multipliers
        if not values:
            values = shorten(self.graph, self.known(reaction_values(self.equations)))
        nodes = [
            (value, f"reaction of {form.name}: Q_i gains lambda_{k + 1} a_{k + 1}i", form.place)
            for k, (value, form) in enumerate(zip(values, system.constraints, strict=True))
        ]
        return self.plan(
            "reactions",
            "reactions lambda: Q_i gains lambda_a a_ai",
            "I.4.1",
            system.l,
            nodes,
            self.frame_guards() + self.mass_guards,
            self.solves,
        )

    def outputs(self) -> FunctionPlan:
        values = self.on_motion([node for _, node in self.system.outputs])
        nodes = [
            (node, name, self.system.places.get(name, ""))
            for (name, _), node in zip(self.system.outputs, values, strict=True)
        ]
        return self.plan("outputs", "the spec's outputs", "", len(nodes), nodes, self.frame_guards())

    def energy(self) -> FunctionPlan:
        value = self.on_motion([self.system.energy])[0]
        return FunctionPlan("energy", "T + V", "II.1.4", (_T, self.y, self.p), None, self.state_loads, (), value)

    def state(self) -> FunctionPlan:
        """y from (q, q'): the kept velocities are the values of their forms, without projection."""
        system = self.system
        forms = self.kept_forms()
        nodes = [system.q[i] for i in self.kept_q]
        nodes += [form_value(self.graph, forms[k], system.v) for k in self.kept_w]
        targets = tuple(Target(k, node) for k, node in enumerate(nodes))
        return FunctionPlan(
            "state",
            "the state y from coordinates and velocities",
            "I.2.1",
            self._motion_arguments(),
            Argument("y", self.y.size),
            self.motion_loads,
            targets,
        )

    def kept_forms(self) -> tuple[Form, ...]:
        frame = self.formulation.frame
        if frame is None:
            return tuple(coordinate_form(self.system, i) for i in range(self.system.n))
        return frame.forms[self.system.l :]

    def _motion_arguments(self) -> tuple[Argument, ...]:
        n = self.system.n
        return (_T, Argument("q", n), Argument("qdot", n), self.p)

    def residuals(self) -> FunctionPlan:
        system = self.system
        targets = tuple(
            Target(k, form_value(self.graph, form, system.v), f"{form.name} = 0", Origin("I.1.1", form.place))
            for k, form in enumerate(system.constraints)
        )
        return FunctionPlan(
            "residuals",
            "left sides of the constraints, zero on every motion",
            "I.1.1",
            self._motion_arguments(),
            Argument("r", system.l),
            self.motion_loads,
            targets,
        )

    def positions(self) -> FunctionPlan | None:
        """f(q, t) of the holonomic constraints; None where there are none."""
        system = self.system
        held = [form for form in system.constraints if form.equation is not None]
        if not held:
            return None
        targets = tuple(
            Target(k, form.equation, f"{form.name} = 0", Origin("", form.place))
            for k, form in enumerate(held)
            if form.equation is not None
        )
        return FunctionPlan(
            "positions",
            "residuals of the holonomic constraints at position level",
            "",
            (_T, Argument("q", system.n), self.p),
            Argument("f", len(held)),
            self.motion_loads,
            targets,
        )

    def jacobian(self) -> FunctionPlan:
        """d rhs / d y: the rates by implicit differentiation of mass w' - force, with the factors already at hand."""
        g, motion, y = self.graph, self.equations.motion, self.y_nodes
        rows = [gradient(g, motion.velocities[i], y) for i in self.kept_q]
        matrix, right = self._dense() if motion.rates else ([], [])
        unknowns = (*motion.rates, *self.equations.multipliers)
        residual = [
            g.sub(value, g.sum([g.mul(m, x) for m, x in zip(row, unknowns, strict=True)]))
            for row, value in zip(matrix, right, strict=True)
        ]
        slopes = [gradient(g, node, y) for node in residual]
        solves, columns = self._jacobian_columns(matrix, [list(column) for column in zip(*slopes, strict=True)], len(y))
        rates = [[column[k] for column in columns] for k in self.kept_w]
        nodes = [(node, "", "") for row in (*rows, *rates) for node in row]
        return self.plan(
            "jacobian",
            "d rhs_i / d y_j, row-major",
            self.equations.number,
            len(y) ** 2,
            nodes,
            self.frame_guards() + self.mass_guards,
            solves,
        )

    def _jacobian_columns(
        self, matrix: list[list[Node]], columns: list[list[Node]], count: int
    ) -> tuple[tuple[SolvePlan, ...], list[list[Node]]]:
        g = self.graph
        if not matrix:
            return (), [[] for _ in range(count)]
        if self.equations.definite:
            solved = [solve_factored(g, self.factors, self.known(column)) for column in columns]
            flat = shorten(g, [node for column in solved for node in column])
            size = len(matrix)
            return (), [flat[k * size : (k + 1) * size] for k in range(len(columns))]
        symbols = [[g.symbol(f"d{i}_{j}", "unknown") for i in range(len(matrix))] for j in range(len(columns))]
        return (*self.solves, self._dense_solve(matrix, columns, symbols)), symbols


def _about(system: System, i: int) -> str:
    coordinate = system.spec.coordinates[i]
    unit = f" [{coordinate.unit}]" if coordinate.unit else ""
    return f"{coordinate.about}{unit}".strip()


def build_functions(planner: Planner, only: Sequence[str] = ()) -> tuple[Function, ...]:
    """The functions asked for (all by default), in their fixed order."""
    functions = []
    for name in FUNCTIONS:
        if only and name not in only:
            continue
        plan = getattr(planner, name)()
        if plan is not None:
            functions.append(lower_function(planner.graph, plan, planner.parameters))
    return tuple(functions)
