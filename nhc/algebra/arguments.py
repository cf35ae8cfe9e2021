"""Angles and exponents as polynomials, by which functions of equal arguments are known to be equal."""

from __future__ import annotations

from fractions import Fraction

from nhc.algebra.expand import Polynomial, TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import polynomial
from nhc.algebra.rebuilding import substitute

_LIMIT = 60
_WAVES = ("sin", "cos")
_MOST_TURNS = 8  # multiples of an angle that are written out


def argument_terms(graph: Graph, argument: Node) -> Polynomial:
    """An angle or exponent as a polynomial; it is one term where that would be long.

    Sines and cosines in it are those of single angles, by the addition theorems, and cos^2 is 1 - sin^2: exp(cos(x - y)) is
    exp(cos(x) cos(y) + sin(x) sin(y)).
    """
    try:
        found = polynomial(graph, argument, limit=_LIMIT, circle=False)
        waves = {factor for monomial in found for factor, _ in monomial if graph.op[factor] in _WAVES}
        if not waves:
            return found
        (opened,) = substitute(graph, [argument], {wave: _open(graph, wave) for wave in waves}, named=False)
        return polynomial(graph, opened, limit=_LIMIT, circle=True)
    except TooLarge:
        return {((argument, 1),): Fraction(1)}


def _open(graph: Graph, wave: Node) -> Node:
    """A sine or cosine of a sum by those of its terms.

    Raises:
        TooLarge: an angle stands there many times.
    """
    g, c, s = graph, graph.one, graph.zero
    for monomial, k in argument_terms(graph, graph.a[wave]).items():
        if abs(k.numerator) > _MOST_TURNS:
            raise TooLarge
        part = g.product(g.power(factor, n) for factor, n in monomial)
        angle = g.scale(Fraction(1 if k > 0 else -1, k.denominator), part)
        ck, sk = g.function("cos", angle), g.function("sin", angle)
        for _ in range(abs(k.numerator)):
            c, s = g.sub(g.mul(c, ck), g.mul(s, sk)), g.add(g.mul(s, ck), g.mul(c, sk))
    return s if g.op[wave] == "sin" else c
