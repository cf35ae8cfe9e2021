"""How the rates are solved for: by the dense L D L^T, by short inverses of blocks, from the leaves of a tree to its root, or by way
of angular velocities.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.differences import join_angles
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.walks import count
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.detour import Detour, find_detour
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.in_space import find_in_space
from nhc.mechanics.invariant import at_zero
from nhc.mechanics.system import Form, System
from nhc.mechanics.trees import FEW
from nhc.program.plan import factor, solve_factored
from nhc.program.planning.short_inverse import short_inverse
from nhc.records import fresh, structure

if TYPE_CHECKING:
    from nhc.mechanics.trees.tree import Elimination

Pairs = list[tuple[Node, Node]]
Solver = Callable[[Sequence[Node]], list[Node]]
"""Of x with mass @ x = right, from ``right``."""
Residual = Callable[[Sequence[Node]], list[Node]]
"""Of force - mass @ rates, from the rates."""


_LONG = 90
"""Operations of the dense way for each rate, from which a tree is looked for where constraints leave few rates and T holds the
time: the dense way then differentiates the matrices of what moves by itself."""
_SHORT = 90
"""Operations for each rate, up to which a detour is tried under constraints: what is longer has more than a body's turns in it."""
_APART = 40
"""Operations for each rate, from which bodies in space are also taken each on its own axes."""
_SHORTER = 1.05
"""How many times as long another way has to be for that."""
_REFUSES = 1.02
"""How many times as short a detour with a coframe of its own has to be."""
_MOST_BODIES = 20
"""Rates up to which the matrix of bodies may be shorter than the elimination along their tree."""


@structure
class MassRoute:
    """``values`` of the rates; (pivot, scale) pairs that must not vanish; ``solve``, where there is one.

    ``short``: the values are so short that they are differentiated themselves.  ``residual``: along a tree, where one was read.
    ``held``: pairs of the reactions' matrix of a held tree, which tell how many digits are left; ``turned``: of the coframe of a
    detour, whose determinants stand squared in that of the mass matrix.  ``chained``: each pivot waits for the one before it.
    """

    values: list[Node]
    pivots: Pairs
    solve: Solver | None = None
    short: bool = False
    residual: Residual | None = None
    chained: bool = False
    held: Pairs = fresh(factory=list)
    turned: Pairs = fresh(factory=list)


def mass_route(
    equations: Equations, full: Equations, put_in: Mapping[Node, Node], kept: Sequence[Form], *, straight: bool = False
) -> MassRoute:
    """The cheapest way; ``full`` are the equations before ``put_in`` was put into them: a tree is read from these.

    ``kept`` are the forms whose values the velocities w are.
    """
    g, size, found = equations.system.graph, len(equations.motion.w), list[MassRoute]()
    if full.tree is not None:
        found.append(_along(equations, full.tree, put_in))
    else:
        dense = _dense(equations)
        found += [dense, *_in_blocks(equations, dense)]
        tree = _other_tree(full) if not _is_small(full) or _is_long(full, dense) else None
        if tree is not None:
            along = _along(equations, tree, put_in)
            dense.residual = along.residual
            found.append(along)
        held = _along_held(full, put_in, kept, dense)
        if held is not None:
            found.append(held)
    least = min(count(g, way.values) for way in found)
    if not straight:
        in_space = find_in_space(full, kept)
        bound = full.system.l > len(full.system.rotations)  # by more than the lengths of quaternions
        detour = find_detour(full, kept) if not bound or least <= _SHORT * size else None
        found += [_by(way, full, put_in) for way in (detour, *in_space) if way is not None]
        turned = _with_another_energy(full, put_in, kept)
        found += [turned] if turned is not None else []
        least = min(count(g, way.values) for way in found)
    bodies = _of_bodies(full, put_in) if least > _APART * size else None
    if len(found) == 1 and bodies is None:
        return found[0]
    from nhc.mechanics.trees.choice import CHAINED, work

    def moving(way: MassRoute) -> int:
        """Pivots that must be watched: of a ball that rolls freely, whose rates are zero, nothing else is left."""
        return sum(g.depends(pivot, ~g.mask(full.system.p)) for pivot, _ in way.pivots)

    def cost(way: MassRoute) -> float:
        waits = way.chained and moving(way) > 0
        refuses = _REFUSES if way.turned else 1  # near what a detour's own coframe is singular at
        return refuses * work(g, join_angles(g, way.values)) + CHAINED * size * waits

    best = min(found, key=lambda way: (cost(way), moving(way)))
    return bodies if bodies is not None and _SHORTER * cost(bodies) < cost(best) else best


def _with_another_energy(full: Equations, put_in: Mapping[Node, Node], kept: Sequence[Form]) -> MassRoute | None:
    """The dense way with T at zero of an angle that it does not depend on."""
    if full.tree is not None or full.motion.velocities != full.motion.w or full.motion.w != full.system.v:
        return None
    g, system = full.system.graph, at_zero(full.system)
    if system is None:
        return None
    equations = equations_of(system, Formulation("lagrange", full.number, None, None, (), ""))
    inner = mass_route(equations, equations, {}, kept, straight=True)
    values, pivots = substitute(g, inner.values, put_in), _in_pairs(g, inner.pivots, put_in)
    return MassRoute(values, pivots, short=True, chained=inner.chained)


def _along_held(
    full: Equations, put_in: Mapping[Node, Node], kept: Sequence[Form], dense: MassRoute
) -> MassRoute | None:
    """By a tree that constraints hold, where there are few of them."""
    g = full.system.graph
    if not 0 < 2 * full.system.l <= len(full.motion.w) or len(full.motion.w) <= FEW:
        return None
    from nhc.program.planning.held_tree import held_tree

    held = held_tree(full, kept)
    if held is None:
        return None
    return MassRoute(
        substitute(g, held.rates, put_in),
        _in_pairs(g, held.pivots, put_in),
        lambda right: substitute(g, held.solve(right), put_in),
        residual=dense.residual,
        chained=True,
        held=_in_pairs(g, held.held, put_in),
    )


def _along(equations: Equations, tree: Elimination, put_in: Mapping[Node, Node]) -> MassRoute:
    g = equations.system.graph

    def put(nodes: Sequence[Node]) -> list[Node]:
        return substitute(g, nodes, put_in)

    return MassRoute(
        put(tree.rates),
        _in_pairs(g, tree.pivots, put_in),
        lambda right: put(tree.solve(right)),
        short=True,
        residual=lambda rates: put(tree.residual(rates)),
        chained=True,
    )


def _by(detour: Detour, full: Equations, put_in: Mapping[Node, Node]) -> MassRoute:
    g = full.system.graph
    inner = mass_route(
        detour.equations, detour.equations, {}, detour.frame.forms[detour.equations.system.l :], straight=True
    )
    values = shorten(g, detour.accelerations(inner.values))
    pivots = _in_pairs(g, _in_pairs(g, inner.pivots, detour.values), put_in)
    turned = _in_pairs(g, [pair for pair in detour.frame.guards if pair not in full.guards], put_in)
    return MassRoute(substitute(g, values, put_in), pivots, short=True, chained=inner.chained, turned=turned)


def _in_pairs(g: Graph, pairs: Sequence[tuple[Node, Node]], put_in: Mapping[Node, Node]) -> Pairs:
    flat = substitute(g, [node for pair in pairs for node in pair], put_in)
    return list(zip(flat[::2], flat[1::2], strict=True))


def _of_bodies(full: Equations, put_in: Mapping[Node, Node]) -> MassRoute | None:
    """The dense way with the matrix and the right side of bodies in space, where T has nothing but these."""
    g, size = full.system.graph, len(full.motion.w)
    if not 2 < size <= _MOST_BODIES or "composite inertias" in g.off:
        return None
    if _is_small(full) and not full.system.rotations:
        return None  # constraints leave a part of a body or two, which they have solved already
    from nhc.mechanics.trees.composite import assemble

    found = assemble(full.system, full.motion)
    if found is None:
        return None
    flat = substitute(g, [*(x for row in found.mass for x in row), *found.force], put_in)
    mass = [flat[k * size : (k + 1) * size] for k in range(size)]
    route = _by_matrix(full.system, mass, flat[size * size :])
    route.residual = lambda rates: substitute(g, found.residual(rates), put_in)
    return route


def _is_small(equations: Equations) -> bool:
    """Whether constraints leave few rates, for which a tree is seldom worth it."""
    motion = equations.motion
    return len(motion.w) <= FEW and motion.velocities != motion.w


def _is_long(equations: Equations, dense: MassRoute) -> bool:
    system = equations.system
    g = system.graph
    return g.depends(system.T, g.deps[system.t]) and count(g, dense.values) > _LONG * len(dense.values)


def _other_tree(equations: Equations) -> Elimination | None:
    """A tree that was not surely worth it, or under constraints that leave many rates: it is held against the dense way."""
    motion = equations.motion
    if len(motion.w) < 2:
        return None
    from nhc.mechanics.energies.whole_forms import whole_kinetic
    from nhc.mechanics.trees.choice import tree_of

    kinetic = whole_kinetic(equations.system)
    return tree_of(equations.system, motion, kinetic) if kinetic is not None else None


def _dense(equations: Equations) -> MassRoute:
    return _by_matrix(equations.system, equations.mass, equations.force)


def _in_blocks(equations: Equations, dense: MassRoute) -> list[MassRoute]:
    """By the short inverses of blocks, where these are shorter for it."""
    found = short_inverse(equations.system, equations.mass, equations.force) if equations.definite else None
    if found is None:
        return []
    pivots, solve = found
    g = equations.system.graph
    values = shorten(g, solve(equations.force))
    shorter = _SHORTER * count(g, [*values, *(pivot for pivot, _ in pivots)]) < count(g, dense.values)
    return [MassRoute(values, pivots, solve)] if shorter else []


def _by_matrix(system: System, mass: Sequence[Sequence[Node]], force: Sequence[Node]) -> MassRoute:
    g = system.graph
    factors = factor(g, mass, g.mask(system.p))
    values = shorten(g, solve_factored(g, factors, force))
    pivots = [(pivot, mass[k][k]) for k, pivot in zip(factors.order, factors.pivots, strict=True)]
    return MassRoute(values, pivots, lambda right: solve_factored(g, factors, right))
