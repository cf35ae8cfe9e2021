"""Random expressions as trees, built with the graph's rules and without them, and evaluated without any graph."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
from hypothesis import settings
from hypothesis import strategies as st

from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node

Tree = tuple[Any, ...]
NAMES = ("x", "y", "z")
QUIET = settings(deadline=None, derandomize=True, database=None, max_examples=60)

numbers = st.builds(lambda a, b: ("num", Fraction(a, b)), st.integers(-4, 4), st.integers(1, 4))
symbols = st.builds(lambda k: ("sym", k), st.integers(0, 2))
leaves = st.one_of(symbols, symbols, numbers)


def _algebraic(inner: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
    pair = st.tuples(st.sampled_from(["+", "-", "*", "*"]), inner, inner)
    return st.one_of(
        pair, st.tuples(st.just("neg"), inner), st.tuples(st.just("pow"), inner, st.sampled_from([-2, -1, 2, 3]))
    )


def _smooth(inner: st.SearchStrategy[Tree]) -> st.SearchStrategy[Tree]:
    """With functions defined everywhere: sqrt of 1 + u^2, reciprocals of 2 + u^2."""
    one, two = ("num", Fraction(1)), ("num", Fraction(2))
    square = inner.map(lambda u: ("pow", u, 2))
    return st.one_of(
        st.tuples(st.sampled_from(["+", "-", "*", "*"]), inner, inner),
        st.tuples(st.sampled_from(["sin", "cos", "tanh", "atan", "neg", "sin", "cos"]), inner),
        square,
        square.map(lambda u: ("sqrt", ("+", one, u))),
        square.map(lambda u: ("pow", ("+", two, u), -1)),
        inner.map(lambda u: ("exp", ("sin", u))),
    )


rational_trees = st.recursive(leaves, _algebraic, max_leaves=10)
smooth_trees = st.recursive(leaves, _smooth, max_leaves=8)


def build(g: Graph, tree: Tree) -> Node:
    """By the graph's own methods, with all their rules."""
    kind, *rest = tree
    if kind == "num":
        return g.number(rest[0])
    if kind == "sym":
        return g.symbol(NAMES[rest[0]])
    if kind == "pi":
        return g.pi()
    if kind == "pow":
        return g.power(build(g, rest[0]), rest[1])
    parts = [build(g, part) for part in rest]
    known = {"+": g.add, "-": g.sub, "*": g.mul, "/": g.div, "neg": g.neg}
    return known[kind](*parts) if kind in known else g.function(kind, *parts)


def build_raw(g: Graph, tree: Tree) -> Node:
    """Node by node, without a rule."""
    kind, *rest = tree
    if kind in ("num", "sym", "pi"):
        return build(g, tree)
    if kind == "pow":
        inner = build_raw(g, rest[0])
        return g.raw(POW, inner, rest[1])
    if kind == "-":
        return build_raw(g, ("+", rest[0], ("neg", rest[1])))
    if kind == "/":
        return build_raw(g, ("*", rest[0], ("pow", rest[1], -1)))
    if kind == "tan":
        return build_raw(g, ("/", ("sin", rest[0]), ("cos", rest[0])))
    parts = [build_raw(g, part) for part in rest]
    deps = g.mask(parts)
    op = {"+": ADD, "*": MUL, "neg": NEG}.get(kind, kind)
    return g._make(op, parts[0], parts[1] if len(parts) > 1 else 0, deps)


def value(tree: Tree, point: tuple[Any, ...], number: Any = lambda q: q) -> Any:
    """By the arithmetic of the point's own type: Fraction, or mpmath (then ``number`` converts rationals)."""
    kind, *rest = tree
    if kind == "num":
        return number(rest[0])
    if kind == "sym":
        return point[rest[0]]
    if kind == "pi":
        return +mpmath.pi
    if kind == "pow":
        return value(rest[0], point, number) ** rest[1]
    parts = [value(part, point, number) for part in rest]
    if kind in ("+", "-", "*", "/"):
        x, y = parts
        return x + y if kind == "+" else x - y if kind == "-" else x * y if kind == "*" else x / y
    if kind == "neg":
        return -parts[0]
    if kind == "powf":
        return parts[0] ** parts[1]
    plain = {"abs": abs, "min": min, "max": max, "sign": mpmath.sign}
    return plain.get(kind, getattr(mpmath, kind, None))(*parts)


def to_mpf(q: Fraction) -> Any:
    return mpmath.mpf(q.numerator) / q.denominator
