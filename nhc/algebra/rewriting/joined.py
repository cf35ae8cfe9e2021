"""Sines and cosines of sums and differences of angles, where the addition theorems were written out.

cos(a) cos(b) + sin(a) sin(b) is cos(a - b), whatever the two terms are multiplied with; repeated, sums of three angles and more.
For paper; emitted code keeps the products, whose sines and cosines it has anyway, but for :mod:`.differences` (the reverse is
:mod:`.related`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from nhc.algebra.expand import Monomial, Polynomial
from nhc.algebra.graph import ADD, NEG, Graph, Node
from nhc.algebra.nodes import Rational
from nhc.algebra.parts import list_terms, split_powers
from nhc.algebra.rebuilding import rebuild
from nhc.algebra.walks import reachable

_OTHER = {"sin": "cos", "cos": "sin"}
_MOST = 60  # terms of a sum that are looked at


def join_sums(graph: Graph, nodes: Sequence[Node], kept: Mapping[Node, Node] | None = None) -> list[Node]:
    """The nodes with each sum below them joined, innermost first; ``kept``: nodes and what stands for them untouched."""
    needed = reachable(graph, nodes)
    whole = find_whole(graph, nodes, needed)
    new: dict[Node, Node] = dict(kept or {})
    for node in needed:
        if node in new:
            continue
        children = graph.children(node)
        moved = [new[kid] for kid in children]
        made = node if moved == list(children) else rebuild(graph, node, moved)
        body = graph.a[made] if graph.op[made] == NEG else made  # a sum may come out as the negative of one
        if graph.op[body] == ADD and (graph.op[node] != ADD or node in whole):
            joined = _join_sum(graph, body)
            made = joined if body == made else graph.neg(joined)
        new[node] = made
    return [new[node] for node in nodes]


def find_whole(graph: Graph, roots: Iterable[Node], needed: Sequence[Node]) -> set[Node]:
    """What is not only a term of longer sums, among the nodes that the roots need: a sum there is looked at as a whole."""
    whole = set(roots)
    for node in reversed(needed):
        if graph.op[node] != ADD and (graph.op[node] != NEG or node in whole):
            whole.update(graph.children(node))
    return whole


def close_circles(graph: Graph, node: Node) -> Node:
    """The sum with u for u sin(x)^2 + u cos(x)^2 among its terms; the node itself where there are no such terms."""
    p = _collect(graph, list_terms(graph, node))
    waiting, closed = list(p), False
    while waiting:
        monomial = waiting.pop()
        powers, k = dict(monomial), p.get(monomial, 0)
        for base, n in monomial:
            if not k or n < 2 or graph.op[base] != "sin":
                continue
            cosine = graph.function("cos", graph.a[base])
            rest = {b: m - 2 if b == base else m for b, m in monomial if b != base or m > 2}
            other = tuple(sorted({**rest, cosine: powers.get(cosine, 0) + 2}.items()))
            if p.get(other) == k:
                inner = tuple(sorted(rest.items()))
                p[inner] = p.get(inner, 0) + k
                del p[monomial], p[other]
                waiting.append(inner)
                closed = True
                break
    return graph.sum([make_product(graph, m, c) for m, c in p.items() if c]) if closed else node


def _join_sum(graph: Graph, node: Node) -> Node:
    """The sum of its joined terms; the node itself where none can be joined."""
    terms = list_terms(graph, node)
    if not 2 <= len(terms) <= _MOST:
        return node
    p = _collect(graph, terms)
    made = join_terms(graph, p)
    return node if made == p else graph.sum([make_product(graph, m, c) for m, c in made.items() if c])


def _collect(graph: Graph, terms: Sequence[Node]) -> Polynomial:
    """The sum of products as a polynomial in their factors."""
    p: Polynomial = {}
    for term in terms:
        k, monomial = split_factors(graph, term)
        p[monomial] = p.get(monomial, 0) + k
    return p


def split_factors(graph: Graph, term: Node) -> tuple[Rational, Monomial]:
    """A product as its number and the powers of its factors."""
    coefficient, powers = split_powers(graph, term)
    return coefficient, tuple(sorted(powers.items()))


def make_product(graph: Graph, monomial: Monomial, coefficient: Rational = 1) -> Node:
    """The other way round."""
    return graph.mul_number(coefficient, graph.product(graph.power(base, e) for base, e in monomial))


def join_terms(graph: Graph, p: Polynomial) -> Polynomial:
    """The polynomial with pairs of terms as one, as often as there are any."""
    left, waiting = dict(p), list(p)
    skeletons = {monomial: _skeleton(graph, monomial) for monomial in p}
    alike: dict[_Skeleton, set[Monomial]] = {}
    for monomial, skeleton in skeletons.items():
        alike.setdefault(skeleton, set()).add(monomial)
    while waiting:
        first = waiting.pop(0)
        others = alike[skeletons[first]] - {first} if first in left else set()
        for second, rest, made in _partners(graph, first, others) if others else ():
            size, other = left[first], left.get(second)
            if other is None or abs(other) != abs(size):
                continue
            k, factor = graph.split_coefficient(made(equal=other == size))
            del left[first], left[second]
            monomial = _times(rest, factor, graph)
            left[monomial] = left.get(monomial, 0) + size * k
            if left[monomial] == 0:
                del left[monomial]
            skeletons[monomial] = _skeleton(graph, monomial)
            alike.setdefault(skeletons[monomial], set()).add(monomial)
            waiting.append(monomial)
            break
    return left


_Skeleton = frozenset[tuple[tuple[Node, bool], int]]


def _skeleton(graph: Graph, monomial: Monomial) -> _Skeleton:
    """A term's factors with sines and cosines of one angle as one: terms that can be joined have the same."""
    powers: dict[tuple[Node, bool], int] = {}
    for factor, exponent in monomial:
        turned = graph.op[factor] in _OTHER
        key = (graph.a[factor] if turned else factor, turned)
        powers[key] = powers.get(key, 0) + exponent
    return frozenset(powers.items())


class _Made:
    """What two terms make together, per unit of the first one's coefficient; ``equal``: the second one has the same.

    cos a cos b + sin a sin b = cos(a - b), sin a cos b + cos a sin b = sin(a + b), and so on; of a sine and a cosine, a is the
    sine's angle.
    """

    def __init__(self, graph: Graph, a: Node, b: Node, functions: tuple[str, str]) -> None:
        self.graph, self.a, self.b, self.functions = graph, a, b, functions

    def __call__(self, *, equal: bool) -> Node:
        g, mixed = self.graph, self.functions == ("sin", "cos")
        angle = _add_angle(g, self.a, self.b, 1 if equal == mixed else -1)
        if mixed:
            return g.function("sin", angle)
        joined = g.function("cos", angle)
        return g.neg(joined) if self.functions == ("sin", "sin") and not equal else joined


def _partners(
    graph: Graph, monomial: Monomial, others: Iterable[Monomial]
) -> Iterator[tuple[Monomial, Monomial, _Made]]:
    """Each of the ``others`` that the given term may be joined with, what both have in common, and what they make together."""
    turned = [f for f, e in monomial if e > 0 and graph.op[f] in _OTHER]
    for f, h in sorted(_lost_pairs(monomial, others, {f: k for k, f in enumerate(turned)})):
        f, h = turned[f], turned[h]
        if graph.a[f] == graph.a[h]:
            continue
        one, other = (h, f) if (graph.op[f], graph.op[h]) == ("cos", "sin") else (f, h)
        rest = _times(_times(monomial, one, graph, -1), other, graph, -1)
        partner = rest
        for factor in (one, other):
            partner = _times(partner, graph.function(_OTHER[graph.op[factor]], graph.a[factor]), graph)
        yield partner, rest, _Made(graph, graph.a[one], graph.a[other], (graph.op[one], graph.op[other]))


def _lost_pairs(
    monomial: Monomial, others: Iterable[Monomial], places: Mapping[Node, int]
) -> Iterator[tuple[int, int]]:
    """Places of two factors that the term has once more than another one, and no further ones."""
    for other in others:
        powers = dict(other)
        lost = [(f, e - powers.get(f, 0)) for f, e in monomial if e > powers.get(f, 0)]
        if len(lost) == 2 and all(more == 1 and f in places for f, more in lost):
            (f, _), (h, _) = lost
            yield places[f], places[h]


def _times(monomial: Monomial, factor: Node, graph: Graph, exponent: int = 1) -> Monomial:
    if factor == graph.one:
        return monomial
    powers = dict(monomial)
    powers[factor] = powers.get(factor, 0) + exponent
    return tuple(sorted((f, e) for f, e in powers.items() if e))


def _add_angle(graph: Graph, a: Node, b: Node, sign: int) -> Node:
    """a + sign b with each term once, numbers last; the negative of a sum where it would begin with a minus."""
    found: dict[Node, Rational] = {}
    for angle, factor in ((a, 1), (b, sign)):
        for term in list_terms(graph, angle):
            k, core = graph.split_coefficient(term)
            found[core] = found.get(core, 0) + factor * k
    terms = sorted(((core, k) for core, k in found.items() if k), key=lambda term: (term[0] == graph.one, term[0]))
    negative = bool(terms) and terms[0][1] < 0
    total = graph.sum([graph.mul_number(-k if negative else k, core) for core, k in terms])
    return graph.neg(total) if negative else total
