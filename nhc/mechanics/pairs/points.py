"""Whether two specs allow the same velocities and give the same accelerations, at random points of a prime field.

The state of the second system is drawn; the first system stands where q_1 = phi(q_2, t) puts it, and what only it has is random.
Its constraints must allow the velocities D phi q_2', as many as the second's allow; then its accelerations, solved modulo the
prime, must be the second time derivatives of phi.  Each system is taken by d'Alembert with multipliers, straight from its T
(I.4.1).  Where that holds at random values of what only one system has, it does not depend on them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular, null_space, rank_modulo, solve_modulo
from nhc.algebra.exact.degree import Degrees, Solved
from nhc.algebra.exact.draw import MOST_DRAWS, draw_points
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.signs import Signs, may_hold
from nhc.algebra.graph import Node
from nhc.mechanics.certificates.certificate import POINTS, count_points
from nhc.mechanics.formulate import rate_symbols
from nhc.mechanics.frame import total_derivative
from nhc.mechanics.pairs.laws import (
    Row,
    carry_laws,
    is_solvable,
    laws_of,
    products,
    refuse_closed,
    solution,
    values_of,
    with_nodes,
)
from nhc.mechanics.pairs.pairing import Pairing
from nhc.mechanics.pairs.roots import open_roots
from nhc.mechanics.properties.leaf import leaf_of
from nhc.records import record


@record
class Found:
    """What some points say, by coordinate of the first system: whether the accelerations are ``equal`` (empty: the velocities that
    are allowed differ).  ``violated`` are constraints of the first system, and of the second, that the other's motions break.

    ``freedom`` and ``places`` are how many of the common velocities are free, and in how many ways the common coordinates can
    be chosen, in either system; ``off`` names equations of the first system's positions that the second's positions break.
    """

    primes: tuple[int, ...]
    equal: tuple[bool, ...]
    violated: tuple[tuple[str, ...], tuple[str, ...]]
    freedom: tuple[int, int]
    places: tuple[int, int]
    off: tuple[str, ...]
    degree: int
    signs: int

    @property
    def same_velocities(self) -> bool:
        return not any(self.violated) and self.freedom[0] == self.freedom[1]

    @property
    def same_places(self) -> bool:
        """Whether the second's positions are among the first's; an equation that its constraints keep may choose among them."""
        return not self.off or self.places[0] < self.places[1]

    @property
    def agrees(self) -> bool:
        return self.same_velocities and self.same_places and all(self.equal)


class PairPoints:
    """Both systems on the second's graph, and the drawing of points.

    ``ranged`` are coordinates whose ranges tell the signs of roots, ``unsigned`` those of which a root is |r| for want of a range.
    """

    def __init__(self, pairing: Pairing) -> None:
        self.pairing = pairing
        first, second = pairing.first, pairing.second
        self.graph = g = second.graph
        self.common = pairing.common
        images = [node for _, node in pairing.images]
        self.rates = rate_symbols(second, second.v)
        self.slopes = [gradient(g, node, second.q) for node in images]
        self.motion = [total_derivative(second, node, second.v, {}) for node in images]
        moving = dict(zip(second.v, self.rates, strict=True))
        self.turning = [total_derivative(second, node, second.v, moving) for node in self.motion]
        extra = pairing.alone[0]
        self.own = tuple(g.symbol(first.q_names[i], "velocity") for i in extra)
        meaning = {first.t: second.t, **dict(pairing.parameters)}
        meaning.update((p, g.symbol(first.symbol_name(p), "parameter")) for p in first.p if p not in meaning)
        meaning.update((first.q[i], node) for i, node in pairing.images)
        meaning.update((first.v[i], node) for i, node in zip(self.common, self.motion, strict=True))
        meaning.update((first.q[i], g.symbol(first.q_names[i], "coordinate")) for i in extra)
        meaning.update((first.v[i], v) for i, v in zip(extra, self.own, strict=True))
        carried = carry_laws(laws_of(first), first.graph, g, meaning)
        own, size = laws_of(second), len(carried.nodes())
        opened, self.ranged, self.unsigned = open_roots(second, [*carried.nodes(), *own.nodes()])
        self.laws = with_nodes(carried, opened[:size]), with_nodes(own, opened[size:])
        refuse_closed(pairing, self.laws[0])
        self.told = self._told()
        self.leaf = leaf_of(second, self._all_nodes())
        self.on_leaf = bool(self.leaf.steps) or not second.spec.holonomic

    def _told(self) -> frozenset[str]:
        """Equations of the first spec's positions that are no equation of the second's: the others need no point to tell."""
        g, declared = self.graph, {entry.name for entry in self.pairing.first.spec.holonomic}
        known = self.laws[1].equations
        found = set[str]()
        for k, f in zip(self.laws[0].holonomic, self.laws[0].equations, strict=True):
            same = any(are_zero(g, [made])[0] for x in known for made in (g.sub(f, x), g.add(f, x)))
            if self.laws[0].names[k] in declared and not same:
                found.add(self.laws[0].names[k])
        return frozenset(found)

    def _all_nodes(self) -> list[Node]:
        slopes = [x for row in self.slopes for x in row]
        return [*self.laws[0].nodes(), *self.laws[1].nodes(), *self.motion, *self.turning, *slopes]

    # --- points -------------------------------------------------------------------------------------------

    def look(self, seed: int = 1) -> Found:
        """Compare at as many points as signs need.

        Raises:
            nhc.algebra.exact.modular.Unlucky: no point was found where both systems have a motion.
        """
        nodes = self._all_nodes()
        signs = self._count_signs(nodes)
        needed, primes = count_points(self.graph, nodes, signs, POINTS), primes_of(self.graph)
        seen = list[Found]()
        for k in range(needed):
            prime, begin = primes[k % len(primes)], (seed * 1009 + k) * 100_003
            seen.append(self._look_at(nodes, prime, range(begin, begin + MOST_DRAWS), signs))
            if k + 1 >= POINTS and not _joined(seen).agrees and not _joined(seen).equal:
                break
        return replace(_joined(seen), degree=self._degree(nodes))

    def _look_at(self, nodes: Sequence[Node], prime: int, seeds: range, signs: int) -> Found:
        moving = self.graph.mask((*self.pairing.second.v, *self.own, *self.rates))
        for _, point in draw_points(self.graph, nodes, prime, seeds, later=moving, settle=self.leaf.settling):
            try:
                return self._compare(point, signs)
            except (Unlucky, Singular):
                continue
        raise Unlucky

    def settle(self, point: FieldPoint) -> tuple[list[list[int]], list[str]]:
        """Give all velocities their values; the directions that the second system allows, and what of the first these break.

        Raises:
            Unlucky: there are none at this point.
        """
        first, second = self.laws
        p = point.prime
        symbols = self.pairing.second.v
        given = [point.evaluate(row) for row in second.rows]
        v, directions = solution(given, point.evaluate(symbols), p)
        point.evaluate([], dict(zip(symbols, v, strict=True)))
        w = point.evaluate(self.motion)
        rows = [point.evaluate(row) for row in first.rows]
        extra = self.pairing.alone[0]
        reduced = [
            [*(row[i] for i in extra), (sum(row[i] * x for i, x in zip(self.common, w, strict=True)) + row[-1]) % p]
            for row in rows
        ]
        broken, kept = list[str](), list[list[int]]()
        for name, row in zip(first.names, reduced, strict=True):
            if is_solvable([*kept, row], p):
                kept.append(row)
            else:
                broken.append(name)
        found, _ = solution(kept, point.evaluate(self.own), p)
        point.evaluate([], dict(zip(self.own, found, strict=True)))
        return directions, broken

    def _compare(self, point: FieldPoint, signs: int) -> Found:
        p, (first, second), pairing = point.prime, self.laws, self.pairing
        self.leaf.settle(point)
        directions, broken = self.settle(point)
        slopes = [point.evaluate(row) for row in self.slopes]
        rows = [[point.evaluate(row)[:-1] for row in laws.rows] for laws in self.laws]
        off = [first.names[k] for k, f in zip(first.holonomic, first.equations, strict=True) if point.evaluate([f])[0]]
        off = [name for name in off if name in self.told]
        held = [
            [row for k, row in enumerate(rows[i]) if k in laws.holonomic and self._counts(i, k, point)]
            for i, laws in enumerate(self.laws)
        ]
        free = self._dimension(rows[0], p), rank_modulo(products(slopes, directions, p), p)
        wide = null_space(held[1], pairing.second.n, p)
        places = self._dimension(held[0], p), rank_modulo(products(slopes, wide, p), p)
        lacking = self._break_second(point, rows[0], free) if free[0] > free[1] else ()
        if broken or free[0] != free[1]:
            return Found((p,), (), (tuple(broken), lacking), free, places, tuple(off), 0, signs)
        x = solve_modulo(*values_of(point, second), p)
        point.evaluate([], dict(zip(self.rates, x[: pairing.second.n], strict=True)))
        y, turning = solve_modulo(*values_of(point, first), p), point.evaluate(self.turning)
        equal = tuple(y[i] == z for i, z in zip(self.common, turning, strict=True))
        return Found((p,), equal, ((), ()), free, places, tuple(off), 0, signs)

    def _counts(self, which: int, k: int, point: FieldPoint) -> bool:
        """Whether an equation narrows the positions at this point: the length of a quaternion means nothing where it is free."""
        laws, system = self.laws[which], (self.pairing.first, self.pairing.second)[which]
        if laws.names[k] in {entry.name for entry in system.spec.holonomic}:
            return True
        return which == 0 and not point.evaluate([laws.equations[laws.holonomic.index(k)]])[0]

    def _dimension(self, rows: Sequence[Sequence[int]], p: int) -> int:
        """How many of the common velocities of the first system these rows leave free."""
        free = null_space(rows, self.pairing.first.n, p)
        return rank_modulo([[vector[i] for i in self.common] for vector in free], p)

    def _break_second(self, point: FieldPoint, rows: Sequence[Sequence[int]], free: tuple[int, int]) -> tuple[str, ...]:
        """Constraints of the second system that velocities break which the first allows; as far as names can be compared."""
        pairing, p, laws = self.pairing, point.prime, self.laws[1]
        places = {i: pairing.place_of(i) for i in self.common}
        if not pairing.is_renaming:
            return ()
        vectors = null_space(rows, pairing.first.n, p)
        found = []
        for name, row in zip(laws.names, laws.rows, strict=True):
            values = point.evaluate(row)
            if any(values[j] for j in pairing.alone[1]):
                continue
            on = {i: values[j] for i, j in places.items() if j is not None}
            if any(sum(a * vector[i] for i, a in on.items()) % p for vector in vectors):
                found.append(name)
        return tuple(found)

    # --- how much a point says ----------------------------------------------------------------------------

    def _solved(self) -> list[Solved]:
        first, second = self.laws
        extra = self.pairing.alone[0]
        rest = [[*(row[i] for i in extra), self._rest(row)] for row in first.rows]
        accelerated = [[*row, b] for row, b in zip(second.matrix, second.right, strict=True)]
        return [(self.pairing.second.v, second.rows), (self.own, rest), (self.rates, accelerated)]

    def _rest(self, row: Row) -> Node:
        """What the common velocities give to a row of the first system."""
        g = self.graph
        return g.add(g.dot([row[i] for i in self.common], self.motion), row[-1])

    def _count_signs(self, nodes: Sequence[Node]) -> int:
        g = self.graph
        if not may_hold(g, nodes):
            return 0

        def settle(point: FieldPoint) -> None:
            self.leaf.settle(point)
            self.settle(point)

        symbols = (*self.pairing.second.v, *self.own, *self.rates, *self.leaf.solved)
        signs = Signs(g, nodes, settle, g.mask(symbols))
        for unknowns, rows in self._solved():
            signs.solve([x for row in rows for x in row[:-1]], [row[-1] for row in rows], unknowns)
        first = self.laws[0]
        mask, degree = signs.solve([x for row in first.matrix for x in row], first.right)
        other, turned = signs.mask_and_degree([*self.turning, *self.motion])
        return min((mask | other).bit_count(), max(degree, turned))

    def _degree(self, nodes: Sequence[Node]) -> int:
        first = self.laws[0]
        degrees = Degrees(self.graph, nodes, {}, self._solved())
        rows = [[*row, b] for row, b in zip(first.matrix, first.right, strict=True)]
        rows += [[self._rest(row)] for row in first.rows]
        own = 2 * sum(degrees.over_common(row) for row in rows)
        return degrees.inflate(own + degrees.over_common([*self.turning, *self.motion]))


def _joined(seen: Sequence[Found]) -> Found:
    whole = all(one.equal for one in seen)
    equal = tuple(all(flags) for flags in zip(*(one.equal for one in seen), strict=True)) if whole else ()
    violated = [tuple(dict.fromkeys(name for one in seen for name in one.violated[k])) for k in (0, 1)]
    return Found(
        tuple(p for one in seen for p in one.primes),
        equal,
        (violated[0], violated[1]),
        (max(one.freedom[0] for one in seen), max(one.freedom[1] for one in seen)),
        (max(one.places[0] for one in seen), max(one.places[1] for one in seen)),
        tuple(dict.fromkeys(name for one in seen for name in one.off)),
        0,
        seen[0].signs,
    )
