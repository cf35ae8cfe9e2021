"""What a motion passes faster than its steps can see: a bump in the road, a thin wall, a collision far away.

Between two places where nothing happens the steps of a motion become long, and what lies between their stages is not there
for them, whatever the tolerance.  The motion found in this way tells where the special places of the spec's functions
(:mod:`nhc.program.clock`) lie on it; a second one, whose steps end there, is another motion if something was passed over.
Then that one is looked at in the same way.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from math import inf, nan

from nhc.algebra.calculus import reachable
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.program.clock import Search, is_corner, join_stops, list_special
from nhc.program.ir import Stop
from nhc.simulate.prepare import Job
from nhc.simulate.task import STOPPED, TOO_MANY, Outcome, Task

ROWS = 256
MOST = 4096  # steps: with more of them none is long beside the scene
_TURNS = 6
_CLOSE = 1.0 / 32  # of the time: corners that are further apart are seen without stops
_SAME, _TOLD = 1e3, 1e5  # tolerances: beyond the first the stops stay
_AT_ONCE = 4  # rows from the one to the other where something was passed over; the errors of corners add up slowly


def watch_passing(job: Job, task: Task, integrate: Callable[[Task], Outcome]) -> tuple[tuple[Stop, ...], str]:
    """(stops of the task, with those along its motion that change it; what was passed over, or nothing).

    Raises:
        KeyboardInterrupt: it was stopped.
    """
    system, deps = job.system, job.system.graph.deps
    moving = (*job.symbols, *(system.v if job.kept is not None else ()))
    outside = ~system.graph.mask((*moving, *system.p, system.t))
    special = [node for node in list_special(system, moving) if not deps[node] & outside]
    if not special:
        return tuple(task.stops), ""
    start, end = task.times[0], task.times[-1]
    times = (*(start + (end - start) * k / ROWS for k in range(ROWS)), end)
    scout = replace(task, times=times, most=min(task.most, MOST))
    found, first = integrate(scout), inf
    for _ in range(_TURNS):
        if found.kind == STOPPED:
            raise KeyboardInterrupt
        if found.kind == TOO_MANY or len(found.states) < 8:
            break
        stops = join_stops((*scout.stops, *_list_stops(job, special, times, found.states)))
        if len(stops) == len(scout.stops):
            break
        scout = replace(scout, stops=stops)
        other = integrate(scout)
        near, far = (_find_parting(found.states, other.states, part * task.tolerance) for part in (_SAME, _TOLD))
        if near is None:
            break
        if far is not None and far - near <= _AT_ONCE:
            first = min(first, times[near])
        task, found = replace(task, stops=stops), other
    if first == inf:
        return tuple(task.stops), ""
    return tuple(
        task.stops
    ), f"at t = {first:.6g} the motion passes what its own steps would leap over: steps end there"


def _list_stops(
    job: Job, special: Sequence[Node], times: Sequence[float], states: Sequence[Sequence[float]]
) -> list[Stop]:
    """Where steps have to end along a motion: at narrow peaks, and at corners that are close to one another."""
    path = _Path(job, special, times, states)
    low, high = times[0], times[len(states) - 1]
    search, found = Search(job.system.graph, path.place, low, high, len(states) - 1), list[Stop]()
    corners = list[Stop]()
    for node in special:
        stops = search.list_stops(node)
        (corners if is_corner(job.system.graph, node) else found).extend(stops)
    corners.sort()
    near = _CLOSE * (high - low)
    for k, stop in enumerate(corners):
        if (k and stop[0] - corners[k - 1][1] < near) or (k + 1 < len(corners) and corners[k + 1][0] - stop[1] < near):
            found.append(stop)
    return found


class _Path:
    """A motion between its rows: cubic polynomials through four of them."""

    def __init__(
        self, job: Job, special: Sequence[Node], times: Sequence[float], states: Sequence[Sequence[float]]
    ) -> None:
        self.job, self.times, self.states = job, times[: len(states)], states
        self.place: Callable[[float], Mapping[Node, float]] = lru_cache(maxsize=4 * ROWS)(self._place)
        system, recipe = job.system, job.recipe
        self._fixed = dict(zip(system.p, job.p, strict=False))
        with_rates = any(system.graph.deps[node] & system.graph.mask(system.v) for node in special)
        self._velocities = recipe.equations.motion.velocities if with_rates and recipe is not None else ()
        self._order = reachable(system.graph, self._velocities)

    def _place(self, t: float) -> Mapping[Node, float]:
        """Values of time, parameters, the state and, where they are asked for, velocities; NaN for those that have none."""
        system, values = self.job.system, {self.job.system.t: t, **self._fixed}
        values |= zip(self.job.symbols, self._state(t), strict=True)
        if self._velocities:
            try:
                v = evaluate(system.graph, self._velocities, values, order=self._order)
            except (ArithmeticError, ValueError):
                v = [nan] * len(system.v)
            values |= zip(system.v, v, strict=True)
        return values

    def _state(self, t: float) -> Sequence[float]:
        times = self.times
        at = bisect_left(times, t)
        if at < len(times) and times[at] == t:
            return self.states[at]
        k = min(max(bisect_right(times, t) - 2, 0), len(times) - 4)
        nodes = times[k : k + 4]
        weights = [1.0] * 4
        for i, a in enumerate(nodes):
            for j, b in enumerate(nodes):
                if i != j:
                    weights[i] *= (t - b) / (a - b)
        return [
            sum(w * x for w, x in zip(weights, column, strict=True))
            for column in zip(*self.states[k : k + 4], strict=True)
        ]


def _find_parting(one: Sequence[Sequence[float]], other: Sequence[Sequence[float]], bound: float) -> int | None:
    """The row at which two motions are no longer the same, by a part of each quantity's size; None where they are to the end."""
    sizes = [max(map(abs, column)) for column in zip(*one, strict=True)]
    least = 1e-9 * max(sizes, default=0.0)  # what is zero but for rounding
    for k, (a, b) in enumerate(zip(one, other, strict=False)):
        if any(abs(x - y) > bound * max(size, least) for x, y, size in zip(a, b, sizes, strict=True)):
            return k
    return None if len(one) == len(other) else min(len(one), len(other)) - 1
