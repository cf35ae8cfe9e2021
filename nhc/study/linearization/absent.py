"""Motions that are steady, or of a family, for the values of the parameters alone: what is 0 is left out of the equations then."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TypeVar

from nhc.algebra.exact.field import Unlucky
from nhc.diagnostics import SpecError
from nhc.mechanics.about import scene_about
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation, formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.mechanics.system import System
from nhc.records import record
from nhc.study.linearization.field import SteadyModel
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import count_zeros
from nhc.study.linearization.motion import Findings, Request, linearise, linearise_whole, steady_model

T = TypeVar("T")
Worth = tuple[int, int]
"""Of what is found: how many velocities are lost, and how many zeros are none of a family; less is better."""

BEST: Worth = (0, 0)


def linearise_at_values(equations: Equations, formulation: Formulation, request: Request, *, fixed: bool) -> Findings:
    """Find the steady motion and linearise about it; ``fixed``: somebody asked for the formulation.

    A spring or a slope that may be 0 ties down a coordinate that is free without it.  Where the equations with all parameters have
    no steady motion, or not the one that was asked about, those without the parameters that are 0 are asked; and also where zeros
    are left that may be those of a family.

    Raises:
        nhc.diagnostics.SpecError: unknown names, or a guess that violates the constraints.
        NotSteady: no steady motion is found.
    """
    study = linearise if fixed else linearise_whole
    found: Findings | NotSteady
    try:
        found = study(equations, formulation, request)
    except NotSteady as error:
        found = error
    worth = None if isinstance(found, NotSteady) else (len(found.lost), count_zeros(found.linearisation))
    if worth != BEST:
        system = equations.system
        start = start_of(system, scene_about(system.spec, request.about, request.settings))
        other = ask_without_zeros(
            leave_zeros_out(
                system, start, request.sweep[0] if request.sweep else "", formulation.name if fixed else ""
            ),
            lambda left: study(left.equations, left.formulation, request),
            lambda other: (len(other.lost), count_zeros(other.linearisation)),
            worth,
            None if isinstance(found, NotSteady) else found.model,
        )
        if other is not None:
            return replace(other[0], absent=other[1])
    if isinstance(found, NotSteady):
        raise found
    return found


@record
class Left:
    """Equations without the parameters ``absent``, which are 0."""

    equations: Equations
    formulation: Formulation
    absent: tuple[str, ...]


def leave_zeros_out(system: System, start: Start, swept: str, formulation: str = "") -> Left | None:
    """The equations without the parameters that are 0 at a start, but for the one that is swept.

    None where all of them are something, and where there are no such equations, or not in this formulation.
    """
    pairs = zip(system.spec.parameters, start.p, strict=True)
    absent = tuple(parameter.name for parameter, value in pairs if value == 0 and parameter.name != swept)
    if not absent:
        return None
    try:
        own = resolve(system.spec, absent=absent)
        form = formulate(own, formulation)
        return Left(equations_of(own, form), form, absent)
    except (SpecError, Unlucky):
        return None


def ask_without_zeros(
    left: Left | None,
    ask: Callable[[Left], T],
    weigh: Callable[[T], Worth],
    worth: Worth | None,
    model: SteadyModel | None,
) -> tuple[T, tuple[str, ...]] | None:
    """What is found without the parameters that are 0, with their names; None unless it is better than what has that ``worth``.

    Where the motion is found whole with the ``model``, only more that is free can make a family of it.
    """
    if left is None:
        return None
    try:
        found_whole = worth is not None and not worth[0]
        if model and found_whole and not _is_freer(steady_model(left.equations, left.formulation, model.p), model):
            return None
        other = ask(left)
    except (NotSteady, SpecError, Unlucky):
        return None
    return (other, left.absent) if worth is None or weigh(other) < worth else None


def _is_freer(one: SteadyModel, other: SteadyModel) -> bool:
    """Whether more coordinates are cyclic, or more turns and shifts of all leave the equations as they are."""
    free, known = (len(model.cyclic) + max(map(len, model.symmetries), default=0) for model in (one, other))
    return free > known
