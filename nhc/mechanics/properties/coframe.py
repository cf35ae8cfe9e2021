"""What is to be known of the quasi-velocities that a spec gives: where they are singular, and how many digits they leave."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nhc.algebra.bounds.common_zero import find_common_zero
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.algebra.solving.blocks import find_eliminated
from nhc.algebra.solving.determinants import in_determinants
from nhc.diagnostics import Bag
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.choosing.independence import independence
from nhc.mechanics.choosing.orders import find_weak_factors
from nhc.mechanics.properties.named import entry_text
from nhc.mechanics.properties.singular import find_lost_factors, never_changes
from nhc.mechanics.properties.zeros import never_vanishes, where_zero
from nhc.mechanics.regular.regularity import Choice
from nhc.mechanics.regular.trials import ordinary_points, trial_points
from nhc.mechanics.system import Form, System

_ROUNDING = 1e-12
_CLEAR = 1e-5
"""Of a form's length, as far as the constraints and the other forms leave it; the mass matrix has its square."""


def _is_zero_as_given(system: System, node: Node) -> bool:
    """Whether a node that is the same at every state vanishes for the parameters' values in the spec."""
    try:
        value = float(evaluate(system.graph, [node], trial_points(system)[-1])[0])
    except (ArithmeticError, ValueError):
        return False
    return abs(value) < _ROUNDING


def _meets_equations(system: System, guard: Node) -> bool:
    """Whether a zero of it is found among the positions that the equations of `holonomic:` allow: not of a rod's own length."""
    equations = [form.equation for form in system.constraints if form.equation is not None]
    symbols = (*system.q, system.t)
    found = find_common_zero(system.graph, [guard, *equations], symbols, trial_points(system)) if equations else {}
    return found is not None


def warn_of_quasi_velocities(system: System, formulation: Formulation, bag: Bag) -> None:
    """Quasi-velocities that lose rank somewhere (W0408), or digits everywhere (W0425)."""
    if formulation.frame is None or not system.quasi:
        return
    _warn_of_lost_digits(system, formulation.frame.forms[system.l :], bag)
    lost = find_lost_factors(system)
    for guard, _ in in_determinants(system.graph, formulation.frame.guards, find_eliminated(system.graph)):
        if never_vanishes(system, guard) or (never_changes(system, guard) and not _is_zero_as_given(system, guard)):
            continue
        if not _meets_equations(system, guard):
            continue
        where = where_zero(system, guard, "`", entry_text(system, guard))
        if lost and find_weak_factors(system, [guard]) <= lost:
            _warn_of_dependent_rows(system, where_zero(system, system.graph.product(sorted(lost)), "`"), bag)
            continue
        own = len(system.quasi) > 3 * len(system.rotations)
        form = None if own else _find_row(system, guard)
        if form is not None:
            bag.warning(
                "W0408",
                f"the velocities that nhc keeps are singular where {where}",
                system.spec.constraint_spans.get(form.name, system.spec.kinetic.span),
                notes=(f"`{form.name}` is solved there for a velocity that it does not hold",),
                help=("keep away from it, or declare a `range` of the coordinates that leaves it out",),
            )
            continue
        other = ", take the other `frame` of the rotation" if system.rotations else ""
        bag.warning(
            "W0408",
            f"the quasi-velocities are singular where {where}",
            system.spec.key_span("quasi_velocities" if own else "rotation"),
            help=(f"choose forms that stay independent there{other}, or keep away from it",),
        )


def _find_row(system: System, guard: Node) -> Form | None:
    """The constraint with a coefficient that vanishes with a determinant that does not hold how a rotation has turned; None where
    there is none.
    """
    g, turned = system.graph, [system.q[k] for rotation in system.rotations for k in rotation.places]
    if g.depends(guard, g.mask(turned)):
        return None
    factors = find_weak_factors(system, [guard])
    rows = (
        form for form in system.constraints if factors & find_weak_factors(system, [x for x in form.coefficients if x])
    )
    return next(rows, None)


def _warn_of_dependent_rows(system: System, where: str, bag: Bag) -> None:
    """Rows that say less somewhere, as two components in space of what lies in a tangent plane: nothing completes them there."""
    bag.warning(
        "W0408",
        f"the constraints depend on each other where {where}, and no quasi-velocities are regular there",
        system.spec.key_span("constraints"),
        help=("write the same condition by other components, which stay independent there, or keep away from it",),
    )


def warn_of_dependent(system: System, choice: Choice, bag: Bag) -> None:
    """Dependent velocities that somebody asked for, and that are singular somewhere (W0408)."""
    if choice.determinant is None or choice.regular or never_vanishes(system, choice.determinant):
        return
    own, names = bool(system.dependent), ", ".join(f"{system.q_names[i]}'" for i in choice.dependent)
    advice = "leave `dependent:` out" if own else "name others under `dependent:`, leave `formulation:` out"
    bag.warning(
        "W0408",
        f"the dependent velocities {names} are singular where {where_zero(system, choice.determinant, '`')}",
        system.spec.key_span("dependent" if own else "formulation"),
        notes=() if own else ("nhc chose them; no choice is known to be regular everywhere",),
        help=(f"{advice}, or use quasi-velocities that stay regular",),
    )


def _warn_of_lost_digits(system: System, forms: Sequence[Form], bag: Bag) -> None:
    """Forms that are hardly independent of each other on what the constraints allow, at ordinary states."""
    found = [independence(system, forms, [point]) for point in ordinary_points(system)]
    least = min(
        (value for value in found if value > _ROUNDING), default=1.0
    )  # of what is singular something else is said
    if least >= _CLEAR:
        return
    own = len(system.quasi) > 3 * len(system.rotations)
    first = (
        "leave `quasi_velocities` out, and nhc chooses"
        if own
        else "give `quasi_velocities` that the constraints leave free"
    )
    lost = min(16, math.ceil(-2 * math.log10(least)))
    bag.warning(
        "W0425",
        f"the quasi-velocities are hardly independent under the constraints: about {lost} of 16 digits are lost",
        system.spec.key_span("quasi_velocities" if own else "rotation"),
        help=(f"{first}; or take velocities of other bodies of the chain",),
    )
