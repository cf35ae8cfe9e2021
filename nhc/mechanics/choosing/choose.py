"""Which formulation, on which coframe, and why."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import rank
from nhc.diagnostics import several
from nhc.mechanics.choosing.adapt import complete, spelled, turning_choices
from nhc.mechanics.choosing.axes import frame_on_axes
from nhc.mechanics.choosing.energy import SOUND_ENERGY, least_energy
from nhc.mechanics.choosing.faults import list_faults
from nhc.mechanics.choosing.independence import leaves_digits
from nhc.mechanics.choosing.length import is_unwieldy
from nhc.mechanics.choosing.lines import along_lines
from nhc.mechanics.choosing.minors import adapted_forms
from nhc.mechanics.choosing.pivots import are_headings, set_pivots_aside
from nhc.mechanics.choosing.reach import are_multipliers_dear, becomes_singular, find_lasting
from nhc.mechanics.choosing.refusal import NotApplicable, refuse
from nhc.mechanics.frame import Frame, coordinate_frame, make_frame, velocity_symbol
from nhc.mechanics.regular.regularity import Choice as DependentChoice
from nhc.mechanics.regular.regularity import choose_dependent, judge, ranked, weak_where_constraints_are_not
from nhc.mechanics.system import Form, System
from nhc.records import record

if TYPE_CHECKING:
    from nhc.mechanics.formulations.chaplygin import Hypotheses

NUMBERS = {
    "newton": "II.1.3",
    "lagrange": "II.3",
    "chaplygin": "III.3",
    "voronec": "I.4.9",
    "multipliers": "I.4.1",
}
"""Of the thesis; the Euler-Lagrange equations have two, with and without constraints."""
ON_THE_WAY = "positions that the motion can reach"


@record
class Formulation:
    """A formulation with its frame (None: the coordinate velocities themselves).

    ``broken`` are hypotheses of the thesis that fail although the generalized equations hold.
    """

    name: str
    number: str
    frame: Frame | None
    dependent: DependentChoice | None
    added: tuple[str, ...]
    reason: str
    broken: tuple[str, ...] = ()


def formulate(system: System, name: str = "") -> Formulation:
    """The formulation of that name (or of the spec, or the best) on this system.

    Raises:
        nhc.diagnostics.SpecError: it does not apply.
    """
    wanted = name or system.spec.formulation or "auto"
    try:
        return choose(system) if wanted == "auto" else of_name(system, wanted)
    except NotApplicable as error:
        spans = dict(system.spec.key_spans)
        written = [spans[key] for key in (error.key if name else "formulation", "holonomic") if key in spans]
        refuse(system, error, written[0] if written else system.spec.kinetic.span)
        raise


def of_name(system: System, name: str) -> Formulation:
    """The formulation of that name, in the velocities that `auto` takes where the name leaves them open and `auto` takes it.

    Raises:
        NotApplicable: a hypothesis that it cannot do without is broken.
    """
    best = choose(system) if _is_open(system, name) else None
    return best if best is not None and best.name == name else build(system, name)


def _is_open(system: System, name: str) -> bool:
    """Whether nhc chooses the velocities of the formulation of that name."""
    given = system.quasi or system.dependent or system.rotations
    return name in ("euler-lagrange", "voronec") and bool(system.constraints) and not given


def checked_dependent(system: System) -> DependentChoice:
    """:func:`dependent_of`, also where the formulation does not ask for it.

    Raises:
        nhc.diagnostics.SpecError: the spec's are too few, too many, or singular everywhere.
    """
    try:
        return dependent_of(system)
    except NotApplicable as error:
        refuse(system, error, system.spec.key_span(error.key))
        raise


def build(system: System, name: str) -> Formulation:
    """The named formulation.

    Raises:
        NotApplicable: a hypothesis that it cannot do without is broken.
    """
    if name == "newton":
        from nhc.mechanics.formulations import newton  # here: commands that do without it start sooner

        reasons = newton.broken_hypotheses(system)
        if reasons:
            raise NotApplicable(name, reasons)
        return Formulation(name, NUMBERS[name], None, None, (), "free particles with constant masses")
    if name == "lagrange":
        if system.constraints:
            held = several(system.l, "constraint")
            raise NotApplicable(name, [f"the system has {held}, and Lagrange's equations of T* are wrong"])
        return Formulation(name, NUMBERS[name], None, None, (), "no constraints")
    if name == "multipliers":
        reason = "all velocities kept, reactions as unknowns"
        return Formulation(name, NUMBERS[name], None, None, (), reason)
    if name == "euler-lagrange":
        return _euler_lagrange(system)
    return _reduced(system, name)


def _euler_lagrange(system: System) -> Formulation:
    try:
        forms, added = complete(system)
        forms = along_lines(system, forms)
        frame = make_frame(system, forms, [velocity_symbol(system, form) for form in forms])
    except Singular:
        raise NotApplicable(
            "euler-lagrange",
            [
                f"these quasi-velocities are no basis together with the {several(system.l, 'constraint')}"
                if system.l
                else "these quasi-velocities are no basis",
                *list_faults(system),
            ],
            "E0406",
            "quasi_velocities",
        ) from None
    number = "I.2.15" if system.l else "I.2.14"
    own = (
        "quasi-velocities of the spec"
        if not system.rotations
        else "angular velocities and quasi-velocities of the spec"
    )
    reason = own if not added else f"coframe completed by nhc with {', '.join(added)}"
    return Formulation("euler-lagrange", number, frame, None, added, reason)


def turning_formulations(system: System) -> Iterator[Formulation]:
    """The Euler-Lagrange equations in each set of angular velocities that the constraints may leave (none without rotations)."""
    for forms in turning_choices(system) if system.rotations else ():
        try:
            frame = make_frame(system, forms, [velocity_symbol(system, form) for form in forms])
        except Singular:
            continue
        yield Formulation(
            "euler-lagrange", "I.2.15", frame, None, (), "angular velocities that the constraints leave free"
        )


def dependent_of(system: System) -> DependentChoice:
    """The spec's dependent velocities, or nhc's choice.

    Raises:
        NotApplicable: the spec's are too few, too many, or singular everywhere.
    """
    if not system.dependent:
        return choose_dependent(system)
    if len(system.dependent) != system.l:
        reasons = [f"`dependent` names {len(system.dependent)} velocities, the constraints determine {system.l}"]
        raise NotApplicable("voronec", reasons, "E0407", "dependent")
    dependent = tuple(sorted(system.dependent))
    block = [[form.coefficients[j] for j in dependent] for form in system.constraints]
    if rank(system.graph, block) < system.l:
        names = ", ".join(f"`{system.q_names[i]}'`" for i in dependent)
        reasons = [f"the constraints cannot be solved for {names}: their coefficients are singular everywhere"]
        raise NotApplicable("voronec", reasons, "E0407", "dependent")
    return judge(system, dependent)


def _reduced(system: System, name: str) -> Formulation:
    if not system.constraints:
        raise NotApplicable(name, ["the system has no constraints: these are Lagrange's equations"])
    choice = dependent_of(system)
    reason = "dependent velocities of the spec" if system.dependent else "dependent velocities chosen by nhc"
    if name == "voronec":
        return _voronec(system, choice, reason)
    choice, frame, found = chaplygin_dependent(system, choice)
    if found.fatal:
        raise NotApplicable(name, found.fatal)
    return Formulation(name, NUMBERS[name], frame, choice, (), reason, found.broken)


def chaplygin_dependent(system: System, choice: DependentChoice) -> tuple[DependentChoice, Frame, Hypotheses]:
    """The dependent velocities of Čaplygin's equations, with their frame and hypotheses.

    They are ``choice`` where it allows these equations and where the spec gives it; else the best of the others that allow them,
    so that no system is refused for what nhc chose.  Who asks again, to say what was found, gets the same answer.
    """
    known: list[tuple[System, tuple[int, ...], tuple[DependentChoice, Frame, Hypotheses]]]
    known = system.graph.memory.setdefault("chaplygin dependents", [])
    for owner, columns, answer in known:
        if owner is system and columns == choice.dependent:
            return answer
    found = _find_chaplygin_dependent(system, choice)
    known.append((system, choice.dependent, found))
    return found


def _find_chaplygin_dependent(system: System, choice: DependentChoice) -> tuple[DependentChoice, Frame, Hypotheses]:
    from nhc.mechanics.formulations import chaplygin

    frame = coordinate_frame(system, choice.dependent)
    found = chaplygin.hypotheses(frame, choice.dependent)
    if system.dependent or not found.fatal:
        return choice, frame, found
    for other in ranked(system, chaplygin.possible(system), chaplygin.seem_free(system)):
        others = coordinate_frame(system, other.dependent)
        hypotheses = chaplygin.hypotheses(others, other.dependent)
        if not hypotheses.fatal:
            return other, others, hypotheses
    return choice, frame, found


def choose(system: System) -> Formulation:
    """The cheapest formulation that is valid and regular.

    The spec's own quasi-velocities come first.  Dependent velocities are taken where their block cannot vanish and the others are
    independent on what the constraints allow; else the adapted coframe, unless it is singular where the constraints are not: then
    dependent velocities that stay regular along the motions of a mechanism, or the multipliers.
    """
    if system.quasi:
        return build(system, "euler-lagrange")
    if not system.constraints:
        return build(system, "lagrange")
    choice = dependent_of(system)
    if choice.regular and leaves_digits(system, choice.dependent):
        led = _without_small_divisors(system, choice) or _on_axes(system, choice)
        return led or _reduced_or_voronec(system)
    try:
        adapted = build(system, "euler-lagrange")
    except NotApplicable:
        return build(system, "multipliers")
    assert adapted.frame is not None
    lost = _where_singular(system, adapted.frame.forms)
    if lost and system.dependent and not _where_singular(system, coordinate_frame(system, choice.dependent).forms):
        return _voronec(system, choice, "dependent velocities of the spec, regular on all positions that were tried")
    lasting = find_lasting(system) if lost else None
    if lasting is not None:
        why = "dependent velocities that stay regular on all positions that were tried"
        return _voronec(system, judge(system, lasting), why)
    if lost == ON_THE_WAY and are_multipliers_dear(system):
        return replace(
            adapted, reason=f"{adapted.reason}, singular at {lost}, for all velocities would take a multiple"
        )
    if lost:
        why = f"every coframe that was tried is singular at {lost}; all velocities kept"
        return replace(build(system, "multipliers"), reason=why)
    if is_unwieldy(system, adapted.frame):
        why = "the determinants that complete the constraints are many times as long as these; all velocities kept"
        return replace(build(system, "multipliers"), reason=why)
    names = ", ".join(f"{system.q_names[i]}'" for i in choice.dependent)
    whose = "of the spec" if system.dependent else "that nhc would choose"
    flaw = "leave too few digits of the others" if choice.regular else "are singular somewhere"
    return replace(adapted, reason=f"{adapted.reason}: the dependent velocities {whose} ({names}) {flaw}")


def _without_small_divisors(system: System, choice: DependentChoice) -> Formulation | None:
    """The adapted coframe, where the dependent velocities are divided by parameters: along knife edges that stand beside the point
    whose coordinates the spec has, or where these parameters are so small that the energy of the others is nearly degenerate.
    """
    g = system.graph
    if system.dependent or choice.determinant is None or not g.depends(choice.determinant, g.mask(system.p)):
        return None
    aside = set_pivots_aside(system, by_numbers=True)
    forms = adapted_forms(system, aside)
    if forms is None:
        return None
    forms = along_lines(system, forms)
    frame = make_frame(system, forms, [velocity_symbol(system, form) for form in forms])
    names = ", ".join(f"{system.q_names[i]}'" for i in choice.dependent)
    reason = f"coframe chosen by nhc: along the edges, since {names} would be divided by parameters"
    if not are_headings(system, forms, aside[0]):
        found = least_energy(system, coordinate_frame(system, choice.dependent))
        if found >= SOUND_ENERGY or least_energy(system, frame) < max(SOUND_ENERGY, 2 * found):
            return None
        reason = f"coframe chosen by nhc: solved for {names}, little is left of the energy of the other velocities"
    added = tuple(spelled(system, form) for form in forms)
    return Formulation("euler-lagrange", "I.2.15", frame, None, added, reason)


def _on_axes(system: System, choice: DependentChoice) -> Formulation | None:
    """The velocities along and across a body in place of x' and y', where the kinetic energy holds its heading in these alone."""
    found = None if system.dependent else frame_on_axes(system, choice.dependent)
    if found is None:
        return None
    frame, turning = found
    added = tuple(spelled(system, form) for form in frame.forms[system.l :])
    names = " and ".join(f"{system.q_names[k]}'" for k in (turning.first, turning.second))
    axes = f"on axes that turn with {system.q_names[turning.heading]}"
    reason = f"coframe chosen by nhc: {axes}, which the kinetic energy in {names} would contain"
    return Formulation("euler-lagrange", "I.2.15", frame, None, added, reason)


def _where_singular(system: System, forms: Sequence[Form]) -> str:
    """Where a coframe is singular although the constraints are not, as far as is known."""
    if weak_where_constraints_are_not(system, forms):
        return "an ordinary state"
    return ON_THE_WAY if becomes_singular(system, forms) else ""


def _voronec(system: System, choice: DependentChoice, reason: str) -> Formulation:
    return Formulation("voronec", NUMBERS["voronec"], coordinate_frame(system, choice.dependent), choice, (), reason)


def _reduced_or_voronec(system: System) -> Formulation:
    """Čaplygin's equations where they apply with velocities that stay regular, else Voronec's, with the reason."""
    try:
        reduced = build(system, "chaplygin")
    except NotApplicable as error:
        if error.code != "E0411":
            raise
        why = f"Čaplygin's equations do not apply: {error.reasons[0]}"
    else:
        if reduced.dependent is None or reduced.dependent.regular:
            return reduced
        names = ", ".join(f"{system.q_names[i]}'" for i in reduced.dependent.dependent)
        why = f"Čaplygin's equations would need {names}, which are singular somewhere"
    made = build(system, "voronec")
    return replace(made, reason=f"{made.reason}; {why}")


def applicable(system: System) -> list[Formulation]:
    """Every formulation that applies, the reference (multipliers or Lagrange) first."""
    order = ("multipliers", "lagrange", "newton", "euler-lagrange", "voronec", "chaplygin")
    found = []
    for name in order:
        try:
            found.append(of_name(system, name))
        except NotApplicable:
            continue
    return found
