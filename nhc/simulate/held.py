"""The job of a scene in which dry friction holds something."""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import rank
from nhc.mechanics.choosing.choose import Formulation, choose
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.system import System
from nhc.program.runs.friction import Friction, hold, let_idle, tell
from nhc.program.runs.sharing import hold_together
from nhc.simulate.prepare import Job, Recipe, prepare


def hold_by(loose: Job, recipe: Recipe, frictions: tuple[Friction, ...]) -> Job:
    """The job ``loose``, of this recipe, in which nothing is held, with these frictions holding.

    Raises:
        nhc.algebra.dense.Singular: the constraints hold them by themselves, or it is not known when they break loose.
        nhc.mechanics.choosing.refusal.NotApplicable: no formulation applies.
        nhc.diagnostics.SpecError: there are no equations.
    """
    system, event = loose.system, recipe.event
    held = hold_together(system, frictions)
    for friction in (*held.leading, *(friction for friction in held.frictions if friction not in held.leading)):
        if event is not None:
            edges = tuple(tell(system, friction, edge) for edge in event.edges)
            event = replace(event, value=tell(system, friction, event.value), edges=edges)
        system = hold(system, friction, follows=friction not in held.leading)
    if not held.leading or rank(system.graph, [form.coefficients for form in system.constraints]) < system.l:
        raise Singular
    formulation = _choose(system)
    equations = equations_of(system, formulation)
    without = let_idle(equations)
    if without is not None:
        equations = equations_of(without, formulation)
    return prepare(replace(recipe, equations=equations, event=event, held=held), formulation, loose.start)


def _choose(system: System) -> Formulation:
    """The formulation that nhc chooses; quasi-velocities of the spec that are held are no choice any more."""
    try:
        return choose(system)
    except NotApplicable:
        return choose(replace(system, quasi=()))
