"""Syntax trees back to text."""

from __future__ import annotations

from fractions import Fraction

from nhc.language.expressions.syntax import Binary, Call, Differential, Name, Negate, Number, Prime, Syntax, fold_tree

_LEVEL = {"+": 10, "-": 10, "*": 20, "/": 20, "^": 40}
_NEGATE, _WHOLE = 30, 100
_LONG = 17  # digits from which a number is written with an exponent


def show_number(value: Fraction) -> str:
    """Return a number's shortest exact text: ``3``, ``0.25``, ``1e-30``; ``1/3`` where no decimal is exact."""
    sign = "-" if value < 0 else ""
    value = abs(value)
    rest, twos, fives = value.denominator, 0, 0
    while rest % 2 == 0:
        rest, twos = rest // 2, twos + 1
    while rest % 5 == 0:
        rest, fives = rest // 5, fives + 1
    if rest != 1:
        return f"{sign}{value.numerator}/{value.denominator}"
    places = max(twos, fives)
    digits = str(value.numerator * 2 ** (places - twos) * 5 ** (places - fives))
    short = digits.rstrip("0") or "0"
    if places == 0 and len(digits) <= _LONG:
        return sign + digits
    if places == 0 or places > _LONG:
        return f"{sign}{short}e{len(digits) - len(short) - places}"
    digits = digits.rjust(places + 1, "0")
    return f"{sign}{digits[:-places]}.{digits[-places:]}"


_Piece = tuple[str, int]  # a text and how tightly it holds together


def _wrap(piece: _Piece, level: int) -> str:
    return piece[0] if piece[1] >= level else f"({piece[0]})"


def _binary(node: Binary, left: _Piece, right: _Piece) -> _Piece:
    level = _LEVEL[node.op]
    if node.op == "^":
        return f"{_wrap(left, level + 1)}^{_wrap(right, level)}", level
    text = f"{_wrap(left, level)} {node.op} " if level == 10 else f"{_wrap(left, level)}{node.op}"
    return text + _wrap(right, level + 1), level


def _visit(node: Syntax, parts: tuple[_Piece, ...]) -> _Piece:
    match node:
        case Number():
            text = show_number(node.value)
            return text, 20 if "/" in text or text.startswith("-") else _WHOLE
        case Name():
            return node.name, _WHOLE
        case Differential():
            return f"d{node.name}", _WHOLE
        case Prime():
            whole = isinstance(node.operand, Name)
            return (f"{parts[0][0]}'" if whole else f"({parts[0][0]})'"), _WHOLE
        case Negate():
            return f"-{_wrap(parts[0], _NEGATE)}", _NEGATE
        case Call():
            return f"{node.function}({', '.join(part[0] for part in parts)})", _WHOLE
        case Binary():
            return _binary(node, parts[0], parts[1])


def unparse(tree: Syntax) -> str:
    """Return the text of a tree, with no more parentheses than it needs; parsed again it gives the same tree."""
    return fold_tree(tree, _visit)[0]
