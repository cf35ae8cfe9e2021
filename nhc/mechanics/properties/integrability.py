"""Are the constraints integrable?  Frobenius' test and the growth vector of the allowed directions.

The vectors e_mu span ker A, the drift is X_0 = d/dt + e_0.  Their Lie brackets, taken again and again, span a space
whose terminal rank at a generic point is n (+ 1 with the drift) minus the number of hidden holonomic constraints.
Ranks are computed modulo a prime at a random point, so they are exact up to the probability of
:mod:`nhc.algebra.exact.modular`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import Unlucky, are_zero, is_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import depends
from nhc.algebra.walks import count
from nhc.mechanics.frame import Frame, coordinate_frame
from nhc.mechanics.properties.flag import Field, growth_vector, terminal_rank
from nhc.mechanics.properties.leaf import leaf_of
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.system import Form, System
from nhc.records import record

_LARGE = 250  # operations of the constraints beyond which no second growth vector is asked for


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


def classify(system: System, frame: Frame | None = None, *, levels: bool = True) -> Integrability:
    """The constraints' integrability (``growth`` is (n,) without constraints); ``frame``: whose free vectors are short.

    Without ``levels`` the growth vector is found only where something is integrable, and empty else.
    """
    g, n = system.graph, system.n
    if not system.constraints:
        return Integrability((n,), 0, (), False, False)
    frame = frame or coordinate_frame(system, choose_dependent(system).dependent)
    affine = not all(are_zero(g, frame.drift))
    entries = [x for form in system.constraints for x in (*form.coefficients, form.constant)]
    rheonomic = any(g.depends(x, g.deps[system.t]) for x in entries)
    settle = leaf_of(system, [x for e in (*frame.free_vectors, frame.drift) for x in e]).settling
    whole = None if affine else (frame.kinematics, frame.free)
    closed = tuple(form.name for form in system.constraints if is_integrable(system, form))
    timed = affine or rheonomic
    fields = [(*e, g.zero) for e in frame.free_vectors] + [(*frame.drift, g.one)] if timed else frame.free_vectors
    if not levels and not closed:
        variables = (*system.q, system.t) if timed else system.q
        if terminal_rank(g, variables, fields, settle, None if timed else whole) == len(variables):
            return Integrability((), 0, (), affine, rheonomic)
    growth = growth_vector(g, system.q, frame.free_vectors, settle, whole)
    hidden = n + 1 - terminal_rank(g, (*system.q, system.t), fields, settle) if timed else n - growth[-1]
    return Integrability(growth, hidden, closed, affine, rheonomic)


def as_given(system: System) -> System | None:
    """The system with the parameters' values of the spec in its constraints; None where there are none to put in."""
    g = system.graph
    pairs = zip(system.p, system.spec.parameters, strict=True)
    values = {p: g.number(parameter.value) for p, parameter in pairs if isinstance(parameter.value, Fraction)}
    forms, changed = [], False
    for form in system.constraints:
        old = [*form.coefficients, form.constant]
        new = substitute(g, old, values, named=False)
        changed = changed or new != old
        equation = form.equation
        if equation is not None:
            (equation,) = substitute(g, [equation], values, named=False)
        forms.append(Form(form.name, tuple(new[:-1]), new[-1], form.place, equation))
    return replace(system, constraints=tuple(forms)) if changed else None


def classify_as_given(system: System, generic: Integrability, *, levels: bool) -> tuple[System, Integrability] | None:
    """What :func:`classify` finds for the parameters' values in the spec, where more is integrable then.

    Parameters whose values are no rational numbers stay as they are; long constraints are not looked at a second time.
    """
    entries = [x for form in system.constraints for x in (*form.coefficients, form.constant)]
    if generic.hidden == system.l or count(system.graph, entries) > _LARGE:
        return None
    dependent = choose_dependent(system).dependent  # for arbitrary parameters: what is chosen is kept for the graph
    try:
        given = as_given(system)
        found = classify(given, coordinate_frame(given, dependent), levels=levels) if given else generic
    except (ArithmeticError, Singular, Unlucky):
        return None  # a division by zero, or dependent rows, which are told apart from this
    return (given, found) if given and found.hidden > generic.hidden else None


def lie_bracket(graph: Graph, variables: Sequence[Node], x: Field, y: Field) -> Field:
    """[x, y] = x(y) - y(x), componentwise."""
    along_x = tangent(graph, y, dict(zip(variables, x, strict=True)))
    along_y = tangent(graph, x, dict(zip(variables, y, strict=True)))
    return tuple(graph.sub(a, b) for a, b in zip(along_x, along_y, strict=True))


def is_integrable(system: System, form: Form) -> bool:
    """omega ^ d omega = 0 for one constraint form alone (Frobenius), time counted as a coordinate.

    Where a_r is not zero, the components (r, j, k) imply the others: contract with e_r/a_r.
    """
    g = system.graph
    a = dict(zip((*system.q, system.t), (*form.coefficients, form.constant), strict=True))
    r = next((v for v, x in a.items() if not is_zero(g, x)), None)
    if r is None:
        return True
    held = g.mask(a.values())
    active = [v for v in a if v != r and (a[v] != g.zero or g.deps[v] & held)]
    near = (r, *active)
    slopes = {v: dict(zip(near, gradient(g, a[v], near), strict=True)) for v in near}
    terms = []
    for number, j in enumerate(active):
        for k in active[number + 1 :]:
            cycle = ((r, j, k), (j, k, r), (k, r, j))
            terms.append(g.sum([g.mul(a[x], g.sub(slopes[z][y], slopes[y][z])) for x, y, z in cycle]))
    return all(are_zero(g, terms))


def cyclic_coordinates(system: System) -> list[int]:
    """Coordinates that T, U, Q and the constraints do not contain."""
    g = system.graph
    nodes = [system.T, system.U, *system.Q, *(x for f in system.constraints for x in (*f.coefficients, f.constant))]
    result = []
    for i, q in enumerate(system.q):
        if not any(depends(g, nodes, [q])):
            result.append(i)
    return result
