"""Velocities along the axes of a body, in place of the row of minors that completes its constraints, or of coordinates'.

The row of minors is regular wherever the constraints are, but long: for two axles that steer it is a sum of products of the sines
and cosines of both.  Where the constraints are those of a body that turns in a plane, they look the same on its axes whatever its
heading, and the velocity along one of these axes, cos(heading) x' + sin(heading) y', often completes them as well: its product
with the row of minors is what the determinant is, does not contain the heading, and may be one that cannot vanish.

Where all minors may vanish together, as those of two axles whose lines coincide at some angle of steering, no completion is regular
everywhere; but of the velocities of coordinates each fails at two headings of every turn, and those along the axes at none.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, islice

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.carry import carry
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.angles import normalise_angles
from nhc.mechanics.frame import coordinate_form
from nhc.mechanics.regular.regularity import coframe_weakness, intervals
from nhc.mechanics.regular.trials import sampled_rows, trial_points
from nhc.mechanics.system import Form, System
from nhc.records import record

_LIMIT = 200  # terms of a product with a row of minors
MOST_HEADINGS = 3
_MOST_TRIALS = 40  # sets of angles that are turned
_STATES, _TURN, _ROUNDING = 2, 1.0, 1e-9


def along_headings(system: System, forms: Sequence[Form]) -> tuple[Form, ...]:
    """The forms with velocities along axes for rows of three minors or more, where none is singular more often for that."""
    made = [_along_axis(system, form) or form for form in forms]
    if all(new is old for new, old in zip(made, forms, strict=True)):
        return tuple(forms)
    weak, before = (coframe_weakness(system, (*system.constraints, *own))[0] for own in (made, forms))
    return tuple(forms) if weak > before else tuple(made)


@record
class Turning:
    """Columns ``first`` and ``second`` of constraints turn with the coordinates in ``places``; ``heading`` is one of these."""

    places: tuple[int, ...]
    heading: int
    first: int
    second: int

    def axes(self, system: System, names: Sequence[str]) -> tuple[Form, Form]:
        """The velocities along the axis with that heading, and across it to the left."""
        g = system.graph
        s, c = g.function("sin", system.q[self.heading]), g.function("cos", system.q[self.heading])
        found = []
        for name, first, second in ((names[0], c, s), (names[-1], g.neg(s), c)):
            coefficients = [g.zero] * system.n
            coefficients[self.first], coefficients[self.second] = first, second
            found.append(Form(name, tuple(coefficients), g.zero))
        return found[0], found[1]


@record
class Axes:
    """The names of two coordinates, and velocities with one along or across a body's axes in place of these coordinates' own."""

    names: tuple[str, str]
    pools: tuple[tuple[Form, ...], ...]

    def halves(self, made: Sequence[Form]) -> bool:
        """Whether a completion has one of the two coordinates' velocities alone: then it is singular at two headings."""
        return len({form.name for form in made} & set(self.names)) == 1


def on_axes(system: System, name: str) -> list[Axes]:
    """What may complete the constraints where these look the same at all headings of a body: the velocity along its axis or across
    it, which bears that name, and the rates of other coordinates, its heading the first or the last of them.
    """
    found = []
    for turning in islice(find_turning(system, range(system.n)), MOST_HEADINGS):
        i, j = turning.first, turning.second
        others = [k for k in range(system.n) if k not in (i, j)]
        orders = others, [*(k for k in others if k != turning.heading), turning.heading]
        pools = [
            (axis, *(coordinate_form(system, k) for k in order))
            for axis in turning.axes(system, (name,))
            for order in orders
        ]
        found.append(Axes((system.q_names[i], system.q_names[j]), tuple(pools)))
    return found


def find_turning(system: System, columns: Sequence[int]) -> Iterator[Turning]:
    """Coordinates with which two of these columns of the constraints turn, while nothing else in them changes: one angle, or
    several that count from the same direction, as those of a car and of its trailer.

    By their values at random states, before and after some turn: it is a choice, on whose ground nothing is left out.
    """
    g = system.graph
    moving = 0
    for form in system.constraints:
        for node in form.coefficients:
            moving |= g.deps[node]
    held = [k for k, q in enumerate(system.q) if moving & g.deps[q]]
    if sum(k not in held for k in columns) < 2:
        return
    states = trial_points(system)[-_STATES:]
    before = _constraint_rows(system, states)
    periodic = [
        k for k in held if not _changed(before, _constraint_rows(system, _turn(system, states, [k], 2 * math.pi)))
    ]
    together = (places for size in range(1, len(periodic) + 1) for places in combinations(periodic, size))
    for places in islice(together, _MOST_TRIALS):
        after = _constraint_rows(system, _turn(system, states, places, _TURN))
        changed = sorted(_changed(before, after))
        if len(changed) != 2 or set(changed) & set(held) or not set(changed) <= set(columns):
            continue
        pairs = [pair for old, new in zip(before, after, strict=True) for pair in zip(old, new, strict=True)]
        for i, j in (changed, changed[::-1]):
            if all(_turns(old[i], old[j], new[i], new[j]) for old, new in pairs):
                yield from (Turning(places, heading, i, j) for heading in places)
                break


def _constraint_rows(system: System, states: Sequence[Mapping[Node, float]]) -> list[list[list[float]]]:
    return sampled_rows(system, system.constraints, [dict(state) for state in states], units=[1.0] * system.n)


def _changed(before: Sequence[Sequence[Sequence[float]]], after: Sequence[Sequence[Sequence[float]]]) -> set[int]:
    """The columns that differ; all where one of the states has no values."""
    if len(before) != _STATES or len(after) != _STATES:
        return set(range(len(before[0][0]))) if before else {0}
    return {
        j
        for old, new in zip(before, after, strict=True)
        for one, other in zip(old, new, strict=True)
        for j, (x, y) in enumerate(zip(one, other, strict=True))
        if abs(x - y) > _ROUNDING * (1 + abs(x))
    }


def _turn(
    system: System, states: Sequence[Mapping[Node, float]], places: Sequence[int], angle: float
) -> list[dict[Node, float]]:
    return [{**state, **{system.q[k]: state[system.q[k]] + angle for k in places}} for state in states]


def turned(system: System, state: Mapping[Node, float], places: Sequence[int]) -> dict[Node, float]:
    """The state with these coordinates, angles, turned by the same."""
    return _turn(system, [state], places, _TURN)[0]


def _turns(x: float, y: float, new_x: float, new_y: float) -> bool:
    c, s = math.cos(_TURN), math.sin(_TURN)
    return abs(c * x - s * y - new_x) + abs(s * x + c * y - new_y) <= _ROUNDING * (1 + abs(x) + abs(y))


def _along_axis(system: System, form: Form) -> Form | None:
    """The velocity along an axis in place of a row of minors; None where none is known to be regular."""
    g = system.graph
    minors = [j for j, node in enumerate(form.coefficients) if node != g.zero]
    for i, j in combinations(minors, 2) if len(minors) > 2 else ():
        pair = form.coefficients[i], form.coefficients[j]
        found = _find_axis(system, pair)
        if found is not None:
            heading, across = found
            s, c = g.function("sin", heading), g.function("cos", heading)
            coefficients = [g.zero] * system.n
            coefficients[i], coefficients[j] = (g.neg(s), c) if across else (c, s)
            return Form(form.name, tuple(coefficients), g.zero)
    return None


def _find_axis(system: System, pair: Sequence[Node]) -> tuple[Node, bool] | None:
    """The heading of axes of which one, the second if true, is one along which two minors cannot vanish together."""
    scratch, symbols, (x, y) = _copied(system, pair)
    known = {symbols[node]: bounds for node, bounds in intervals(system).items() if node in symbols}
    for heading in (q for q in system.q if q in symbols):
        s, c = scratch.function("sin", symbols[heading]), scratch.function("cos", symbols[heading])
        along, across = scratch.dot((c, s), (x, y)), scratch.sub(scratch.mul(c, y), scratch.mul(s, x))
        for product in (along, across):
            if _is_regular(scratch, product, symbols[heading], known):
                return heading, product == across
    return None


def _copied(system: System, nodes: Sequence[Node]) -> tuple[Graph, dict[Node, Node], list[Node]]:
    """Nodes on a graph of their own: what is tried leaves none behind, whose order is part of what is derived later."""
    scratch, symbols = Graph(), dict[Node, Node]()
    for node in dict.fromkeys(node for root in nodes for node in system.graph.symbols_in(root)):
        symbol = system.graph.symbol_of(node)
        assert symbol is not None
        symbols[node] = scratch.symbol(symbol.name, symbol.kind)
    return scratch, symbols, carry(system.graph, scratch, nodes, symbols)


def _is_regular(graph: Graph, product: Node, heading: Node, known: Mapping[Node, Interval]) -> bool:
    determinant = normalise_angles(graph, product, _LIMIT)
    return not graph.depends(determinant, graph.mask((heading,))) and cannot_vanish(graph, determinant, known)
