"""All maximal minors of a small matrix of doubles from one elimination, and units in which they can be compared."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from operator import mul

_PASSES = 20  # of the means of rows and columns
_FEW = 3  # sets of columns whose determinants take less time one by one than the elimination that serves all
_MANY = 8  # rows beyond which entries are looked for that are alone in their row or column


def relative_minors(matrix: Sequence[Sequence[float]], subsets: Sequence[Sequence[int]]) -> list[float]:
    """For each set of as many columns as there are rows, |det| over the product of the norms of the whole rows (Hadamard), its
    l-th root: in [0, 1].

    With B the columns of the pivots and R = B^-1 A, the determinant of other columns is det B times the minor of R in the rows
    of the pivots that they leave out and the columns that they take instead.
    """
    if not matrix:
        return [1.0] * len(subsets)
    scale = row_size(matrix)
    if len(subsets) <= (_FEW if len(matrix) > _MANY else 1) and scale != 0.0:
        blocks = ([[row[j] for j in subset] for row in matrix] for subset in subsets)
        return [(abs(float_determinant(block)) / scale) ** (1.0 / len(matrix)) for block in blocks]
    pivots, reduced, determinant = _reduce(matrix)
    if scale == 0.0 or len(pivots) < len(matrix):
        return [0.0] * len(subsets)
    place = {column: row for row, column in enumerate(pivots)}
    found = []
    for subset in subsets:
        taken = [j for j in subset if j not in place]
        kept = set(subset)
        rows = [place[j] for j in pivots if j not in kept]
        minor = float_determinant([[reduced[i][j] for j in taken] for i in rows])
        found.append((abs(determinant * minor) / scale) ** (1.0 / len(matrix)))
    return found


def row_size(matrix: Sequence[Sequence[float]]) -> float:
    """The product of the norms of the rows."""
    return math.prod(math.sqrt(sum(map(mul, row, row))) for row in matrix)


def _reduce(matrix: Sequence[Sequence[float]]) -> tuple[list[int], list[list[float]], float]:
    """(columns of the pivots, B^-1 A, |det B|), the pivots being the largest entries that are left."""
    work = [list(row) for row in matrix]
    sizes = [max(map(abs, row)) for row in work]
    pivots: list[int] = []
    determinant, count = 1.0, len(work)
    for step in range(count):
        size = max(sizes[step:])  # what was a pivot's column is zero there
        if not size > 0.0:
            break
        i = sizes.index(size, step)
        j = next(j for j, x in enumerate(work[i]) if abs(x) == size)
        work[step], work[i] = work[i], work[step]
        sizes[step], sizes[i] = sizes[i], sizes[step]
        pivot = work[step][j]
        determinant *= size
        pivots.append(j)
        own = work[step] = [x / pivot for x in work[step]]
        entries = list_entries(own)
        for k in range(count):
            factor = work[k][j]
            if k != step and factor:
                subtract(work[k], entries, factor)
                work[k][j] = 0.0
                sizes[k] = max(map(abs, work[k]))
    return pivots, work, determinant


def float_determinant(block: Sequence[Sequence[float]]) -> float:
    """By elimination with row pivoting, in larger blocks of what is left without entries that are alone in their row or column."""
    size = len(block)
    if size == 1:
        return block[0][0]
    if size == 2:
        return block[0][0] * block[1][1] - block[0][1] * block[1][0]
    det, rows = _take_lone_entries(block) if size > _MANY else (1.0, [list(row) for row in block])
    for j in range(len(rows)):  # each step leaves a row less
        column = [abs(row[j]) for row in rows]
        largest = max(column)
        if largest == 0.0:
            return 0.0
        k = column.index(largest)
        if k % 2:
            det = -det
        own = rows.pop(k)
        det *= own[j]
        entries = list_entries(own, j + 1)
        for row in rows:
            if row[j]:
                subtract(row, entries, row[j] / own[j])
    return det


def _take_lone_entries(block: Sequence[Sequence[float]]) -> tuple[float, list[list[float]]]:
    """The product of entries that are alone, with the sign that it has in the determinant, and what is left of the block."""
    size, product = len(block), 1.0
    place = dict(find_lone_entries([[j for j, x in enumerate(row) if x] for row in block], size))
    for i, j in place.items():
        product *= block[i][j]
    rows, gone = [i for i in range(size) if i not in place], {*place.values()}
    columns = [j for j in range(size) if j not in gone]
    place.update(zip(rows, columns, strict=True))
    odd = _is_odd([place[i] for i in range(size)])
    return -product if odd else product, [[block[i][j] for j in columns] for i in rows]


def find_lone_entries(
    rows: Sequence[Sequence[int]], width: int, fits: Callable[[int, int], bool] | None = None
) -> list[tuple[int, int]]:
    """Entries (row, column) of a matrix with these columns in its rows that are alone in their row or column, each in what those
    before it leave, and that ``fits``.  With them taken nothing is added to the rest.

    The rows of a chain of bodies are triangular but for a few, and nothing of them is left.
    """
    held: list[list[set[int]]] = [[set(row) for row in rows], [set() for _ in range(width)]]
    for i, row in enumerate(rows):
        for j in row:
            held[1][j].add(i)
    alone = [(k, line) for k in (0, 1) for line, met in enumerate(held[k]) if len(met) == 1]
    found: list[tuple[int, int]] = []
    for k, line in alone:
        for other in [*held[k][line]]:  # none where its row or column is taken
            entry = (line, other) if k == 0 else (other, line)
            if fits is not None and not fits(*entry):
                continue
            found.append(entry)
            for side, own in ((0, entry[0]), (1, entry[1])):
                for met in held[side][own]:
                    held[1 - side][met].discard(own)
                    if len(held[1 - side][met]) == 1:
                        alone.append((1 - side, met))
                held[side][own] = set()
    return found


def _is_odd(permutation: Sequence[int]) -> bool:
    """By its cycles."""
    seen, odd = [False] * len(permutation), False
    for start in range(len(permutation)):
        place = start
        while not seen[place]:
            seen[place] = True
            place = permutation[place]
            odd ^= place != start
    return odd


def list_entries(row: Sequence[float], start: int = 0) -> list[tuple[int, float]]:
    """The entries that are not zero, from the column ``start`` on: rows of many bodies' constraints have few."""
    return [(j, row[j]) for j in range(start, len(row)) if row[j]]


def subtract(row: list[float], entries: Sequence[tuple[int, float]], factor: float) -> None:
    """Subtract a multiple of another row."""
    for j, y in entries:
        row[j] -= factor * y


def balance_columns(matrix: Sequence[Sequence[float]], width: int) -> list[float]:
    """Factors of the columns for which there are factors of the rows that bring the entries near 1, in the mean of the logarithms.

    Columns in other units get the same products, up to a factor for all columns of a part that no row joins to the others: what
    the first pass meets first has the factor 1, and each pass takes means of what was there before (Curtis and Reid 1972, with a
    few passes in place of the least squares' solution).
    """
    logs = [{j: math.log(abs(x)) for j, x in enumerate(row) if x != 0.0 and math.isfinite(x)} for row in matrix]
    columns: list[float | None] = [None] * width
    for j in range(width):
        if columns[j] is None:
            columns[j] = 0.0
            _spread_out(logs, columns)
    found = [x or 0.0 for x in columns]
    members = [[(i, row[j]) for i, row in enumerate(logs) if j in row] for j in range(width)]
    for _ in range(_PASSES):
        rows = [sum(x + found[j] for j, x in row.items()) / max(len(row), 1) for row in logs]
        found = [
            sum(rows[i] - x for i, x in met) / len(met) if met else value
            for met, value in zip(members, found, strict=True)
        ]
    return [math.exp(x) for x in found]


def _spread_out(logs: Sequence[dict[int, float]], columns: list[float | None]) -> None:
    """Factors for all columns that rows join to those that have one."""
    waiting = [k for k, row in enumerate(logs) if row]
    while waiting:
        later = []
        for k in waiting:
            known = [x + value for j, x in logs[k].items() if (value := columns[j]) is not None]
            if not known:
                later.append(k)
                continue
            for j, x in logs[k].items():
                if columns[j] is None:
                    columns[j] = sum(known) / len(known) - x
        if len(later) == len(waiting):
            break
        waiting = later
