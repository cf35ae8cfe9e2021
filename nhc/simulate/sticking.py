"""A run goes on where dry friction sticks, with what it holds at zero as one more constraint, until that breaks loose.

See :mod:`nhc.program.runs.friction` for the mechanics.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable
from nhc.diagnostics import SpecError
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.system import System
from nhc.program.planning.planner import Planner
from nhc.program.runs.friction import ROOT, Friction, find_friction
from nhc.program.runs.leaps import find_functions, name_argument
from nhc.program.runs.sharing import list_following
from nhc.simulate.aside import Slip, find_way, list_asides, reach
from nhc.simulate.carrying import carry, place_of
from nhc.simulate.held import hold_by
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.prepare import Job, Recipe, move_start
from nhc.simulate.task import EVENT, HELD, SINGULAR, STALLED, TOO_MANY, UNDERFLOW, Outcome

TOLD = 6  # changes that are told one by one
_MOST, _NOTHING = 20, 1e-9  # so many times in this part of a run are no motion
_OFF = 1e-10  # of the largest velocity: where a slip in a plane begins, whose direction is stiff by friction over mass and speed
_NEAR = 1e-10  # of the largest velocity: slower, a body is at rest
_SLOW = (TOO_MANY, STALLED, UNDERFLOW, SINGULAR)
_ROUNDED = 1e3  # times a slip, of which velocities are that only differ by it
_SHORT = 1e-9  # of a run: shorter steps tell that something is held in a plane
PATIENCE = 1000  # steps after which that is looked for, and twice as many each time that it is in vain
_TOGETHER = 7  # frictions that come to rest at one time
_SLIGHT = 1e-6  # of the largest rate: what a rate may be by rounding


@dataclass
class _Cast:
    """What is asked at single states of a job and of those that were moved from it; ``functions`` by parameters."""

    job: Job
    functions: dict[tuple[float, ...], list[Node]] = field(default_factory=dict)
    models: dict[str, InterpretedModel] = field(default_factory=dict)
    slips: dict[Node, list[Node]] = field(default_factory=dict)


@dataclass
class Sticking:
    """What dry friction holds in a run: ``loose`` is the job in which nothing is held, ``held`` are those in which something is, by
    what that is.  ``tell`` is told the first of the changes, ``changes`` counts them; ``speed`` is the largest so far.
    """

    tell: Callable[[str], None]
    changes: int = 0
    loose: Job | None = None
    held: dict[frozenset[Node], Job | None] = field(default_factory=dict)
    times: list[float] = field(default_factory=list)
    speed: float = 0.0
    patience: int = PATIENCE
    rounded: list[int] = field(default_factory=list)
    _frictions: list[tuple[System, dict[Node, Friction | None]]] = field(default_factory=list)
    _casts: list[_Cast] = field(default_factory=list)

    def begin(self, tell: Callable[[str], None]) -> None:
        """Another run, of the same job or of one that was moved from it."""
        self.tell, self.changes, self.times, self.speed, self.patience = tell, 0, [], 0.0, PATIENCE

    def follow(self, job: Job, outcome: Outcome) -> tuple[Job, list[float]] | None:
        """The job and its state that a run goes on with where friction begins to hold or breaks loose.

        None elsewhere, and where what holds is no dry friction that acts along what it holds, or the run does not get on.
        """
        recipe = job.recipe
        first = 0 if recipe is None or recipe.event is None else 1
        if recipe is None or not (
            outcome.kind in (HELD, *_SLOW) or (outcome.kind == EVENT and outcome.status >= first)
        ):
            return None
        if not recipe.held.frictions and job is not self.loose:
            if self.loose is None or job.program is not self.loose.program:
                self.held, self._casts = {}, []
            self.loose = job
        released = recipe.held.releases[outcome.status - first].frictions if outcome.kind == EVENT else ()
        held = None if released else self._find_held(job, recipe, outcome)
        self.patience *= 2 if outcome.kind in _SLOW else 1
        if (held is None and not released) or not self._gets_on(job, outcome.t):
            return None
        wanted = [friction for friction in recipe.held.frictions if friction not in released]
        found = self._settle(job, recipe, outcome, (*wanted, held) if held is not None else tuple(wanted))
        if found is None or found[0].recipe is None:
            return None
        if found[0] is job and outcome.kind in _SLOW and outcome.kind != SINGULAR:  # where it is slow, it moves
            return None
        self.patience = PATIENCE
        self._tell_changes(job.system, outcome.t, recipe.held.frictions, found[0].recipe.held.frictions)
        return found

    def list_planes(self, job: Job) -> list[Friction]:
        """The frictions in planes that a job does not hold: its steps become short where they hold, and do not say so."""
        held = job.recipe.held.frictions if job.recipe is not None else ()
        system = self.loose.system if held and self.loose is not None else job.system
        roots = [node for node in reachable(system.graph, system.Q) if system.graph.op[node] == ROOT]
        found = [self._friction_of(system, node) for node in roots]
        return [friction for friction in found if friction is not None and friction not in held]

    def is_slow(self, job: Job, outcome: Outcome) -> bool:
        """Whether a run takes steps as short as where something is held in a plane."""
        short = outcome.kind in _SLOW and abs(outcome.h) <= _SHORT * abs(job.time[1] - job.time[0])
        return short and bool(self.list_planes(job))

    def _find_held(self, job: Job, recipe: Recipe, outcome: Outcome) -> Friction | None:
        """What a run begins to hold."""
        if outcome.kind == HELD and self.loose is not None:
            return self._friction_of(self.loose.system, self._functions(job)[outcome.status])
        place = place_of(job, recipe, outcome) if self.is_slow(job, outcome) else None
        if place is None:
            return None
        self._look_at_speed(job, outcome, place)
        still = (x for x in self.list_planes(job) if _is_still(job.system.graph, x, place, self.speed))
        return next(still, None)

    def _look_at_speed(self, job: Job, outcome: Outcome, place: Mapping[Node, float]) -> None:
        fastest = max((*map(abs, outcome.sizes[job.system.n :]), *(abs(place[v]) for v in job.system.v)), default=0.0)
        self.speed = max(self.speed, fastest)

    def _gets_on(self, job: Job, t: float) -> bool:
        self.times.append(t)
        return len(self.times) <= _MOST or abs(self.times[-_MOST - 1] - t) > _NOTHING * abs(job.time[1] - job.time[0])

    def _tell_changes(self, system: System, t: float, before: Sequence[Friction], after: Sequence[Friction]) -> None:
        loose, held = (
            [f"`{name_argument(system, friction.function)}`" for friction in some if friction not in rest]
            for some, rest in ((before, after), (after, before))
        )
        lines = (
            [f"at t = {t:.9g} {' and '.join(loose)} {'break' if len(loose) > 1 else 'breaks'} loose"] if loose else []
        )
        lines += [f"from t = {t:.9g} on dry friction holds {' and '.join(held)} at zero"] if held else []
        for line in lines:
            self.changes += 1
            if self.changes <= TOLD:
                self.tell(line)

    # --- what holds, and what does not ----------------------------------------------------------------------------------

    def _settle(
        self, job: Job, recipe: Recipe, outcome: Outcome, wanted: tuple[Friction, ...]
    ) -> tuple[Job, list[float]] | None:
        """The first of the ways to go on that agrees with itself: what is held needs no more than its friction, the rest leaves.

        What comes to rest at the same time may be held or not; the more is held, the sooner it is tried.
        """
        assert self.loose is not None
        place = place_of(job, recipe, outcome)
        if place is None:
            return None
        g, system = job.system.graph, self.loose.system
        frictions = [self._friction_of(system, function) for function in self._functions(self.loose)]
        frictions = [*dict.fromkeys((*frictions, *wanted, *recipe.held.frictions))]
        self._look_at_speed(job, outcome, place)
        near = [
            friction
            for friction in frictions
            if friction is not None
            and _value(g, friction.size, place) > 0.0
            and (friction in wanted or friction in recipe.held.frictions or _is_still(g, friction, place, self.speed))
        ]
        if not all(friction in near for friction in wanted) or len(near) > _TOGETHER + len(wanted):
            return None
        tried = list[Job]()
        for held in dict.fromkeys((wanted, *_list_choices(near))):
            following = self._hold_by(held)
            if following is None or following.recipe is None or any(following is other for other in tried):
                continue
            tried.append(following)
            others = [friction for friction in near if friction not in following.recipe.held.frictions]
            try:
                y = self._begin(following, job, outcome, others)
            except (ArithmeticError, ValueError):  # it has no values there
                continue
            if y is not None:
                return following, y
        return None

    def _begin(self, following: Job, job: Job, outcome: Outcome, others: Sequence[Friction]) -> list[float] | None:
        """The state of a job with all ``others`` a little beside their jumps, on the sides that forces drive them to.

        None where they drive them back, or what it holds would break loose at once.
        """
        t, y = outcome.t, carry(job, following, outcome)
        slopes = [self._slopes(following, friction, t, y) for friction in others]
        slopes = [rows for rows in slopes if any(any(row[2]) for row in rows)]
        if not slopes:
            return y if self._is_enough(following, t, y) else None
        if any(len(rows) > 1 for rows in slopes):
            return self._leave_plane(following, t, y, slopes[0]) if len(slopes) == 1 else None
        rows = [row for (row,) in slopes]
        best, least, most = None, 0.0, 0.0
        for sides, aside in list_asides(y, following.system.n, rows):
            if not self._is_enough(following, t, aside):
                continue
            rates = [side * rate for side, rate in zip(sides, self._rates(following, t, aside, rows), strict=True)]
            most = max([most, *map(abs, rates)])
            if best is None or min(rates) > least:
                best, least = aside, min(rates)
        return best if least >= -_SLIGHT * most else None

    def _rates(self, job: Job, t: float, y: Sequence[float], rows: Sequence[Slip]) -> list[float]:
        """How fast slips change."""
        rhs = self._model(job, "rhs").rhs(t, y, job.p)
        return [
            along + sum(a * b for a, b in zip((*left, *right), rhs, strict=True)) for _, (along, *left), right in rows
        ]

    def _leave_plane(self, job: Job, t: float, y: Sequence[float], rows: Sequence[Slip]) -> list[float] | None:
        """A state with a slip in the direction in which it grows."""
        n, size, count = job.system.n, _OFF * (self.speed or 1.0), len(rows)

        def find_state(way: Sequence[float]) -> list[float]:
            aims = [size * part / max(map(abs, row[2])) for part, row in zip(way, rows, strict=True)]
            return [*y[:n], *(reach(y[n:], rows, aims) or y[n:])]

        units = [[sign if i == j else 0.0 for i in range(count)] for sign in (1.0, -1.0) for j in range(count)]
        rates = [self._rates(job, t, find_state(unit), rows) for unit in units]
        way = find_way(rates[:count], rates[count:], _SLIGHT)
        aside = None if way is None else find_state(way)
        if aside is None or not self._is_enough(job, t, aside):
            return None
        inside = [i for i in range(len(aside) - n) if any(row[2][i] for row in rows)]
        self.rounded = inside if max((abs(aside[n + i]) for i in inside), default=0.0) > _ROUNDED * size else []
        return aside

    def widen(self, job: Job, sizes: Sequence[float]) -> tuple[float, ...]:
        """The sizes of a state where a slip begins that is what larger velocities leave: their rounding is in all its parts."""
        n, inside = job.system.n, self.rounded if sizes else []
        largest = max((sizes[n + i] for i in inside), default=0.0)
        self.rounded = []
        return tuple(largest if k - n in inside else size for k, size in enumerate(sizes))

    def _slopes(self, job: Job, friction: Friction, t: float, y: Sequence[float]) -> list[Slip]:
        assert job.recipe is not None
        system, motion, g = job.system, job.recipe.equations.motion, job.system.graph
        state, known = (*system.q, *motion.w), self._cast(job).slips
        if friction.function not in known:
            on = dict(zip(system.v, motion.velocities, strict=True))
            values = substitute(g, [form.value for form in friction.forms if form.value is not None], on)
            known[friction.function] = [x for value in values for x in (value, *gradient(g, value, (system.t, *state)))]
        place = {system.t: t, **dict(zip((*system.p, *state), (*job.p, *y), strict=True))}
        found = [float(x) for x in evaluate(g, known[friction.function], place)]
        size = len(found) // len(friction.forms)
        each = [found[k * size : (k + 1) * size] for k in range(len(friction.forms))]
        return [(one[0], one[1 : system.n + 2], one[system.n + 2 :]) for one in each]

    def _is_enough(self, job: Job, t: float, y: Sequence[float]) -> bool:
        """Whether the frictions that hold are as large as they have to be."""
        assert job.recipe is not None
        first = 0 if job.recipe.event is None else 1
        if not job.recipe.held.releases:
            return True
        values = self._model(job, "watch").watch(t, y, job.p)
        return all(value > 0.0 for value in values[first : first + len(job.recipe.held.releases)])

    # --- what is made once ----------------------------------------------------------------------------------------------

    def _hold_by(self, frictions: tuple[Friction, ...]) -> Job | None:
        """The job in which these hold, and what follows from them; None where the constraints hold them, or the rest does not tell
        the motion.
        """
        assert self.loose is not None and self.loose.recipe is not None
        if not frictions:
            return self.loose
        system, order = self.loose.system, self._functions(self.loose)
        known = (self._friction_of(system, function) for function in order)
        left = [friction for friction in known if friction is not None and friction not in frictions]
        whole = (*frictions, *list_following(system, frictions, left))
        key = frozenset(friction.function for friction in whole)
        if key not in self.held:
            try:
                self.held[key] = hold_by(self.loose, self.loose.recipe, whole)
            except (NotApplicable, Singular, SpecError):
                self.held[key] = None
        found = self.held[key]
        if found is not None and found.start is not self.loose.start:
            self.held[key] = found = move_start(found, self.loose.start)
        return found

    def _cast(self, job: Job) -> _Cast:
        for cast in self._casts:
            if cast.job.program is job.program:
                return cast
        self._casts.append(_Cast(job))
        return self._casts[-1]

    def _functions(self, job: Job) -> list[Node]:
        """Those of the arguments of a job's steps."""
        known = self._cast(job).functions
        if job.p not in known and job.recipe is not None:
            values = {symbol: (value, value) for symbol, value in zip(job.system.p, job.p, strict=True)}
            known[job.p] = [*find_functions(Planner(job.recipe.equations, job.formulation), values).values()]
        return known.get(job.p, [])

    def _friction_of(self, system: System, function: Node) -> Friction | None:
        """That of a function, in a system in which nothing is held."""
        known = next((known for owner, known in self._frictions if owner is system), None)
        if known is None:
            known = {}
            self._frictions.append((system, known))
        if function not in known:
            known[function] = find_friction(system, function)
        return known[function]

    def _model(self, job: Job, name: str) -> InterpretedModel:
        """One function of a job, for single calls."""
        models = self._cast(job).models
        if name not in models:
            functions = tuple(function for function in job.program.functions if function.name == name)
            models[name] = InterpretedModel(replace(job.program, functions=functions), job.events)
        return models[name]


def _list_choices(near: Sequence[Friction]) -> Iterator[tuple[Friction, ...]]:
    for size in range(len(near), -1, -1):
        yield from combinations(near, size)


def _is_still(graph: Graph, friction: Friction, place: Mapping[Node, float], speed: float) -> bool:
    return all(
        abs(_value(graph, form.value, place)) <= _NEAR * speed for form in friction.forms if form.value is not None
    )


def _value(graph: Graph, node: Node, place: Mapping[Node, float]) -> float:
    """The node's value; none is no number."""
    try:
        return float(evaluate(graph, [node], place)[0])
    except (ArithmeticError, ValueError):
        return float("nan")
