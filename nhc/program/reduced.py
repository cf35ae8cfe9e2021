"""The program of a scene: the smallest model that delivers what the scene needs (:mod:`nhc.mechanics.reduce`)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from nhc.algebra.calculus import count, reachable, substitute
from nhc.algebra.graph import Node
from nhc.algebra.evaluate import evaluate
from nhc.algebra.modular import Unlucky, are_zero
from nhc.algebra.shorten import shorten
from nhc.language.spec import Scene
from nhc.mechanics.associate import Equations, Motion
from nhc.mechanics.choose import Formulation
from nhc.mechanics.formulate import bordered_system, equations_of
from nhc.mechanics.kinetic import Kinetic, kinetic_structure
from nhc.mechanics.reduce import Reduction, reduce_equations
from nhc.mechanics.regularity import intervals
from nhc.mechanics.scene_frames import free_forms, list_formulations, momentum_formulation
from nhc.mechanics.scenes import Start, kept_velocities, start_of
from nhc.mechanics.system import Form, System
from nhc.program.build import Planner
from nhc.program.ir import Function, Program, Quantity, SceneData
from nhc.program.lower import lower_function
from nhc.program.model import build_program, state_quantities
from nhc.program.naming import identifier
from nhc.program.plan import FunctionPlan

SCENE_FUNCTIONS = ("rhs", "state", "jacobian", "outputs")
ENTRY, DIVISION, CALL = 80, 8, 20
"""What an entry of the state (stages to combine, a row and a column of the Jacobian), a division and a function cost."""
_NEAR = 1.05
"""How much dearer the first formulation may be and still be taken, for the sake of the spec's own names."""
_WEAK = 0.02
_LARGE = 1500
"""Operations of the equations beyond which only the formulation itself is reduced: trying others would take seconds each."""


@dataclass
class ScenePlanner(Planner):
    """Plans over the kept state; what is left out has been given a value that its equations do not depend on."""

    reduction: Reduction = field(kw_only=True)
    shorter: bool = field(default=True, kw_only=True)

    def _arrange(self) -> None:
        made, system, w = self.reduction, self.system, self.equations.motion.w
        self.kept_q = tuple(i for i in made.kept if i < system.n)
        self.kept_w = tuple(i - system.n for i in made.kept if i >= system.n)
        entries = (*system.q, *w)
        self.parameters = (*system.p, *(entries[i] for i in made.constants))
        self.put_in = dict(made.fixed)
        self.original, self.equations = self.equations, self._fixed_equations()
        super()._arrange()
        for k, i in enumerate(made.constants):
            about = f"constant of the motion: {made.names[i]}"
            self.state_loads[entries[i]] = ("p", len(system.p) + k, about)

    def fix(self, nodes: Sequence[Node]) -> list[Node]:
        """Nodes over the full state in terms of what is kept; shorter where they can be."""
        made = substitute(self.graph, nodes, self.put_in)
        if made == list(nodes):
            return made
        zero = are_zero(self.graph, made)
        made = [self.graph.zero if z else x for x, z in zip(made, zero, strict=True)]
        return shorten(self.graph, made) if self.shorter else made

    def _fixed_equations(self) -> Equations:
        equations, g = self.equations, self.graph
        size, motion = len(equations.mass), equations.motion
        held = {i for i in (*self.reduction.kept, *self.reduction.constants) if i < len(motion.velocities)}
        velocities = iter(self.fix([node for i, node in enumerate(motion.velocities) if i in held]))
        moved = tuple(next(velocities) if i in held else g.zero for i in range(len(motion.velocities)))
        made = Motion(motion.w, motion.rates, moved, motion.vectors)
        guards = [x for pair in equations.guards for x in pair]
        guards = substitute(g, guards, self.put_in)
        moving = [(guards[k], guards[k + 1]) for k in range(0, len(guards), 2) if g.value(guards[k]) is None]
        pairs = tuple(dict.fromkeys(moving))
        if not equations.definite:
            return replace(equations, motion=made, guards=pairs)
        flat = self.fix([*(x for row in equations.mass for x in row), *equations.force])
        mass = tuple(tuple(flat[k * size : (k + 1) * size]) for k in range(size))
        return replace(equations, motion=made, mass=mass, force=tuple(flat[size * size :]), guards=pairs)

    def _solve(self) -> None:
        super()._solve()
        wanted = [self.solved[self.equations.motion.rates[k]] for k in self.kept_w if self.solved]
        wanted += self.known([node for node, _ in self._columns()]) if self.solved else []
        seen = set(reachable(self.graph, wanted))
        self.mass_guards = tuple(guard for guard in self.mass_guards if guard.value in seen)

    def _dense(self) -> tuple[list[list[Node]], list[Node]]:
        """The fixed equations; a bordered system is made from the full ones first."""
        size = len(self.original.mass)
        if self.original.multipliers:
            matrix, right = bordered_system(self.original)
            size = len(right)
            flat = self.fix([*(x for row in matrix for x in row), *right])
        elif self.original.definite:
            return [list(row) for row in self.equations.mass], list(self.equations.force)
        else:
            flat = self.fix([*(x for row in self.original.mass for x in row), *self.original.force])
        return [flat[k * size : (k + 1) * size] for k in range(size)], flat[size * size :]

    def _columns(self) -> list[tuple[Node, str]]:
        nodes = substitute(self.graph, [column.node for column in self.reduction.outputs], self.put_in)
        return [(node, column.name) for node, column in zip(nodes, self.reduction.outputs, strict=True)]

    def outputs(self) -> FunctionPlan:
        """What the scene needs, in its order."""
        columns = self._columns()
        nodes = shorten(self.graph, self.known([node for node, _ in columns]))
        rates = self.graph.mask((*self.equations.motion.rates, *self.equations.multipliers))
        moving = any(self.graph.depends(node, rates) for node, _ in columns)
        written = [(node, name, "") for node, (_, name) in zip(nodes, columns, strict=True)]
        plain = all(node in self.state_loads for node in nodes)  # then there is nothing that can be singular
        guards = () if plain else self.frame_guards() + (self.mass_guards if moving else ())
        return self.plan(
            "outputs", "what the scene needs", "", len(written), written, guards, self.solves if moving else ()
        )


@dataclass(frozen=True)
class Tried:
    """A formulation that was tried for a scene, with the operations of its right-hand side and its cost.

    ``rejected`` says why it could not be taken, if so; nothing was counted then.
    """

    formulation: str
    reason: str
    state: tuple[str, ...]
    constants: tuple[str, ...]
    operations: int = -1
    cost: int = -1
    rejected: str = ""


@dataclass(frozen=True)
class SceneModel:
    """The reduction that was chosen, its planner, what was tried, and the operations of the full right-hand side."""

    system: System
    scene: Scene
    start: Start
    reduction: Reduction
    planner: ScenePlanner
    tried: tuple[Tried, ...]
    full_formulation: str
    full_state: tuple[str, ...]
    full_operations: int
    operations: int
    chosen: int


def count_operations_of(function: Function) -> int:
    """Additions, multiplications, divisions and calls together."""
    return function.adds + function.multiplications + function.divisions + function.calls


def _lower_rhs(planner: Planner) -> Function:
    return lower_function(planner.graph, planner.rhs(), planner.parameters)


def scene_model(system: System, base: Formulation, scene: Scene, *, only_base: bool, fold: bool = False) -> SceneModel:
    """The cheapest model for a scene over all formulations and coframes that are tried; the first of equals.

    ``only_base``: the user fixed the formulation; ``fold``: the scene's parameter values are put in.

    Raises:
        nhc.diagnostics.SpecError: the scene has no consistent start.
    """
    start = start_of(system, scene)
    kinetic = kinetic_structure(system)
    equations = equations_of(system, base, kinetic)
    search = _Search(system, scene, start, kinetic, _fold(system, start) if fold else {})
    search.take_base(equations, base)
    if not only_base:
        search.take_momenta(equations, base)
    if not only_base and count(system.graph, [*equations.force, *equations.motion.velocities]) <= _LARGE:
        for other in list_formulations(system, base, kinetic, scene):
            search.take_formulation(other)
    best = search.best()
    full = Planner(equations, base)
    return SceneModel(
        system=system,
        scene=scene,
        start=start,
        reduction=best.planner.reduction,
        planner=best.planner,
        tried=tuple(search.tried),
        full_formulation=base.name,
        full_state=(*system.q_names, *full.kept_names()),
        full_operations=count_operations_of(_lower_rhs(full)),
        operations=search.tried[best.place].operations,
        chosen=best.place,
    )


def _fold(system: System, start: Start) -> dict[Node, Node]:
    g = system.graph
    return {symbol: g.number(Fraction(value)) for symbol, value in zip(system.p, start.p, strict=True)}


@dataclass(frozen=True)
class _Found:
    """A reduction that may be taken; ``place`` is its index among those tried."""

    place: int
    cost: int
    planner: ScenePlanner


class _Search:
    """Reductions of several formulations; the cheapest wins, the first of those that cost about the same."""

    def __init__(
        self, system: System, scene: Scene, start: Start, kinetic: Kinetic, folded: Mapping[Node, Node]
    ) -> None:
        self.system, self.scene, self.start, self.kinetic, self.folded = system, scene, start, kinetic, folded
        values = dict(zip(system.p, start.p, strict=True))
        self.known = {**intervals(system), **{symbol: (value, value) for symbol, value in values.items()}}
        self.found: list[_Found] = []
        self.tried: list[Tried] = []
        self.seen: set[tuple[Form, ...]] = set()

    def take_base(self, equations: Equations, formulation: Formulation) -> None:
        """The formulation that the spec, the user or nhc has chosen, which needs no proof that it is regular."""
        self._is_known(formulation)
        self.take(equations, formulation, trusted=True)

    def take_formulation(self, formulation: Formulation) -> None:
        """A coframe counts when it is regular wherever the scene may go, and so do its momenta."""
        if self._is_known(formulation):
            return
        equations = equations_of(self.system, formulation, self.kinetic)
        if self.take(equations, formulation, trusted=False):
            self.take_momenta(equations, formulation)

    def take_momenta(self, equations: Equations, formulation: Formulation) -> None:
        """The same with conserved momenta in place of their velocities, where there are any."""
        made = momentum_formulation(equations, formulation)
        if made is None or self._is_known(made):
            return
        new = equations_of(self.system, made, self.kinetic)
        self.take(new, made, trusted=True, weak=self._is_weak_at_start(new))

    def _is_weak_at_start(self, equations: Equations) -> bool:
        """Whether the velocities follow from the momenta with a loss of digits where the scene starts (a top that stands up)."""
        nodes = [node for pair in equations.guards for node in pair]
        try:
            values = [abs(float(x)) for x in evaluate(self.system.graph, nodes, self.start.values(self.system))]
        except (ArithmeticError, ValueError):
            return True
        return any(value < _WEAK * scale for value, scale in zip(values[::2], values[1::2], strict=True))

    def _is_known(self, formulation: Formulation) -> bool:
        """Whether its free velocities were tried before, perhaps under another name."""
        forms = free_forms(self.system, formulation.frame)
        key = tuple(Form("", form.coefficients, form.constant) for form in forms)
        known = key in self.seen
        self.seen.add(key)
        return known

    def take(self, equations: Equations, formulation: Formulation, *, trusted: bool, weak: bool = False) -> bool:
        """Reduce; ``trusted`` formulations need no proof that they are regular, ``weak`` ones cannot be taken."""
        try:
            made = reduce_equations(equations, formulation, self.scene, self.known, self.folded)
        except Unlucky:
            return False
        regular = trusted or made.regular or (formulation.dependent is not None and formulation.dependent.regular)
        why = "" if regular else "its coframe may become singular"
        if weak:
            regular, why = False, "its coframe is weak where the scene starts"
        constants = tuple(made.names[i] for i in made.constants)
        tried = Tried(formulation.name, formulation.reason, made.state, constants, rejected=why)
        if regular:
            operations, cost, planner = _cheapest_planner(made)
            tried = replace(tried, operations=operations, cost=cost)
            self.found.append(_Found(len(self.tried), cost, planner))
        self.tried.append(tried)
        return regular

    def best(self) -> _Found:
        """The first that costs hardly more than the cheapest."""
        least = min(found.cost for found in self.found)
        return next(found for found in self.found if found.cost <= _NEAR * least)


def _cheapest_planner(made: Reduction) -> tuple[int, int, ScenePlanner]:
    """(operations, cost, planner); canonical forms are used only where they help."""
    found = []
    for shorter in (True, False) if made.fixed else (True,):
        planner = ScenePlanner(made.equations, made.formulation, reduction=made, shorter=shorter)
        rhs = _lower_rhs(planner)
        work = rhs.adds + rhs.multiplications + DIVISION * rhs.divisions + CALL * rhs.calls
        found.append((count_operations_of(rhs), work + ENTRY * len(made.kept), planner))
    return min(found, key=lambda entry: entry[1])


# --- the program --------------------------------------------------------------------------------------------------


def build_scene_program(model: SceneModel, only: Sequence[str] = ()) -> Program:
    """The program of a scene: its state, its constants after the spec's parameters, and its needs as the outputs."""
    system, made, planner = model.system, model.reduction, model.planner
    everything = (*model.start.q, *kept_velocities(system, planner.kept_forms(), model.start))
    constants = tuple(everything[i] for i in made.constants)
    columns = made.outputs
    full = build_program(system, made.formulation, made.equations, only=("none",), scene=model.scene.name)
    data = SceneData(
        model.scene.name,
        model.scene.about,
        tuple(everything[i] for i in made.kept),
        (*model.start.p, *constants),
        model.start.time,
        tuple(column.name for column in columns),
        float(model.scene.tolerance),
    )
    quantities = state_quantities(system, planner)
    return replace(
        full,
        state=tuple(quantities[i] for i in made.kept),
        parameters=(*full.parameters, *_constants(quantities, made, constants)),
        outputs=tuple(Quantity(c.name, identifier(c.name), c.unit, c.about) for c in columns),
        functions=_functions(planner, only),
        scenes=(data,),
        notes=(*full.notes, *_notes(model)),
    )


def _constants(quantities: Sequence[Quantity], made: Reduction, values: Sequence[float]) -> tuple[Quantity, ...]:
    about = "constant of the motion, from the start of the scene"
    return tuple(
        replace(quantities[i], about=about, default=value) for i, value in zip(made.constants, values, strict=True)
    )


def _functions(planner: ScenePlanner, only: Sequence[str]) -> tuple[Function, ...]:
    found = []
    known = all(name in SCENE_FUNCTIONS for name in only)  # what is asked for and not there is the emitter's to refuse
    for name in SCENE_FUNCTIONS:
        if only and known and name not in only:
            continue
        plan: FunctionPlan = getattr(planner, name)()
        found.append(lower_function(planner.graph, plan, planner.parameters))
    return tuple(found)


def _notes(model: SceneModel) -> list[str]:
    before, after = len(model.full_state), len(model.reduction.kept)
    needs = ", ".join(column.name for column in model.reduction.outputs)
    lines = [f"reduced for the scene {model.scene.name}, which needs {needs}: {after} of {before} states"]
    lines += [f"left out: {omission.name}: {omission.reason}" for omission in model.reduction.left]
    return lines
