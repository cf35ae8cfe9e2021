"""Whether a function of the state jumps: has two finite limits, one at each side of a surface that motions cross.

Elementary functions can do so only where a sign changes, on the branch cut of an angle of a pair, and where something is divided by
zero: ``x/abs(x)``, ``atan(1/x)``.  These places are looked for in doubles along random lines through the state space, which any
surface of one dimension less is met by; what has less dimensions (the centre that a body is drawn to) is met by none of them, and
by no ordinary motion.

At such a place only those terms of a sum can jump that break there, alone or together, and the others need no look: a sum of n
fractions with a place each takes time proportional to n.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from operator import add, mul
from types import MappingProxyType
from typing import Any

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.evaluate import Floats, apply_function, evaluate, evaluate_into
from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.walks import reachable
from nhc.records import record

_LINES = 6
_CENTRAL = (4, 5)  # those through the origin, where small closed surfaces lie
_GRID = 120  # places on each, even so that the middle is one of them
_NEAR = tuple(math.tan(math.pi * (k / _GRID - 0.5)) for k in range(1, _GRID))
_FAR = tuple(sorted(sign * 10.0 ** (k / 4) for sign in (-1, 1) for k in range(4, 49)))
"""Places from 10 to 10^12 at both sides, on two lines more, where no zero was met on the others."""
_MOST = 12  # zeros that are looked at on a line
_HALVINGS = 80
_SECANTS = 20
_EARLY, _EARLY_SIZE = 25, 0.1  # the width is 4e-6 of the first one then, and its root 2e-3
_GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
_ASIDE = (1e-7, 3e-8, 1e-8)  # how far from the surface both sides are compared
_FLAT = 0.1  # what the distance of both sides may change by between these, relative
_SMALL = 1e-9
_MOST_WORK = 5_000_000  # nodes that are evaluated

_TOGETHER = 1e-6  # how far apart breaks are that are looked at together, in the same measure

Value = Callable[[float], float]


@record
class Term:
    """A sign and factors of which the first ones break nowhere; the last one breaks where one of ``breaks`` vanishes."""

    sign: int
    factors: tuple[Node, ...]
    breaks: frozenset[Node]


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
        for k, inner in enumerate(_broken_at(graph, node)):
            found[inner] = found.get(inner, False) or (graph.op[node] in ("sign", "atan2") and k == 0)
    return [(node, hard) for node, hard in found.items() if graph.depends(node, moving)]


def _broken_at(graph: Graph, node: Node) -> tuple[Node, ...]:
    """At the zeros of which the operation itself may jump."""
    op = graph.op[node]
    if op == "atan2":
        return graph.kids[node]
    return (graph.a[node],) if op in ("sign", "log", "powf") or (op == POW and graph.b[node] < 0) else ()


def _list_terms(graph: Graph, root: Node, breaks: Collection[Node]) -> list[Term]:
    """The root without the terms that break nowhere: sums behind factors that do not break are taken apart.

    It stays one term where that would take more of them than it has parts: sums that stand in many places.
    """
    order, kids, op = reachable(graph, [root]), graph.kids, graph.op
    rough = set[Node]()
    for node in order:
        if any(kid in rough for kid in kids[node]) or any(a in breaks for a in _broken_at(graph, node)):
            rough.add(node)
    found, stack, work = list[Term](), [(root, 1, tuple[Node, ...]())], 0
    while stack:
        node, sign, factors = stack.pop()
        work += 1
        if work > len(order):
            return [Term(1, (root,), frozenset(breaks))]
        hot = [kid for kid in kids[node] if kid in rough]
        if op[node] == ADD:
            stack += [(kid, sign, factors) for kid in hot]
        elif op[node] == NEG:
            stack += [(kid, -sign, factors) for kid in hot]
        elif op[node] == MUL and len(hot) == 1:
            stack.append((hot[0], sign, (*factors, *(kid for kid in kids[node] if kid not in rough))))
        elif node in rough:
            inner = reachable(graph, [node])
            own = frozenset(a for part in inner for a in _broken_at(graph, part) if a in breaks)
            found.append(Term(sign, (*factors, node), own))
    return found


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
    breaks = {
        node: hard
        for node, hard in find_breaks(graph, [root], graph.mask(moving))
        if not cannot_vanish(graph, node, {symbol: (value, value) for symbol, value in known.items()} | dict(ranges))
    }
    lines, terms = _Lines(graph, moving, known, ranges), _list_terms(graph, root, breaks)
    rng, unmet = random.Random(17), dict(breaks)
    for line in range(_LINES + 2):
        looked = list(breaks if line < _LINES else unmet)
        if not looked:
            break
        lines.turn(rng, 1e-9 if line in _CENTRAL else 1.0)
        for place, near in _meet(lines, looked, _NEAR if line < _LINES else _FAR):
            unmet = {node: hard for node, hard in unmet.items() if node not in near}
            own = [term for term in terms if not near.isdisjoint(term.breaks)]
            if _differs(lines.along(own), place) and not all(map(keeps, near)):
                return True
    return any(hard and not keeps(node) for node, hard in unmet.items())  # nowhere near: nothing is known of its sign


class _Lines:
    """Values along a line through the state space, as many as there is time for; folded into the ranges."""

    def __init__(
        self, graph: Graph, moving: Sequence[Node], known: Mapping[Node, float], ranges: Mapping[Node, Interval]
    ) -> None:
        self.graph, self._moving, self._known, self._ranges = graph, moving, known, ranges
        self._orders: dict[tuple[Node, ...], list[Node]] = {}
        self._left = _MOST_WORK
        self._way: dict[Node, tuple[float, float]] = {}

    def turn(self, rng: random.Random, size: float) -> None:
        """Another line, which starts at about this distance from the origin."""
        base = [rng.gauss(0.0, 1.0) * size for _ in self._moving]
        self._way = {symbol: (b, rng.gauss(0.0, 1.0)) for symbol, b in zip(self._moving, base, strict=True)}

    def many(self, node: Node, places: Sequence[float]) -> list[float]:
        """The node at many places on this line: operation by operation, or place by place where it has no value at some."""
        order, graph = self._order((node,)), self.graph
        rows: dict[Node, list[float]] = {}
        self._spend(len(order) * len(places))
        try:
            for n in order:
                op, kids = graph.op[n], graph.kids[n]
                if n in self._way:
                    base, slope = self._way[n]
                    row = [base + s * slope for s in places]
                    if n in self._ranges:
                        row = [self._fold(n, x) for x in row]
                elif op == ADD:
                    row = list(map(add, rows[kids[0]], rows[kids[1]]))
                elif op == MUL:
                    row = list(map(mul, rows[kids[0]], rows[kids[1]]))
                elif op == POW:
                    exponent = graph.b[n]
                    row = [x**exponent for x in rows[kids[0]]]
                elif op == NEG:
                    row = [-x for x in rows[kids[0]]]
                elif not kids:
                    row = evaluate(graph, [n], self._known, _Saturated, [n]) * len(places)
                else:
                    row = [
                        apply_function(_Saturated, op, *values)
                        for values in zip(*(rows[kid] for kid in kids), strict=True)
                    ]
                rows[n] = row
        except (ArithmeticError, ValueError):
            return list(map(self.along([Term(1, (node,), frozenset())]), places))
        return [float(x) for x in rows[node]]

    def _fold(self, symbol: Node, x: float) -> float:
        low, high = self._ranges[symbol]
        return low + (high - low) * 0.5 * (1.0 + math.sin(x))

    def _spend(self, work: int) -> None:
        self._left -= work
        if self._left < 0:
            raise TooLong

    def _order(self, nodes: tuple[Node, ...]) -> list[Node]:
        order = self._orders.get(nodes)
        if order is None:
            order = self._orders[nodes] = reachable(self.graph, nodes)
        return order

    def along(self, terms: Sequence[Term]) -> Value:
        """The sum of the terms on this line, NaN where it has no value."""
        order = self._order(tuple(node for term in terms for node in term.factors))
        way = {node: self._way[node] for node in order if node in self._way}
        fixed = {node: self._known[node] for node in order if node in self._known}

        def value(s: float) -> float:
            self._spend(len(order))
            found = dict(fixed)
            for symbol, (base, slope) in way.items():
                x = base + s * slope
                found[symbol] = self._fold(symbol, x) if symbol in self._ranges else x
            try:
                evaluate_into(found, self.graph, order, _Saturated)
                return float(sum(t.sign * math.prod([found[f] for f in t.factors]) for t in terms))
            except (ArithmeticError, ValueError):
                return math.nan

        return value


def _meet(lines: _Lines, breaks: Iterable[Node], places: Sequence[float]) -> Iterator[tuple[float, set[Node]]]:
    """Where a line meets zeros of the breaks, and which of them vanish there, or might: those with more than are looked at."""
    met, often = list[tuple[float, Node]](), set[Node]()
    for node in breaks:
        value = lines.along([Term(1, (node,), frozenset())])
        zeros = list(_zeros(value, places, lines.many(node, places)))
        met += [(place, node) for place in zeros]
        if len(zeros) == _MOST:
            often.add(node)
    met.sort()
    first = last = 0
    for place, _ in met:
        reach = _TOGETHER * (1.0 + abs(place))
        while met[first][0] < place - reach:
            first += 1
        while last < len(met) and met[last][0] <= place + reach:
            last += 1
        yield place, {node for _, node in met[first:last]} | often


def _zeros(value: Value, places: Sequence[float], heights: Sequence[float]) -> Iterator[float]:
    """Where the value changes its sign, or touches zero, between neighbouring places; the first ones from one end of the line."""
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
    """By the Illinois rule, which meets the zero of a smooth function in few steps, and by halves where it takes more."""
    low, high = value(left), value(right)
    for step in range(_HALVINGS):
        middle = 0.5 * (left + right)
        if step < _SECANTS and math.isfinite(low) and math.isfinite(high):
            chosen = (left * high - right * low) / (high - low)
            middle = chosen if left < chosen < right else middle
        if middle in (left, right):
            break
        height = value(middle)
        if height == 0.0:
            return middle
        if height * low > 0.0:
            left, low, high = middle, height, high * 0.5
        else:
            right, high, low = middle, height, low * 0.5
    return 0.5 * (left + right)


def _touch(value: Value, left: float, right: float, height: float) -> float | None:
    """Where the size of the value comes down to zero between two places, by golden sections; None where it does not.

    What is to be as small as that at the end falls with a power of the distance above 1/2: it is small early.
    """
    low, high = right - _GOLDEN * (right - left), left + _GOLDEN * (right - left)
    at_low, at_high = abs(value(low)), abs(value(high))
    for step in range(_HALVINGS):
        if at_low < at_high:
            right, high, at_high = high, low, at_low
            low = right - _GOLDEN * (right - left)
            at_low = abs(value(low))
        else:
            left, low, at_low = low, high, at_high
            high = left + _GOLDEN * (right - left)
            at_high = abs(value(high))
        if step == _EARLY and min(at_low, at_high) > _EARLY_SIZE * height:
            return None
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
