"""How large a determinant usually is against the size that the entries of its rows allow."""

from __future__ import annotations

import math

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.mechanics.regularity import trial_points
from nhc.mechanics.system import System

_NEAR = 1e-3


def usual_digits(system: System, value: Node, scale: Node) -> int:
    """By how many powers of ten a determinant stays below its ``scale`` wherever it is looked at; 0 where it comes near it.

    Rows that hold lengths and angles have sizes that hang on the unit of length: then the largest ratio over the trial points, with
    the parameters' values in the spec, stands for the one in units in which lengths are near 1.
    """
    if scale in (system.graph.zero, system.graph.one):
        return 0
    known: dict[tuple[Node, Node], int] = system.graph.memory.setdefault("usual digits", {})
    if (value, scale) not in known:
        ratios = []
        for point in trial_points(system):
            try:
                found, size = (float(x) for x in evaluate(system.graph, [value, scale], point))
            except (ArithmeticError, ValueError, KeyError):
                continue
            if found and size and math.isfinite(found / size):
                ratios.append(abs(found / size))
        largest = max(ratios, default=1.0)
        known[value, scale] = 0 if largest >= _NEAR else -math.ceil(math.log10(largest))
    return known[value, scale]
