"""Nodes as one-line text, for messages and dumps."""

from __future__ import annotations

from nhc.algebra.graph import ADD, MUL, NEG, NUM, PI, POW, SYM, Graph, Node

_PRIMES = {"velocity": "'", "acceleration": "''", "rate": "'"}
_SUM, _PRODUCT, _POWER, _ATOM = 1, 2, 3, 4


def to_text(graph: Graph, node: Node, longest: int = 400) -> str:
    """The node as an expression of the language; cut with an ellipsis beyond ``longest`` characters."""
    text = _write(graph, node, [longest * 4])[0]
    return text if len(text) <= longest else text[: longest - 1] + "…"


def _write(g: Graph, node: Node, budget: list[int]) -> tuple[str, int]:
    budget[0] -= 1
    if budget[0] < 0:
        return "…", _ATOM
    op, a, b = g.op[node], g.a[node], g.b[node]
    if op == NUM:
        value = g.value(node)
        assert value is not None
        return str(value), _ATOM if value >= 0 and value.denominator == 1 else _PRODUCT if value >= 0 else _SUM
    if op == SYM:
        symbol = g.symbols[a]
        return symbol.name + _PRIMES.get(symbol.kind, ""), _ATOM
    if op == PI:
        return "pi", _ATOM
    if op == NEG:
        return "-" + _wrap(_write(g, a, budget), _PRODUCT), _SUM
    if op == ADD:
        left = _wrap(_write(g, a, budget), _SUM)
        if g.op[b] == NEG:
            return f"{left} - {_wrap(_write(g, g.a[b], budget), _PRODUCT)}", _SUM
        return f"{left} + {_wrap(_write(g, b, budget), _SUM)}", _SUM
    if op == MUL:
        return _write_product(g, a, b, budget)
    if op == POW:
        if b < 0:
            return "1/" + _wrap(_write_power(g, a, -b, budget), _POWER), _PRODUCT
        return _write_power(g, a, b, budget)
    inner = ", ".join(_write(g, c, budget)[0] for c in g.children(node))
    return f"{'pow' if op == 'powf' else op}({inner})", _ATOM


def _write_power(g: Graph, base: Node, n: int, budget: list[int]) -> tuple[str, int]:
    written = _write(g, base, budget)
    return written if n == 1 else (f"{_wrap(written, _ATOM)}^{n}", _POWER)


def _write_product(g: Graph, a: Node, b: Node, budget: list[int]) -> tuple[str, int]:
    for x, y in ((a, b), (b, a)):
        if g.op[y] == POW and g.b[y] < 0:
            top = _wrap(_write(g, x, budget), _PRODUCT)
            return f"{top}/{_wrap(_write_power(g, g.a[y], -g.b[y], budget), _POWER)}", _PRODUCT
    return f"{_wrap(_write(g, a, budget), _PRODUCT)}*{_wrap(_write(g, b, budget), _PRODUCT)}", _PRODUCT


def _wrap(written: tuple[str, int], least: int) -> str:
    text, level = written
    return text if level >= least else f"({text})"
