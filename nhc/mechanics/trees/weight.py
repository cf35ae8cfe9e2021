"""Forces on the positions whose rates are forms of T, and the acceleration of the ground that stands for weight."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import NEG, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.system import System
from nhc.mechanics.trees.points import Components

Weighed = tuple[Node, dict[Node, Node], dict[int, Node]]


def weigh(system: System, kinetic: Kinetic, *, coordinates: bool = False) -> Weighed:
    """U with symbols for the positions whose rates are forms of T, these symbols' positions, and dU by these, by number of the
    form; ``coordinates``: also where the position is one of these.
    """
    g = system.graph
    present = set(reachable(g, [system.U]))
    places: dict[Node, tuple[int, bool]] = {}
    for k, atom in enumerate(kinetic.atoms):
        negative = atom not in g.rate_of
        place = g.rate_of.get(g.neg(atom) if negative else atom)
        if place is not None and g.op[place] == NEG:
            place, negative = g.a[place], not negative
        if place in present and (coordinates or place not in system.q):
            places[place] = k, negative
    symbols = {place: g.symbol(f"place{k}", "held") for place, (k, _) in places.items()}
    (potential,) = substitute(g, [system.U], symbols)
    meaning = {symbol: place for place, symbol in symbols.items()}
    slopes = substitute(g, gradient(g, potential, list(symbols.values())), meaning)
    found = zip(places.values(), slopes, strict=True)
    return potential, meaning, {k: g.neg(f) if negative else f for (k, negative), f in found if f != g.zero}


def field_of(
    kinetic: Kinetic, points: Iterable[Components], signs: dict[int, int], weight: dict[int, Node]
) -> Vector | None:
    """The forces on points by the masses, where these are everywhere the same and nothing else has forces (J. le R. d'Alembert).

    None where they are not, or there are none.
    """
    g, system = kinetic.system.graph, kinetic.system
    found: list[set[Node]] = [set(), set(), set()]
    left = {k for k, force in weight.items() if force != g.zero}
    for components in points:
        for axis, k in enumerate(components):
            if k is not None:
                left.discard(k)
                force = g.scale(signs[k], weight.get(k, g.zero))
                found[axis].add(g.div(force, kinetic.hessian[k][k]))
    if left or any(len(values) > 1 for values in found):
        return None
    x, y, z = (next(iter(values), g.zero) for values in found)
    still = not any(g.depends(a, g.mask((*system.q, *kinetic.u))) for a in (x, y, z))
    return (x, y, z) if still and any((x, y, z)) else None
