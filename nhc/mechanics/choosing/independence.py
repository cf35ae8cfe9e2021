"""How independent velocity forms are of each other on what the constraints allow, at points."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nhc.algebra.graph import Node
from nhc.algebra.minors import list_entries, subtract
from nhc.mechanics.frame import coordinate_form
from nhc.mechanics.regular.trials import ordinary_points, sampled_rows
from nhc.mechanics.system import Form, System

CLEAR = 0.03
"""Of a form's length: what is left of it beside others of which it is clearly independent."""
MANY_ROWS = 8
"""Constraints beyond which their order says more than the size of their determinant."""
SOUND = 1e-5
"""Of a free velocity's length: the mass matrix has its square, and six digits are left."""
_MUCH = 0.1
"""Of a form's length: where more is left, rounding leaves no more than ten times its own of the others in it."""
_ROUNDING = 1e-12


def independence(system: System, made: Sequence[Form], points: Sequence[dict[Node, float]]) -> float:
    """How long the free velocities, of forms of length 1, are at least on what the constraints and those before them leave.

    A point at which the constraints have no full rank says nothing: all coordinates zero are no position of a chain of rods.
    """
    least = 1.0
    for matrix in sampled_rows(system, [*system.constraints, *made], points):
        across: list[list[tuple[int, float]]] = []
        for k, row in enumerate(matrix):
            rest = _unit(row)
            for known in across:
                _leave_across(rest, known)
            length = math.hypot(*rest)
            if length < _MUCH:  # twice is enough (Kahan and Parlett), once is not where little is left
                for known in across:
                    _leave_across(rest, known)
                length = math.hypot(*rest)
            if k < system.l and length <= _ROUNDING:
                break
            if k >= system.l:
                least = min(least, length)
            across.append(list_entries(_unit(rest)))
    return least


def leaves_digits(system: System, dependent: Sequence[int]) -> bool:
    """Whether the velocities beside the dependent ones of many rows are independent on what the constraints allow.

    A determinant that never vanishes may still be small where each velocity follows from those before it.
    """
    free = [coordinate_form(system, j) for j in range(system.n) if j not in dependent]
    return system.l <= MANY_ROWS or independence(system, free, ordinary_points(system)) >= SOUND


def strongest(
    system: System,
    forms: Sequence[Form],
    groups: Sequence[Sequence[Form]],
    points: Sequence[dict[Node, float]],
    least: float = CLEAR,
) -> list[Form]:
    """Of each group in turn as many as are independent by ``least`` of all before them at every point, the farthest first."""
    digits = -math.floor(math.log10(least))  # what differs by less is as far
    before = [*system.constraints, *forms]
    offered = [form for group in groups for form in group]
    left = [[_unit(row) for row in matrix] for matrix in sampled_rows(system, [*before, *offered], points)]
    chosen: list[Form] = []

    def leave(k: int) -> None:
        """Only what of the rows is across the k-th one stays."""
        for rows in left:
            own = list_entries(_unit(rows[k]))
            for row in rows:
                _leave_across(row, own)

    for k in range(len(before)):
        leave(k)
    place = len(before)
    for group in groups:
        places = range(place, place + len(group))
        place += len(group)
        while left and places:
            far = {k: round(min(math.hypot(*rows[k]) for rows in left), digits) for k in places}
            best = max(places, key=lambda k: far[k])
            if far[best] < least:
                break
            chosen.append(offered[best - len(before)])
            leave(best)
    return chosen


def _leave_across(row: list[float], known: Sequence[tuple[int, float]]) -> None:
    """Only what of the row is across another one of length 1 stays; ``known`` are its entries that are not zero."""
    along = 0.0
    for j, y in known:
        along += row[j] * y
    if along:
        subtract(row, known, along)


def _unit(row: Sequence[float]) -> list[float]:
    """Of length 1; nothing where only rounding is left."""
    length = math.hypot(*row)
    return [x / length for x in row] if length > _ROUNDING else [0.0] * len(row)
