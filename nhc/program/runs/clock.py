"""Times at which a run has to look: corners and short pulses of what depends on time alone.

Adaptive steps see a force by its values at their stages.  A system at rest takes steps as long as its scene, and a pulse of a
tenth of a second lies between the stages: the estimate of the error knows nothing of it.  Each function of time in the spec
has its special places where its argument is zero or turns: there ``sign`` jumps, ``max`` has a corner, ``exp(-((t - a)/w)^2)`` its
peak.  The argument is a slow function of time also where the pulse is short, so that a grid finds them.

Functions of the state have such places along a motion, and the steps look for these by themselves (:mod:`nhc.program.runs.leaps`),
as for those of a function of time that turns more often than the grid can tell.  Of it the first are listed, for a body at rest.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise
from math import exp, inf, isfinite, nan, sin, ulp

from nhc.algebra.evaluate import evaluate_into
from nhc.algebra.graph import POW, Graph, Node
from nhc.algebra.walks import reachable
from nhc.mechanics.system import System
from nhc.program.ir import Stop
from nhc.records import record

GRID = 1024
CORNERS = frozenset({"sign", "abs", "min", "max", "atan2"})
_PEAKS = frozenset({"exp", "sqrt", "powf", "log", POW})
STEPS = frozenset({"tanh", "atan"})
_SPECIAL = CORNERS | _PEAKS | STEPS
_HALVINGS, _SECTIONS, _BISECTIONS = 50, 60, 100
_CHANGES = 4  # of a sign between two places of the grid: by way of zero there are two, beyond them is rounding
_AROUND = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)  # widths from a pulse's middle at which a step ends
_POLE = 1e6  # of an argument's size on the grid: no function turns there
_FAR = 3.0  # what exp's argument changes by where exp has a pulse
HIGH = 8  # a power of something that turns: from there on it has peaks
_FIRST, _LISTED = 0.125, 256  # of the scene, and stops there, where there are too many
_ULPS = 3  # at both sides of a corner, which the C may have elsewhere
_ISOLATED = 8.0  # widths to the next pulse beyond which the time between them is quiet


def find_stops(system: System, p: Sequence[float], time: tuple[float, float]) -> tuple[Stop, ...]:
    """The times between the start and the end of a scene, in their order, at which a step has to end.

    ``p``: values of the parameters in the spec's order.
    """
    t, values = system.t, dict(zip(system.p, p, strict=True))
    outside = ~system.graph.mask((t, *system.p))
    alone = [node for node in list_special(system, (t,)) if not system.graph.deps[node] & outside]
    if not alone:
        return ()
    search = Search(system.graph, lambda now: {t: now, **values}, *time)
    return join_stops(stop for node in alone for stop in search.list_stops(node))


def list_special(system: System, symbols: Sequence[Node]) -> list[Node]:
    """The functions in the spec's energies, forces and constraints that have special places and depend on one of the symbols."""
    op, exponent = system.graph.op, system.graph.b
    reached = list_reached(system, symbols)
    return [n for n in reached if op[n] in _SPECIAL and (op[n] != POW or not 0 < exponent[n] < HIGH)]


def list_reached(system: System, symbols: Sequence[Node]) -> list[Node]:
    """What depends on one of the symbols in the spec's energies, forces and constraints."""
    roots = [system.T, system.U, *system.Q]
    for form in (*system.constraints, *system.quasi):
        roots += [*form.coefficients, form.constant, *([form.equation] if form.equation is not None else [])]
    return reachable(system.graph, roots, system.graph.mask(symbols))


def join_stops(stops: Iterable[Stop]) -> tuple[Stop, ...]:
    """In their order; those that touch are one."""
    joined: list[Stop] = []
    for before, after in sorted(stops):
        if joined and before <= joined[-1][1]:
            joined[-1] = (joined[-1][0], max(after, joined[-1][1]))
        else:
            joined.append((before, after))
    return tuple(joined)


@record
class _Place:
    """A special place of a function: between two times with nothing but it between them."""

    before: float
    after: float

    @property
    def middle(self) -> float:
        return 0.5 * (self.before + self.after)


class Search:
    """Functions of time between two times; ``place`` gives the values of their symbols, ``grid`` is a number of intervals."""

    def __init__(
        self,
        graph: Graph,
        place: Callable[[float], Mapping[Node, float]],
        low: float,
        high: float,
        grid: int = GRID,
    ) -> None:
        self.graph, self._place = graph, place
        self.low, self.high, self._grid = low, high, grid
        # uneven, so that no period falls in with them
        inner = (low + (high - low) * (k + 0.25 * sin(2.4 * k)) / grid for k in range(1, grid))
        self._times = [low, *inner, high]

    def list_stops(self, node: Node) -> list[Stop]:
        """Where a step has to end for the sake of one special node, not of its operands."""
        kind, argument = self.graph.op[node], self._argument(node)
        values = [argument(t) for t in self._times]
        if not _may_be_short(kind, values, self.graph.b[node] if kind == POW else 0):
            return []
        if _count_turns(values) > self._grid // 4:
            return self._list_first(node)
        zeros, turns = self._special(argument, values)
        if kind in CORNERS:
            size = max(map(abs, filter(isfinite, values)))
            found = [self._bracket(argument, place, size) for place in zeros]
        else:
            places = (*zeros, *turns) if kind in STEPS else turns
            found = self._around([place.middle for place in places], self._function(node))
        return [stop for stop in found if self.low < stop[0] and stop[1] < self.high]

    def _list_first(self, node: Node) -> list[Stop]:
        """Of what turns too often for the grid, the first stops: they tell the sizes that it gives a state at rest."""
        end = self.low + _FIRST * (self.high - self.low)
        if not self.low + 1e-9 * max(abs(self.low), abs(self.high)) < end:
            return []
        return Search(self.graph, self._place, self.low, end, self._grid).list_stops(node)[:_LISTED]

    # --- functions of time ----------------------------------------------------------------------------------

    def _function(self, node: Node) -> Callable[[float], float]:
        order = reachable(self.graph, [node])

        def value(t: float) -> float:
            known = dict(self._place(t))
            try:
                evaluate_into(known, self.graph, order)
            except (ArithmeticError, ValueError):
                return nan
            return float(known[node])

        return lru_cache(maxsize=4 * GRID)(value)

    def _argument(self, node: Node) -> Callable[[float], float]:
        """What decides where a function is special: its operand, of two that are compared their difference."""
        first = self._function(self.graph.a[node])
        if self.graph.op[node] not in ("min", "max"):
            return first
        second = self._function(self.graph.b[node])
        return lambda t: first(t) - second(t)

    # --- special places ---------------------------------------------------------------------------------------

    def _special(self, f: Callable[[float], float], values: Sequence[float]) -> tuple[list[_Place], list[_Place]]:
        """Where f changes its sign, and where it turns."""
        times = self._times
        size = max((abs(v) for v in values if isfinite(v)), default=0.0)
        turns, marks = list[_Place](), [(times[0], values[0])]
        for k in range(1, len(times)):
            if k + 1 < len(times):
                rise, fall = values[k] - values[k - 1], values[k + 1] - values[k]
                if rise * fall < 0.0 and min(abs(rise), abs(fall)) > 1e-13 * size:
                    t = self._turn(f, times[k - 1], times[k + 1], -1.0 if rise > 0.0 else 1.0)
                    if abs(f(t)) < _POLE * size:
                        turns.append(_Place(t, t))
                        marks.append((t, f(t)))
            marks.append((times[k], values[k]))
        marks.sort()
        zeros = list[_Place]()
        for (a, u), (b, v) in pairwise(marks):
            zeros += self._change(f, a, b, _sign(u), _sign(v))
        return zeros, turns

    def _turn(self, f: Callable[[float], float], a: float, b: float, sign: float) -> float:
        """Where sign*f is least between a and b, by golden sections."""
        part = 0.6180339887498949
        c, d = b - part * (b - a), a + part * (b - a)
        u, v = sign * f(c), sign * f(d)
        for _ in range(_SECTIONS):
            if u < v:
                b, d, v = d, c, u
                c = b - part * (b - a)
                u = sign * f(c)
            else:
                a, c, u = c, d, v
                d = a + part * (b - a)
                v = sign * f(d)
        return 0.5 * (a + b)

    def _change(self, f: Callable[[float], float], a: float, b: float, before: int, after: int) -> list[_Place]:
        """The places between a and b at which f's sign changes; zero, where f stays there, is a sign of its own."""
        found = list[_Place]()
        while before != after and a < b and len(found) < _CHANGES:
            low, high, sign = a, b, after
            for _ in range(_BISECTIONS):
                middle = 0.5 * (low + high)
                if not low < middle < high:
                    break
                here = _sign(f(middle))
                if here == before:
                    low = middle
                else:
                    high, sign = middle, here
            found.append(_Place(low, high))
            a, before = high, sign
        return found

    def _bracket(self, f: Callable[[float], float], place: _Place, size: float) -> Stop:
        """Around a zero of f, by what its rounding may be where a sine or a product is rounded otherwise."""
        rounding, step = max(abs(f(place.before)), abs(f(place.after))), 1e-9 * (self.high - self.low)
        slope = abs(f(place.after + step) - f(place.before - step)) / (2.0 * step)
        wide = _ULPS * rounding / slope if 0.0 < rounding < 1e-12 * size and slope > 0.0 else 0.0
        before, after = (max(wide, _ULPS * ulp(t)) for t in (place.before, place.after))
        return place.before - before, place.after + after

    # --- pulses -----------------------------------------------------------------------------------------------

    def _around(self, centres: Sequence[float], f: Callable[[float], float]) -> list[Stop]:
        """Times around the centres at which f has short pulses or steps, and is quiet between them."""
        duration = self.high - self.low
        apart = list[float]()
        for centre in sorted(centres):
            if not apart or centre - apart[-1] > 1e-9 * duration:
                apart.append(centre)
        found: list[Stop] = []
        levels = [f(t) for t in (*self._times, *apart)]
        finite = [v for v in levels if isfinite(v)]
        height = max(finite) - min(finite) if finite else 0.0
        for k, centre in enumerate(apart):
            gap = min(
                centre - apart[k - 1] if k else duration,
                apart[k + 1] - centre if k + 1 < len(apart) else duration,
            )
            width = self._width(centre, f, height)
            if width * _ISOLATED < gap:
                times = (centre, *(centre + sign * part * width for part in _AROUND for sign in (-1.0, 1.0)))
                found += [(t, t) for t in times]
        return found

    def _width(self, centre: float, f: Callable[[float], float], height: float) -> float:
        """The distance from the centre at which f has changed by a good part of its height; infinite where it never does."""
        at = f(centre)
        for k in range(_HALVINGS, 0, -1):
            d = (self.high - self.low) * 2.0**-k
            left, right = f(centre - d), f(centre + d)
            if height > 0.0 and max(abs(right - 2.0 * at + left), abs(right - left)) >= 0.5 * height:
                return d
        return inf


def _may_be_short(kind: str, values: Sequence[float], power: int) -> bool:
    """Whether a function of an argument with these values may have pulses that are short beside the time between them."""
    finite = [v for v in values if isfinite(v)]
    if kind in CORNERS or not finite:
        return bool(finite)
    if kind == "exp" or kind in STEPS:
        return max(finite) - min(finite) > _FAR
    low, high = min(map(abs, finite)), max(map(abs, finite))
    return low < (0.1 if power <= 0 else exp(-_FAR / power)) * high


def _count_turns(values: Sequence[float]) -> int:
    """How often neighbouring values rise and then fall, or the other way round, beyond rounding."""
    least = 1e-13 * max((abs(v) for v in values if isfinite(v)), default=0.0)
    steps = [b - a for a, b in pairwise(values)]
    return sum(a * b < 0.0 and min(abs(a), abs(b)) > least for a, b in pairwise(steps))


def _sign(x: float) -> int:
    return (x > 0.0) - (x < 0.0)
