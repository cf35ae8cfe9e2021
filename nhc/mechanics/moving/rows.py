"""Which components of the spec are vectors: squares of T with one factor, rows of constraints, rows along a direction."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import permutations

from nhc.algebra.graph import NEG, SYM, Graph, Node
from nhc.algebra.parts import list_terms
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.energies.positions import find_positions
from nhc.mechanics.moving.axes import Setting
from nhc.mechanics.moving.vectors import Chained
from nhc.mechanics.rotations.directions import Sided, along_direction
from nhc.mechanics.rotations.turns import Vector, change_axes
from nhc.mechanics.system import System


def square_groups(system: System, kinetic: Kinetic) -> list[tuple[int, ...]]:
    """Pairs and triples of exact velocity forms that stand in T as h/2 (u_i^2 + u_j^2 + u_k^2) and nowhere else.

    Forms that are not exact, such as components on a body's own axes, are no components on axes that stand still.  Exact ones that
    the spec wrote as velocities get their positions: in whatever order it has them, they are then one vector with those of
    coordinates.
    """
    g = system.graph
    coordinates = g.mask(system.q)
    groups: list[tuple[int, ...]] = []
    by_factor: dict[Node, list[int]] = {}
    for k in lone_squares(g, kinetic):
        factor = kinetic.hessian[k][k]
        if kinetic.slope[k] == g.mul(factor, kinetic.u[k]) and kinetic.is_exact(
            k
        ):  # else it was written in another way
            by_factor.setdefault(factor, []).append(k)
    find_positions(system, [kinetic.atoms[k] for members in by_factor.values() if len(members) > 1 for k in members])
    for members in by_factor.values():
        reach = {k: g.deps[kinetic.atoms[k]] & coordinates for k in members}
        groups += _pair(members, reach)
    return sorted(groups, key=sorted)


def lone_squares(graph: Graph, kinetic: Kinetic) -> list[int]:
    """Velocity forms that stand in T as h/2 u^2 and nowhere else, in the order in which T has them."""
    g, forms = graph, graph.mask(kinetic.u)
    found = []
    for k, (u, pi, row) in enumerate(zip(kinetic.u, kinetic.slope, kinetic.hessian, strict=True)):
        factor = row[k]
        alone = all(x == g.zero for j, x in enumerate(row) if j != k)
        if not alone or factor == g.zero or g.depends(factor, forms):
            continue
        if pi == g.mul(factor, u) or substitute(g, [pi], {u: g.zero}, named=False)[0] == g.zero:
            found.append(k)
    written = _list_symbols(g, kinetic.tau)
    return sorted(found, key=lambda k: written[kinetic.u[k]])


def _list_symbols(graph: Graph, root: Node) -> dict[Node, int]:
    """The symbols of an expression by their places, from left to right."""
    found: dict[Node, int] = {}
    seen, stack = set[Node](), [root]
    while stack:
        node = stack.pop()
        if graph.op[node] == SYM:
            found.setdefault(node, len(found))
        elif node not in seen:
            seen.add(node)
            stack += reversed(graph.kids[node])
    return found


def _pair(members: Sequence[int], reach: dict[int, int]) -> Iterator[tuple[int, ...]]:
    """Neighbours that contain the same coordinates, and a third that contains no others."""
    left = list(members)
    pairs = []
    for k, first in enumerate(members):
        if first not in left:
            continue
        partner = next((j for j in members[k + 1 :] if j in left and reach[j] == reach[first]), None)
        if partner is not None:
            left.remove(first)
            left.remove(partner)
            pairs.append((first, partner))
    for first, partner in pairs:
        third = [j for j in left if not reach[j] & ~reach[first]]
        if third and len(left) <= len(pairs):
            nearest = min(third, key=lambda j: abs(j - partner))
            left.remove(nearest)
            yield first, partner, nearest
        else:
            yield first, partner


def read_vector(setting: Setting, components: Vector) -> tuple[Chained, bool]:
    """A velocity by its components: as the rate of a position where the spec differentiated one."""
    places = [place_of(setting, node) for node in components]
    x, y, z = places
    if x is None or y is None or z is None:
        return setting.velocities.read(components), False
    return setting.positions.read((x, y, z)), True


def order_roots(setting: Setting, kinetic: Kinetic, groups: Sequence[tuple[int, ...]]) -> list[tuple[int, ...]]:
    """The groups, those of coordinates' own velocities in the order in which the rows and the other groups use these."""
    g, system = setting.graph, setting.system
    votes = Counter[tuple[Node, int]]()
    for value in setting.values:
        sided = along_direction(g, value)
        if sided is not None:
            votes.update((node, axis) for axis, node in enumerate(direction_vector(g, sided)[0]))
    own = dict(zip(system.q, system.v, strict=True))
    for group in groups:
        for axis, k in enumerate(group):
            place = place_of(setting, kinetic.atoms[k])
            votes.update((own[term], axis) for term in list_terms(g, place or g.zero) if term in own and term != place)
    ordered = []
    for group in groups:
        orders = list(permutations(group)) if all(kinetic.atoms[k] in system.v for k in group) else [group]
        agree = [sum(votes[kinetic.atoms[k], axis] for axis, k in enumerate(order)) for order in orders]
        ordered.append(orders[agree.index(max(agree))])
    return ordered


def read_group(setting: Setting, kinetic: Kinetic, group: tuple[int, ...]) -> tuple[tuple[int, ...], Chained, bool]:
    """A group of squares as a vector: in the given order, or in one in which it stands on a vector that is known."""

    def filled(nodes: Iterable[Node]) -> Vector:
        x, y, z = [*nodes, setting.graph.zero][:3]
        return x, y, z

    def stands(order: tuple[int, ...]) -> bool:
        places = [place_of(setting, kinetic.atoms[k]) for k in order]
        known = [place for place in places if place is not None]
        return len(known) == len(places) and setting.positions.stands_on_known(filled(known))

    order = next(filter(stands, permutations(group)), group)
    return order, *read_square(setting, filled(kinetic.atoms[k] for k in order))


def read_square(setting: Setting, components: Vector) -> tuple[Chained, bool]:
    """The same for components of a square, whose signs say nothing: those that the spec differentiated, or that share a base."""
    g = setting.graph
    signed = [sorted({node, g.neg(node)}, key=lambda n: (g.op[n] == NEG, n)) for node in components]
    placed = [next((n for n in both if place_of(setting, n) is not None), None) for both in signed]
    x, y, z = placed
    if x is not None and y is not None and z is not None:
        return read_vector(setting, (x, y, z))
    options = [(x, y, z) for x in signed[0][:1] for y in signed[1] for z in signed[2]]
    best = next((option for option in options if setting.velocities.has_base(option)), options[0])
    return setting.velocities.read(best), False


def place_of(setting: Setting, node: Node) -> Node | None:
    """The expression whose rate the node is, where the spec has one."""
    g, system = setting.graph, setting.system
    if node == g.zero:
        return g.zero
    if node in g.rate_of:
        return g.rate_of[node]
    body = g.a[node] if g.op[node] == NEG else node
    if body in system.v:
        place = system.q[system.v.index(body)]
    elif body in g.rate_of:
        place = g.rate_of[body]
    else:
        return None
    return place if body == node else g.neg(place)


def rewrite_row(setting: Setting, row: Node) -> Node | None:
    """A row along a direction, with its vector's component taken from the vector's home."""
    g = setting.graph
    sided = along_direction(g, row)
    if sided is None:
        return None
    components, axis, sign = direction_vector(g, sided)
    vector, is_position = read_vector(setting, components)
    home = setting.home(vector, is_position)
    component = change_axes(g, home.velocity, home.path, sided.path)[axis]
    return g.add(g.mul(sided.scale, component if sign > 0 else g.neg(component)), sided.rest)


def direction_vector(graph: Graph, sided: Sided) -> tuple[Vector, int, int]:
    """(vector, axis, sign): the row is its component along (0) or across (1) the direction, with that sign."""
    g, c, s = graph, sided.c, sided.s
    options = (((c, s), 0, 1), ((g.neg(s), c), 1, 1), ((g.neg(c), g.neg(s)), 0, -1), ((s, g.neg(c)), 1, -1))
    # all are true; the one that needs no signs in the components is the one that the user thought of
    (x, y), axis, sign = next((o for o in options if all(g.op[node] != NEG for node in o[0])), options[0])
    return (x, y, g.zero), axis, sign
