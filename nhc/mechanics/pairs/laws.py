"""The equations of two systems over the symbols of the second, and linear equations at points of a prime field."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.carry import carry
from nhc.algebra.dense import null_space
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.graph import Graph, Node
from nhc.diagnostics import Bag
from nhc.mechanics.certificates.claims import reference_claim
from nhc.mechanics.pairs.pairing import OPTION, Pairing
from nhc.mechanics.system import System
from nhc.records import record

Row = tuple[Node, ...]
"""Coefficients of the velocities, then the constant."""


@record
class Laws:
    """The equations of one system: rows of the constraints, and ``matrix`` x = ``right`` for q'' and the multipliers.

    ``holonomic`` are the places of those that are derivatives of ``equations`` f(q, t) = 0.
    """

    names: tuple[str, ...]
    rows: tuple[Row, ...]
    holonomic: tuple[int, ...]
    equations: tuple[Node, ...]
    matrix: tuple[tuple[Node, ...], ...]
    right: tuple[Node, ...]

    def nodes(self) -> list[Node]:
        """Every node that has to be evaluated."""
        return [x for row in (*self.rows, *self.matrix) for x in row] + [*self.right, *self.equations]


def laws_of(system: System) -> Laws:
    """Straight from T and the constraints (I.4.1)."""
    claim = reference_claim(system)
    held = tuple(k for k, form in enumerate(system.constraints) if form.equation is not None)
    equations = tuple(form.equation for form in system.constraints if form.equation is not None)
    rows = tuple((*form.coefficients, form.constant) for form in system.constraints)
    return Laws(tuple(form.name for form in system.constraints), rows, held, equations, claim.matrix, claim.right)


def carry_laws(laws: Laws, source: Graph, target: Graph, meaning: Mapping[Node, Node]) -> Laws:
    """The same equations on another graph."""
    return with_nodes(laws, carry(source, target, laws.nodes(), meaning))


def with_nodes(laws: Laws, nodes: Sequence[Node]) -> Laws:
    """The same equations with other nodes in the place of theirs."""
    made = iter(nodes)
    rows = tuple(tuple(next(made) for _ in row) for row in laws.rows)
    matrix = tuple(tuple(next(made) for _ in row) for row in laws.matrix)
    right = tuple(next(made) for _ in laws.right)
    return Laws(laws.names, rows, laws.holonomic, tuple(made), matrix, right)


def refuse_closed(pairing: Pairing, laws: Laws) -> None:
    """Refuse equations of positions of the first system that hold coordinates of its own: where they put these is not known.

    Raises:
        nhc.diagnostics.SpecError: E0506 at the equation.
    """
    g, first = pairing.second.graph, pairing.first
    own = g.mask(tuple(g.symbol(first.q_names[i], "coordinate") for i in pairing.alone[0]))
    bag, declared = Bag(first.spec.origin), {entry.name: entry.span for entry in first.spec.holonomic}
    for k, equation in zip(laws.holonomic, laws.equations, strict=True):
        span = declared.get(laws.names[k])
        held = [first.q_names[i] for i in pairing.alone[0] if g.depends(equation, own)]
        if span is not None and held:
            message = f"`{laws.names[k]}` holds `{held[0]}`, which only this spec has"
            help = f"say what `{held[0]}` is in the other spec: `{OPTION} '{held[0]}=...'`; or name the specs in the other order"
            bag.error("E0506", message, span, help=(help,))
    bag.raise_if_errors()


# --- linear equations modulo a prime ------------------------------------------------------------------------


def solution(rows: Sequence[Sequence[int]], free: Sequence[int], prime: int) -> tuple[list[int], list[list[int]]]:
    """x with row @ (x, 1) = 0 for all rows, what these leave free being ``free``; and a basis of the directions they allow.

    Raises:
        nhc.algebra.exact.modular.Unlucky: there is none.
    """
    size = len(free)
    basis = null_space(rows, size + 1, prime)
    if not basis or not basis[-1][size]:
        raise Unlucky
    x, directions = basis[-1][:size], [vector[:size] for vector in basis[:-1]]
    for vector in directions:
        value = free[max(j for j, a in enumerate(vector) if a)]
        x = [(a + value * b) % prime for a, b in zip(x, vector, strict=True)]
    return x, directions


def is_solvable(rows: Sequence[Sequence[int]], prime: int) -> bool:
    """Whether there is an x with row @ (x, 1) = 0 for all rows."""
    basis = null_space(rows, len(rows[0]), prime)
    return bool(basis) and bool(basis[-1][-1])


def products(matrix: Sequence[Sequence[int]], vectors: Sequence[Sequence[int]], prime: int) -> list[list[int]]:
    """matrix @ vector for each of the vectors."""
    return [[sum(a * b for a, b in zip(row, vector, strict=True)) % prime for row in matrix] for vector in vectors]


def values_of(point: FieldPoint, laws: Laws) -> tuple[list[list[int]], list[int]]:
    """The matrix and the right side at a point."""
    return [point.evaluate(row) for row in laws.matrix], point.evaluate(laws.right)
