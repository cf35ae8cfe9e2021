"""What a function has to compute, in nodes: the step between equations and statements."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.shorten import shorten
from nhc.program.ir import Argument, Origin
from nhc.records import record


@record
class Target:
    """``array[index] = node``."""

    index: int
    node: Node
    about: str = ""
    origin: Origin = Origin()


@record
class Entry:
    """A value that a function writes, what it is, its place in the spec, and its equation's number (None: the function's)."""

    node: Node
    about: str = ""
    place: str = ""
    equation: str | None = None


@record
class GuardPlan:
    """``|value|`` must exceed ``tolerance * scale``."""

    value: Node
    scale: Node
    tolerance: float
    status: int
    what: str


@record
class SolvePlan:
    """A dense system whose solution binds ``symbols[c][i]``; later stages may use them."""

    matrix: tuple[tuple[Node, ...], ...]
    columns: tuple[tuple[Node, ...], ...]
    symbols: tuple[tuple[Node, ...], ...]
    tolerance: float
    status: int
    what: str
    plain: bool = False


@record
class SweepPlan:
    """``targets`` once per pass, linear in the symbols ``seeds``: in pass k the k-th one is 1 and the others are 0.

    A target's index counts from the pass's entry of ``offsets``.
    """

    about: str
    seeds: tuple[Node, ...]
    offsets: tuple[int, ...]
    targets: tuple[Target, ...]


@record
class FunctionPlan:
    """``loads`` maps a symbol to (array, index, about); ``result`` is the scalar value of a function without output array.

    ``calls``: (function, array, size) of other functions whose output the loads may name.
    """

    name: str
    about: str
    equation: str
    inputs: tuple[Argument, ...]
    output: Argument | None
    loads: dict[Node, tuple[str, int, str]]
    targets: tuple[Target, ...] = ()
    result: Node | None = None
    guards: tuple[GuardPlan, ...] = ()
    solves: tuple[SolvePlan, ...] = ()
    sweeps: tuple[SweepPlan, ...] = ()
    calls: tuple[tuple[str, str, int], ...] = ()

    def roots(self) -> list[Node]:
        """All nodes that the function computes for its results, guards, solves and sweeps."""
        found = [target.node for target in self.targets]
        if self.result is not None:
            found.append(self.result)
        for guard in self.guards:
            found += [guard.value, guard.scale]
        for solve in self.solves:
            found += [n for row in (*solve.matrix, *solve.columns) for n in row]
        found += [target.node for sweep in self.sweeps for target in sweep.targets]
        return found


def map_nodes(plan: FunctionPlan, change: Callable[[list[Node]], list[Node]]) -> FunctionPlan:
    """The plan with its nodes changed, all at once; with sweeps as it is, since these share nodes with what is before them."""
    if plan.sweeps:
        return plan
    targets, guards = [t.node for t in plan.targets], [n for guard in plan.guards for n in (guard.value, guard.scale)]
    dense = [n for solve in plan.solves for row in (*solve.matrix, *solve.columns) for n in row]
    result = [] if plan.result is None else [plan.result]
    new = iter(change([*targets, *guards, *dense, *result]))

    def take(rows: Sequence[Sequence[Node]]) -> tuple[tuple[Node, ...], ...]:
        return tuple(tuple(next(new) for _ in row) for row in rows)

    return replace(
        plan,
        targets=tuple(replace(t, node=next(new)) for t in plan.targets),
        guards=tuple(replace(guard, value=next(new), scale=next(new)) for guard in plan.guards),
        solves=tuple(replace(solve, matrix=take(solve.matrix), columns=take(solve.columns)) for solve in plan.solves),
        result=next(new) if result else None,
    )


@record
class Factors:
    """L (unit lower, below the diagonal), the pivots d and their reciprocals of a symmetric matrix L D L^T, whose rows and columns
    are taken in this ``order``.
    """

    lower: tuple[tuple[Node, ...], ...]
    pivots: tuple[Node, ...]
    reciprocals: tuple[Node, ...]
    order: tuple[int, ...]


def elimination_order(pattern: Sequence[int]) -> list[int]:
    """The order in which the fewest entries arise; ``pattern[i]`` has the bits of row i's entries that are not zero.

    As given, or each time a row with the fewest entries next (W. F. Tinney and J. W. Walker, Proc. IEEE 55 (1967) 1801), where
    that takes fewer operations: any order is stable for a positive matrix.
    """
    size = len(pattern)
    given, taken = _Elimination(pattern), _Elimination(pattern)
    for k in range(size):
        given.take(k)
    left, order = list(range(size)), list[int]()
    while left:
        k = min(left, key=taken.width)
        left.remove(k)
        order.append(k)
        taken.take(k)
    return order if taken.work < given.work else list(range(size))


class _Elimination:
    """Which entries arise while rows are taken away, and the operations that this takes."""

    def __init__(self, pattern: Sequence[int]) -> None:
        self._rows = [row & ~(1 << i) for i, row in enumerate(pattern)]
        self.work = 0

    def width(self, k: int) -> int:
        return self._rows[k].bit_count()

    def take(self, k: int) -> None:
        own, width = self._rows[k], self.width(k)
        self.work += width * (width + 3)
        for i in range(len(self._rows)):
            if own >> i & 1:
                self._rows[i] = (self._rows[i] | own) & ~(1 << i) & ~(1 << k)


def factor(graph: Graph, matrix: Sequence[Sequence[Node]], constants: int = 0) -> Factors:
    """L D L^T of a symmetric matrix, unrolled; structural zeros cost nothing.

    What is left of a matrix behind a pivot of ``constants`` (a mask) alone is made shorter: for a free body's place in the plane
    it is a matrix about the centre of mass, in which sin^2 + cos^2 stand together.
    """
    size = len(matrix)
    pattern = [sum(1 << j for j, x in enumerate(row) if x != graph.zero) for row in matrix]
    order = list(range(size)) if "order of pivots" in graph.off else elimination_order(pattern)
    work = [[matrix[i][j] for j in order] for i in order]
    lower = [[graph.zero] * size for _ in range(size)]
    pivots, reciprocals = [], []
    for k in range(size):
        pivot = work[k][k]
        reciprocal = graph.inverse(pivot)
        pivots.append(pivot)
        reciprocals.append(reciprocal)
        for i in range(k + 1, size):
            if work[i][k] != graph.zero:
                lower[i][k] = graph.mul(work[i][k], reciprocal)
        for i in range(k + 1, size):
            if lower[i][k] == graph.zero:
                continue
            for j in range(k + 1, i + 1):
                if work[j][k] != graph.zero:
                    work[i][j] = graph.sub(work[i][j], graph.mul(lower[i][k], work[j][k]))
                    work[j][i] = work[i][j]
        if not graph.deps[pivot] & ~constants and "still pivots" not in graph.off:
            _shorten_rest(graph, work, k + 1)
    return Factors(tuple(tuple(row) for row in lower), tuple(pivots), tuple(reciprocals), tuple(order))


def _shorten_rest(graph: Graph, work: list[list[Node]], first: int) -> None:
    """What is left of a symmetric matrix from this row on, in place, where an entry turns out not to depend on all that it is
    written with.
    """
    places = [(i, j) for i in range(first, len(work)) for j in range(first, i + 1)]
    made = shorten(graph, [work[i][j] for i, j in places])
    for (i, j), node in zip(places, made, strict=True):
        if graph.deps[node] != graph.deps[work[i][j]]:
            work[i][j] = work[j][i] = node


def solve_factored(graph: Graph, factors: Factors, right: Sequence[Node]) -> list[Node]:
    """x with L D L^T x = right."""
    size = len(right)
    y = [right[i] for i in factors.order]
    for i in range(size):
        for k in range(i):
            if factors.lower[i][k] != graph.zero and y[k] != graph.zero:
                y[i] = graph.sub(y[i], graph.mul(factors.lower[i][k], y[k]))
    x = [graph.mul(value, reciprocal) for value, reciprocal in zip(y, factors.reciprocals, strict=True)]
    for i in reversed(range(size)):
        for k in range(i + 1, size):
            if factors.lower[k][i] != graph.zero and x[k] != graph.zero:
                x[i] = graph.sub(x[i], graph.mul(factors.lower[k][i], x[k]))
    place = {i: k for k, i in enumerate(factors.order)}
    return [x[place[i]] for i in range(size)]
