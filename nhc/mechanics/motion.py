"""The motion that a formulation's equations hold along."""

from __future__ import annotations

from dataclasses import dataclass

from nhc.algebra.graph import Node


@dataclass(frozen=True)
class Motion:
    """The vector field X: q' = ``velocities``(q, w, t), w' = ``rates``, t' = 1; ``vectors`` are dq/dw_mu."""

    w: tuple[Node, ...]
    rates: tuple[Node, ...]
    velocities: tuple[Node, ...]
    vectors: tuple[tuple[Node, ...], ...]
