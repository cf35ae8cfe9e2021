"""L U with row pivoting, operation for operation as ``templates/c/methods/linear.c.jinja`` has it."""

from __future__ import annotations

from collections.abc import Sequence

Matrix = list[list[float]]


class SingularMatrix(ArithmeticError):
    """A pivot is zero."""


def factor(matrix: Sequence[Sequence[float]]) -> tuple[Matrix, list[int]]:
    """(L U, the rows that were exchanged)."""
    a, size, order = [list(row) for row in matrix], len(matrix), []
    for k in range(size):
        best = max(range(k, size), key=lambda i: abs(a[i][k]))
        order.append(best)
        if not abs(a[best][k]) > 0.0:
            raise SingularMatrix("the matrix is singular")
        a[k], a[best] = a[best], a[k]
        top = a[k]
        for row in a[k + 1 :]:
            row[k] /= top[k]
            if row[k]:
                for j in range(k + 1, size):
                    row[j] -= row[k] * top[j]
    return a, order


def resolve(factors: tuple[Matrix, list[int]], right: Sequence[float]) -> list[float]:
    """x with the factored matrix times x = right."""
    a, order = factors
    x = list(right)
    for k, best in enumerate(order):
        x[k], x[best] = x[best], x[k]
    for i, row in enumerate(a):
        x[i] -= sum(row[j] * x[j] for j in range(i))
    for i in reversed(range(len(a))):
        x[i] = (x[i] - sum(a[i][j] * x[j] for j in range(i + 1, len(a)))) / a[i][i]
    return x


def solve(matrix: Sequence[Sequence[float]], right: Sequence[float]) -> list[float]:
    """x with matrix times x = right."""
    return resolve(factor(matrix), right)
