"""Expressions of one graph on another, with what stands there for the symbols."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.graph import ADD, MUL, NEG, NUM, PI, POW, Graph, Node
from nhc.algebra.walks import reachable


def carry(source: Graph, target: Graph, roots: Sequence[Node], meaning: Mapping[Node, Node]) -> list[Node]:
    """The roots as nodes of ``target``; ``meaning`` gives every symbol of ``source`` that they hold a node there.

    The rules of the graph are applied anew, so what is equal to something on the target is likely to be the same node.

    Raises:
        ZeroDivisionError: a divisor is zero with these meanings.
    """
    made = dict(meaning)
    for node in reachable(source, roots):
        if node in made:
            continue
        op, kids = source.op[node], [made[kid] for kid in source.kids[node]]
        if op == NUM:
            value = source.value(node)
            assert value is not None
            made[node] = target.number(value.numerator if value.denominator == 1 else value)
        elif op == PI:
            made[node] = target.pi()
        elif op == ADD:
            made[node] = target.add(*kids)
        elif op == MUL:
            made[node] = target.mul(*kids)
        elif op == NEG:
            made[node] = target.neg(*kids)
        elif op == POW:
            made[node] = target.power(kids[0], source.b[node])
        else:
            made[node] = target.function(op, *kids)
    return [made[root] for root in roots]
