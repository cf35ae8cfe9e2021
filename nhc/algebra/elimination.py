"""Small dense linear systems over a prime field and over doubles."""

from __future__ import annotations

from collections.abc import Sequence

Echelon = list[tuple[int, list[int]]]
"""Independent rows, each with the column of its 1, in which the rows after it are zero."""


class Singular(Exception):
    """The matrix has no inverse; of one over a graph: at no state."""


def solve_modulo(matrix: Sequence[Sequence[int]], right: Sequence[int], prime: int) -> list[int]:
    """x with matrix @ x = right modulo a prime.

    Raises:
        Singular: the determinant is zero modulo the prime.
    """
    return [row[0] for row in solve_columns_modulo(matrix, [[b] for b in right], prime)]


def solve_columns_modulo(
    matrix: Sequence[Sequence[int]], right: Sequence[Sequence[int]], prime: int
) -> list[list[int]]:
    """X with matrix @ X = right modulo a prime, row by row.

    Raises:
        Singular: the determinant is zero modulo the prime.
    """
    size = len(matrix)
    table = [[x % prime for x in (*row, *columns)] for row, columns in zip(matrix, right, strict=True)]
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
    return [row[size:] for row in table]


def extend_echelon(rows: Echelon, row: Sequence[int], prime: int) -> bool:
    """Add what is new of a row modulo a prime; whether there is anything."""
    work = [x % prime for x in row]
    for column, known in rows:
        factor = work[column]
        if factor:
            work = [(x - factor * y) % prime for x, y in zip(work, known, strict=True)]
    pivot = next((j for j, x in enumerate(work) if x), None)
    if pivot is None:
        return False
    inverse = pow(work[pivot], -1, prime)
    rows.append((pivot, [x * inverse % prime for x in work]))
    return True


def rank_modulo(matrix: Sequence[Sequence[int]], prime: int) -> int:
    """The rank of a matrix modulo a prime."""
    rows: Echelon = []
    for row in matrix:
        if len(rows) < len(row):
            extend_echelon(rows, row, prime)
    return len(rows)


def null_space(matrix: Sequence[Sequence[int]], width: int, prime: int) -> list[list[int]]:
    """A basis of the x with matrix @ x = 0 modulo a prime, in reduced form: each vector ends with a 1 that is 0 in the others."""
    rows: Echelon = []
    for row in matrix:
        if extend_echelon(rows, row, prime):
            pivot, new = rows[-1]
            rows[:-1] = [
                (column, [(x - known[pivot] * y) % prime for x, y in zip(known, new, strict=True)])
                for column, known in rows[:-1]
            ]
    pivots = {column for column, _ in rows}
    basis = []
    for free in (j for j in range(width) if j not in pivots):
        vector = [0] * width
        vector[free] = 1
        for column, row in rows:
            vector[column] = -row[free] % prime
        basis.append(vector)
    return basis


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
