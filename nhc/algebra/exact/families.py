"""Linear relations whose coefficients are rational functions of parameters, between functions that are known at random points.

At fixed values of the parameters, elements of a prime field, the relations are a null space, whose reduced basis is unique: its
entries are functions of the parameters.  One parameter moved after the other tells which of them an entry depends on; those of few
are found as quotients of polynomials of low degree, which many more values of the parameters confirm.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from itertools import combinations_with_replacement
from math import comb

from nhc.algebra.dense import null_space
from nhc.algebra.exact.field import Unlucky
from nhc.algebra.exact.relations import find_relations, rational
from nhc.algebra.graph import Graph, Node

Sample = Callable[[Mapping[Node, int]], Sequence[Sequence[int]]]
"""From values of the parameters to rows, each the functions' values at a random point, some more than there are functions."""

_DEGREE = 2
_TOGETHER = 3  # parameters that one coefficient depends on
_MOST = 60  # parameters, each of which is moved
_SPARE = 4


def draw_parameters(parameters: Sequence[Node], prime: int, seed: int) -> dict[Node, int]:
    """Random values, the same for the same seed."""
    source = random.Random(seed)
    return {symbol: source.randrange(2, prime - 1) for symbol in parameters}


def find_families(
    graph: Graph, parameters: Sequence[Node], sample: Sample, width: int, prime: int
) -> list[list[Node] | None]:
    """The k(parameters), polynomials, with sum_j k_j row_j = 0: a basis over their quotients; None where of no low degree.

    Raises:
        Unlucky: as ``sample`` does.
    """
    here, other = (draw_parameters(parameters, prime, seed) for seed in (1, 2))

    def basis_at(place: Mapping[Node, int]) -> list[list[int]]:
        found = null_space(sample(place), width, prime)
        if len(found) != len(basis):
            raise Unlucky
        return found

    basis = null_space(sample(here), width, prime)
    if len(parameters) > _MOST:
        return [None] * len(basis)
    moved = {symbol: basis_at({**here, symbol: other[symbol]}) for symbol in parameters}
    places = [(i, j) for i in range(len(basis)) for j in range(width)]
    needed = {(i, j): tuple(symbol for symbol in parameters if moved[symbol][i][j] != basis[i][j]) for i, j in places}
    most = max((len(symbols) for symbols in needed.values() if len(symbols) <= _TOGETHER), default=0)
    count = 2 * comb(most + _DEGREE, _DEGREE) + _SPARE if most else 0
    values = [draw_parameters(parameters, prime, 3 + k) for k in range(count)]
    bases = [basis_at(place) for place in values]

    def entry_of(i: int, j: int) -> tuple[Node, Node] | None:
        symbols = needed[i, j]
        if not symbols:
            return _constant(graph, basis[i][j], prime)
        return (
            _quotient(graph, symbols, values, [one[i][j] for one in bases], prime)
            if len(symbols) <= _TOGETHER
            else None
        )

    families = list[list[Node] | None]()
    for i in range(len(basis)):
        entries = [entry_of(i, j) for j in range(width)]
        known = [entry for entry in entries if entry is not None]
        families.append(_without_quotients(graph, known) if len(known) == width else None)
    return families


def _constant(graph: Graph, residue: int, prime: int) -> tuple[Node, Node] | None:
    value = rational(residue, prime)
    return None if value is None else (graph.number(value), graph.one)


def _quotient(
    graph: Graph, symbols: Sequence[Node], values: Sequence[Mapping[Node, int]], seen: Sequence[int], prime: int
) -> tuple[Node, Node] | None:
    """(numerator, denominator) of the least degree that is ``seen`` at the ``values`` of the symbols; None if there is none."""
    for degree in range(1, _DEGREE + 1):
        powers = [p for d in range(degree + 1) for p in combinations_with_replacement(symbols, d)]
        rows = []
        for place, x in zip(values, seen, strict=True):
            row = [_multiply([place[s] for s in power], prime) for power in powers]
            rows.append([*row, *(-x * y % prime for y in row)])
        for found in find_relations(rows, 2 * len(powers), prime):
            over, under = (_polynomial(graph, powers, part) for part in (found[: len(powers)], found[len(powers) :]))
            if under != graph.zero:
                return over, under
    return None


def _multiply(factors: Sequence[int], prime: int) -> int:
    product = 1
    for factor in factors:
        product = product * factor % prime
    return product


def _polynomial(graph: Graph, powers: Sequence[tuple[Node, ...]], coefficients: Sequence[Fraction]) -> Node:
    pairs = zip(powers, coefficients, strict=True)
    return graph.sum([graph.product([graph.number(c), *power]) for power, c in pairs if c])


def _without_quotients(graph: Graph, entries: Sequence[tuple[Node, Node]]) -> list[Node]:
    """The entries times all their denominators, each taken once."""
    unders = list(dict.fromkeys(under for _, under in entries if graph.value(under) is None))
    made = []
    for over, under in entries:
        rest = graph.product([other for other in unders if other != under])
        made.append(graph.div(graph.mul(over, rest), graph.number(graph.value(under) or Fraction(1))))
    return made
