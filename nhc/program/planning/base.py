"""What the plans of all functions of a model share: arguments, loads, the solved rates, guards."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from nhc.algebra.graph import Node
from nhc.algebra.parts import split_powers
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.solving.blocks import Matrix, find_eliminated, without_sign
from nhc.algebra.solving.determinants import in_determinants
from nhc.algebra.walks import count, reachable
from nhc.mechanics.added_forms import describe_added
from nhc.mechanics.added_units import added_units
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.formulate import bordered_system
from nhc.mechanics.frame import kept_forms
from nhc.mechanics.regular.trials import usual_digits, usual_part
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import System
from nhc.program.ir import Argument, Function, Origin, Quantity
from nhc.program.lowering.lower import lower_function
from nhc.program.plan import Entry, FunctionPlan, GuardPlan, SolvePlan, Target
from nhc.program.planning.mass_route import mass_route

SINGULAR_FRAME, SINGULAR_MASS = 1, 2
MASS_LOST = "the mass matrix is singular"
_PIVOT_DIGITS = (
    3.0  # of a pivot that may vanish where its block is regular: there are twice as many in what it is divided by
)
_FRAME_DIGITS, _MASS_TOLERANCE, _BORDERED_TOLERANCE = 12.0, 1e-13, 1e-13
_TURNED_DIGITS = (
    7.0  # of a determinant that stands squared in that of the mass matrix; its scale is a few times what it can be
)
_HELD_TOLERANCE = 1e-10  # six digits are left
T_ARGUMENT = Argument("t", -1)


@dataclass(eq=False, repr=False)
class PlannerBase:
    """One model: nodes that several functions need are made once."""

    equations: Equations
    formulation: Formulation
    solved: dict[Node, Node] = field(default_factory=dict)
    mass_guards: tuple[GuardPlan, ...] = ()
    turned_guards: tuple[GuardPlan, ...] = ()
    solves: tuple[SolvePlan, ...] = ()

    def __post_init__(self) -> None:
        system = self.system
        self.graph = system.graph
        self.parameters: tuple[Node, ...] = system.p
        self.kept_q: tuple[int, ...] = tuple(range(system.n))
        self.kept_w: tuple[int, ...] = tuple(range(len(self.equations.motion.w)))
        self.put_in: dict[Node, Node] = {}
        self._arrange()
        rates = [system.units.get(f"{name}'", "") for name in system.q_names]
        self.motion_loads = {
            system.t: ("t", -1, "time"),
            **{node: ("q", i, _about(system, i)) for i, node in enumerate(system.q)},
            **{node: ("qdot", i, _unit(rates[i])) for i, node in enumerate(system.v)},
            **self._parameter_loads(),
        }
        self._solve()

    def _arrange(self) -> None:
        """The arguments y and p of functions of the state, from the coordinates and velocities that are kept."""
        system, w = self.system, self.equations.motion.w
        self.y_nodes = (*(system.q[i] for i in self.kept_q), *(w[k] for k in self.kept_w))
        self.y = Argument("y", len(self.y_nodes))
        self.p = Argument("p", len(self.parameters))
        kept = self.state_quantities()[len(system.spec.coordinates) :]
        abouts = [*(_about(system, i) for i in self.kept_q), *(_unit(kept[k].unit) for k in self.kept_w)]
        self.state_loads = {
            system.t: ("t", -1, "time"),
            **{node: ("y", k, about) for k, (node, about) in enumerate(zip(self.y_nodes, abouts, strict=True))},
            **self._parameter_loads(),
        }

    @property
    def system(self) -> System:
        return self.equations.system

    @property
    def full_equations(self) -> Equations:
        """The equations before anything was put into them."""
        return self.equations

    def _parameter_loads(self) -> dict[Node, tuple[str, int, str]]:
        found = {}
        for k, (node, parameter) in enumerate(zip(self.system.p, self.system.spec.parameters, strict=True)):
            found[node] = ("p", k, f"{parameter.about} {_unit(parameter.unit)}".strip())
        return found

    # --- the rates ------------------------------------------------------------------------------------------

    def _solve(self) -> None:
        """Express the rates: by the unrolled factorization, or as unknowns of a dense solve with pivoting."""
        equations = self.equations
        rates = equations.motion.rates
        if not rates:
            return
        if equations.definite:
            kept = kept_forms(self.system, self.formulation.frame)
            self.route = mass_route(equations, self.full_equations, self.put_in, kept)
            self.solved = dict(zip(rates, self.route.values, strict=True))
            self.turned_guards = self._guard_determinants(self.route.turned, _TURNED_DIGITS, SINGULAR_MASS, MASS_LOST)
            self.mass_guards = (
                *self._guard_pivots(self.route.pivots, _MASS_TOLERANCE),
                *self._guard_pivots(self.route.held, _HELD_TOLERANCE),
                *self.turned_guards,
            )
            return
        matrix, right = self.dense_system()
        unknowns = (*rates, *equations.multipliers)
        self.solves = (self.plan_dense_solve(matrix, [right], [unknowns]),)
        self.solved = self._held_alone(matrix, right, unknowns)

    def _held_alone(
        self, matrix: Sequence[Sequence[Node]], right: Sequence[Node], unknowns: Sequence[Node]
    ) -> dict[Node, Node]:
        """The accelerations that one constraint gives by itself, as u' = 0 does: not what elimination leaves of zero.

        Rounding is no small part of that where the velocity stays zero, and no step is short enough for it.
        """
        g, found = self.graph, dict[Node, Node]()
        for row, value in list(zip(matrix, right, strict=True))[len(self.equations.motion.rates) :]:
            entries = [(k, entry) for k, entry in enumerate(row) if entry != g.zero]
            if len(entries) == 1 and g.value(entries[0][1]) is not None:
                found[unknowns[entries[0][0]]] = g.div(value, entries[0][1])
        return found

    def _guard_pivots(self, pivots: Sequence[tuple[Node, Node]], tolerance: float) -> list[GuardPlan]:
        what = MASS_LOST
        # determinants of the coframe are in it, squared: it is lost before they are
        if any(not self.is_constant(value) for value, _ in self.equations.guards):
            what += ", or the velocities that are kept do not suffice"
        g = self.graph
        sizes = [(without_sign(g, pivot), pivot, scale) for pivot, scale in pivots]
        # what is held against itself is refused at zero only
        return [
            GuardPlan(size, g.zero if pivot == scale else scale, tolerance, SINGULAR_MASS, what)
            for size, pivot, scale in sizes
            if not self._constant_positive(size)
        ]

    def _constant_positive(self, pivot: Node) -> bool:
        """A number, or a parameter standing alone: no guard is worth its cost."""
        return self.graph.value(pivot) is not None

    def dense_system(self) -> tuple[list[list[Node]], list[Node]]:
        """The matrix and the right side of the rates, with the multipliers' rows where there are multipliers."""
        if self.equations.multipliers:
            return bordered_system(self.equations)
        return [list(row) for row in self.equations.mass], list(self.equations.force)

    def plan_dense_solve(
        self, matrix: Sequence[Sequence[Node]], columns: Sequence[Sequence[Node]], symbols: Sequence[Sequence[Node]]
    ) -> SolvePlan:
        """A solve with pivoting while the code runs: each of ``columns`` gives the values of a row of ``symbols``."""
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
        """Of the coframe's determinants; its pivots are left sooner where something stands in for what is divided by them."""
        return self._guard_frame(_PIVOT_DIGITS if self.exchanges else _FRAME_DIGITS)

    def last_guards(self) -> tuple[GuardPlan, ...]:
        """The same of a function that nothing stands in for."""
        return self._guard_frame(_FRAME_DIGITS)

    def _guard_frame(self, digits: float) -> tuple[GuardPlan, ...]:
        what, known = self.frame_what(), self.eliminated()
        pivots = [pair for pair in self.equations.guards if without_sign(self.graph, pair[0]) in known]
        others = [pair for pair in self.equations.guards if pair not in pivots]
        return (
            *self._guard_determinants(pivots, digits, SINGULAR_FRAME, what),
            *self._guard_determinants(others, _FRAME_DIGITS, SINGULAR_FRAME, what),
        )

    def frame_determinants(self) -> tuple[GuardPlan, ...]:
        """What vanishes where the coframe is singular, whatever the order of elimination."""
        g, pairs = self.graph, list[tuple[Node, Node]]()
        for value, scale in in_determinants(g, self.equations.guards, self.eliminated()):
            # many rows are never all at right angles, and what they could be is far from what they are
            most = g.one if (value, scale) in self.equations.guards else g.number(usual_part(self.system, value, scale))
            pairs.append((value, g.mul(most, scale)))
        return self._guard_determinants(pairs, _FRAME_DIGITS, SINGULAR_FRAME, self.frame_what())

    def eliminated(self) -> dict[Node, Matrix]:
        """The blocks whose pivots are guarded (see :func:`nhc.algebra.solving.blocks.find_eliminated`)."""
        return find_eliminated(self.graph)

    def frame_what(self) -> str:
        """What it means where the coframe is singular."""
        if self.formulation.dependent is None:
            return "the coframe is singular"
        names = ", ".join(f"{self.system.q_names[i]}'" for i in self.formulation.dependent.dependent)
        return f"the constraints cannot be solved for {names}"

    @property
    def exchanges(self) -> PlannerBase | None:
        """The plans of what stands in where a pivot in a fixed order is small; None where none can be."""
        return None

    def _guard_determinants(
        self, pairs: Sequence[tuple[Node, Node]], digits: float, status: int, what: str
    ) -> tuple[GuardPlan, ...]:
        g, once = self.graph, dict[Node, GuardPlan]()
        for value, scale in pairs:
            whole = without_sign(g, value)
            # what is made of parameters alone comes first, for it is divided by ahead of all that depends on the state
            for size in dict.fromkeys((self._still_part(whole), whole)):
                # what is constant, or its own scale, as a sum of squares of coordinates, is only held against zero
                limit = g.zero if size == scale or self.is_constant(size) else scale
                tolerance = float(f"{10.0 ** -(digits + usual_digits(self.system, size, limit)):.2g}")
                once.setdefault(size, GuardPlan(size, limit, tolerance, status, what))
        return tuple(once.values())

    def _still_part(self, determinant: Node) -> Node:
        """The parameters in front of a determinant that moves; itself where there are none."""
        g = self.graph
        if self.is_constant(determinant):
            return determinant
        powers = split_powers(g, determinant)[1]
        still = g.product([g.power(base, n) for base, n in powers.items() if n > 0 and self.is_constant(base)])
        return determinant if still == g.one else still

    def is_constant(self, node: Node) -> bool:
        """Made of parameters and numbers only."""
        return not self.graph.deps[node] & ~self.graph.mask(self.parameters)

    def on_motion(self, nodes: Sequence[Node]) -> list[Node]:
        """Functions of (q, q', t) in terms of the kept state, shortened."""
        g, on = self.graph, moving(self.system, self.equations.motion.velocities)
        made = shorten(g, substitute(g, nodes, on))
        shorter = self._kinetic_on_motion(nodes)
        if not shorter:
            return made
        other = shorten(g, substitute(g, nodes, {**on, **shorter}))
        return min(made, other, key=lambda found: count(g, found))

    def _kinetic_on_motion(self, nodes: Sequence[Node]) -> dict[Node, Node]:
        """T, and T + V, in the words of the axes on which the rows were made, where the nodes contain them."""
        g, system = self.graph, self.system
        energies = {system.T, system.energy}
        if not g.kids[system.T] or energies.isdisjoint(reachable(g, nodes, g.mask(system.v))):
            return {}
        kinetic = self.equations.kinetic()
        return {} if kinetic is None else {system.T: kinetic, system.energy: g.sub(kinetic, system.U)}

    def known(self, nodes: Sequence[Node]) -> list[Node]:
        """Nodes with the rates' symbols replaced by their values (dense unknowns stay symbols)."""
        return substitute(self.graph, nodes, self.solved) if self.solved else list(nodes)

    # --- plans ------------------------------------------------------------------------------------------------

    def plan(
        self,
        name: str,
        about: str,
        equation: str,
        entries: Sequence[Entry],
        guards: tuple[GuardPlan, ...] = (),
        solves: tuple[SolvePlan, ...] = (),
        *,
        size: int | None = None,
    ) -> FunctionPlan:
        """A function of (t, y, p) that writes ``entries`` into its output array, whose ``size`` is theirs if not given."""
        output = {
            "rhs": "dydt",
            "velocities": "qdot",
            "accelerations": "qddot",
            "reactions": "lambda",
            "jacobian": "J",
            "outputs": "out",
        }[name]
        numbers = [equation if e.equation is None else e.equation for e in entries]
        origins = [Origin(number, e.place) for number, e in zip(numbers, entries, strict=True)]
        targets = tuple(Target(k, e.node, e.about, origins[k]) for k, e in enumerate(entries))
        inputs, written = (T_ARGUMENT, self.y, self.p), Argument(output, len(targets) if size is None else size)
        return FunctionPlan(name, about, equation, inputs, written, self.state_loads, targets, None, guards, solves)

    def lower_out(
        self,
        name: str,
        about: str,
        nodes: Sequence[Node],
        texts: Sequence[str] = (),
        guards: tuple[GuardPlan, ...] = (),
        solves: tuple[SolvePlan, ...] = (),
    ) -> Function:
        """A function of (t, y, p) that writes the nodes into ``out``; ``texts`` say what each of them is."""
        about_each = texts or [""] * len(nodes)
        targets = tuple(Target(k, node, text) for k, (node, text) in enumerate(zip(nodes, about_each, strict=True)))
        inputs, output = (T_ARGUMENT, self.y, self.p), Argument("out", len(targets))
        plan = FunctionPlan(name, about, "", inputs, output, self.state_loads, targets, None, guards, solves)
        return lower_function(self.graph, plan, self.system.p)

    def kept_names(self) -> list[str]:
        found = []
        for node in self.equations.motion.w:
            symbol = self.graph.symbol_of(node)
            assert symbol is not None
            found.append(f"{symbol.name}'" if symbol.kind == "velocity" else symbol.name)
        return found

    def state_quantities(self) -> tuple[Quantity, ...]:
        """The full state: the coordinates, then the kept velocities."""
        coordinates = [Quantity(c.name, c.unit, c.about) for c in self.system.spec.coordinates]
        frame = self.formulation.frame
        units = {**added_units(self.system, frame), **self.system.units}
        added = describe_added(self.system, frame)
        kept = [Quantity(name, units.get(name, ""), added.get(name, "")) for name in self.kept_names()]
        return (*coordinates, *kept)


def _about(system: System, i: int) -> str:
    coordinate = system.spec.coordinates[i]
    return f"{coordinate.about} {_unit(coordinate.unit)}".strip()


def _unit(unit: str) -> str:
    return f"[{unit}]" if unit else ""
