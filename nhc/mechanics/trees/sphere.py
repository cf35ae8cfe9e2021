"""A point mass on a massless rod that swings in space by two angles, and where a chain has such rods."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import list_terms, split_parameters
from nhc.algebra.polynomial import normalise
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.trees.chain import Chain, join
from nhc.mechanics.trees.recursion import Terms
from nhc.records import structure

SHORT = 60
"""Terms of g_r and of sums of squares in their shortest form."""


@structure
class Sphere:
    """A rod: ``foot`` says what the tip's forms are of beside the rates; ``arm[r]`` is the unit of the rate r by that of these
    forms times the length, ``reach``.

    ``free``: the variables of the foot have diagonal inertias and move nothing else, so that they are solved for here.
    """

    rates: tuple[int, int]
    tip: tuple[int, int, int]
    foot: tuple[Terms, Terms, Terms]
    n: Vector
    e: tuple[Vector, Vector]
    g: tuple[Node, Node]
    reach: Node
    arm: tuple[Node, Node]
    mass: Node
    free: bool = False
    rest: Vector = (0, 0, 0)  # the foot's acceleration where no rate changes, without that of what it is made of
    centripetal: Node = 0  # b, with n . rest where it stands on another rod
    turning: tuple[Node, Node] = (0, 0)  # l e_r . n'' without the rates' rates, with e_r . rest
    child: Sphere | None = None
    cosine: Node = 0  # n . n'
    across: tuple[Node, Node] = (0, 0)  # e_r . n'
    along: tuple[Node, Node] = (0, 0)  # e'_r . n
    lean: Node = 0  # |n' - (n . n') n|^2
    pivot: Node = 0
    reciprocal: Node = 0
    stiffness: Node = 0

    @property
    def variables(self) -> list[int]:
        """What the foot is made of."""
        return list(dict.fromkeys(i for terms in self.foot for i in terms))

    def moved(self, graph: Graph, i: int, vector: Sequence[Node]) -> Node:
        """What a variable gives to the foot's component along a vector."""
        return graph.sum(graph.mul(x, terms[i]) for x, terms in zip(vector, self.foot, strict=True) if i in terms)

    def continues(self, graph: Graph) -> bool:
        """Whether its foot is another's tip, one of its forms along each axis and no multiple of that."""
        return all([abs(graph.value(a) or 0) for a in terms.values()] == [1] for terms in self.foot)

    def on_foot(self, graph: Graph, vector: Vector) -> list[Node]:
        """The components by the forms of the tip that it stands on, which may have the other sign."""
        return [graph.mul(a, x) for x, terms in zip(vector, self.foot, strict=True) for a in terms.values()]


def find_spheres(chain: Chain) -> list[Sphere]:
    """The rods, feet before tips."""
    g = chain.graph
    users: list[list[int]] = [[] for _ in range(chain.size)]
    for k, terms in enumerate(chain.definitions):
        for c in terms:
            users[c].append(chain.rates + k)
    mixed = {i for key in chain.weights if key[0] != key[1] for i in key}
    pairs: dict[tuple[int, ...], list[int]] = {}
    for i in range(chain.rates):
        if len(users[i]) in (2, 3) and (i, i) not in chain.weights and i not in mixed:
            pairs.setdefault(tuple(users[i]), []).append(i)
    made: dict[tuple[int, ...], Sphere] = {}
    wide = [key for key in pairs if len(key) == 3]
    places = chain.places() if wide else {}
    for tip in sorted(wide, reverse=True):
        rates = [i for key, own in pairs.items() if set(key) <= set(tip) for i in own]
        beyond = {j for t in tip for j in users[t]}
        carried = [own for own in made.values() if beyond & {*own.tip}]
        alone = [own for own in carried if beyond == {*own.tip} and {*own.variables} == {*tip} and own.continues(g)]
        if len(rates) != 2 or mixed & {*tip} or (beyond and not alone):
            continue
        axes = tuple(i for terms in alone[0].foot for i in terms) if alone else tip
        rod = _read(chain, (axes[0], axes[1], axes[2]), (min(rates), max(rates)), [places.get(j) for j in axes])
        if rod is not None:
            rod.free = bool(rod.variables) and all(
                i < chain.rates and i not in mixed and (i, i) in chain.weights and {*users[i]} <= {*tip}
                for i in rod.variables
            )
            made[tip] = rod
    return [made[tip] for tip in sorted(made)]


def _read(
    chain: Chain, tip: tuple[int, int, int], rates: tuple[int, int], places: Sequence[Node | None]
) -> Sphere | None:
    """The rod with this tip at these ``places``, which these rates turn; None where it is none."""
    g, masses = chain.graph, {chain.weights.get((j, j)) for j in tip}
    (mass,) = masses if len(masses) == 1 else (None,)
    foot = [{c: a for c, a in chain.definitions[j - chain.rates].items() if c not in rates} for j in tip]
    angles = [next((x for x, v in chain.along.items() if v == chain.velocities[i]), None) for i in rates]
    known = [node for node in (*places, *angles) if node is not None]
    if mass is None or len(known) < 5 or not all(chain.steady[j - chain.rates] for j in tip):
        return None
    x, y, z, *q = known
    n = _direction(chain, (x, y, z), (q[0], q[1]))
    if n is None:
        return None
    slopes = [gradient(g, x, q) for x in n]
    e = [(slopes[0][r], slopes[1][r], slopes[2][r]) for r in (0, 1)]
    terms = [[chain.definitions[j - chain.rates].get(i, g.zero) for j in tip] for i in rates]
    scale = [chain.scale[i] for i in rates]
    reach = next((g.div(g.mul(a, scale[0]), x) for a, x in zip(terms[0], e[0], strict=True) if x != g.zero), g.zero)
    same = [
        g.sub(g.mul(a, s), g.mul(reach, x))
        for row, s, own in zip(terms, scale, e, strict=True)
        for a, x in zip(row, own, strict=True)
    ]
    if reach == g.zero or not all(are_zero(g, [*same, g.dot(*e), g.sub(g.dot(n, n), g.one)])):
        return None
    metric = [normalise(g, g.dot(own, own), SHORT) for own in e]
    if are_zero(g, metric) != [False, False]:
        return None
    rod = Sphere(
        rates,
        tip,
        (foot[0], foot[1], foot[2]),
        n,
        (e[0], e[1]),
        (metric[0], metric[1]),
        reach,
        (g.div(scale[0], reach), g.div(scale[1], reach)),
        mass,
    )
    rod.rest = _rest(chain, tip, rod.foot)
    _turn(chain, rod, (q[0], q[1]))
    return rod


def _rest(chain: Chain, tip: Sequence[int], foot: Sequence[Terms]) -> Vector:
    """What moves the foot where nothing that it is made of has an acceleration."""
    g, found = chain.graph, []
    for j, terms in zip(tip, foot, strict=True):
        moved = tangent(g, list(terms.values()), chain.along)
        pairs = [(rate, chain.velocity[c]) for rate, c in zip(moved, terms, strict=True) if rate != g.zero]
        turned = g.sum(join(g, rate, v, chain.parameters, chain.velocities) for rate, v in pairs)
        found.append(g.add(chain.offset[j - chain.rates], turned))
    return found[0], found[1], found[2]


def _direction(chain: Chain, places: Sequence[Node], angles: tuple[Node, Node]) -> Vector | None:
    """n of what two angles turn in the three coordinates of a place; None where it is no product with a length."""
    g, turned, found = chain.graph, chain.graph.mask(angles), list[Node]()
    for place in places:
        terms = [split_parameters(g, x, chain.parameters) for x in list_terms(g, place) if g.depends(x, turned)]
        if any(factor != terms[0][0] or g.depends(rest, ~turned) for factor, rest in terms):
            return None
        found.append(g.sum(rest for _, rest in terms))
    return found[0], found[1], found[2]


def _turn(chain: Chain, rod: Sphere, angles: tuple[Node, Node]) -> None:
    """b, and what the rates of the angles make of e_r . n''."""
    g, w = chain.graph, [chain.velocities[i] for i in rod.rates]

    def times(x: Node, y: Node) -> Node:
        return join(g, x, y, chain.parameters, chain.velocities)

    slopes = [gradient(g, own, angles) for own in rod.g]  # d g_r / d a_s
    squares = [g.power(rate, 2) for rate in w]
    rod.centripetal = g.neg(g.mul(rod.reach, g.sum(times(own, v) for own, v in zip(rod.g, squares, strict=True))))
    made = []
    for r in (0, 1):
        own = g.sum(times(slopes[r][s], g.mul(w[s], w[r])) for s in (0, 1))
        back = g.sum(times(slopes[s][r], squares[s]) for s in (0, 1))
        made.append(g.mul(rod.reach, g.sub(own, g.div(back, g.number(2)))))
    rod.turning = made[0], made[1]
