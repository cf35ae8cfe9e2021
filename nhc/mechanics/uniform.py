"""What rolls on a floor that moves uniformly: its equations are those on a floor at rest (Galilei).

The constraints then have parameters beside the velocities, x' - v_0 + ..., and so have the momenta in all terms of the equations;
in their sums these cancel.  Whether they do is tested exactly, for every entry: on a turntable they do not.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.frame import Frame, form_value, make_frame
from nhc.mechanics.system import Form, System

_FEW = 8
"""Constraints up to which this is asked."""


def uniform_parameters(system: System) -> list[Node]:
    """Those that the constraints have beside the velocities."""
    g = system.graph
    if not 0 < system.l <= _FEW or "uniform motion" in g.off:
        return []
    held = [form.constant for form in system.constraints if form.constant != g.zero]
    return [p for p in system.p if any(g.depends(x, g.deps[p]) for x in held)]


def drop_uniform(system: System, entries: Sequence[Node]) -> list[Node]:
    """The entries without such parameters, where these make no difference."""
    g, found = system.graph, list(entries)
    for p in uniform_parameters(system):
        held = [k for k, x in enumerate(found) if g.depends(x, g.deps[p])]
        try:
            without = substitute(g, [found[k] for k in held], {p: g.zero})
        except ZeroDivisionError:
            continue
        same = are_zero(g, [g.sub(found[k], x) for k, x in zip(held, without, strict=True)])
        for k, x, equal in zip(held, without, same, strict=True):
            found[k] = x if equal else found[k]
    return found


def at_rest(system: System, frame: Frame, entries: Sequence[Node]) -> tuple[System, Frame] | None:
    """The system and the frame with the floor at rest; None where there is none, or the equations' entries have its velocity."""
    g = system.graph
    idle = [p for p in uniform_parameters(system) if not any(g.depends(x, g.deps[p]) for x in entries)]
    still = {p: g.zero for p in idle}
    held = [*system.constraints, *frame.forms[system.l :]]
    own = [form for form in held if any(g.depends(form.constant, g.deps[p]) for p in idle)]
    apart = g.mask(idle)
    if not own or any(form.equation is not None or any(g.deps[a] & apart for a in form.coefficients) for form in own):
        return None

    def calm(form: Form) -> Form:
        value, constant = substitute(g, [form_value(system, form), form.constant], still)
        return Form(form.name, form.coefficients, constant, form.place, None, value) if form in own else form

    quiet = replace(system, constraints=tuple(map(calm, system.constraints)))
    if any(g.deps[form.constant] & apart for form in quiet.constraints):
        return None
    return quiet, make_frame(quiet, [calm(form) for form in frame.forms[system.l :]], frame.free, known=True)
