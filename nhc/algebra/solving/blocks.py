"""Order and blocks of a linear system over the graph: matching, components, Cramer's rule, elimination.

Blocks up to 3 x 3 are solved by Cramer's rule, whose determinants are brought to canonical form where that is not longer, larger
ones by elimination in a fixed order.  Each determinant that is not a constant is returned as a guard: it must not vanish.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nhc.algebra.calculus import reachable
from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import ADD, MUL, NEG, POW, SYM, Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rewriting.angles import normalise_angles, shorter_of_angles
from nhc.algebra.rewriting.digits import keep_digits
from nhc.algebra.rewriting.shorten import shorten

_FEW_TERMS = 12
_FEW_FACTORS = 8
Weakness = Callable[[Sequence[Node], Sequence[Node]], list[int]]


def block_order(size: int, nonzero: Callable[[int, int], bool]) -> list[tuple[list[int], list[int]]]:
    """Blocks (rows, columns) in an order in which each needs only the unknowns of earlier ones.

    Raises:
        Singular: there is no perfect matching (structurally singular).
    """
    row_of = _matching(size, nonzero)
    # edge i -> j: the unknown of matched column i needs that of column j
    needs = [[j for j in range(size) if j != i and nonzero(row_of[i], j)] for i in range(size)]
    return [([row_of[j] for j in sorted(part)], sorted(part)) for part in _components(size, needs)]


def _matching(size: int, nonzero: Callable[[int, int], bool]) -> list[int]:
    """For each column the row that it is matched with, by augmenting paths (Kuhn 1955)."""
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


def solve_block(
    graph: Graph,
    block: Sequence[Sequence[Node]],
    columns: Sequence[Sequence[Node]],
    weakness: Weakness | None = None,
    scale: Callable[[], Node] | None = None,
) -> tuple[list[list[Node]], list[tuple[Node, Node]]]:
    """Unknowns and guards of one block; ``scale`` gives the product of the 1-norms of its whole rows (1 where it is not given)."""
    size = len(block)
    if size > 3 or "Cramer's rule" in graph.off:
        return _eliminate(graph, block, columns, weakness)
    whole = determinant_of(graph, block)
    short = normalise_angles(graph, whole, 120) if size == 1 else shorter_of_angles(graph, whole, 120)
    (determinant,) = keep_digits(graph, [whole], [short])
    if is_zero(graph, determinant):
        raise Singular
    guards = [] if graph.value(determinant) is not None else [(determinant, scale() if scale else graph.one)]
    solved = []
    for column in columns:
        row = []
        for k in range(size):
            replaced = [[*r[:k], column[i], *r[k + 1 :]] for i, r in enumerate(block)]
            row.append(_cancel(graph, graph.div(determinant_of(graph, replaced), determinant)))
        solved.append(row)
    return solved, guards


def row_scale(graph: Graph, block: Sequence[Sequence[Node]]) -> Node:
    """Product over the rows of how large their entries can be: what a determinant is measured against."""
    sums = [graph.sum([size_of(graph, entry) for entry in row]) for row in block]
    return graph.product(shorten(graph, sums))


def form_size(graph: Graph, row: Node, unknowns: int) -> Node | None:
    """The sum of the sizes of the coefficients of a row that is linear in the symbols of a mask; None where it is not by sight.

    It is found on the row's own nodes, so that what rows share is measured once.
    """
    g = graph
    known: dict[Node, Node] = g.memory.setdefault(f"sizes of forms {unknowns:x}", {})
    pending = [node for node in reachable(g, [row], unknowns) if node not in known]
    for node in pending:
        op, moving = g.op[node], [c for c in g.kids[node] if g.deps[c] & unknowns]
        if op == SYM:
            known[node] = g.one
        elif op == NEG or (op == ADD and len(moving) == 1):
            known[node] = known[moving[0]]
        elif op == ADD:
            known[node] = normalise(g, g.add(known[moving[0]], known[moving[1]]), _FEW_TERMS)
        elif op == MUL and len(moving) == 1:
            still = g.a[node] if moving[0] == g.b[node] else g.b[node]
            known[node] = g.mul(known[moving[0]], size_of(g, still))
        else:
            return None
    return known.get(row, g.zero)


def size_of(graph: Graph, root: Node) -> Node:
    """A bound on |root| that does not vanish with it: sines and cosines count 1, differences count as sums.

    A component over the length of its vector, x/sqrt(x^2 + y^2), counts 1 as well.
    """
    size: dict[Node, Node] = graph.memory.setdefault("sizes", {})
    if root in size:
        return size[root]
    for node in reachable(graph, [root]):
        if node in size:
            continue
        op, a, b = graph.op[node], graph.a[node], graph.b[node]
        rest = _unit_component(graph, node) if op == MUL else None
        if rest is not None:
            size[node] = graph.product([size[x] for x in rest])
        elif op == ADD:
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


def _unit_component(graph: Graph, node: Node) -> list[Node] | None:
    """The other factors of a product that holds x and 1/sqrt(x^2 + ...)."""
    g = graph
    factors, stack = list[Node](), [node]
    while stack:
        top = stack.pop()
        if g.op[top] == MUL and len(factors) + len(stack) < _FEW_FACTORS:
            stack += [g.b[top], g.a[top]]
        else:
            factors.append(top)
    for length in factors:
        if g.op[length] != POW or g.b[length] != -1 or g.op[g.a[length]] != "sqrt":
            continue
        squares, terms = set[Node](), [g.a[g.a[length]]]
        while terms:
            top = terms.pop()
            if g.op[top] == ADD:
                terms += [g.a[top], g.b[top]]
            elif g.op[top] == POW and g.b[top] == 2:
                squares.add(g.a[top])
        for x in factors:
            if x in squares:
                left = list(factors)
                left.remove(x)
                left.remove(length)
                return left
        inner = _as_one_factor(g, factors, squares)
        if inner is not None:
            left = list(factors)
            for x in (*inner, length):
                left.remove(x)
            return left
    return None


def _as_one_factor(graph: Graph, factors: Sequence[Node], squares: set[Node]) -> tuple[Node, Node] | None:
    """Two factors whose product is one of the squared nodes."""
    for k, x in enumerate(factors):
        for y in factors[k + 1 :]:
            if graph.mul(x, y) in squares:
                return x, y
    return None


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


def _cancel(graph: Graph, quotient: Node) -> Node:
    """The quotient without its divisor where this is a factor of all that is divided; else as it is, with what it shares."""
    (short,) = shorten(graph, [quotient])
    return short if _divisions(graph, short) < _divisions(graph, quotient) else quotient


def _divisions(graph: Graph, node: Node) -> int:
    return sum(graph.op[part] == POW and graph.b[part] < 0 for part in reachable(graph, [node]))


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
