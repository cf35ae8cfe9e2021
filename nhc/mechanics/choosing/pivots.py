"""Velocities that constraints are solved for as their factors never vanish, and lengths of the forms that complete the others."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.rewriting.angles import normalise_angles as normalise
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.rotations.turning import rows_in_base
from nhc.mechanics.system import Form, System


def set_pivots_aside(system: System, *, by_numbers: bool = False) -> tuple[list[int], set[int]]:
    """(rows that stay, columns of the pivots): pivots cannot vanish, and the rows that stay do not contain their
    columns; ``by_numbers``: nor do pivots hold a parameter, which may be small.
    """
    g, known = system.graph, intervals(system)
    small = g.mask(system.p) if by_numbers else 0
    matrix = rows_in_base(system, system.constraints)
    rows, columns = list(range(system.l)), set[int]()
    held = [sum(row[j] != g.zero for row in matrix) for j in range(system.n)]  # rows that stay with the column
    progress = True
    while progress:
        progress = False
        for row in rows:
            for j, entry in enumerate(matrix[row]):
                if entry == g.zero or j in columns or g.depends(entry, small):
                    continue
                if held[j] == 1 and cannot_vanish(g, normalise(g, entry, 60), known):
                    rows.remove(row)
                    columns.add(j)
                    held = [count - (x != g.zero) for count, x in zip(held, matrix[row], strict=True)]
                    progress = True
                    break
            if progress:
                break
    return rows, columns


def are_headings(system: System, forms: Sequence[Form], rows: Sequence[int]) -> bool:
    """Whether each of the forms that complete the ``rows`` completes one, and has the same length everywhere, as v along a knife
    edge has.
    """
    g = system.graph
    own = [form for form in forms if form.name not in system.q_names]
    lengths = (normalise(g, g.sum(g.power(a, 2) for a in form.coefficients), 60) for form in own)
    return len(own) == len(rows) and all(g.value(length) is not None for length in lengths)
