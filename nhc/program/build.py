"""Equations -> Program: the functions of a model, planned, rewritten and lowered."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.program.ir import Function
from nhc.program.lowering.lower import lower_function
from nhc.program.plan import FunctionPlan
from nhc.program.planning.base import SINGULAR_FRAME
from nhc.program.planning.planner import Planner
from nhc.program.planning.rewrite import rewrite

FUNCTIONS = (
    "rhs",
    "velocities",
    "accelerations",
    "state",
    "residuals",
    "positions",
    "reactions",
    "energy",
    "jacobian",
    "outputs",
)


def build_functions(planner: Planner, only: Sequence[str] = ()) -> tuple[Function, ...]:
    """The functions asked for, in their fixed order; all that this system has where none is named, or one that it does not have."""
    functions = []
    wanted = set[str]() if set(only) == set(FUNCTIONS) else set(only)
    if any(name in wanted and planner.calls_rhs(name) for name in ("accelerations", "reactions")):
        wanted.add("rhs")
    for name in FUNCTIONS:
        if wanted and name not in wanted:
            continue
        plan = getattr(planner, name)()
        if plan is not None:
            functions.append(build_function(planner, plan))
        elif name in wanted:
            return build_functions(planner)  # the emitter refuses it, and names those that there are
    return tuple(functions)


def build_function(planner: Planner, plan: FunctionPlan) -> Function:
    """A plan of the planner, rewritten and lowered, with what stands in for it where a pivot is small."""
    made = lower_function(planner.graph, rewrite(planner, plan), planner.parameters)
    return replace(made, otherwise=_lower_otherwise(planner, plan))


def _lower_otherwise(planner: Planner, plan: FunctionPlan) -> Function | None:
    """The function that stands in for a plan's where a pivot is small; None where nothing in it can be."""
    other = planner.exchanges
    if other is None or not any(guard.status == SINGULAR_FRAME for guard in plan.guards):
        return None
    made: FunctionPlan = getattr(other, plan.name)()
    # not rewritten: of two nodes with one value, one may need unknowns of a solve that the other stands before
    return lower_function(other.graph, made, other.parameters)
