"""A run goes on where dry friction sticks, with what it holds at zero as one more constraint, until that breaks loose.

See :mod:`nhc.program.runs.friction` for the mechanics.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from math import copysign

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import is_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.diagnostics import SpecError
from nhc.mechanics.choosing.choose import Formulation, choose
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.system import Form, System
from nhc.program.planning.planner import Planner
from nhc.program.runs.friction import Friction
from nhc.program.runs.leaps import find_functions, name_argument
from nhc.simulate.carrying import place_of
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.task import EVENT, Outcome

TOLD = 6  # changes that are told one by one
_MOST, _NOTHING = 20, 1e-9  # so many times in this part of a run are no motion
_ASIDE = 1e-12  # of the largest entry of a state: how far beside the jump the motion goes on


@dataclass
class Sticking:
    """What dry friction holds in a run: ``loose`` is the job in which nothing is held, ``held`` are those in which something is.

    ``tell`` is told the first of the changes, ``changes`` counts them.
    """

    tell: Callable[[str], None]
    changes: int = 0
    loose: Job | None = None
    held: dict[tuple[Node, ...], Job] = field(default_factory=dict)
    released: Friction | None = None
    times: list[float] = field(default_factory=list)
    _frictions: list[tuple[Job, list[Friction | None]]] = field(default_factory=list)
    _sides: list[tuple[Job, InterpretedModel]] = field(default_factory=list)

    def hold(self, job: Job, outcome: Outcome) -> Job | None:
        """The job that goes on from where a motion is held at a jump of the forces; None where that is no dry friction that acts
        along what it holds, or the run does not get on.
        """
        recipe, system = job.recipe, job.system
        assert recipe is not None
        self.times.append(outcome.t)
        if self.times[:-_MOST] and abs(self.times[-_MOST] - outcome.t) <= _NOTHING * abs(job.time[1] - job.time[0]):
            return None
        friction, place = self._list_frictions(job, recipe)[outcome.status], place_of(job, recipe, outcome)
        if friction is None or place is None or not _value(system, friction.size, place) > 0.0:
            return None
        if not recipe.frictions and job is not self.loose:
            self.loose, self.held = job, {}
        try:
            following = self._hold_by(job, recipe, (*recipe.frictions, friction))
        except (
            SpecError
        ):  # what is held follows from the constraints already, or the rest does not determine the motion
            return None
        self._tell(
            f"from t = {outcome.t:.9g} on dry friction holds `{name_argument(system, friction.function)}` at zero"
        )
        return following

    def _list_frictions(self, job: Job, recipe: Recipe) -> list[Friction | None]:
        """By the arguments of a job's steps (:func:`nhc.program.runs.leaps.find_functions`)."""
        for owner, known in self._frictions:
            if owner is job:
                return known
        values = {symbol: (value, value) for symbol, value in zip(job.system.p, job.p, strict=True)}
        functions = find_functions(Planner(recipe.equations, job.formulation), values)
        self._frictions.append((job, [_find_friction(job.system, function) for function in functions.values()]))
        return self._frictions[-1][1]

    def release(self, job: Job, outcome: Outcome) -> Job | None:
        """The job that goes on from where a friction that held has become as large as it can be; None where none has."""
        recipe = job.recipe
        first = 0 if recipe is None or recipe.event is None else 1
        if recipe is None or outcome.kind != EVENT or outcome.status < first or self.loose is None:
            return None
        self.released = recipe.frictions[outcome.status - first]
        self._tell(f"at t = {outcome.t:.9g} `{name_argument(job.system, self.released.function)}` breaks loose")
        left = tuple(friction for friction in recipe.frictions if friction is not self.released)
        loose = self.loose.recipe
        return self._hold_by(self.loose, loose, left) if left and loose is not None else self.loose

    def let_go(self, job: Job, t: float, y: Sequence[float]) -> Sequence[float]:
        """The state of a job that a run goes on with: a little beside the jump, where one was released."""
        released, self.released = self.released, None
        return y if released is None else _put_aside(job, self._side(job), released, t, y)

    def _side(self, job: Job) -> InterpretedModel:
        """The right-hand side of a job, for the side that a motion leaves to."""
        for owner, model in self._sides:
            if owner is job:
                return model
        functions = tuple(function for function in job.program.functions if function.name == "rhs")
        self._sides.append((job, InterpretedModel(replace(job.program, functions=functions), 0)))
        return self._sides[-1][1]

    def _tell(self, line: str) -> None:
        self.changes += 1
        if self.changes <= TOLD:
            self.tell(line)

    def _hold_by(self, job: Job, recipe: Recipe, frictions: tuple[Friction, ...]) -> Job:
        """The job in which these hold, those of the job's own recipe first.

        Raises:
            nhc.diagnostics.SpecError: the motion is not determined then.
        """
        key = tuple(friction.function for friction in frictions)
        if key not in self.held:
            system = job.system
            for friction in frictions[len(recipe.frictions) :]:
                system = _held(system, friction)
            formulation = _choose(system)
            whole = replace(recipe, equations=equations_of(system, formulation), frictions=frictions)
            self.held[key] = prepare(whole, formulation, job.start)
        return self.held[key]


def _choose(system: System) -> Formulation:
    """The formulation that nhc chooses; quasi-velocities of the spec that are held are no choice any more."""
    try:
        return choose(system)
    except NotApplicable:
        return choose(replace(system, quasi=()))


def _put_aside(job: Job, model: InterpretedModel, released: Friction, t: float, y: Sequence[float]) -> list[float]:
    """The state of ``job``, in which the friction holds no longer, a little to the side that the forces drive it to."""
    assert job.recipe is not None
    n, motion, g = job.system.n, job.recipe.equations.motion, job.system.graph
    on = dict(zip(job.system.v, motion.velocities, strict=True))
    (slip,) = substitute(g, [g.a[released.function]], on)

    def find_slip(t: float, y: Sequence[float]) -> float:
        place = {job.system.t: t, **dict(zip((*job.system.p, *job.system.q, *motion.w), (*job.p, *y), strict=True))}
        return float(evaluate(g, [slip], place)[0])

    size = max(map(abs, y), default=0.0) or 1.0
    begin, moves = find_slip(t, y), list[float]()
    for k in range(n, len(y)):
        moved = [*y[:k], y[k] + size, *y[k + 1 :]]
        moves.append((find_slip(t, moved) - begin) / size)  # it is linear in velocities
    fastest = max(range(len(moves)), key=lambda k: abs(moves[k]))
    best, rates = list(y), list[float]()
    for sign in (1.0, -1.0):
        aside = list(y)
        aside[n + fastest] += (copysign(_ASIDE * size * abs(moves[fastest]), sign) - begin) / moves[fastest]
        h = 1e-6
        later = [a + h * b for a, b in zip(aside, model.rhs(t, aside, job.p), strict=True)]
        rates.append(sign * (find_slip(t + h, later) - find_slip(t, aside)))
        if rates[-1] == max(rates):
            best = aside
    return best


def _find_friction(system: System, function: Node) -> Friction | None:
    """sign(v) as a constraint v = 0, with the force that it is worth along that; None where it is none."""
    g = system.graph
    if g.op[function] != "sign":
        return None
    slip = g.a[function]
    try:
        coefficients, constant = linear_form(g, slip, system.v)
    except NotLinear:
        return None
    ahead, behind = (_with(system, function, g.number(sign)) for sign in (1, -1))
    jump = [g.mul(g.number(Fraction(1, 2)), g.sub(a, b)) for a, b in zip(ahead, behind, strict=True)]
    first = next((i for i, c in enumerate(coefficients) if not is_zero(g, c)), None)
    if first is None or any(
        not is_zero(g, g.sub(g.mul(jump[i], coefficients[first]), g.mul(jump[first], c)))
        for i, c in enumerate(coefficients)
    ):
        return None
    size = g.neg(g.div(jump[first], coefficients[first]))
    form = Form(f"held{function}", coefficients, constant, "", None, slip)
    return Friction(function, form, size, g.symbol(f"friction {function}", "friction"))


def _with(system: System, function: Node, value: Node) -> list[Node]:
    """Q with a value in place of sign(v), and its negative in place of sign(-v)."""
    return substitute(system.graph, system.Q, _in_place(system, function, value))


def _in_place(system: System, function: Node, value: Node) -> dict[Node, Node]:
    g = system.graph
    found = {function: value}
    opposite = g.function("sign", g.neg(g.a[function]))
    if g.op[opposite] == "sign":
        found.setdefault(opposite, g.neg(value))
    return found


def _held(system: System, friction: Friction) -> System:
    """The system with v = 0, and without sign(v) in its forces."""
    g = system.graph
    out = _in_place(system, friction.function, g.zero)
    told = substitute(g, [node for _, node in system.outputs], _in_place(system, friction.function, friction.value))
    names = [name for name, _ in system.outputs]
    torques = [tuple(substitute(g, three, out)) for three in system.torques]
    return replace(
        system,
        Q=tuple(substitute(g, system.Q, out)),
        torques=tuple((a, b, c) for a, b, c in torques),
        constraints=(*system.constraints, friction.form),
        outputs=tuple(zip(names, told, strict=True)),
        dependent=(),
        pulls=None,
        given=None,
    )


def _value(system: System, node: Node, place: Mapping[Node, float]) -> float:
    try:
        return float(evaluate(system.graph, [node], place)[0])
    except (ArithmeticError, ValueError):
        return 0.0
