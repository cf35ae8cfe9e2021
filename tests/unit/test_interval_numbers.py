"""Numbers that no double holds, as products of numbers that a spec may hold become, have bounds too."""

from __future__ import annotations

import math
import sys
from fractions import Fraction

import pytest

from nhc.algebra.bounds.interval import bounds
from nhc.algebra.graph import Graph

HUGE = Fraction(10) ** 900
LARGEST, LEAST = sys.float_info.max, math.ulp(0.0)


@pytest.mark.parametrize(
    ("number", "low", "high"),
    [
        (HUGE, LARGEST, math.inf),
        (-HUGE, -math.inf, -LARGEST),
        (1 / HUGE, 0.0, LEAST),
        (-1 / HUGE, -LEAST, 0.0),
        (Fraction(1, 2), 0.5, 0.5),
        (Fraction(0), 0.0, 0.0),
    ],
)
def test_a_number_lies_between_its_bounds(number: Fraction, low: float, high: float) -> None:
    graph = Graph()
    assert bounds(graph, graph.number(number), {}) == (low, high)
