"""Forces on the positions whose rates are forms of T, and the acceleration of the ground that stands for weight."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from nhc.algebra.calculus import derivative, gradient
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.expand import Monomial, Polynomial, TooLarge
from nhc.algebra.graph import ADD, NEG, SYM, Graph, Node
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.terms import add_term, divide
from nhc.algebra.walks import reachable
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.system import System
from nhc.mechanics.trees.points import Components
from nhc.mechanics.trees.triples import place_of

_TERMS = 200
"""Terms of a mass's potential energy, and of positions."""
Weighed = tuple[Node, dict[Node, Node], dict[int, Node]]


def weigh(system: System, kinetic: Kinetic, *, coordinates: bool = False) -> Weighed:
    """U with symbols for the positions whose rates are forms of T, these symbols' positions, and dU by these, by number of the
    form; ``coordinates``: also where the position is one of these.
    """
    g, own = system.graph, _by_masses(system, kinetic) if coordinates or _adds_angles(system) else system.U
    present = set(reachable(g, [own]))
    places: dict[Node, tuple[int, bool]] = {}
    for k, atom in enumerate(kinetic.atoms):
        negative = atom not in g.rate_of
        place = g.rate_of.get(g.neg(atom) if negative else atom)
        if place is not None and g.op[place] == NEG:
            place, negative = g.a[place], not negative
        if place in present and (coordinates or place not in system.q):
            places[place] = k, negative
    symbols = {place: _symbol(g, k) for place, (k, _) in places.items()}
    (potential,) = substitute(g, [own], symbols)
    meaning = {symbol: place for place, symbol in symbols.items()}
    slopes = substitute(g, gradient(g, potential, list(symbols.values())), meaning)
    found = zip(places.values(), slopes, strict=True)
    return potential, meaning, {k: g.neg(f) if negative else f for (k, negative), f in found if f != g.zero}


def _adds_angles(system: System) -> bool:
    """Whether U holds sines of sums: what single angles have, :mod:`nhc.mechanics.trees.forces` takes to the bodies."""
    g = system.graph
    return any(g.op[node] in ("sin", "cos") and g.op[g.a[node]] == ADD for node in reachable(g, [system.U]))


def _by_masses(system: System, kinetic: Kinetic) -> Node:
    """U with m g z for the weight of a mass whose position z it does not name, where it was written out in angles."""
    g, U = system.graph, system.U
    if "found positions" in g.off:
        return U
    moving = ~g.mask(system.p)
    present = set(reachable(g, [U], moving))
    found: dict[Node, list[int]] = {}
    for k, row in enumerate(kinetic.hessian):
        if g.op[row[k]] == SYM and row[k] in system.p and place_of(g, kinetic.atoms[k])[0] != g.zero:
            found.setdefault(row[k], []).append(k)
    weights = []
    for mass, group in found.items():
        places = [place_of(g, kinetic.atoms[k])[0] for k in group]
        if not g.depends(U, g.deps[mass]) or any(place in present for place in places):
            continue
        own = derivative(g, U, mass)
        weight = _as_weight(g, own, places, moving) if not g.depends(own, g.deps[mass]) else None
        if weight is not None:
            weights.append((mass, own, weight))
    if not weights:
        return U
    (rest,) = substitute(g, [U], {mass: g.zero for mass, _, _ in weights})
    made = g.sum([rest, *(g.mul(mass, weight) for mass, _, weight in weights)])
    return made if are_equal(g, [made], [U]) else U


def _as_weight(g: Graph, own: Node, places: Sequence[Node], moving: int) -> Node | None:
    """``own`` as a sum of positions times constants, and a constant; None where it is none."""
    try:
        left, terms = polynomial(g, own, _TERMS), list[Node]()
        for place in dict.fromkeys(places):
            pull = _pull(g, left, polynomial(g, place, _TERMS), moving)
            if pull is not None:
                terms.append(g.mul(pull, place))
                for m, c in polynomial(g, terms[-1], _TERMS).items():
                    add_term(left, m, -c)
    except TooLarge:
        return None
    if not terms or any(g.deps[f] & moving for m in left for f, _ in m):
        return None
    return g.add(g.sum(terms), to_node(g, left))


def _pull(g: Graph, potential: Polynomial, place: Polynomial, moving: int) -> Node | None:
    """What the potential has before a position, by the first term of the position that moves; None where it has nothing."""

    def part(m: Monomial, *, moves: bool) -> Monomial:
        return tuple(x for x in m if bool(g.deps[x[0]] & moving) == moves)

    first = next((m for m in place if part(m, moves=True)), ())
    own = part(first, moves=True)
    held = {part(m, moves=False): c for m, c in potential.items() if own and part(m, moves=True) == own}
    factor = divide(held, Fraction(place[first]), part(first, moves=False)) if held else None
    return to_node(g, factor) if factor else None


def on_points(graph: Graph, weighed: Weighed, points: Iterable[Components]) -> Weighed:
    """The same for the points alone: what pulls at other forms' positions, such as at an angle, stays in U as it is."""
    g, (potential, meaning, weight) = graph, weighed
    own = {k for components in points for k in components if k is not None}
    left = {symbol: meaning[symbol] for k in weight if k not in own and (symbol := _symbol(g, k)) in meaning}
    kept = {symbol: place for symbol, place in meaning.items() if symbol not in left}
    return substitute(g, [potential], left)[0], kept, {k: force for k, force in weight.items() if k in own}


def _symbol(graph: Graph, k: int) -> Node:
    """Stands for the position whose rate form k is."""
    return graph.symbol(f"place{k}", "held")


def weigh_together(
    system: System, kinetic: Kinetic, points: Sequence[Components], signs: dict[int, int]
) -> Weighed | None:
    """The same as :func:`weigh` gives for one field on all points, where the masses or places in U are numbers that no longer tell
    which point a term is of: U holds g times the sum of m_k z_k for each axis, or most of it, beside other terms.  None where it
    does not.
    """
    g, moving = system.graph, ~system.graph.mask(system.p)
    axes = [[k for components in points if (k := components[axis]) is not None] for axis in range(3)]
    masses = [kinetic.hessian[k][k] for members in axes for k in members]
    if any(g.depends(mass, moving) for mass in masses) or all(g.value(mass) is None for mass in masses):
        return None
    symbols = {k: _symbol(g, k) for members in axes for k in members}
    places = {k: place_of(g, kinetic.atoms[k])[0] for k in symbols}
    weight, terms = dict[int, Node](), list[Node]()
    try:
        left = polynomial(g, system.U, _TERMS)
        for members in axes:
            moment = polynomial(g, g.sum(g.mul(kinetic.hessian[k][k], places[k]) for k in members), _TERMS)
            pull, left = _pull_most(g, left, moment, moving)
            if pull != g.zero:
                forces = {k: g.mul(pull, kinetic.hessian[k][k]) for k in members}
                weight |= {k: g.scale(signs[k], force) for k, force in forces.items()}
                terms += [g.mul(force, symbols[k]) for k, force in forces.items()]
    except TooLarge:
        return None
    if not weight:
        return None
    return g.add(g.sum(terms), to_node(g, left)), {symbols[k]: places[k] for k in weight}, weight


def _pull_most(g: Graph, potential: Polynomial, moment: Polynomial, moving: int) -> tuple[Node, Polynomial]:
    """The pull on a moment after which the fewest terms of the potential are left that move, and these; 0 where none gets less."""

    def count(p: Polynomial) -> int:
        return sum(any(g.deps[f] & moving for f, _ in m) for m in p)

    best, least = g.zero, potential
    for term in moment.items():
        pull = _pull(g, potential, dict([term]), moving)
        if pull is None:
            continue
        left = dict(potential)
        for m, c in polynomial(g, g.mul(pull, to_node(g, moment)), _TERMS).items():
            add_term(left, m, -c)
        if count(left) < count(least):
            best, least = pull, left
    return best, least


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
