"""Equations -> plans of all functions that are emitted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

from nhc.algebra.graph import POW, Node
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.solving.blocks import without_sign
from nhc.algebra.walks import count, reachable
from nhc.mechanics.formulate import accelerations, reaction_ways
from nhc.mechanics.frame import form_value, kept_forms
from nhc.mechanics.system import Form
from nhc.program.ir import Argument, Origin
from nhc.program.plan import Entry, FunctionPlan, Target
from nhc.program.planning.base import T_ARGUMENT, PlannerBase
from nhc.program.planning.jacobian import plan_jacobian
from nhc.program.planning.rewrite import rewrite

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
        from nhc.program.planning.exchanges import ExchangePlanner  # here, for few models need it

        return ExchangePlanner(self.full_equations, self.formulation, base=self)

    @property
    def kinematics(self) -> str:
        """The number of the equations that give all velocities by the state's; none where these are all velocities."""
        return {"euler-lagrange": "I.2.4", "chaplygin": "I.1.2", "voronec": "I.1.2"}.get(self.formulation.name, "")

    def rhs(self) -> FunctionPlan:
        system, motion = self.system, self.equations.motion
        rates = self.known(motion.rates)
        names, q_names = self.kept_names(), system.q_names
        number = self.kinematics or None  # x' = x' alone is half of a system of the second order
        entries = [Entry(motion.velocities[i], f"{q_names[i]}'", equation=number) for i in self.kept_q]
        entries += [Entry(rates[k], f"{names[k]}'", system.places["T"]) for k in self.kept_w]
        return self.plan(
            "rhs",
            "right-hand side dy/dt = f(t, y; p)",
            self.equations.number,
            entries,
            self.frame_guards() + self.mass_guards,
            self.solves,
        )

    def velocities(self) -> FunctionPlan:
        system = self.system
        pairs = zip(self.equations.motion.velocities, system.q_names, strict=True)
        entries = [Entry(v, f"{name}'") for v, name in pairs]
        return self.plan(
            "velocities", "all velocities q' from the state", self.kinematics, entries, self.frame_guards()
        )

    def accelerations(self) -> FunctionPlan:
        system = self.system
        values = self.after_rates("accelerations", accelerations(self.equations))
        entries = [Entry(a, f"{name}''") for a, name in zip(values, system.q_names, strict=True)]
        return self.take_rates("accelerations", "all accelerations q'' on the motion", self.equations.number, entries)

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
        entries = [
            Entry(value, f"reaction of {form.name}: Q_i gains lambda_{k + 1} a_{k + 1}i", form.place)
            for k, (value, form) in enumerate(zip(values, system.constraints, strict=True))
        ]
        return self.take_rates("reactions", "reactions lambda of the constraints", "I.4.1", entries)

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

    def take_rates(self, name: str, about: str, equation: str, entries: Sequence[Entry]) -> FunctionPlan:
        """The plan of a function of entries from :meth:`after_rates`."""
        guards = self.frame_guards() + self.mass_guards
        plan = self.plan(name, about, equation, entries, guards, self.solves)
        if not self.calls_rhs(name):
            return plan
        first = len(self.kept_q)
        rates = {self.equations.motion.rates[k]: ("dydt", first + i, "") for i, k in enumerate(self.kept_w)}
        own = self.frame_guards() if self.exchanges else ()  # which rhs does not refuse then
        calls = (("rhs", "dydt", self.y.size),)
        return replace(plan, loads=self.state_loads | rates, guards=own, solves=(), calls=calls)

    def outputs(self) -> FunctionPlan:
        values = self.on_motion([node for _, node in self.system.outputs])
        entries = [
            Entry(node, name, self.system.places.get(name, ""))
            for (name, _), node in zip(self.system.outputs, values, strict=True)
        ]
        return self.plan("outputs", "the spec's outputs", "", entries, self.frame_guards())

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
            "I.2.1" if self.formulation.name == "euler-lagrange" else "",
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
