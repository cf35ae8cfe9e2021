"""Energies of arms that were multiplied out in the angles between their links, by the links' angles in space.

cos(q2 + q3) of joints is cos(A3 - A1) of links with A_k = q_1 + ... + q_k: there every velocity turns one link alone, as squares
are looked for (:mod:`nhc.mechanics.energies.squares`).  The coordinates' own symbols stand for the A_k on the way.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from functools import reduce
from itertools import pairwise
from operator import or_

from nhc.algebra.calculus import derivative, gradient
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.expand import TooLarge
from nhc.algebra.graph import ADD, Graph, Node
from nhc.algebra.polynomial import normalise, polynomial
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import count, reachable
from nhc.mechanics.energies.angles import are_products
from nhc.mechanics.energies.entries import TERMS
from nhc.mechanics.energies.squares import squares_of
from nhc.mechanics.system import System

_Parents = dict[int, int]
"""The joint before a joint, by their places among the coordinates."""


def complete_squares(system: System, *, longer: bool = False) -> Node | None:
    """T as a sum of squares, the shortest one that is found, by joints or by links; what comes out is T by the exact test.

    ``longer``: T is one already, and may become a little longer where that says that a mass is a point.
    """
    g, found = system.graph, [squares_of(system, longer=longer)]
    if are_products(system):
        found.append(squares_of(system, all_angles=True))
    for other, back in _by_links(system):
        made = squares_of(other)
        if made is not None:
            plain, whole = substitute(g, made, back, named=False)
            found.append((plain, whole))
    known = sorted((count(g, [plain]), whole) for plain, whole in filter(None, found))
    return next((whole for _, whole in known if are_equal(g, [whole], [system.T])), None)


def _by_links(system: System) -> Iterator[tuple[System, dict[Node, Node]]]:
    """The system with T by angles of links, and what these and their rates are by the joints'; nothing where no angles are added.

    The first joint turns all of the arm: T may not show it, and then it is the coordinate before the others.
    """
    g, joints, done = system.graph, _list_joints(system), list[_Parents]()
    for begin in (max(joints[0] - 1, 0), joints[0], None) if joints else ():
        chain = [*([] if begin is None else [begin]), *(k for k in joints if k != begin)]
        parents = _list_parents(system) if begin is None else {k: before for before, k in pairwise(chain)}
        if not parents or parents in done:
            continue
        done.append(parents)
        apart, whole = dict[Node, Node](), dict[Node, Node]()
        for symbols in (system.q, system.v):
            apart |= {symbols[k]: g.sub(symbols[k], symbols[before]) for k, before in parents.items()}
            whole |= {symbols[k]: g.sum(symbols[j] for j in _path(parents, k)) for k in parents}
        yield replace(system, T=_put(g, system.T, apart)), whole


def _path(parents: _Parents, k: int) -> list[int]:
    """The joints from the root to this one."""
    found = [k]
    while found[-1] in parents:
        found.append(parents[found[-1]])
    return found[::-1]


def _list_parents(system: System) -> _Parents:
    """The joint before each joint of a tree; none where T is of no tree by joints.

    What a joint turns is seen by it as one body, whose inertia about the joint hangs on the angles of all joints behind and of no
    others: on the diagonal of the matrix.
    """
    g, behind = system.graph, dict[int, set[int]]()
    turned = reduce(or_, (g.deps[node] for node in reachable(g, [system.T]) if g.op[node] in ("sin", "cos")), 0)
    joints = [k for k, q in enumerate(system.q) if g.deps[q] & turned]
    with suppress(TooLarge):
        for k, slope in enumerate(gradient(g, system.T, system.v)):
            inertia = polynomial(g, derivative(g, slope, system.v[k]), TERMS)
            seen = reduce(or_, (g.deps[f] for m in inertia for f, _ in m), 0)
            behind[k] = {j for j in joints if g.deps[system.q[j]] & seen}
    nested = all(j not in behind[j] and behind[j] < own for own in behind.values() for j in own if j in behind)
    if len(behind) < system.n or not nested:
        return {}
    before = {j: [k for k in range(system.n) if j in behind[k]] for j in joints}
    return {j: min(own, key=lambda k: len(behind[k])) for j, own in before.items() if own}


def _list_joints(system: System) -> list[int]:
    """The coordinates that are added in sines and cosines of T."""
    g, found = system.graph, set[int]()
    for node in reachable(g, [system.T]):
        if g.op[node] in ("sin", "cos") and g.op[g.a[node]] == ADD:
            slopes = {
                k: g.value(derivative(g, g.a[node], q))
                for k, q in enumerate(system.q)
                if g.depends(g.a[node], g.deps[q])
            }
            if len(slopes) > 1 and (*slopes.values(),) in ((1,) * len(slopes), (-1,) * len(slopes)):
                found |= slopes.keys()
    return sorted(found)


def _put(graph: Graph, energy: Node, apart: dict[Node, Node]) -> Node:
    """The energy with other coordinates, whose sums in sines and cosines are as short as they can be."""
    g, new = graph, dict(apart)
    for node in reachable(g, [energy], g.mask(tuple(apart))):
        if g.op[node] in ("sin", "cos"):
            new[node] = g.function(g.op[node], normalise(g, substitute(g, [g.a[node]], apart, named=False)[0]))
    return substitute(g, [energy], new, named=False)[0]
