"""All forces by the positions that they act on: a spring and its damper are one force before they are multiplied by what moves it.

The slope of a potential along a vector e is the sum over its springs, and that of the other forces one over the dampers. With
positions h_k on which forces F_k are given, both together are (dU/dh_k + F_k) dh_k(e), and what U has besides.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.rotations.turning import Direction
from nhc.mechanics.system import Pulls, System


class Joined:
    """The forces of one system on one motion; ``on_motion`` puts the motion's velocities into nodes."""

    def __init__(self, system: System, pulls: Pulls, on_motion: Callable[[Sequence[Node]], list[Node]]) -> None:
        g = self.graph = system.graph
        self._places = list(dict.fromkeys(place for place, _ in pulls.forces))  # two names may mean one
        self._symbols = {
            place: g.symbol(f"pulled {k}", "held") for k, place in enumerate(self._places) if place not in system.q
        }
        self._meaning = {symbol: place for place, symbol in self._symbols.items()}
        self._sizes = dict.fromkeys(self._places, g.zero)
        self._potential = self._open(system.U)
        self._pull(self._potential, g.one, self._places)
        self.meets = any(self._sizes.values())
        """Whether the potential and another force pull at one position."""
        forces = on_motion([force for _, force in pulls.forces])
        for (place, _), force in zip(pulls.forces, forces, strict=True):
            self._sizes[place] = g.add(self._sizes[place], force)
        self._opened = [self._open(place, itself=False) for place in self._places]
        # what is made of other positions has a higher number than they have
        for place, opened in sorted(zip(self._places, self._opened, strict=True), reverse=True):
            if place in self._symbols:
                self._pull(opened, self._sizes[place], list(self._symbols))
        self._rest = on_motion(pulls.rest)

    def work(self, direction: Direction) -> Node:
        """Along a vector: dU(e) + Q_i e_i."""
        g = self.graph
        held = {q: node for q, node in direction.seeds.items() if q not in self._places}
        arms = tangent(g, self._opened, direction.seeds)
        others, *arms = substitute(g, [*tangent(g, [self._potential], held), *arms], self._meaning)
        pairs = [*zip(self._sizes.values(), arms, strict=True), *zip(self._rest, direction.x, strict=True)]
        return g.add(others, g.sum(g.mul(a, b) for a, b in pairs))

    def _open(self, node: Node, *, itself: bool = True) -> Node:
        """A node over symbols for the positions that it is made of."""
        held = {place: symbol for place, symbol in self._symbols.items() if itself or place != node}
        return substitute(self.graph, [node], held)[0]

    def _pull(self, opened: Node, size: Node, places: Sequence[Node]) -> None:
        """What a force of this size does to the positions that a node is made of."""
        g = self.graph
        slopes = gradient(g, opened, [self._symbols.get(place, place) for place in places])
        for place, slope in zip(places, substitute(g, slopes, self._meaning), strict=True):
            self._sizes[place] = g.add(self._sizes[place], g.mul(size, slope))
