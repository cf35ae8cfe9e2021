"""What the rates of a state depend on, exactly: by values in a prime field, so that a dependence that cancels does not count.

One entry of the state is given another value at a random point; what changes depends on it.  Values and not slopes are compared,
because a sign depends on its argument although its slope is zero.  Where signs occur, also in the guise of roots, it is done at
more points: a sign stays the same at every second change, and others may hide it at every second point.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property

from nhc.algebra.exact.modular import FieldPoint, Unlucky
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.signs import Signs, may_hold, points_for
from nhc.algebra.graph import Node
from nhc.algebra.walks import reachable
from nhc.mechanics.flow import Flow, solve_at
from nhc.records import record

_POINTS, _DRAWS, _CHANGES = 2, 400, 60
_MOST_SIGNS = 4  # multiplied with each other: 384 points


@record
class Dependence:
    """``rates[j]`` are the entries of the state that y'_j depends on, ``needs[k]`` those of the k-th further quantity.

    ``still[j]``: y'_j vanishes identically, y_j is a constant of the motion; ``zero[k]`` likewise for the quantities.
    """

    rates: tuple[frozenset[int], ...]
    needs: tuple[frozenset[int], ...]
    still: tuple[bool, ...]
    zero: tuple[bool, ...]

    def closure(self, needs: Sequence[int]) -> frozenset[int]:
        """The entries that the given quantities depend on, directly or through the rates of other entries."""
        found = {j for k in needs for j in self.needs[k]}
        todo = sorted(found)
        while todo:
            new = self.rates[todo.pop()] - found
            found |= new
            todo += sorted(new)
        return frozenset(found)


def find_vanishing(flow: Flow, needs: Sequence[Node]) -> list[bool]:
    """Which rates of the state, and then which of the needs, vanish identically; wrong as seldom as :func:`find_dependence`.

    The needs are functions of the state, the rates and the multipliers.

    Raises:
        Unlucky: the motion is singular everywhere, or holds too many signs.
    """
    whole, primes = _Evaluation(flow, needs), primes_of(flow.graph)
    zero, seed = [True] * (len(flow.y) + len(needs)), 0
    for index in range(_count_points(flow, needs)):
        _, values, seed = _base(whole, seed, primes[index % len(primes)])
        zero = [z and not value for z, value in zip(zero, values, strict=True)]
    return zero


def find_dependence(flow: Flow, needs: Sequence[Node]) -> Dependence:
    """Which entries of the state each rate and each need depends on.

    Missed with a probability of degree/p**2, and of e**-24 where signs occur.

    Raises:
        Unlucky: the motion is singular everywhere, or holds too many signs.
    """
    g, roots = flow.graph, _roots(flow, needs)
    occurring = [j for j, y in enumerate(flow.y) if any(g.depends(node, g.deps[y]) for node in roots)]
    changes = {j: _Change(flow, needs, j) for j in occurring}
    every = range(len(flow.y) + len(needs))
    found, planned = _Findings(len(flow.y), len(every)), frozenset(reachable(g, roots))
    evaluations: dict[tuple[int, ...], _Evaluation] = {}
    seed, primes = 0, primes_of(g)
    for index in range(_count_points(flow, needs)):
        asked = tuple(every) if index < _POINTS else found.list_asked(changes)
        if not asked:
            break
        if asked not in evaluations:
            evaluations[asked] = _Evaluation(flow, needs, None, asked)
        base, values, seed = _base(evaluations[asked], seed, primes[index % len(primes)])
        known = dict(zip(asked, values, strict=True))
        found.note_values(known)
        others = base.values.keys() - planned  # what the point needed besides: factors of arguments in canonical form
        for j, change in changes.items():
            left = found.list_open(j, change.open)
            if left or j not in found.compared:
                changed = change.compare(base, others, random.Random(1_000_003 * seed + j), known, left)
                found.note_changes(j, changed)
            for crossed in change.cross(base, others) if index < _POINTS else ():
                other = dict(zip(every, crossed, strict=True))
                found.note_values(other)
                found.note_changes(j, {k: other[k] != known[k] for k in every}, compared=False)
    return found.conclude(changes)


class _Findings:
    """What has been seen so far at points: ``depends[k][j]``, that row k (a rate or need) depends on entry j of the state."""

    def __init__(self, size: int, rows: int) -> None:
        self.size = size
        self.depends = [[False] * size for _ in range(rows)]
        self.zero = [True] * rows  # as far as has been seen
        self.compared: set[int] = set()  # entries for which another regular value was found

    def note_values(self, values: Mapping[int, int]) -> None:
        """The rates and needs at a point: what has a value is not zero."""
        for k, value in values.items():
            self.zero[k] = self.zero[k] and not value

    def note_changes(self, j: int, changed: Mapping[int, bool] | None, compared: bool = True) -> None:
        """Which rows changed with entry j; None where no other regular value was found."""
        if changed is None:
            return
        if compared:
            self.compared.add(j)
        for k, differs in changed.items():
            self.depends[k][j] = self.depends[k][j] or differs

    def list_open(self, j: int, rows: Sequence[int]) -> tuple[int, ...]:
        """Of the rows that may depend on entry j those that are not known to."""
        return tuple(k for k in rows if not self.depends[k][j])

    def list_asked(self, changes: Mapping[int, _Change]) -> tuple[int, ...]:
        """The rows of which another point may tell more: all where an entry has not been compared yet."""
        if not changes.keys() <= self.compared:
            return tuple(range(len(self.zero)))
        zero = {k for k, zero in enumerate(self.zero) if zero}
        return tuple(sorted(zero.union(*(self.list_open(j, change.open) for j, change in changes.items()))))

    def conclude(self, changes: Iterable[int]) -> Dependence:
        """``changes`` are the entries that occur; one for which no other regular value was found may matter anywhere."""
        for j in set(changes) - self.compared:
            for row in self.depends:
                row[j] = True
        sets = [frozenset(j for j, found in enumerate(row) if found) for row in self.depends]
        size, zero = self.size, tuple(self.zero)
        return Dependence(tuple(sets[:size]), tuple(sets[size:]), zero[:size], zero[size:])


def _count_points(flow: Flow, needs: Sequence[Node]) -> int:
    g, roots = flow.graph, _roots(flow, needs)
    if not may_hold(g, roots):
        return _POINTS
    signs = Signs(g, roots, later=g.mask(flow.unknowns), changed=flow.y)
    signs.solve([x for row in flow.matrix for x in row], flow.right, flow.unknowns)
    degree = signs.degree([*flow.velocities, *flow.unknowns, *needs])
    if degree > _MOST_SIGNS:
        raise Unlucky
    return points_for(degree, _POINTS)


def _roots(flow: Flow, needs: Sequence[Node]) -> list[Node]:
    return [*flow.velocities, *needs, *flow.flat]


def _rows(flow: Flow, needs: Sequence[Node]) -> list[Node]:
    """The rates of the state, and then the needs."""
    return [*flow.velocities, *flow.unknowns[: flow.kept], *needs]


class _Evaluation:
    """The order in which all rates and needs are evaluated at a point, or what of them depends on a symbol with a given value.

    ``rows``: those that are asked for; the accelerations are solved for only where one of these needs them.
    """

    def __init__(
        self, flow: Flow, needs: Sequence[Node], changed: Node | None = None, rows: Sequence[int] | None = None
    ) -> None:
        g, within = flow.graph, -1 if changed is None else flow.graph.deps[changed]
        every = _rows(flow, needs)
        self.flow, self.results = flow, every if rows is None else [every[k] for k in rows]
        unknown = g.mask(flow.unknowns)
        self._solves = rows is None or any(g.deps[node] & unknown for node in self.results)
        given = {*flow.unknowns, changed}
        self._before = [n for n in reachable(g, flow.flat, within) if n not in given] if self._solves else []
        given.update(self._before)
        moved = within if within == -1 else within | unknown
        self._after = [node for node in reachable(g, self.results, moved) if node not in given]

    @cached_property
    def announced(self) -> FieldPoint:
        """A point to which everything has been announced."""
        point = FieldPoint(self.flow.graph, 0)
        point.prepare([*self.flow.flat, *self.results])
        return point

    def values_at(self, point: FieldPoint) -> list[int]:
        """Residues of the rows, all rates of the state and then the needs; everything else has its value at the point.

        Raises:
            Unlucky: the motion is singular at this point.
        """
        flow = self.flow
        if self._solves:
            point.fill(self._before)
            solved = solve_at(len(flow.unknowns), [point.values[node] for node in flow.flat], point.prime)
            point.values.update(zip(flow.unknowns, solved, strict=True))
        point.fill(self._after)
        return [point.values[node] for node in self.results]


def _base(whole: _Evaluation, seed: int, prime: int) -> tuple[FieldPoint, list[int], int]:
    for draw in range(seed + 1, seed + 1 + _DRAWS):
        point = FieldPoint(whole.flow.graph, 3_000_017 + draw, prime)
        point.prepare_like(whole.announced)
        try:
            return point, whole.values_at(point), draw
        except Unlucky:
            continue
    raise Unlucky


class _Change:
    """Another value for one entry of the state; ``open`` are the rates and needs that may depend on it."""

    def __init__(self, flow: Flow, needs: Sequence[Node], j: int) -> None:
        g, self._entry = flow.graph, flow.y[j]
        self._flow, self._needs = flow, needs
        self._mask = g.mask((self._entry, *flow.unknowns))
        moves = any(g.deps[node] & g.deps[self._entry] for node in flow.flat)
        mask = self._mask if moves else g.deps[self._entry]
        self.open = [k for k, node in enumerate(_rows(flow, needs)) if g.deps[node] & mask]
        self._narrow: dict[tuple[int, ...], _Evaluation] = {}
        held = reachable(g, _roots(flow, needs), g.deps[self._entry])
        free = [g.a[node] for node in held if g.op[node] == "sign" and not g.deps[node] & g.mask(flow.unknowns)]
        self.signs = [(x, reachable(g, [x], g.deps[self._entry])) for x in dict.fromkeys(free)]
        """Arguments of signs, each with what it is made of and depends on the entry."""

    @cached_property
    def _dependent(self) -> _Evaluation:
        """All rows; only where the entry stands below a sign."""
        return _Evaluation(self._flow, self._needs, self._entry)

    def compare(
        self,
        base: FieldPoint,
        others: Iterable[Node],
        rng: random.Random,
        values: Mapping[int, int],
        rows: tuple[int, ...],
    ) -> dict[int, bool] | None:
        """Which of the rows has another value than the given ones at the base; None where no other regular value is found.

        ``others``: nodes with a value at the base that are no part of the rates and needs.
        """
        deps = base.graph.deps
        stale = [node for node in others if deps[node] & self._mask]
        if rows not in self._narrow:
            self._narrow[rows] = _Evaluation(self._flow, self._needs, self._entry, rows)
        for _ in range(_CHANGES):
            point = base.beside(stale)
            point.values[self._entry] = rng.randrange(2, base.prime - 1)
            try:
                found = self._narrow[rows].values_at(point)
            except Unlucky:
                continue
            return {k: x != values[k] for k, x in zip(rows, found, strict=True)}
        return None

    def cross(self, base: FieldPoint, others: Iterable[Node]) -> Iterator[list[int]]:
        """All rates and needs where the entry has a value for which the argument of a sign is zero, and its sign with it."""
        deps, p = base.graph.deps, base.prime
        stale = [node for node in others if deps[node] & self._mask]
        for argument, nodes in self.signs:
            point = base.beside(stale)
            x, y = point.values[self._entry], point.values[argument]
            try:
                slope = (self._fill(point, nodes, argument, x + 1) - y) % p
                if not slope or self._fill(point, nodes, argument, x - y * pow(slope, -1, p)):
                    continue  # it is not linear in the entry
                yield self._dependent.values_at(point)
            except Unlucky:
                continue

    def _fill(self, point: FieldPoint, nodes: Sequence[Node], argument: Node, value: int) -> int:
        """An argument's value where the entry has another one."""
        point.values[self._entry] = value % point.prime
        point.fill(node for node in nodes if node != self._entry)
        return point.values[argument]
