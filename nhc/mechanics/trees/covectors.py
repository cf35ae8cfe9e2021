"""Reverse sweeps over a system with rotations: what a function or a form gives to each velocity, angular ones among them.

The entries of a rotation's matrix and its omega stand as symbols of their own, so that one sweep gives the slopes by all of them.
With R' = R [omega], or [omega] R for components in space, the slopes G by the entries are the torque

    sum over the rows r of R of G_r x r,     or over the columns c of c x G_c,

on the body's axes or in space.  The cost is a small multiple of the function's own, whatever the number of bodies.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.calculus import pullback_gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.rotations.rotation import Rotation, spell
from nhc.mechanics.rotations.turning import along as seeds_along
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross
from nhc.mechanics.system import System
from nhc.records import record

ZERO: Vector = (0, 0, 0)


@record
class Covector:
    """What stands before each coordinate's velocity (zero before those of quaternions), and before each rotation's omega."""

    forces: tuple[Node, ...]
    torques: tuple[Vector, ...]

    def plus(self, graph: Graph, other: Covector, sign: int = 1) -> Covector:
        """The sum, or the difference."""
        join = graph.add if sign > 0 else graph.sub
        forces = tuple(join(a, b) for a, b in zip(self.forces, other.forces, strict=True))
        pairs = zip(self.torques, other.torques, strict=True)
        return Covector(forces, tuple((join(a[0], b[0]), join(a[1], b[1]), join(a[2], b[2])) for a, b in pairs))

    def put(self, graph: Graph, mapping: Mapping[Node, Node]) -> Covector:
        """With the mapping applied."""
        flat = substitute(graph, [*self.forces, *(x for torque in self.torques for x in torque)], mapping)
        n = len(self.forces)
        rest = range(n, len(flat), 3)
        return Covector(tuple(flat[:n]), tuple((flat[k], flat[k + 1], flat[k + 2]) for k in rest))


class Sweeps:
    """Reverse sweeps of one system along the motion q' = ``velocities``, t' = 1."""

    def __init__(self, system: System, velocities: Sequence[Node]) -> None:
        self.system, self.graph = system, system.graph
        g = system.graph
        self.velocities = tuple(velocities)
        self.seeds = {**seeds_along(system, velocities), system.t: g.one}
        self.turning = [r.turning(g, [velocities[k] for k in r.places])[1:] for r in system.rotations]
        spelled = [spell(g, r) for r in system.rotations]
        self.entries, self.omega = [own.entries for own in spelled], [own.omega for own in spelled]
        self.words = {node: symbol for own in spelled for node, symbol in own.words.items()}
        self._back = {symbol: node for own in spelled for symbol, node in own.meaning.items()}
        self.quaternions = {k for r in system.rotations for k in r.places}

    def rates_of_entries(self) -> set[Node]:
        """Of all rotations, on the motion, with either sign; and the terms of these."""
        g, found = self.graph, set[Node]()
        for rotation, omega in zip(self.system.rotations, self.turning, strict=True):
            for rate in (x for row in rotation.rates_of_matrix(g, omega) for x in row):
                found.update((rate, g.neg(rate), *(c for c in g.kids[rate])))
        return found

    def named(self, nodes: Sequence[Node]) -> list[Node]:
        """The nodes over the symbols of entries and angular velocities."""
        return substitute(self.graph, nodes, self.words, named=False) if self.words else list(nodes)

    def _unnamed(self, nodes: Sequence[Node]) -> list[Node]:
        return substitute(self.graph, nodes, self._back, named=False) if self._back else list(nodes)

    def has_own_rates(self, named: Sequence[Node]) -> bool:
        """Whether rates of a quaternion are left in named nodes: they were not written by the angular velocity."""
        mask = self.graph.mask([v for r in self.system.rotations for v in r.v])
        return any(self.graph.depends(node, mask) for node in named)

    def hides_quaternions(self, nodes: Sequence[Node]) -> bool:
        """Whether entries and angular velocities are all that the nodes have of the rotations: e and k e are then the same."""
        mask = self.graph.mask([x for r in self.system.rotations for x in (*r.e, *r.v)])
        return not any(self.graph.depends(node, mask) for node in self.named(nodes))

    def slopes_of(self, node: Node) -> Covector:
        """Of a function."""
        return self.slopes([(self.named([node])[0], self.graph.one)])

    def slopes(self, weighted: Sequence[tuple[Node, Node]]) -> Covector:
        """sum of weight * d(named node) by the coordinates, entries and quaternions; weights are not differentiated."""
        g, system = self.graph, self.system
        flat = [symbol for symbols in self.entries for symbol in symbols]
        found = self._unnamed(pullback_gradient(g, weighted, [*system.q, *flat]))
        own = found[: system.n]
        torques = []
        for k, rotation in enumerate(system.rotations):
            by = found[system.n + 9 * k : system.n + 9 * k + 9]
            torque = self._torque(rotation, [(by[3 * i], by[3 * i + 1], by[3 * i + 2]) for i in range(3)])
            quaternion = [own[place] for place in rotation.places]
            if any(quaternion):
                torque = add_vectors(g, torque, self._of_quaternion(rotation, quaternion))
            torques.append(torque)
        forces = (0 if k in self.quaternions else x for k, x in enumerate(own))
        return Covector(tuple(forces), tuple(torques))

    def _torque(self, rotation: Rotation, rows: Sequence[Vector]) -> Vector:
        g, total = self.graph, ZERO
        for k in range(3):
            if rotation.sign > 0:
                part = cross(g, rows[k], rotation.matrix[k])
            else:
                part = cross(g, [row[k] for row in rotation.matrix], [row[k] for row in rows])
            total = add_vectors(g, total, part)
        return total

    def _of_quaternion(self, rotation: Rotation, slopes: Sequence[Node]) -> Vector:
        """What a function gives that depends on the quaternion in other ways than by the entries."""
        g, found = self.graph, []
        for k in range(3):
            unit = [g.zero] * 4
            unit[k + 1] = g.one
            found.append(g.dot(slopes, rotation.velocities(g, (unit[0], unit[1], unit[2], unit[3]))))
        return found[0], found[1], found[2]

    def turned(self, weighted: Sequence[tuple[Node, Node]]) -> Covector:
        """sum of weight_k * domega_k(X, .) of named velocity forms, X the motion.

        The weights are symbols; what X has for the velocities is still to be put in.
        """
        g, system = self.graph, self.system
        flat = [symbol for symbols in self.omega for symbol in symbols]
        by = self._unnamed(pullback_gradient(g, weighted, [*system.v, *flat]))
        moved = tangent(g, by, self.seeds)
        back = self.slopes(weighted)
        forces = [g.sub(a, b) for a, b in zip(moved[: system.n], back.forces, strict=True)]
        torques = []
        for k, rotation in enumerate(system.rotations):
            place = system.n + 3 * k
            first, own = moved[place : place + 3], by[place : place + 3]
            curled = cross(g, self.turning[k], own) if rotation.sign > 0 else cross(g, own, self.turning[k])
            x, y, z = (g.add(g.sub(a, b), c) for a, b, c in zip(first, back.torques[k], curled, strict=True))
            torques.append((x, y, z))
        return Covector(tuple(forces), tuple(torques))

    def pairs(self, covector: Covector) -> list[tuple[Node, Node]]:
        """(velocity on the motion, what stands before it) of all that is not zero."""
        found = list(zip(self.velocities, covector.forces, strict=True))
        for own, torque in zip(self.turning, covector.torques, strict=True):
            found += zip(own, torque, strict=True)
        return [(velocity, force) for velocity, force in found if force]
