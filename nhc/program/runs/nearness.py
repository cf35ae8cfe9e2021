"""How near the multiplier form is to where the constraints and the mass matrix do not determine the accelerations.

It is solved by elimination in doubles, whose pivots are no expressions.  What tells how near it is to singular is one more
elimination: 1/|K^-1|, by the squares of all entries, lies between the least singular value of K and its part 1/sqrt(n).  Of a large
matrix a few columns K^-1 b stand for all, with fixed b that have no pattern: what K takes to zero is perpendicular to none of them.
K has the units in which each coordinate's own mass is one, and so is what each constraint has beside the masses: no unit and no
factor of a constraint decides.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import islice

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.dense import Singular, pivot_signs, solve_double
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.solving.blocks import determinant_of
from nhc.algebra.solving.sizes import size_of
from nhc.algebra.walks import count
from nhc.mechanics.regular.trials import trial_points
from nhc.mechanics.values import scene_values
from nhc.program.plan import SolvePlan
from nhc.program.planning.base import PlannerBase
from nhc.records import record

_POINTS = 24  # at most, at which its usual value is looked for
_COLUMNS = 8  # that stand for all
_NO_MASS = 1e-6  # of the largest mass that a coordinate has at these points
_LARGE, _TERMS, _MOST_ROWS = 400, 60, 4  # of determinants that are judged
_TOLERANCE = 1e-15
"""Of the elimination: with less there is rounding alone, and it is refused."""


@record
class Nearness:
    """``value``, zero where it is singular; ``usual``: what it is at its best; ``solve`` gives the unknowns that are in it."""

    value: Node
    usual: Fraction
    solve: SolvePlan


def find_nearness(planner: PlannerBase) -> Nearness | None:
    """None where every state has the same, and where masses that are not positive have no units of their own."""
    if not planner.solves or not planner.equations.multipliers:
        return None
    g, given = planner.graph, planner.solves[0]
    masses = len(given.matrix) - len(planner.equations.multipliers)
    points = _points(planner, given.matrix)
    matrix = _in_own_units(g, given.matrix, _least_masses(planner, given.matrix[:masses], points), masses)
    if all(planner.is_constant(entry) for row in matrix for entry in row):
        return None
    columns = _columns(len(matrix))
    usual = _find_usual(g, given.matrix, matrix, columns, masses, points)
    if usual is None:
        return None
    size = range(len(matrix))
    unknowns = tuple(tuple(g.symbol(f"near_{c}_{k}", "unknown") for k in size) for c in range(len(columns)))
    value = g.inverse(g.function("sqrt", g.sum([g.power(x, 2) for column in unknowns for x in column])))
    right = tuple(tuple(g.number(b) for b in column) for column in columns)
    rows = tuple(tuple(row) for row in matrix)
    return Nearness(value, usual, SolvePlan(rows, right, unknowns, _TOLERANCE, given.status, given.what))


def are_masses_regular(planner: PlannerBase, known: dict[Node, Interval]) -> bool:
    """Whether the mass matrix of the multiplier form is shown to be regular everywhere, block by block."""
    g = planner.graph
    masses = len(planner.solves[0].matrix) - len(planner.equations.multipliers)
    matrix = [row[:masses] for row in planner.solves[0].matrix[:masses]]
    for block in _blocks(g, matrix):
        if len(block) > _MOST_ROWS:
            if any(not planner.is_constant(matrix[i][j]) for i in block for j in block):
                return False
            continue
        value = determinant_of(g, [[matrix[i][j] for j in block] for i in block])
        if planner.is_constant(value):
            continue
        if count(g, [value]) > _LARGE or not cannot_vanish(g, normalise(g, value, _TERMS), known):
            return False
    return True


def _blocks(graph: Graph, matrix: Sequence[Sequence[Node]]) -> Iterator[list[int]]:
    """The rows that hang together."""
    left = set(range(len(matrix)))
    while left:
        block, fresh = set[int](), {min(left)}
        while fresh:
            block |= fresh
            fresh = {j for i in fresh for j in left - block if matrix[i][j] != graph.zero}
        left -= block
        yield sorted(block)


def _columns(size: int) -> list[list[Fraction]]:
    """The unit vectors; of many rows, columns with entries between -1 and 1 (the golden section's multiples have no pattern)."""
    if size <= _COLUMNS:
        return [[Fraction(int(i == k)) for i in range(size)] for k in range(size)]
    parts = [[(i * _COLUMNS + k + 1) * 6180339887 % 10**10 for i in range(size)] for k in range(_COLUMNS)]
    return [[Fraction(part // 10**7 - 500, 500) for part in column] for column in parts]


def _points(planner: PlannerBase, matrix: Sequence[Sequence[Node]]) -> list[dict[Node, float]]:
    """Places, of scenes and others, at which it is looked how large things usually are."""
    system = planner.system
    symbols = sorted({symbol for row in matrix for node in row for symbol in planner.graph.symbols_in(node)})
    points = islice((p | values for values in scene_values(system) for p in trial_points(system)), _POINTS)
    return [{**dict.fromkeys(symbols, 0.37), **point} for point in points]


def _least_masses(
    planner: PlannerBase, matrix: Sequence[Sequence[Node]], points: Sequence[dict[Node, float]]
) -> list[Fraction]:
    """Where a mass that changes comes down to this, a small part of its largest value, the constraints give the unit, too."""
    found = [0.0] * len(matrix)
    for i, row in enumerate(matrix):
        for point in points if not planner.is_constant(row[i]) else ():
            with suppress(ArithmeticError, ValueError):
                found[i] = max(found[i], abs(float(evaluate(planner.graph, [row[i]], point)[0])))
    return [_power_below(_NO_MASS * x) if 0.0 < x < math.inf else Fraction(0) for x in found]


def _power_below(x: float) -> Fraction:
    return Fraction(10) ** math.floor(math.log10(x))


def _in_own_units(
    graph: Graph, matrix: Sequence[Sequence[Node]], least: Sequence[Fraction], masses: int
) -> list[list[Node]]:
    """Coordinates without mass have what the constraints make them as their unit."""
    g, size = graph, len(matrix)
    own = [g.one] * size
    heavy = [i for i in range(masses) if matrix[i][i] != g.zero]
    for i in heavy:
        own[i] = g.inverse(g.function("sqrt", g.add(size_of(g, matrix[i][i]), g.number(least[i]))))
    for j in range(masses, size):
        beside = heavy if any(matrix[i][j] != g.zero for i in heavy) else range(masses)
        own[j] = _unit(g, [g.mul(matrix[i][j], own[i]) for i in beside])
    for i in set(range(masses)) - set(heavy):
        own[i] = _unit(g, [g.mul(matrix[i][j], own[j]) for j in range(masses, size)])
    return [[g.mul(g.mul(own[i], own[j]), matrix[i][j]) for j in range(size)] for i in range(size)]


def _unit(graph: Graph, entries: Sequence[Node]) -> Node:
    length = graph.sum([graph.power(size_of(graph, entry), 2) for entry in entries])
    return graph.one if length == graph.zero else graph.inverse(graph.function("sqrt", length))


def _find_usual(
    graph: Graph,
    given: Sequence[Sequence[Node]],
    matrix: Sequence[Sequence[Node]],
    columns: Sequence[Sequence[Fraction]],
    masses: int,
    points: Sequence[dict[Node, float]],
) -> Fraction | None:
    """The power of ten below the largest value at trial points; None where the masses are not positive at one of them."""
    size, nodes = len(matrix), [n for rows in (given, matrix) for row in rows for n in row]
    best, sides = 0.0, [[float(b) for b in column] for column in columns]
    for point in points:
        try:
            values = [float(x) for x in evaluate(graph, nodes, point)]
            rows = [values[k * size : (k + 1) * size] for k in range(2 * size)]
            if -1 in pivot_signs([row[:masses] for row in rows[:masses]]):
                return None
            found = [x for side in sides for x in solve_double(rows[size:], side)]
            best = max(best, 1.0 / math.hypot(*found))
        except (ArithmeticError, ValueError, Singular):
            continue
    return _power_below(min(best, 1.0)) if best > 0.0 else None
