"""Whether a coframe becomes singular at positions that a motion can reach under equations of positions.

Points that are drawn at random do not show it: a coframe is singular on a surface that they miss, and most of them are no
positions of the mechanism.  A walk along velocities that the constraints allow stays on the mechanism's positions, and where the
determinant has another sign after a step, the motion can reach a place where it is zero.
"""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from operator import mul

from nhc.algebra.bounds.common_zero import find_common_zero
from nhc.algebra.graph import Node
from nhc.algebra.minors import float_determinant
from nhc.mechanics.regular.given_rank import given_states
from nhc.mechanics.regular.trials import sampled_rows, velocity_units
from nhc.mechanics.system import Form, System

MOST_WALKED = 8
_WALKS, _STEPS = 2, 30
_TURN = 0.3  # radians by which a step may turn the rows of the constraints
_PROBE = 1e-5
_LOST = 1e-4  # of the lengths of the constraints' rows: what is left of them where they are about to lose rank

Point = dict[Node, float]
Rows = list[list[float]]


def becomes_singular(system: System, forms: Sequence[Form]) -> bool:
    """Whether a walk from positions that ``holonomic:`` allows leads through a place where n forms, those of the constraints
    first, are no coframe although the constraints have full rank on both sides; False where there are no such equations.

    Mechanisms with more than MOST_WALKED coordinates are not walked: multipliers would cost them a multiple (2 for 9 links, 5 for
    20), and a run changes its choice on the way anyway.
    """
    if system.n > MOST_WALKED or not any(form.equation is not None for form in system.constraints):
        return False
    rng = random.Random(13)
    return any(_changes_sign(system, forms, start, rng) for start in given_states(system)[:_WALKS])


def _changes_sign(system: System, forms: Sequence[Form], start: Point, rng: random.Random) -> bool:
    place: Point | None = {x: start[x] for x in (*system.q, *system.v, *system.p, system.t)}
    equations = [form.equation for form in system.constraints if form.equation is not None]
    heading = [rng.gauss(0, 1) for _ in system.q]
    before = 0.0
    for _ in range(_STEPS):
        rows = _rows(system, forms, place) if place is not None else None
        if place is None or rows is None:
            return False
        across = _orthonormal(rows[: system.l])
        if across is None:
            return False
        now = float_determinant(rows)
        if before * now < 0.0:
            return True
        before = now
        heading = _along([x + 0.4 * rng.gauss(0, 1) for x in heading], across)
        step = _length(system, forms, place, rows, heading)
        place = find_common_zero(system.graph, equations, system.q, [_moved(system, place, heading, step)])
    return False


def _rows(system: System, forms: Sequence[Form], place: Point) -> Rows | None:
    """The matrix of the forms at a place, None where it has no value."""
    found = sampled_rows(system, forms, [dict(place)])
    return found[0] if found and all(math.isfinite(x) for row in found[0] for x in row) else None


def _length(system: System, forms: Sequence[Form], place: Point, rows: Rows, heading: Sequence[float]) -> float:
    """How far to go along a unit vector: until the constraints' rows have turned by a part of a radian; at most 1."""
    units = velocity_units(system)
    probe = _PROBE * (1.0 + max(abs(place[x]) / u for x, u in zip(system.q, units, strict=True)))
    other = _rows(system, forms, _moved(system, place, heading, probe))
    if other is None:
        return 0.0
    turned = 0.0
    for row, new in zip(rows[: system.l], other[: system.l], strict=True):
        turned = max(turned, math.dist(row, new) / (math.hypot(*row) or 1.0))
    return min(1.0, _TURN * probe / turned) if turned else 1.0


def _moved(system: System, place: Point, heading: Sequence[float], step: float) -> Point:
    """The place a step along a vector in the units of the rows."""
    units = velocity_units(system)
    return {**place, **{x: place[x] + step * d * u for x, d, u in zip(system.q, heading, units, strict=True)}}


def _orthonormal(rows: Rows) -> Rows | None:
    """Of the space of the rows; None where they hardly span as many dimensions as they are."""
    found: Rows = []
    for row in rows:
        rest = _along(row, found, unit=False)
        length = math.hypot(*rest)
        if not length > _LOST * math.hypot(*row):
            return None
        found.append([x / length for x in rest])
    return found


def _along(vector: Sequence[float], across: Rows, *, unit: bool = True) -> list[float]:
    """What of the vector is orthogonal to unit vectors that are so to each other, as a unit vector."""
    rest = list(vector)
    for row in across:
        part = sum(map(mul, rest, row))
        rest = [x - part * y for x, y in zip(rest, row, strict=True)]
    length = math.hypot(*rest) if unit else 1.0
    return [x / length for x in rest] if length else rest
