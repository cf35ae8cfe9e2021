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
_MOST_HEADINGS = 3
_STATES, _TURN, _ROUNDING = 2, 1.0, 1e-9


def along_headings(system: System, forms: Sequence[Form]) -> tuple[Form, ...]:
    """The forms with velocities along axes for rows of three minors or more, where none is singular more often for that."""
    made = [_along_axis(system, form) or form for form in forms]
    if all(new is old for new, old in zip(made, forms, strict=True)):
        return tuple(forms)
    weak, before = (coframe_weakness(system, (*system.constraints, *own))[0] for own in (made, forms))
    return tuple(forms) if weak > before else tuple(made)


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
    g, found = system.graph, []
    for heading, i, j in islice(_turning(system), _MOST_HEADINGS):
        others = [k for k in range(system.n) if k not in (i, j)]
        orders = others, [*(k for k in others if k != heading), heading]
        s, c = g.function("sin", system.q[heading]), g.function("cos", system.q[heading])
        pools = []
        for first, second in ((c, s), (g.neg(s), c)):
            coefficients = [g.zero] * system.n
            coefficients[i], coefficients[j] = first, second
            axis = Form(name, tuple(coefficients), g.zero)
            pools += [(axis, *(coordinate_form(system, k) for k in order)) for order in orders]
        found.append(Axes((system.q_names[i], system.q_names[j]), tuple(pools)))
    return found


def _turning(system: System) -> Iterator[tuple[int, int, int]]:
    """Each coordinate with which two columns of the constraints turn, while nothing else in them changes; with these columns.

    By their values at random states, before and after some turn: it is a choice, on whose ground nothing is left out.
    """
    states, units = trial_points(system)[-_STATES:], [1.0] * system.n
    before = sampled_rows(system, system.constraints, [dict(state) for state in states], units=units)
    g, entries = system.graph, [node for form in system.constraints for node in form.coefficients]
    for k, heading in enumerate(system.q):
        if not any(g.depends(node, g.deps[heading]) for node in entries):
            continue
        turned = [state | {heading: state[heading] + _TURN} for state in states]
        after = sampled_rows(system, system.constraints, turned, units=units)
        if len(before) == len(after) == _STATES:
            pairs = [pair for old, new in zip(before, after, strict=True) for pair in zip(old, new, strict=True)]
            columns = sorted({j for old, new in pairs for j in range(system.n) if abs(new[j] - old[j]) > _ROUNDING})
            for i, j in (columns, columns[::-1]) if len(columns) == 2 else ():
                if all(_turns(old[i], old[j], new[i], new[j]) for old, new in pairs):
                    yield k, i, j
                    break


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
