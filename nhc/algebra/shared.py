"""Factors that several nodes share, also where they were multiplied out.

The nodes are read as polynomials in their symbols and functions.  Sine and cosine of one angle are written by those of half of it,
S and C, every term with as many of these factors (1 is S^2 + C^2): so multiplied out, a factor 1 + cos that meets sin^2 = (1 +
cos)(1 - cos) is found as well.  Whether anything is shared is asked first modulo a prime, with numbers for all but one unknown:
only where the answer is yes are factors sought, by SymPy, and only in the unknowns for which it is.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from itertools import accumulate, product
from math import comb

from nhc.algebra.bridge import Powers, shared_factors
from nhc.algebra.exact.residues import PRIMES
from nhc.algebra.expand import Expander, Polynomial, TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise, polynomial, to_node

_TERMS = 150
_HIGHEST = 24  # degree in one unknown
_UNKNOWNS = 16
_MOST_FACTORS, _POWERS = 4, 3  # of what is written as a product
_SOON = 16, 9  # terms and unknowns of what is soon written as a product
_FIRST = 3  # of many, the shortest: most share nothing


def find_shared(graph: Graph, nodes: Sequence[Node]) -> list[Node]:
    """Factors that all of the nodes have, each once and without its powers; none where the nodes are too long to tell."""
    expander = Expander(graph, _TERMS, circle=False)
    try:
        expanded = sorted((p for p in expander.expand(nodes) if p), key=len)
        found = _shared(graph, [_by_halves(graph, p) for p in expanded[:_FIRST]])
        if found and len(expanded) > _FIRST:
            found = _shared(graph, [_by_halves(graph, p) for p in expanded])
    except TooLarge:
        return []
    return found


def factor(graph: Graph, node: Node) -> Node:
    """The node as a product where it is one that was multiplied out (exactly, sin^2 + cos^2 being 1), else the node itself."""
    try:
        p = polynomial(graph, node, _TERMS)
        if len(p) < 2:
            return node
        terms = [dict(monomial) for monomial in p]
        outer = {atom: min(term.get(atom, 0) for term in terms) for atom in sorted(set().union(*terms))}
        before = graph.product(graph.power(atom, n) for atom, n in outer.items())
        rest = polynomial(graph, graph.div(node, before), _TERMS)
        if len(rest) > _SOON[0] or len({atom for monomial in rest for atom, _ in monomial}) > _SOON[1]:
            return node  # a second for a bicycle's
        inner = _as_product(graph, rest)
        return node if inner is None else graph.mul(before, inner)
    except TooLarge:
        return node


def _as_product(graph: Graph, p: Polynomial) -> Node | None:
    """The polynomial as a number times powers of its factors; None if that is not found."""
    factors = find_shared(graph, [to_node(graph, p)])
    if not 0 < len(factors) <= _MOST_FACTORS:
        return None
    for powers in sorted(product(range(1, _POWERS + 1), repeat=len(factors)), key=sum):
        made = graph.product(graph.power(base, n) for base, n in zip(factors, powers, strict=True))
        q = polynomial(graph, made, _TERMS)
        number = Fraction(p[min(p)]) / Fraction(q[min(p)]) if min(p) in q else Fraction(0)
        if p == {monomial: number * k for monomial, k in q.items()}:
            return graph.mul_number(number, made)
    return None


def _shared(graph: Graph, polynomials: Sequence[Polynomial]) -> list[Node]:
    written = [p for p in polynomials if p]
    unknowns = sorted({atom for p in written for monomial in p for atom, _ in monomial})
    if not written or len(unknowns) > _UNKNOWNS:
        return []
    dense = [_shifted(p, unknowns) for p in written]
    lowest = [min(low[k] for _, low in dense) for k in range(len(unknowns))]
    found = _joined(graph, [atom for atom, low in zip(unknowns, lowest, strict=True) if low > 0])
    rest = [p for p, _ in dense]
    if max(max(powers, default=0) for p in rest for powers in p) <= _HIGHEST:
        places = _seem_to_share(rest)
        if places:
            own = [unknowns[k] for k in places]
            found += [_written(graph, factor, own) for factor in shared_factors(_coefficients(rest, places))]
    return found


def _joined(graph: Graph, atoms: Sequence[Node]) -> list[Node]:
    """With the sine of an angle in the place of both functions of its half."""
    found = dict.fromkeys(atoms)
    for atom in atoms:
        if graph.op[atom] == "sin":
            other = graph.function("cos", graph.a[atom])
            if other in found:
                del found[atom], found[other]
                found[graph.function("sin", graph.mul_number(2, graph.a[atom]))] = None
    return list(found)


def _written(graph: Graph, p: Powers, unknowns: Sequence[Node]) -> Node:
    """The polynomial as a node, by sine and cosine of the whole angle where it is even in those of its half."""
    g, place = graph, {atom: k for k, atom in enumerate(unknowns)}
    pairs = []
    for s, k in place.items():
        c = g.function("cos", g.a[s]) if g.op[s] == "sin" else s
        even = c in place and all((powers[k] + powers[place[c]]) % 2 == 0 for powers in p)
        if c != s and even:
            whole = g.mul_number(2, g.a[s])
            pairs.append((k, place[c], g.function("sin", whole), g.function("cos", whole)))
    terms = []
    for powers, number in sorted(p.items()):
        left, factors = list(powers), list[Node]()
        for k, j, s, c in pairs:  # S C = sin/2, S^2 = (1 - cos)/2, C^2 = (1 + cos)/2
            odd = left[k] % 2
            number /= 2 ** ((left[k] + left[j]) // 2)
            factors += [s] * odd + [g.power(g.sub(g.one, c), left[k] // 2), g.power(g.add(g.one, c), left[j] // 2)]
            left[k] = left[j] = 0
        factors += [g.power(x, n) for x, n in zip(unknowns, left, strict=True)]
        terms.append(g.mul_number(number, g.product(factors)))
    return normalise(g, g.sum(terms), _TERMS)


def _by_halves(graph: Graph, p: Polynomial) -> Polynomial:
    """Sines and cosines by those of half the angle, every term in the same degree; the polynomial itself where it has none."""
    degrees: dict[Node, int] = {}
    for monomial in p:
        own: dict[Node, int] = {}
        for atom, n in monomial:
            if graph.op[atom] in ("sin", "cos"):
                if n < 0:
                    raise TooLarge  # a divisor that may vanish: not a polynomial
                own[graph.a[atom]] = own.get(graph.a[atom], 0) + n
        degrees |= {angle: max(n, degrees.get(angle, 0)) for angle, n in own.items()}
    for angle, degree in degrees.items():
        p = _by_half(graph, p, angle, degree)
    return p


def _by_half(graph: Graph, p: Polynomial, angle: Node, degree: int) -> Polynomial:
    """The same for one angle: sin is 2 S C, cos is C^2 - S^2, 1 is C^2 + S^2."""
    half = graph.mul_number(Fraction(1, 2), angle)
    whole = {graph.function(name, angle): name for name in ("sin", "cos")}
    s, c = graph.function("sin", half), graph.function("cos", half)
    made: Polynomial = {}
    for monomial, k in p.items():
        n = {name: 0 for name in ("sin", "cos")} | {whole[atom]: e for atom, e in monomial if atom in whole}
        rest = {atom: e for atom, e in monomial if atom not in whole}
        ones = degree - n["sin"] - n["cos"]
        for j, weight in enumerate(_squares(n["cos"], ones)):
            low, high = 2 * j + n["sin"], 2 * (degree - n["sin"] - j) + n["sin"]
            powers = rest | {x: rest.get(x, 0) + e for x, e in ((s, low), (c, high))}
            key = tuple(sorted((x, e) for x, e in powers.items() if e))
            made[key] = made.get(key, 0) + k * weight * 2 ** n["sin"]
    if len(made) > 8 * _TERMS:
        raise TooLarge
    return {monomial: k for monomial, k in made.items() if k}


def _squares(cosines: int, ones: int) -> list[int]:
    """The coefficients of (1 - z)^cosines (1 + z)^ones, z being S^2/C^2."""
    found = [0] * (cosines + ones + 1)
    for i in range(cosines + 1):
        for j in range(ones + 1):
            found[i + j] += (-1) ** i * comb(cosines, i) * comb(ones, j)
    return found


def _shifted(p: Polynomial, unknowns: Sequence[Node]) -> tuple[Powers, list[int]]:
    """The polynomial without the powers that all of its terms have, and these."""
    place = {atom: k for k, atom in enumerate(unknowns)}
    rows = []
    for monomial, k in p.items():
        row = [0] * len(unknowns)
        for atom, n in monomial:
            row[place[atom]] = n
        rows.append((row, Fraction(k)))
    low = [min(column) for column in zip(*(row for row, _ in rows), strict=True)]
    return {tuple(n - m for n, m in zip(row, low, strict=True)): k for row, k in rows}, low


def _coefficients(polynomials: Sequence[Powers], places: Sequence[int]) -> list[Powers]:
    """All polynomials by the other unknowns: their coefficients, polynomials in those at the places, the shortest first.

    A factor that only has these unknowns is one of every coefficient, and these are far smaller.  Each comes once, up to a number.
    """
    made: dict[frozenset[tuple[tuple[int, ...], Fraction]], Powers] = {}
    for p in polynomials:
        by_others: dict[tuple[int, ...], dict[tuple[int, ...], Fraction]] = {}
        for powers, value in p.items():
            others = tuple(0 if k in places else n for k, n in enumerate(powers))
            by_others.setdefault(others, {})[tuple(powers[k] for k in places)] = value
        for own in by_others.values():
            first = own[min(own)]
            monic = {powers: value / first for powers, value in own.items()}
            made.setdefault(frozenset(monic.items()), monic)
    return sorted(made.values(), key=len)


def _seem_to_share(polynomials: Sequence[Powers]) -> list[int]:
    """The unknowns for which the polynomials have a factor in common, modulo a prime and with numbers for the others.

    What they share is seen so; that it seems to be and is not has the chance of a zero at a random point.
    """
    prime, rng = PRIMES[0], random.Random(7)
    count = len(next(iter(polynomials[0])))
    tables = []
    for k in range(count):
        highest = max(powers[k] for p in polynomials for powers in p)
        value = rng.randrange(1, prime)
        tables.append(list(accumulate([value] * highest, lambda a, b: a * b % prime, initial=1)))
    scalars = [{powers: k.numerator * pow(k.denominator, -1, prime) for powers, k in p.items()} for p in polynomials]
    places = []
    for k in range(count):
        if not all(any(powers[k] for powers in p) for p in scalars):
            continue
        common: list[int] = []
        for p in scalars:
            line = [0] * len(tables[k])
            for powers, value in p.items():
                for j, n in enumerate(powers):
                    if j != k and n:
                        value = value * tables[j][n] % prime
                line[powers[k]] = (line[powers[k]] + value) % prime
            common = _common_divisor(common, line, prime)
            if len(common) == 1:
                break
        if len(common) > 1:
            places.append(k)
    return places


def _common_divisor(p: list[int], q: list[int], prime: int) -> list[int]:
    """Of polynomials in one unknown, lowest powers first, up to a number (Euclid)."""
    p, q = _trimmed(p), _trimmed(q)
    while q:
        inverse = pow(q[-1], -1, prime)
        while len(p) >= len(q):
            factor, shift = p[-1] * inverse % prime, len(p) - len(q)
            for k, value in enumerate(q, shift):
                p[k] = (p[k] - factor * value) % prime
            p = _trimmed(p)
        p, q = q, p
    return p


def _trimmed(p: list[int]) -> list[int]:
    size = len(p)
    while size and not p[size - 1]:
        size -= 1
    return p[:size]
