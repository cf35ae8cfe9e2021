"""Point masses on massless rods that swing in space by two angles: only the force along the rod reaches its other end.

The direction of a rod is n, its slopes by the two angles are e_r, normal to each other and to n, and g_r = e_r . e_r.  What the
whole tree beyond the rod asks of its foot is a function of one component of the foot's acceleration A, as in the plane
(:mod:`nhc.mechanics.trees.rods`):

    kappa/2 (n . A + b)^2 + beta (n . A + b),       b = -l (g_1 a_1'^2 + g_2 a_2'^2).

A rod that carries another one, n', passes on kappa = mu (mu + kappa')/(mu + kappa' |n' - (n . n') n|^2).  The rates of directions
are never taken: e_r . n'' is the rate of g_r a_r' without half the slopes of the g_s a_s'^2, as in Lagrange's equations.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.graph import Node
from nhc.algebra.rewriting.shorten import shorten
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.trees.chain import Chain
from nhc.mechanics.trees.sphere import Sphere, find_spheres
from nhc.records import structure


@structure
class _Load:
    """What pulls at a rod: ``sides[r]`` = e_r . the force on the tip, ``cross`` = n' . the part of it that is normal to n, and what
    reaches the foot beside kappa n . A.
    """

    sides: tuple[Node, Node]
    cross: Node
    pushed: Node


class Spheres:
    """All such rods of a chain; ``roots`` stand on something else."""

    def __init__(self, chain: Chain) -> None:
        self.chain, self.graph = chain, chain.graph
        self.rods, self.roots = list[Sphere](), list[Sphere]()
        g, held = self.graph, dict[tuple[int, ...], Sphere]()
        for rod in find_spheres(chain):  # feet come before tips
            parent = held.get(tuple(i for terms in rod.foot for i in terms)) if rod.continues(g) else None
            if parent is None:
                self.roots.append(rod)
            else:
                parent.child = rod
                if any(rod.rest):  # a weight that is an acceleration from here on
                    rod.centripetal = g.add(rod.centripetal, g.dot(rod.n, rod.rest))
                    first, second = (g.add(own, g.dot(e, rod.rest)) for own, e in zip(rod.turning, rod.e, strict=True))
                    rod.turning = first, second
            held[rod.tip] = rod
            self.rods.append(rod)
        for rod in reversed(self.rods):
            self._stiffen(rod)

    @property
    def variables(self) -> list[int]:
        """The rates and forms that are solved for here."""
        return [i for rod in self.rods for i in (*rod.rates, *rod.tip, *(rod.variables if rod.free else ()))]

    @property
    def pivots(self) -> list[tuple[Node, Node]]:
        """(pivot, what it is measured by)."""
        g = self.graph
        found = [(rod.pivot, rod.mass) for rod in self.rods]
        for rod in self.rods:  # zero where the angles are no coordinates
            found += [(own, own) for own in (g.mul(rod.mass, x) for x in rod.g if g.value(x) is None)]
            found += [(own, own) for own in dict.fromkeys(self._inertia(i) for i in rod.variables) if rod.free]
        return found

    def _inertia(self, i: int) -> Node:
        return self.chain.weights.get((i, i), self.graph.zero)

    def _stiffen(self, rod: Sphere) -> None:
        """kappa of what lies beyond the foot, from those beyond the tip."""
        g, mu, child = self.graph, rod.mass, rod.child
        if child is None:
            rod.pivot = rod.stiffness = mu
            return
        n, first, second = (child.on_foot(g, x) for x in (child.n, *child.e))
        rod.cosine = g.dot(rod.n, n)
        rod.across = g.dot(rod.e[0], n), g.dot(rod.e[1], n)
        rod.along = g.dot(first, rod.n), g.dot(second, rod.n)
        rod.lean = g.sum(g.div(g.power(t, 2), own) for t, own in zip(rod.across, rod.g, strict=True))
        rod.pivot = g.add(mu, g.mul(child.stiffness, rod.lean))
        rod.reciprocal = g.inverse(rod.pivot)
        rod.stiffness = g.mul(g.mul(mu, g.add(mu, child.stiffness)), rod.reciprocal)

    # --- right sides ----------------------------------------------------------------------------------------------

    def weights(self) -> list[tuple[int, int, Node]]:
        """What the rods add to H of the variables they stand on (a <= b)."""
        g, found = self.graph, []
        for rod in self.roots:
            held = [(i, rod.moved(g, i, rod.n)) for i in rod.variables if not rod.free]
            for k, (a, x) in enumerate(held):
                pushed = g.mul(rod.stiffness, x)
                found += [(min(a, b), max(a, b), g.mul(pushed, y)) for b, y in held[k:]]
        return found

    def push(self, pull: list[Node], drift: Sequence[Node], *, moving: bool) -> dict[int, _Load]:
        """Take the forces of the rods to what they stand on."""
        g, loads = self.graph, dict[int, _Load]()
        for rod in reversed(self.rods):
            force = [pull[i] for i in rod.tip]
            own = [g.mul(pull[i], arm) for i, arm in zip(rod.rates, rod.arm, strict=True)]  # at the joint
            sides = [g.add(g.dot(e, force), x) for e, x in zip(rod.e, own, strict=True)]
            if any(own):
                back = self._spread(rod, own)
                for i in rod.variables:
                    pull[i] = g.sub(pull[i], rod.moved(g, i, back))
            pushed, cross, child = g.neg(g.dot(rod.n, force)), g.zero, rod.child
            if child is not None:
                parts = zip(rod.across, sides, rod.g, strict=True)
                cross = g.sum(g.mul(t, g.div(side, own)) for t, side, own in parts)
                beyond = g.add(g.mul(rod.mass, loads[child.rates[0]].pushed), g.mul(child.stiffness, cross))
                pushed = g.add(pushed, g.mul(rod.cosine, g.mul(rod.reciprocal, beyond)))
            if moving:
                pushed = g.add(pushed, g.mul(rod.stiffness, rod.centripetal))
            loads[rod.rates[0]] = _Load((sides[0], sides[1]), cross, pushed)
        for rod in self.roots:
            load = loads[rod.rates[0]]
            if moving:
                load.pushed = g.add(g.mul(rod.stiffness, g.dot(rod.n, self._ground(rod, drift))), load.pushed)
            for i in rod.variables if not rod.free else ():
                pull[i] = g.sub(pull[i], g.mul(rod.moved(g, i, rod.n), load.pushed))
        return loads

    def _spread(self, rod: Sphere, sides: Sequence[Node]) -> list[Node]:
        """The vector normal to the rod that has these products with e_r."""
        g = self.graph
        parts = [g.div(side, own) for side, own in zip(sides, rod.g, strict=True)]
        return [g.dot(parts, column) for column in zip(*rod.e, strict=True)]

    def _ground(self, rod: Sphere, drift: Sequence[Node]) -> Vector:
        """The acceleration of a root's foot where no rate changes."""
        g = self.graph
        carried = (g.sum(g.mul(a, drift[i]) for i, a in terms.items()) for terms in rod.foot)
        x, y, z = (g.add(a, b) for a, b in zip(carried, rod.rest, strict=True))
        return x, y, z

    def answer(
        self,
        found: list[Node],
        pull: Sequence[Node],
        drift: Sequence[Node],
        loads: dict[int, _Load],
        *,
        moving: bool,
    ) -> None:
        """The rates of the rods, from roots to tips."""
        g = self.graph
        local: dict[int, tuple[Node, list[Node]]] = {}  # n . A and e_r . A of the foot
        for rod in self.roots:
            if rod.free:
                self._carry(rod, found, pull, loads[rod.rates[0]].pushed)
            foot = [g.sum(g.mul(a, found[i]) for i, a in terms.items()) for terms in rod.foot]
            if moving:
                foot = [g.add(x, a) for x, a in zip(foot, self._ground(rod, drift), strict=True)]
            local[rod.rates[0]] = g.dot(rod.n, foot), [g.dot(e, foot) for e in rod.e]
        for rod in self.rods:
            along, across = local[rod.rates[0]]
            load, child = loads[rod.rates[0]], rod.child
            if moving:
                along = g.add(along, rod.centripetal)
            tension = g.zero  # of the rod that this one carries
            if child is not None:
                asked = g.add(g.mul(child.stiffness, g.mul(rod.cosine, along)), loads[child.rates[0]].pushed)
                beyond = g.add(g.mul(rod.mass, asked), g.mul(child.stiffness, load.cross))
                tension = g.mul(rod.reciprocal, beyond)
                local[child.rates[0]] = self._tip(rod, child, along, load, tension)
            for r, i in enumerate(rod.rates):
                own = g.div(g.sub(load.sides[r], g.mul(rod.across[r], tension)), rod.mass)
                rest = g.add(across[r], rod.turning[r]) if moving else across[r]
                found[i] = g.mul(rod.arm[r], g.div(g.sub(own, rest), rod.g[r]))

    def _carry(self, rod: Sphere, found: list[Node], pull: Sequence[Node], pushed: Node) -> None:
        """The rates of what a rod alone is carried by: with the rod's force S, D v' = pull - h S and S = kappa h . v' + pushed."""
        g = self.graph
        h = {i: rod.moved(g, i, rod.n) for i in rod.variables}
        squares: dict[Node, list[Node]] = {}
        for i, x in h.items():
            squares.setdefault(self._inertia(i), []).append(g.power(x, 2))
        sums = shorten(g, [g.sum(parts) for parts in squares.values()], [*h.values()])
        eased = g.sum(g.div(total, own) for total, own in zip(sums, squares, strict=True))
        moved = g.sum(g.div(g.mul(x, pull[i]), self._inertia(i)) for i, x in h.items())
        force = g.div(g.add(g.mul(rod.stiffness, moved), pushed), g.add(g.one, g.mul(rod.stiffness, eased)))
        for i, x in h.items():
            found[i] = g.div(g.sub(pull[i], g.mul(x, force)), self._inertia(i))

    def _tip(self, rod: Sphere, child: Sphere, along: Node, load: _Load, tension: Node) -> tuple[Node, list[Node]]:
        """The acceleration of a rod's tip on the axes of the one it carries."""
        g, pulled = self.graph, self.graph.div(tension, rod.mass)
        to = g.add(g.mul(rod.cosine, along), g.sub(g.div(load.cross, rod.mass), g.mul(rod.lean, pulled)))
        inner = g.add(along, g.mul(rod.cosine, pulled))
        moved = self._spread(rod, [g.div(side, rod.mass) for side in load.sides])
        turned = [child.on_foot(g, e) for e in child.e]
        return to, [g.add(g.mul(u, inner), g.dot(e, moved)) for u, e in zip(rod.along, turned, strict=True)]
