"""Coframes at positions that a motion can reach under equations of positions: which become singular there, and which do not.

Points that are drawn at random do not show it: a coframe is singular on a surface that they miss, and most of them are no
positions of the mechanism.  A walk along velocities that the constraints allow stays on the mechanism's positions, and where the
determinant has another sign after a step, the motion can reach a place where it is zero.
"""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from itertools import combinations, pairwise
from operator import mul

from nhc.algebra.bounds.common_zero import find_common_zero
from nhc.algebra.graph import Node
from nhc.algebra.minors import float_determinant, relative_minors
from nhc.mechanics.regular.given_rank import given_states
from nhc.mechanics.regular.trials import sampled_rows, velocity_units
from nhc.mechanics.system import Form, System

_MOST_WALKED, _MOST_LED = 12, 30  # coordinates; the second of mechanisms of one degree of freedom
_MOST_CHOICES = 1000  # of dependent velocities that are compared
_WALKS, _SURE_WALKS, _MORE_WALKS, _STEPS = 2, 4, 8, 30
_FREEDOM = 2  # velocities that the constraints leave free
_TURN = 0.3  # radians by which a step may turn the rows of the constraints
_LITTLE = 0.25  # of a determinant's largest value: it may as well vanish elsewhere
_SWERVE = 0.4  # from step to step
_PROBE = 1e-5
_HALVINGS = 24  # between two places of a walk
_ZERO = 1e-11  # of the rows' lengths: nothing but rounding
_LOST = 1e-4  # of the lengths of the constraints' rows: what is left of them where they are about to lose rank
_WEAK = 0.03  # of the largest determinant that rows of these lengths can have (per constraint)

Point = dict[Node, float]
Rows = list[list[float]]


def becomes_singular(system: System, forms: Sequence[Form]) -> bool:
    """Whether a walk from positions that ``holonomic:`` allows leads through a place where n forms, those of the constraints
    first, are no coframe although the constraints have full rank on both sides, or are none where it begins; False where there
    are no such equations.  A mechanism that has folded may move without ever passing a place where its coframe is regular.

    Long mechanisms are not walked but those of one degree of freedom, and are not thought to become singular.
    """
    walks = [_with_rows(system, forms, walk) for walk in _walks(system, _WALKS)]
    if any(_becomes_singular_on(system, forms, walk) for walk in walks):
        return True
    if system.n - system.l <= _FREEDOM or not _has_changed(walks):
        return False
    # walks do not get everywhere where more velocities are free
    more = (_with_rows(system, forms, walk) for walk in _walks(system, _SURE_WALKS)[_WALKS:])
    return any(_becomes_singular_on(system, forms, walk) for walk in more)


_Walked = list[tuple[Point, Rows | None]]
"""Places one after the other, each with the matrix of the forms there."""


def _with_rows(system: System, forms: Sequence[Form], walk: Sequence[Point]) -> _Walked:
    return [(place, _rows(system, forms, place)) for place in walk]


def _has_changed(walks: Sequence[_Walked]) -> bool:
    """Whether the determinant of the forms becomes much less than it is elsewhere on walks: that of a rod's minors does not."""
    found = [abs(float_determinant(rows)) for walk in walks for _, rows in walk if rows is not None]
    return bool(found) and min(found) < _LITTLE * max(found)


def _becomes_singular_on(system: System, forms: Sequence[Form], places: _Walked) -> bool:
    for (first, rows), (second, others) in [*pairwise(places)] or [(place, place) for place in places]:
        if rows is None or others is None:
            return False
        if _changes_sign([rows, others]) and not _is_lost_between(system, forms, first, second):
            return True
    return False


def _is_lost_between(system: System, forms: Sequence[Form], first: Point, second: Point) -> bool:
    """Whether the constraints lose rank where the determinant changes its sign between two places: a step may go over that."""
    equations = [form.equation for form in system.constraints if form.equation is not None]
    sign = float_determinant(_rows(system, forms, first) or [[0.0]])
    for _ in range(_HALVINGS):
        middle = {**first, **{x: (first[x] + second[x]) / 2 for x in (*system.q, system.t)}}
        place = find_common_zero(system.graph, equations, system.q, [middle]) or middle
        rows = _rows(system, forms, place)
        if rows is None:
            return False
        first, second = (place, second) if float_determinant(rows) * sign > 0.0 else (first, place)
    rows = _rows(system, system.constraints, second)
    return rows is None or _orthonormal(rows) is None


def are_multipliers_dear(system: System) -> bool:
    """Whether the multipliers of a mechanism take a multiple of the operations of a coframe (2 for 9 links, 5 for 20).

    A run changes its choice on the way anyway.
    """
    return system.n > _MOST_WALKED and any(form.equation is not None for form in system.constraints)


def find_lasting(system: System) -> tuple[int, ...] | None:
    """The dependent velocities that stay farthest from singular on walks; None where all come near it, or none was walked.

    With one or two degrees of freedom only: walks do not get everywhere with more.
    """
    freedom = system.n - system.l
    if freedom > _FREEDOM or math.comb(system.n, system.l) > _MOST_CHOICES:
        return None
    least = dict.fromkeys(combinations(range(system.n), system.l), 1.0)
    walked = False
    for k in range(_WALKS if freedom == 1 else _MORE_WALKS):
        for walk in _walks(system, k + 1)[k:] if least else ():
            places, walked = [_rows(system, system.constraints, place) for place in walk], True
            for rows in places:
                near = relative_minors(rows or [], list(least))
                least = {c: min(x, y) for (c, x), y in zip(least.items(), near, strict=True) if min(x, y) > _WEAK}
            least = {c: x for c, x in least.items() if not _changes_sign([_block(rows, c) for rows in places])}
    return max(least, key=lambda c: least[c]) if walked and least else None


def _block(rows: Rows | None, columns: Sequence[int]) -> Rows | None:
    return None if rows is None else [[row[j] for j in columns] for row in rows]


def _changes_sign(places: Sequence[Rows | None]) -> bool:
    """Whether the determinants along a walk change their sign, or are zero."""
    found = []
    for rows in places:
        if rows is None:
            break
        found.append(float_determinant(rows))
        if abs(found[-1]) < _ZERO * math.prod(math.hypot(*row) for row in rows):
            return True
    return any(x * y < 0.0 for x, y in pairwise(found))


def _walks(system: System, count: int) -> list[list[Point]]:
    """Positions one after the other that the constraints allow, each walk until they are about to lose rank; none where there are
    no equations of positions or too many coordinates.
    """
    equations = [form.equation for form in system.constraints if form.equation is not None]
    most = _MOST_LED if system.n == system.l + 1 else _MOST_WALKED
    given = given_states(system) if equations and system.n <= most else []
    starts = [one for k, one in enumerate(given) if one not in given[:k]]  # a scene that is there twice is one
    if not starts:
        return []
    known: list[tuple[object, list[list[Point]]]] = system.graph.memory.setdefault("walks", [])
    walks = next((walks for spec, walks in known if spec is system.spec), None)
    if walks is None:
        walks = list[list[Point]]()
        known.append((system.spec, walks))
    for k in range(len(walks), count):
        walks.append(_walk(system, equations, starts[k % len(starts)], random.Random(13 + k)))
    return walks[:count]


def _walk(system: System, equations: Sequence[Node], start: Point, rng: random.Random) -> list[Point]:
    """A walk that ends where the constraints lose rank goes on at its other end."""
    place = {x: start[x] for x in (*system.q, *system.v, *system.p, system.t)}
    heading = [rng.gauss(0, 1) for _ in system.q]
    ahead = _go(system, equations, place, heading, rng, _STEPS)
    behind = _go(system, equations, place, [-x for x in heading], rng, _STEPS - len(ahead) + 1)
    return [*behind[:0:-1], *ahead]


def _go(
    system: System, equations: Sequence[Node], start: Point, heading: Sequence[float], rng: random.Random, steps: int
) -> list[Point]:
    """At most as many places, of which the first is the start; fewer where the constraints lose rank."""
    place: Point | None = start
    walked: list[Point] = []
    while place is not None and len(walked) < steps:
        rows = _rows(system, system.constraints, place)
        across = _orthonormal(rows) if rows is not None else None
        if rows is None or across is None:
            break
        walked.append(place)
        heading = _along([x + _SWERVE * rng.gauss(0, 1) for x in heading] if len(walked) > 1 else heading, across)
        step = _length(system, place, rows, heading)
        place = find_common_zero(system.graph, equations, system.q, [_moved(system, place, heading, step)])
    return walked


def _rows(system: System, forms: Sequence[Form], place: Point) -> Rows | None:
    """The matrix of the forms at a place, None where it has no value."""
    found = sampled_rows(system, forms, [dict(place)])
    return found[0] if found and all(math.isfinite(x) for row in found[0] for x in row) else None


def _length(system: System, place: Point, rows: Rows, heading: Sequence[float]) -> float:
    """How far to go along a unit vector: until the constraints' rows have turned by a part of a radian; at most 1."""
    units = velocity_units(system)
    probe = _PROBE * (1.0 + max(abs(place[x]) / u for x, u in zip(system.q, units, strict=True)))
    other = _rows(system, system.constraints, _moved(system, place, heading, probe))
    if other is None:
        return 0.0
    turned = 0.0
    for row, new in zip(rows, other, strict=True):
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
