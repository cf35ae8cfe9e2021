"""Polynomials divided by the sums that stand below their fraction lines: x^2/(l^2 - x^2) + 1 is l^2/(l^2 - x^2).

With r = 1/D for a sum D, and D for the squares of its roots, a polynomial is one in r over the other atoms: lead r is
(1 - rest r)/c where D = c lead + rest.  Which of D's monomials leads is tried, for no one order is the shortest everywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from nhc.algebra.expand import Monomial, Polynomial, TooLarge
from nhc.algebra.graph import ADD, POW, Graph, Node
from nhc.algebra.terms import add_term, merge

_MOST = 8
"""Terms of a sum by which is divided."""
_STEPS = 60
"""Terms that are divided, one after another."""
_FEWER = 0.75
"""What a division has to leave of the terms: what it leaves is seldom shared with other expressions."""
Expand = Callable[[Node], Polynomial]


def divide_sums(graph: Graph, p: Polynomial, expand: Expand) -> Polynomial:
    """The polynomial after division by one sum after another, or as it is where that leaves nearly as many terms."""
    if "divided sums" in graph.off:
        return p
    made = _square_roots(graph, p)
    for r in sorted({f for m in made for f, _ in m if _is_reciprocal(graph, f)}):
        if not any(_exponent(m, r) for m in made):
            continue  # gone with another one
        try:
            divisor = expand(graph.a[r])
        except TooLarge:
            continue
        if 1 < len(divisor) <= _MOST:
            least = min(_divided(made, r, divisor), key=len, default=made)
            made = least if len(least) <= _FEWER * len(made) else made
    return made if len(made) <= _FEWER * len(p) else p


def _square_roots(graph: Graph, p: Polynomial) -> Polynomial:
    """With D for the squares of its roots."""
    roots = {f for m in p for f, e in m if not -1 <= e <= 1 and graph.op[f] == "sqrt" and graph.op[graph.a[f]] == ADD}
    if not roots:
        return p
    made = Polynomial()
    for m, c in p.items():
        for f, e in m:
            if f in roots:
                whole = int(e / 2)
                m = merge(m, ((f, -2 * whole), (graph.inverse(graph.a[f]), -whole)))
        add_term(made, m, c)
    return made


def _is_reciprocal(graph: Graph, node: Node) -> bool:
    return graph.op[node] == POW and graph.b[node] == -1 and graph.op[graph.a[node]] == ADD


def _divided(p: Polynomial, r: Node, divisor: Polynomial) -> Iterator[Polynomial]:
    """With each monomial of D that divides no other one as the leading one, relative to the lowest power of r and to r^0."""
    lowest = min(_exponent(m, r) for m in p)
    for lead in divisor:
        if lead and all(m == lead or _quotient(m, lead) is None for m in divisor):
            for power in dict.fromkeys((lowest, 0)):
                made = _divide(_times_power(p, r, -power), r, divisor, lead)
                if made is not None:
                    yield _times_power(made, r, power)


def _divide(p: Polynomial, r: Node, divisor: Polynomial, lead: Monomial) -> Polynomial | None:
    """Without lead r; None where this takes too long."""
    made, left, steps = dict(p), [m for m in p if _reduces(m, r, lead)], 0
    share = {other: -Fraction(c) / divisor[lead] for other, c in divisor.items() if other != lead}
    while left:
        m = left.pop()
        quotient, c = _quotient(m, lead), made.pop(m, 0)
        if quotient is None or not c:
            continue
        steps += 1
        if steps > _STEPS:
            return None
        new = [(merge(quotient, ((r, -1),)), Fraction(c) / divisor[lead])]
        new += [(merge(quotient, other), c * k) for other, k in share.items()]
        for other, k in new:
            add_term(made, other, k.numerator if k.denominator == 1 else k)
            if _reduces(other, r, lead):
                left.append(other)
    return made


def _reduces(m: Monomial, r: Node, lead: Monomial) -> bool:
    return _exponent(m, r) > 0 and _quotient(m, lead) is not None


def _exponent(m: Monomial, factor: Node) -> int:
    return next((e for f, e in m if f == factor), 0)


def _times_power(p: Polynomial, r: Node, power: int) -> Polynomial:
    return {merge(m, ((r, power),)): c for m, c in p.items()} if power else p


def _quotient(m: Monomial, by: Monomial) -> Monomial | None:
    """The monomial without another one that stands in it."""
    exponents = dict(m)
    for f, e in by:
        own = exponents.get(f, 0)
        if not (0 < e <= own or own <= e < 0):
            return None
    return merge(m, tuple((f, -e) for f, e in by))
