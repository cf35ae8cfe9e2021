"""Dry friction that sticks: where sign(v) in the forces holds v at zero, the run goes on with v = 0 as one more constraint.

A force c sign(v) that acts along the constraint, Q_i = -c sign(v) dv/dq'_i, is at rest any Q_i = -s c dv/dq'_i with -1 <= s <= 1
(Coulomb's law; Filippov 1988, sec. 4).  That is the reaction of v = 0, lambda dv/dq'_i with lambda = -s c, as long as that is no
larger.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.system import Form
from nhc.program.planning.planner import Planner
from nhc.program.runs.needed import reactions_of
from nhc.records import record

_MARGIN = Fraction(
    1, 10**9
)  # by which lambda^2 is more than c^2 where it breaks loose, so that it does not stick again at once


@record
class Friction:
    """``function`` is sign(v), ``form`` the constraint v = 0, ``size`` c > 0; ``value`` stands for s in what is computed of it."""

    function: Node
    form: Form
    size: Node
    value: Node


def list_releases(planner: Planner, frictions: Sequence[Friction]) -> list[Node]:
    """Values that are positive while friction holds; ``frictions`` are the last constraints of the planner's system."""
    g, (reactions, sizes) = planner.graph, _reactions(planner, frictions)
    most = g.number(1 + _MARGIN)
    return [
        g.sub(g.mul(most, g.power(size, 2)), g.power(reaction, 2))
        for reaction, size in zip(reactions, sizes, strict=True)
    ]


def put_values(planner: Planner, frictions: Sequence[Friction], nodes: Sequence[Node]) -> list[Node]:
    """Nodes on the motion with s by the reactions in place of each ``value``."""
    if not frictions:
        return list(nodes)
    g, (reactions, sizes) = planner.graph, _reactions(planner, frictions)
    found = {
        friction.value: g.neg(g.div(reaction, size))
        for friction, reaction, size in zip(frictions, reactions, sizes, strict=True)
    }
    return substitute(g, nodes, found)


def _reactions(planner: Planner, frictions: Sequence[Friction]) -> tuple[list[Node], list[Node]]:
    if not frictions:
        return [], []
    return reactions_of(planner)[-len(frictions) :], planner.on_motion([friction.size for friction in frictions])
