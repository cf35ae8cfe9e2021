"""A run goes on where dry friction sticks, with what it holds at zero as one more constraint, until that breaks loose.

See :mod:`nhc.program.runs.friction` for the mechanics.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.algebra.walks import count, reachable
from nhc.diagnostics import SpecError
from nhc.mechanics.choosing.choose import Formulation, choose
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.system import Form, System
from nhc.program.planning.planner import Planner
from nhc.program.runs.friction import Friction
from nhc.program.runs.leaps import find_functions, name_argument
from nhc.simulate.carrying import carry, place_of
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.task import EVENT, Outcome

TOLD = 6  # changes that are told one by one
_TERMS = 60  # of a friction's size, up to which it is brought to its canonical form
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
    _models: list[tuple[Job, str, InterpretedModel]] = field(default_factory=list)

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
            NotApplicable,
            Singular,
            SpecError,
        ):  # it follows from the constraints, or the rest does not tell the motion
            return None
        if not self._is_enough(following, outcome.t, carry(job, following, outcome)):
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

    def _is_enough(self, job: Job, t: float, y: Sequence[float]) -> bool:
        """Whether the frictions that hold are as large as they have to be: two along one velocity hold more than each of them."""
        assert job.recipe is not None
        first = 0 if job.recipe.event is None else 1
        values = self._model(job, "watch").watch(t, y, job.p)
        return all(value > 0.0 for value in values[first : first + len(job.recipe.frictions)])

    def let_go(self, job: Job, t: float, y: Sequence[float]) -> Sequence[float]:
        """The state of a job that a run goes on with: a little beside the jump, where one was released."""
        released, self.released = self.released, None
        return y if released is None else _put_aside(job, self._model(job, "rhs"), released, t, y)

    def _model(self, job: Job, name: str) -> InterpretedModel:
        """One function of a job, for single calls."""
        for owner, known, model in self._models:
            if owner is job and known == name:
                return model
        functions = tuple(function for function in job.program.functions if function.name == name)
        self._models.append((job, name, InterpretedModel(replace(job.program, functions=functions), job.events)))
        return self._models[-1][2]

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
    system, motion, g = job.system, job.recipe.equations.motion, job.system.graph
    (slip,) = substitute(g, [g.a[released.function]], dict(zip(system.v, motion.velocities, strict=True)))
    state = (*system.q, *motion.w)
    slopes = gradient(g, slip, (system.t, *state))

    def evaluate_at(nodes: Sequence[Node], y: Sequence[float]) -> list[float]:
        place = {system.t: t, **dict(zip((*system.p, *state), (*job.p, *y), strict=True))}
        return [float(value) for value in evaluate(g, nodes, place)]

    begin, *moves = evaluate_at([slip, *slopes[1 + system.n :]], y)  # it is linear in velocities
    fastest = max(range(len(moves)), key=lambda k: abs(moves[k]))
    size = max(map(abs, y), default=0.0) or 1.0
    sides = list[tuple[float, list[float]]]()
    for sign in (1.0, -1.0):
        aside = list(y)
        aside[system.n + fastest] += (sign * _ASIDE * size * abs(moves[fastest]) - begin) / moves[fastest]
        along, *rates = evaluate_at(slopes, aside)
        rate = along + sum(a * b for a, b in zip(rates, model.rhs(t, aside, job.p), strict=True))
        sides.append((sign * rate, aside))
    return max(sides)[1]


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
    elsewhere = [system.T, system.U, *(x for form in system.constraints for x in (*form.coefficients, form.constant))]
    if function in reachable(g, elsewhere):
        return None
    ahead, behind, still = (_with(system, function, g.number(sign)) for sign in (1, -1, 0))
    jumps = [g.sub(a, b) for a, b in zip(ahead, behind, strict=True)]  # -2 c dv/dq'
    sums = [g.sub(g.add(a, b), g.add(c, c)) for a, b, c in zip(ahead, behind, still, strict=True)]
    square = g.dot(coefficients, coefficients)
    if not all(are_zero(g, sums)) or is_zero(g, square):
        return None
    single = [g.div(jump, a) for jump, a in zip(jumps, coefficients, strict=True) if not is_zero(g, a)]
    ratios = [normalise(g, ratio, _TERMS) for ratio in (g.div(g.dot(jumps, coefficients), square), *single)]
    whole = min(ratios, key=lambda ratio: count(g, [ratio]))  # what is longer may have a zero of its own below its line
    if not all(are_zero(g, [g.sub(jump, g.mul(whole, a)) for jump, a in zip(jumps, coefficients, strict=True)])):
        return None
    size = g.mul(g.number(Fraction(-1, 2)), whole)
    form = Form(f"held{function}", coefficients, constant, "", None, slip)
    return Friction(function, form, size, g.symbol(f"friction {function}", "friction"))


def _with(system: System, function: Node, value: Node) -> list[Node]:
    """Q with a value in place of sign(v)."""
    return substitute(system.graph, system.Q, _in_place(system, function, value))


def _in_place(system: System, function: Node, value: Node) -> dict[Node, Node]:
    """A value in place of sign(v), and what follows from that of sign(k v) with a number k."""
    g, found = system.graph, {function: value}
    for node in reachable(g, system.Q):
        if g.op[node] == "sign" and node != function:
            ratio = g.value(normalise(g, g.div(g.a[node], g.a[function]), _TERMS))
            if ratio is not None:
                found[node] = value if ratio > 0 else g.neg(value)
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
