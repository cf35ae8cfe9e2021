"""T with points that move on spheres, cones and circles by the squares of single velocities.

x'^2 + y'^2 + z'^2 = l^2 (a'^2 + sin(a)^2 b'^2) of the first point of a pendulum in space says no more in components, where no other
point stands on it: the components' accelerations are then made for this point alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.expand import TooLarge
from nhc.algebra.graph import Node
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.energies.kinetic import Kinetic, keep_as_written, kinetic_structure
from nhc.mechanics.moving.rows import lone_squares
from nhc.mechanics.system import System

_MOST = 5
"""Coordinates of a system that is looked at."""
_TERMS = 60
"""Terms of such squares."""


def by_single_velocities(system: System) -> System | None:
    """The system with such a T; None where no point's square is one of single velocities."""
    if system.l or system.rotations or not 2 < system.n <= _MOST or "lone points" in system.graph.off:
        return None
    g, kinetic = system.graph, kinetic_structure(system)
    alone = lone_squares(g, kinetic)
    points = [k for group in _in_points(system, kinetic, alone) if _single(system, kinetic, group) for k in group]
    found = [*points, *(k for k in alone if kinetic.atoms[k] in system.v)]
    square = _single(system, kinetic, found) if points else None
    if square is None:
        return None
    put_in = dict(zip(kinetic.u, kinetic.atoms, strict=True)) | {kinetic.u[k]: g.zero for k in found}
    made = g.add(square, substitute(g, [kinetic.tau], put_in)[0])
    if made == system.T or not are_equal(g, [made], [system.T]):
        return None
    keep_as_written(g, made)
    return replace(system, T=made)


def _in_points(system: System, kinetic: Kinetic, alone: Sequence[int]) -> Iterable[list[int]]:
    """Forms of the same two velocities or more: what one angle turns is short in any words."""
    g, groups = system.graph, dict[int, list[int]]()
    velocities = g.mask(system.v)
    for k in alone:
        groups.setdefault(g.deps[kinetic.atoms[k]] & velocities, []).append(k)
    return (group for moved, group in groups.items() if moved.bit_count() > 1)


def _single(system: System, kinetic: Kinetic, group: Sequence[int]) -> Node | None:
    """What these forms have in T, where it has no product of two velocities."""
    g = system.graph
    squares = [g.mul(kinetic.hessian[k][k], g.power(kinetic.atoms[k], 2)) for k in group]
    try:
        p = polynomial(g, g.mul_number(Fraction(1, 2), g.sum(squares)), _TERMS)
    except TooLarge:
        return None
    velocities = g.mask(system.v)
    apart = all([e for f, e in m if g.deps[f] & velocities] == [2] for m in p)
    return to_node(g, p) if apart else None
