"""What an outcome means, in words."""

from __future__ import annotations

from math import isfinite

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.algebra.show import to_text
from nhc.mechanics.choosing.conditioning import conditioning
from nhc.mechanics.properties.singular import smallest_singular_value
from nhc.mechanics.regular.undefined import find_pole, find_undefined
from nhc.program.planning.base import SINGULAR_FRAME
from nhc.simulate.prepare import Job
from nhc.simulate.task import (
    CROSSED,
    DONE,
    EVENT,
    HELD,
    NO_SOLUTION,
    SINGULAR,
    STALLED,
    STOPPED,
    TOO_MANY,
    UNDERFLOW,
    Outcome,
)

LOST_RANK = 1e-5
"""Smallest singular value of constraints that are taken to have lost their rank."""
_LONGEST = 12  # entries of a state that are shown
_POOR = 1e-4  # of a coframe's determinant, relative to its rows: its square has lost half of a double's digits


def describe_outcome(job: Job, outcome: Outcome) -> tuple[str, str]:
    """(done, event, stopped or failed; why)."""
    if outcome.kind == DONE:
        return "done", ""
    if outcome.kind == EVENT:
        text = "" if job.recipe is None else job.recipe.until
        return "event", f"`{text}` of `--until` crosses zero"
    if outcome.kind == STOPPED:
        return "stopped", "interrupted"
    if outcome.kind == CROSSED:
        return "failed", job.watch.describe(find_lost(job, outcome))
    reasons = {
        SINGULAR: _why_singular(job, outcome),
        UNDERFLOW: "the step size underflows: the motion approaches a singularity, is not smooth there, or is faster than the "
        "digits of the time can tell",
        TOO_MANY: "it takes too many steps",
        STALLED: "the steps become so short that the end is out of reach: the motion comes close to a singularity, or slides along "
        "a jump of the forces, as friction by `sign(v)` makes it do where it sticks (`tanh(v/eps)` does not), or the scene is very "
        "long beside its fastest motion",
        HELD: _why_held(job, outcome),
        NO_SOLUTION: f"the equations of the implicit step are not solved (step {abs(outcome.h):.3g}); take a smaller one"
        f"{_tell_jumping(job)}",
    }
    return "failed", reasons.get(outcome.kind, "it fails")


def describe_valueless(job: Job, outcome: Outcome, status: int) -> str:
    """Why a row cannot be written: a needed quantity without a value at the outcome's state; which, where that can be told."""
    g, system = job.system.graph, job.system
    place = dict(zip((*system.p, *job.constants, *job.symbols), (*job.p, *outcome.y), strict=True))
    place[system.t] = outcome.t
    named = [(f"`{column.heading}`, which is needed,", column.node) for column in job.columns]
    named += [(f"`{to_text(g, node)}` under `draw`", node) for node in job.sketch.nodes]
    for name, node in named:
        try:
            lost = not isfinite(float(evaluate(g, [node], place)[0]))
        except KeyError:  # it holds what the model solves for
            continue
        except (ArithmeticError, ValueError, TypeError):
            lost = True
        if lost:
            return f"{name} has no real, finite value"
    return f"a needed quantity has no value: {job.meanings.get(status, 'it is not finite')}"


def find_lost(job: Job, outcome: Outcome) -> int:
    """The watched value that says why a run ended at one of them: where a choice of velocities becomes singular the mass matrix on
    them, which has their determinant squared in it, is lost first.
    """
    watch, index = job.watch, outcome.status
    frames = [k for k in range(watch.dips, watch.weak) if watch.kinds[k] == "frame"]
    if watch.kinds[index] != "mass" or not frames:
        return index
    try:
        sound = conditioning(job.system, job.formulation, _place_of(job, outcome))
    except (ArithmeticError, ValueError):
        return index
    return frames[0] if sound ** max(job.system.l, 1) < _POOR else index


def is_for_frame(job: Job, outcome: Outcome) -> bool:
    """Whether a run failed because its coframe is singular, while the constraints keep their rank: another formulation goes on."""
    if outcome.kind == CROSSED:
        framed = job.watch.kinds[find_lost(job, outcome)] == "frame"
    else:
        framed = outcome.kind == SINGULAR and outcome.status == SINGULAR_FRAME
    rank = rank_left(job, outcome) if framed else None
    return rank is not None and rank >= LOST_RANK


def _tell_jumping(job: Job) -> str:
    """What else to do about an implicit step where forces jump: across a jump it may have no solution at any length."""
    leaps = job.program.driving.leaps
    return (
        ", or leave `--method` and `--step` out: the forces jump somewhere" if leaps is not None and leaps.lands else ""
    )


def _why_held(job: Job, outcome: Outcome) -> str:
    """What the model says of the argument at whose jump the motion is held; with none, a friction that held has to let go."""
    leaps = job.program.driving.leaps
    if outcome.kind == HELD and leaps is not None and outcome.status >= 0:
        return leaps.held[outcome.status]
    return (
        "dry friction has to let go, and no way to go on agrees with itself: where frictions in planes hold what follows from each "
        "other, the equations do not tell how much each gives; `tanh(v/eps)` in place of `sign(v)` does"
    )


def _why_singular(job: Job, outcome: Outcome) -> str:
    """What the model's status means, unless an expression of the spec has no value there: then no block has one either.

    Where a result is not finite although all have values, a slope of T, the potential or a force may have none.
    """
    if outcome.kind != SINGULAR:
        return ""
    place = _place_of(job, outcome)
    undefined = find_undefined(job.system, place)[0]
    if undefined:
        return undefined
    if outcome.status in job.meanings:
        return job.meanings[outcome.status]
    pole = find_pole(job.system, place)[0]
    if pole:
        return pole.removesuffix(",")
    beside = ", or the expression of `--until` has no value within the next step" if job.events else ""
    return f"a result is not finite at a place that the next step tries{beside}"


def _place_of(job: Job, outcome: Outcome) -> dict[Node, float]:
    """Where a run ended; what the model does not carry, and the velocities, stand as they were at its start."""
    place = job.start.values(job.system) | {job.system.t: outcome.t}
    carried = dict(zip(job.state_names, outcome.y, strict=True))
    place |= {q: carried[name] for q, name in zip(job.system.q, job.system.q_names, strict=True) if name in carried}
    return place


def name_outcome(job: Job, outcome: Outcome) -> str:
    """Why a run does not end, in a few words."""
    if outcome.kind == CROSSED:
        return job.watch.about[find_lost(job, outcome)]
    if outcome.kind == NO_SOLUTION:
        return "Newton's iteration does not converge"
    return describe_outcome(job, outcome)[1].partition(":")[0]


def describe_state(job: Job, outcome: Outcome) -> str:
    """``x = 1, y = 2, ...`` at the place where a run ended."""
    pairs = list(zip(job.state_names, outcome.y, strict=True))
    shown = ", ".join(f"{name} = {value:.9g}" for name, value in pairs[:_LONGEST])
    return shown + (", ..." if len(pairs) > _LONGEST else "")


def rank_left(job: Job, outcome: Outcome) -> float | None:
    """The smallest singular value of the constraints where a run ended; None without constraints.

    Coordinates that the model does not carry stand at their start: the rank does not depend on them.
    """
    if not job.system.constraints:
        return None
    try:
        return smallest_singular_value(job.system, _place_of(job, outcome))
    except (ArithmeticError, ValueError):
        return None
