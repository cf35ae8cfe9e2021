"""Whether a function of the state jumps: has two finite limits, one at each side of a surface that motions cross.

Elementary functions can do so only where a sign changes, on the branch cut of an angle of a pair, and where something is divided by
zero: ``x/abs(x)``, ``atan(1/x)``.  These places are looked for in doubles along random lines through the state space, which any
surface of one dimension less is met by; what has less dimensions (the centre that a body is drawn to) is met by none of them, and
by no ordinary motion.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import Any

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.calculus import reachable
from nhc.algebra.evaluate import Floats, evaluate
from nhc.algebra.graph import POW, Graph, Node

_LINES = 6
_CENTRAL = (4, 5)  # those through the origin, where small closed surfaces lie
_GRID = 120  # places on each, even so that the middle is one of them
_NEAR = tuple(math.tan(math.pi * (k / _GRID - 0.5)) for k in range(1, _GRID))
_FAR = tuple(sorted(sign * 10.0 ** (k / 4) for sign in (-1, 1) for k in range(4, 49)))
"""Places from 10 to 10^12 at both sides, on two lines more, where no zero was met on the others."""
_MOST = 12  # zeros that are looked at on a line
_HALVINGS = 80
_GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
_ASIDE = (1e-7, 3e-8, 1e-8)  # how far from the surface both sides are compared
_FLAT = 0.1  # what the distance of both sides may change by between these, relative
_SMALL = 1e-9
_MOST_WORK = 5_000_000  # nodes that are evaluated

Value = Callable[[float], float]


def _exp(x: float) -> float:
    return math.exp(x) if x < 709.0 else math.inf


class _Saturated(Floats):
    """Doubles whose exponentials are infinite where they are too large, so that what is divided by them is zero."""

    exp: Any = staticmethod(_exp)
    sinh: Any = staticmethod(lambda x: 0.5 * (_exp(x) - _exp(-x)))
    cosh: Any = staticmethod(lambda x: 0.5 * (_exp(x) + _exp(-x)))


def find_breaks(graph: Graph, roots: Sequence[Node], moving: int) -> list[tuple[Node, bool]]:
    """At the zeros of what the roots may jump; and whether something surely does there (a sign, a branch)."""
    found: dict[Node, bool] = {}
    for node in reachable(graph, roots, moving):
        op, a = graph.op[node], graph.a[node]
        if op in ("sign", "atan2"):
            found[a] = True
        elif op in ("log", "powf") or (op == POW and graph.b[node] < 0):
            found.setdefault(a, False)
        if op == "atan2":
            found.setdefault(graph.b[node], False)
    return [(node, hard) for node, hard in found.items() if graph.depends(node, moving)]


class TooLong(Exception):
    """Nothing was decided: the expression has more places where it may jump than can be looked at."""


def jumps(
    graph: Graph,
    root: Node,
    moving: Sequence[Node],
    known: Mapping[Node, float],
    keeps: Callable[[Node], bool],
    ranges: Mapping[Node, Interval] = MappingProxyType({}),
) -> bool:
    """Whether the root jumps where the symbols ``moving`` take it; all others have the values ``known``.

    ``keeps`` tells functions that do not change along a motion: what breaks at their zeros alone does not break.  Symbols with
    ``ranges`` go no further.

    Raises:
        TooLong: it was not decided.
    """
    breaks = [
        (node, hard)
        for node, hard in find_breaks(graph, [root], graph.mask(moving))
        if not cannot_vanish(graph, node, {symbol: (value, value) for symbol, value in known.items()} | dict(ranges))
    ]
    lines = _Lines(graph, moving, known, ranges)
    return any(_jumps_at(lines, root, node, hard) and not keeps(node) for node, hard in breaks)


def _jumps_at(lines: _Lines, root: Node, node: Node, hard: bool) -> bool:
    rng, met, moving = random.Random(17), False, lines.moving
    for line in range(_LINES + 2):
        if line >= _LINES and met:
            break
        base = [rng.gauss(0.0, 1.0) * (1e-9 if line in _CENTRAL else 1.0) for _ in moving]
        way = [rng.gauss(0.0, 1.0) for _ in moving]
        inner, outer = (lines.along(each, base, way) for each in (node, root))
        for place in _zeros(inner, _NEAR if line < _LINES else _FAR):
            met = True
            if _differs(outer, place):
                return True
    return hard and not met  # nowhere near: nothing is known of its sign


class _Lines:
    """Values of nodes along lines through the state space, as many as there is time for; folded into the ranges."""

    def __init__(
        self, graph: Graph, moving: Sequence[Node], known: Mapping[Node, float], ranges: Mapping[Node, Interval]
    ) -> None:
        self.graph, self.moving, self._known, self._ranges = graph, moving, known, ranges
        self._orders: dict[Node, list[Node]] = {}
        self._left = _MOST_WORK

    def along(self, root: Node, base: Sequence[float], way: Sequence[float]) -> Value:
        """The root on a line, NaN where it has no value."""
        order = self._orders.get(root)
        if order is None:
            order = self._orders[root] = reachable(self.graph, [root])

        def value(s: float) -> float:
            self._left -= len(order)
            if self._left < 0:
                raise TooLong
            place = {symbol: b + s * w for symbol, b, w in zip(self.moving, base, way, strict=True)}
            for symbol, (low, high) in self._ranges.items():
                place[symbol] = low + (high - low) * 0.5 * (1.0 + math.sin(place[symbol]))
            try:
                return float(evaluate(self.graph, [root], {**self._known, **place}, _Saturated, order)[0])
            except (ArithmeticError, ValueError):
                return math.nan

        return value


def _zeros(value: Value, places: Sequence[float]) -> Iterator[float]:
    """Where the value changes its sign, or touches zero, between neighbouring places; the first ones from one end of the line."""
    heights = [value(s) for s in places]
    count = 0
    for k, height in enumerate(heights):
        found = None
        if height == 0.0:
            found = places[k]
        elif k and height * heights[k - 1] < 0.0:
            found = _halve(value, places[k - 1], places[k])
        elif 0 < k < len(heights) - 1 and abs(height) < min(abs(heights[k - 1]), abs(heights[k + 1])):
            found = _touch(value, places[k - 1], places[k + 1], abs(height))
        if found is not None:
            yield found
            count += 1
            if count == _MOST:
                return


def _halve(value: Value, left: float, right: float) -> float:
    low = value(left)
    for _ in range(_HALVINGS):
        middle = 0.5 * (left + right)
        height = value(middle)
        if height == 0.0:
            return middle
        if height * low > 0.0:
            left = middle
        else:
            right = middle
    return 0.5 * (left + right)


def _touch(value: Value, left: float, right: float, height: float) -> float | None:
    """Where the size of the value comes down to zero between two places, by golden sections; None where it does not."""
    for _ in range(_HALVINGS):
        low, high = right - _GOLDEN * (right - left), left + _GOLDEN * (right - left)
        if abs(value(low)) < abs(value(high)):
            right = high
        else:
            left = low
    middle = 0.5 * (left + right)
    return middle if abs(value(middle)) < _SMALL * height else None


def _differs(value: Value, place: float) -> bool:
    """Whether both sides have limits that differ: their distance is the same on three scales, and they do not run away.

    On two scales it may be by chance: near a place where nothing has a limit (a quaternion of length zero) it rises and falls
    again.
    """
    sizes, distances = [], []
    for aside in _ASIDE:
        step = aside * (1.0 + abs(place))
        left, right = value(place - step), value(place + step)
        sizes.append(max(abs(left), abs(right)))
        distances.append(abs(right - left))
    if not all(map(math.isfinite, sizes + distances)):
        return False
    stays = max(distances) - min(distances) < _FLAT * max(distances) and distances[-1] > 1e-6 * sizes[-1]
    return stays and sizes[-1] < 2.0 * sizes[0]
