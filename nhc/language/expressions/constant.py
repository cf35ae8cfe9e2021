"""The value of an expression of numbers and ``pi``."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction

from nhc.diagnostics import Span
from nhc.language.expressions.syntax import Binary, Call, Name, Negate, Number, Prime, Syntax, fold_tree

_ROUNDING = 2.0**-50  # of an angle that was a multiple of pi
_MOST = 1e3  # turns beyond it are no longer told from others


def _cosine(angle: float, exact: bool = False) -> float:
    """Zero where the angle is an odd quarter turn to rounding: ``pi/2`` means the quarter turn, not the double next to it."""
    value = math.cos(angle)
    return 0.0 if not exact and abs(value) <= _ROUNDING * abs(angle) < _ROUNDING * _MOST else value


def _sine(angle: float, exact: bool = False) -> float:
    """Zero where the angle is a half turn to rounding."""
    value = math.sin(angle)
    return 0.0 if not exact and abs(value) <= _ROUNDING * abs(angle) < _ROUNDING * _MOST else value


_TURNS: dict[str, Callable[[float, bool], float]] = {
    "sin": _sine,
    "cos": _cosine,
    "tan": lambda angle, exact: _sine(angle, exact) / _cosine(angle, exact),
}
_FUNCTIONS: dict[str, Callable[..., float]] = {
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "atan2": math.atan2,
    "sinh": math.sinh,
    "cosh": math.cosh,
    "tanh": math.tanh,
    "exp": math.exp,
    "log": math.log,
    "sqrt": math.sqrt,
    "abs": abs,
    "sign": lambda value: float((value > 0) - (value < 0)),
    "min": min,
    "max": max,
}


_DIVISOR = "correct the divisor"


class ConstantError(Exception):
    """The expression has no real, finite value."""

    def __init__(self, code: str, message: str, span: Span, help: str) -> None:
        super().__init__(message)
        self.help = help
        self.code = code
        self.message = message
        self.span = span


def _apply(op: str, left: Fraction | float, right: Fraction | float) -> Fraction | float:
    match op:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "/":
            return left / right
        case _:
            return math.pow(left, right)


def _visit(node: Syntax, parts: tuple[Fraction | float, ...]) -> Fraction | float:
    value: Fraction | float
    try:
        match node:
            case Number():
                return node.value
            case Negate():
                return -parts[0]
            case Binary():
                value = _apply(node.op, parts[0], parts[1])
            case Call() if node.function in _TURNS:
                value = _TURNS[node.function](float(parts[0]), isinstance(parts[0], Fraction))
            case Call():
                value = _FUNCTIONS[node.function](*(float(part) for part in parts))
            case Name():
                return math.pi
            case Prime():
                raise ConstantError("E0212", "time derivative of a constant", node.span, "leave it out: it is 0")
            case _:
                raise ConstantError("E0314", "value is not constant", node.span, "write numbers and `pi` only")
        if math.isfinite(float(value)):
            return value
    except ZeroDivisionError:
        raise ConstantError("E0417", "division by zero", node.span, _DIVISOR) from None
    except (ValueError, OverflowError):
        pass
    if isinstance(node, Binary) and node.op == "^" and parts[0] == 0:
        raise ConstantError("E0417", "division by zero", node.span, _DIVISOR)
    help = "keep arguments where the function is real, and results below 1e308"
    raise ConstantError("E0313", "the expression has no real, finite value", node.span, help)


def evaluate(tree: Syntax) -> Fraction | float:
    """Return the value: exact where only ``+ - * /`` and numbers stand, a double otherwise.

    The only names in it must be ``pi``. Raises ``ConstantError`` where there is no real, finite value.
    """
    return fold_tree(tree, _visit)
