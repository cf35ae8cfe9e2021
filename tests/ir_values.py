"""Expressions of the IR evaluated independently of all printers."""

from __future__ import annotations

import math
import operator
from collections.abc import Mapping
from typing import Any

import mpmath

from nhc.program.ir import Binary, Call, Expr, Negate, Number, Pi, Power, Ref

OPERATORS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv}


def value(expression: Expr, known: Mapping[str, Any], library: Any = math) -> Any:
    """In doubles, or with the numbers of mpmath where that is the ``library``; ``known``: the values of names."""

    def of(part: Expr) -> Any:
        return value(part, known, library)

    match expression:
        case Number():
            if library is mpmath:
                return mpmath.mpf(expression.value.numerator) / expression.value.denominator
            return float(expression.value)
        case Pi():
            return +library.pi
        case Ref():
            return known[expression.name]
        case Negate():
            return -of(expression.operand)
        case Binary():
            return OPERATORS[expression.op](of(expression.left), of(expression.right))
        case Power():
            return of(expression.base) ** expression.exponent
        case Call():
            return _call(expression.function, [of(argument) for argument in expression.arguments], library)


def _call(function: str, arguments: list[Any], library: Any) -> Any:
    match function:
        case "pow":
            return arguments[0] ** arguments[1]
        case "min":
            return min(arguments)
        case "max":
            return max(arguments)
        case "abs":
            return abs(arguments[0])
        case "sign":
            return math.copysign(1.0, arguments[0])
        case _:
            return getattr(library, function)(*arguments)
