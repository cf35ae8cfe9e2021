"""What statements are made of: their expressions, the parts of these, and how many operations they take."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.program.ir import Binary, Call, Expr, Guard, Let, Negate, Power, Ref, Result, Solve, Statement, Store, Sweep

_VALUED = (Let, Store, Result)


def list_expressions(statement: Statement) -> tuple[Expr, ...]:
    """The expressions that a statement evaluates."""
    if isinstance(statement, _VALUED):
        return (statement.value,)
    if isinstance(statement, Guard):
        return (statement.value, statement.scale)
    if isinstance(statement, Solve):
        rows = statement.matrix + statement.columns
        return tuple(entry for row in rows for entry in row)
    if isinstance(statement, Sweep):
        return tuple(inner.value for inner in statement.body)
    return ()


def walk(expression: Expr) -> list[Expr]:
    """The expression and all that it is made of, from left to right; a sum may be thousands of terms deep, hence the stack."""
    found: list[Expr] = []
    stack: list[Expr] = [expression]
    while stack:
        node = stack.pop()
        while type(node) is Binary:  # all but the last on the way down the left operands
            found.append(node)
            stack.append(node.right)
            node = node.left
        found.append(node)
        if type(node) is not Ref:
            stack += list_operands(node)
    return found


def list_operands(node: Expr) -> Iterable[Expr]:
    """What an expression is made of that is no operation of two operands, the last first."""
    if isinstance(node, Negate):
        return (node.operand,)
    if isinstance(node, Power):
        return (node.base,)
    return reversed(node.arguments) if isinstance(node, Call) else ()


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
        pending = list(list_expressions(statement))
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
