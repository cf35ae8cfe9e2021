"""The motion's field near a steady motion, as nodes: what it depends on, its slopes, its leaves, its matrix where it stays short.

A steady motion is a relative equilibrium: the state without its cyclic coordinates stands still, while those run on.
A coordinate is cyclic here when no rate of what is kept depends on it: a property of the field y' = f(y), tested
exactly, not of T and U alone (for the rolling disk the heading, which the constraints contain, is cyclic as well).
Hidden holonomic constraints foliate the configurations; the directions inside a leaf are spanned by the free vectors
and their brackets (Frobenius, Nagano).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from nhc.algebra.calculus import count, gradient, substitute
from nhc.algebra.dense import Singular, solve_columns_modulo, solve_modulo
from nhc.algebra.graph import Graph, Node
from nhc.algebra.linear import solve
from nhc.algebra.modular import FieldPoint, Unlucky, are_zero, rank
from nhc.algebra.polynomial import normalise
from nhc.algebra.primes import primes_of
from nhc.mechanics.associate import Equations
from nhc.mechanics.choose import Formulation, NotApplicable, build
from nhc.mechanics.flag import growth_vector
from nhc.mechanics.formulate import bordered_system
from nhc.mechanics.frame import Frame, form_value
from nhc.mechanics.integrability import is_integrable, lie_bracket
from nhc.mechanics.rotation import moving
from nhc.mechanics.system import System
from nhc.records import record

_POINTS, _DRAWS = 2, 400
_READABLE = 60
"""Operations of a matrix entry that a reader still follows."""
_LARGE = 4000
"""Operations of all entries together beyond which no symbolic matrix is tried."""


@dataclass(frozen=True)
class Flow:
    """y' = f(y), y = (q, w): q' = ``velocities``, and matrix @ (w', multipliers) = right."""

    equations: Equations
    y: tuple[Node, ...]
    velocities: tuple[Node, ...]
    matrix: tuple[tuple[Node, ...], ...]
    right: tuple[Node, ...]
    unknowns: tuple[Node, ...]

    @property
    def system(self) -> System:
        return self.equations.system

    @property
    def graph(self) -> Graph:
        return self.equations.system.graph

    @property
    def kept(self) -> int:
        """How many velocities the state holds."""
        return len(self.equations.motion.w)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The state's names: coordinates, then the kept velocities."""
        symbols = [self.graph.symbol_of(node) for node in self.y]
        return tuple(f"{s.name}'" if s.kind == "velocity" else s.name for s in symbols if s is not None)

    @cached_property
    def flat(self) -> tuple[Node, ...]:
        """The matrix row by row, then the right side."""
        return (*(x for row in self.matrix for x in row), *self.right)

    @cached_property
    def residual(self) -> tuple[Node, ...]:
        """right - matrix @ unknowns, zero on the motion."""
        g = self.graph
        return tuple(
            g.sub(value, g.dot(row, self.unknowns)) for row, value in zip(self.matrix, self.right, strict=True)
        )

    @cached_property
    def velocity_slopes(self) -> tuple[tuple[Node, ...], ...]:
        """d q'_i / d y_j."""
        return tuple(tuple(gradient(self.graph, node, self.y)) for node in self.velocities)

    @cached_property
    def residual_slopes(self) -> tuple[tuple[Node, ...], ...]:
        """d residual_k / d y_j at fixed unknowns; the rates' slopes are matrix^-1 times these."""
        return tuple(tuple(gradient(self.graph, node, self.y)) for node in self.residual)


def flow_of(equations: Equations) -> Flow:
    """The field of a formulation's equations."""
    motion = equations.motion
    if equations.multipliers:
        matrix, right = bordered_system(equations)
    else:
        matrix, right = [list(row) for row in equations.mass], list(equations.force)
    unknowns = (*motion.rates, *equations.multipliers)
    rows = tuple(tuple(row) for row in matrix)
    return Flow(equations, (*equations.system.q, *motion.w), motion.velocities, rows, tuple(right), unknowns)


# --- cyclic coordinates --------------------------------------------------------------------------------------


def cyclic_of(flow: Flow) -> tuple[int, ...]:
    """The largest set of coordinates on which neither the rates of the kept velocities nor those of the other coordinates depend.

    Exact, with the probability of :mod:`nhc.algebra.modular`.
    """
    n = flow.system.n
    depends = _dependence(flow)
    cyclic = [i for i in range(n) if not any(depends[n + k][i] for k in range(flow.kept))]
    while True:
        left = [i for i in cyclic if not any(depends[j][i] for j in range(n) if j not in cyclic)]
        if left == cyclic:
            return tuple(cyclic)
        cyclic = left


def is_autonomous(flow: Flow, p: Sequence[float]) -> bool:
    """Whether the field is free of the time at these values of the parameters (only those that vanish are looked at)."""
    g = flow.graph
    absent = {symbol: g.zero for symbol, value in zip(flow.system.p, p, strict=True) if value == 0.0}
    nodes = [*flow.velocities, *flow.flat]
    try:
        nodes = substitute(g, nodes, absent)
    except ZeroDivisionError:
        return False
    seen = [node for node in nodes if g.depends(node, g.deps[flow.system.t])]
    return all(are_zero(g, [gradient(g, node, [flow.system.t])[0] for node in seen]))


def _dependence(flow: Flow) -> list[list[bool]]:
    """[row][column]: whether y'_row depends on y_column, from residues at random points."""
    size = len(flow.y)
    found = [[False] * size for _ in range(size)]
    points, draws, primes = 0, 0, primes_of(flow.graph)
    while points < _POINTS:
        draws += 1
        if draws > _DRAWS:
            raise Unlucky
        prime = primes[points % len(primes)]
        try:
            rows = jacobian_residues(flow, FieldPoint(flow.graph, 7_000_003 + draws, prime))
        except Unlucky:
            continue
        points += 1
        found = [[f or bool(x) for f, x in zip(fs, xs, strict=True)] for fs, xs in zip(found, rows, strict=True)]
    return found


def jacobian_residues(flow: Flow, point: FieldPoint) -> list[list[int]]:
    """df/dy at a point of a prime field, row by row; :class:`Unlucky` on a pole or where the model is singular."""
    size, n, p = len(flow.unknowns), flow.system.n, point.prime
    rows = [point.evaluate(row) for row in flow.velocity_slopes]
    if not size:
        return rows
    matrix = [point.evaluate(row) for row in flow.matrix]
    rates = dict(zip(flow.unknowns, solve_at(size, point.evaluate(flow.flat), p), strict=True))
    slopes = [point.evaluate(row, rates) for row in flow.residual_slopes]
    return [*rows[:n], *solve_columns_modulo(matrix, slopes, p)[: flow.kept]]


def solve_at(size: int, values: Sequence[int], prime: int) -> list[int]:
    """x with matrix @ x = right at a point, ``values`` being the residues of the matrix, row by row, and then of the right side.

    Raises:
        Unlucky: the matrix is singular there.
    """
    matrix = [values[k * size : (k + 1) * size] for k in range(size)]
    try:
        return solve_modulo(matrix, values[size * size :], prime)
    except Singular:
        raise Unlucky from None


def reduced(system: System, formulation: Formulation) -> Formulation:
    """The formulation itself, or Voronec's equations in place of multipliers: in the constraints' own velocities a motion
    that turns is steady, in x' and y' it is not.
    """
    if formulation.name != "multipliers":
        return formulation
    try:
        return build(system, "voronec")
    except NotApplicable:
        return formulation


# --- leaves --------------------------------------------------------------------------------------------------


@record
class Leaf:
    """The leaf through a configuration: ``dimension``, and vectors over q that span its tangent space (``fields``) or rows that
    vanish on it (``normals``), whichever is known.  Neither is needed where ``dimension`` is n: no hidden holonomic constraint.
    """

    dimension: int
    fields: tuple[tuple[Node, ...], ...] = ()
    normals: tuple[tuple[Node, ...], ...] = ()


def leaf_of(system: System, frame: Frame) -> Leaf:
    """All brackets of the free vectors with each other and with the drift, until their rank grows no more.

    Constraints that are integrable by themselves are taken as normals where they are enough: brackets may lose rank
    at a special point.
    """
    g, n = system.graph, system.n
    variables = (*system.q, system.t)
    free = [(*e, g.zero) for e in frame.free_vectors]
    moving = not all(are_zero(g, frame.drift)) or any(
        g.depends(x, g.deps[system.t]) for e in frame.free_vectors for x in e
    )
    base = [*free, (*frame.drift, g.one)] if moving else free
    dimension = growth_vector(g, variables if moving else system.q, base if moving else frame.free_vectors)[-1] - moving
    if dimension == n:
        return Leaf(n)
    closed = [form.coefficients for form in system.constraints if is_integrable(system, form)]
    if len(closed) == n - dimension:
        return Leaf(dimension, normals=tuple(closed))
    spanned, everything, newest = list(free), list(free), list(free)
    while newest:
        brackets = [lie_bracket(g, variables, x, y) for x in base for y in newest if x != y]
        newest = []
        for field in brackets:
            if all(node == g.zero for node in field):
                continue
            everything.append(field)  # even where it adds nothing in general: it may at a special point
            if rank(g, [*spanned, field]) > len(spanned):
                spanned.append(field)
                newest.append(field)
    return Leaf(dimension, fields=tuple(field[:n] for field in everything))


# --- names ---------------------------------------------------------------------------------------------------


def quantity(flow: Flow, name: str) -> Node | None:
    """A coordinate, velocity (``x'``), quasi-velocity or output as a function of the state; None for an unknown name."""
    system, g = flow.system, flow.graph
    if name in flow.names:
        return flow.y[flow.names.index(name)]
    for i, own in enumerate(system.q_names):
        if name == f"{own}'":
            return flow.velocities[i]
    for form in system.quasi:
        if form.name == name:
            return form_value(g, form, flow.velocities)
    for own, node in system.outputs:
        if own == name:
            return substitute(g, [node], moving(system, flow.velocities))[0]
    return None


# --- the matrix on paper -------------------------------------------------------------------------------------


@record
class SymbolicMatrix:
    """A over the rows and columns of ``indices`` of the state; ``held`` are the symbols it was made at."""

    indices: tuple[int, ...]
    entries: tuple[tuple[Node, ...], ...]
    held: tuple[tuple[str, Node], ...]


def symbolic_matrix(flow: Flow, rest: Sequence[int], point: Mapping[Node, Node]) -> SymbolicMatrix | str:
    """The Jacobian of the rates of ``rest`` at a steady motion given as nodes, or why there is none.

    Kept velocities that may have any value on the steady motion stay symbols.  On a steady motion all rates of ``rest``
    vanish, so the slopes of the kept velocities' rates are M^-1 df/dy: nothing is differentiated through the inverse.
    """
    g, n = flow.graph, flow.system.n
    if flow.equations.multipliers:
        return "the multipliers' equations are solved as numbers only"
    if any(n + k not in rest for k in range(flow.kept)):
        return "a kept velocity is not part of it"
    place = _free_velocities(flow, rest, dict(point))
    if place is None:
        return "the motion is steady as numbers, not as an expression in the parameters"
    slopes = [flow.velocity_slopes[i] if i < n else flow.residual_slopes[i - n] for i in rest]
    still = {**{symbol: g.zero for symbol in flow.unknowns}, **place}
    flat = [row[j] for row in slopes for j in rest] + [x for row in flow.matrix for x in row]
    try:
        values = substitute(g, flat, still)
        if count(g, values) > _LARGE:
            return "its entries are too large to read"
        values = [normalise(g, node, _READABLE) for node in values]
        entries = _solved(g, flow, rest, values)
    except (ZeroDivisionError, Singular):
        return "the field is singular there as an expression"
    if any(count(g, [node]) > _READABLE for row in entries for node in row):
        return "its entries are too large to read"
    held = tuple((flow.names[i], place.get(flow.y[i], flow.y[i])) for i in rest)
    return SymbolicMatrix(tuple(rest), tuple(tuple(row) for row in entries), held)


def _solved(g: Graph, flow: Flow, rest: Sequence[int], values: list[Node]) -> list[list[Node]]:
    width, n, kept = len(rest), flow.system.n, flow.kept
    rows = [values[k * width : (k + 1) * width] for k in range(width)]
    tail = values[width * width :]
    mass = [tail[k * kept : (k + 1) * kept] for k in range(kept)]
    order = [k for k, i in enumerate(rest) if i >= n]
    if not order:
        return rows
    columns = [[rows[k][c] for k in order] for c in range(width)]
    solved = solve(g, mass, columns).unknowns
    for position, k in enumerate(order):
        rows[k] = [normalise(g, solved[c][position], _READABLE) for c in range(width)]
    zero = are_zero(g, [x for row in rows for x in row])
    return [[g.zero if zero[r * width + c] else x for c, x in enumerate(row)] for r, row in enumerate(rows)]


def _free_velocities(flow: Flow, rest: Sequence[int], place: dict[Node, Node]) -> dict[Node, Node] | None:
    """The point with as many nonzero kept velocities left open as keep it steady; None if it is not steady at all."""
    for i in rest:
        symbol = flow.y[i]
        if i < flow.system.n or place.get(symbol, symbol) in (symbol, flow.graph.zero):
            continue
        freed = {key: node for key, node in place.items() if key != symbol}
        if _is_steady(flow, rest, freed):
            place = freed
    return place if _is_steady(flow, rest, place) else None


def _is_steady(flow: Flow, rest: Sequence[int], place: Mapping[Node, Node]) -> bool:
    g, n = flow.graph, flow.system.n
    nodes = [flow.velocities[i] for i in rest if i < n] + list(flow.right)
    try:
        return all(are_zero(g, substitute(g, nodes, place)))
    except (ZeroDivisionError, Unlucky):
        return False
