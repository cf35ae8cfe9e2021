"""T with one angle counted from where it is: where nothing in it depends on the direction from which angles are counted.

The kinetic energy of an arm on a fixed joint is a function of the angles between its links, however its positions were written:
T(q) = T(q - q_k g) for a direction g of equal shifts.  At q_k = 0 the sine of that angle is 0, and the matrix is that of the books.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable
from nhc.mechanics.energies.kinetic import energy_as_squares
from nhc.mechanics.system import System

_MOST = 6
"""Coordinates of a system that is looked at."""


def at_zero(system: System) -> System | None:
    """The system with T at zero of an angle, where that is the same T; None where there is no such angle."""
    if system.l or system.rotations or not 1 < system.n <= _MOST or "directions" in system.graph.off:
        return None
    g, energy = system.graph, energy_as_squares(system)
    for mapping in _shifts(system, energy):
        (made,) = substitute(g, [energy], mapping, named=False)
        if made != energy and are_equal(g, [made], [energy]):
            return replace(system, T=made)
    return None


def _shifts(system: System, energy: Node) -> Iterator[dict[Node, Node]]:
    """What becomes of the angles that T holds: all of them shifted by the first, or one of them left out."""
    g = system.graph
    turned = {g.a[node] for node in reachable(g, [energy]) if g.op[node] in ("sin", "cos")}
    angles = [q for q in system.q if any(g.depends(angle, g.deps[q]) for angle in turned)]
    if len(angles) > 1:
        first, *others = angles
        yield {first: g.zero, **{q: g.sub(q, first) for q in others}}
    for q in angles:
        yield {q: g.zero}
