"""Where a run's models are made, once each, and run.

A compiler takes longer to optimise a model than most scenes take to run.  So a model is compiled as it is written first (*hasty*:
a fifth of the time, and three times as slow), for a number of steps that goes by its size; what takes more of them is done again by
the optimised one.  Which of the two a result comes from hangs on the job alone, not on what stands in the cache: where a processor
fuses products and sums, optimised code may round otherwise.
"""

from __future__ import annotations

import time
from dataclasses import dataclass, field, replace

from nhc.simulate.c.compile import HASTY_FLAGS, CompileError, build, loop_flags, tell_passing, tell_why
from nhc.simulate.c.compiled import CompiledModel
from nhc.simulate.c.source import write_natural, write_source
from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.methods import RUNGE_KUTTA, STRUCTURE
from nhc.simulate.methods.tableau import Collocation
from nhc.simulate.natural import NaturalModel
from nhc.simulate.peers import PEERS, PeerModel
from nhc.simulate.prepare import Job
from nhc.simulate.task import STOPPED, TOO_MANY, Outcome, Task
from nhc.simulate.waiting import Show, wait_for

Model = CompiledModel | InterpretedModel | NaturalModel
HASTE = 8_000_000  # statements that a hasty model may take: 0.2 to 0.3 s; optimised it would be a third of that
_OF_A_STEP = 80  # what a step takes beside the right-hand side's, as many statements of it


def load(job: Job, method: str, compiled: bool = True, hasty: bool = False) -> tuple[Model, tuple[str, ...]]:
    """The compiled model, or the emitted Python where there is no compiler; notes say so."""
    notes: tuple[str, ...] = ()
    if method in PEERS:
        return PeerModel(job.program, job.events, dips=job.watch.dips), ()
    if compiled:
        try:
            model = _compile(job, method, hasty)
            return model, tell_passing(model.path)
        except CompileError as error:
            notes = (f"{tell_why(error)}; running the emitted Python, which is some hundred times slower",)
    if method in STRUCTURE:
        return NaturalModel(job.program), notes
    frames = job.watch.weak, job.watch.frames
    return InterpretedModel(job.program, job.events, job.holds, job.watch.dips, frames), notes


def _compile(job: Job, method: str, hasty: bool) -> CompiledModel:
    if method in STRUCTURE:
        sources = write_natural(job.program, STRUCTURE[method])
    else:
        watch, methods = job.watch, [RUNGE_KUTTA[method]]
        sources = write_source(
            job.program, methods, job.events, job.holds, dips=watch.dips, frames=(watch.weak, watch.frames)
        )
    flags = HASTY_FLAGS if hasty else loop_flags(len(job.y))
    path = build(sources, f"{job.program.system}_run.c", flags)
    return CompiledModel(path, job.program.system, len(job.y), job.width)


@dataclass(eq=False)
class _Made:
    """``most``: steps that may be tried with this model; None without bound."""

    job: Job
    method: str
    model: Model
    most: int | None


@dataclass
class Workshop:
    """Models that are made once for a job and those moved from it, and run in a thread of their own so that Ctrl-C is heard.

    ``seconds``: what making them has taken; ``stopped``: somebody has asked to stop, and no run begins any more.
    """

    compiled: bool
    show: Show | None
    notes: tuple[str, ...] = ()
    seconds: float = 0.0
    stopped: bool = False
    _made: list[_Made] = field(default_factory=list)

    def model(self, job: Job, method: str) -> Model:
        """The model of a job with a method, as it was used last."""
        return self._find(job, method).model

    def integrate(self, job: Job, method: str, task: Task) -> Outcome:
        """One run of one model."""
        made = self._find(job, method)
        if made.most is not None:
            most = made.most
            outcome = self._run(made, replace(task, most=min(most, task.most)))
            if outcome.kind != TOO_MANY or task.most <= most:
                made.most = max(most - outcome.steps - outcome.rejected, 0)
                return outcome
            try:
                self._optimise(made)
            except KeyboardInterrupt:  # the compiler is at work for seconds: what the hasty model has reached is kept
                outcome.kind = STOPPED
                return outcome
        return self._run(made, task)

    def _run(self, made: _Made, task: Task) -> Outcome:
        news = made.model.news()
        news.t, news.stop = task.times[0], self.stopped
        outcome = wait_for(lambda: made.model.integrate(task, made.method, news), news, self.show)
        self.stopped = news.stop
        if news.stop and outcome.kind == TOO_MANY:  # it ended before it was asked to
            outcome.kind = STOPPED
        return outcome

    def _find(self, job: Job, method: str) -> _Made:
        for made in self._made:
            if made.job.program is job.program and made.method == method:
                return made
        begin, most = time.perf_counter(), _find_haste(job, method)
        model, notes = load(job, method, self.compiled, hasty=most > 0)
        self.seconds += time.perf_counter() - begin
        self._note(notes)
        self._made.append(_Made(job, method, model, most if most > 0 and isinstance(model, CompiledModel) else None))
        return self._made[-1]

    def _optimise(self, made: _Made) -> None:
        """Take the compiler's pains with a model; it stays as it is where the compiler does not get to an end with them."""
        begin = time.perf_counter()
        try:
            made.model = _compile(made.job, made.method, hasty=False)
        except CompileError as error:
            self._note((f"{tell_why(error)}; the run goes on without optimisation",))
        made.most = None
        self.seconds += time.perf_counter() - begin

    def _note(self, notes: tuple[str, ...]) -> None:
        self.notes = tuple(dict.fromkeys((*self.notes, *notes)))


def _find_haste(job: Job, method: str) -> int:
    """Steps that a hasty model may take; those that are solved for eliminate in a matrix of the state's size."""
    rhs = next(function for function in job.program.functions if function.name == "rhs")
    solved = method in STRUCTURE or isinstance(RUNGE_KUTTA.get(method), Collocation)
    return HASTE // (_OF_A_STEP + len(rhs.body) + (len(job.y) ** 3 if solved else 0))
