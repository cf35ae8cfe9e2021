"""Sums of products with what they have in common in front.

Assembled term by term, sum h_k W_k u_k multiplies by the same mass and the same speed at every term.  Factors that consist of
parameters only, and the speeds themselves, are cheap to recognise and are shared by many terms, so they are taken out of the sum;
the rest of a product stays the node that it is, so that nothing that other expressions share is taken apart.
"""

from __future__ import annotations

from collections.abc import Iterable

from nhc.algebra.graph import MUL, NEG, POW, SYM, Graph, Node


def gather(graph: Graph, terms: Iterable[Node], constants: int, speeds: int) -> Node:
    """The sum of the terms; ``constants`` and ``speeds`` are masks of the symbols whose products are taken out."""
    g = graph
    by_speed: dict[Node, dict[Node, list[Node]]] = {}
    for term in terms:
        if term == g.zero:
            continue
        speed, constant, rest = split(g, term, constants, speeds)
        by_speed.setdefault(speed, {}).setdefault(constant, []).append(rest)
    total = g.zero
    for speed, by_constant in by_speed.items():
        inner = g.sum(g.mul(constant, g.sum(rests)) for constant, rests in by_constant.items())
        total = g.add(total, g.mul(speed, inner))
    return total


def split(graph: Graph, term: Node, constants: int, speeds: int) -> tuple[Node, Node, Node]:
    """(speeds, constants, rest) whose product is the term."""
    g = graph
    speed, constant, rest = g.one, g.one, g.one
    stack, negative = [term], False
    while stack:
        node = stack.pop()
        if g.op[node] == NEG:
            negative = not negative
            stack.append(g.a[node])
        elif not g.deps[node] & ~constants:
            constant = g.mul(constant, node)
        elif _is_speed(g, node, speeds):
            speed = g.mul(speed, node)
        elif g.op[node] == MUL and g.deps[node] & (constants | speeds):
            stack += [g.b[node], g.a[node]]
        else:
            rest = g.mul(rest, node)
    return speed, constant, g.neg(rest) if negative else rest


def _is_speed(graph: Graph, node: Node, speeds: int) -> bool:
    g = graph
    base = g.a[node] if g.op[node] == POW else node
    return g.op[base] == SYM and bool(g.deps[base] & speeds)
