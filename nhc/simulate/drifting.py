"""What a motion conserves and its run does not: the energy, where it is asked for, and what `--until` waits for."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.dense import Singular
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import Unlucky
from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.properties.conserved import driving_terms, uneven_terms
from nhc.mechanics.properties.constancy import are_constant, jumps
from nhc.mechanics.properties.sampling import Sampler
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.simulate.prepare import Job

_FAR = 100.0  # times the accuracy: what a long run may well add up to
_COARSE = 0.1  # of its size, in steps that nothing but the user's word holds


def tell_conserved(job: Job, rows: Sequence[Sequence[float]], tolerance: float, event: bool) -> tuple[str, ...]:
    """Notes on the energy in the rows and, where the run ended by its ``event``, on that; ``tolerance``: 0 of fixed steps."""
    return (*_tell_energy(job, rows, tolerance), *(_tell_event(job) if event else ()))


def _tell_energy(job: Job, rows: Sequence[Sequence[float]], tolerance: float) -> tuple[str, ...]:
    """A note where the energy among the columns changes by far more than ``tolerance`` (0: of fixed steps), and should not.

    It is compared with itself, and with T and V at the start, which may cancel.
    """
    system = job.system
    names = {*system.q_names, *(form.name for form in system.quasi), *(name for name, _ in system.outputs)}
    places = [k for k, column in enumerate(job.columns) if column.heading == "energy" and column.group == "need"]
    if not places or len(rows) < 2 or "energy" in names:  # which is another one
        return ()
    values = [row[places[0]] for row in rows]
    try:
        parts = evaluate(system.graph, [system.T, system.U], job.start.values(system))
    except ArithmeticError:
        return ()
    size = max(abs(float(x)) for x in (*values, *parts))
    change = max(abs(x - values[0]) for x in values)
    if not change > (_FAR * tolerance or _COARSE) * size or not _is_conserved(job):
        return ()
    told = f"the energy, which the motion conserves, changes by {change / size:.2g} of its size"
    if not tolerance:
        return (f"{told}: these steps are too long for it; take shorter ones, or leave `--step` out",)
    return (
        f"{told}, though each step was held to an accuracy of {tolerance:.3g}: that is beside what an entry of the state is there,"
        " and of velocities that are large for a while errors stay that are large beside what comes after; see whether the end"
        " changes with a smaller `--tol`",
    )


def _tell_event(job: Job) -> tuple[str, ...]:
    """A note where what has ended a run is a constant of the motion."""
    recipe, system = job.recipe, job.system
    if recipe is None or recipe.event is None:
        return ()
    try:
        sampler = Sampler(system, coordinate_frame(system, choose_dependent(system).dependent) if system.l else None)
        if not are_constant(sampler, [recipe.event.value])[0] or jumps(sampler, recipe.event.value):
            return ()
    except (Unlucky, Singular):
        return ()
    return (
        f"`{recipe.until}` of `--until` is a constant of the motion: rounding and the errors of the run alone change it",
    )


def _is_conserved(job: Job) -> bool:
    """By the theorem of energy (III.2.2); what needs more than its terms is not told."""
    try:
        return not driving_terms(job.system) and not uneven_terms(job.system)
    except Unlucky:
        return False
