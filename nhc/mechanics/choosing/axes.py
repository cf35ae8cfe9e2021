"""Velocities along and across a body in place of x' and y', both of which the constraints leave free.

Of a robot on wheels that roll in all directions the mass matrix by x' and y' holds the heading, unless its centre of mass lies
where they are taken; on its own axes it is constant.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

from nhc.mechanics.choosing.energy import free_energy
from nhc.mechanics.choosing.headings import MOST_HEADINGS, Turning, find_turning, turned
from nhc.mechanics.choosing.minors import unused_name
from nhc.mechanics.frame import Frame, coordinate_form, coordinate_frame, make_frame, velocity_symbol
from nhc.mechanics.regular.trials import trial_points
from nhc.mechanics.system import System

_SAME = 1e-9


def frame_on_axes(system: System, dependent: Sequence[int]) -> tuple[Frame, Turning] | None:
    """The frame of the velocities that are not dependent, two of them on axes that turn, and how these turn; None where the kinetic
    energy does not gain by it.
    """
    free = [k for k in range(system.n) if k not in dependent]
    names = [name := unused_name(system, []), unused_name(system, [name])]
    for turning in islice(find_turning(system, free), MOST_HEADINGS):
        pair = turning.first, turning.second
        if _is_same(system, coordinate_frame(system, dependent), turning):
            return None
        along = dict(zip(pair, turning.axes(system, names), strict=True))
        forms = [along.get(k) or coordinate_form(system, k) for k in free]
        frame = make_frame(system, forms, [velocity_symbol(system, form) for form in forms])
        if _is_same(system, frame, turning):
            return frame, turning
    return None


def _is_same(system: System, frame: Frame, turning: Turning) -> bool:
    """Whether the kinetic energy by the frame's free velocities is the same before and after a turn, at some state."""
    state = dict(trial_points(system)[-1])
    before, after = (free_energy(system, frame, place) for place in (state, turned(system, state, turning.places)))
    if not before or len(before) != len(after):
        return False
    pairs = [pair for old, new in zip(before, after, strict=True) for pair in zip(old, new, strict=True)]
    return max(abs(x - y) for x, y in pairs) <= _SAME * max(abs(x) for x, _ in pairs)
