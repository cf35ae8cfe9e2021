"""Equations -> Program: the plans of all emitted functions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

from nhc.algebra.calculus import count, reachable
from nhc.algebra.graph import POW, Node
from nhc.algebra.rewriting.factors import find_factors
from nhc.algebra.rewriting.pieces import shorten_pieces
from nhc.algebra.rewriting.related import relate_angles
from nhc.algebra.rewriting.sharing import share_parts
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.rewriting.values import share_values
from nhc.algebra.solving.blocks import without_sign
from nhc.mechanics.formulate import accelerations, reaction_ways
from nhc.mechanics.frame import form_value, kept_forms
from nhc.mechanics.system import Form
from nhc.program.ir import Argument, Function, Origin
from nhc.program.jacobian import plan_jacobian
from nhc.program.lower import lower_function
from nhc.program.plan import FunctionPlan, Target, map_nodes
from nhc.program.planner import SINGULAR_FRAME, T_ARGUMENT, PlannerBase

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

CALLED = 300
"""Operations of the rates beyond which other functions call ``rhs`` for them."""


class Planner(PlannerBase):
    """Plans of one model's functions."""

    @cached_property
    def exchanges(self) -> Planner | None:
        frame, known = self.formulation.frame, self.eliminated()
        pivots = (without_sign(self.graph, value) for value, _ in self.equations.guards)
        if frame is None or not any(pivot in known for pivot in pivots):
            return None
        from nhc.program.exchanges import ExchangePlanner  # here, for few models need it

        return ExchangePlanner(self.full_equations, self.formulation, base=self)

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

    def velocities(self) -> FunctionPlan:
        system = self.system
        nodes = [(v, f"{name}'", "") for v, name in zip(self.equations.motion.velocities, system.q_names, strict=True)]
        return self.plan(
            "velocities", "all velocities q' from the state", "I.2.4", system.n, nodes, self.frame_guards()
        )

    def accelerations(self) -> FunctionPlan:
        system = self.system
        values = self.after_rates("accelerations", accelerations(self.equations))
        nodes = [(a, f"{name}''", "") for a, name in zip(values, system.q_names, strict=True)]
        return self.take_rates(
            "accelerations",
            "all accelerations q'' on the motion",
            self.equations.number,
            system.n,
            nodes,
        )

    def reactions(self) -> FunctionPlan:
        if self.equations.multipliers:
            return self._reactions(self.equations.multipliers)
        ways = reaction_ways(self.equations)
        plans = [self._reactions(self.after_rates("reactions", way)) for way in ways]
        return (
            plans[0] if len(plans) == 1 else min(plans, key=lambda plan: count(self.graph, rewrite(self, plan).roots()))
        )

    def _reactions(self, values: Sequence[Node]) -> FunctionPlan:
        system = self.system
        nodes = [
            (value, f"reaction of {form.name}: Q_i gains lambda_{k + 1} a_{k + 1}i", form.place)
            for k, (value, form) in enumerate(zip(values, system.constraints, strict=True))
        ]
        return self.take_rates("reactions", "reactions lambda of the constraints", "I.4.1", system.l, nodes)

    # --- what follows from the rates ------------------------------------------------------------------------

    def calls_rhs(self, name: str) -> bool:
        """Whether a function that needs the rates calls ``rhs`` for them: where they are long enough to be worth it.

        Of a dense solve only the accelerations do, for the reactions are other unknowns of it.
        """
        if self.solves:
            return name == "accelerations" and len(self.kept_w) == len(self.equations.motion.rates)
        return bool(self.solved) and count(self.graph, list(self.solved.values())) > CALLED

    def after_rates(self, name: str, nodes: Sequence[Node]) -> list[Node]:
        """The nodes of a function shortened, with the rates put in unless they come from ``rhs``."""
        return shorten(self.graph, list(nodes) if self.calls_rhs(name) else self.known(nodes))

    def take_rates(
        self, name: str, about: str, equation: str, size: int, nodes: Sequence[tuple[Node, str, str]]
    ) -> FunctionPlan:
        """The plan of a function of nodes from :meth:`after_rates`."""
        guards = self.frame_guards() + self.mass_guards
        plan = self.plan(name, about, equation, size, nodes, guards, self.solves)
        if not self.calls_rhs(name):
            return plan
        first, names = len(self.kept_q), self.kept_names()
        rates = {self.equations.motion.rates[k]: ("dydt", first + i, f"{names[k]}'") for i, k in enumerate(self.kept_w)}
        own = self.frame_guards() if self.exchanges else ()  # which rhs does not refuse then
        calls = (("rhs", "dydt", self.y.size),)
        return replace(plan, loads=self.state_loads | rates, guards=own, solves=(), calls=calls)

    def outputs(self) -> FunctionPlan:
        values = self.on_motion([node for _, node in self.system.outputs])
        nodes = [
            (node, name, self.system.places.get(name, ""))
            for (name, _), node in zip(self.system.outputs, values, strict=True)
        ]
        return self.plan("outputs", "the spec's outputs", "", len(nodes), nodes, self.frame_guards())

    def energy(self) -> FunctionPlan:
        value = self.on_motion([self.system.energy])[0]
        guards = self.frame_guards() if self.exchanges or self._divides_by_frame(value) else ()
        unit = self.system.units.get("energy", "")
        about = f"energy T + V [{unit}]" if unit not in ("", "1") else "energy T + V"
        inputs = (T_ARGUMENT, self.y, self.p)
        return FunctionPlan("energy", about, "", inputs, None, self.state_loads, (), value, guards)

    def _divides_by_frame(self, energy: Node) -> bool:
        """Whether T's velocities brought divisors with them: in quasi-velocities T may have none, and a value at every state."""
        g, system = self.graph, self.system
        forms = (*system.constraints, *self.kept_forms())
        own = [system.energy, *(x for form in forms for x in (*form.coefficients, form.constant))]
        known, found = (
            {g.a[node] for node in reachable(g, nodes) if g.op[node] == POW and g.b[node] < 0}
            for nodes in (own, [energy])
        )
        return any(not self.is_constant(divisor) for divisor in found - known)

    def state(self) -> FunctionPlan:
        """y from (q, q'): the kept velocities are the values of their forms, without projection."""
        system = self.system
        forms = self.kept_forms()
        nodes = [system.q[i] for i in self.kept_q]
        nodes += [form_value(system, forms[k]) for k in self.kept_w]
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
        """The velocity forms of the full state, in its order."""
        return kept_forms(self.system, self.formulation.frame)

    def _motion_arguments(self) -> tuple[Argument, ...]:
        n = self.system.n
        return (T_ARGUMENT, Argument("q", n), Argument("qdot", n), self.p)

    def residuals(self) -> FunctionPlan:
        system = self.system
        targets = tuple(
            Target(k, form_value(system, form), f"{form.name} = 0", Origin("I.1.1", form.place))
            for k, form in enumerate(system.constraints)
        )
        return FunctionPlan(
            "residuals",
            "left minus right side of each constraint, zero on every motion",
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
            "left minus right side of each holonomic constraint, zero on every motion",
            "",
            (T_ARGUMENT, Argument("q", system.n), self.p),
            Argument("f", len(held)),
            self.motion_loads,
            targets,
        )

    def jacobian(self) -> FunctionPlan:
        return plan_jacobian(self)


def build_functions(planner: Planner, only: Sequence[str] = ()) -> tuple[Function, ...]:
    """The functions asked for, in their fixed order; all that this system has where none is named, or one that it does not have."""
    functions = []
    wanted = set[str]() if set(only) == set(FUNCTIONS) else set(only)
    if any(name in wanted and planner.calls_rhs(name) for name in ("accelerations", "reactions")):
        wanted.add("rhs")
    for name in FUNCTIONS:
        if wanted and name not in wanted:
            continue
        plan = getattr(planner, name)()
        if plan is not None:
            made = lower_function(planner.graph, rewrite(planner, plan), planner.parameters)
            functions.append(replace(made, otherwise=lower_otherwise(planner, plan)))
        elif name in wanted:
            return build_functions(planner)  # the emitter refuses it, and names those that there are
    return tuple(functions)


def lower_otherwise(planner: Planner, plan: FunctionPlan) -> Function | None:
    """The function that stands in for a plan's where a pivot is small; None where nothing in it can be."""
    other = planner.exchanges
    if other is None or not any(guard.status == SINGULAR_FRAME for guard in plan.guards):
        return None
    made: FunctionPlan = getattr(other, plan.name)()
    # not rewritten: of two nodes with one value, one may need unknowns of a solve that the other stands before
    return lower_function(other.graph, made, other.parameters)


def rewrite(planner: PlannerBase, plan: FunctionPlan) -> FunctionPlan:
    """The plan after the rules that look at a whole function."""
    g, constants = planner.graph, planner.graph.mask(planner.parameters)

    def change(nodes: Sequence[Node]) -> list[Node]:
        made = relate_angles(g, nodes)
        if plan.name == "rhs":  # only what is called all the time is worth the trouble
            made = shorten_pieces(g, made)
        made = share_values(g, made)
        if plan.name == "rhs" and planner.equations.tree is None:  # a recursion along a tree has none
            made = find_factors(g, made)
        return share_parts(g, made, constants)

    return map_nodes(plan, change)
