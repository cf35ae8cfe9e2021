"""Forms that complete constraints: the rows of their signed maximal minors.

Constraint rows with a pivot that cannot vanish are set aside, each with its column.  What remains, k rows, is
completed on k + 1 columns by the row of its signed maximal minors: its determinant with the rows is the sum of the
squares of all the minors (Cauchy-Binet), which vanishes only where the rows lose rank.  For a knife edge this is the
velocity along the edge.  Rows that share no column are completed each by themselves.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, islice

from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.exact.modular import rank
from nhc.algebra.graph import Node
from nhc.algebra.rewriting.angles import normalise_angles as normalise
from nhc.algebra.solving.blocks import determinant_of
from nhc.mechanics.choosing.pivots import set_pivots_aside
from nhc.mechanics.choosing.stepwise import Step
from nhc.mechanics.frame import coordinate_form
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.row_factors import without_common
from nhc.mechanics.system import Form, System

_MOST_ROWS = 3
_MOST_SUBSETS = 150  # of columns that are tried for a form of minors that cannot vanish together


def adapted_forms(
    system: System, aside: tuple[list[int], set[int]] | None = None, *, to_the_left: bool = False
) -> tuple[Form, ...] | None:
    """n - l free forms, or None where no small completion is found; ``aside`` are the pivots, if not the usual ones.

    A row of minors begins without a minus sign, or with ``to_the_left`` makes the determinant positive: beside the velocity along
    a body's axis it is then the one to the left, otherwise that to the right.
    """
    rows, columns = aside or set_pivots_aside(system)
    free_columns = [j for j in range(system.n) if j not in columns]
    made: list[Form] = []
    used: set[int] = set()
    for group in _apart(system, rows, free_columns):
        if len(group) > _MOST_ROWS:
            return None
        seen = [
            j for j in free_columns if any(system.constraints[r].coefficients[j] != system.graph.zero for r in group)
        ]
        name = unused_name(system, [form.name for form in made])
        best = _minor_form(system, group, seen, name, to_the_left=to_the_left)
        if best is None or best[2]:
            return None
        made.append(best[0])
        used.update(best[1])
    return (*made, *(coordinate_form(system, j) for j in free_columns if j not in used))


def stepwise_forms(system: System, steps: Sequence[Step] | None) -> tuple[Form, ...] | None:
    """n - l free forms where each constraint in turn is solved for a velocity of its own, or completed by the row of its minors on
    two of them; None where there are no such ``steps``, as one has no velocity of its own.
    """
    if steps is None:
        return None
    made: list[Form] = []
    used: set[int] = set()
    for step in steps:
        if step.pivot is not None or len(step.columns) == 1:
            used.add(step.columns[0] if step.pivot is None else step.pivot)
            continue
        best = _minor_form(system, [step.row], step.columns, unused_name(system, [form.name for form in made]))
        if best is None:
            return None
        made.append(best[0])
        used.update(best[1])
    return (*made, *(coordinate_form(system, j) for j in range(system.n) if j not in used))


def _apart(system: System, rows: Sequence[int], columns: Sequence[int]) -> list[list[int]]:
    """The rows in groups that share no column, each in its order: skates that roll by themselves."""
    g = system.graph
    groups: list[tuple[set[int], list[int]]] = []
    for row in rows:
        seen = {j for j in columns if system.constraints[row].coefficients[j] != g.zero}
        joined = [group for group in groups if group[0] & seen]
        groups = [group for group in groups if not group[0] & seen]
        merged = seen.union(*(group[0] for group in joined))
        groups.append((merged, sorted([*(r for group in joined for r in group[1]), row])))
    return sorted((members for _, members in groups), key=lambda members: members[0])


def _minor_form(
    system: System, rows: Sequence[int], columns: Sequence[int], name: str, *, to_the_left: bool = False
) -> tuple[Form, tuple[int, ...], bool] | None:
    """The row of signed minors on the best k + 1 columns, under that name; the rows must not reach outside them."""
    g, size = system.graph, len(rows)
    known, constants = intervals(system), g.mask(system.p)
    own = {r: without_common(g, system.constraints[r].coefficients, constants) for r in rows}
    found: list[tuple[bool, int, tuple[int, ...], list[Node], Node]] = []
    for subset in islice(combinations(columns, size + 1), _MOST_SUBSETS):
        block = [[own[r][j] for j in subset] for r in rows]
        if rank(g, block) < size:
            continue
        minors = []
        for k in range(size + 1):
            minor = determinant_of(g, [[*row[:k], *row[k + 1 :]] for row in block])
            minors.append(normalise(g, g.neg(minor) if k % 2 else minor, 120))
        gram = normalise(g, g.sum([g.power(m, 2) for m in minors]), 200)
        found.append((not cannot_vanish(g, gram, known), len(found), subset, minors, gram))
        if not found[-1][0]:
            break
    if not found:
        return None
    singular, _, subset, minors, _ = min(found)
    coefficients = [g.zero] * system.n
    sign = (-1) ** size if to_the_left else _leading_sign(system, minors)
    for j, minor in zip(subset, minors, strict=True):
        coefficients[j] = g.neg(minor) if sign < 0 else minor
    outside = [j for j in columns if j not in subset]
    reaches = any(system.constraints[r].coefficients[j] != g.zero for r in rows for j in outside)
    return Form(name, tuple(coefficients), g.zero), subset, singular and reaches


def _leading_sign(system: System, minors: Sequence[Node]) -> int:
    """So that the first nonzero minor does not start with a minus sign."""
    g = system.graph
    first = next((m for m in minors if m != g.zero), g.one)
    coefficient, _ = g.split_coefficient(first)
    return -1 if coefficient < 0 else 1


def unused_name(system: System, others: Sequence[str]) -> str:
    """v, or v with a number, so that it is no name of the spec and none of the others."""
    spec = system.spec
    taken = {
        *others,
        *(c.name for c in spec.coordinates),
        *(p.name for p in spec.parameters),
        *(d.name for d in spec.definitions),
        *(d.name for d in spec.quasi_velocities),
        *(name for rotation in spec.rotations for name in rotation.velocities),
        *(o.name for o in spec.outputs),
    }
    name, k = "v", 1
    while name in taken:
        k += 1
        name = f"v{k}"
    return name
