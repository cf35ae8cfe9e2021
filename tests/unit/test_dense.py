"""Small dense matrices: solutions are put in again, ranks and kernels are those of SymPy, eigenvalues those of NumPy."""

from __future__ import annotations

import itertools
import random

import numpy
import pytest
import sympy

from nhc.algebra.dense import (
    RowSpace,
    Singular,
    null_space,
    pivot_signs,
    rank_modulo,
    solve_columns_modulo,
    solve_double,
    solve_modulo,
    solve_positive,
    symmetric_eigenvalues,
)
from nhc.algebra.exact.residues import PRIMES

P = PRIMES[0]
Matrix = list[list[int]]


def draw(rng: random.Random, rows: int, columns: int, most: int) -> Matrix:
    """A random matrix of at most that rank."""
    left = [[rng.randint(-3, 3) for _ in range(most)] for _ in range(rows)]
    right = [[rng.randint(-3, 3) for _ in range(columns)] for _ in range(most)]
    return times(left, right)


def times(left: Matrix, right: Matrix) -> Matrix:
    return [
        [sum(a * b for a, b in zip(row, column, strict=True)) for column in zip(*right, strict=True)] for row in left
    ]


@pytest.mark.parametrize("seed", range(20))
def test_ranks_and_kernels_modulo_a_prime_are_those_of_rational_numbers(seed: int) -> None:
    rng = random.Random(seed)
    rows, columns = rng.randint(1, 12), rng.randint(1, 12)
    matrix = draw(rng, rows, columns, rng.randint(1, 5))
    expected = sympy.Matrix(matrix).rank()
    assert rank_modulo(matrix, P) == expected
    basis = null_space(matrix, columns, P)
    assert len(basis) == columns - expected
    for vector in basis:
        assert all(sum(a * x for a, x in zip(row, vector, strict=True)) % P == 0 for row in matrix)
        last = max(j for j, x in enumerate(vector) if x)
        assert vector[last] == 1 and all(other[last] == 0 for other in basis if other is not vector)


@pytest.mark.parametrize("prime", [10_007, P])
def test_linear_systems_modulo_a_prime(prime: int) -> None:
    matrix, x = [[0, 2, 1], [3, 0, 5], [7, 1, 0]], [[5, 1], [11, 0], [13, 9]]
    right = times(matrix, x)
    assert solve_columns_modulo(matrix, right, prime) == x
    assert solve_modulo(matrix, [row[0] for row in right], prime) == [5, 11, 13]
    with pytest.raises(Singular):
        solve_modulo([[1, 2], [2, 4]], [1, 1], prime)


@pytest.mark.parametrize("size", [9, 17, 40])
@pytest.mark.parametrize("prime", [10_007, P])
def test_large_linear_systems_modulo_a_prime(size: int, prime: int) -> None:
    """Rows as numbers: with zeros, with rows to be exchanged, with many right sides, and a row that is a sum of others."""
    draws = random.Random(size)
    full = [[draws.randrange(prime) for _ in range(size)] for _ in range(size)]
    few = [[x if abs(i + j + 1 - size) < 2 else 0 for j, x in enumerate(row)] for i, row in enumerate(full)]
    x = [[draws.randrange(prime) for _ in range(3)] for _ in range(size)]
    for matrix in (full, few):
        found = solve_columns_modulo(matrix, [[a % prime for a in row] for row in times(matrix, x)], prime)
        assert found == x
        matrix[size // 2] = [a + b for a, b in zip(matrix[0], matrix[-1], strict=True)]
        with pytest.raises(Singular):
            solve_columns_modulo(matrix, x, prime)


def test_linear_systems_in_doubles() -> None:
    assert solve_double([[0.0, 2.0], [3.0, 1.0]], [4.0, 5.0]) == pytest.approx([1.0, 2.0])
    assert solve_double([[1e-9, 1.0], [1.0, 1.0]], [1.0, 2.0]) == pytest.approx([1.0, 1.0])
    with pytest.raises(Singular):
        solve_double([[1.0, 2.0], [2.0, 4.0]], [1.0, 1.0])


@pytest.mark.parametrize("seed", range(10))
def test_positive_systems_of_few_entries(seed: int) -> None:
    """Along a random tree with a few more entries, and full ones: as elimination with all entries has it."""
    draws = random.Random(seed)
    size = draws.randint(1, 12)
    rows: list[dict[int, float]] = [{k: 9.0} for k in range(size)]
    ends = [(draws.randrange(k), k) for k in range(1, size)] + [(0, draws.randrange(size)) for _ in range(3)]
    every = [(i, j) for i in range(size) for j in range(i)]
    for i, j in ends if seed % 2 else every:
        if i != j:
            rows[i][j] = rows[j][i] = draws.uniform(-0.7, 0.7)
    right = [draws.uniform(-1, 1) for _ in range(size)]
    expected = solve_double([[row.get(j, 0.0) for j in range(size)] for row in rows], right)
    assert solve_positive(rows, right) == pytest.approx(expected, rel=1e-12, abs=1e-13)
    rows[0] = {0: 0.0}
    with pytest.raises(Singular):
        solve_positive(rows, right)


@pytest.mark.parametrize("seed", range(20))
def test_symmetric_matrices(seed: int) -> None:
    rng = random.Random(seed)
    size = rng.randint(1, 5)
    half = draw(rng, size, size, size)
    matrix = [
        [float(a + b) for a, b in zip(row, column, strict=True)]
        for row, column in zip(half, zip(*half, strict=True), strict=True)
    ]
    expected = numpy.linalg.eigvalsh(matrix)
    assert sorted(symmetric_eigenvalues(matrix)) == pytest.approx(list(expected), abs=1e-9)
    signs = pivot_signs(matrix)
    minors = [round(numpy.linalg.det(numpy.array(matrix)[:k, :k])) for k in range(size + 1)]
    if all(minors):  # Jacobi: the pivots are quotients of the leading minors
        assert signs == [1 if a * b > 0 else -1 for a, b in itertools.pairwise(minors)]
        assert signs.count(-1) == sum(x < 0 for x in expected)  # Sylvester's law of inertia
    else:
        assert len(signs) < size or signs[-1] < 1


def test_equations_one_by_one() -> None:
    space = RowSpace(3)
    assert space.add([1.0, 1.0, 0.0], 3.0) is None
    assert space.add([1.0, -1.0, 0.0], 1.0) is None
    assert space.add([2.0, 0.0, 0.0], 4.0) == pytest.approx(0.0)  # the sum of both
    assert space.add([2.0, 0.0, 0.0], 8.0) == pytest.approx(4.0)  # contradicts it by 4
    assert space.solution() == pytest.approx([2.0, 1.0, 0.0])


def test_equations_with_a_small_pivot_keep_each_its_own_column() -> None:
    """Rounding that stays in the column of an earlier pivot is made large by a small one, and taken for another pivot."""
    space = RowSpace(3)
    for row, value in (
        ([-0.29552020666133955, 0.955336489125606, -1e-7], 0.0),
        ([1, 0, 0], 1.0),
        ([0, 1, 0], 0.309336),
    ):
        assert space.add(row, value) is None
    off = space.add([0, 0, 1], 0.0)
    assert off is not None and abs(off - 2.384612) < 1e-5
    assert space.solution()[:2] == pytest.approx([1.0, 0.309336])
