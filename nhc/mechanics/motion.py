"""The motion that a formulation's equations hold along."""

from __future__ import annotations

from nhc.algebra.graph import Node
from nhc.records import record


@record
class Motion:
    """The vector field X: q' = ``velocities``(q, w, t), w' = ``rates``, t' = 1; ``vectors`` are dq/dw_mu."""

    w: tuple[Node, ...]
    rates: tuple[Node, ...]
    velocities: tuple[Node, ...]
    vectors: tuple[tuple[Node, ...], ...]
