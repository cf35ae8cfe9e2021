"""Rotations: a quaternion's four coordinates with the kinematics of angular velocity in closed form.

With s = 2/|e|^2 the angular velocity is omega = s E e', E being the 3 x 4 matrix of the quaternion product, and

    e' = E^T omega / 2 + e (|e|^2)' / (2 |e|^2)

is its inverse for every e but zero: E E^T = |e|^2 1 and E e = 0 (A. Cayley 1845; E. T. Whittaker, Analytical Dynamics, 4th ed.
(1937), sections 7-9).  Nothing is solved and no pivot can vanish.  The matrix R is of degree 0 in e and omega is invariant
when e is scaled, so every identity here holds for all e, not on |e| = 1 alone: the length is a gauge, the kinematics keep it, and
the reaction of |e|^2 = 1 is zero.

omega on the body's axes is left invariant, d omega = -omega x omega; in space d omega = + omega x omega (Cartan).  R' = R [omega],
or [omega] R.  These three facts are used where derivatives along a motion are taken, in place of the derivatives of quotients.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.calculus import tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.sizes import know_size
from nhc.mechanics.rotations.turns import Vector, cross
from nhc.records import fresh, identity_record, record

Turning = tuple[Node, Node, Node, Node]
"""(|e|^2)' and the three components of omega."""


@identity_record
class Rotation:
    """``places`` are the indices of the quaternion among the coordinates; ``matrix`` is R, ``omega`` and ``growth`` = (|e|^2)'
    are nodes over e and e'.  ``sign``: 1 for components on the body's axes, -1 for those in space.

    ``sums`` are the parts q_jj + q_kk of the diagonal entries R_ii = 1 - sums_i.
    """

    name: str
    places: tuple[int, int, int, int]
    sign: int
    e: tuple[Node, ...]
    v: tuple[Node, ...]
    matrix: tuple[Vector, ...]
    omega: Vector
    growth: Node
    sums: Vector
    known: dict[tuple[Node, ...], Turning] = fresh(factory=dict)
    _seeds: dict[tuple[Node, ...], dict[Node, Node]] = fresh(factory=dict)

    # --- velocities -----------------------------------------------------------------------------------------

    def velocities(self, graph: Graph, turning: Turning) -> tuple[Node, ...]:
        """e' from (|e|^2)' and omega."""
        g = graph
        columns = _columns(g, self.e, self.sign)
        half = [g.sum([g.mul(c[i], w) for c, w in zip(columns, turning[1:], strict=True)]) for i in range(4)]
        made = [g.div(x, g.number(2)) for x in half]
        if turning[0] != g.zero:
            rate = g.div(turning[0], g.mul(g.number(2), square(g, self.e)))
            made = [g.add(x, g.mul(e, rate)) for x, e in zip(made, self.e, strict=True)]
        self.known.setdefault(tuple(made), turning)
        return tuple(made)

    def turning(self, graph: Graph, rates: Sequence[Node]) -> Turning:
        """(|e|^2)' and omega of e' = ``rates``: looked up where these were made from them, else by the formula."""
        found = self.known.get(tuple(rates))
        if found is None:
            if all(x == graph.zero for x in rates):
                found = (graph.zero,) * 4
            else:
                on = dict(zip(self.v, rates, strict=True))
                first, a, b, c = substitute(graph, [self.growth, *self.omega], on, named=False)
                found = (first, a, b, c)
            self.known[tuple(rates)] = found
        return found

    def own_momenta(self, graph: Graph, p: Sequence[Node]) -> Vector:
        """From the momenta of e' those of unit turns about the axes of the velocities."""
        zero, one = graph.zero, graph.one
        units = (zero, one, zero, zero), (zero, zero, one, zero), (zero, zero, zero, one)
        x, y, z = (graph.dot(p, self.velocities(graph, unit)) for unit in units)
        return x, y, z

    def other_momenta(self, graph: Graph, p: Sequence[Node]) -> Vector:
        """The same about the axes of space, for velocities on the body's, or the reverse."""
        own = self.own_momenta(graph, p)
        R = self.matrix if self.sign > 0 else tuple(zip(*self.matrix, strict=True))
        x, y, z = (graph.dot(row, own) for row in R)
        return x, y, z

    # --- derivatives ----------------------------------------------------------------------------------------

    def rates_of_matrix(self, graph: Graph, omega: Sequence[Node]) -> list[list[Node]]:
        """R' = R [omega] or [omega] R."""
        g, R = graph, self.matrix
        if self.sign > 0:
            return [list(cross(g, row, omega)) for row in R]
        columns = [cross(g, omega, [R[0][j], R[1][j], R[2][j]]) for j in range(3)]
        return [[columns[j][i] for j in range(3)] for i in range(3)]

    def seeds(self, graph: Graph, rates: Sequence[Node]) -> dict[Node, Node]:
        """Derivatives of e and of the matrix along e' = ``rates``, for :func:`nhc.algebra.calculus.tangent`."""
        g, key = graph, tuple(rates)
        known = self._seeds.get(key)
        if known is not None:
            return known
        found = self._seeds[key] = dict(zip(self.e, rates, strict=True))
        if not any(rates):
            return found
        moved = self.rates_of_matrix(g, self.turning(g, rates)[1:])
        for i in range(3):
            for j in range(3):
                put(g, found, self.matrix[i][j], moved[i][j])
            put(g, found, self.sums[i], g.neg(moved[i][i]))
        return found

    def moving(self, graph: Graph, rates: Sequence[Node]) -> dict[Node, Node]:
        """e', omega and (|e|^2)' with e' = ``rates``, for substitution and for derivatives by velocities."""
        first, *omega = self.turning(graph, rates)
        found = dict(zip(self.v, rates, strict=True))
        for node, value in zip((self.growth, *self.omega), (first, *omega), strict=True):
            put(graph, found, node, value)
        return found

    def curl(self, graph: Graph, x: Sequence[Node], y: Sequence[Node]) -> Vector:
        """d omega (X, Y) for vectors whose angular velocities are x and y."""
        return cross(graph, y, x) if self.sign > 0 else cross(graph, x, y)


def name_entries(
    graph: Graph, rotation: Rotation, entries: Sequence[str], velocities: Sequence[str]
) -> dict[Node, Node]:
    """Symbols in place of the entries of R (row by row) and of omega, for substitution into what a person reads.

    They are not independent, so that nothing may be tested or differentiated with them in it.
    """
    found: dict[Node, Node] = {}
    for i in range(3):
        for j in range(3):
            symbol = graph.symbol(entries[3 * i + j], "entry")
            put(graph, found, rotation.matrix[i][j], symbol)
            if i == j:
                put(graph, found, rotation.sums[i], graph.sub(graph.one, symbol))
    for node, name in zip(rotation.omega, velocities, strict=True):
        put(graph, found, node, graph.symbol(name, "quasi"))
    return found


@record
class Spelled:
    """A rotation by symbols: the entries row by row, omega, what they stand in place of (``words``), and what they mean."""

    entries: tuple[Node, ...]
    omega: tuple[Node, ...]
    words: dict[Node, Node]
    meaning: dict[Node, Node]


def spell(graph: Graph, rotation: Rotation) -> Spelled:
    """Symbols of its own for the entries of R and for omega, as :func:`name_entries` puts them in, and the way back."""
    g = graph
    names = [f"{rotation.name}_entry{k}" for k in range(9)], [f"{rotation.name}_turn{k}" for k in range(3)]
    entries, omega = (
        tuple(g.symbol(own, kind) for own in part) for part, kind in zip(names, ("entry", "quasi"), strict=True)
    )
    nodes = (*(x for row in rotation.matrix for x in row), *rotation.omega)
    return Spelled(entries, omega, name_entries(g, rotation, *names), dict(zip((*entries, *omega), nodes, strict=True)))


def put(graph: Graph, mapping: dict[Node, Node], node: Node, value: Node) -> None:
    """``node`` = ``value`` as an entry for the node without its rational factor, which products carry in front of them."""
    factor, core = graph.split_coefficient(node)
    if core != graph.one:
        mapping[core] = value if factor == 1 or not value else graph.mul(graph.number(Fraction(1) / factor), value)


def square(g: Graph, e: Sequence[Node]) -> Node:
    """|e|^2."""
    return g.sum([g.power(x, 2) for x in e])


def _columns(g: Graph, e: Sequence[Node], sign: int) -> list[list[Node]]:
    """The rows of E: what multiplies omega_k in 2 e'."""
    found = []
    for k in range(3):
        i, j = (k + 1) % 3 + 1, (k + 2) % 3 + 1
        column = [g.neg(e[k + 1]), g.zero, g.zero, g.zero]
        column[k + 1] = e[0]
        column[i] = e[j] if sign > 0 else g.neg(e[j])
        column[j] = g.neg(e[i]) if sign > 0 else e[i]
        found.append(column)
    return found


def make_rotation(
    graph: Graph, name: str, places: Sequence[int], sign: int, e: Sequence[Node], v: Sequence[Node]
) -> Rotation:
    """The nodes of a rotation; sums stand on top of them, so that no product that they are in takes them apart."""
    g = graph
    half = g.sum([g.div(g.power(x, 2), g.number(2)) for x in e])
    f = [g.mul(x, g.inverse(half)) for x in e]  # 2 e / |e|^2
    squares = [g.mul(a, b) for a, b in zip(f, e, strict=True)]
    omega, entries, sums = [], [[g.zero] * 3 for _ in range(3)], []
    for k in range(3):
        i, j = (k + 1) % 3 + 1, (k + 2) % 3 + 1
        own = g.sub(g.mul(f[0], v[k + 1]), g.mul(f[k + 1], v[0]))
        other = g.sub(g.mul(f[j], v[i]), g.mul(f[i], v[j]))
        omega.append(g.add(own, other) if sign > 0 else g.sub(own, other))
        mixed, spun = g.mul(f[i], e[j]), g.mul(f[0], e[k + 1])
        entries[i - 1][j - 1], entries[j - 1][i - 1] = g.sub(mixed, spun), g.add(mixed, spun)
        sums.append(g.add(squares[i], squares[j]))
        entries[k][k] = g.sub(g.one, sums[k])
    for node in (*(x for row in entries for x in row), *sums):
        know_size(g, node, 2 if node in sums else 1)
    growth = tangent(g, [g.sub(square(g, e), g.one)], dict(zip(e, v, strict=True)))[0]
    a, b, c, d = places
    made = tuple((row[0], row[1], row[2]) for row in entries)
    return Rotation(
        name,
        (a, b, c, d),
        sign,
        tuple(e),
        tuple(v),
        made,
        (omega[0], omega[1], omega[2]),
        growth,
        (sums[0], sums[1], sums[2]),
    )
