"""Truncated Taylor series in several variables over the prime field.

``series[i][k]`` is the coefficient of s^k times the monomial number i of a :class:`Box`: of the variables d_0, d_1, ... each up
to a power of its own.  Sums and products are Cauchy's; a function f(u) has f' = f_u u' in every direction, which gives its
coefficients one by one (A. Griewank and A. Walther, Evaluating Derivatives, 2nd ed. (2008), sec. 13.2); powers have
u f' = n f u', so that they need no others.  Only the values at the point are :class:`~nhc.algebra.exact.field.FieldPoint`'s.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import product
from operator import mul

from nhc.algebra.calculus import partials
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.walks import reachable
from nhc.records import record

Series = list[list[int]]
"""Coefficients by the monomial of a box and the power of s."""

WIDTH = 20
"""Bytes of a coefficient of a sum of products: two residues of 61 bits, over powers, components and monomials."""

_SCALE, _KEEP, _FUNCTION = "scale", "keep", "function"


def close(graph: Graph, roots: Sequence[Node], mask: int) -> list[Node]:
    """What the series of the roots need: the nodes below them and the derivatives of their functions, operands first."""
    known = dict[Node, None]()
    pending = list(roots)
    while pending:
        new = reachable(graph, pending, known=known)
        known.update(dict.fromkeys(new))
        pending = [part for node in new if _is_function(graph, node, mask) for part in slopes(graph, node)]
    return reachable(graph, list(known))


def _is_function(graph: Graph, node: Node, mask: int) -> bool:
    return bool(graph.deps[node] & mask) and bool(graph.kids[node]) and graph.op[node] not in (ADD, MUL, NEG, POW)


def slopes(graph: Graph, node: Node) -> tuple[Node, ...]:
    """Derivatives of a function by its operands; those of x^y written with x^y itself, lest they never end."""
    if graph.op[node] != "powf":
        return partials(graph, node)
    x, y = graph.a[node], graph.b[node]
    growth = graph.zero if graph.value(y) is not None else graph.mul(node, graph.function("log", x))
    return graph.mul(graph.mul(y, node), graph.inverse(x)), growth


@record
class Box:
    """The monomials with exponents up to ``lengths``, the first one's running fastest.

    ``parts``: for each monomial the pairs of monomials whose product it is, itself and 1 first.  ``slopes``: its exponent e in the
    last variable that it has, and with each pair the one that the first of the two has in it: what belongs to it in f' is e f, and
    the exponents' weights give the rest of a product with a derivative.  ``places``: of the monomials in a number that stands for a
    polynomial, whose products are those of the polynomials (Kronecker 1882).
    """

    parts: tuple[tuple[tuple[int, int], ...], ...]
    slopes: tuple[tuple[int, tuple[tuple[int, int, int], ...]], ...]
    places: tuple[int, ...]

    def pack(self, residues: Sequence[int]) -> int:
        """The polynomial with these coefficients as a number."""
        text = bytearray(self.places[-1] + WIDTH)
        for place, x in zip(self.places, residues, strict=True):
            text[place : place + 8] = x.to_bytes(8, "little")
        return int.from_bytes(text, "little")

    def unpack(self, number: int) -> list[int]:
        """The coefficients of a sum of products."""
        text = number.to_bytes(max(self.places[-1] + WIDTH, (number.bit_length() + 7) // 8), "little")
        return [int.from_bytes(text[place : place + WIDTH], "little") for place in self.places]


@cache
def make_box(lengths: tuple[int, ...]) -> Box:
    """Tables of a box; without variables it has the monomial 1."""
    monomials = [tuple(reversed(m)) for m in product(*(range(length + 1) for length in reversed(lengths)))]
    number = {m: i for i, m in enumerate(monomials)}
    parts, slopes = [], []
    for whole in monomials:
        below = [tuple(reversed(m)) for m in product(*(range(e, -1, -1) for e in reversed(whole)))]
        pairs = [(number[m], number[tuple(e - x for e, x in zip(whole, m, strict=True))]) for m in below]
        last = max((v for v, e in enumerate(whole) if e), default=-1)
        weighted = [(m[last], *pair) for m, pair in zip(below, pairs, strict=True) if last >= 0 and m[last]]
        parts.append(tuple(pairs))
        slopes.append((whole[last] if last >= 0 else 0, tuple(weighted)))
    strides = [WIDTH]
    for length in lengths:
        strides.append(strides[-1] * (2 * length + 1))
    places = tuple(sum(map(mul, m, strides)) for m in monomials)
    return Box(tuple(parts), tuple(slopes), places)


@record
class JetPlan:
    """How the series of ``roots`` follow from those of the variables: what moves with these, operands first."""

    graph: Graph
    roots: tuple[Node, ...]
    variables: tuple[Node, ...]
    nodes: tuple[Node, ...]  # all that need a value at the point
    moving: tuple[tuple[str, Node, Node, Node], ...]  # operation, node, operands; a factor that is still comes first
    still: tuple[Node, ...]  # what does not move and is asked for nevertheless
    factors: tuple[Node, ...]  # what stands in products, powers and functions, and the powers themselves


def plan_jets(graph: Graph, roots: Sequence[Node], variables: Sequence[Node]) -> JetPlan:
    """Made once for all points and boxes."""
    mask, given = graph.mask(tuple(variables)), set(variables)
    nodes = close(graph, roots, mask)
    deps, moving = graph.deps, []
    asked, factors = dict.fromkeys(roots), dict[Node, None]()
    for node in nodes:
        if not deps[node] & mask or node in given:
            continue
        kind, a, b = graph.op[node], graph.a[node], graph.b[node]
        if kind in (ADD, MUL) and not deps[a] & mask:
            a, b = b, a
        if kind in (ADD, MUL) and not deps[b] & mask:
            kind, a, b = (_KEEP, a, a) if kind == ADD else (_SCALE, b, a)
        if _is_function(graph, node, mask):
            kind = _FUNCTION
            own = dict.fromkeys((*graph.kids[node], *slopes(graph, node)))
            asked |= own
            factors |= own
        elif kind == MUL:
            factors |= {a: None, b: None}
        elif kind == POW:
            factors |= {a: None, node: None}
        moving.append((kind, node, a, b))
    still = tuple(node for node in asked if not deps[node] & mask)
    return JetPlan(graph, tuple(roots), tuple(variables), tuple(nodes), tuple(moving), still, tuple(factors))


class Jets:
    """Series of a plan's nodes over a box; ``place`` are those of the variables, which may grow term by term."""

    def __init__(self, plan: JetPlan, point: FieldPoint, place: Sequence[Series], box: Box) -> None:
        self.plan, self.prime, self.box = plan, point.prime, box
        point.evaluate(plan.nodes)
        self.values = point.values
        sets = box.parts
        self.series: dict[Node, Series] = {node: [[] for _ in sets] for _, node, _, _ in plan.moving}
        self.series |= {node: [[] for _ in sets] for node in plan.still}
        self.series |= zip(plan.variables, place, strict=True)
        series = self.series
        self._work = [
            (kind, node, series[node], a, series.get(a, []), series.get(b, [])) for kind, node, a, b in plan.moving
        ]
        self.packed: dict[Node, list[int]] = {}
        self._reciprocals: dict[Node, int] = {}
        if len(sets) > 1:
            self.packed = {node: [] for node in plan.factors if node in series}

    def extend(self, k: int) -> None:
        """The coefficients of s^k, once those of lower powers are known and those of the variables reach so far.

        Raises:
            Unlucky: the point is a pole.
        """
        values, count = self.values, len(self.box.parts)
        for node in self.plan.still:
            for i in range(count):
                self.series[node][i].append(0 if k or i else values[node])
        for node in self.packed.keys() - {node for _, node, _, _ in self.plan.moving}:
            self.packed[node].append(self.box.pack([c[k] for c in self.series[node]]))
        if k and self.packed:
            self._extend_packed(k)
            return
        if not k:
            for _, node, made, *_ in self._work:
                made[0].append(values[node])
        for whole in range(0 if k else 1, count):
            self._extend_one(k, whole)
        for node, numbers in self.packed.items():
            if not numbers:
                numbers.append(self.box.pack([c[k] for c in self.series[node]]))

    def _extend_one(self, k: int, whole: int) -> None:
        """The coefficients of s^k times one monomial of the box."""
        p, values, pairs = self.prime, self.values, self.box.parts[whole]
        for kind, node, made, a, x, y in self._work:
            if kind == MUL:
                new = 0
                for i, j in pairs:
                    new += sum(map(mul, x[i], y[j][k::-1]))
            elif kind == ADD:
                new = x[whole][k] + y[whole][k]
            elif kind == _SCALE:
                new = values[a] * y[whole][k]
            elif kind == _KEEP:
                new = x[whole][k]
            elif kind == NEG:
                new = -x[whole][k]
            elif kind == POW:
                new = self._power(made, x, self.plan.graph.b[node], whole, k)
            else:
                new = self._function(node, whole, k)
            made[whole].append(new % p)

    def _extend_packed(self, k: int) -> None:
        """The same for k > 0, all monomials at once."""
        p, values, packed, unpack = self.prime, self.values, self.packed, self.box.unpack
        for (kind, node, made, a, x, y), (_, _, _, b) in zip(self._work, self.plan.moving, strict=True):
            if kind == MUL:
                new = unpack(sum(map(mul, packed[a], packed[b][k::-1])))
            elif kind == ADD:
                new = [u[k] + v[k] for u, v in zip(x, y, strict=True)]
            elif kind == _SCALE:
                factor = values[a]
                new = [factor * v[k] for v in y]
            elif kind == _KEEP:
                new = [u[k] for u in x]
            elif kind == NEG:
                new = [-u[k] for u in x]
            elif kind == POW:
                new = self._packed_power(node, a, self.plan.graph.b[node], k)
            else:
                new = self._packed_function(node, k)
            new = [c % p for c in new]
            for powers, c in zip(made, new, strict=True):
                powers.append(c)
            if node in packed:
                packed[node].append(self.box.pack(new))

    def _packed_function(self, node: Node, k: int) -> list[int]:
        graph, packed = self.plan.graph, self.packed
        pairs = zip(graph.kids[node], slopes(graph, node), strict=True)
        total = sum(_weighted(packed[child], packed[slope], k) for child, slope in pairs if child in packed)
        inverse = pow(k, -1, self.prime)
        return [c % self.prime * inverse for c in self.box.unpack(total)]

    def _packed_power(self, f: Node, u: Node, n: int, k: int) -> list[int]:
        p, packed, box = self.prime, self.packed, self.box
        if f not in self._reciprocals:
            first = [c[0] for c in self.series[u]]
            inverse = [pow(first[0], -1, p)]
            for pairs in box.parts[1:]:
                inverse.append(-inverse[0] * sum(first[i] * inverse[j] for i, j in pairs if j < len(inverse)) % p)
            self._reciprocals[f] = box.pack(inverse)
        gained = box.unpack(_weighted(packed[u], packed[f], k))
        lost = box.unpack(_weighted(packed[f], packed[u], k))
        scale = pow(k, -1, p)
        rest = [(n * x - y) % p * scale % p for x, y in zip(gained, lost, strict=True)]
        return box.unpack(box.pack(rest) * self._reciprocals[f])

    def _function(self, node: Node, whole: int, k: int) -> int:
        """f' = sum of f_u u', along s or, before it moves, along another variable."""
        graph, series = self.plan.graph, self.series
        exponent, weighted = self.box.slopes[whole]
        total = 0
        for child, slope in zip(graph.kids[node], slopes(graph, node), strict=True):
            u, v = series[child], series[slope]
            if k:
                total += sum(_weighted(u[i], v[j], k) for i, j in self.box.parts[whole])
            else:
                total += sum(e * u[i][0] * v[j][0] for e, i, j in weighted)
        return total * pow(k or exponent, -1, self.prime)

    def _power(self, f: Series, u: Series, n: int, whole: int, k: int) -> int:
        """f = u^n by u f' = n f u'."""
        p, known = self.prime, 0
        if not u[0][0]:
            raise Unlucky
        f[whole].append(0)  # in the place of the one that is looked for
        exponent, weighted = self.box.slopes[whole]
        if k:
            for i, j in self.box.parts[whole]:
                known += n * _weighted(u[i], f[j], k) - _weighted(f[i], u[j], k)
        else:
            known = sum(e * (n * u[i][0] * f[j][0] - f[i][0] * u[j][0]) for e, i, j in weighted)
        f[whole].pop()
        return known * pow((k or exponent) * u[0][0], -1, p)


def _weighted(u: Sequence[int], v: Sequence[int], k: int) -> int:
    """sum of j u_j v_{k-j} for j from 1 to k, or as far as u is known."""
    return sum(map(mul, map(mul, range(1, k + 1), u[1 : k + 1]), v[k - 1 :: -1]))
