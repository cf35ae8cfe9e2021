"""Small dense matrices: linear systems, ranks and kernels modulo a prime; linear systems, signs and eigenvalues in doubles."""

from __future__ import annotations

import math
from collections.abc import Sequence

Echelon = list[tuple[int, list[int]]]
"""Independent rows, each with the column of its 1, in which the rows after it are zero."""


_MANY = 8
"""Rows from which a row is worth being one number."""


class Singular(Exception):
    """The matrix has no inverse; of one over a graph: at no state."""


# --- modulo a prime ---------------------------------------------------------------------------------------


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
    table = [[x % prime for x in (*row, *columns)] for row, columns in zip(matrix, right, strict=True)]
    if len(matrix) > _MANY:
        return _solve_packed(table, len(matrix), prime)
    for k in range(len(matrix)):
        pivot = next((i for i in range(k, len(matrix)) if table[i][k]), None)
        if pivot is None:
            raise Singular
        table[k], table[pivot] = table[pivot], table[k]
        inverse = pow(table[k][k], -1, prime)
        table[k] = [x * inverse % prime for x in table[k]]
        for i in range(len(matrix)):
            factor = table[i][k]
            if i != k and factor:
                table[i] = [(x - factor * y) % prime for x, y in zip(table[i], table[k], strict=True)]
    return [row[len(matrix) :] for row in table]


def _solve_packed(rows: Sequence[Sequence[int]], size: int, prime: int) -> list[list[int]]:
    """The same for rows of residues, each as one number: below the pivots a row is reduced once, when it is a pivot's own."""
    columns = len(rows[0]) - size
    width = (2 * prime.bit_length() + size.bit_length() + 8) // 8  # bytes of a sum of products, one of each pivot's row
    low, step = (1 << 8 * width) - 1, 8 * width
    table, pivots = [pack(row, width) for row in rows], list[list[int]]()
    for k in range(size):
        heads = [(row & low) % prime for row in table]
        place = next((i for i, head in enumerate(heads) if head), None)
        if place is None:
            raise Singular
        own, inverse = unpack(table.pop(place) >> step, size - k - 1 + columns, width), pow(heads.pop(place), -1, prime)
        pivots.append([x * inverse % prime for x in own])
        packed = pack(pivots[-1], width)
        table = [
            (row >> step) + (prime - head) * packed if head else row >> step
            for row, head in zip(table, heads, strict=True)
        ]
    solved = list[int]()  # from the last unknown to the first, the values for all right sides in one number
    found = list[list[int]]()
    for row in reversed(pivots):
        others = row[: len(solved)]
        total = pack(row[len(solved) :], width) + sum((prime - x) * y for x, y in zip(others, reversed(solved)) if x)
        found.append([x % prime for x in unpack(total, columns, width)])
        solved.append(pack(found[-1], width))
    return found[::-1]


def pack(residues: Sequence[int], width: int) -> int:
    """One after another, ``width`` bytes each: what is done to the number is done to all of them (Kronecker 1882)."""
    return int.from_bytes(b"".join([x.to_bytes(width, "little") for x in residues]), "little")


def unpack(number: int, count: int, width: int) -> list[int]:
    text = number.to_bytes(count * width, "little")
    return [int.from_bytes(text[k : k + width], "little") for k in range(0, count * width, width)]


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


# --- in doubles ---------------------------------------------------------------------------------------------


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


class RowSpace:
    """Linear equations taken one by one; each is reduced by those before it."""

    def __init__(self, size: int) -> None:
        self.size = size
        self.rows: list[tuple[int, list[float], float]] = []
        """(column, row, right side): the row is 1 in its own column and 0 in those of the others."""

    def add(self, row: Sequence[float], value: float) -> float | None:
        """None if the equation was new; else by how much its right side contradicts the earlier ones."""
        row, scale = list(row), max((abs(x) for x in row), default=0.0)
        for column, known, right in self.rows:
            factor = row[column]
            if factor:
                row = [x - factor * y for x, y in zip(row, known, strict=True)]
                value -= factor * right
        pivot = max(range(self.size), key=lambda j: abs(row[j]))
        if abs(row[pivot]) <= 1e-9 * max(scale, 1e-300):
            return value
        inverse = 1.0 / row[pivot]
        row, value = [x * inverse for x in row], value * inverse
        self.rows = [
            (c, [x - known[pivot] * y for x, y in zip(known, row, strict=True)], right - known[pivot] * value)
            for c, known, right in self.rows
        ]
        self.rows.append((pivot, row, value))
        return None

    def solution(self) -> list[float]:
        """What solves all equations; unknowns that they leave free are zero."""
        result = [0.0] * self.size
        for column, _, value in self.rows:
            result[column] = value
        return result


def pivot_signs(matrix: Sequence[Sequence[float]]) -> list[int]:
    """Signs of the pivots of a symmetric matrix without exchanges; ends at the first one that is zero to rounding.

    Beside a larger entry such a pivot means a negative minor: -1.
    """
    work, signs = [list(row) for row in matrix], list[int]()
    scale = max((abs(x) for row in work for x in row), default=0.0)
    for k, own in enumerate(work):
        pivot = own[k]
        if abs(pivot) <= 1e-11 * scale:
            return [*signs, -1 if any(abs(x) > 1e-5 * scale for x in own[k + 1 :]) else 0]
        signs.append(1 if pivot > 0 else -1)
        for i in range(k + 1, len(work)):
            factor = work[i][k] / pivot
            work[i] = [x - factor * y for x, y in zip(work[i], own, strict=True)]
    return signs


def symmetric_eigenvalues(matrix: Sequence[Sequence[float]]) -> list[float]:
    """Eigenvalues of a small symmetric matrix (Jacobi 1846: cyclic rotations until the rest is negligible)."""
    a, size = [list(row) for row in matrix], len(matrix)
    for _ in range(60):
        off = sum(a[i][j] ** 2 for i in range(size) for j in range(size) if i != j)
        if off <= 1e-30 * sum(a[i][i] ** 2 for i in range(size)):
            break
        for p in range(size):
            for q in range(p + 1, size):
                if a[p][q] == 0.0:
                    continue
                angle = 0.5 * math.atan2(2 * a[p][q], a[q][q] - a[p][p])
                c, s = math.cos(angle), math.sin(angle)
                for k in range(size):
                    a[k][p], a[k][q] = c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]
                for k in range(size):
                    a[p][k], a[q][k] = c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]
    return [a[i][i] for i in range(size)]
