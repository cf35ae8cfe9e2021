"""Whether the rates that a program computes solve the equations that it was made from: an exact test of the way that was taken."""

from __future__ import annotations

from nhc.algebra.exact.modular import are_zero
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation, applicable
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.planning.planner import Planner


def check_emitted(source: Source) -> dict[str, bool | None]:
    """By formulation that applies to a spec, whether the emitted rates solve its equations; None where a run solves them.

    Raises:
        nhc.diagnostics.SpecError: the spec has errors.
    """
    system = resolve(decode(source))
    return {f.name: solve_equations(equations_of(system, f), f) for f in applicable(system)}


def solve_equations(equations: Equations, formulation: Formulation) -> bool | None:
    """Whether mass @ rates = force, identically, for the rates as they are planned: from the leaves of a tree, by way of other
    velocities, on other axes.  None where the program solves the equations by numbers, in its own run.

    Raises:
        nhc.algebra.exact.field.Unlucky: no point was found where they have values.
    """
    planner = Planner(equations, formulation)
    if planner.solves or not equations.definite:
        return None
    g, values = equations.system.graph, [planner.solved[rate] for rate in equations.motion.rates]
    left = [g.sub(g.dot(row, values), force) for row, force in zip(equations.mass, equations.force, strict=True)]
    return all(are_zero(g, left))
