"""One trajectory through several formulations and methods.

Where a formulation becomes nearly singular the run goes on with another, the state being carried over by way of q and q'.  A
change waits for a choice of free velocities that is better by a good factor (:mod:`nhc.mechanics.choosing.conditioning`), so
that a run near the middle between two of them does not go back and forth.  Where the steps of an explicit method are held by its
stability, the run goes on with an implicit one if that takes steps long enough to pay, and back where it no longer does.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from nhc.mechanics.choosing.conditioning import Choice, conditioning, find_better, is_mass_sound, name_of
from nhc.program.planning.base import SINGULAR_FRAME
from nhc.records import record
from nhc.simulate.carrying import carry, carry_sizes, implicit_job, is_same, make_job, place_of
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.pacing import Pace
from nhc.simulate.prepare import Job, Recipe
from nhc.simulate.sticking import TOLD, Sticking
from nhc.simulate.task import CROSSED, DONE, EVENT, HELD, SINGULAR, TOO_MANY, Outcome, Task

SOUND = 0.01
"""Of a coframe's determinant over the lengths of its rows: from here on nothing is said."""
_FRAME = ("frame", "deep")
_NEAR = {
    "deep": "the coframe is nearly singular, and no other choice is better",
    "mass": "the mass matrix is nearly singular, as it is where the coordinates are",
    **dict.fromkeys(("rank", "row"), "the constraints nearly lose rank"),
    "whole": "the constraints and the mass matrix hardly determine the accelerations",
}


@record
class Leg:
    """A part of a trajectory: ``task`` from its start, with all times that were still to come, and what came out."""

    job: Job
    method: str
    task: Task
    outcome: Outcome


@dataclass
class Follower:
    """``integrate`` runs a job's task with a method; the same follower may run several tasks of its job.

    ``auto``: the method may be changed; else a stiff scene is only told.
    """

    job: Job
    method: str
    integrate: Callable[[Job, str, Task], Outcome]
    auto: bool = False
    told: dict[str, None] = field(default_factory=dict)
    changes: int = 0
    paces: int = 0
    jobs: list[Job] = field(default_factory=list)
    implicit: list[tuple[Job, Job]] = field(default_factory=list)
    sticking: Sticking = field(default_factory=lambda: Sticking(lambda line: None))

    @property
    def notes(self) -> tuple[str, ...]:
        """What happened in the last run."""
        rest = (
            (self.changes, "more changes of the formulation"),
            (self.sticking.changes, "more times friction begins to hold or breaks loose"),
            (self.paces, "more changes of the method, or reasons for one"),
        )
        return (*self.told, *(f"{count - TOLD} {what}" for count, what in rest if count > TOLD))

    def run(self, task: Task) -> list[Leg]:
        """The legs of a run; the outcome of the last one says how it ended."""
        job, legs, first = self.job, list[Leg](), task
        self.told, self.changes, self.paces = {}, 0, 0
        pace = Pace(self.method, task, self.auto, self._say_pace)
        self.sticking.begin(self._say)
        while True:
            most = self._find_most(job, task, pace)
            outcome = self.integrate(job, pace.method, replace(task, most=min(most, pace.most)))
            legs.append(Leg(job, pace.method, task, outcome))
            more = most < pace.most
            pace.count(outcome)
            stuck = self._stick(legs)
            following = stuck[0] if stuck is not None else self._decide(legs[-1])
            if following is None:
                following = self._pace(pace, legs[-1]) or (job if more and outcome.kind == TOO_MANY else None)
            rest = task.times[len(outcome.states) :]
            if following is None or not rest:
                pace.finish()
                over = following is not None  # what it would go on from is the end itself
                return [*legs[:-1], replace(legs[-1], outcome=replace(outcome, kind=DONE, status=0))] if over else legs
            # what was left out of its state cannot be carried over: once more
            if job.kept is None and following.kept is not None:
                return self._repeat(following, first)
            same = is_same(job.formulation, following.formulation)
            y = stuck[1] if stuck is not None else outcome.y if same else carry(job, following, outcome)
            if outcome.t == task.times[0]:  # nothing came of it
                legs.pop()
                rest = task.times[1:]
            sizes = self.sticking.widen(following, carry_sizes(job, following, outcome))
            job, task = following, replace(task, y=y, times=(outcome.t, *rest), sizes=sizes)

    def _repeat(self, whole: Job, task: Task) -> list[Leg]:
        self.job, self.jobs = whole, []
        return self.run(replace(task, y=whole.y, p=whole.p, sizes=()))

    def _pace(self, pace: Pace, leg: Leg) -> Job | None:
        former = pace.method
        following = pace.look(leg.job, leg.task.times[0], leg.outcome)
        if pace.method != former:
            self.jobs = []  # they lack the Jacobian, or need it no more
        return following

    def _say_pace(self, line: str) -> None:
        self.paces += line not in self.told
        if self.paces <= TOLD:
            self._say(line)

    def _say(self, line: str) -> None:
        self.told[line] = None

    def _find_most(self, job: Job, task: Task, pace: Pace) -> int:
        """Attempts until it is looked whether something is held that steps do not tell."""
        recipe = job.recipe
        slides = recipe is not None and recipe.weak and task.step <= 0 and self.sticking.list_planes(job)
        return self.sticking.patience if slides else pace.most

    def _stick(self, legs: list[Leg]) -> tuple[Job, list[float]] | None:
        """What a run goes on with where dry friction begins to hold or breaks loose."""
        job, outcome = legs[-1].job, legs[-1].outcome
        recipe = job.recipe
        if recipe is None or not recipe.weak or legs[-1].task.step > 0:
            return None
        if job.kept is None:
            stuck = outcome.kind == HELD or self.sticking.is_slow(job, outcome)
            return (make_job(recipe, job.system, job.formulation, job), []) if stuck else None
        found = self.sticking.follow(job, outcome)
        if found is not None and recipe.jacobian:
            found = self._with_jacobian(found[0]), found[1]
        if outcome.kind == EVENT and recipe.held.frictions and (found or outcome.status > 0 or recipe.event is None):
            # the event is not the user's
            kind, status = (CROSSED, outcome.status) if found else (HELD, -1)
            legs[-1] = replace(legs[-1], outcome=replace(outcome, kind=kind, status=status))
        return found

    def _with_jacobian(self, job: Job) -> Job:
        """The job for the implicit method that the run is at."""
        if job.recipe is None or job.recipe.jacobian:
            return job
        for explicit, implicit in self.implicit:
            if explicit is job:
                return implicit
        self.implicit.append((job, implicit_job(job.recipe, job)))
        return self.implicit[-1][1]

    def _decide(self, leg: Leg) -> Job | None:
        """The job that the run goes on with; None where it ends here."""
        job, outcome = leg.job, leg.outcome
        recipe, watch = job.recipe, job.watch
        crossed = outcome.kind == CROSSED
        lost = outcome.kind == SINGULAR and outcome.status == SINGULAR_FRAME
        if recipe is None or not recipe.weak or not (crossed or lost):
            return None
        weak = crossed and outcome.status >= watch.weak
        kind = watch.kinds[outcome.status] if crossed else "frame"
        framed = kind in _FRAME or (kind == "mass" and weak and job.formulation.frame is not None)
        if framed and job.kept is None:
            return make_job(recipe, job.system, job.formulation, job)
        framed = framed and (kind in _FRAME or self._is_for_its_frame(leg, recipe))
        # where the determinant is gone, so are the digits: only a start is as good as it was given
        sound = weak or outcome.steps == 0
        found = self._find(job, recipe, outcome) if framed and sound else None
        if found is not None:
            return found
        if weak and kind in _NEAR and _comes_near(leg) and not self._is_sound(leg, recipe, kind):
            self._warn(leg, kind)
        return job if weak else None

    def _find(self, job: Job, recipe: Recipe, outcome: Outcome) -> Job | None:
        place = place_of(job, recipe, outcome)
        if place is None:
            return None
        made_before = [made for made in self.jobs if made.system is job.system]
        others = [Choice(made.system, made.formulation, 0.0) for made in made_before if made is not job]
        found = find_better(job.system, job.formulation, place, others)
        if found is None:
            return None
        self.changes += 1
        if self.changes <= TOLD:
            value = conditioning(job.system, job.formulation, place)
            self._say(
                f"at t = {outcome.t:.9g} the run goes on with {name_of(found.system, found.formulation)} "
                f"(conditioning {found.value:.2g}) in place of {name_of(job.system, job.formulation)} ({value:.2g})"
            )
        if not made_before:
            self.jobs.append(job)
            made_before = [job]
        for made in made_before:
            if is_same(made.formulation, found.formulation):
                return made
        made = make_job(recipe, found.system, found.formulation, job)
        self.jobs.append(made)
        return made

    def _is_sound(self, leg: Leg, recipe: Recipe, kind: str) -> bool:
        """Whether the coframe (or the mass matrix) is well conditioned although its determinant (or a pivot) is small against what
        its entries allow: a rod far from the origin is no less regular.
        """
        whole = kind in ("deep", "mass") and leg.job.kept is not None
        place = place_of(leg.job, recipe, leg.outcome) if whole else None
        if place is None:
            return False
        if kind == "mass":
            return is_mass_sound(leg.job.system, leg.job.formulation, place)
        system = leg.job.system
        return conditioning(system, leg.job.formulation, place) ** max(system.l, 1) >= SOUND

    def _is_for_its_frame(self, leg: Leg, recipe: Recipe) -> bool:
        """Whether a mass matrix becomes singular because the coframe does, whose determinant squared stands in it."""
        place = place_of(leg.job, recipe, leg.outcome)
        if place is None:
            return False
        return conditioning(leg.job.system, leg.job.formulation, place) ** max(leg.job.system.l, 1) < SOUND

    def _warn(self, leg: Leg, kind: str) -> None:
        line = f"{_NEAR[kind]}: digits are lost there"
        if leg.task.step > 0:
            line += ", and with fixed steps perhaps all of them"
        if not any(line in known for known in self.told):
            self._say(f"at t = {leg.outcome.t:.9g} {line}")


def _comes_near(leg: Leg) -> bool:
    """Whether the watched value has gone down in the leg: the motion comes near, and does not leave."""
    job, outcome = leg.job, leg.outcome
    functions = tuple(f for f in job.program.functions if f.name == "watch")
    model = InterpretedModel(replace(job.program, functions=functions), job.events)
    begin = model.watch(leg.task.times[0], leg.task.y, job.p)[outcome.status]
    return begin > model.watch(outcome.t, outcome.y, job.p)[outcome.status]
