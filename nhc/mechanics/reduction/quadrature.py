"""Coordinates that follow from others without an equation of their own.

Where rates q'_i = c_ik w_k + d_i have coefficients that are constant on every motion, each linear relation between the rows c_i
integrates to q_i = C + a_j q_j + d t: constraints such as r*theta' = x', wheels on one axle, angles that turn at a constant rate.
Where the constraints have an integral f(q, t) = C (holonomic ones, and those that are so in disguise) in which one coordinate
stands linearly with a constant factor, that coordinate is a function of the others.

Far from t = 0 functions of the time are not taken: C + d t keeps few digits there, and rates over it jump from one double t to the
next, which an integrator takes for a rough motion.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.exact.modular import Unlucky, are_zero
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.digits import normalise_kept
from nhc.algebra.show import to_text
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.properties.constancy import has_jumps
from nhc.mechanics.properties.integrability import classify
from nhc.mechanics.properties.integrals import find_position_integrals
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.regular.undefined import are_defined
from nhc.mechanics.system import System
from nhc.records import record

_TERMS = 40
_LONGEST = 160  # characters of a reason that is still read
MOST_COORDINATES = 6  # beyond, looking for integrals takes longer than it saves


@record
class Integral:
    """q_index = ``symbol`` + ``rest``, the symbol being a constant of the motion.

    ``written``: the same as it was found and as the text says it; it may hold other coordinates that have integrals.
    """

    index: int
    symbol: Node
    rest: Node
    text: str
    written: Node


@record
class Given:
    """What is known of a scene's motions.

    ``constants`` are symbols that do not change on a motion beside the parameters, ``first`` coordinates that had better stay,
    ``known`` bounds of symbols; ``far``: it takes place far from t = 0.
    """

    constants: Sequence[Node]
    first: Sequence[int]
    known: Mapping[Node, Interval]
    far: bool


@record
class _Row:
    """sum of weights * q' = vector . w + drift; ``vector`` is 1 in column ``pivot``."""

    pivot: int
    vector: tuple[Node, ...]
    weights: Mapping[int, Node]
    drift: Node


def find_integrals(system: System, rates: Mapping[int, Node], w: Sequence[Node], given: Given) -> list[Integral]:
    """The coordinates among ``rates`` (index -> q' over the kept state) that follow from the others."""
    g = system.graph
    changing = ~g.mask((*system.p, *given.constants))
    rows: list[_Row] = []
    found: list[Integral] = []
    for i in sorted(rates, key=lambda i: (i not in given.first, i)):
        try:
            coefficients, drift = linear_form(g, rates[i], w)
        except NotLinear:
            continue
        parts = _clean(system, [*coefficients, drift])
        if any(g.deps[part] & changing for part in parts):
            continue
        row = _reduce(system, _Row(-1, tuple(parts[:-1]), {i: g.one}, parts[-1]), rows)
        pivot = next((k for k, x in enumerate(row.vector) if x != g.zero), None)
        if pivot is None:
            if not given.far or _clean(system, [row.drift]) == [g.zero]:
                found.append(_integral(system, i, row))
        elif cannot_vanish(g, row.vector[pivot], given.known):
            rows.append(_scaled(system, row, pivot))
    return found


def find_closed(system: System, place: Mapping[Node, float]) -> tuple[Node, ...]:
    """Integrals f(q, t) of the constraints, those that are declared and those that are found; nothing for large systems.

    Those without a value at the ``place`` where a motion starts are left out: x' = x*y' holds at x = 0 too, of which its integral
    y - log(abs(x)) does not tell.  Along a motion that starts where it has a value it stays what it is.
    """
    if not system.constraints or system.n > MOST_COORDINATES:
        return tuple(form.equation for form in system.constraints if form.equation is not None)
    try:
        found = classify(system)
        if not found.hidden:
            return ()
        frame = coordinate_frame(system, choose_dependent(system).dependent)
        nodes = [integral.node for integral in find_position_integrals(system, frame, found.hidden, found.closed)]
    except Unlucky:
        return ()
    return tuple(node for node, defined in zip(nodes, are_defined(system, nodes, place), strict=True) if defined)


def solve_closed(
    system: System, closed: Sequence[Node], held: Sequence[int], found: Sequence[Integral], given: Given
) -> list[Integral]:
    """The coordinates among ``held`` that integrals of the constraints give by the other ones; after those already ``found``."""
    g, made = system.graph, list(found)
    changing = ~g.mask((*system.p, *given.constants))
    for node in closed:
        free = [i for i in held if all(i != integral.index for integral in made)]
        others = g.mask([q for i, q in enumerate(system.q) if i not in free])
        known_ones = {system.q[integral.index]: g.add(integral.symbol, integral.rest) for integral in made}
        f = normalise_kept(g, substitute(g, [node], known_ones)[0], _TERMS)
        # a coordinate goes on where the branch of an angle ends
        late = given.far and g.depends(f, g.deps[system.t])
        if late or g.depends(f, others) or has_jumps(system, [node], elsewhere=True):
            continue
        for i in sorted(free, key=lambda i: (i in given.first, -i)):
            try:
                (factor,), rest = linear_form(g, f, [system.q[i]])
            except NotLinear:
                continue
            (factor,) = _clean(system, [factor])
            if factor == g.zero or g.deps[factor] & changing or not cannot_vanish(g, factor, given.known):
                continue
            made.append(_name_integral(system, i, g.neg(g.div(rest, factor))))
            break
    return made[len(found) :]


def _clean(system: System, nodes: Sequence[Node]) -> list[Node]:
    g = system.graph
    zero = are_zero(g, nodes)
    return [g.zero if z else normalise_kept(g, node, _TERMS) for z, node in zip(zero, nodes, strict=True)]


def _reduce(system: System, row: _Row, rows: Sequence[_Row]) -> _Row:
    """The row less multiples of those before it."""
    g = system.graph
    vector, weights, drift = list(row.vector), dict(row.weights), row.drift
    for other in rows:
        factor = vector[other.pivot]
        if factor == g.zero:
            continue
        vector = _clean(system, [g.sub(x, g.mul(factor, y)) for x, y in zip(vector, other.vector, strict=True)])
        drift = g.sub(drift, g.mul(factor, other.drift))
        for j, weight in other.weights.items():
            weights[j] = g.sub(weights.get(j, g.zero), g.mul(factor, weight))
    return _Row(-1, tuple(vector), weights, drift)


def _scaled(system: System, row: _Row, pivot: int) -> _Row:
    g = system.graph
    scale = g.inverse(row.vector[pivot])
    vector = tuple(g.one if k == pivot else g.mul(scale, x) for k, x in enumerate(row.vector))
    return _Row(pivot, vector, {j: g.mul(scale, x) for j, x in row.weights.items()}, g.mul(scale, row.drift))


def _integral(system: System, i: int, row: _Row) -> Integral:
    g = system.graph
    names = [j for j in sorted(row.weights) if j != i]
    weights = _clean(system, [*(g.neg(row.weights[j]) for j in names), row.drift])
    terms = [g.mul(weight, system.q[j]) for j, weight in zip(names, weights, strict=False)]
    return _name_integral(system, i, g.sum([*terms, g.mul(weights[-1], system.t)]))


def _name_integral(system: System, i: int, rest: Node) -> Integral:
    g = system.graph
    name = f"{system.q_names[i]}_0"
    taken = {*system.q_names, *(p.name for p in system.spec.parameters), *(form.name for form in system.quasi)}
    while name in taken:
        name += "_"
    whole = to_text(g, rest)
    if len(whole) > _LONGEST:
        whole = f"a function of {', '.join(n for n, q in zip(system.q_names, system.q, strict=True) if g.depends(rest, g.deps[q]))}"
    text = name if rest == g.zero else f"{name} - {whole[1:]}" if whole.startswith("-") else f"{name} + {whole}"
    return Integral(i, g.symbol(name, "constant"), rest, f"{system.q_names[i]} = {text}", rest)


def close_integrals(system: System, found: Sequence[Integral]) -> list[Integral]:
    """The integrals over coordinates that have none: a later one may give what an earlier one contains."""
    g = system.graph
    known: dict[Node, Node] = {}
    closed: list[Integral] = []
    for integral in reversed(found):
        rest = substitute(g, [integral.written], known)[0]
        known[system.q[integral.index]] = g.add(integral.symbol, rest)
        closed.insert(0, replace(integral, rest=rest))
    return closed
