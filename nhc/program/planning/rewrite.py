"""The rules that look at a whole function, applied to its plan."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.differences import join_angles
from nhc.algebra.rewriting.factors import find_factors
from nhc.algebra.rewriting.numbers import fold_numbers
from nhc.algebra.rewriting.pieces import shorten_pieces
from nhc.algebra.rewriting.related import relate_angles
from nhc.algebra.rewriting.sharing import share_parts
from nhc.algebra.rewriting.values import share_values
from nhc.algebra.walks import count
from nhc.program.plan import FunctionPlan, map_nodes
from nhc.program.planning.base import PlannerBase


def rewrite(planner: PlannerBase, plan: FunctionPlan) -> FunctionPlan:
    """The plan after the rules that look at a whole function."""
    g, constants = planner.graph, planner.graph.mask(planner.parameters)

    def change(nodes: Sequence[Node]) -> list[Node]:
        made = relate_angles(g, join_angles(g, nodes))
        if plan.name == "rhs":  # only what is called all the time is worth the trouble
            made = shorten_pieces(g, made)
        made = _shorter(g, made, share_values(g, made))
        if plan.name == "rhs" and planner.equations.tree is None:  # a recursion along a tree has none
            made = find_factors(g, made)
        made = _shorter(g, made, share_parts(g, made, constants))
        return fold_numbers(g, made) if plan.name == "rhs" else made

    return map_nodes(plan, change)


def _shorter(graph: Graph, before: list[Node], after: list[Node]) -> list[Node]:
    """What a rule has made, unless it has made it longer: one node for equal ones may lose what others had in common."""
    return after if count(graph, after) <= count(graph, before) else before
