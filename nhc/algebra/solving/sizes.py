"""How large expressions can be: what determinants and pivots are measured against."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, POW, SYM, Graph, Node
from nhc.algebra.parts import list_factors
from nhc.algebra.polynomial import normalise
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.walks import reachable

_FEW_TERMS = 12


def row_scale(graph: Graph, block: Sequence[Sequence[Node]]) -> Node:
    """Product over the rows of how large their entries can be: what a determinant is measured against."""
    sums = [graph.sum([size_of(graph, entry) for entry in row]) for row in block]
    return graph.product(shorten(graph, sums))


def form_size(graph: Graph, row: Node, unknowns: int) -> Node | None:
    """The sum of the sizes of the coefficients of a row that is linear in the symbols of a mask; None where it is not by sight.

    It is found on the row's own nodes, so that what rows share is measured once.
    """
    g = graph
    known: dict[Node, Node] = g.memory.setdefault(f"sizes of forms {unknowns:x}", {})
    pending = [node for node in reachable(g, [row], unknowns) if node not in known]
    for node in pending:
        op, moving = g.op[node], [c for c in g.kids[node] if g.deps[c] & unknowns]
        if op == SYM:
            known[node] = g.one
        elif op == NEG or (op == ADD and len(moving) == 1):
            known[node] = known[moving[0]]
        elif op == ADD:
            known[node] = normalise(g, g.add(known[moving[0]], known[moving[1]]), _FEW_TERMS)
        elif op == MUL and len(moving) == 1:
            still = g.a[node] if moving[0] == g.b[node] else g.b[node]
            known[node] = g.mul(known[moving[0]], size_of(g, still))
        else:
            return None
    return known.get(row, g.zero)


def size_of(graph: Graph, root: Node) -> Node:
    """A bound on |root| that does not vanish with it: sines and cosines count 1, differences count as sums.

    A component over the length of its vector, x/sqrt(x^2 + y^2), counts 1 as well.
    """
    size = _sizes(graph)
    if root in size:
        return size[root]
    for node in reachable(graph, [root]):
        if node in size:
            continue
        op, a, b = graph.op[node], graph.a[node], graph.b[node]
        rest = _unit_component(graph, node) if op == MUL else None
        if rest is not None:
            size[node] = graph.product([size[x] for x in rest])
        elif op == ADD:
            size[node] = graph.add(size[a], size[b])
        elif op == MUL:
            size[node] = graph.mul(size[a], size[b])
        elif op == NEG:
            size[node] = size[a]
        elif op == POW and b > 0:
            base = size[a]
            size[node] = graph.power(graph.a[base] if b % 2 == 0 and graph.op[base] == "abs" else base, b)
        elif op in ("sin", "cos"):
            size[node] = graph.one
        else:
            size[node] = graph.function("abs", node)
    return size[root]


def know_size(graph: Graph, node: Node, bound: int) -> None:
    """|node| <= ``bound``, whatever its terms add up to: an entry of a rotation's matrix is at most 1."""
    factor, core = graph.split_coefficient(node)
    size = _sizes(graph)
    size[node], size[core] = graph.number(bound), graph.number(abs(bound / Fraction(factor)))


def _sizes(graph: Graph) -> dict[Node, Node]:
    known: dict[Node, Node] = graph.memory.setdefault("sizes", {})
    return known


def _unit_component(graph: Graph, node: Node) -> list[Node] | None:
    """The other factors of a product that holds x and 1/sqrt(x^2 + ...)."""
    g, factors = graph, list_factors(graph, node)
    for length in factors:
        if g.op[length] != POW or g.b[length] != -1 or g.op[g.a[length]] != "sqrt":
            continue
        squares, terms = set[Node](), [g.a[g.a[length]]]
        while terms:
            top = terms.pop()
            if g.op[top] == ADD:
                terms += [g.a[top], g.b[top]]
            elif g.op[top] == POW and g.b[top] == 2:
                squares.add(g.a[top])
        for x in factors:
            if x in squares:
                left = list(factors)
                left.remove(x)
                left.remove(length)
                return left
        inner = _as_one_factor(g, factors, squares)
        if inner is not None:
            left = list(factors)
            for x in (*inner, length):
                left.remove(x)
            return left
    return None


def _as_one_factor(graph: Graph, factors: Sequence[Node], squares: set[Node]) -> tuple[Node, Node] | None:
    """Two factors whose product is one of the squared nodes."""
    for k, x in enumerate(factors):
        for y in factors[k + 1 :]:
            if graph.mul(x, y) in squares:
                return x, y
    return None
