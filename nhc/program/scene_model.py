"""The cheapest model of a scene over formulations and coframes."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import Unlucky
from nhc.algebra.graph import Node
from nhc.algebra.walks import count
from nhc.language.spec import Scene
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.choosing.conditioning import find_start
from nhc.mechanics.energies.kinetic import Kinetic, kinetic_structure
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import kept_forms
from nhc.mechanics.reduction.quadrature import find_closed
from nhc.mechanics.reduction.reduce import Reduction, keep_everything, reduce_equations
from nhc.mechanics.reduction.scene_frames import list_formulations, momentum_formulation
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.mechanics.system import Form, System
from nhc.program.ir import Function
from nhc.program.lowering.lower import lower_function
from nhc.program.planning.planner import Planner
from nhc.program.planning.rewrite import rewrite
from nhc.program.planning.scene import ScenePlanner
from nhc.program.runs.starting import refuse_massless
from nhc.records import record

ENTRY, DIVISION, CALL = 80, 8, 20
"""What an entry of the state (stages to combine, a row and a column of the Jacobian), a division and a function cost."""
_NEAR = 1.05
"""How much dearer the first formulation may be and still be taken, for the sake of the spec's own names."""
_WEAK = 0.02
WEAK_THERE = "its coframe is weak where the scene starts"
_MANY = 40
"""Velocities beyond which no momenta are tried: they undo the recursion that keeps long chains short."""
_LARGE = 10_000
"""Operations of the equations beyond which only the formulation itself is reduced: trying others would take seconds each."""


@record
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


@record
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
    folded: bool = False


def count_operations_of(function: Function) -> int:
    """Additions, multiplications, divisions and calls together."""
    return function.adds + function.multiplications + function.divisions + function.calls


def _lower_rhs(planner: Planner) -> Function:
    return lower_function(planner.graph, rewrite(planner, planner.rhs()), planner.parameters)


def scene_model(system: System, base: Formulation, scene: Scene, *, only_base: bool, fold: bool = False) -> SceneModel:
    """The cheapest model for a scene over all formulations and coframes that are tried; the first of equals.

    ``only_base``: the user fixed the formulation; ``fold``: the scene's parameter values are put in.  Where the coframe of ``base``
    is nearly singular at the start and another is not, that is what the others are compared with.

    Raises:
        nhc.diagnostics.SpecError: the scene has no consistent start, or a coordinate no inertia there.
    """
    start = start_of(system, scene)
    kinetic = kinetic_structure(system)
    equations = equations_of(system, base, kinetic)
    search = _Search(system, scene, start, kinetic, _fold(system, start) if fold else {})
    full, other = Planner(equations, base), None
    refuse_massless(full, start)
    if not only_base:
        other = search.find_start(equations, base)
    if other is not None:
        base, equations = other, equations_of(system, other, kinetic)
    search.take_base(equations, base)
    if not only_base:
        search.take_momenta(equations, base)
    if not only_base and count(system.graph, [*equations.force, *equations.motion.velocities]) <= _LARGE:
        for made in list_formulations(system, base, kinetic, scene):
            search.take_formulation(made)
    best = search.best()
    return SceneModel(
        system=system,
        scene=scene,
        start=start,
        reduction=best.planner.reduction,
        planner=best.planner,
        tried=tuple(search.tried),
        full_formulation=full.formulation.name,
        full_state=(*system.q_names, *full.kept_names()),
        full_operations=count_operations_of(_lower_rhs(full)),
        operations=search.tried[best.place].operations,
        chosen=best.place,
        folded=fold,
    )


def reduce_one(equations: Equations, formulation: Formulation, start: Start) -> ScenePlanner:
    """The reduction of one formulation to what the scene needs, without trying others."""
    system = equations.system
    known = {**intervals(system), **{symbol: (x, x) for symbol, x in zip(system.p, start.p, strict=True)}}
    try:
        return _cheapest_planner(reduce_equations(equations, formulation, start.scene, known))[2]
    except (Unlucky, ZeroDivisionError):  # singular, or so at the values that stand for what is left out
        return _cheapest_planner(keep_everything(equations, formulation, start.scene))[2]


def _fold(system: System, start: Start) -> dict[Node, Node]:
    g = system.graph
    return {symbol: g.number(Fraction(value)) for symbol, value in zip(system.p, start.p, strict=True)}


@record
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
        self.closed = find_closed(system, start.values(system))
        self.found: list[_Found] = []
        self.tried: list[Tried] = []
        self.seen: set[tuple[Form, ...]] = set()

    def find_start(self, equations: Equations, base: Formulation) -> Formulation | None:
        """What is better than ``base`` where its coframe is weak at the start, which is then noted among those tried; or None."""
        if not self._is_weak_at_start(equations):
            return None
        found = find_start(self.system, base, self.start)
        if found is not None:
            self._is_known(base)
            state = (*self.system.q_names, *Planner(equations, base).kept_names())
            self.tried.append(Tried(base.name, base.reason, state, (), rejected=WEAK_THERE))
        return found

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
        if self.system.n - self.system.l > _MANY:
            return
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
        # the scale of a determinant of parameters may be zero with it
        return not all(value > _WEAK * scale for value, scale in zip(values[::2], values[1::2], strict=True))

    def _is_known(self, formulation: Formulation) -> bool:
        """Whether its free velocities were tried before, perhaps under another name."""
        forms = kept_forms(self.system, formulation.frame)
        key = tuple(Form("", form.coefficients, form.constant) for form in forms)
        known = key in self.seen
        self.seen.add(key)
        return known

    def take(self, equations: Equations, formulation: Formulation, *, trusted: bool, weak: bool = False) -> bool:
        """Reduce; ``trusted`` formulations need no proof that they are regular, ``weak`` ones cannot be taken."""
        try:
            made = reduce_equations(equations, formulation, self.scene, self.known, self.folded, self.closed)
        except (Unlucky, ZeroDivisionError):  # singular, or so at the values that stand for what is left out
            if not trusted or self.found:
                return False
            made = keep_everything(equations, formulation, self.scene)
        regular = trusted or made.regular or (formulation.dependent is not None and formulation.dependent.regular)
        why = "" if regular else "its coframe may become singular"
        if weak:
            regular, why = False, WEAK_THERE
        operations, cost = -1, -1
        if regular:
            try:
                operations, cost, planner = self._cheapest(made)
            except ZeroDivisionError:
                if self.found:
                    return False
                operations, cost, planner = self._cheapest(keep_everything(equations, formulation, self.scene))
            made = planner.reduction
            self.found.append(_Found(len(self.tried), cost, planner))
        integrated = [made.names[integral.index] for integral in made.integrals]
        constants = (*(made.names[i] for i in made.constants), *(f"{name} integrated" for name in integrated))
        tried = Tried(formulation.name, formulation.reason, made.state, constants, operations, cost, why)
        self.tried.append(tried)
        return regular

    def _cheapest(self, made: Reduction) -> tuple[int, int, ScenePlanner]:
        """With the constraints' integrals, or without them where their functions cost more than an equation."""
        found = _cheapest_planner(made)
        if not (self.closed and made.integrals):
            return found
        plain = reduce_equations(made.equations, made.formulation, self.scene, self.known, self.folded)
        return min(found, _cheapest_planner(plain), key=lambda entry: entry[1])

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
