"""The method of a run that is still going on, looked at after some steps and then ever less often."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from nhc.records import record
from nhc.simulate.auto import COARSE
from nhc.simulate.carrying import implicit_job
from nhc.simulate.prepare import Job
from nhc.simulate.stiffness import FIRST, FREE, HELD, IMPLICIT, MORE, PAYS, TRIAL, fastest_mode
from nhc.simulate.task import NO_SOLUTION, SINGULAR, STALLED, TOO_MANY, UNDERFLOW, Outcome, Task

AUTO = "auto"


def first_method(tolerance: float) -> str:
    """What ``--method auto`` starts with."""
    return "dopri5" if tolerance >= COARSE else "dop853"


@record
class _Trial:
    """What an implicit method has to better: the explicit one, its job, its mean step; and when the next look would be."""

    method: str
    job: Job
    length: float
    looks: int
    note: str


@dataclass
class Pace:
    """``auto``: the method may be changed; else a stiff scene is only told.  ``looks``: steps until the next look, 0: none;
    ``taken``: those that all legs took so far.
    """

    method: str
    task: Task
    auto: bool
    tell: Callable[[str], None]
    looks: int = FIRST
    trial: _Trial | None = None
    explicit: tuple[str, Job] | None = None
    taken: int = 0

    @property
    def most(self) -> int:
        """Steps that the next leg may take."""
        left = max(self.task.most - self.taken, 0)
        return min(self.looks, left) if self._may_look else left

    def count(self, outcome: Outcome) -> None:
        """A leg has ended."""
        self.taken += outcome.steps + outcome.rejected

    @property
    def _may_look(self) -> bool:
        return self.task.step <= 0 and self.looks > 0 and (self.auto or self.method in HELD)

    def look(self, job: Job, begin: float, outcome: Outcome) -> Job | None:
        """The job that a leg from ``begin`` is followed by; ``method`` is changed where that pays.  None: nothing to look at."""
        if (
            self.method == IMPLICIT
            and self.explicit is not None
            and outcome.kind in (NO_SOLUTION, SINGULAR, UNDERFLOW, STALLED)
        ):
            self.looks = 0
            return self._go_back(job, outcome.t, "finds no solution")
        if outcome.kind != TOO_MANY or not self._may_look or self.taken >= self.task.most:
            return None
        length = abs(outcome.t - begin) / max(outcome.steps, 1)
        if self.trial is not None:
            return self._judge(self.trial, job, outcome.t, length)
        size = length * fastest_mode(job, outcome.t, outcome.y, length)
        self.looks *= MORE
        if self.method == IMPLICIT:
            return self._go_back(job, outcome.t, "no longer pays") if size < FREE and self.explicit else job
        return self._try(job, outcome.t, length, size) if size > HELD[self.method] else job

    def _try(self, job: Job, t: float, length: float, size: float) -> Job:
        held = f"the scene is stiff: at t = {t:.6g} stability holds the steps of {self.method} at {length:.3g}"
        held = f"{held} (h |lambda| = {size:.2g})"
        if not self.auto or job.recipe is None:
            self.tell(f"{held}; leave `--method` out, or take {IMPLICIT}")
            self.looks = 0
            return job
        note = f"{held}, and the run goes on with {IMPLICIT}"
        self.trial = _Trial(self.method, job, length, self.looks, note)
        self.explicit = (self.method, job)
        self.method, self.looks = IMPLICIT, TRIAL
        return implicit_job(job.recipe, job)

    def _judge(self, trial: _Trial, job: Job, t: float, length: float) -> Job:
        """Whether the implicit steps are long enough for what they cost."""
        self.trial = None
        if length >= PAYS * trial.length:
            self.tell(trial.note)
            self.looks = FIRST
            return job
        self.method, self.looks = trial.method, trial.looks
        return trial.job if _are_alike(trial.job, job) else job

    def _go_back(self, job: Job, t: float, why: str) -> Job:
        assert self.explicit is not None
        method, former = self.explicit
        if self.trial is None:
            self.tell(f"at t = {t:.6g} {IMPLICIT} {why}: the run goes on with {method}")
        self.method, self.explicit, self.trial = method, None, None
        return former if _are_alike(former, job) else job

    def finish(self) -> None:
        """Say what was not said yet."""
        if self.trial is not None:
            self.tell(self.trial.note)


def _are_alike(one: Job, other: Job) -> bool:
    """Whether they have the same state."""
    return one.system is other.system and one.formulation == other.formulation
