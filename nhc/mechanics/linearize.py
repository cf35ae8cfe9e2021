"""A motion's field near a steady motion, as nodes: what it depends on, its leaves, its matrix where it stays short.

A steady motion is a relative equilibrium: the state without its cyclic coordinates stands still, while those run on.
A coordinate is cyclic here when no rate of what is kept depends on it: a property of the field y' = f(y), tested
exactly, not of T and U alone (for the rolling disk the heading, which the constraints contain, is cyclic as well).
Hidden holonomic constraints foliate the configurations; the directions inside a leaf are spanned by the free vectors
and their brackets (Frobenius, Nagano).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import Unlucky, are_zero, rank
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import depends, solve
from nhc.algebra.walks import count
from nhc.mechanics.choosing.choose import Formulation, build
from nhc.mechanics.choosing.refusal import NotApplicable
from nhc.mechanics.dependence import find_dependence
from nhc.mechanics.flow import Flow
from nhc.mechanics.frame import Frame, form_value
from nhc.mechanics.properties.flag import terminal_rank
from nhc.mechanics.properties.integrability import is_integrable, lie_bracket
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import System
from nhc.records import record

_READABLE = 60
"""Operations of a matrix entry that a reader still follows."""
_LARGE = 4000
"""Operations of all entries together beyond which no symbolic matrix is tried."""


# --- cyclic coordinates --------------------------------------------------------------------------------------


def cyclic_of(flow: Flow) -> tuple[int, ...]:
    """The largest set of coordinates on which neither the rates of the kept velocities nor those of the other coordinates depend.

    Exact, with the probability of :func:`nhc.mechanics.dependence.find_dependence`.
    """
    n, size = flow.system.n, len(flow.y)
    try:
        rates = find_dependence(flow, ()).rates
    except Unlucky:  # too many signs, or nested roots: what stands in the equations counts
        g = flow.graph
        nodes = (*flow.velocities, *flow.flat)
        occurring = frozenset(j for j, y in enumerate(flow.y) if any(g.depends(node, g.deps[y]) for node in nodes))
        rates = (occurring,) * size
    cyclic = [i for i in range(n) if all(i not in rates[k] for k in range(n, size))]
    while True:
        left = [i for i in cyclic if all(i not in rates[j] for j in range(n) if j not in cyclic)]
        if left == cyclic:
            return tuple(cyclic)
        cyclic = left


def is_autonomous(flow: Flow, p: Sequence[float]) -> bool:
    """Whether the field is free of the time at these values of the parameters (only those that vanish are looked at)."""
    g = flow.graph
    nodes = [*flow.velocities, *flow.flat]
    if not any(g.depends(node, g.deps[flow.system.t]) for node in nodes):
        return True  # a field that these values make singular does not depend on the time for that
    absent = {symbol: g.zero for symbol, value in zip(flow.system.p, p, strict=True) if value == 0.0}
    try:
        nodes = substitute(g, nodes, absent)
    except ZeroDivisionError:
        return False
    return not any(depends(g, nodes, [flow.system.t]))


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
class HiddenLeaf:
    """What hidden holonomic constraints leave of the configurations near one of them.

    ``dimension``, and vectors over q that span its tangent space (``fields``) or rows that vanish on it (``normals``), whichever is
    known.  Neither is needed where ``dimension`` is n: no hidden holonomic constraint.
    """

    dimension: int
    fields: tuple[tuple[Node, ...], ...] = ()
    normals: tuple[tuple[Node, ...], ...] = ()


def hidden_leaf(system: System, frame: Frame) -> HiddenLeaf:
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
    dimension = terminal_rank(g, variables if moving else system.q, base if moving else frame.free_vectors) - moving
    if dimension == n:
        return HiddenLeaf(n)
    closed = [form.coefficients for form in system.constraints if is_integrable(system, form)]
    if len(closed) == n - dimension:
        return HiddenLeaf(dimension, normals=tuple(closed))
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
    return HiddenLeaf(dimension, fields=tuple(field[:n] for field in everything))


# --- names ---------------------------------------------------------------------------------------------------


def quantity(flow: Flow, name: str) -> Node | None:
    """A coordinate, velocity (``x'``), quasi-velocity or output as a function of the state; None for an unknown name."""
    system, g = flow.system, flow.graph
    if name in flow.names:
        return flow.y[flow.names.index(name)]
    for i, own in enumerate(system.q_names):
        if name == f"{own}'":
            return flow.velocities[i]
    named = [*((form.name, form_value(system, form)) for form in system.quasi), *system.outputs]
    for own, node in named:
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


def symbolic_matrix(
    flow: Flow, rest: Sequence[int], point: Mapping[Node, Node], shifts: Sequence[Sequence[Node]] = ()
) -> SymbolicMatrix | str:
    """The Jacobian of the rates of ``rest`` at a steady motion given as nodes, or why there is none.

    The motion may go along ``shifts`` of the coordinates of ``rest``, under which the field looks the same.

    Kept velocities that may have any value on the steady motion stay symbols.  On a steady motion all rates of ``rest``
    vanish, so the slopes of the kept velocities' rates are M^-1 df/dy: nothing is differentiated through the inverse.
    """
    g, n = flow.graph, flow.system.n
    if flow.equations.multipliers:
        return "the multipliers' equations are solved as numbers only"
    if any(n + k not in rest for k in range(flow.kept)):
        return "a kept velocity is not part of it"
    place = _free_velocities(flow, rest, dict(point), shifts)
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


def _free_velocities(
    flow: Flow, rest: Sequence[int], place: dict[Node, Node], shifts: Sequence[Sequence[Node]]
) -> dict[Node, Node] | None:
    """The point with as many nonzero kept velocities left open as keep it steady; None if it is not steady at all."""
    for i in rest:
        symbol = flow.y[i]
        if i < flow.system.n or place.get(symbol, symbol) in (symbol, flow.graph.zero):
            continue
        freed = {key: node for key, node in place.items() if key != symbol}
        if _is_steady(flow, rest, freed, shifts):
            place = freed
    return place if _is_steady(flow, rest, place, shifts) else None


def _is_steady(flow: Flow, rest: Sequence[int], place: Mapping[Node, Node], shifts: Sequence[Sequence[Node]]) -> bool:
    g, n = flow.graph, flow.system.n
    nodes = [flow.velocities[i] for i in rest if i < n]
    try:
        rates = substitute(g, [*nodes, *flow.right], place)
        if not all(are_zero(g, rates[len(nodes) :])):
            return False
        along = rates[: len(nodes)]
        return all(are_zero(g, along)) or (bool(shifts) and rank(g, [*shifts, along]) == rank(g, shifts))
    except (ZeroDivisionError, Unlucky):
        return False
