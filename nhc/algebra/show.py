"""Nodes as one-line text, for messages and dumps."""

from __future__ import annotations

from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, NUM, PI, POW, SYM, Graph, Node
from nhc.algebra.reading import Reading

_PRIMES = {"velocity": "'", "acceleration": "''", "rate": "'"}
_SUM, _PRODUCT, _POWER, _ATOM = 1, 2, 3, 4


def to_text(graph: Graph, node: Node, longest: int = 400) -> str:
    """The node as an expression of the language; cut with an ellipsis beyond ``longest`` characters."""
    text = _write(Reading(graph), node, [longest * 4])[0]
    return text if len(text) <= longest else text[: longest - 1] + "…"


def _write(r: Reading, node: Node, budget: list[int]) -> tuple[str, int]:
    budget[0] -= 1
    if budget[0] < 0:
        return "…", _ATOM
    g = r.graph
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
    if op == ADD or (op == NEG and g.op[a] == ADD):
        return _write_sum(r, node, budget), _SUM
    if op == NEG:
        return "-" + _wrap(_write(r, a, budget), _PRODUCT), _SUM
    if op == MUL:
        return _write_product(r, node, budget)
    if op == POW:
        if b < 0:
            return "1/" + _wrap(_write_power(r, a, -b, budget), _POWER), _PRODUCT
        return _write_power(r, a, b, budget)
    if op == "powf":
        base, exponent = (_wrap(_write(r, c, budget), _ATOM) for c in g.children(node))
        return f"{base}^{exponent}", _POWER
    return f"{op}({', '.join(_write(r, c, budget)[0] for c in g.children(node))})", _ATOM


def _write_sum(r: Reading, node: Node, budget: list[int]) -> str:
    """The terms in reading order, a sign between two of them standing apart."""
    whole = ""
    for negative, term in r.terms(node):
        text = _wrap(_write(r, term, budget), _PRODUCT if negative else _SUM)
        if text.startswith("-"):
            negative, text = not negative, text[1:]
        sign = "-" if negative else "+"
        whole += f" {sign} {text}" if whole else text if sign == "+" else f"-{text}"
    return whole


def _write_power(r: Reading, base: Node, n: int, budget: list[int]) -> tuple[str, int]:
    written = _write(r, base, budget)
    return written if n == 1 else (f"{_wrap(written, _ATOM)}^{n}", _POWER)


def _write_product(r: Reading, node: Node, budget: list[int]) -> tuple[str, int]:
    """One fraction line, parameters first: ``3*a*(x + y)/(2*b)``."""
    g, number, over, under, stack = r.graph, Fraction(1), list[str](), list[str](), [node]
    constants = 0  # of those above the line
    while stack:
        part = stack.pop()
        if g.op[part] in (MUL, NEG):
            number = -number if g.op[part] == NEG else number
            stack += reversed(g.children(part))
        elif g.op[part] == NUM:
            value = g.value(part)
            assert value is not None
            number *= value
        elif g.op[part] == POW and g.b[part] < 0:
            under.append(_wrap(_write_power(r, g.a[part], -g.b[part], budget), _POWER))
        else:
            place = constants if _is_parameter(g, part) else len(over)
            constants += _is_parameter(g, part)
            over.insert(place, _wrap(_write(r, part, budget), _PRODUCT))
    above, below = abs(number).numerator, number.denominator
    over = [str(above), *over] if above != 1 or not over else over
    under = [str(below), *under] if below != 1 else under
    text = "*".join(over)
    if under:
        text += f"/{under[0]}" if len(under) == 1 else f"/({'*'.join(under)})"
    return (f"-{text}", _SUM) if number < 0 else (text, _PRODUCT)


def _is_parameter(graph: Graph, factor: Node) -> bool:
    symbol = graph.symbol_of(graph.a[factor] if graph.op[factor] == POW else factor)
    return symbol is not None and symbol.kind == "parameter"


def _wrap(written: tuple[str, int], least: int) -> str:
    text, level = written
    return text if level >= least else f"({text})"
