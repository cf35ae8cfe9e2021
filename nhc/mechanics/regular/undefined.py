"""Expressions of the spec without a real, finite value, or slope, at a state."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.evaluate import evaluate, evaluate_into
from nhc.algebra.graph import Graph, Node
from nhc.algebra.show import to_text
from nhc.algebra.walks import reachable
from nhc.diagnostics import Span
from nhc.mechanics.system import System

_LONGEST = 60  # characters that a message shows of an expression


def find_undefined(system: System, place: dict[Node, float], others: Sequence[Node] = ()) -> tuple[str, Node | None]:
    """The first part of T, the potential, the forces and the constraints without a real, finite value, in words and as it is; or of
    ``others``, if there are any.

    ``place`` gives every symbol of the system its value.  The words are empty, and the part is None, where all have a value.
    """
    graph = system.graph
    roots = list(others) or [system.T, system.U, *system.Q]
    for form in () if others else system.constraints:
        roots += [*form.coefficients, form.constant]
    wrong, large = _first_undefined(graph, roots, place)
    if wrong is None:
        return "", None
    lack = "is larger than a double can be (1.8e308)" if large else "has no real, finite value"
    return f"`{to_text(graph, wrong, _LONGEST)}` {lack}", wrong


def _first_undefined(graph: Graph, roots: Sequence[Node], place: Mapping[Node, float]) -> tuple[Node | None, bool]:
    """The first node on the way to the roots without a real, finite value at a place; None where all have one.  And whether it is
    too large.
    """
    known, order, large = dict(place), reachable(graph, roots), False
    try:
        evaluate_into(known, graph, order)
    except OverflowError:
        large = True
    except (ArithmeticError, ValueError):  # at the first node that is not known
        pass
    wrong = next((node for node in order if not math.isfinite(known.get(node, math.nan))), None)
    return wrong, large or (wrong is not None and math.isinf(known.get(wrong, 0.0)))


def are_defined(system: System, nodes: Sequence[Node], place: Mapping[Node, float]) -> list[bool]:
    """Which functions of (q, t) have a finite value and finite slopes at a place: log(x) has none where x is not positive.

    ``place`` gives every symbol in them its value.
    """
    g, moving = system.graph, (*system.q, system.t)
    found = []
    for node in nodes:
        try:
            values = [float(x) for x in evaluate(g, [node, *gradient(g, node, moving)], place)]
        except (ArithmeticError, ValueError):
            values = [math.nan]
        found.append(all(map(math.isfinite, values)))
    return found


def find_pole(system: System, values: Mapping[Node, float]) -> tuple[str, Span, Node | None]:
    """What of T, the potential and the forces has no finite value or slope at a state, in words, with its place in the spec and
    the part of it, or of its slope, that has none.

    The words are empty, and the part is None, where all have.
    """
    g, spec, moving = system.graph, system.spec, (*system.q, *system.v)
    forces = {force.name: force.span for force in spec.forces}
    potential = spec.potential.span if spec.potential is not None else spec.kinetic.span
    parts = [("`T`", system.T, moving, spec.kinetic.span)]
    parts += [(f"`{spec.potential_kind or 'V'}`", system.U, system.q, potential)]
    for name, node in zip(system.q_names, system.Q, strict=True):
        parts += [(f"the force on `{name}`", node, (), forces.get(name, spec.key_span("forces")))]
    for name, node, symbols, span in parts:
        wanted = [node, *gradient(g, node, symbols)]
        try:
            found = [float(x) for x in evaluate(g, wanted, values)]
        except (ArithmeticError, ValueError):
            found = [math.nan]
        if not all(map(math.isfinite, found)):
            return f"{name} has no finite value, or slope,", span, _first_undefined(g, wanted, values)[0]
    return "", spec.kinetic.span, None
