"""Where one coframe finds no steady motion: others, in which one that turns may be steady."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from typing import TypeVar

from nhc.algebra.graph import Node
from nhc.diagnostics import SpecError
from nhc.mechanics.choosing.choose import Formulation, build
from nhc.mechanics.choosing.conditioning import adapted_choices
from nhc.mechanics.starts.scenes import Start
from nhc.mechanics.system import System
from nhc.simulate.switching import SOUND
from nhc.study.linearization.asked import SNAP
from nhc.study.linearization.field import SteadyModel
from nhc.study.linearization.found import NotSteady, SingularFrame, Steady

Found = TypeVar("Found")


def elsewhere(
    system: System,
    error: NotSteady,
    start: Start,
    study: Callable[[System, Formulation], Found],
    where: Callable[[Found], tuple[SteadyModel, Steady]],
    keeps: Callable[[Found], bool],
) -> Found:
    """What other coframes find where one did not: where it is singular, and where it may not have all angular velocities.

    A motion that turns is not steady in quasi-velocities such as x', but may be by multipliers, in axes that turn with it: that is
    taken where it ``keeps`` the velocities that were asked for.

    Raises:
        NotSteady: the error itself, where they find nothing either.
    """
    if isinstance(error, SingularFrame):
        return nearest_of(system, start, study, where)
    if system.rotations and error.place:
        with suppress(NotSteady):
            return nearest_of(system, start, study, where, whole=False)
    made = by_multipliers(system, start, study, keeps) if error.place else None
    if made is None:
        raise error
    return made


def by_multipliers(
    system: System, start: Start, study: Callable[[System, Formulation], Found], keeps: Callable[[Found], bool]
) -> Found | None:
    """What multipliers find of a motion that was asked about, if it ``keeps`` the velocities of it."""
    if not system.l or not any(start.v):
        return None
    with suppress(NotSteady):
        made = study(system, build(system, "multipliers"))
        if keeps(made):
            return made
    return None


def nearest_of(
    system: System,
    start: Start,
    study: Callable[[System, Formulation], Found],
    where: Callable[[Found], tuple[SteadyModel, Steady]],
    *,
    whole: bool = True,
) -> Found:
    """A study in coframes in which a motion that turns is steady, ``whole``: and by multipliers; that of the motion nearest to
    the start.

    Raises:
        NotSteady: none of them finds a steady motion; the reason is that of multipliers.
    """
    place, failed = start.values(system), NotSteady("no coframe has a steady motion", math.inf)
    found: list[tuple[float, Found]] = []
    if whole:
        try:
            made = study(system, build(system, "multipliers"))
            found.append((_distance(place, *where(made)), made))
        except NotSteady as error:
            failed = error
    for choice in adapted_choices(system, place):
        if choice.value >= SOUND:
            with suppress(NotSteady, SpecError):  # the names of other quasi-velocities are not known there
                other = study(choice.system, choice.formulation)
                found.append((_distance(place, *where(other)), other))
    if not found:
        raise failed
    least = min(distance for distance, _ in found)
    return next(one for distance, one in found if distance <= least + SNAP)


def _distance(place: dict[Node, float], model: SteadyModel, steady: Steady) -> float:
    """How far a steady motion is from a place, in q and q'."""
    system = model.flow.system
    values = [model.value(steady.y, node) for node in model.flow.velocities]
    pairs = [*zip(system.q, steady.y, strict=False), *zip(system.v, values, strict=True)]
    return math.sqrt(sum((place[symbol] - value) ** 2 for symbol, value in pairs))
