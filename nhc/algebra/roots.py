"""Roots where their arguments are zero: products and slopes that are 0 there, and would be 0/0 factor by factor."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

from nhc.algebra.nodes import Node, exact_power

if TYPE_CHECKING:
    from nhc.algebra.graph import Graph


def join_root(g: Graph, x: Node, m: int, y: Node, n: int) -> Node | None:
    """x^m * sqrt(k x)^n, in either order, as one power of the root; None where neither is the other's root.

    x^2/sqrt(x) would be 0/0 at x = 0, where sqrt(x)^3 is 0.  So is max(0, u)^2/sqrt(|u|), which is sqrt(max(0, u))^3 everywhere.
    """
    if g.op[x] == "sqrt":
        x, m, y, n = y, n, x, m
    if g.op[y] != "sqrt":
        return None
    inner = g.a[y]
    if g.core[inner] == x:
        return g.mul_number(exact_power(Fraction(g.coefficient[inner]), -m), g.power(y, 2 * m + n))
    if m > 0 and 2 * m + n > 0 and size_of_part(g, x) == inner:
        return g.power(g.function("sqrt", x), 2 * m + n)
    return None


def size_of_part(g: Graph, x: Node) -> Node | None:
    """|u| where x = max(0, u), else None.

    Slopes that are infinite at x = 0 are taken at |u|: the same where u > 0, and finite where u < 0, so that the slope of max,
    which is 0 there, makes them 0.
    """
    if g.op[x] != "max" or g.zero not in g.kids[x]:
        return None
    first, second = g.kids[x]
    return g.function("abs", second if first == g.zero else first)
