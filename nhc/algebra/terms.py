"""Terms of canonical polynomials: collected, divided by a monomial, and roots of squares that are monomials."""

from __future__ import annotations

from fractions import Fraction
from typing import TypeVar

from nhc.algebra.expand import Coefficient, Monomial, Polynomial
from nhc.algebra.graph import Graph, Node

_Key = TypeVar("_Key")


def put(into: dict[_Key, Polynomial], key: _Key, monomial: Monomial, c: Coefficient) -> None:
    """Add a term to one of several polynomials, in place."""
    add_term(into.setdefault(key, {}), monomial, c)


def add_term(p: Polynomial, monomial: Monomial, c: Coefficient) -> None:
    """Add a term in place."""
    c += p.get(monomial, 0)
    if c:
        p[monomial] = c
    else:
        p.pop(monomial, None)


def merge(m1: Monomial, m2: Monomial) -> Monomial:
    """The product of two monomials."""
    if not m1:
        return m2
    if not m2:
        return m1
    exponents = dict(m1)
    for factor, e in m2:
        e += exponents.get(factor, 0)
        if e:
            exponents[factor] = e
        else:
            exponents.pop(factor, None)
    return tuple(sorted(exponents.items()))


def divide(p: Polynomial, factor: Fraction, by: Monomial) -> Polynomial | None:
    """By a factor and a monomial that stands in every term."""
    made: Polynomial = {}
    for m, c in p.items():
        exponents = dict(m)
        for f, e in by:
            exponents[f] = exponents.get(f, 0) - e
            if exponents[f] < 0:
                return None
        made[tuple((f, e) for f, e in sorted(exponents.items()) if e)] = Fraction(c) / factor
    return made


def root(graph: Graph, p: Polynomial) -> tuple[Fraction, Monomial] | None:
    """(c, m) where p = c m^2 for a monomial m, with 1 - sin^2 read as cos^2; None where it is not."""
    cosines = dict[Node, int]()
    while len(p) > 1:
        for sine in sorted({f for m in p for f, _ in m if graph.op[f] == "sin"}):
            quotient = _by_cosine(p, sine)
            if quotient is not None:
                cosine = graph.function("cos", graph.a[sine])
                cosines[cosine] = cosines.get(cosine, 0) + 1
                p = quotient
                break
        else:
            return None
    ((monomial, c),) = p.items()
    if c <= 0 or any(e % 2 or e < 0 for _, e in monomial):
        return None
    powers = {f: e // 2 for f, e in monomial}
    for cosine, e in cosines.items():
        powers[cosine] = powers.get(cosine, 0) + e
    return Fraction(c), tuple(sorted(powers.items()))


def root_of_ratio(p: Polynomial, q: Polynomial) -> tuple[Fraction, Monomial] | None:
    """(c, m) where p = c m^2 q, for polynomials of one term each; None where they are others, or m has no whole powers."""
    if len(p) != 1 or len(q) != 1:
        return None
    ((top, c),), ((bottom, d),) = p.items(), q.items()
    powers = dict(top)
    for f, e in bottom:
        powers[f] = powers.get(f, 0) - e
    if any(e % 2 for e in powers.values()):
        return None
    return Fraction(c) / d, tuple(sorted((f, e // 2) for f, e in powers.items() if e))


def _by_cosine(p: Polynomial, sine: Node) -> Polynomial | None:
    """p / (1 - sin^2), where that is a polynomial."""
    parts: dict[int, Polynomial] = {}
    for m, c in p.items():
        e = dict(m).get(sine, 0)
        put(parts, e, tuple((f, k) for f, k in m if f != sine), c)
    top = max(parts)
    for e in range(2, top + 1):
        for m, c in list(parts.get(e - 2, {}).items()):
            put(parts, e, m, c)
    if parts.get(top) or parts.get(top - 1):
        return None
    made: Polynomial = {}
    for e, part in parts.items():
        for m, c in part.items():
            made[tuple(sorted((*m, (sine, e)))) if e else m] = c
    return made
