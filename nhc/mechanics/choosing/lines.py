"""Rows of minors as what the velocities are along, in place of a form of their length.

The row n of minors that completes some constraints spans all that these leave to the velocities in its columns.  As the form n q'
it is divided by |n|^2 where the coframe is solved, with all its derivatives; of the form n q' / |n|^2, which is as regular, the
vector is n itself: q' = n v.  Its entries have the units of the velocities over that of v, too, where |n|^2 is a sum of several.

What rolls on something that moves has velocities u of that as well: q' = n v + u, where the constraints are written for q' - u.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice, product

from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import ADD, MUL, NEG, POW, SYM, Graph, Node
from nhc.algebra.parts import list_terms, split_powers
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.algebra.walks import count, reachable
from nhc.mechanics.added_forms import added_forms
from nhc.mechanics.frame import closed_rows, form_value
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.system import Form, Line, System

_LIMIT = 200  # terms of a square
_MOST_TRIALS = 16
_OF_UNITS = (ADD, MUL, NEG, POW, "sqrt", "abs", "min", "max")  # whose values are no mere numbers


def along_lines(system: System, forms: Sequence[Form]) -> tuple[Form, ...]:
    """The forms, where those that nhc made are all that constraints leave to some velocities by what these velocities are along."""
    made = {form: _along_line(system, form) for form in added_forms(system, forms)}
    return tuple(made.get(form) or form for form in forms)


def _along_line(system: System, form: Form) -> Form | None:
    g, vector = system.graph, form.coefficients
    columns = tuple(j for j, node in enumerate(vector) if node != g.zero)
    closed = closed_rows(system, columns)
    rows = [system.constraints[r] for r in closed]
    turned = {k for rotation in system.rotations for k in rotation.places}
    if not rows or len(rows) != len(columns) - 1 or not turned.isdisjoint(columns):
        return None
    over = _in_front(system, vector, closed)
    vector = tuple(g.div(x, g.product(over)) for x in vector)
    if not all(are_zero(g, [g.dot(row.coefficients, vector) for row in rows])):
        return None
    carried = _carrying(system, rows, columns)
    if carried is None or (g.value(_square(g, vector, vector)) is not None and not _is_uniform(system, carried)):
        return None
    dual, square = _measure(system, vector)
    coefficients = tuple(g.div(x, square) for x in dual)
    constant = g.neg(g.div(g.dot(dual, carried), square))
    line = Line(columns, vector, dual, carried, square, over)
    return Form(form.name, coefficients, constant, form.place, value=g.div(line.value(g, system.v), square), line=line)


def _measure(system: System, vector: tuple[Node, ...]) -> tuple[tuple[Node, ...], Node]:
    """What the vector is multiplied with, and their product: itself, or each entry over the square of its own parameters.

    Of (L cos d, sin d), a velocity and a rate of turn, the sum of squares would depend on the unit of L; times (cos d / L, sin d)
    it is 1.  Where entries are positions, as of (x, a), it is left to these to have one unit.
    """
    g = system.graph
    plain = vector, _square(g, vector, vector)
    entries = [x for x in vector if x != g.zero]
    units = {x: _parameters_of(system, x) for x in entries}
    first = next((powers for powers in units.values() if powers), {})
    if any(_holds_positions(system, x) for x in entries) or all(powers == first for powers in units.values()):
        return plain
    ways = [] if not all(units.values()) else [plain]  # unlike things are not added
    for times in ({}, first):
        dual = tuple(_rescale(g, x, units[x], times) if x != g.zero else x for x in vector)
        ways.append((dual, _square(g, dual, vector)))
    return min(ways, key=lambda way: count(g, [*way[0], way[1]]))


def _rescale(graph: Graph, node: Node, over: Mapping[Node, int], times: Mapping[Node, int]) -> Node:
    """A node over the square of a product of powers and times that of another; powers that stand in it are taken from these."""
    number, own = split_powers(graph, node)
    for sign, powers in ((-2, over), (2, times)):
        for base, n in powers.items():
            own[base] = own.get(base, 0) + sign * n
    return graph.mul(graph.number(number), graph.product([graph.power(base, n) for base, n in own.items() if n]))


def _square(graph: Graph, dual: Sequence[Node], vector: Sequence[Node]) -> Node:
    plain = graph.dot(dual, vector)
    return min(normalise_angles(graph, plain, _LIMIT), plain, key=lambda node: count(graph, [node]))


def _holds_positions(system: System, node: Node) -> bool:
    """Whether anything but parameters stands outside of functions, whose values are numbers."""
    g, stack, still = system.graph, [node], system.graph.mask(system.p)
    while stack:
        top = stack.pop()
        if g.op[top] in _OF_UNITS:
            stack += g.kids[top]
        elif g.op[top] == SYM and g.deps[top] & ~still:
            return True
    return False


def _parameters_of(system: System, node: Node) -> dict[Node, int]:
    """The powers of parameters, zero in no scene, in front of the first term of sums, whose other terms have its unit."""
    g, known = system.graph, intervals(system)
    found, stack = dict[Node, int](), [(node, 1)]
    while stack:
        top, times = stack.pop()
        for base, n in split_powers(g, list_terms(g, top)[0])[1].items():
            if g.op[base] == ADD:
                stack.append((base, n * times))
            elif base in system.p and cannot_vanish(g, base, known):
                found[base] = found.get(base, 0) + n * times
    return {p: n for p, n in found.items() if n}


def _is_uniform(system: System, carried: Sequence[Node]) -> bool:
    """Whether something moves along with parameters alone: v is best counted from it, though its length is known already.

    On a turntable the velocity against the ground is shorter, in which T is written.
    """
    g, still = system.graph, system.graph.mask(system.p)
    return any(carried) and not any(g.deps[u] & ~still for u in carried)


def _in_front(system: System, vector: Sequence[Node], closed: Sequence[int]) -> tuple[Node, ...]:
    """Parameters in front of most entries of a vector that other constraints hold as well, and that are zero in no scene.

    A tractor whose wheelbase is the length of its trailers, too, is led by the speed of its front wheel, (cos d, sin d / L): with
    (L cos d, sin d) the length would cancel in the rates of the angles and not in the velocities, and no product would be in both.
    """
    g, known = system.graph, intervals(system)
    powers = [split_powers(g, x)[1] for x in vector if x != g.zero]
    most = [p for p in system.p if 2 * sum(own.get(p, 0) > 0 for own in powers) > len(powers)]
    others = [form.coefficients for r, form in enumerate(system.constraints) if r not in closed]
    held = (p for p in most if any(g.depends(x, g.deps[p]) for row in others for x in row))
    return tuple(p for p in held if cannot_vanish(g, p, known))


def _carrying(system: System, rows: Sequence[Form], columns: Sequence[int]) -> tuple[Node, ...] | None:
    """Velocities in the columns that the rows allow where v is zero; None where they are not written down in the rows."""
    g, carried = system.graph, [system.graph.zero] * system.n
    if all(row.constant == g.zero for row in rows):
        return tuple(carried)
    written = [form_value(system, row) for row in rows]
    choices = [_carriers(g, written, system.v[j], g.mask(system.v)) for j in columns]
    for trial in islice(product(*choices), _MOST_TRIALS):
        for j, node in zip(columns, trial, strict=True):
            carried[j] = node
        if all(are_zero(g, [g.add(g.dot(row.coefficients, carried), row.constant) for row in rows])):
            return tuple(carried)
    return None


def _carriers(graph: Graph, written: Sequence[Node], velocity: Node, velocities: int) -> list[Node]:
    """What is taken from a velocity before it is multiplied by anything, the most frequent first; nothing where that is so."""
    g, own = graph, graph.deps[velocity]
    found: dict[Node, int] = {}
    for node in reachable(g, written, own):
        for kind, x, y in ((g.op[node], g.a[node], g.b[node]), (g.op[node], g.b[node], g.a[node])):
            if kind == ADD and x == velocity and not g.deps[y] & velocities:
                found[g.neg(y)] = found.get(g.neg(y), 0) + 1
    return [*sorted(found, key=lambda node: -found[node]), g.zero]
