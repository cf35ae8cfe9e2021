"""What a user gave to the motion that is asked about: velocities that it keeps or that have gone, and where coordinates stay."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.language.spec import Initial, Scene
from nhc.mechanics.flow import Flow
from nhc.mechanics.linearize import quantity
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.values import coordinate_ranges
from nhc.study.linearization.field import Hold, SteadyModel
from nhc.study.linearization.found import NotSteady, Steady
from nhc.study.linearization.steady import find_steady

SNAP = 1e-11
"""What differs by no more, relative to its size, is the same."""
_NOTHING = 1e-15
_LOST = 0.1  # of the kinetic energy: a motion with less is not the one that was asked about
_SLIGHT = 1e-3  # of the kinetic energy: a velocity of a scene with less is a disturbance
_FARTHER = 2.0  # times the way to the nearest steady motion: where the velocities of a scene must not lead

_PARTS = (0.5, 0.25, 0.75)  # of a range, where the search begins again


def keep_ranges(model: SteadyModel, guess: Sequence[float], nearest: Steady, holds: Sequence[Hold]) -> Steady:
    """A steady motion in the ranges that the spec gives to coordinates, if the search from a guess in them led out of them and
    finds one from elsewhere in them.

    Long first steps from where slopes are small end at a mirror image, as at a governor's balls that swing to the other side.
    """
    left = [i for i in list_outside(model, nearest.y) if i not in list_outside(model, guess)]
    if not left or model.leaf.dimension < model.flow.system.n:  # elsewhere is another leaf
        return nearest
    ranges, found = coordinate_ranges(model.flow.system), list[Steady]()
    for part in _PARTS:
        start = list(guess)
        for i in left:
            low, high = ranges[model.flow.y[i]]
            start[i] = low + part * (high - low)
        with suppress(NotSteady):
            found.append(find_steady(model, start, holds))
    inside = [steady for steady in found if not list_outside(model, steady.y)]
    return min(inside, key=lambda steady: _way(model, guess, steady), default=nearest)


def list_outside(model: SteadyModel, y: Sequence[float]) -> list[int]:
    """The entries of a state that have left their ranges, apart from cyclic coordinates."""
    ranges = coordinate_ranges(model.flow.system)
    limits = [(i, *ranges[model.flow.y[i]]) for i in model.rest if model.flow.y[i] in ranges]
    return [i for i, low, high in limits if not low - SNAP <= y[i] <= high + SNAP]


def keep_speeds(
    model: SteadyModel, scene: Scene, guess: Sequence[float], nearest: Steady, holds: Sequence[Hold]
) -> Steady:
    """The member of the family of ``nearest`` that has the velocities that were asked for, one by one as far as there is one.

    The search alone ends at the member nearest in the whole state, of which the user gave a part: at another speed.  What moves
    most comes first.  A scene of the spec need not be near a steady motion: its own small velocities are disturbances that need
    not stay, nor should its others lead far away.
    """
    declared = next((one.initial for one in model.flow.system.spec.scenes if one.name == scene.name), ())
    asked = [(_share(model, guess, hold), entry in declared, hold) for entry, hold in _asked(model, scene, guess)]
    far, best = _FARTHER * _way(model, guess, nearest), nearest
    for share, loose, hold in sorted(asked, key=lambda one: -one[0]):
        if loose and share <= _SLIGHT:
            continue
        kept = (*holds, hold)
        if abs(model.value(best.y, hold.node) - hold.value) > SNAP * abs(hold.value):
            try:
                other = find_steady(model, best.y, kept)
            except NotSteady:
                continue
            if loose and _way(model, guess, other) > far:
                continue
            best = other
        holds = kept
    return _as_given(model, guess, best)


def _as_given(model: SteadyModel, guess: Sequence[float], steady: Steady) -> Steady:
    """With the values of the guess where the search's differ from them by rounding only, if that is as steady."""
    pairs = zip(steady.y, guess, strict=True)
    y = tuple(own if abs(x - own) <= SNAP * (1.0 + abs(x)) else x for x, own in pairs)
    if steady.turning is not None or y == steady.y:
        return steady
    rest = list(model.rest)
    left, before = (float(np.max(np.abs(model.field(at)[0])[rest], initial=0.0)) for at in (y, steady.y))
    return replace(steady, y=y) if left <= max(before, _NOTHING * (1.0 + max(map(abs, y)))) else steady


def _way(model: SteadyModel, guess: Sequence[float], steady: Steady) -> float:
    """How far a steady motion is from the guess, apart from cyclic coordinates, as the search sees it."""
    with suppress(ArithmeticError):
        model = model.in_units(guess)
    way = np.array(model.inside(steady.y)) - np.array(model.inside(guess))
    return float(np.linalg.norm(way[list(model.rest)]))


def _share(model: SteadyModel, guess: Sequence[float], hold: Hold) -> float:
    """The least kinetic energy with which a quantity, linear in the velocities, has its value, beside that of the guess."""
    kept = model.flow.kept
    slopes = model.slopes(guess, hold.node)[len(model.flow.y) - kept :]
    yielding = float(slopes @ np.linalg.pinv(model.mass(guess)[:kept, :kept], hermitian=True) @ slopes)
    whole = abs(model.value(guess, _kinetic(model.flow)))
    return hold.value**2 / abs(2 * yielding * whole) if yielding * whole else 0.0


def _kinetic(flow: Flow) -> Node:
    """T over the state."""
    return substitute(flow.graph, [flow.system.T], moving(flow.system, flow.velocities))[0]


def _asked(model: SteadyModel, scene: Scene, guess: Sequence[float]) -> list[tuple[Initial, Hold]]:
    """The velocities that were given, as they are in the guess; zeros are what nobody gives a thought."""
    found = list[tuple[Initial, Hold]]()
    for entry in scene.initial:
        name = f"{entry.name}'" if entry.kind == "velocity" else entry.name
        node = None if entry.kind == "coordinate" else quantity(model.flow, name)
        value = 0.0 if node is None else model.value(guess, node)
        if node is not None and value:
            found.append((entry, Hold(name, node, value)))
    return found


def has_halted(model: SteadyModel, guess: Sequence[float], y: Sequence[float]) -> bool:
    """Whether most of the kinetic energy has gone: rest was nearer than what was meant."""
    kinetic = _kinetic(model.flow)
    return model.value(y, kinetic) < _LOST * model.value(guess, kinetic)


def describe_lost(model: SteadyModel, scene: Scene, guess: Sequence[float], y: Sequence[float]) -> str:
    """Which velocities that were asked for have gone, with what is left of them."""
    lost = list[str]()
    for _, asked in _asked(model, scene, guess):
        after = model.value(y, asked.node)
        if abs(after) < abs(asked.value) / 2:
            now = after if abs(after) > SNAP * abs(asked.value) else 0
            lost.append(f"{asked.name} = {asked.value:.6g} has become {now:.6g}")
    return "; ".join(lost)
