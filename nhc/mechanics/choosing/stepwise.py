"""Constraints one after another, each with the velocities that it is the first to hold.

Along a chain of bodies the k-th constraint holds the velocities of the bodies before it and of its own.  Solved for its own, in
this order, the matrix of the dependent velocities is triangular: every velocity follows from those before it in a few operations,
and what is free is the root's and each body's own.  A choice over all columns at once, whose determinant may be larger, mixes both
ends of the chain, and every velocity is then a fraction of polynomials in all angles.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.regular.trials import sampled_rows
from nhc.mechanics.system import System
from nhc.records import record

_LONGEST = 60  # terms of an entry in canonical form


@record
class Step:
    """A constraint, the velocities that no constraint before it holds, and the one of them whose factor never vanishes, or None."""

    row: int
    columns: tuple[int, ...]
    pivot: int | None


def order_stepwise(system: System) -> tuple[Step, ...] | None:
    """The constraints in an order in which each brings velocities of its own, as few as may be; None where one brings none."""
    g = system.graph
    held = [{j for j, x in enumerate(form.coefficients) if x != g.zero} for form in system.constraints]
    left, seen, steps = list(range(system.l)), set[int](), list[Step]()
    samples = sampled_rows(system, system.constraints)
    while left:
        row = min(left, key=lambda r: (len(held[r] - seen), r))
        new = sorted(held[row] - seen)
        if not new:
            return None
        steps.append(Step(row, tuple(new), _find_pivot(system, row, new, samples)))
        seen |= held[row]
        left.remove(row)
    return tuple(steps)


def _find_pivot(
    system: System, row: int, columns: Sequence[int], samples: Sequence[Sequence[Sequence[float]]]
) -> int | None:
    """The column whose entry is never near zero; the last one of those that come as near."""
    g, known = system.graph, intervals(system)
    entries = system.constraints[row].coefficients
    able = [j for j in columns if cannot_vanish(g, normalise_angles(g, entries[j], _LONGEST), known)]
    return max(able, key=lambda j: (round(min((abs(m[row][j]) for m in samples), default=0.0), 9), j), default=None)
