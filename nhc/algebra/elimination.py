"""Small dense linear systems over a prime field and over doubles."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.linear import Singular


def solve_modulo(matrix: Sequence[Sequence[int]], right: Sequence[int], prime: int) -> list[int]:
    """x with matrix @ x = right modulo a prime.

    Raises:
        Singular: the determinant is zero modulo the prime.
    """
    size = len(matrix)
    table = [[x % prime for x in (*row, b)] for row, b in zip(matrix, right, strict=True)]
    for k in range(size):
        pivot = next((i for i in range(k, size) if table[i][k]), None)
        if pivot is None:
            raise Singular
        table[k], table[pivot] = table[pivot], table[k]
        inverse = pow(table[k][k], -1, prime)
        table[k] = [x * inverse % prime for x in table[k]]
        for i in range(size):
            factor = table[i][k]
            if i != k and factor:
                table[i] = [(x - factor * y) % prime for x, y in zip(table[i], table[k], strict=True)]
    return [row[-1] for row in table]


def solve_double(matrix: Sequence[Sequence[float]], right: Sequence[float]) -> list[float]:
    """x with matrix @ x = right in double precision, by elimination with row pivoting after scaling the rows.

    Raises:
        Singular: a pivot is no larger than rounding.
    """
    size = len(matrix)
    table = []
    for row, b in zip(matrix, right, strict=True):
        scale = max((abs(x) for x in row), default=0.0)
        if not scale > 0.0:
            raise Singular
        table.append([x / scale for x in (*row, b)])
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(table[i][k]))
        if not abs(table[pivot][k]) > 1e-14:
            raise Singular
        table[k], table[pivot] = table[pivot], table[k]
        for i in range(k + 1, size):
            factor = table[i][k] / table[k][k]
            if factor:
                table[i] = [x - factor * y for x, y in zip(table[i], table[k], strict=True)]
    x = [0.0] * size
    for k in reversed(range(size)):
        x[k] = (table[k][size] - sum(table[k][j] * x[j] for j in range(k + 1, size))) / table[k][k]
    return x


def null_space(matrix: Sequence[Sequence[int]], width: int, prime: int) -> list[list[int]]:
    """A basis of the x with matrix @ x = 0 modulo a prime, in reduced form: each vector ends with a 1 that is 0 in the others."""
    rows: list[list[int]] = []
    pivots: list[int] = []
    for row in matrix:
        work = [x % prime for x in row]
        for known, column in zip(rows, pivots, strict=True):
            factor = work[column]
            if factor:
                work = [(x - factor * y) % prime for x, y in zip(work, known, strict=True)]
        column = next((j for j, x in enumerate(work) if x), -1)
        if column < 0:
            continue
        inverse = pow(work[column], -1, prime)
        work = [x * inverse % prime for x in work]
        rows = [[(x - known[column] * y) % prime for x, y in zip(known, work, strict=True)] for known in rows]
        rows.append(work)
        pivots.append(column)
    basis = []
    for free in (j for j in range(width) if j not in pivots):
        vector = [0] * width
        vector[free] = 1
        for row, column in zip(rows, pivots, strict=True):
            vector[column] = -row[free] % prime
        basis.append(vector)
    return basis
