"""What a run keeps an eye on: values whose change of sign ends it, or hands it to another formulation.

In this order: the user's event; the edges beyond which it has no value; the determinants that the formulation divides by; how far
those, the pivots of the mass matrix and the rank of the constraints are from nothing; how far they are from weak.  All after the
edges are free of scale: a determinant d with the size s that its entries allow gives d^2 - (c s)^2, a pivot or a sum of squares p
gives p - c s.  Of a constraint whose coefficients vanish all at once s is what the start has.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain

from nhc.algebra.bounds.interval import cannot_vanish
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.blocks import determinant_of
from nhc.algebra.solving.sizes import row_scale, size_of
from nhc.algebra.walks import count
from nhc.mechanics.properties.singular import (
    find_rank_loss,
    find_vanishing_factors,
    find_vanishing_minors,
    find_vanishing_rows,
)
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.regular.trials import usual_digits, usual_part
from nhc.mechanics.system import System
from nhc.program.ir import Function, Lookout
from nhc.program.plan import GuardPlan, SolvePlan
from nhc.program.planning.base import MASS_LOST
from nhc.program.planning.planner import Planner
from nhc.program.runs.nearness import are_masses_regular, find_nearness
from nhc.program.runs.sharing import NO_FRICTION, Held, list_releases, put_values
from nhc.records import record

NOTHING = Fraction(1, 10**12)
"""Of the scale: less is singular.  An angle's sine, squared in a mass matrix, is 1e-6 there."""
WEAK = tuple(Fraction(1, k) for k in (33, 100, 333, 1000, 10000))
"""Of a determinant's scale: levels at which a run looks for another formulation; the scale may be too large by far."""
DEEP = Fraction(1, 333)
SMALL = Fraction(1, 100)
"""Of its scale: the largest part that a determinant is anywhere; if it is less, levels are of that part."""
THIN = Fraction(1, 10**4)
"""The same of a square's scale, and of a determinant's that is divided by once, not squared: four digits are lost there."""
SLIGHT = Fraction(1, 10**8)
"""The same of the sum of a constraint's squares, against the start's: it has a ten thousandth of its size."""
RANK_LOST = "the constraints lose rank"
_LARGE = 400  # operations beyond which a pivot is not followed
_TERMS = 60
_MOST_ROWS = 4  # of a matrix whose determinant is written out


@record
class Event:
    """The ``value`` whose zero ends a run; it has a meaning while its ``edges`` are positive; ``told``: what happens where not."""

    value: Node
    edges: tuple[Node, ...] = ()
    told: tuple[str, ...] = ()


@record
class Watch:
    """``about[k]`` says what value k is, ``kinds[k]`` is event, edge, frame, mass, rank, row, minors or whole, and deep for a
    frame's lower levels.

    ``events``, ``signs``, ``close`` count the events, the edges and determinants, and the values that tell a singularity by
    closeness; those after them tell weakness, first of ``frames`` determinants of coframes, each at the levels ``WEAK``.
    """

    about: tuple[str, ...] = ()
    kinds: tuple[str, ...] = ()
    events: int = 0
    signs: int = 0
    close: int = 0
    frames: int = 0

    @property
    def dips(self) -> int:
        """The first value that is sought where it only touches zero."""
        return self.events + self.signs

    @property
    def weak(self) -> int:
        """The first value that tells weakness only."""
        return self.dips + self.close

    def describe(self, index: int) -> str:
        """What it means that value ``index``, which is not the user's, changed its sign."""
        what, kind = self.about[index], self.kinds[index]
        beyond = "results beyond it would be wrong"
        if kind == "row" or (index < self.dips and kind == "rank"):
            return f"{what} here: all coefficients of one of them vanish, and {beyond}"
        if kind == "edge":
            return f"the expression of `--until` has no value beyond this place, where {what}"
        if index < self.dips and kind != "minors":
            return f"{what}: the determinant changes its sign here, and {beyond}"
        if kind == "mass":
            who = "the coordinates, or the velocities that are kept," if "frame" in self.kinds else "the coordinates"
            return f"{what}: a pivot of it vanishes here, where {who} do not tell the motion, and {beyond}"
        if kind in ("rank", "minors"):
            return f"{what} here: their minors vanish together, and {beyond}"
        if kind == "whole":
            return f"{what} here, and {beyond}"
        return f"{what}: the determinant vanishes here, and {beyond}"


@record
class _Measure:
    """``value`` against ``scale``; ``squared``: it is a square or positive already.

    ``levels``: where it is weak, as parts of ``usual`` times the scale.
    """

    value: Node
    scale: Node
    squared: bool
    kind: str
    what: str
    levels: tuple[Fraction, ...]
    usual: Fraction = Fraction(1)


def watch_function(
    planner: Planner,
    event: Event | None,
    weak: bool,
    known: dict[Node, tuple[float, float]],
    starts: Sequence[Mapping[Node, float]],
    held: Held = NO_FRICTION,
) -> tuple[Function | None, Watch]:
    """The function of a run's watched values, None where there are none; ``weak``: with the levels of weakness.

    ``known``: intervals of symbols beside those of the spec, such as a scene's parameters; ``starts``: values of t, q and p;
    ``held``: the frictions that hold, whose ends are events after the user's.
    """
    events, edges = _asked(planner, event, held)
    frames = _frames(planner)
    determinants = [*_turned(planner), *_determinant(planner, known)]
    whole, solves = _whole(planner, known)
    solves = (*solves, *(plan for plan in planner.solves if plan not in solves)) if held.frictions else solves
    # pivots of a mass matrix have no value where one of the coframe's vanishes, which is no singular place
    pivots = [] if planner.exchanges else _pivots(planner, known)
    measures = [*frames, *determinants, *pivots, *_rank(planner), *(whole or _rows(planner, starts))]
    seen = {m.value for m in (*frames, *determinants)}
    factors = [m for m in _factors(planner) if m.value not in seen]
    signs = [m for m in (*frames, *determinants, *factors) if m.value not in events]
    nodes = [*events, *edges, *(m.value for m in signs)]
    about = [*("" for _ in events), *(() if event is None else event.told), *(m.what for m in signs)]
    kinds = [*("event" for _ in events), *("edge" for _ in edges), *(m.kind for m in signs)]
    levels: list[tuple[_Measure, Fraction]] = [(m, NOTHING) for m in measures]
    close = len(levels)
    if weak:
        levels += [(m, level * m.usual) for m in measures for level in m.levels]
    for measure, level in levels:
        nodes.append(_distance(planner, measure, level))
        about.append(measure.what)
        deep = measure.kind == "frame" and NOTHING < level <= DEEP * measure.usual
        kinds.append("deep" if deep else measure.kind)
    if not nodes:
        return None, Watch()
    watch = Watch(tuple(about), tuple(kinds), len(events), len(edges) + len(signs), close, len(frames) if weak else 0)
    what, other = "values whose change of sign ends a run", planner.exchanges
    if other is None or not events:
        return planner.lower_out("watch", what, nodes, about, solves=solves), watch
    made = planner.lower_out("watch", what, nodes, about, planner.frame_guards())
    exchanged = [*chain(*_asked(other, event, held)), *nodes[len(events) + len(edges) :]]
    return replace(made, otherwise=other.lower_out("watch", what, exchanged, about)), watch


def _asked(planner: Planner, event: Event | None, held: Held) -> tuple[list[Node], list[Node]]:
    """The events, the user's first, and its edges."""
    releases = list_releases(planner, held) if held.frictions else []
    if event is None:
        return releases, []
    value, *edges = put_values(planner, held, planner.on_motion([event.value, *event.edges]))
    return [value, *releases], edges


def look_out(
    planner: Planner, parameters: Sequence[Sequence[float]], starts: Sequence[Mapping[Node, float]]
) -> Lookout | None:
    """What a driver watches in scenes with these values of the spec's parameters that start with these of t, q and p; None where
    nothing can be lost.
    """
    function, watch = watch_function(planner, None, False, known_values(planner.system, parameters), starts)
    if function is None:
        return None
    return Lookout(function, tuple(watch.describe(k) + _way_out(watch, k) for k in range(len(watch.about))), watch.dips)


def _way_out(watch: Watch, index: int) -> str:
    """A driver keeps the formulation that it was emitted with: where another has no such place, that is said.  Of a pivot, too: the
    determinant of the choice of velocities is in it, squared, so that it is lost first where that vanishes.
    """
    if watch.kinds[index] != "frame" and not (watch.kinds[index] == "mass" and "frame" in watch.kinds):
        return ""
    return "; emitted with `--formulation multipliers` the model chooses no velocities"


def known_values(system: System, parameters: Sequence[Sequence[float]]) -> dict[Node, tuple[float, float]]:
    """From the least to the largest value of each of the spec's parameters."""
    columns = zip(*parameters, strict=True)
    return {symbol: (min(values), max(values)) for symbol, values in zip(system.p, columns, strict=True)}


def _distance(planner: Planner, measure: _Measure, level: Fraction) -> Node:
    g = planner.graph
    if measure.squared:
        return g.sub(measure.value, g.mul(g.number(level), measure.scale))
    return g.sub(g.power(measure.value, 2), g.mul(g.number(level**2), g.power(measure.scale, 2)))


def _frames(planner: Planner) -> list[_Measure]:
    return _guarded(planner, planner.frame_determinants(), "frame", WEAK)


def _turned(planner: Planner) -> list[_Measure]:
    return _guarded(planner, planner.turned_guards, "mass", (THIN,))


def _guarded(planner: Planner, guards: Sequence[GuardPlan], kind: str, levels: tuple[Fraction, ...]) -> list[_Measure]:
    seen: dict[Node, _Measure] = {}
    for guard in guards:
        if not planner.is_constant(guard.value):
            usual = Fraction(1, 10 ** usual_digits(planner.system, guard.value, guard.scale))
            scale = planner.graph.mul(planner.graph.number(usual), guard.scale)
            part = usual_part(planner.system, guard.value, guard.scale) / usual
            own = _Measure(guard.value, scale, False, kind, guard.what, levels, part if part < SMALL else Fraction(1))
            seen.setdefault(guard.value, own)
    return list(seen.values())


def _pivots(planner: Planner, known: dict[Node, tuple[float, float]]) -> list[_Measure]:
    """Pivots of the mass matrix that may vanish for all that is known, with the entry that each came from or its own size."""
    g, found = planner.graph, []
    ranges = {**intervals(planner.system), **known}
    for guard in planner.mass_guards:
        if guard in planner.turned_guards or planner.is_constant(guard.value) or count(g, [guard.value]) > _LARGE:
            continue
        if cannot_vanish(g, normalise(g, guard.value, _TERMS), ranges):
            continue
        scale = size_of(g, guard.value) if guard.scale == g.zero else guard.scale
        found.append(_Measure(guard.value, scale, True, "mass", MASS_LOST, (THIN,)))
    return found


def _determinant(planner: Planner, known: dict[Node, tuple[float, float]]) -> list[_Measure]:
    """Of a small mass matrix that is not positive by itself: solved with pivoting, it may change its sign between two steps."""
    g = planner.graph
    if planner.equations.multipliers or not planner.solves or len(planner.solves[0].matrix) > _MOST_ROWS:
        return []
    rows = planner.solves[0].matrix
    value = determinant_of(g, [list(row) for row in rows])
    if count(g, [value]) > _LARGE or planner.is_constant(value):
        return []
    if cannot_vanish(g, normalise(g, value, _TERMS), {**intervals(planner.system), **known}):
        return []
    return [_Measure(value, row_scale(g, rows), False, "mass", MASS_LOST, (DEEP,))]


def _whole(planner: Planner, known: dict[Node, tuple[float, float]]) -> tuple[list[_Measure], tuple[SolvePlan, ...]]:
    """How near the multiplier form is to singular, with the solve that tells it, where its parts do not tell by themselves."""
    if not planner.equations.multipliers or not planner.solves:
        return [], ()
    judged = find_rank_loss(planner.system).regular is not None
    if judged and are_masses_regular(planner, {**intervals(planner.system), **known}):
        return [], ()
    near = find_nearness(planner)
    if near is None:
        return [], ()
    scale = planner.graph.number(near.usual)
    return [_Measure(near.value, scale, True, "whole", near.solve.what, (THIN,))], (near.solve,)


def _rank(planner: Planner) -> list[_Measure]:
    """All velocities kept: the sum of the squares of the constraints' minors, which no other guard looks at."""
    g, system = planner.graph, planner.system
    if not planner.equations.multipliers:
        return []
    lost = find_rank_loss(system)
    if lost.regular is not False:
        return []
    value = g.sum([g.power(minor, 2) for minor in substitute(g, lost.minors, planner.put_in)])
    if planner.is_constant(value):
        return []
    return [_Measure(value, size_of(g, value), True, "rank", RANK_LOST, (THIN,))]


def _rows(planner: Planner, starts: Sequence[Mapping[Node, float]]) -> list[_Measure]:
    """Constraints whose coefficients may vanish all at once, against the least of the sizes that they start with."""
    g, found = planner.graph, list[_Measure]()
    for row in find_vanishing_rows(planner.system):
        square = g.sum([g.power(entry, 2) for entry in row])
        (value,) = substitute(g, [square], planner.put_in)
        least = min(_value_at(g, square, start) for start in starts)
        if least > 0 and not g.deps[value] & ~g.mask((*planner.y_nodes, *planner.parameters, planner.system.t)):
            found.append(_Measure(value, g.number(Fraction(f"{least:.3g}")), True, "row", RANK_LOST, (SLIGHT,)))
    return found


def _value_at(graph: Graph, node: Node, place: Mapping[Node, float]) -> float:
    """The node's value; 0 where it has none."""
    try:
        (value,) = evaluate(graph, [node], dict(place))
    except (ArithmeticError, ValueError):
        return 0.0
    return float(value) if math.isfinite(value) else 0.0


def _factors(planner: Planner) -> list[_Measure]:
    """What a constraint is multiplied by as a whole, or all minors of several, where that may vanish: only its sign tells."""
    g, system, found = planner.graph, planner.system, list[_Measure]()
    for kind, nodes in (("rank", find_vanishing_factors(system)), ("minors", find_vanishing_minors(system))):
        for value in substitute(g, nodes, planner.put_in):
            if not planner.is_constant(value) and value not in [m.value for m in found]:
                found.append(_Measure(value, g.one, False, kind, RANK_LOST, ()))
    return found
