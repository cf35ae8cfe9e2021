"""Sums of products with what they have in common in front.

Assembled term by term, sum h_k W_k u_k multiplies by the same mass and the same speed at every term.  Factors that consist of
parameters only, and the speeds themselves, are cheap to recognise and are shared by many terms, so they are taken out of the sum.
They are taken off the outside of each factor of a product: what is left is a node that exists already, and nothing that other
expressions share is taken apart.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nhc.algebra.graph import MUL, NEG, POW, SYM, Graph, Node


def gather(graph: Graph, products: Iterable[Sequence[Node]], constants: int, speeds: int) -> Node:
    """The sum of the products; ``constants`` and ``speeds`` are masks of the symbols whose products are taken out."""
    g = graph
    if "gathered sums" in g.off:
        return g.sum(g.product(factors) for factors in products)
    by_speed: dict[Node, dict[Node, list[Node]]] = {}
    for factors in products:
        speed, constant, rest = g.one, g.one, g.one
        for factor in factors:
            own_speed, own_constant, left = split(g, factor, constants, speeds)
            speed, constant, rest = g.mul(speed, own_speed), g.mul(constant, own_constant), g.mul(rest, left)
        if rest != g.zero:
            by_speed.setdefault(speed, {}).setdefault(constant, []).append(rest)
    total = g.zero
    for speed, by_constant in by_speed.items():
        inner = g.sum(g.mul(constant, g.sum(rests)) for constant, rests in by_constant.items())
        total = g.add(total, g.mul(speed, inner))
    return total


def split(graph: Graph, factor: Node, constants: int, speeds: int) -> tuple[Node, Node, Node]:
    """(speeds, constants, rest) whose product is the factor; the rest is one of its own operands, or its negative."""
    g = graph
    speed, constant, rest, negative = g.one, g.one, factor, False
    while True:
        if g.op[rest] == NEG:
            rest, negative = g.a[rest], not negative
        elif rest == g.zero:
            break
        elif not g.deps[rest] & ~constants:
            constant, rest = g.mul(constant, rest), g.one
            break
        elif _is_speed(g, rest, speeds):
            speed, rest = g.mul(speed, rest), g.one
            break
        elif g.op[rest] == MUL:
            a, b = g.a[rest], g.b[rest]
            outer = next((x for x in (a, b) if not g.deps[x] & ~constants or _is_speed(g, x, speeds)), None)
            if outer is None:
                break
            rest = b if outer == a else a
            if g.deps[outer] & ~constants:
                speed = g.mul(speed, outer)
            else:
                constant = g.mul(constant, outer)
        else:
            break
    return speed, constant, g.neg(rest) if negative else rest


def _is_speed(graph: Graph, node: Node, speeds: int) -> bool:
    g = graph
    base = g.a[node] if g.op[node] == POW else node
    return g.op[base] == SYM and bool(g.deps[base] & speeds)
