"""Sines and cosines of arcs: what is algebraic in x takes no call, where an arc of x stands alone or in a sum.

cos(atan x) is 1/sqrt(1 + x^2), and sin(y + atan x) is (sin y + x cos y)/sqrt(1 + x^2): an axle that a leaning board steers by
atan(k sin(lean)), a connecting rod that leans by asin(k sin(crank)).  An arc stays where its tangent, or the square of that, may be
infinite at ordinary values: atan(y/x) is a quarter turn at x = 0, atan(v/eps) a step at eps = 0, and exp(x)^2 is no double from
x = 355 on.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import ADD, MUL, NEG, NUM, PI, POW, SYM, Graph, Node
from nhc.algebra.parts import list_terms
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.angles import Pair, add_angles
from nhc.algebra.walks import reachable

_ARCS = ("asin", "acos", "atan")
_TAME = frozenset(
    (NUM, SYM, PI, ADD, MUL, NEG, "sin", "cos", "tanh", "sqrt", "abs", "sign", "min", "max", "atan2", *_ARCS)
)
"""Operations whose results are no larger than polynomials of what they take."""


def open_arcs(graph: Graph, roots: Sequence[Node]) -> list[Node]:
    """Equal roots without the sine or cosine of an arc."""
    g, new = graph, dict[Node, Node]()
    for node in reachable(g, roots):
        if g.op[node] not in ("sin", "cos"):
            continue
        pairs, rest = list[Pair](), list[Node]()
        for term in list_terms(g, g.a[node]):
            pair = _pair_of(g, term, new)
            if pair is None:
                rest.append(term)
            else:
                pairs.append(pair)
        if pairs:
            (angle,) = substitute(g, [g.sum(rest)], new)
            own = g.function("sin", angle), g.function("cos", angle)
            new[node] = add_angles(g, (own, *pairs))[g.op[node] == "cos"]
    return substitute(g, roots, new) if new else list(roots)


def _pair_of(graph: Graph, term: Node, new: dict[Node, Node]) -> Pair | None:
    """Sine and cosine of an arc, or of minus one; what is replaced already stands in them as that."""
    g = graph
    arc = g.a[term] if g.op[term] == NEG else term
    if g.op[arc] not in _ARCS or (g.op[arc] == "atan" and not _is_finite(g, g.a[arc])):
        return None
    (x,) = substitute(g, [g.a[arc]], new)
    square = g.power(x, 2)
    if g.op[arc] == "atan":
        cosine = g.inverse(g.function("sqrt", g.add(g.one, square)))
        sine = g.mul(x, cosine)
    else:
        other = g.function("sqrt", g.sub(g.one, square))
        sine, cosine = (x, other) if g.op[arc] == "asin" else (other, x)
    return (sine if arc == term else g.neg(sine)), cosine


def _is_finite(graph: Graph, x: Node) -> bool:
    """Whether it grows like a polynomial of symbols, over no other denominators than cosines, which are no number's zero."""
    op, a, b = graph.op, graph.a, graph.b
    return all(
        op[node] in _TAME or (op[node] == POW and (b[node] > 0 or op[a[node]] == "cos"))
        for node in reachable(graph, [x])
    )
