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
        g = system.graph
        self.system = system
        self._places = [place for place, _ in pulls.forces]
        symbols = {
            place: g.symbol(f"pulled {k}", "held") for k, place in enumerate(self._places) if place not in system.q
        }
        (self._potential,) = substitute(g, [system.U], symbols)
        self._meaning = {symbol: place for place, symbol in symbols.items()}
        own = gradient(g, self._potential, [symbols.get(place, place) for place in self._places])
        self.meets = any(slope != g.zero for slope in own)
        """Whether the potential and another force pull at one position."""
        forces = on_motion([force for _, force in pulls.forces])
        self._sizes = [g.add(a, b) for a, b in zip(substitute(g, own, self._meaning), forces, strict=True)]
        self._rest = on_motion(pulls.rest)

    def work(self, direction: Direction) -> Node:
        """Along a vector: dU(e) + Q_i e_i."""
        g = self.system.graph
        arms = tangent(g, self._places, direction.seeds)
        seeds = {symbol: node for symbol, node in direction.seeds.items() if symbol not in self._places}
        others = substitute(g, tangent(g, [self._potential], seeds), self._meaning)[0]
        pairs = [*zip(self._sizes, arms, strict=True), *zip(self._rest, direction.x, strict=True)]
        return g.add(others, g.sum(g.mul(a, b) for a, b in pairs))
