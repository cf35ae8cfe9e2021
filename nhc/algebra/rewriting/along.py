"""Forces along what they share: a spring and a damper between two points pull together, k (A d) + F d = (k A + F) d.

The slope of a potential has its stiffness in front of all of its terms, and each force without a potential stands by itself: every
component of a direction d would be multiplied for both.  The sum in front of d is the same for all components.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from nhc.algebra.graph import ADD, MUL, NEG, Graph, Node
from nhc.records import record

_MOST_TERMS = 64


@record
class _Term:
    """A term of a sum: its sign, factors of parameters in front of it, and what is left."""

    negative: bool
    constants: tuple[Node, ...]
    rest: Node


def add_along(graph: Graph, slope: Node, force: Node, constants: int) -> Node | None:
    """slope + force with the moving factors in front along which both have terms; None where there are none.

    ``constants`` is the mask of the parameters.
    """
    pulls, pushes = _list_terms(graph, slope, constants), _list_terms(graph, force, constants)
    shared = _list_factors(graph, pulls, constants) & _list_factors(graph, pushes, constants)
    if not shared or max(len(pulls), len(pushes)) > _MOST_TERMS or "gathered sums" in graph.off:
        return None
    along: dict[Node, Node] = {}
    left = [*_take_along(graph, pulls, shared, along), *_take_along(graph, pushes, shared, along)]
    inner: dict[tuple[Node, ...], Node] = {}
    for term in left:
        total, part = inner.get(term.constants, graph.zero), term.rest
        inner[term.constants] = graph.sub(total, part) if term.negative else graph.add(total, part)
    total = graph.sum(graph.mul(graph.product(front), node) for front, node in inner.items())
    return graph.add(total, graph.sum(graph.mul(size, factor) for factor, size in along.items()))


def _list_terms(graph: Graph, node: Node, constants: int) -> list[_Term]:
    """The terms of a sum, also of sums that parameters stand in front of.  No node is made."""
    op, a, b, deps = graph.op, graph.a, graph.b, graph.deps
    found, stack = list[_Term](), [_Term(False, (), node)]
    while stack:
        term = stack.pop()
        top = term.rest
        if op[top] == NEG:
            stack.append(_Term(not term.negative, term.constants, a[top]))
        elif op[top] == ADD:
            stack += [_Term(term.negative, term.constants, kid) for kid in (b[top], a[top])]
        elif op[top] == MUL and not (deps[a[top]] & ~constants and deps[b[top]] & ~constants):
            front, rest = (a[top], b[top]) if deps[b[top]] & ~constants else (b[top], a[top])
            stack.append(_Term(term.negative, (*term.constants, front), rest))
            if not deps[rest] & ~constants:
                found.append(stack.pop())
        elif top != graph.zero:
            found.append(term)
    return found


def _list_factors(graph: Graph, terms: Iterable[_Term], constants: int) -> set[Node]:
    """The moving factors, no symbols, of those terms that are products of two."""
    kids, deps = graph.kids, graph.deps
    own = (kid for term in terms if graph.op[term.rest] == MUL for kid in kids[term.rest])
    return {kid for kid in own if kids[kid] and deps[kid] & ~constants}


def _take_along(graph: Graph, terms: Iterable[_Term], shared: set[Node], along: dict[Node, Node]) -> Iterator[_Term]:
    """Adds to ``along`` what stands in front of each shared factor; the other terms are returned."""
    for term in terms:
        pair = graph.kids[term.rest] if graph.op[term.rest] == MUL else ()
        factor = next((kid for kid in pair if kid in shared), None)
        if factor is None:
            yield term
            continue
        rest = pair[1] if factor == pair[0] else pair[0]
        size = graph.product((*term.constants, rest))
        along[factor] = graph.add(along.get(factor, graph.zero), graph.neg(size) if term.negative else size)
