"""Matrices of numbers: linear systems, ranks and kernels modulo a prime; linear systems, signs and eigenvalues in doubles."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from heapq import heapify, heappop, heappush

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
        pivots, others = _echelon(table, len(matrix), prime)
        if len(pivots) < len(matrix):
            raise Singular
        return _reduce_back(pivots, others, prime)
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


def _echelon(rows: Sequence[Sequence[int]], size: int, prime: int) -> tuple[list[tuple[int, list[int]]], list[int]]:
    """Rows of residues by elimination in their first ``size`` columns, each row as one number that is reduced when it is a pivot's.

    Returns each pivot's column with the entries after its 1, and the columns without a pivot.
    """
    total = len(rows[0]) if rows else size
    width = (
        2 * prime.bit_length() + total.bit_length() + 8
    ) // 8  # bytes of a sum of products, one of each pivot's row
    low, step = (1 << 8 * width) - 1, 8 * width
    table, pivots, others = [pack(row, width) for row in rows], list[tuple[int, list[int]]](), list[int]()
    for k in range(size):
        heads = [(row & low) % prime for row in table]
        place = next((i for i, head in enumerate(heads) if head), None)
        if place is None:
            others.append(k)
            table = [row >> step for row in table]
            continue
        own, inverse = unpack(table.pop(place) >> step, total - k - 1, width), pow(heads.pop(place), -1, prime)
        pivots.append((k, [x * inverse % prime for x in own]))
        packed = pack(pivots[-1][1], width)
        table = [
            (row >> step) + (prime - head) * packed if head else row >> step
            for row, head in zip(table, heads, strict=True)
        ]
    return pivots, [*others, *range(size, total)]


def _reduce_back(pivots: Sequence[tuple[int, Sequence[int]]], others: Sequence[int], prime: int) -> list[list[int]]:
    """Of each pivot's row what is left in the ``others`` when the columns of all pivots are zero but for their 1."""
    width = (2 * prime.bit_length() + len(pivots).bit_length() + 8) // 8
    solved, found = list[tuple[int, int]](), list[list[int]]()
    for k, row in reversed(pivots):
        total = pack([row[j - k - 1] if j > k else 0 for j in others], width)
        total += sum((prime - row[j - k - 1]) * y for j, y in solved if row[j - k - 1])
        found.append([x % prime for x in unpack(total, len(others), width)])
        solved.append((k, pack(found[-1], width)))
    return found[::-1]


def pack(residues: Sequence[int], width: int) -> int:
    """One after another, ``width`` bytes each: what is done to the number is done to all of them (Kronecker 1882)."""
    return int.from_bytes(b"".join([x.to_bytes(width, "little") for x in residues]), "little")


def unpack(number: int, count: int, width: int) -> list[int]:
    """The ``count`` entries of such a number, each up to 256^width."""
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
    if len(matrix) > _MANY:
        return len(_echelon([[x % prime for x in row] for row in matrix], len(matrix[0]), prime)[0])
    rows: Echelon = []
    for row in matrix:
        if len(rows) < len(row):
            extend_echelon(rows, row, prime)
    return len(rows)


def null_space(matrix: Sequence[Sequence[int]], width: int, prime: int) -> list[list[int]]:
    """A basis of the x with matrix @ x = 0 modulo a prime, in reduced form: each vector ends with a 1 that is 0 in the others."""
    pivots, others = _echelon([[x % prime for x in row] for row in matrix], width, prime)
    reduced, basis = _reduce_back(pivots, others, prime), []
    for number, free in enumerate(others):
        vector = [0] * width
        vector[free] = 1
        for (column, _), row in zip(pivots, reduced, strict=True):
            vector[column] = -row[number] % prime
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


def solve_positive(rows: Sequence[Mapping[int, float]], right: Sequence[float]) -> list[float]:
    """x with matrix @ x = right for a symmetric positive matrix of few entries, given by these; fewest entries first.

    Raises:
        Singular: a pivot is no larger than rounding.
    """
    table, left, order = [dict(row) for row in rows], list(right), list[int]()
    waiting = [(len(row), k) for k, row in enumerate(table)]
    heapify(waiting)
    while waiting:
        degree, k = heappop(waiting)
        if degree != len(table[k]):  # it has changed since, or is taken: a row taken is shorter than all that waits
            continue
        row = table[k]
        order.append(k)
        pivot = row.pop(k, 0.0)
        if not pivot > 1e-14 * rows[k].get(k, 0.0):
            raise Singular
        for i, x in row.items():
            factor, other = x / pivot, table[i]
            for j, y in row.items():
                other[j] = other.get(j, 0.0) - factor * y
            del other[k]
            left[i] -= factor * left[k]
            heappush(waiting, (len(other), i))
        left[k] /= pivot
        table[k] = {j: y / pivot for j, y in row.items()}
    for k in reversed(order):
        left[k] -= sum(y * left[j] for j, y in table[k].items())
    return left


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
                row, value = _without(row, factor, known, column), value - factor * right
        pivot = max(range(self.size), key=lambda j: abs(row[j]))
        if abs(row[pivot]) <= 1e-9 * max(scale, 1e-300):
            return value
        inverse = 1.0 / row[pivot]
        row, value = [x * inverse for x in row], value * inverse
        row[pivot] = 1.0
        self.rows = [
            (c, _without(known, known[pivot], row, pivot), right - known[pivot] * value)
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


def _without(row: Sequence[float], factor: float, other: Sequence[float], column: int) -> list[float]:
    """The row less a multiple of another, exactly 0 in that column: a small pivot makes rounding that stays there large."""
    rest = [x - factor * y for x, y in zip(row, other, strict=True)]
    rest[column] = 0.0
    return rest


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
