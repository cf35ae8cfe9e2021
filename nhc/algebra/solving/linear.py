"""Linear forms and small linear systems over the graph.

A system is solved in block-triangular order: a maximum matching of its nonzero pattern, then the strongly connected components of
the matched pattern (:mod:`nhc.algebra.solving.blocks`).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.dense import Singular
from nhc.algebra.exact.field import INVERSE
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.exact.signs import STEPS
from nhc.algebra.graph import ADD, MUL, NEG, POW, SYM, Graph, Node
from nhc.algebra.probe import probe_of
from nhc.algebra.rebuilding import rebuild, substitute
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.solving.blocks import Pivots, Weakness, block_order, solve_block
from nhc.algebra.solving.peel import coefficients, peel
from nhc.algebra.solving.sizes import form_size, row_scale
from nhc.algebra.walks import reachable
from nhc.records import fresh, record, structure

_NO_POLYNOMIAL = 99
STEPPED = (*STEPS, "sqrt", "powf", *INVERSE)
"""Operations that may hold a step: signs, roots of squares, and angles, which jump by pi where their arguments pass a pole."""


class NotLinear(Exception):
    """The expression is not linear in the given symbols; ``symbol`` is one in which it is not."""

    def __init__(self, symbol: Node) -> None:
        super().__init__(f"not linear in node {symbol}")
        self.symbol = symbol


def is_clearly_linear(graph: Graph, node: Node, symbols: Sequence[Node]) -> bool:
    """Whether the node is linear in the symbols by sight (False: not known)."""
    return degrees(graph, symbols)[node] <= 1


def degrees(graph: Graph, symbols: Sequence[Node]) -> list[int]:
    """Degree in the symbols of every node of the graph, by sight; a node that is no polynomial in them has degree 99."""
    mask = graph.mask(symbols)
    found: list[int] = graph.memory.setdefault(f"degrees {mask:x}", [])
    op, a, b, deps = graph.op, graph.a, graph.b, graph.deps
    for node in range(len(found), len(op)):
        kind, x = op[node], a[node]
        if not deps[node] & mask:
            degree = 0
        elif kind == SYM:
            degree = 1
        elif kind == ADD:
            degree = max(found[x], found[b[node]])
        elif kind == MUL:
            degree = min(_NO_POLYNOMIAL, found[x] + found[b[node]])
        elif kind == NEG:
            degree = found[x]
        elif kind == POW and b[node] > 0:
            degree = min(_NO_POLYNOMIAL, found[x] * b[node])
        else:
            degree = _NO_POLYNOMIAL
        found.append(degree)
    return found


def depends(graph: Graph, nodes: Sequence[Node], symbols: Sequence[Node]) -> list[bool]:
    """For each node whether its value depends on one of the symbols (exactly, not only by sight).

    A derivative that vanishes says no, but for steps: a sign may change where its derivative is zero on both sides.  There the
    values with these and with other symbols are compared.
    """
    mask = graph.mask(tuple(symbols))
    found = [False] * len(nodes)
    for k, node in enumerate(nodes):
        if not graph.deps[node] & mask:
            continue
        found[k] = not all(are_zero(graph, gradient(graph, node, symbols)))
        if not found[k] and _has_steps(graph, node, mask):
            others = {s: graph.symbol(f"other {s}") for s in symbols}
            found[k] = not is_zero(graph, graph.sub(node, substitute(graph, [node], others, named=False)[0]))
    return found


def steps_with(graph: Graph, nodes: Sequence[Node], symbol: Node) -> bool:
    """Whether a step in one of the nodes, such as a sign, makes it depend on a symbol by which its slope may be zero."""
    stepped = [node for node in nodes if _has_steps(graph, node, graph.deps[symbol])]
    return any(depends(graph, stepped, [symbol]))


def _has_steps(graph: Graph, node: Node, mask: int) -> bool:
    """Whether something takes one of the symbols that may differ by a constant on two sides of a point.

    Signs and what has kinks, roots (of squares), and inverse functions: sums of logarithms are the same on both sides of a pole.
    """
    return any(graph.op[n] in STEPPED and graph.deps[n] & mask for n in reachable(graph, [node], mask))


def linear_form(graph: Graph, node: Node, symbols: Sequence[Node]) -> tuple[tuple[Node, ...], Node]:
    """(coefficients, constant) with node = sum coefficient_k * symbol_k + constant, exactly.

    Raises:
        NotLinear: a coefficient or the constant depends on one of the symbols.
    """
    for n in reachable(graph, [node], graph.mask(tuple(symbols))):
        if graph.op[n] == "powf":  # without a real value on one side of zero
            raise NotLinear(next(s for s in symbols if graph.deps[n] & graph.deps[s]))
    coefficients = gradient(graph, node, symbols)
    for symbol, moving in zip(symbols, depends(graph, coefficients, symbols), strict=True):
        if moving:
            raise NotLinear(symbol)
    rest = graph.sub(node, graph.dot(coefficients, symbols))
    if _has_steps(graph, node, graph.mask(tuple(symbols))):
        stepped = next((s for s in symbols if depends(graph, [rest], [s])[0]), None)
        if stepped is not None:
            raise NotLinear(stepped)
    try:
        cleaned = substitute(graph, [*coefficients, node], dict.fromkeys(symbols, graph.zero), named=False)
    except ZeroDivisionError:  # the same at any other place
        other = {symbol: graph.number(17 + 13 * k * k) for k, symbol in enumerate(symbols)}
        cleaned = substitute(graph, [*coefficients, rest], other, named=False)
    return tuple(cleaned[:-1]), cleaned[-1]


@structure
class Elimination:
    """Unknowns as nodes, and what must not vanish for that: (determinant, scale) pairs."""

    unknowns: list[list[Node]]
    guards: list[tuple[Node, Node]] = fresh(factory=list)


@record
class NamedBlock:
    """A solved block: ``symbols`` stand for ``values``, the solution of matrix @ symbols = right by elimination with ``pivots``."""

    symbols: tuple[Node, ...]
    values: tuple[Node, ...]
    matrix: list[list[Node]]
    right: list[Node]
    pivots: Pivots

    def mapped(self, change: Callable[[Sequence[Node]], Sequence[Node]]) -> NamedBlock:
        """The block with ``change`` applied to all it consists of."""
        return NamedBlock(
            self.symbols,
            tuple(change(self.values)),
            [list(change(row)) for row in self.matrix],
            list(change(self.right)),
            self.pivots,
        )

    def rates(self, graph: Graph, seeds: Mapping[Node, Node]) -> list[Node]:
        """Derivatives of the symbols along the seeds, by the derivative of the equations and the same solution."""
        g = graph
        residual = [g.sub(g.dot(row, self.symbols), value) for row, value in zip(self.matrix, self.right, strict=True)]
        right = [g.neg(node) for node in tangent(g, residual, seeds)]
        return solve_block(g, self.matrix, [right], pivots=self.pivots)[0][0]


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
        whole = [matrix[i] for i in rows]
        solved, guards = solve_block(graph, block, right, weakness, partial(row_scale, graph, whole))
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
    weakness: Weakness | None = None,
    named: list[NamedBlock] | None = None,
) -> tuple[list[Node], list[tuple[Node, Node]]]:
    """(values of the unknowns, guards) for rows = 0, each row linear in the unknowns.

    What rows share stays shared: known unknowns are put into the rows' own nodes, so that a chain of n bodies costs n.  With
    ``named``, unknowns of a block with a determinant that can vanish stay symbols in the values, and the block is added to it.

    Raises:
        Singular: the determinant vanishes identically.
    """
    known = Substitution(graph, unknowns)
    guards: list[tuple[Node, Node]] = []

    mask = graph.mask(unknowns)

    def scale(part: Sequence[int]) -> Node:
        sizes = [form_size(graph, rows[i], mask) for i in part]
        if None in sizes:
            return row_scale(graph, [coefficients(graph, rows[i], unknowns) for i in part])
        return graph.product(shorten(graph, [size for size in sizes if size is not None]))

    for part, columns, block in _blocks_of(graph, rows, unknowns):
        right = [graph.neg(known.without_others(rows[i])) for i in part]
        pivots = Pivots()
        (solved,), found = solve_block(graph, block, [right], weakness, partial(scale, part), pivots)
        guards.extend(found)
        if named is not None and found and len(columns) > 1:
            symbols = [graph.symbol(f"solved_{j}", "unknown") for j in columns]
            named.append(NamedBlock(tuple(symbols), tuple(solved), block, right, pivots))
            solved = symbols
        for j, value in zip(columns, solved, strict=True):
            known.learn(unknowns[j], value)
    return [known.values[symbol] for symbol in unknowns], guards


Block = tuple[Sequence[int], Sequence[int], list[list[Node]]]


def _blocks_of(graph: Graph, rows: Sequence[Node], unknowns: Sequence[Node]) -> list[Block]:
    """(rows, columns, matrix) in an order in which each block needs only the unknowns of earlier ones."""
    peeled = peel(graph, rows, unknowns)
    if len(peeled.rows) != len(peeled.columns):
        raise Singular
    core = [unknowns[j] for j in peeled.columns]
    matrix = [coefficients(graph, rows[i], core) for i in peeled.rows]
    zero_entry = _zero_pattern(graph, matrix)
    found: list[Block] = [((i,), (j,), [[slope]]) for i, j, slope in peeled.first]
    for part, columns in block_order(len(matrix), lambda i, j: not zero_entry[i][j]):
        block = [[graph.zero if zero_entry[i][j] else matrix[i][j] for j in columns] for i in part]
        found.append(([peeled.rows[i] for i in part], [peeled.columns[j] for j in columns], block))
    return found + [((i,), (j,), [[slope]]) for i, j, slope in peeled.last]


def is_clearly_regular(graph: Graph, rows: Sequence[Node], unknowns: Sequence[Node]) -> bool:
    """Whether rows linear in the unknowns are certainly independent (False: not known).  A yes is remembered."""
    asked = (tuple(rows), tuple(unknowns))
    known: set[tuple[tuple[Node, ...], ...]] = graph.memory.setdefault("regular rows", set())
    if asked in known:
        return True
    peeled = peel(graph, rows, unknowns)
    core = [unknowns[j] for j in peeled.columns]
    if len(peeled.rows) > len(core):
        return False
    matrix = [coefficients(graph, rows[i], core) for i in peeled.rows]
    if matrix and not probe_of(graph).has_full_rank(matrix):
        return False
    known.add(asked)
    return True


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
            if not open_now:
                g.pass_label(node, built)
        return self._memo.get(root, new.get(root, root))


def _row_times(graph: Graph, row: Sequence[Node], zero: Sequence[bool], x: Sequence[Node], done: Sequence[int]) -> Node:
    return graph.sum([graph.mul(row[j], x[j]) for j in done if not zero[j]])


def _zero_pattern(graph: Graph, matrix: Sequence[Sequence[Node]]) -> list[list[bool]]:
    flat = [entry for row in matrix for entry in row]
    zeros = are_zero(graph, flat)
    width = len(matrix)
    return [zeros[i * width : (i + 1) * width] for i in range(width)]
