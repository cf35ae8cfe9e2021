"""What a user gave to the motion that is asked about: velocities that it keeps or that have gone, and where coordinates stay."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.language.expressions.syntax import Number
from nhc.language.spec import Initial, Scene
from nhc.mechanics.flow import Flow
from nhc.mechanics.linearize import quantity
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.values import coordinate_ranges
from nhc.study.linearization.field import Hold, SteadyModel
from nhc.study.linearization.found import Locked, NotSteady, SingularFrame, Steady
from nhc.study.linearization.steady import find_motion, find_steady

Search = Callable[[SteadyModel, Sequence[float], Sequence[Hold]], Steady]
SNAP = 1e-11
"""What differs by no more, relative to its size, is the same."""
_NOTHING = 1e-15
_LOST = 0.1  # of the kinetic energy: a motion with less is not the one that was asked about
_SLIGHT = 1e-3  # of the kinetic energy: a velocity of a scene with less is a disturbance
_FARTHER = 2.0  # times the way to the nearest steady motion: where the velocities of a scene must not lead

_PARTS = (0.5, 0.25, 0.75)  # of a range, where the search begins again


def find_asked(
    model: SteadyModel, scene: Scene, guess: Sequence[float], holds: Sequence[Hold], search: Search = find_motion
) -> Steady:
    """The steady motion that was asked about: with all that was given, where somebody gave it for this and there is such a motion.

    Else the nearest in the whole state that ``search`` finds, and the member of its family with the velocities that were given.

    Raises:
        NotSteady: none is found.
    """
    declared = next((one.initial for one in model.flow.system.spec.scenes if one.name == scene.name), ())
    try:
        asked, places = _asked(model, scene, guess), _places(model, scene, guess)
    except ArithmeticError:  # the search says why
        asked, places = [], []
    whole = (*holds, *(hold for _, hold in asked), *places)
    given = bool(asked and places) and not any(entry in declared for entry, _ in asked)
    found = _find(model, guess, whole) if given else None
    if found is None and given:  # a coordinate that stays has no rate: that one was a disturbance
        still = {place.name for place in places}
        calm = [hold for entry, hold in asked if entry.kind != "velocity" or entry.name not in still]
        found = _find(model, guess, (*holds, *calm, *places)) if 0 < len(calm) < len(asked) else None
    if found is not None:
        return _as_given(model, guess, found)
    try:
        nearest = keep_ranges(model, guess, search(model, guess, holds), holds)
    except (SingularFrame, Locked):
        raise  # there is one, or it is for other coframes to say
    except NotSteady:
        found = _find(model, guess, whole) if asked and not given else None
        if found is None:
            raise
        return _as_given(model, guess, found)
    asked = asked or _asked(model, scene, guess)
    loose = [(_share(model, guess, hold), entry in declared, hold) for entry, hold in asked]
    return _as_given(model, guess, _keep_speeds(model, guess, nearest, holds, loose))


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


def _keep_speeds(
    model: SteadyModel,
    guess: Sequence[float],
    nearest: Steady,
    holds: Sequence[Hold],
    asked: Sequence[tuple[float, bool, Hold]],
) -> Steady:
    """The member of the family of ``nearest`` that has the velocities that were asked for, one by one as far as there is one.

    The search alone ends at the member nearest in the whole state, of which the user gave a part: at another speed.  What moves
    most comes first: ``asked`` are parts of the kinetic energy, whether the spec's scene says so, and the holds.  A scene of the
    spec need not be near a steady motion: its own small velocities are disturbances that need not stay, nor should its others lead
    far away.
    """
    best, far = nearest, (_FARTHER * _way(model, guess, nearest), _FARTHER * _jolt(model, guess, nearest))
    for share, loose, hold in sorted(asked, key=lambda one: -one[0]):
        if loose and share <= _SLIGHT:
            continue
        kept = (*holds, hold)
        if abs(model.value(best.y, hold.node) - hold.value) > SNAP * abs(hold.value):
            other = _find(model, best.y, kept)
            if other is None:
                continue
            if loose and _way(model, guess, other) > far[0] and _jolt(model, guess, other) > far[1]:
                continue
            best = other
        holds = kept
    return best


def _find(model: SteadyModel, begin: Sequence[float], holds: Sequence[Hold]) -> Steady | None:
    with suppress(NotSteady):
        return find_steady(model, begin, holds)
    return None


def _places(model: SteadyModel, scene: Scene, guess: Sequence[float]) -> list[Hold]:
    """The coordinates that were given, apart from those that are cyclic or go along with a symmetry, of which any value does."""
    flow = model.flow
    named = {entry.name for entry in scene.initial if entry.kind == "coordinate"}
    turns = [turn for group in model.symmetries for turn in group]
    moved = {i for i in model.rest for turn in turns if turn.matrix[i].any() or turn.shift[i]}
    return [Hold(flow.names[i], flow.y[i], guess[i]) for i in model.rest if flow.names[i] in named and i not in moved]


def _as_given(model: SteadyModel, guess: Sequence[float], steady: Steady) -> Steady:
    """With the values of the guess where the search's differ from them by rounding only, if that is as steady."""
    pairs = zip(steady.y, guess, strict=True)
    y = tuple(own if abs(x - own) <= SNAP * (1.0 + abs(x)) else x for x, own in pairs)
    if y == steady.y:
        return steady
    rest, own = list(model.rest), replace(model, turning=steady.turning) if steady.turning else model
    left, before = (float(np.max(np.abs(own.field(at)[0])[rest], initial=0.0)) for at in (y, steady.y))
    return replace(steady, y=y) if left <= max(before, _NOTHING * (1.0 + max(map(abs, y)))) else steady


def _way(model: SteadyModel, guess: Sequence[float], steady: Steady) -> float:
    """How far a steady motion is from the guess, apart from cyclic coordinates, as the search sees it."""
    with suppress(ArithmeticError):
        model = model.in_units(guess)
    way = np.array(model.inside(steady.y)) - np.array(model.inside(guess))
    return float(np.linalg.norm(way[list(model.rest)]))


def _jolt(model: SteadyModel, guess: Sequence[float], steady: Steady) -> float:
    """How far its velocities are from the guess, by the kinetic energy of the difference: a small ball's spin is soon another."""
    kept = model.flow.kept
    change = np.array(steady.y[len(steady.y) - kept :]) - np.array(guess[len(guess) - kept :])
    with suppress(ArithmeticError):
        return float(np.sqrt(abs(change @ model.mass(guess)[:kept, :kept] @ change)))
    return math.inf


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
    """The velocities that were given, as they are in the guess; zeros are what nobody gives a thought, also where the rounding of
    a start that keeps to the constraints is in them.
    """
    found = list[tuple[Initial, Hold]]()
    for entry in scene.initial:
        if isinstance(entry.value, Number) and not entry.value.value:
            continue
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


def is_missed(model: SteadyModel, scene: Scene, guess: Sequence[float], y: Sequence[float]) -> bool:
    """Whether a velocity has gone that has much of the kinetic energy: the motion is another one than that asked about."""
    return any(
        abs(model.value(y, asked.node)) < abs(asked.value) / 2 and _share(model, guess, asked) > _LOST
        for _, asked in _asked(model, scene, guess)
    )


def list_lost(model: SteadyModel, scene: Scene, guess: Sequence[float], y: Sequence[float]) -> tuple[str, ...]:
    """Which velocities that were asked for have gone, with what is left of them."""
    lost = list[str]()
    for _, asked in _asked(model, scene, guess):
        after = model.value(y, asked.node)
        if abs(after) < abs(asked.value) / 2:
            now = after if abs(after) > SNAP * abs(asked.value) else 0
            lost.append(f"{asked.name} = {asked.value:.6g} has become {now:.6g}")
    return tuple(lost)
