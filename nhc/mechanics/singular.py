"""Where the constraints themselves lose rank: there the equations of motion are undefined in every formulation."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations

from nhc.algebra.graph import Node
from nhc.algebra.interval import cannot_vanish
from nhc.algebra.linear import determinant_of
from nhc.algebra.polynomial import normalise
from nhc.mechanics.adapt import _set_pivots_aside
from nhc.mechanics.regularity import intervals
from nhc.mechanics.system import System

_MOST_ROWS = 3
_MOST_MINORS = 60


@dataclass(frozen=True)
class RankLoss:
    """``regular``: shown to have full rank everywhere (None: too large to decide); else only where all of ``minors`` vanish."""

    regular: bool | None
    minors: tuple[Node, ...]


def find_rank_loss(system: System) -> RankLoss:
    """Rows with a pivot that cannot vanish are set aside; the others are judged by the squares of their maximal minors."""
    g, known = system.graph, intervals(system)
    rows, columns = _set_pivots_aside(system)
    if not rows:
        return RankLoss(True, ())
    free = [j for j in range(system.n) if j not in columns]
    free = [j for j in free if any(system.constraints[r].coefficients[j] != g.zero for r in rows)]
    if len(rows) > _MOST_ROWS or math.comb(len(free), len(rows)) > _MOST_MINORS:
        return RankLoss(None, ())
    minors = set[Node]()
    for subset in combinations(free, len(rows)):
        block = [[system.constraints[r].coefficients[j] for j in subset] for r in rows]
        minor = normalise(g, determinant_of(g, block), 120)
        if minor != g.zero:
            minors.add(g.split_coefficient(minor)[1])
    kept = sorted(minors)
    if any(cannot_vanish(g, minor, known) for minor in kept):
        return RankLoss(True, ())
    gram = normalise(g, g.sum([g.power(minor, 2) for minor in kept]), 200)
    if cannot_vanish(g, gram, known):
        return RankLoss(True, ())
    return RankLoss(False, tuple(kept))
