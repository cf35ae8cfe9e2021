"""Passes over statements: operation counts, free names."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from nhc.program.ir import (
    Binary,
    Call,
    Evaluate,
    Expr,
    Guard,
    Let,
    Load,
    Negate,
    Number,
    Pi,
    Power,
    Ref,
    Result,
    Section,
    Solve,
    Statement,
    Store,
    Sweep,
)


def expressions(statement: Statement) -> Iterator[Expr]:
    """The expressions that a statement evaluates."""
    match statement:
        case Let() | Store() | Result():
            yield statement.value
        case Guard():
            yield statement.value
            yield statement.scale
        case Solve():
            for row in (*statement.matrix, *statement.columns):
                yield from row
        case Section() | Load() | Evaluate() | Sweep():
            return


def walk(expression: Expr) -> Iterator[Expr]:
    """Every part of an expression, itself first."""
    yield expression
    match expression:
        case Binary():
            yield from walk(expression.left)
            yield from walk(expression.right)
        case Negate():
            yield from walk(expression.operand)
        case Power():
            yield from walk(expression.base)
        case Call():
            for argument in expression.arguments:
                yield from walk(argument)
        case Number() | Pi() | Ref():
            return


def count_operations(body: Iterable[Statement]) -> tuple[int, int, int, int]:
    """(additions, multiplications, divisions, calls); a dense solve counts its elimination, a sweep all its passes.

    What another function computes is not counted.
    """
    adds = multiplications = divisions = calls = 0
    for statement in body:
        if isinstance(statement, Sweep):
            passes = len(statement.offsets)
            more = count_operations(statement.body)
            adds, multiplications = adds + passes * more[0], multiplications + passes * more[1]
            divisions, calls = divisions + passes * more[2], calls + passes * more[3]
            continue
        if isinstance(statement, Solve):
            size, columns = len(statement.matrix), len(statement.columns)
            work = sum(k * (k - 1) + k * columns for k in range(1, size + 1)) + columns * size * (size - 1) // 2
            adds, multiplications, divisions = adds + work, multiplications + work, divisions + size * (1 + columns)
        pending = list(expressions(statement))
        while pending:
            part = pending.pop()
            if type(part) is Ref:  # every other one
                continue
            if isinstance(part, Binary):
                op = part.op
                if op == "*":
                    multiplications += 1
                elif op == "/":
                    divisions += 1
                else:
                    adds += 1
                pending += (part.left, part.right)
            elif isinstance(part, Negate):
                pending.append(part.operand)
            elif isinstance(part, Power):
                calls += 1
                pending.append(part.base)
            elif isinstance(part, Call):
                calls += 1
                pending += part.arguments
    return adds, multiplications, divisions, calls
