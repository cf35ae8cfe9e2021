"""Where an expression of the spec has no real, finite value."""

from __future__ import annotations

import math
from contextlib import suppress

from nhc.algebra.calculus import reachable
from nhc.algebra.evaluate import evaluate_into
from nhc.algebra.graph import Node
from nhc.algebra.show import to_text
from nhc.mechanics.system import System

_LONGEST = 60  # characters that a message shows of an expression


def find_undefined(system: System, place: dict[Node, float]) -> str:
    """The first part of T, the potential, the forces and the constraints without a real, finite value; empty where all have one.

    ``place`` gives every symbol of the system its value.
    """
    graph = system.graph
    roots = [system.T, system.U, *system.Q]
    for form in system.constraints:
        roots += [*form.coefficients, form.constant]
    known, order = dict(place), reachable(graph, roots)
    with suppress(ArithmeticError, ValueError):  # at the first node that is not known
        evaluate_into(known, graph, order)
    wrong = next((node for node in order if not math.isfinite(known.get(node, math.nan))), None)
    return to_text(graph, wrong, _LONGEST) if wrong is not None else ""
