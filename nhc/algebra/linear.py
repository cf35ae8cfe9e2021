"""Linear forms and small linear systems over the graph.

A system is solved in block-triangular order: a maximum matching of its nonzero pattern, then the strongly connected components of
the matched pattern.  Blocks up to 3 x 3 are solved by Cramer's rule, whose determinants are brought to canonical form, larger ones
by elimination in a fixed order.  Each determinant that is not a constant is returned as a guard: it must not vanish.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from nhc.algebra.calculus import gradient, reachable, rebuild, substitute
from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.modular import are_zero
from nhc.algebra.polynomial import normalise

Weakness = Callable[[Sequence[Node], Sequence[Node]], list[int]]


class NotLinear(Exception):
    """The expression is not linear in the given symbols; ``symbol`` is one in which it is not."""

    def __init__(self, symbol: Node) -> None:
        super().__init__(f"not linear in node {symbol}")
        self.symbol = symbol


class Singular(Exception):
    """The matrix has no inverse, identically."""


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
        solved, guards = _solve_block(graph, block, right, scales, weakness)
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
) -> tuple[list[Node], list[tuple[Node, Node]]]:
    """(values of the unknowns, guards) for rows = 0, each row linear in the unknowns with the coefficients ``matrix``.

    What rows share stays shared: known unknowns are put into the rows' own nodes, so that a chain of n bodies costs n.

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
        (solved,), found = _solve_block(graph, block, [right], scales, weakness)
        guards.extend(found)
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


def block_order(size: int, nonzero: Callable[[int, int], bool]) -> list[tuple[list[int], list[int]]]:
    """Blocks (rows, columns) in an order in which each needs only the unknowns of earlier ones.

    Raises:
        Singular: there is no perfect matching (structurally singular).
    """
    match_of_column = _matching(size, nonzero)
    row_of = match_of_column
    # edge i -> j: the unknown of matched column i needs that of column j
    needs = [[j for j in range(size) if j != i and nonzero(row_of[i], j)] for i in range(size)]
    return [([row_of[j] for j in sorted(part)], sorted(part)) for part in _components(size, needs)]


def _matching(size: int, nonzero: Callable[[int, int], bool]) -> list[int]:
    row_of = [-1] * size

    def augment(row: int, seen: set[int]) -> bool:
        for column in range(size):
            if nonzero(row, column) and column not in seen:
                seen.add(column)
                if row_of[column] < 0 or augment(row_of[column], seen):
                    row_of[column] = row
                    return True
        return False

    for row in range(size):
        if not augment(row, set()):
            raise Singular
    return row_of


def _components(size: int, edges: Sequence[Sequence[int]]) -> list[list[int]]:
    """Strongly connected components, each after those it points to (Tarjan 1972), without recursion."""
    index, low = [-1] * size, [0] * size
    on_stack, stack, result = [False] * size, [], []
    counter = 0
    for start in range(size):
        if index[start] >= 0:
            continue
        work: list[tuple[int, int]] = [(start, 0)]
        while work:
            node, position = work.pop()
            if position == 0:
                index[node] = low[node] = counter
                counter += 1
                stack.append(node)
                on_stack[node] = True
            for k in range(position, len(edges[node])):
                target = edges[node][k]
                if index[target] < 0:
                    work.append((node, k + 1))
                    work.append((target, 0))
                    break
                if on_stack[target]:
                    low[node] = min(low[node], index[target])
            else:
                if low[node] == index[node]:
                    part = []
                    while True:
                        top = stack.pop()
                        on_stack[top] = False
                        part.append(top)
                        if top == node:
                            break
                    result.append(part)
                if work:
                    parent = work[-1][0]
                    low[parent] = min(low[parent], low[node])
    return result


def _solve_block(
    graph: Graph,
    block: Sequence[Sequence[Node]],
    columns: Sequence[Sequence[Node]],
    scales: Sequence[Node],
    weakness: Weakness | None,
) -> tuple[list[list[Node]], list[tuple[Node, Node]]]:
    """Unknowns and guards of one block; ``scales`` are the 1-norms of its whole rows."""
    size = len(block)
    if size > 3:
        return _eliminate(graph, block, columns, weakness)
    determinant = normalise(graph, determinant_of(graph, block), 120)
    if are_zero(graph, [determinant])[0]:
        raise Singular
    guards = [] if graph.value(determinant) is not None else [(determinant, graph.product(scales))]
    solved = []
    for column in columns:
        row = []
        for k in range(size):
            replaced = [[*r[:k], column[i], *r[k + 1 :]] for i, r in enumerate(block)]
            row.append(graph.div(determinant_of(graph, replaced), determinant))
        solved.append(row)
    return solved, guards


def row_scale(graph: Graph, block: Sequence[Sequence[Node]]) -> Node:
    """Product over the rows of how large their entries can be: what a determinant is measured against."""
    return graph.product([graph.sum([size_of(graph, entry) for entry in row]) for row in block])


def size_of(graph: Graph, root: Node) -> Node:
    """A bound on |root| that does not vanish with it: sines and cosines count 1, differences count as sums."""
    size: dict[Node, Node] = {}
    for node in reachable(graph, [root]):
        op, a, b = graph.op[node], graph.a[node], graph.b[node]
        if op == ADD:
            size[node] = graph.add(size[a], size[b])
        elif op == MUL:
            size[node] = graph.mul(size[a], size[b])
        elif op == NEG:
            size[node] = size[a]
        elif op == POW and b > 0:
            size[node] = graph.power(size[a], b)
        elif op in ("sin", "cos"):
            size[node] = graph.one
        else:
            size[node] = graph.function("abs", node)
    return size[root]


def determinant_of(graph: Graph, block: Sequence[Sequence[Node]]) -> Node:
    """By expansion along the first row (meant for small blocks)."""
    if not block:
        return graph.one
    if len(block) == 1:
        return block[0][0]
    total = graph.zero
    for j, entry in enumerate(block[0]):
        if entry == graph.zero:
            continue
        minor = [[*row[:j], *row[j + 1 :]] for row in block[1:]]
        term = graph.mul(entry, determinant_of(graph, minor))
        total = graph.sub(total, term) if j % 2 else graph.add(total, term)
    return total


def _eliminate(
    graph: Graph, block: Sequence[Sequence[Node]], columns: Sequence[Sequence[Node]], weakness: Weakness | None
) -> tuple[list[list[Node]], list[tuple[Node, Node]]]:
    """Elimination in a fixed order; each pivot is a constant where there is one, else the one that is weak most rarely."""
    size = len(block)
    rows = [[*row, *(column[i] for column in columns)] for i, row in enumerate(block)]
    guards: list[tuple[Node, Node]] = []
    order: list[int] = []
    for step in range(size):
        row, column = _pivot(graph, rows, step, order, size, weakness)
        rows[step], rows[row] = rows[row], rows[step]
        order.append(column)
        pivot = rows[step][column]
        if graph.value(pivot) is None:
            guards.append((pivot, row_scale(graph, [rows[step][:size]])))
        inverse = graph.inverse(pivot)
        rows[step] = [graph.mul(entry, inverse) if entry != graph.zero else entry for entry in rows[step]]
        for i in range(size):
            factor = rows[i][column]
            if i == step or factor == graph.zero:
                continue
            rows[i] = [
                graph.sub(x, graph.mul(factor, y)) if y != graph.zero else x
                for x, y in zip(rows[i], rows[step], strict=True)
            ]
            rows[i][column] = graph.zero
    solved = []
    for c in range(len(columns)):
        x = [graph.zero] * size
        for step, column in enumerate(order):
            x[column] = rows[step][size + c]
        solved.append(x)
    return solved, guards


def _pivot(
    graph: Graph, rows: list[list[Node]], step: int, used: list[int], size: int, weakness: Weakness | None
) -> tuple[int, int]:
    candidates = [(i, j) for i in range(step, size) for j in range(size) if j not in used and rows[i][j] != graph.zero]
    zero = are_zero(graph, [rows[i][j] for i, j in candidates])
    alive = [c for c, z in zip(candidates, zero, strict=True) if not z]
    if not alive:
        raise Singular
    constant = [(i, j) for i, j in alive if graph.value(rows[i][j]) is not None]
    if constant:
        return constant[0]
    weak = [0] * len(alive)
    if weakness is not None:
        scales = {i: graph.sum([graph.function("abs", rows[i][j]) for j in range(size)]) for i, _ in alive}
        weak = weakness([rows[i][j] for i, j in alive], [scales[i] for i, _ in alive])
    order = {c: (w, graph.deps[rows[c[0]][c[1]]].bit_count(), c) for c, w in zip(alive, weak, strict=True)}
    return min(alive, key=lambda c: order[c])
