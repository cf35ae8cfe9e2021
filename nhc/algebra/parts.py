"""Sums and products taken apart: terms, factors and their powers, the factor made of parameters."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, Graph, Node
from nhc.algebra.nodes import Rational
from nhc.algebra.walks import reachable
from nhc.records import fresh, record

_ONE = Fraction(1)
_FEW_FACTORS = 8


@record
class Factor:
    """``number`` times the product of nodes to integer powers."""

    number: Fraction = _ONE
    powers: Mapping[Node, int] = fresh(factory=dict)

    def node(self, graph: Graph) -> Node:
        """The factor as a node; equal factors are one node."""
        product = graph.product([graph.power(base, n) for base, n in sorted(self.powers.items()) if n])
        return graph.mul(graph.number(self.number), product)

    def divisible_by(self, other: Factor, times: int = 1) -> bool:
        """Whether no symbol stands in a denominator after division by ``other ** times`` that did not before."""
        return all(self.powers.get(base, 0) >= n * times for base, n in other.powers.items() if n > 0)


def common(factors: Sequence[Factor]) -> Factor:
    """The largest product of positive powers in all of them, with their number where they share it."""
    if not factors:
        return Factor()
    first = factors[0]
    powers = {base: min(m.powers.get(base, 0) for m in factors) for base in first.powers}
    number = abs(first.number)
    shared = number if all(abs(m.number) == number for m in factors) else _ONE
    return Factor(shared, {base: n for base, n in powers.items() if n > 0})


def take_out_common(graph: Graph, nodes: Sequence[Node]) -> tuple[Node, list[Node]]:
    """The factor that all nodes but zeros have, of parameters or not, and the nodes without it."""
    g, every = graph, -1
    split = [split_parameters(g, node, every) for node in nodes]
    shared = common([factor for factor, sign in split if sign != g.zero])
    left = list[Node]()
    for factor, sign in split:
        powers = {base: n - shared.powers.get(base, 0) for base, n in factor.powers.items()}
        left.append(g.mul(sign, Factor(factor.number / shared.number, powers).node(g)))
    return shared.node(g), left


def list_terms(graph: Graph, node: Node, whole: Collection[Node] = ()) -> list[Node]:
    """The terms of a sum with their signs, from left to right; sums in ``whole`` are terms themselves, and zero has none."""
    g, found = graph, list[Node]()
    stack = [(node, False)]
    while stack:
        top, negative = stack.pop()
        if g.op[top] == NEG:
            stack.append((g.a[top], not negative))
        elif g.op[top] == ADD and not (whole and (g.neg(top) if negative else top) in whole):
            stack += [(g.b[top], negative), (g.a[top], negative)]
        elif top != g.zero:
            found.append(g.neg(top) if negative else top)
    return found


def list_factors(graph: Graph, node: Node) -> list[Node]:
    """The factors of a product from left to right, -1 for its sign at the end; of many, the last ones stay together."""
    g, found, stack, negative = graph, list[Node](), [node], False
    while stack:
        top = stack.pop()
        if g.op[top] == NEG:
            negative = not negative
            stack.append(g.a[top])
        elif g.op[top] == MUL and len(found) + len(stack) < _FEW_FACTORS:
            stack += [g.b[top], g.a[top]]
        else:
            found.append(top)
    return [*found, g.number(-1)] if negative else found


def split_powers(graph: Graph, term: Node) -> tuple[Rational, dict[Node, int]]:
    """A product as its number and the powers of its factors, from left to right; sums are factors, also under powers."""
    number: Rational = 1
    powers, stack = dict[Node, int](), [term]
    while stack:
        coefficient, core = graph.split_coefficient(stack.pop())
        number *= coefficient
        if core == graph.one:
            continue
        if graph.op[core] == MUL:
            stack += [graph.b[core], graph.a[core]]
        else:
            base, n = (graph.a[core], graph.b[core]) if graph.op[core] == POW else (core, 1)
            powers[base] = powers.get(base, 0) + n
    return number, powers


def split_parameters(graph: Graph, node: Node, mask: int) -> tuple[Factor, Node]:
    """(positive factor of what consists of the symbols of ``mask``, all other factors with the sign)."""
    number, powers = _ONE, dict[Node, int]()
    rest: list[Node] = []
    stack = [(node, 1)]
    while stack:
        part, n = stack.pop()
        op = graph.op[part]
        if op == NEG:
            number = -number if n % 2 else number
            stack.append((graph.a[part], n))
        elif op == MUL:
            stack += [(graph.b[part], n), (graph.a[part], n)]
        elif op == POW:
            stack.append((graph.a[part], n * graph.b[part]))
        elif op == NUM and graph.value(part) != 0:
            number *= Fraction(graph.value(part) or 1) ** n
        elif graph.deps[part] and not graph.deps[part] & ~mask:
            powers[part] = powers.get(part, 0) + n
        else:
            rest.append(graph.power(part, n))
    product = graph.product(sorted(rest))
    return Factor(abs(number), powers), graph.neg(product) if number < 0 else product


def tidy(graph: Graph, node: Node, mask: int) -> Node:
    """The product with its parameters gathered in one factor."""
    factor, rest = split_parameters(graph, node, mask)
    return graph.mul(factor.node(graph), rest)


def sum_products(graph: Graph, terms: Iterable[Node], mask: int) -> Node:
    """The sum of the terms, those with the same parameters in front together."""
    parts: dict[Node, Node] = {}
    for term in terms:
        outer, rest = _outer_parameters(graph, term, mask)
        parts[outer] = graph.add(parts.get(outer, graph.zero), rest)
    return graph.sum(graph.mul(outer, rest) for outer, rest in parts.items())


def _outer_parameters(graph: Graph, term: Node, mask: int) -> tuple[Node, Node]:
    """(parameters, rest) of a product; factors without parameters stay the nodes that they are."""
    outer, rest, stack, negative = graph.one, graph.one, [term], False
    while stack:
        node = stack.pop()
        if graph.op[node] == NEG:
            negative = not negative
            stack.append(graph.a[node])
        elif not graph.deps[node] & ~mask:
            outer = graph.mul(outer, node)
        elif graph.op[node] == MUL and graph.deps[node] & mask:
            stack += [graph.b[node], graph.a[node]]
        else:
            rest = graph.mul(rest, node)
    return tidy(graph, outer, mask), graph.neg(rest) if negative else rest


def divisors_in(graph: Graph, nodes: Sequence[Node]) -> set[Node]:
    """The factors of all that stands below a fraction line, apart from numbers."""
    below = (graph.a[node] for node in reachable(graph, nodes) if graph.op[node] == POW and graph.b[node] < 0)
    return {base for node in below for base in split_powers(graph, node)[1]}
