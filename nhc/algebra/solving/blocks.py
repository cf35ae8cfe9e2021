"""Order and blocks of a linear system over the graph: matching, components, Cramer's rule, elimination.

Blocks up to 3 x 3 are solved by Cramer's rule, whose determinants are brought to canonical form where that is not longer.  Of
larger ones, pivots that are constants are eliminated first; what is left, up to 4 x 4, is solved by Cramer's rule as well, for a
fixed order of elimination has pivots that vanish where the block is regular.  Three rows that are completed by that of their
minors are a block of four that is regular wherever they are independent.  Each determinant and pivot that is not a constant is
returned as a guard: it must not vanish.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from fractions import Fraction

from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import NEG, POW, Graph, Node
from nhc.algebra.rewriting.angles import normalise_angles, shorter_of_angles
from nhc.algebra.rewriting.digits import keep_digits
from nhc.algebra.rewriting.joined import make_product, split_factors
from nhc.algebra.rewriting.shorten import canonical_form, shorten
from nhc.algebra.solving.orthonormal import solve_orthonormal
from nhc.algebra.solving.sizes import row_scale
from nhc.algebra.walks import count, reachable

_LARGEST_AT_ONCE = 3
_IN_SPACE = 3  # rows; of two the determinant shows it
LARGEST_CORE = 4
"""Of rows that are solved by determinants: of more, pivots may vanish where the block is regular."""
LITTLE = Fraction(1, 10)
"""Of a row before elimination, beside what is left of it: digits are lost, too, where little is left."""
_TERMS = 120
Weakness = Callable[[Sequence[Node], Sequence[Node]], list[int]]
Matrix = tuple[tuple[Node, ...], ...]
Pivots = list[tuple[int, int]]
"""(row, column) of each pivot of an elimination, the rows counted after the exchanges before it."""


def block_order(size: int, nonzero: Callable[[int, int], bool]) -> list[tuple[list[int], list[int]]]:
    """Blocks (rows, columns) in an order in which each needs only the unknowns of earlier ones.

    Raises:
        Singular: there is no perfect matching (structurally singular).
    """
    held = [[j for j in range(size) if nonzero(i, j)] for i in range(size)]
    row_of = _matching(held)
    # edge i -> j: the unknown of matched column i needs that of column j
    needs = [[j for j in held[row_of[i]] if j != i] for i in range(size)]
    return [([row_of[j] for j in sorted(part)], sorted(part)) for part in _components(size, needs)]


def _matching(held: Sequence[Sequence[int]]) -> list[int]:
    """For each column the row that it is matched with, by augmenting paths (Kuhn 1955); ``held`` are the columns of each row."""
    size = len(held)
    row_of = [-1] * size

    def augment(row: int, seen: set[int]) -> bool:
        for column in held[row]:
            if column not in seen:
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
    pivots: Pivots | None = None,
) -> tuple[list[list[Node]], list[tuple[Node, Node]]]:
    """Unknowns and guards of one block; ``scale`` gives the product of the 1-norms of its whole rows (1 where it is not given).

    ``pivots`` are taken in their order, or recorded where there are none yet: what is solved again divides by nothing that was
    not guarded the first time.
    """
    size = len(block)
    if "Cramer's rule" in graph.off:
        return _eliminate(graph, block, columns, weakness, 0, pivots)
    if size == _IN_SPACE and "orthonormal rows" not in graph.off:
        solved = solve_orthonormal(graph, block, columns, scale)
        if solved is not None:
            return solved
    if size > _LARGEST_AT_ONCE:
        return _eliminate(graph, block, columns, weakness, LARGEST_CORE, pivots)
    return _solve_by_determinants(graph, block, columns, scale)


def without_sign(graph: Graph, node: Node) -> Node:
    """x for -x."""
    return graph.a[node] if graph.op[node] == NEG else node


def find_eliminated(graph: Graph) -> dict[Node, Matrix]:
    """For each pivot, without its sign, of an elimination in a fixed order the block that it is one of.

    Such a pivot may vanish where the block is regular.  One that stands alone among constants is not here: it is the determinant.
    """
    found: dict[Node, Matrix] = graph.memory.setdefault("eliminated", {})
    return found


def _solve_by_determinants(
    graph: Graph, block: Sequence[Sequence[Node]], columns: Sequence[Sequence[Node]], scale: Callable[[], Node] | None
) -> tuple[list[list[Node]], list[tuple[Node, Node]]]:
    """Cramer's rule: regular wherever the block is."""
    size = len(block)
    whole = determinant_of(graph, block)
    short = normalise_angles(graph, whole, _TERMS) if size == 1 else shorter_of_angles(graph, whole, _TERMS)
    (determinant,) = keep_digits(graph, [whole], [short])
    if is_zero(graph, determinant):
        raise Singular
    guards = [] if graph.value(determinant) is not None else [(determinant, scale() if scale else graph.one)]
    solved = []
    for column in columns:
        numerators = (_numerator(graph, block, column, k) for k in range(size))
        solved.append([_divide(graph, numerator, determinant) for numerator in numerators])
    return solved, guards


def _numerator(graph: Graph, block: Sequence[Sequence[Node]], column: Sequence[Node], k: int) -> Node:
    """Of Cramer's rule: the determinant of the block with ``column`` in place of its k-th one.

    For more than three rows it is expanded along that column: short where few of its entries are not zero, as one alone is beside
    a row of minors.
    """
    if len(block) <= 3:
        return determinant_of(graph, [[*r[:k], column[i], *r[k + 1 :]] for i, r in enumerate(block)])
    terms = []
    for i, value in enumerate(column):
        if value != graph.zero:
            minor = determinant_of(graph, [[*r[:k], *r[k + 1 :]] for m, r in enumerate(block) if m != i])
            terms.append(graph.mul(graph.neg(value) if (i + k) % 2 else value, minor))
    return graph.sum(terms)


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


def _divide(graph: Graph, numerator: Node, divisor: Node) -> Node:
    """The quotient without its divisor where this is a factor of all that is divided; else as it is, with what it shares.

    Factors of both are left out, for which the numerator is brought to canonical form where that is shorter.
    """
    quotient = graph.div(numerator, divisor)
    divisions = _divisions(graph, quotient)
    if _divisions(graph, canonical_form(graph, quotient)) < divisions:
        (short,) = shorten(graph, [quotient])
        if _divisions(graph, short) < divisions:
            return short
    number, left = split_factors(graph, divisor)
    if len(left) < 2:
        return quotient
    first, powers = split_factors(graph, shorten(graph, [numerator])[0])
    lowest = Counter(dict(powers))
    lowest.subtract(dict(left))
    made = make_product(graph, tuple(sorted((x, n) for x, n in lowest.items() if n)), first * Fraction(1) / number)
    return made if count(graph, [made]) < count(graph, [quotient]) else quotient


def _divisions(graph: Graph, node: Node) -> int:
    return sum(graph.op[part] == POW and graph.b[part] < 0 for part in reachable(graph, [node]))


def _eliminate(
    graph: Graph,
    block: Sequence[Sequence[Node]],
    columns: Sequence[Sequence[Node]],
    weakness: Weakness | None,
    core: int,
    pivots: Pivots | None,
) -> tuple[list[list[Node]], list[tuple[Node, Node]]]:
    """Elimination: pivots that are constants while there are any, then Cramer's rule if no more than ``core`` rows are left.

    Of more rows the pivot is the one that is weak most rarely.  Such a pivot may vanish where the block is regular, so that
    determinants of what it leaves would gain nothing, and they are longer.
    """
    size = len(block)
    rows = [[*row, *(column[i] for column in columns)] for i, row in enumerate(block)]
    origin = list(range(size))
    guards: list[tuple[Node, Node]] = []
    grown: list[tuple[Node, Node]] = []
    order: list[int] = []
    given, taken = iter(pivots or ()), Pivots()
    for step in range(size):
        if pivots:
            found = next(given, None)
            if found is None:
                break
        else:
            found = _constant_pivot(graph, rows, step, order, size)
            if found is None and size - step <= core and not guards:
                break
        row, column = found or _pivot(graph, rows, step, order, size, weakness)
        taken.append((row, column))
        rows[step], rows[row] = rows[row], rows[step]
        origin[step], origin[row] = origin[row], origin[step]
        order.append(column)
        pivot = rows[step][column]
        if graph.value(pivot) is None:
            guards.append((pivot, row_scale(graph, [rows[step][:size]])))
            grown.append((pivot, _size_now(graph, rows[step][:size], block[origin[step]])))
        inverse = graph.inverse(pivot)
        rows[step] = [graph.mul(entry, inverse) if entry != graph.zero else entry for entry in rows[step]]
        for i in range(size):
            if i != step and rows[i][column] != graph.zero:
                rows[i] = _without(graph, rows[i], rows[step], column)
    if pivots is not None:
        pivots[:] = taken
    if len(grown) > 1:
        whole = tuple(map(tuple, block))
        find_eliminated(graph).update((without_sign(graph, pivot), whole) for pivot, _ in grown)
        guards = grown
    left = [j for j in range(size) if j not in order]
    rest, more = _solve_core(graph, rows, left, size) if left else ([[]] * len(columns), [])
    solved = []
    for c, known in enumerate(rest):
        x = [graph.zero] * size
        for column, value in zip(left, known, strict=True):
            x[column] = value
        for own, column in zip(rows, order, strict=False):
            x[column] = graph.sub(own[size + c], graph.dot([own[j] for j in left], known))
        solved.append(x)
    return solved, [*guards, *more]


def _size_now(graph: Graph, row: Sequence[Node], given: Sequence[Node]) -> Node:
    """What a pivot is small against: the entries beside it, as large as they are, and a part of its row before the elimination.

    The sizes of their terms, without their signs, grow with each pivot before, and say nothing after a few of them.
    """
    g = graph
    now = g.sum([g.function("abs", entry) for entry in row])
    return g.add(now, g.mul(g.number(LITTLE), row_scale(g, [given])))


def _without(graph: Graph, row: Sequence[Node], by: Sequence[Node], column: int) -> list[Node]:
    """A row less the multiple of another, whose entry in the column is 1, that leaves nothing there."""
    factor = row[column]
    new = [graph.sub(x, graph.mul(factor, y)) if y != graph.zero else x for x, y in zip(row, by, strict=True)]
    new[column] = graph.zero
    return new


def _solve_core(
    graph: Graph, rows: Sequence[Sequence[Node]], left: Sequence[int], size: int
) -> tuple[list[list[Node]], list[tuple[Node, Node]]]:
    """The last rows of an elimination for the columns that are left, with their right sides from ``size`` on."""
    own = rows[size - len(left) :]
    entries = [row[j] for row in own for j in left]
    short = iter(keep_digits(graph, entries, [shorter_of_angles(graph, entry, _TERMS) for entry in entries]))
    core = [[next(short) for _ in left] for _ in left]
    columns = [[row[k] for row in own] for k in range(size, len(own[0]))]
    return _solve_by_determinants(graph, core, columns, lambda: row_scale(graph, core))


def _constant_pivot(
    graph: Graph, rows: Sequence[Sequence[Node]], step: int, used: Sequence[int], size: int
) -> tuple[int, int] | None:
    """The first entry that is a number but zero."""
    places = ((i, j) for i in range(step, size) for j in range(size) if j not in used)
    return next((place for place in places if graph.value(rows[place[0]][place[1]]) not in (None, 0)), None)


def _pivot(
    graph: Graph,
    rows: Sequence[Sequence[Node]],
    step: int,
    used: Sequence[int],
    size: int,
    weakness: Weakness | None,
) -> tuple[int, int]:
    """The pivot that is weak at the fewest trial points, of those the one of the fewest symbols."""
    candidates = [(i, j) for i in range(step, size) for j in range(size) if j not in used and rows[i][j] != graph.zero]
    zero = are_zero(graph, [rows[i][j] for i, j in candidates])
    alive = [c for c, z in zip(candidates, zero, strict=True) if not z]
    if not alive:
        raise Singular
    weak = [0] * len(alive)
    if weakness is not None:
        scales = {i: graph.sum([graph.function("abs", rows[i][j]) for j in range(size)]) for i, _ in alive}
        weak = weakness([rows[i][j] for i, j in alive], [scales[i] for i, _ in alive])
    order = {c: (w, graph.deps[rows[c[0]][c[1]]].bit_count(), c) for c, w in zip(alive, weak, strict=True)}
    return min(alive, key=lambda c: order[c])
