"""Canonical Laurent polynomials over the graph: what is small enough is brought to one form modulo sin^2 + cos^2 = 1.

A monomial is a tuple of (node, exponent) pairs in increasing order of node, a polynomial maps monomials to rationals.  An atom is
whatever is not a sum, product or integer power (symbols, sin, sqrt, reciprocals of sums).  Everything is bounded by ``limit``
terms: what would grow past it raises :class:`TooLarge` and the caller keeps the graph's own form.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from fractions import Fraction
from math import gcd, lcm

from nhc.algebra.divided import divide_sums
from nhc.algebra.expand import Coefficient, Expander, Monomial, Polynomial, TooLarge, is_length
from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.terms import add_term, merge
from nhc.algebra.walks import count, reachable

ONE: Monomial = ()
Terms = list[tuple[Monomial, Coefficient]]
"""A polynomial, where no term is looked up."""
_ONE, _MILLION = Fraction(1), 10**6
_WIDEST = 64  # factors that monomials have places for
_CHAINS = ((3, 80), (5, 20))
"""Coordinates and terms before any cancel, beyond which a form has never come out short: what cancels are the turns of one body,
and a chain of bodies has more.  Of 214 forms beyond them, of all specs and of chains of 1 to 20 links, two had few enough terms,
and neither was the shorter one."""


def polynomial(graph: Graph, node: Node, limit: int = 300, circle: bool = True) -> Polynomial:
    """The node as a canonical polynomial; with ``circle``, cos^2 is written 1 - sin^2."""
    return Expander(graph, limit, circle).expand([node])[0]


# --- back to the graph, factored --------------------------------------------------------------------------


def to_node(graph: Graph, p: Polynomial) -> Node:
    """A short expression for the polynomial: common factors out first, sums of squares of sin and cos as 1."""
    if not p:
        return graph.zero
    shortest = p
    for _ in range(6):  # sin^2 -> 1 - cos^2 where that leaves fewer terms
        candidate = _swap_sines(graph, shortest)
        if candidate is None:
            break
        shortest = candidate
    if not shortest:  # (1 - sin^2)/cos - cos: not zero until the sine is swapped
        return graph.zero
    return _horner(graph, list(shortest.items()))


def _swap_sines(graph: Graph, p: Polynomial) -> Polynomial | None:
    """The polynomial with one angle's sin^2 written 1 - cos^2, if that has fewer terms."""
    sines = sorted({f for m in p for f, e in m if e >= 2 and graph.op[f] == "sin"})
    for sine in sines:
        cosine = graph.function("cos", graph.a[sine])
        result: Polynomial = {}
        for monomial, c in p.items():
            e = next((k for f, k in monomial if f == sine), 0)
            if e < 2:
                add_term(result, monomial, c)
                continue
            rest = tuple((f, k - 2 if f == sine else k) for f, k in monomial if f != sine or k > 2)
            add_term(result, rest, c)
            add_term(result, merge(rest, ((cosine, 2),)), -c)
        if len(result) < len(p):
            return result
    return None


def _horner(graph: Graph, terms: Terms) -> Node:
    if len(terms) == 1:
        return _monomial(graph, *terms[0])
    content = _content([c for _, c in terms])
    if content != 1:
        return graph.mul_number(content, _horner(graph, [(m, c / content) for m, c in terms]))
    times = _count_factors(terms)
    common = _common(terms, times)
    if common:
        by = dict(common)
        return graph.mul(_monomial(graph, common, 1), _horner(graph, [(_divide(m, by), c) for m, c in terms]))
    most = max(times.values())
    if most == 1:
        return graph.sum([_monomial(graph, m, c) for m, c in sorted(terms)])
    taken, negative = divmod(min(key for key, count in times.items() if count == most), 2)
    inside, outside = Terms(), Terms()
    for term in terms:
        for f, e in term[0]:
            if f == taken and (e < 0) == negative:
                inside.append(term)
                break
        else:
            outside.append(term)
    return graph.add(_horner(graph, inside), _horner(graph, outside))


def _content(coefficients: Sequence[Coefficient]) -> Fraction:
    """The rational number in front of all terms, where taking it out leaves fewer multiplications by numbers; else 1.

    Multiples of one polynomial then share it.
    """
    if 1 in coefficients or -1 in coefficients:
        return _ONE
    content = Fraction(gcd(*(c.numerator for c in coefficients)), lcm(*(c.denominator for c in coefficients)))
    sizes = [abs(c) for c in coefficients]
    return content if sum(c != content for c in sizes) + 1 < len(sizes) else _ONE


def _count_factors(terms: Terms) -> dict[int, int]:
    """In how many of the terms each factor stands: 2 f for f with positive exponents, 2 f + 1 for f with negative ones."""
    times: dict[int, int] = {}
    for m, _ in terms:
        for f, e in m:
            key = 2 * f + (e < 0)
            times[key] = times.get(key, 0) + 1
    return times


def _common(terms: Terms, times: dict[int, int]) -> Monomial:
    """The largest monomial that divides every term."""
    size = len(terms)
    shared = {f: e for f, e in terms[0][0] if times[2 * f + (e < 0)] == size}
    if shared:
        for m, _ in terms:
            for f, e in m:
                if f in shared and abs(e) < abs(shared[f]):
                    shared[f] = e
    return tuple(shared.items())


def _divide(m: Monomial, by: dict[Node, int]) -> Monomial:
    """By a monomial whose factors all stand in it."""
    return tuple([(f, e - by[f]) if f in by else (f, e) for f, e in m if by.get(f) != e])


def _monomial(graph: Graph, m: Monomial, c: Coefficient) -> Node:
    top = bottom = graph.one
    for f, e in m:
        if e > 0:
            top = graph.mul(top, graph.power(f, e))
    for f, e in m:
        if e < 0:
            bottom = graph.mul(bottom, graph.power(f, -e))
    result = top if c in (1, -1) else graph.mul(graph.number(-c if c < 0 else c), top)
    if bottom != graph.one:
        result = graph.div(result, bottom)
    return graph.neg(result) if c < 0 else result


def normalise(graph: Graph, node: Node, limit: int = 300) -> Node:
    """The node in canonical short form, or the node itself where that would be longer than ``limit`` terms."""
    return normalise_all(graph, [node], limit)[0]


def _expander(graph: Graph, limit: int, closed: bool = False) -> Expander:
    """One that knows what was expanded before, unless its monomials have become long."""
    name = f"{'closed ' if closed else ''}expander to {limit}"
    found: Expander | None = graph.memory.get(name)
    if found is None or found.width > _WIDEST:
        found = graph.memory[name] = Expander(graph, limit, True, closed)
    return found


def normalise_all(graph: Graph, nodes: Iterable[Node], limit: int, swollen: int = 0) -> list[Node]:
    """Each node in canonical short form where that has at most ``limit`` terms; common parts are expanded once.

    With ``swollen``, a node that would have more terms than that before any of them cancel is left as it is, and so is one that has
    many terms for a chain.
    """
    nodes = list(nodes)
    sizes = _count_terms(graph, nodes) if swollen else {}
    known: dict[Node, Node] = graph.memory.setdefault(f"normal forms of {limit}", {})
    made = dict[Node, Node]()
    for node in nodes:
        if node in made or node in known:
            made[node] = known.get(node, node)
            continue
        try:
            if swollen and _swells(graph, node, sizes[node], swollen):
                raise TooLarge
            made[node] = known[node] = _shorter(graph, node, limit)
        except TooLarge:
            made[node] = node
    return [made[node] for node in nodes]


def _swells(graph: Graph, node: Node, terms: int, swollen: int) -> bool:
    """Whether a node with so many terms before any of them cancel is certain, or sure enough, to have too many after it."""
    coordinates = (graph.deps[node] & ~(graph.moving | graph.parameters)).bit_count()
    return terms > swollen or any(coordinates > many and terms > most for many, most in _CHAINS)


def _shorter(graph: Graph, node: Node, limit: int) -> Node:
    """The canonical form with all sums multiplied out, or with those of parameters left as they are: the shorter one.

    (b - a)^2/(b - a) is not seen to be b - a when it is multiplied out, nor (a + b)^2 - (a - b)^2 to be 4 a b when it is not.

    Raises:
        TooLarge: both have too many terms.
    """
    open_, forms = _expander(graph, limit), list[Node]()
    try:
        forms += _forms(graph, open_, node)
        if node not in open_.opened:
            return min(forms, key=lambda form: _cost(graph, form))
    except TooLarge:
        if not any(is_length(graph, inner) for inner in reachable(graph, [node], graph.still)):
            raise
    with suppress(TooLarge):
        forms += _forms(graph, _expander(graph, limit, True), node)
    if not forms:
        raise TooLarge
    return min(forms, key=lambda form: _cost(graph, form))


def _forms(graph: Graph, expander: Expander, node: Node) -> list[Node]:
    """The polynomial as it is, and divided by the sums below its fraction lines where it has fewer terms then."""
    p = expander.expand([node])[0]
    q = divide_sums(graph, p, lambda inner: expander.expand([inner])[0])
    return [to_node(graph, p)] if q is p else [to_node(graph, p), to_node(graph, q)]


def _cost(graph: Graph, node: Node) -> int:
    """Operations, where a division counts as eight."""
    divisions = sum(graph.op[x] == POW and graph.b[x] < 0 for x in reachable(graph, [node]))
    return count(graph, [node]) + 7 * divisions


def _count_terms(graph: Graph, nodes: Sequence[Node]) -> dict[Node, int]:
    """Terms of products multiplied out, if nothing cancelled; at most a million.  Each node is counted once."""
    op, a, b = graph.op, graph.a, graph.b
    count: dict[Node, int] = graph.memory.setdefault("terms", {})
    for node in reachable(graph, nodes):
        if node in count:
            continue
        kind = op[node]
        if kind == ADD:
            count[node] = min(count[a[node]] + count[b[node]], _MILLION)
        elif kind == MUL:
            count[node] = min(count[a[node]] * count[b[node]], _MILLION)
        elif kind == NEG:
            count[node] = count[a[node]]
        elif kind == POW and b[node] > 0:
            count[node] = min(count[a[node]] ** min(b[node], 20), _MILLION)
        else:
            count[node] = 1
    return count


def leading_size(p: Polynomial, q: Polynomial) -> Fraction:
    """The magnitude of the first coefficient of p - q in the order of the monomials; 1 where p is q."""
    rest = {m: k for m in {**p, **q} if (k := p.get(m, 0) - q.get(m, 0))}
    return abs(Fraction(rest[min(rest)])) if rest else Fraction(1)
