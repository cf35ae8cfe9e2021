"""The pieces of a natural mechanical system that structure-preserving methods work with, as functions of (t, q, q'; p).

L = q' M(q) q' / 2 + U(q) with constraints A(q) q' = 0: ``mass`` is M, ``slope`` is dL/dq, ``rows`` is A, ``total``
is T + V.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.rotations.turning import regular_energy
from nhc.mechanics.system import System
from nhc.program.ir import Argument, Function
from nhc.program.lowering.lower import lower_function
from nhc.program.plan import FunctionPlan, Target
from nhc.program.planning.base import T_ARGUMENT
from nhc.program.planning.planner import Planner
from nhc.records import record


@record
class Structure:
    """The functions, and whether M is constant; ``lacking`` says why a system has no such structure."""

    functions: tuple[Function, ...] = ()
    constant_mass: bool = False
    lacking: str = ""


def structure_of(planner: Planner) -> Structure:
    """The functions of a natural system, or why it is none."""
    system, g = planner.system, planner.graph
    kinetic = regular_energy(system)
    momenta = gradient(g, kinetic, system.v)
    mass = [gradient(g, p, system.v) for p in momenta]
    flat = [entry for row in mass for entry in row]
    lacking = find_lacking(system, momenta, flat)
    if lacking:
        return Structure(lacking=lacking)
    slope = gradient(g, g.add(kinetic, system.U), system.q)
    rows = [a for form in system.constraints for a in form.coefficients]
    functions = (
        _function(planner, "mass", "mass matrix, row by row", flat),
        _function(planner, "slope", "dL/dq", slope),
        _function(planner, "rows", "coefficients of the constraints, row by row", rows),
        _function(planner, "total", "T + V", [g.sub(kinetic, system.U)]),
    )
    moving = g.mask(system.q)
    return Structure(functions, not any(g.depends(entry, moving) for entry in flat))


def find_lacking(system: System, momenta: Sequence[Node], mass: Sequence[Node]) -> str:
    """Why a system is not natural; empty where it is."""
    g = system.graph
    velocities, time = g.mask(system.v), g.mask([system.t])
    still = {v: g.zero for v in system.v}
    rest = substitute(g, [system.T, *momenta], still, named=False)
    if any(g.depends(entry, velocities) for entry in mass) or not all(are_zero(g, rest)):
        return "T is not a quadratic form of the velocities"
    if any(q != g.zero for q in system.Q):
        return "it has forces that are not from a potential"
    if any(form.constant != g.zero for form in system.constraints):
        return "a constraint is not homogeneous in the velocities"
    forms = [a for form in system.constraints for a in form.coefficients]
    if any(g.depends(node, time) for node in (system.T, system.U, *forms)):
        return "it depends on the time"
    return ""


def _function(planner: Planner, name: str, about: str, nodes: Sequence[Node]) -> Function:
    system = planner.system
    n = system.n
    inputs = (T_ARGUMENT, Argument("q", n), Argument("qdot", n), planner.p)
    targets = tuple(Target(k, node) for k, node in enumerate(nodes))
    output = Argument("out", len(nodes))
    return lower_function(
        planner.graph, FunctionPlan(name, about, "", inputs, output, planner.motion_loads, targets), system.p
    )
