"""Motions that are steady for the values of the parameters alone: what is 0 is left out of the equations where they need it."""

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
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.motion import Findings, Request, linearise, linearise_whole

T = TypeVar("T")


def linearise_at_values(equations: Equations, formulation: Formulation, request: Request, *, fixed: bool) -> Findings:
    """Find the steady motion and linearise about it; ``fixed``: somebody asked for the formulation.

    A spring or a slope that may be 0 ties down a coordinate that is free without it.  Where the equations with all parameters have
    no steady motion, or not the one that was asked about, those without the parameters that are 0 are asked.

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
    if isinstance(found, NotSteady) or found.lost:
        system = equations.system
        start = start_of(system, scene_about(system.spec, request.about, request.settings))
        other = ask_without_zeros(
            leave_zeros_out(
                system, start, request.sweep[0] if request.sweep else "", formulation.name if fixed else ""
            ),
            lambda left: study(left.equations, left.formulation, request),
            lambda other: len(other.lost),
            most_lost(start) if isinstance(found, NotSteady) else len(found.lost),
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


def most_lost(start: Start) -> int:
    """How many velocities are lost where nothing is found: one more than there can be."""
    return len(start.v) + 1


def ask_without_zeros(
    left: Left | None, ask: Callable[[Left], T], count: Callable[[T], int], lost: int
) -> tuple[T, tuple[str, ...]] | None:
    """What is found without the parameters that are 0, with their names; None unless fewer velocities are ``lost`` then."""
    if left is None:
        return None
    try:
        other = ask(left)
    except (NotSteady, SpecError, Unlucky):
        return None
    return (other, left.absent) if count(other) < lost else None
