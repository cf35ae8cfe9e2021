"""A constraint is an equation up to a factor that vanishes nowhere: what moving axes look at is the row without it.

Numbers and parameters in front of a row, also in front of each of its terms, and denominators under all of them say nothing
about the motion.  They count only where the constraints' own values do: in the reactions.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.parts import split_powers
from nhc.mechanics.rotations.directions import along_direction
from nhc.records import record

Product = tuple[Fraction, dict[Node, int]]
"""A number and powers of factors."""
_MANY = 12  # terms beyond which a row is not a component along a direction


@record
class Bare:
    """A row is ``factor`` times ``row``; ``divisors`` are what must not vanish for both to say the same."""

    row: Node
    factor: Node
    divisors: tuple[Node, ...] = ()


def strip_factor(graph: Graph, row: Node, constants: int, velocities: Collection[Node] = ()) -> Bare:
    """The row without what consists of the symbols of ``constants`` in front of it, or of each of its terms.

    Denominators that move go where the rest is a component of a velocity: one of ``velocities``, or of a position that nhc
    differentiated.
    """
    g, factor, divisors, body, negative = graph, graph.one, list[Node](), row, False
    while g.op[body] in (NEG, MUL):
        coefficient, core = g.split_coefficient(body)
        if g.op[body] == NEG:
            body, negative = g.a[body], not negative
        elif core != body:
            body, factor = core, g.mul(factor, g.number(coefficient))
        else:
            a, b = g.a[body], g.b[body]
            own = next((x for x in (a, b) if not g.deps[x] & ~constants), None)
            if own is None:
                break
            body, factor = b if own == a else a, g.mul(factor, own)
            divisors += [own] if _may_vanish(g, own) else []
    inner = _strip_terms(g, body, constants, velocities)
    if inner is not None:
        body, factor = inner.row, g.mul(factor, inner.factor)
        divisors += inner.divisors
    if factor == g.one:
        return Bare(row, g.one)
    return Bare(g.neg(body) if negative else body, factor, tuple(divisors))


def _may_vanish(graph: Graph, node: Node) -> bool:
    return not (graph.op[node] == POW and graph.b[node] < 0) and graph.value(node) is None


def _strip_terms(graph: Graph, row: Node, constants: int, velocities: Collection[Node]) -> Bare | None:
    """The same for a sum whose terms have factors in common."""
    g, split = graph, [_powers(graph, term, sign) for sign, term in _terms(graph, row)]
    if not 2 <= len(split) <= _MANY:
        return None
    own = sum(any(base in velocities or base in g.rate_of for base in powers) for _, powers in split)
    made = _take_out(g, split, constants, moving=own == 2 and bool(velocities))  # two components of one velocity
    if made is None:
        return None
    number, shared, rest = made
    body = g.sum(rest)
    if any(g.deps[base] & ~constants for base in shared) and not _is_component(g, body, velocities):
        return None  # in other rows denominators may be what is short
    divisors = tuple(base for base, n in shared.items() if n > 0)
    return Bare(body, g.mul(g.number(number), _product(g, shared)), divisors)


def without_common(graph: Graph, nodes: Sequence[Node], constants: int) -> list[Node]:
    """The nodes, products of a row, without the numbers and the parameters that all of them have in front."""
    split = [_powers(graph, node) for node in nodes if node != graph.zero]
    made = _take_out(graph, split, constants) if split else None
    if made is None:
        return list(nodes)
    left = iter(made[2])
    return [next(left) if node != graph.zero else node for node in nodes]


def common_parameters(graph: Graph, nodes: Sequence[Node], constants: int) -> list[Node]:
    """The parameters that :func:`without_common` takes away and that may vanish: nothing holds a row then."""
    split = [_powers(graph, node) for node in nodes if node != graph.zero]
    made = _take_out(graph, split, constants) if split else None
    return [] if made is None else [base for base, n in made[1].items() if n > 0 and graph.value(base) is None]


def _take_out(
    graph: Graph, products: Sequence[Product], constants: int, *, moving: bool = False
) -> tuple[Fraction, dict[Node, int], list[Node]] | None:
    """A number and powers of parameters that all the products have, and what is left of them; None where they have nothing in
    common.  Denominators of some are taken for those of all, with ``moving`` also those that are no parameters.
    """
    g, shared = graph, dict[Node, int]()
    for base in dict.fromkeys(base for _, powers in products for base in powers):
        least = min(powers.get(base, 0) for _, powers in products)
        if least and (not g.deps[base] & ~constants or (least < 0 and moving)):
            shared[base] = least
    size = abs(products[0][0])
    number = size if all(abs(own) == size for own, _ in products) else Fraction(1)
    if not shared and number == 1:
        return None
    rest = []
    for own, powers in products:
        left = {base: n for base in {**powers, **shared} if (n := powers.get(base, 0) - shared.get(base, 0))}
        rest.append(g.mul(g.number(own / number), _product(g, left)))
    return number, shared, rest


def _terms(graph: Graph, row: Node) -> list[tuple[int, Node]]:
    """The terms of a sum and their signs: no node is made for a row that has no factor."""
    g, found, stack = graph, list[tuple[int, Node]](), [(1, row)]
    while stack:
        sign, node = stack.pop()
        if g.op[node] == NEG:
            stack.append((-sign, g.a[node]))
        elif g.op[node] == ADD and node not in g.rate_of:
            stack += [(sign, g.b[node]), (sign, g.a[node])]
        else:
            found.append((sign, node))
    return found


def _is_component(graph: Graph, row: Node, velocities: Collection[Node]) -> bool:
    """Whether it is the component along a direction of what the spec has as a velocity."""
    sided = along_direction(graph, row)
    if sided is None:
        return False
    own = (graph.a[node] if graph.op[node] == NEG else node for node in (sided.c, sided.s))
    return all(node in velocities or node in graph.rate_of for node in own)


def _powers(graph: Graph, term: Node, sign: int = 1) -> Product:
    number, powers = split_powers(graph, term)
    return Fraction(sign * number), powers


def _product(graph: Graph, powers: dict[Node, int]) -> Node:
    return graph.product([graph.power(base, n) for base, n in powers.items()])
