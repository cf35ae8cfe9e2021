"""Times at which a run has to look: corners and short pulses of what depends on time alone.

Adaptive steps see a force by its values at their stages.  A system at rest takes steps as long as its scene, and a pulse of a
tenth of a second lies between the stages: the estimate of the error knows nothing of it.  Each function of time in the spec
has its special places where its argument is zero or turns: there ``sign`` jumps, ``max`` has a corner, ``exp(-((t - a)/w)^2)`` its
peak.  The argument is a slow function of time also where the pulse is short, so that a grid finds them.

Not found: pulses of functions that depend on the state, too, and what turns more often than the grid can tell (there, no step
is long).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from itertools import pairwise
from math import inf, isfinite, nan

from nhc.algebra.calculus import reachable
from nhc.algebra.evaluate import evaluate_into
from nhc.algebra.graph import POW, Graph, Node
from nhc.mechanics.system import System
from nhc.records import record

Stop = tuple[float, float]
"""The last time before a jump and the first after it; the same time twice where there is none."""

GRID = 1024
_MOST = GRID // 4  # special places of one function: more are not told apart reliably
_CORNERS = frozenset({"sign", "abs", "min", "max", "atan2"})
_PEAKS = frozenset({"exp", "sqrt", "powf", "log", POW})
_STEPS = frozenset({"tanh", "atan"})
_HALVINGS, _SECTIONS, _BISECTIONS = 50, 60, 100
_CHANGES = 4  # of a sign between two places of the grid: by way of zero there are two, beyond them is rounding
_AROUND = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)  # widths from a pulse's middle at which a step ends
_ISOLATED = 8.0  # widths to the next pulse beyond which the time between them is quiet


def find_stops(system: System, p: Sequence[float], time: tuple[float, float]) -> tuple[Stop, ...]:
    """The times between the start and the end of a scene, in their order, at which a step has to end.

    ``p``: values of the parameters in the spec's order.
    """
    graph = system.graph
    roots = [system.T, system.U, *system.Q]
    for form in (*system.constraints, *system.quasi):
        roots += [*form.coefficients, form.constant, *([form.equation] if form.equation is not None else [])]
    clock = graph.deps[system.t]
    if not any(graph.deps[root] & clock for root in roots):
        return ()
    known = clock | graph.mask(system.p)
    alone = [node for node in reachable(graph, roots, clock) if not graph.deps[node] & ~known]
    low, high = time
    search = _Search(graph, system.t, dict(zip(system.p, p, strict=True)), low, high)
    found: list[Stop] = []
    for node in alone:
        found += search.list_stops(node)
    return tuple(_join(stop for stop in found if low < stop[0] and stop[1] < high))


@record
class _Place:
    """A special place of a function: between two times with nothing but it between them."""

    before: float
    after: float

    @property
    def middle(self) -> float:
        return 0.5 * (self.before + self.after)


class _Search:
    """Functions of time between two times."""

    def __init__(self, graph: Graph, t: Node, values: Mapping[Node, float], low: float, high: float) -> None:
        self.graph, self._t, self._values = graph, t, values
        self.low, self.high = low, high
        self._times = [low + (high - low) * k / GRID for k in range(GRID + 1)]

    def list_stops(self, node: Node) -> list[Stop]:
        """Where a step has to end for the sake of one node, not of its operands."""
        kind = self.graph.op[node]
        if kind in _CORNERS:
            zeros, _ = self._special(self._argument(node))
            return [(place.before, place.after) for place in zeros]
        if kind in _STEPS or (kind in _PEAKS and (kind != POW or self.graph.b[node] < 0)):
            zeros, turns = self._special(self._argument(node))
            places = (*zeros, *turns) if kind in _STEPS else turns
            return self._around([place.middle for place in places], self._function(node))
        return []

    # --- functions of time ----------------------------------------------------------------------------------

    def _function(self, node: Node) -> Callable[[float], float]:
        order = reachable(self.graph, [node])

        def value(t: float) -> float:
            known = {self._t: t, **self._values}
            try:
                evaluate_into(known, self.graph, order)
            except (ArithmeticError, ValueError):
                return nan
            return float(known[node])

        return lru_cache(maxsize=2 * GRID)(value)

    def _argument(self, node: Node) -> Callable[[float], float]:
        """What decides where a function is special: its operand, of two that are compared their difference."""
        first = self._function(self.graph.a[node])
        if self.graph.op[node] not in ("min", "max"):
            return first
        second = self._function(self.graph.b[node])
        return lambda t: first(t) - second(t)

    # --- special places ---------------------------------------------------------------------------------------

    def _special(self, f: Callable[[float], float]) -> tuple[list[_Place], list[_Place]]:
        """Where f changes its sign, and where it turns; nothing where there is too much of it."""
        times, values = self._times, [f(t) for t in self._times]
        size = max((abs(v) for v in values if isfinite(v)), default=0.0)
        turns, marks = list[_Place](), [(times[0], values[0])]
        for k in range(1, GRID + 1):
            if k < GRID:
                rise, fall = values[k] - values[k - 1], values[k + 1] - values[k]
                if rise * fall < 0.0 and min(abs(rise), abs(fall)) > 1e-13 * size:
                    t = self._turn(f, times[k - 1], times[k + 1], -1.0 if rise > 0.0 else 1.0)
                    turns.append(_Place(t, t))
                    marks.append((t, f(t)))
            marks.append((times[k], values[k]))
        marks.sort()
        zeros = list[_Place]()
        for (a, u), (b, v) in pairwise(marks):
            zeros += self._change(f, a, b, _sign(u), _sign(v))
        return (zeros, turns) if len(zeros) + len(turns) <= _MOST else ([], [])

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


def _sign(x: float) -> int:
    return (x > 0.0) - (x < 0.0)


def _join(stops: Iterable[Stop]) -> list[Stop]:
    """In their order; those that touch are one."""
    joined: list[Stop] = []
    for before, after in sorted(stops):
        if joined and before <= joined[-1][1]:
            joined[-1] = (joined[-1][0], max(after, joined[-1][1]))
        else:
            joined.append((before, after))
    return joined
