"""The state of one formulation in terms of another one's, by way of q and q'; and jobs of other formulations."""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.evaluate import evaluate
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.choosing.energy import Place
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.starts.scenes import kept_velocities
from nhc.mechanics.system import System
from nhc.simulate.prepare import Job, Recipe, prepare
from nhc.simulate.reduced import prepare_reduced
from nhc.simulate.task import Outcome


def is_same(one: Formulation, other: Formulation) -> bool:
    """Whether two formulations have the same coframe."""
    if one.frame is None or other.frame is None:
        return one.name == other.name
    return [form.coefficients for form in one.frame.forms] == [form.coefficients for form in other.frame.forms]


def make_job(recipe: Recipe, system: System, formulation: Formulation, job: Job) -> Job:
    """The job in another formulation, with its whole state."""
    own = formulation == job.formulation
    equations = recipe.equations if own else equations_of(system, formulation)
    return prepare(replace(recipe, equations=equations), formulation, job.start)


def implicit_job(recipe: Recipe, job: Job) -> Job:
    """The same job with the Jacobian of its right-hand side, on the same state."""
    wanted = replace(recipe, jacobian=True)
    if job.kept is not None:
        return make_job(wanted, job.system, job.formulation, job)
    reduced = prepare_reduced(wanted, job.formulation, job.start)
    assert reduced is not None
    return reduced


def place_of(job: Job, recipe: Recipe, outcome: Outcome) -> Place | None:
    """Values of t, q, q' and p where a leg ended; None where q' has none."""
    system, n = job.system, job.system.n
    place = {
        system.t: outcome.t,
        **dict(zip(system.p, job.p, strict=True)),
        **dict(zip(system.q, outcome.y[:n], strict=True)),
    }
    if outcome.t == job.start.time[0]:  # as given: near a singular point the state has lost its digits
        return {**place, **dict(zip(system.v, job.start.v, strict=True))}
    motion = recipe.equations.motion
    inner = {**place, **dict(zip(motion.w, outcome.y[n:], strict=True))}
    try:
        v = [float(x) for x in evaluate(system.graph, motion.velocities, inner)]
    except (ArithmeticError, ValueError):
        return None
    return {**place, **dict(zip(system.v, v, strict=True))}


def carry(job: Job, following: Job, outcome: Outcome) -> list[float]:
    """The state vector of the job ``following`` at the q and q' where ``outcome`` of ``job`` ended."""
    assert job.recipe is not None and following.kept is not None
    place = place_of(job, job.recipe, outcome)
    assert place is not None
    system = following.system
    v = tuple(place[x] for x in system.v)
    start = replace(job.start, time=(outcome.t, job.start.time[1]), q=tuple(outcome.y[: system.n]), v=v)
    return [*start.q, *kept_velocities(system, following.kept, start)]


def carry_sizes(job: Job, following: Job, outcome: Outcome) -> tuple[float, ...]:
    """The largest magnitudes that entries of the state of ``following`` have had: of those that ``job`` has, too, and else none.

    The error of what comes to rest counts against the size that it had, and not against what rounding leaves of it.
    """
    if not outcome.sizes:
        return ()
    known = dict(zip(job.state_names, outcome.sizes, strict=True))
    return tuple(known.get(name, 0.0) for name in following.state_names)
