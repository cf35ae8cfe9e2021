"""Rows of minors as what the velocities are along, in place of a form of their length.

The row n of minors that completes some constraints spans all that these leave to the velocities in its columns.  As the form n q'
it is divided by |n|^2 where the coframe is solved, with all its derivatives; of the form n q' / |n|^2, which is as regular, the
vector is n itself: q' = n v.  Its entries have the units of the velocities over that of v, too, where |n|^2 is a sum of several.

What rolls on something that moves has velocities u of that as well: q' = n v + u, where the constraints are written for q' - u.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice, product

from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import ADD, Graph, Node
from nhc.algebra.parts import split_powers
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.algebra.walks import count, reachable
from nhc.mechanics.frame import added_forms, closed_rows, form_value
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.system import Form, Line, System

_LIMIT = 200  # terms of a square
_MOST_TRIALS = 16


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
    plain = g.sum([g.power(x, 2) for x in vector])
    square = min(normalise_angles(g, plain, _LIMIT), plain, key=lambda node: count(g, [node]))
    if not all(are_zero(g, [g.dot(row.coefficients, vector) for row in rows])):
        return None
    carried = _carrying(system, rows, columns)
    if carried is None or (g.value(square) is not None and not _is_uniform(system, carried)):
        return None
    coefficients = tuple(g.div(x, square) for x in vector)
    constant = g.neg(g.div(g.dot(vector, carried), square))
    line = Line(columns, vector, carried, square, over)
    return Form(form.name, coefficients, constant, form.place, value=g.div(line.value(g, system.v), square), line=line)


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
