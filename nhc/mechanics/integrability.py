"""Are the constraints integrable?  Frobenius' test and the growth vector of the allowed directions.

The vectors e_mu span ker A, the drift is X_0 = d/dt + e_0.  Their Lie brackets, taken again and again, span a space
whose terminal rank at a generic point is n (+ 1 with the drift) minus the number of hidden holonomic constraints.
Ranks are computed modulo a prime at a random point, so they are exact up to the probability of
:mod:`nhc.algebra.modular`.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.draw import MOST_DRAWS, draw_points
from nhc.algebra.graph import Graph, Node
from nhc.algebra.linear import depends, solve
from nhc.algebra.modular import PRIMES, FieldPoint, Unlucky, are_zero, enough_points
from nhc.mechanics.frame import Frame, coordinate_frame
from nhc.mechanics.regularity import choose_dependent
from nhc.mechanics.system import Form, System
from nhc.records import record
from nhc.thesis import equation

Field = tuple[Node, ...]

Rows = list[tuple[int, list[int]]]
"""Pivot column, and a row with a 1 there."""

_MOST_POINTS = 12


@record
class Integrability:
    """``growth``: ranks of the successive brackets of ker A; ``hidden``: how many holonomic constraints are in
    disguise; ``closed``: names of constraints that are integrable by themselves; ``affine``, ``rheonomic``: kinds of
    the rows.
    """

    growth: tuple[int, ...]
    hidden: int
    closed: tuple[str, ...]
    affine: bool
    rheonomic: bool


def classify(system: System, frame: Frame | None = None) -> Integrability:
    """The constraints' integrability (``growth`` is (n,) without constraints)."""
    g, n = system.graph, system.n
    if not system.constraints:
        return Integrability((n,), 0, (), False, False)
    frame = frame or coordinate_frame(system, choose_dependent(system).dependent)
    affine = not all(are_zero(g, frame.drift))
    entries = [x for form in system.constraints for x in (*form.coefficients, form.constant)]
    rheonomic = any(g.depends(x, g.deps[system.t]) for x in entries)
    growth = growth_vector(g, system.q, frame.free_vectors)
    hidden = n - growth[-1]
    if affine or rheonomic:
        fields = [(*e, g.zero) for e in frame.free_vectors] + [(*frame.drift, g.one)]
        hidden = n + 1 - growth_vector(g, (*system.q, system.t), fields)[-1]
    closed = tuple(form.name for form in system.constraints if is_integrable(system, form))
    return Integrability(growth, hidden, closed, affine, rheonomic)


def growth_vector(graph: Graph, variables: Sequence[Node], fields: Sequence[Field]) -> tuple[int, ...]:
    """Ranks of D_1 = span(fields), D_{k+1} = D_k + [D_1, D_k] until they stop growing or fill the space.

    All ranks are taken at the same random points, one of them where no signs occur.
    """
    base = [tuple(f) for f in fields]
    newest = list(base)
    span = _Span(graph, [node for field in base for node in field])
    for field in base:
        span.add(field)
    ranks = [span.rank]
    while ranks[-1] < len(variables):
        grown: list[Field] = []
        for x in base:
            for y in newest:
                field = lie_bracket(graph, variables, x, y) if x != y else ()
                if any(node != graph.zero for node in field) and span.add(field):
                    grown.append(field)
        if span.rank == ranks[-1]:
            break
        ranks.append(span.rank)
        newest = grown
    return tuple(ranks)


class _Span:
    """The span of fields at random points of the prime field; its rank is the largest found.

    One point is enough but where signs occur (the root of a square), which may be the wrong ones at every second point.
    """

    def __init__(self, graph: Graph, nodes: Sequence[Node]) -> None:
        self.graph = graph
        self._seeds = iter(range(9_000_011, 9_000_011 + MOST_DRAWS))
        self._nodes = list(nodes)
        self._fields: list[Field] = []
        count = min(_MOST_POINTS, enough_points(graph, nodes, 1))
        self._points = [self._draw() for _ in range(count)]

    @property
    def rank(self) -> int:
        return max(len(rows) for _, rows in self._points)

    def add(self, field: Field) -> bool:
        """Whether the field was independent of those before it."""
        before = self.rank
        self._fields.append(field)
        for k, (point, rows) in enumerate(self._points):
            try:
                _reduce(rows, point.evaluate(field), point.prime)
            except Unlucky:
                self._points[k] = self._draw()
        return self.rank > before

    def _draw(self) -> tuple[FieldPoint, Rows]:
        """A point where all fields so far have values, with their span there."""
        for _, point in draw_points(self.graph, self._nodes, PRIMES[0], self._seeds):
            rows: Rows = []
            try:
                for field in self._fields:
                    _reduce(rows, point.evaluate(field), point.prime)
            except Unlucky:
                continue
            return point, rows
        raise Unlucky


def _reduce(rows: Rows, row: Sequence[int], p: int) -> None:
    """Add what is new of a row."""
    work = list(row)
    for column, known in rows:
        factor = work[column]
        if factor:
            work = [(x - factor * y) % p for x, y in zip(work, known, strict=True)]
    pivot = next((j for j, x in enumerate(work) if x), -1)
    if pivot >= 0:
        inverse = pow(work[pivot], -1, p)
        rows.append((pivot, [x * inverse % p for x in work]))


def lie_bracket(graph: Graph, variables: Sequence[Node], x: Field, y: Field) -> Field:
    """[x, y] = x(y) - y(x), componentwise."""
    along_x = tangent(graph, y, dict(zip(variables, x, strict=True)))
    along_y = tangent(graph, x, dict(zip(variables, y, strict=True)))
    return tuple(graph.sub(a, b) for a, b in zip(along_x, along_y, strict=True))


def is_integrable(system: System, form: Form) -> bool:
    """omega ^ d omega = 0 for one constraint form alone (Frobenius), time counted as a coordinate."""
    g = system.graph
    variables = (*system.q, system.t)
    a = (*form.coefficients, form.constant)
    slopes = [gradient(g, x, variables) for x in a]
    size = len(variables)
    terms = []
    for i in range(size):
        for j in range(i + 1, size):
            for k in range(j + 1, size):
                term = g.zero
                for r, s, t in ((i, j, k), (j, k, i), (k, i, j)):
                    term = g.add(term, g.mul(a[r], g.sub(slopes[t][s], slopes[s][t])))
                terms.append(term)
    return all(are_zero(g, terms))


@equation("I.1.1")
def frobenius_obstruction(frame: Frame) -> list[tuple[int, int, int]]:
    """(alpha, mu, nu) with gamma^alpha_munu != 0: the brackets that leave ker A; nu = n is the drift (epsilon)."""
    system, found = frame.system, []
    for alpha in range(system.l):
        for mu in range(system.l, system.n):
            for nu in (*range(mu + 1, system.n), system.n):
                if not are_zero(frame.graph, [frame.gamma(alpha, nu, mu)])[0]:
                    found.append((alpha, mu, nu))
    return found


def cyclic_coordinates(system: System) -> list[int]:
    """Coordinates that T, U, Q and the constraints do not contain."""
    g = system.graph
    nodes = [system.T, system.U, *system.Q, *(x for f in system.constraints for x in (*f.coefficients, f.constant))]
    result = []
    for i, q in enumerate(system.q):
        if not any(depends(g, nodes, [q])):
            result.append(i)
    return result


def span_coefficients(graph: Graph, rows: Sequence[Sequence[Node]], target: Sequence[Node]) -> list[Node]:
    """c with c_k rows_k = target for a square regular set of rows."""
    columns = [[row[i] for row in rows] for i in range(len(target))]
    return solve(graph, columns, [list(target)]).unknowns[0]
