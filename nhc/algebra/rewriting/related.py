"""Sines and cosines of angles that are sums, differences or multiples of others at hand: six operations in place of two calls.

A library takes 70 to 95 instructions for a sine, and 120 to 150 for sine and cosine together (glibc 2.36, counted).
Among the angles whose sines and cosines are needed, the simplest are computed; what is a sum of two or three of these, with either
sign, repeats allowed, comes from the addition theorems.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction

from nhc.algebra.graph import ADD, Graph, Node
from nhc.algebra.nodes import Rational
from nhc.algebra.parts import list_terms
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.angles import Pair, add_angles
from nhc.algebra.rewriting.arcs import open_arcs
from nhc.algebra.walks import reachable

Angle = tuple[tuple[Node, Rational], ...]
"""An angle as (term without its rational factor, factor), by increasing node."""

Terms = tuple[tuple[Angle, int], ...]
"""Angles with signs, to be added."""

_BOTH = ("sin", "cos")
_FIRST, _SECOND = 80, 50  # instructions of a call of glibc 2.36, and of the other function of the same angle
_SUM = 3  # operations of an addition theorem, for one of the functions
_MOST = 12  # angles; beyond them, sums of three are too many to look at
_ALL = 256  # angles; beyond them, sums of two are
_SEVERAL = 64  # angles; beyond them, multiples stay apart, whose rounding grows with them
_DEEPEST = 2  # sums of sums: each adds its rounding


def relate_angles(graph: Graph, roots: Sequence[Node]) -> list[Node]:
    """Equal roots in which sines and cosines of sums come from those of the terms, where that is shorter, and of arcs from none."""
    if "related angles" in graph.off:
        return list(roots)
    roots = open_arcs(graph, roots)
    needed = _list_angles(graph, roots)
    if not 2 <= len(needed) <= _ALL:
        return list(roots)
    vectors = {node: _split(graph, node) for node in needed}
    if len(needed) > _SEVERAL:
        vectors = {node: vector for node, vector in vectors.items() if all(abs(k) == 1 for _, k in vector)}
    phases = _list_phases(graph, vectors.values())
    if not phases and _are_independent(vectors.values()):
        return list(roots)
    known: dict[Angle, Node] = {}
    pairs: dict[Node, Pair] = {}
    depth: dict[Node, int] = {}
    new: dict[Node, Node] = {}
    for phase in phases:
        known[_split(graph, phase)] = phase
        pairs[phase], depth[phase], needed[phase] = (
            (graph.function("sin", phase), graph.function("cos", phase)),
            0,
            {*_BOTH},
        )
    for node in sorted(vectors, key=lambda node: (*_size(vectors[node]), node)):
        called = graph.function("sin", node), graph.function("cos", node)
        pairs[node], depth[node] = called, 0
        terms = _find_terms(known, vectors[node])
        operands = [known[vector] for vector, _ in terms or ()]
        if terms is not None and _saves(needed, node, operands, new, pairs):
            pairs[node] = add_angles(graph, [_turn_back(graph, pairs[known[vector]], sign) for vector, sign in terms])
            new |= zip(called, pairs[node], strict=True)
            needed |= {operand: set(_BOTH) for operand in operands}
            depth[node] = 1 + max(depth[operand] for operand in operands)
        if depth[node] < _DEEPEST:
            known.setdefault(vectors[node], node)
    return substitute(graph, roots, new) if new else list(roots)


def count_angles(graph: Graph, roots: Sequence[Node]) -> tuple[int, int]:
    """Angles whose sines and cosines will be called, and those that will come from these."""
    needed = {graph.a[node] for node in reachable(graph, roots) if graph.op[node] in _BOTH}
    if not 2 <= len(needed) <= _ALL or "related angles" in graph.off:
        return len(needed), 0
    vectors = [_split(graph, node) for node in needed]
    if _are_independent(vectors):
        return len(needed), 0
    known: dict[Angle, None] = {}
    for vector in sorted(vectors, key=_size):
        if _find_terms(known, vector) is None:
            known[vector] = None
    return len(known), len(needed) - len(known)


def _list_phases(graph: Graph, vectors: Iterable[Angle]) -> list[Node]:
    """Numbers by which angles differ: their sines and cosines are numbers, too."""
    groups: dict[Angle, list[Fraction]] = {}
    for vector in vectors:
        moving = tuple(term for term in vector if term[0] != graph.one)
        turned = bool(moving) and moving[0][1] < 0  # 2 - x is x - 2
        phase = Fraction(dict(vector).get(graph.one, 0))
        groups.setdefault(_negative(moving) if turned else moving, []).append(-phase if turned else phase)
    several = (sorted(found, key=abs) for moving, found in groups.items() if moving)
    return [graph.number(k) for k in sorted({abs(k - found[0]) for found in several for k in found[1:]})]


def _saves(
    needed: Mapping[Node, set[str]],
    node: Node,
    operands: Sequence[Node],
    new: Collection[Node],
    pairs: Mapping[Node, Pair],
) -> bool:
    """Whether adding the operands takes fewer operations than calling the functions that are needed of their sum."""
    wanted = len(needed[node])
    cost = _SUM * (2 * max(0, len(operands) - 2) + (wanted if len(operands) > 1 else 0))
    for operand in set(operands):
        cost += (2 - len(needed[operand])) * (_SUM if pairs[operand][0] in new else _SECOND)
    return cost < _FIRST + (wanted - 1) * _SECOND


def _list_angles(graph: Graph, roots: Sequence[Node]) -> dict[Node, set[str]]:
    """The arguments of sines and cosines, each with the functions that are needed; those that hold sines themselves stay apart."""
    found: dict[Node, set[str]] = {}
    op, kids = graph.op, graph.kids
    for node in reachable(graph, roots):
        if op[node] in _BOTH:
            found.setdefault(kids[node][0], set()).add(op[node])
    simple = {angle for angle in found if not any(op[part] in _BOTH for part in reachable(graph, (angle,), known=()))}
    return {angle: own for angle, own in found.items() if angle in simple}


def _split(graph: Graph, node: Node) -> Angle:
    found: dict[Node, Rational] = {}
    stack: list[tuple[Rational, Node]] = [(1, node)]
    while stack:
        size, part = stack.pop()
        for k, core in map(graph.split_coefficient, list_terms(graph, part)):
            if graph.op[core] == ADD:  # 2 (a + b)
                stack.append((size * k, core))
            else:
                found[core] = found.get(core, 0) + size * k  # a sum may hold a term twice, or with both signs
    return _as_angle(found)


def _size(vector: Angle) -> tuple[int, Fraction]:
    """By it the simplest angles come first."""
    return len(vector), sum((abs(Fraction(k)) for _, k in vector), Fraction(0))


def _are_independent(vectors: Iterable[Angle]) -> bool:
    """Whether no angle is a combination of others."""
    echelon: dict[Node, Angle] = {}
    for vector in vectors:
        rest = vector
        while rest and rest[0][0] in echelon:
            row = echelon[rest[0][0]]
            rest = _subtract(rest, row, Fraction(rest[0][1]) / row[0][1])
        if not rest:
            return False
        echelon[rest[0][0]] = rest
    return True


def _find_terms(known: Iterable[Angle], wanted: Angle) -> Terms | None:
    """Up to three of the known angles, with signs, whose sum is the wanted one; as few as possible."""
    signed = {vector: (vector, 1) for vector in known}
    signed |= {_negative(vector): (vector, -1) for vector in known}
    if wanted in signed:
        return (signed[wanted],)
    for vector, term in signed.items():
        rest = signed.get(_subtract(wanted, vector))
        if rest is not None:
            return term, rest
    if len(signed) > 2 * _MOST:
        return None
    for vector, term in signed.items():
        left = _subtract(wanted, vector)
        for other, second in signed.items():
            third = signed.get(_subtract(left, other))
            if third is not None:
                return term, second, third
    return None


def _negative(vector: Angle) -> Angle:
    return tuple((term, -k) for term, k in vector)


def _subtract(vector: Angle, other: Angle, factor: Rational = 1) -> Angle:
    found: dict[Node, Rational] = dict(vector)
    for term, k in other:
        found[term] = found.get(term, 0) - factor * k
    return _as_angle(found)


def _as_angle(factors: Mapping[Node, Rational]) -> Angle:
    return tuple(sorted((term, k) for term, k in factors.items() if k))


def _turn_back(graph: Graph, pair: Pair, sign: int) -> Pair:
    return pair if sign > 0 else (graph.neg(pair[0]), pair[1])
