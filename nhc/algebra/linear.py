"""Linear forms and small linear systems over the graph.

A system is solved in block-triangular order: a maximum matching of its nonzero pattern, then the strongly connected components of
the matched pattern (:mod:`nhc.algebra.blocks`).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from nhc.algebra.blocks import Singular, Weakness, block_order, determinant_of, row_scale, solve_block
from nhc.algebra.calculus import gradient, rebuild, substitute, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.modular import are_zero

__all__ = [
    "Elimination",
    "NotLinear",
    "Singular",
    "Substitution",
    "block_order",
    "determinant_of",
    "linear_form",
    "solve",
    "solve_rows",
]


class NotLinear(Exception):
    """The expression is not linear in the given symbols; ``symbol`` is one in which it is not."""

    def __init__(self, symbol: Node) -> None:
        super().__init__(f"not linear in node {symbol}")
        self.symbol = symbol


def linear_form(graph: Graph, node: Node, symbols: Sequence[Node]) -> tuple[tuple[Node, ...], Node]:
    """(coefficients, constant) with node = sum coefficient_k * symbol_k + constant, exactly.

    Raises:
        NotLinear: a coefficient depends on one of the symbols.
    """
    mask = graph.mask(tuple(symbols))
    coefficients = gradient(graph, node, symbols)
    for k, coefficient in enumerate(coefficients):
        if graph.depends(coefficient, mask):
            second = gradient(graph, coefficient, symbols)
            if not all(are_zero(graph, second)):
                raise NotLinear(symbols[k])
    zeros = {symbol: graph.zero for symbol in symbols}
    cleaned = substitute(graph, [*coefficients, node], zeros)
    return tuple(cleaned[:-1]), cleaned[-1]


@dataclass
class Elimination:
    """Unknowns as nodes, and what must not vanish for that: (determinant, scale) pairs."""

    unknowns: list[list[Node]]
    guards: list[tuple[Node, Node]] = field(default_factory=list)


@dataclass(frozen=True)
class NamedBlock:
    """A solved block: ``symbols`` stand for ``values``, the solution of matrix @ symbols = right."""

    symbols: tuple[Node, ...]
    values: tuple[Node, ...]
    matrix: list[list[Node]]
    right: list[Node]
    scales: list[Node]

    def mapped(self, change: Callable[[Sequence[Node]], Sequence[Node]]) -> NamedBlock:
        """The block with ``change`` applied to all it consists of."""
        return NamedBlock(
            self.symbols,
            tuple(change(self.values)),
            [list(change(row)) for row in self.matrix],
            list(change(self.right)),
            list(change(self.scales)),
        )

    def rates(self, graph: Graph, seeds: Mapping[Node, Node]) -> list[Node]:
        """Derivatives of the symbols along the seeds, by the derivative of the equations and the same solution."""
        g = graph
        residual = [
            g.sub(g.sum([g.mul(a, x) for a, x in zip(row, self.symbols, strict=True)]), value)
            for row, value in zip(self.matrix, self.right, strict=True)
        ]
        right = [g.neg(node) for node in tangent(g, residual, seeds)]
        return solve_block(g, self.matrix, [right], self.scales, None)[0][0]


def solve(
    graph: Graph,
    matrix: Sequence[Sequence[Node]],
    columns: Sequence[Sequence[Node]],
    weakness: Weakness | None = None,
) -> Elimination:
    """x with matrix @ x = column for each column (``columns[c][i]``); ``unknowns[c][i]``.

    ``weakness(pivots, scales)`` counts for each pivot at how many ordinary points it is small; large blocks avoid such pivots.

    Raises:
        Singular: the determinant vanishes identically.
    """
    size = len(matrix)
    zero_entry = _zero_pattern(graph, matrix)
    blocks = block_order(size, lambda i, j: not zero_entry[i][j])
    x: list[list[Node]] = [[graph.zero] * size for _ in columns]
    result = Elimination(x)
    done: list[int] = []
    for rows, cols in blocks:
        block = [[graph.zero if zero_entry[i][j] else matrix[i][j] for j in cols] for i in rows]
        right = [
            [graph.sub(column[i], _row_times(graph, matrix[i], zero_entry[i], x[c], done)) for i in rows]
            for c, column in enumerate(columns)
        ]
        scales = [row_scale(graph, [matrix[i]]) for i in rows]
        solved, guards = solve_block(graph, block, right, scales, weakness)
        result.guards.extend(guards)
        for c in range(len(columns)):
            for k, j in enumerate(cols):
                x[c][j] = solved[c][k]
        done.extend(cols)
    return result


def solve_rows(
    graph: Graph,
    rows: Sequence[Node],
    unknowns: Sequence[Node],
    matrix: Sequence[Sequence[Node]],
    weakness: Weakness | None = None,
    named: list[NamedBlock] | None = None,
) -> tuple[list[Node], list[tuple[Node, Node]]]:
    """(values of the unknowns, guards) for rows = 0, each row linear in the unknowns with the coefficients ``matrix``.

    What rows share stays shared: known unknowns are put into the rows' own nodes, so that a chain of n bodies costs n.  With
    ``named``, unknowns of a block with a determinant that can vanish stay symbols in the values, and the block is added to it.

    Raises:
        Singular: the determinant vanishes identically.
    """
    zero_entry = _zero_pattern(graph, matrix)
    blocks = block_order(len(rows), lambda i, j: not zero_entry[i][j])
    known = Substitution(graph, unknowns)
    guards: list[tuple[Node, Node]] = []
    for part, columns in blocks:
        block = [[graph.zero if zero_entry[i][j] else matrix[i][j] for j in columns] for i in part]
        right = [graph.neg(known.without_others(rows[i])) for i in part]
        scales = [row_scale(graph, [matrix[i]]) for i in part]
        (solved,), found = solve_block(graph, block, [right], scales, weakness)
        guards.extend(found)
        if named is not None and found and len(columns) > 1:
            symbols = [graph.symbol(f"solved_{j}", "unknown") for j in columns]
            named.append(NamedBlock(tuple(symbols), tuple(solved), block, right, scales))
            solved = symbols
        for j, value in zip(columns, solved, strict=True):
            known.learn(unknowns[j], value)
    return [known.values[symbol] for symbol in unknowns], guards


class Substitution:
    """Values for symbols that become known one after another; what is fully known is rebuilt once."""

    def __init__(self, graph: Graph, symbols: Sequence[Node]) -> None:
        self.graph, self.values = graph, dict[Node, Node]()
        self._open = graph.mask(tuple(symbols))
        self._all = self._open
        self._memo: dict[Node, Node] = {}

    def learn(self, symbol: Node, value: Node) -> None:
        self.values[symbol] = self._memo[symbol] = value
        self._open &= ~self.graph.deps[symbol]

    def without_others(self, root: Node) -> Node:
        """The root with known symbols at their values and all others zero."""
        g, new = self.graph, dict[Node, Node]()
        stack = [root]
        while stack:
            node = stack[-1]
            if node in new or node in self._memo or not g.deps[node] & self._all:
                stack.pop()
                continue
            missing = [c for c in g.children(node) if g.deps[c] & self._all and c not in new and c not in self._memo]
            if missing:
                stack.extend(missing)
                continue
            stack.pop()
            open_now = bool(g.deps[node] & self._open)
            if not g.children(node):
                new[node] = g.zero
                continue
            built = rebuild(g, node, [self._memo.get(c, new.get(c, c)) for c in g.children(node)])
            (new if open_now else self._memo)[node] = built
            label = g.labels.get(node)
            if label is not None and not open_now:
                g.labels.setdefault(built, label)
        return self._memo.get(root, new.get(root, root))


def _row_times(graph: Graph, row: Sequence[Node], zero: Sequence[bool], x: Sequence[Node], done: Sequence[int]) -> Node:
    return graph.sum([graph.mul(row[j], x[j]) for j in done if not zero[j]])


def _zero_pattern(graph: Graph, matrix: Sequence[Sequence[Node]]) -> list[list[bool]]:
    flat = [entry for row in matrix for entry in row]
    zeros = are_zero(graph, flat)
    width = len(matrix)
    return [zeros[i * width : (i + 1) * width] for i in range(width)]
