"""Sines and cosines of angles that differ by a known part of a turn, as of three wheels that stand 120 degrees apart.

A quarter turn exchanges sine and cosine; thirds and sixths of half a turn are combinations of both with 1/2 and sqrt(3)/2.  What
is symmetric then cancels exactly: the sum of sin^2 over three such wheels is 3/2.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from math import ceil

from nhc.algebra.graph import PI, Graph, Node
from nhc.algebra.parts import list_terms
from nhc.algebra.show import to_text

_HALF = Fraction(1, 2)
_KNOWN = (1, 2, 3, 4, 6)
"""Denominators of the parts of half a turn whose sines are made of one square root."""

Phases = Mapping[str, set[Fraction]]
"""By the text of an angle without multiples of pi, what a spec adds to it, in half turns."""


def list_phases(graph: Graph, angles: Sequence[Node]) -> Phases:
    """Those of all the angles of sines and cosines."""
    found: dict[str, set[Fraction]] = {}
    for angle in angles:
        base, turns = split_turn(graph, angle)
        found.setdefault(to_text(graph, base), set()).add(turns)
    return found


def split_turn(graph: Graph, angle: Node) -> tuple[Node, Fraction]:
    """The angle without multiples of pi, and these in half turns."""
    terms = [(*graph.split_coefficient(term), term) for term in list_terms(graph, angle)]
    turns = sum((Fraction(k) for k, core, _ in terms if graph.op[core] == PI), Fraction(0))
    return (graph.sum(term for _, core, term in terms if graph.op[core] != PI) if turns else angle), turns


def known_pair(graph: Graph, base: Node, turns: Fraction, phases: Phases) -> tuple[Node, Node] | None:
    """Sine and cosine of base + turns pi from those of fewer angles; None where the angle is best left as it is.

    A phase beside no other one of its angle stays: it takes one call, where its parts may take two.  So do constants, for the
    constant lean of a joint is taken together with the turn before it.
    """
    g = graph
    others = phases.get(to_text(g, base), set()) - {turns}
    quarters, part = _split_quarters(turns)
    if base == g.zero or turns.denominator not in _KNOWN or (part and not others):
        return None
    if part and any((turns - x).denominator in (3, 4, 6) for x in others):
        pair = _turn(g, g.function("sin", base), g.function("cos", base), part)
    else:
        kept = g.add(base, g.mul(g.number(part), g.pi()))
        pair = g.function("sin", kept), g.function("cos", kept)
    for _ in range(quarters % 4):
        pair = pair[1], g.neg(pair[0])
    return pair


def _split_quarters(turns: Fraction) -> tuple[int, Fraction]:
    """Quarter turns, and what is left of the half turns: more than -1/4 and at most 1/4."""
    quarters = ceil(turns / _HALF - _HALF)
    return quarters, turns - quarters * _HALF


def _turn(graph: Graph, s: Node, c: Node, part: Fraction) -> tuple[Node, Node]:
    """Sine and cosine after a further sixth of half a turn, ahead or back, or a fourth ahead."""
    g = graph
    root = g.div(g.function("sqrt", g.number(2 if part.denominator == 4 else 3)), g.number(2))
    sine = root if part.denominator == 4 else g.number(_HALF if part > 0 else -_HALF)
    return g.add(g.mul(s, root), g.mul(c, sine)), g.sub(g.mul(c, root), g.mul(s, sine))
