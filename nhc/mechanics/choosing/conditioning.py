"""How good a choice of free velocities is at one place, and which would be better there: for a run that has to change, and for the
model of a scene that starts there.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from math import comb, sqrt

from nhc.algebra.graph import Node
from nhc.mechanics.choosing.choose import Formulation, build, turning_formulations
from nhc.mechanics.choosing.energy import SOUND_ENERGY, Place, Rows, evaluate_rows, free_energy, least_eigenvalue
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.regular.regularity import relative_determinant
from nhc.mechanics.regular.trials import balanced_units, sampled_rows, trial_points, velocity_units
from nhc.mechanics.starts.scenes import Start
from nhc.mechanics.system import Form, System
from nhc.records import record

GAIN = 3.0
"""The determinant of a choice that is taken is this many times that of the one it replaces: between the two nothing changes."""
_NOTHING = 1e-12  # of a determinant, over the lengths of its rows: what the emitted functions refuse
_MANY = 250  # choices of dependent velocities that are looked at one by one
_KEPT = 0.5  # a preferred choice is taken down to this part of the best conditioning


@record
class Choice:
    """A formulation of ``system``, which may be in other velocities than the spec's, with its conditioning."""

    system: System
    formulation: Formulation
    value: float


def conditioning(system: System, formulation: Formulation, place: Place, units: Sequence[float] | None = None) -> float:
    """|det| of the coframe over the lengths of its rows (Hadamard), its l-th root: in [0, 1], 0 where it is singular.

    A free form counts with the length that it has elsewhere, so that one that vanishes is not taken for a good one.  Where a
    form has no value (log(x) x' at x = 0) the coframe is singular, too.  ``units`` of the velocities: by default those in which
    regularity is judged.
    """
    if formulation.frame is None:
        return 1.0
    forms, own = formulation.frame.forms, tuple(velocity_units(system) if units is None else units)
    try:
        rows = balanced_rows(system, forms, place, own)
    except (ArithmeticError, ValueError):
        return 0.0
    value = relative_determinant(rows, range(len(rows))) ** len(rows)
    for form, row in zip(forms[system.l :], rows[system.l :], strict=True):
        length = _norm(row)
        value *= length / max(length, _usual_length(system, form, own), 1e-300)
    return float(value ** (1.0 / max(system.l, 1)))


def _norm(row: Sequence[float]) -> float:
    return sqrt(sum(x * x for x in row))


def _usual_length(system: System, form: Form, units: tuple[float, ...]) -> float:
    """The median of a form's length over the places that regularity is judged by."""
    known: dict[tuple[tuple[Node, ...], tuple[float, ...]], float] = system.graph.memory.setdefault("usual lengths", {})
    key = form.direction, units
    if key not in known:
        lengths = sorted(_norm(rows[0]) for rows in sampled_rows(system, [form], units=units))
        known[key] = lengths[len(lengths) // 2] if lengths else 1.0
    return known[key]


def balanced_rows(system: System, forms: Sequence[Form], place: Place, units: Sequence[float] | None = None) -> Rows:
    """The same in these units of the velocities, by default those in which regularity is judged."""
    own = velocity_units(system) if units is None else units
    return [[a * u for a, u in zip(row, own, strict=True)] for row in evaluate_rows(system, forms, place)]


def find_better(system: System, now: Formulation, place: Place, known: Sequence[Choice]) -> Choice | None:
    """A choice that is worth a change at ``place`` (values of t, q, q' and p), or None.

    Those of ``known`` come first, then dependent velocities and the adapted coframe, the present kind before the other, each
    while it has half the conditioning of the best.  None is taken where the kinetic energy of its free velocities is degenerate:
    then the coordinates or the constraints themselves are singular.
    """
    needed = GAIN ** (1.0 / max(system.l, 1)) * conditioning(system, now, place)
    kinds = [_dependent(system, place), adapted_choices(system, place)]
    if now.dependent is None:
        kinds.reverse()
    options = [*_rated(known, place), *(choice for kind in kinds for choice in kind)]
    best = max((choice.value for choice in options), default=0.0)
    for choice in options:
        if choice.value > 0.0 and choice.value >= max(needed, _KEPT * best) and _is_definite(choice, place):
            return choice
    return None


def find_start(system: System, now: Formulation, start: Start) -> Formulation | None:
    """A formulation that is better than ``now`` where a scene starts, with the reason, or None: as :func:`find_better`, or all
    velocities where the coframes that are tried are all singular there and the constraints are not.

    The better one must also be so in units in which the constraints' coefficients are near 1: a small ball on a large cone has
    small determinants for its size alone.
    """
    place = start.values(system)
    found = find_better(system, now, place, ())
    where = f"the start of the scene {start.scene.name}" if start.scene.name else "the motion of --about"
    why = f"chosen for {where}, where {name_of(system, now)} is singular or nearly so"
    if found is not None and not _is_lost(system, found.value) and _gains(system, now, found, place):
        return replace(found.formulation, reason=why)
    if not system.l or not _is_lost(system, conditioning(system, now, place)) or not _has_rank(system, place):
        return None
    return replace(build(system, "multipliers"), reason=f"{why}, and so are the other coframes that were tried")


def _gains(system: System, now: Formulation, found: Choice, place: Place) -> bool:
    """Whether a choice is worth a change in balanced units, too."""
    units = balanced_units(system)
    needed = GAIN ** (1.0 / max(system.l, 1)) * conditioning(system, now, place, units)
    return bool(conditioning(found.system, found.formulation, place, units) >= needed)


def _has_rank(system: System, place: Place) -> bool:
    """Whether some of the constraints' blocks of dependent velocities is regular there."""
    rows = balanced_rows(system, system.constraints, place)
    return not _is_lost(system, relative_determinant(rows, _best_columns(rows, system.n)))


def _is_lost(system: System, value: float) -> bool:
    """Whether a conditioning, an l-th root, is of a determinant that is nothing but rounding."""
    return value ** max(system.l, 1) <= _NOTHING


def name_of(system: System, formulation: Formulation) -> str:
    """``voronec solved for x'``, ``the coframe with v, phi'``."""
    if formulation.dependent is not None:
        names = ", ".join(f"{system.q_names[i]}'" for i in formulation.dependent.dependent)
        return f"{formulation.name} solved for {names}"
    if formulation.frame is None:
        return formulation.name
    forms = formulation.frame.forms[system.l :]
    names = ", ".join(f"{form.name}'" if form.name in system.q_names else form.name for form in forms)
    return f"{formulation.name} with {names}"


def _rated(known: Sequence[Choice], place: Place) -> Iterator[Choice]:
    for choice in known:
        yield replace(choice, value=conditioning(choice.system, choice.formulation, place))


def _dependent(system: System, place: Place) -> Iterator[Choice]:
    """The dependent velocities that are best there; without constraints, all velocities kept."""
    if not system.l:
        yield Choice(system, build(system, "lagrange"), 1.0)
        return
    rows = balanced_rows(system, system.constraints, place)
    columns = _best_columns(rows, system.n)
    chosen = replace(system, dependent=columns)
    try:
        yield Choice(system, build(chosen, "voronec"), relative_determinant(rows, columns))
    except NotApplicable:
        return


def _best_columns(rows: Rows, n: int) -> tuple[int, ...]:
    if comb(n, len(rows)) <= _MANY:
        return max(combinations(range(n), len(rows)), key=lambda columns: relative_determinant(rows, columns))
    work, found = [list(row) for row in rows], list[int]()
    for k in range(len(work)):  # elimination with full pivoting
        pairs = ((abs(work[i][j]), i, j) for i in range(k, len(work)) for j in range(n) if j not in found)
        _, best, column = max(pairs)
        work[k], work[best] = work[best], work[k]
        found.append(column)
        for i in range(k + 1, len(work)):
            part = work[i][column] / work[k][column] if work[k][column] else 0.0
            work[i] = [x - part * y for x, y in zip(work[i], work[k], strict=True)]
    return tuple(sorted(found))


def adapted_choices(system: System, place: Place) -> Iterator[Choice]:
    """Coframes in the constraints' own velocities, in which a motion that turns may be steady; none without constraints."""
    if not system.l:
        return
    for turning in turning_formulations(system):
        yield Choice(system, turning, conditioning(system, turning, place))
    plain = replace(system, quasi=(), dependent=())
    try:
        made = build(plain, "euler-lagrange")
    except NotApplicable:
        return
    yield Choice(system, made, conditioning(system, made, place))


def _is_definite(choice: Choice, place: Place) -> bool:
    """Whether the kinetic energy of the free velocities is well conditioned, scaled to a diagonal of ones."""
    return least_eigenvalue(free_energy(choice.system, choice.formulation.frame, place)) >= SOUND_ENERGY


def is_mass_sound(system: System, formulation: Formulation, place: Place) -> bool:
    """Whether the kinetic energy of the free velocities is well conditioned at a place, and none of its squares has become small
    against what it is elsewhere (the angle's of polar coordinates near their centre).
    """
    here = free_energy(system, formulation.frame, place)
    if least_eigenvalue(here) < SOUND_ENERGY:
        return False
    frame = formulation.frame
    elsewhere = [found for point in trial_points(system) if (found := free_energy(system, frame, dict(point)))]
    for k in range(len(here)):
        usual = sorted(found[k][k] for found in elsewhere)
        if not usual or here[k][k] < SOUND_ENERGY * usual[len(usual) // 2]:
            return False
    return True
