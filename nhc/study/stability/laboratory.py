"""All studies of one scene together: what ``nhc stability`` runs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation, build
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.records import record
from nhc.simulate.requests import find_scene
from nhc.simulate.stiffness import HELD, IMPLICIT, PAYS
from nhc.study.stability.bench import Bench, open_bench
from nhc.study.stability.conduct import conduct
from nhc.study.stability.distance import NEAR, Distance, distances
from nhc.study.stability.drift import LENGTHS, LongRun, long_run
from nhc.study.stability.motions import Motion, Search, steady_motion
from nhc.study.stability.sensitivity import Sensitivity, sensitivity
from nhc.study.stability.stepsize import Spectrum, StepLimit, spectrum, step_limits

Found = TypeVar("Found")
Show = Callable[[float, str], None]
_PLACES = 6
_STEADY = "steady motion"
STIFF = 1e3
"""Stiffness ratio from which an implicit method is advised."""


def _silent(part: float, what: str) -> None:
    pass


@record
class Question:
    """``scene``: a name (empty: the first).  ``about`` (empty: it), ``settings``, ``holds``, ``sweep``: as for a linearisation;
    the scene has the ``settings``, too, when its equations are made.

    ``lengths``: how many times the scene's time the long run takes; ``compiled``: with a C compiler where there is one.
    """

    scene: str = ""
    about: str = ""
    settings: tuple[str, ...] = ()
    holds: tuple[str, ...] = ()
    sweep: tuple[str, float, float, int] | None = None
    lengths: float = LENGTHS
    compiled: bool = True


@record
class Laboratory:
    """What was found; a study that could not be done is None or empty and ``missing`` says why, as (study, reason).

    ``failed``: the reason why the scene itself does not run, or empty; ``conduct``: what ``nhc run`` does about what was found;
    ``changes``: what the scene has in place of what the spec says.
    """

    bench: Bench
    motion: Motion | None
    spectrum: Spectrum | None
    limits: tuple[StepLimit, ...]
    runs: tuple[LongRun, ...]
    sensitivity: Sensitivity | None
    distances: tuple[Distance, ...]
    missing: tuple[tuple[str, str], ...]
    failed: str
    conduct: tuple[str, ...] = ()
    changes: tuple[str, ...] = ()
    held: bool = False
    """Whether stability, and not accuracy, is what limits the steps of ``dop853``; looked at where the stiffness is large."""

    def tell_stiffness(self) -> str:
        """What the stiffness ratio means: what decays fast at one place may oscillate or grow as fast at another."""
        if (self.stiffness or 0.0) <= STIFF:
            return "not stiff"
        if self.stopped or any(IMPLICIT in note for note in self.conduct):
            return f"stiff: take {IMPLICIT}"
        if self.held:
            return f"stability limits the steps, but those of {IMPLICIT} are not {PAYS:.0f} times as long"
        return "not stiff: accuracy asks for shorter steps still"

    @property
    def stopped(self) -> bool:
        """Whether ``nhc run`` does not end the scene either."""
        return bool(self.conduct) and self.conduct[-1].startswith("it stops")

    @property
    def stiffness(self) -> float | None:
        """The fastest decay against the slowest thing that matters: the smallest other rate, but nothing slower than the scene."""
        if self.spectrum is None:
            return None
        return self.spectrum.decay / max(self.spectrum.slowest, 1.0 / self.bench.duration)


def examine(equations: Equations, formulation: Formulation, question: Question, show: Show = _silent) -> Laboratory:
    """Every study that applies; ``show`` is told how much is done, roughly, and what is next.

    Raises:
        nhc.diagnostics.SpecError: unknown names, or a start that violates the constraints.
        nhc.simulate.requests.RunError: no such scene.
    """
    system = equations.system
    scene = find_scene(system.spec, question.scene)
    missing: list[tuple[str, str]] = []

    def attempt(name: str, study: Callable[[], Found]) -> Found | None:
        try:
            return study()
        except ArithmeticError as error:
            missing.append((name, str(error)))
            return None

    show(0.05, "compiling")
    bench = open_bench(equations, formulation, start_of(system, scene), question.compiled)
    show(0.25, "steady motion")
    motion = attempt(_STEADY, lambda: _motion(bench, question))
    if attempt("scene", lambda: bench.table) is None:
        return Laboratory(bench, motion, None, (), (), None, (), tuple(missing), missing[-1][1], conduct(bench))
    show(0.5, "eigenvalues along the scene")
    along = attempt("eigenvalues along the scene", lambda: spectrum(bench))
    show(0.55, "largest stable steps")
    limits = step_limits(bench, along) if along is not None else ()
    show(0.7, "drift")
    runs = [long_run(bench, question.lengths)]
    step = next((x.measured for x in limits if x.method == "rk4"), 0.0)
    if step > 0:
        runs.append(long_run(bench, question.lengths, "rk4", min(step, bench.duration / 25) / 4))
    show(0.8, "sensitivity to the start")
    growth = attempt("sensitivity", lambda: sensitivity(bench, question.lengths))
    show(0.9, "distance from singular points")
    near = attempt("distances", lambda: distances(bench)) or ()
    found = Laboratory(bench, motion, along, limits, tuple(runs), growth, near, tuple(missing), "")
    stiff = (found.stiffness or 0.0) > STIFF
    if not stiff and not any(d.least < NEAR for d in near if d.used):
        return found
    return replace(found, conduct=conduct(bench), held=stiff and along is not None and _is_held(bench, along))


def _is_held(bench: Bench, along: Spectrum) -> bool:
    """Whether the mean step of dop853 is as long as stability allows beside the fastest decay."""
    outcome = bench.integrate("dop853", bench.job.time)
    return outcome.steps > 0 and along.decay * bench.duration / outcome.steps > HELD["dop853"]


def examine_whole(
    equations: Equations, formulation: Formulation, question: Question, show: Show = _silent
) -> Laboratory:
    """The same where nobody asked for the formulation: one that the scene leads to where it cannot go on gives way to multipliers.

    Raises:
        nhc.diagnostics.SpecError: unknown names, or a start that violates the constraints.
        nhc.simulate.requests.RunError: no such scene.
    """
    found = examine(equations, formulation, question, show)
    if not found.failed or found.stopped or formulation.frame is None:
        return found
    other = build(equations.system, "multipliers")
    whole = examine(equations_of(equations.system, other), other, question, show)
    if whole.failed:
        return found
    note = f"studied with {other.name}: {found.failed}"
    whole = replace(whole, bench=replace(whole.bench, notes=(*whole.bench.notes, note)), conduct=found.conduct)
    if found.motion is None or (whole.motion is not None and len(whole.motion.lost) < len(found.motion.lost)):
        return whole
    # the equations that the scene leads to have the velocities in which its steady motion is one
    return replace(whole, motion=found.motion, missing=tuple(x for x in whole.missing if x[0] != _STEADY))


def _motion(bench: Bench, question: Question) -> Motion:
    """Raises: NotSteady."""
    hidden = tuple((bench.columns[k].heading, bench.columns[k].node) for k in bench.group("hidden"))
    about = question.about or bench.job.scene.name
    search = Search(about, question.settings, question.holds, question.sweep, hidden)
    return steady_motion(bench.equations, bench.formulation, search, [] if question.about else _beside(bench))


def _beside(bench: Bench) -> list[tuple[float, Start]]:
    """States along the scene as starts; none where it does not run."""
    try:
        states = bench.reference
        picked = [round(k * (len(bench.times) - 1) / _PLACES) for k in range(1, _PLACES + 1)]
        moving = [bench.velocities(bench.times[k], states[k].tolist()) for k in picked]
    except ArithmeticError:
        return []
    n, scene, time, p = bench.equations.system.n, bench.job.scene, bench.job.time, bench.job.p
    rows = zip(picked, moving, strict=True)
    return [(bench.times[k], Start(scene, time, p, tuple(float(x) for x in states[k][:n]), tuple(v))) for k, v in rows]
