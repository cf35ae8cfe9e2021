"""Are the constraints independent as the spec gives them: with its parameters' values, where its equations of positions hold?

Rows may be independent at arbitrary states and for arbitrary parameters, and yet repeat one another on every motion that the
spec describes: rows that differ in parameters of one value, or a mechanism with a rod too many.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from nhc.algebra.bounds.common_zero import find_common_zero
from nhc.algebra.dense import RowSpace
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.language import Spec
from nhc.mechanics.regular.trials import ordinary_points, trial_points, velocity_units
from nhc.mechanics.system import Form, System

_STATES = 4
_OF_NO_SCENE = 2  # of the ordinary points, the last
_DRAWN = 8  # of the trial points are random ones, the last


def given_states(system: System) -> list[dict[Node, float]]:
    """Random states with the parameters' values in the spec, at positions that the holonomic constraints allow.

    Near the scenes' starts where there are scenes: a mechanism may have other positions, in which it does not move.
    """
    equations = tuple(form.equation for form in system.constraints if form.equation is not None)
    known: dict[tuple[Node, ...], tuple[Spec, list[dict[Node, float]]]] = system.graph.memory.setdefault("given", {})
    key = (*equations, *system.q, *system.v)
    if key not in known or known[key][0] is not system.spec:
        known[key] = system.spec, _find_states(system, equations)
    return [dict(state) for state in known[key][1]]


def _find_states(system: System, equations: Sequence[Node]) -> list[dict[Node, float]]:
    near = ordinary_points(system)[1:-_OF_NO_SCENE:2]
    found: list[dict[Node, float]] = []
    for point in near or trial_points(system)[-_DRAWN:]:
        place = find_common_zero(system.graph, equations, system.q, [point]) if equations else point
        if place is not None:
            found.append(place)
        if len(found) == _STATES:
            break
    return found


def find_dependent_row(system: System, place: Mapping[Node, float]) -> Form | None:
    """The first constraint whose row vanishes, or depends on those before it, at a state; None also where there is no row.

    Holonomic ones come first: what repeats them is what can be left out.
    """
    space, units = RowSpace(system.n), velocity_units(system)
    for form in sorted(system.constraints, key=lambda form: form.equation is None):
        try:
            row = [float(x) for x in evaluate(system.graph, form.coefficients, dict(place))]
        except (ArithmeticError, ValueError, KeyError):
            return None
        if not all(map(math.isfinite, row)):
            return None
        if space.add([a * u for a, u in zip(row, units, strict=True)], 0.0) is not None:
            return form
    return None


def find_dependent_as_given(system: System) -> tuple[Form | None, bool]:
    """The constraint that depends on those before it at all states that :func:`given_states` draws; None where there is none.

    With it, whether the equations under ``holonomic:`` matter: elsewhere, with the same parameters, the rows are independent.
    """
    form = _dependent_at_all(system, given_states(system))
    if form is None or all(other.equation is None for other in system.constraints):
        return form, False
    return form, _dependent_at_all(system, trial_points(system)[-_DRAWN:]) is None


def _dependent_at_all(system: System, places: Sequence[Mapping[Node, float]]) -> Form | None:
    found = [find_dependent_row(system, place) for place in places]
    return found[0] if found and None not in found else None
