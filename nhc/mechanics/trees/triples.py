"""Which of T's velocity forms are the components of points' velocities, in space or in a plane."""

from __future__ import annotations

from nhc.algebra.graph import Graph, Node
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.system import System


def place_of(g: Graph, atom: Node) -> tuple[Node, int]:
    """The position that a form or its negative is the rate of, and the sign; zero where there is none."""
    for rate, sign in ((atom, 1), (g.neg(atom), -1)):
        place = g.rate_of.get(rate, g.zero)
        if place != g.zero:
            return place, sign
    return g.zero, 1


def list_squares(system: System, kinetic: Kinetic) -> list[list[int]]:
    """T's forms that are rates of positions and stand there as h/2 x'^2, by h, in the order of the text."""
    g, forms = system.graph, system.graph.mask(kinetic.u)
    number = {u: k for k, u in enumerate(kinetic.u)}
    groups: dict[Node, list[int]] = {}
    for k in (number[node] for node in _from_left(g, kinetic.tau) if node in number):
        factor = kinetic.hessian[k][k]
        alone = all(h == g.zero for j, h in enumerate(kinetic.hessian[k]) if j != k)
        square = alone and not g.depends(factor, forms) and kinetic.slope[k] == g.mul(factor, kinetic.u[k])
        if square and place_of(g, kinetic.atoms[k])[0] != g.zero:
            groups.setdefault(factor, []).append(k)
    return list(groups.values())


def _from_left(g: Graph, root: Node) -> list[Node]:
    """The nodes of an expression, each once, in the order of its text."""
    found: dict[Node, None] = {}
    stack = [root]
    while stack:
        node = stack.pop()
        if node not in found:
            found[node] = None
            stack += reversed(g.kids[node])
    return list(found)
