"""Linear relations with constant rational coefficients between functions that are known at random points of a prime field."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.dense import null_space

_LARGEST = 1 << 20  # a coefficient beyond this is no small rational but noise


def rational(residue: int, prime: int) -> Fraction | None:
    """The rational with small numerator and denominator that has this residue (Wang 1981), or None."""
    r0, r1 = prime, residue % prime
    s0, s1 = 0, 1
    while r1 > _LARGEST:
        q = r0 // r1
        r0, r1, s0, s1 = r1, r0 - q * r1, s1, s0 - q * s1
    if s1 == 0 or abs(s1) > _LARGEST:
        return None
    return Fraction(r1, s1)


def find_relations(rows: Sequence[Sequence[int]], width: int, prime: int) -> list[list[Fraction]]:
    """A basis of the k with sum_j k_j row_j = 0 for every row, each as rationals; vectors that are none are left out.

    The basis is reduced: each vector has one entry 1 of its own, which is its last nonzero one.  There should be some more rows
    than columns: what vanishes at that many random points vanishes.
    """
    found = []
    for vector in null_space(rows, width, prime):
        exact = [rational(x, prime) for x in vector]
        if all(x is not None for x in exact):
            found.append([x for x in exact if x is not None])
    return found


def without(basis: Sequence[Sequence[Fraction]], trivial: Sequence[Sequence[Fraction]]) -> list[list[Fraction]]:
    """The vectors of ``basis`` that are independent of ``trivial`` and of those before them."""
    echelon: list[tuple[int, list[Fraction]]] = []

    def reduce(vector: Sequence[Fraction]) -> list[Fraction]:
        work = list(vector)
        for column, row in echelon:
            if work[column]:
                factor = work[column]
                work = [x - factor * y for x, y in zip(work, row, strict=True)]
        return work

    def take(vector: Sequence[Fraction]) -> bool:
        work = reduce(vector)
        column = next((j for j in reversed(range(len(work))) if work[j]), -1)
        if column < 0:
            return False
        lead = work[column]
        echelon.append((column, [x / lead for x in work]))
        return True

    for vector in trivial:
        take(vector)
    return [list(vector) for vector in basis if take(vector)]
