"""Velocity forms that are long as they are written, and short as a_i q'_i + a_0: those of points that roll on turned axes.

The velocity of a wheel's point on the axes of the ground beside it is a product of all turns between the two, of which nearly all
cancels: the wheel's own angle stands in it and makes no difference.  Every formulation solves the rows, so that what is left in one
of them is in all velocities.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.algebra.walks import count, reachable
from nhc.mechanics.system import Form

_LONG = 7
"""Operations for each of a row's velocities from which it is long; those of trailers and snakes have four."""
_LONGEST = 600
_TERMS = 120
_PAYS = 0.45
"""What it has to become of its length: as it is written it shares what T has, on which moving axes rest."""
_MOST = 8
"""Velocities of a row that is looked at: those of a point on a few bodies."""
_ROUNDING = 1e-9


def short_row(graph: Graph, q: Sequence[Node], velocities: Sequence[Node], form: Form, turned: int = 0) -> Form:
    """The form, or the same one by its coefficients in their shortest form where that is much shorter.

    A row with rates of quaternions (``turned``) is kept: it is written by angular velocities and the entries of matrices.
    """
    g, value = graph, form.value
    if value is None or g.deps[value] & turned or "short rows" in g.off:
        return form
    held = (g.deps[value] & g.mask(velocities)).bit_count()
    length = count(g, [value])
    if held > _MOST or not _LONG * held < length <= _LONGEST or not _has_idle(g, [*q, *velocities], value):
        return form
    *coefficients, constant = (normalise_angles(g, a, _TERMS) for a in (*form.coefficients, form.constant))
    short = g.add(g.dot(coefficients, velocities), constant)
    if count(g, [short]) > _PAYS * length:
        return form
    return Form(form.name, tuple(coefficients), constant, form.place, form.equation, short)


def _has_idle(graph: Graph, symbols: Sequence[Node], value: Node) -> bool:
    """Whether a coordinate or a velocity stands in the row and makes no difference, by numbers at one place."""
    g, order = graph, reachable(graph, [value])
    values = {x: 0.37 + 0.61 * (k * 0.618 % 1.0) for k, x in enumerate(g.symbols_in(value))}
    try:
        (before,) = evaluate(g, [value], values, order=order)
        for x in (x for x in symbols if x in values):
            (after,) = evaluate(g, [value], {**values, x: values[x] + 0.53}, order=order)
            if abs(after - before) <= _ROUNDING * (1.0 + abs(before)):
                return True
    except (ArithmeticError, ValueError, TypeError):
        pass
    return False
