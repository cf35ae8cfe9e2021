"""Rods without inertia of their own about their joint: only the force along the rod reaches its other end.

A rod i turns the pair of forms at its tip by n w'_i, n = (cos, sin) of its angle, and d = dn/dpsi is normal to n.  Nothing else
holds w'_i, so what the whole tree beyond the rod asks of its foot is a function of one component of the foot's acceleration A:

    kappa/2 (d . A + b)^2 + beta (d . A + b) + r n . A,       b = psi' w_i, r the force on w'_i,

and on the axes (n, d) of the next rod these are a few products with the sine and cosine of the angle between the two.  For a chain
of point masses this is the elimination of the rods' tensions, written with accelerations.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from nhc.algebra.calculus import tangent
from nhc.algebra.graph import NEG, Graph, Node
from nhc.algebra.walks import reachable
from nhc.mechanics.trees.chain import Chain, join
from nhc.records import fresh, structure

Foot = tuple[int | None, int | None]


@structure
class Rod:
    """``direction`` is n; psi = ``sign`` * angle + ``quarter`` * pi/2; kappa and D as in the text, b = ``centripetal``."""

    rate: int
    tip: tuple[int, int]
    foot: Foot
    direction: tuple[Node, Node]
    angle: Node
    sign: int
    quarter: int
    mass: Node
    centripetal: Node
    children: list[Rod] = fresh(factory=list)
    sine: Node = 0  # of psi minus the parent's
    cosine: Node = 0
    pivot: Node = 0
    reciprocal: Node = 0
    stiffness: Node = 0

    def axes(self, graph: Graph) -> tuple[tuple[Node, Node], tuple[Node, Node]]:
        """n and d on the axes of the pair."""
        x, y = self.direction
        return (x, y), (graph.neg(y), x)


class Rods:
    """All rods of a chain with nothing but rods beyond them; ``roots`` stand on something else."""

    def __init__(self, chain: Chain, beside: Sequence[Node]) -> None:
        self.chain, self.graph = chain, chain.graph
        self.rods = _find(chain)
        held = {rod.tip: rod for rod in self.rods}
        self.roots: list[Rod] = []
        for rod in self.rods:  # feet come before tips
            x, y = rod.foot
            parent = held.get((x, y)) if x is not None and y is not None else None
            if parent is None:
                self.roots.append(rod)
            else:
                parent.children.append(rod)
        trigonometry = self._at_hand(beside)
        for rod in self.rods:
            for child in rod.children:
                child.cosine, child.sine = _between(self.graph, rod, child, trigonometry)
        for rod in reversed(self.rods):
            self._stiffen(rod)

    @property
    def variables(self) -> list[int]:
        """The rates and forms that are solved for here."""
        return [i for rod in self.rods for i in (rod.rate, *rod.tip)]

    @property
    def pivots(self) -> list[tuple[Node, Node]]:
        """(pivot, what it is measured by)."""
        return [(rod.pivot, rod.mass) for rod in self.rods]

    def _at_hand(self, beside: Sequence[Node]) -> set[Node]:
        """Sines and cosines that are needed anyhow, also for what is computed ``beside``."""
        g, chain = self.graph, self.chain
        own = {i for rod in self.rods for i in (rod.rate, *rod.tip)}
        used = [*beside, *(force for force in chain.force if force != g.zero)]
        for k, terms in enumerate(chain.definitions):
            if chain.rates + k not in own:
                used += [*terms.values(), chain.turn[k]]
        return {node for node in reachable(g, used) if g.op[node] in ("sin", "cos")}

    def _stiffen(self, rod: Rod) -> None:
        """kappa of what lies beyond the foot, from those beyond the tip."""
        g, mu = self.graph, rod.mass
        parts = [(c.stiffness, g.neg(c.sine), c.cosine) for c in rod.children]
        rod.pivot = g.sum([mu, *(g.mul(g.mul(k, s), s) for k, s, _ in parts)])
        rod.reciprocal = g.inverse(rod.pivot)
        if not parts:
            rod.stiffness = mu
        elif len(parts) == 1:
            rod.stiffness = g.mul(g.mul(mu, g.add(mu, parts[0][0])), rod.reciprocal)
        else:
            along = g.sum([mu, *(g.mul(g.mul(k, c), c) for k, _, c in parts)])
            cross = self._cross(rod)
            rod.stiffness = g.sub(along, g.mul(g.mul(cross, rod.reciprocal), cross))

    def _cross(self, rod: Rod) -> Node:
        g = self.graph
        return g.neg(g.sum([g.mul(g.mul(c.stiffness, c.sine), c.cosine) for c in rod.children]))

    # --- right sides ----------------------------------------------------------------------------------------------

    def weights(self) -> list[tuple[int, int, Node]]:
        """What the rods add to H of the forms they stand on (a <= b)."""
        g, found = self.graph, []
        for rod in self.roots:
            _, d = rod.axes(g)
            held = [(i, g.mul(x, rod.stiffness), x) for i, x in zip(rod.foot, d, strict=True) if i is not None]
            found += [(a, a, g.mul(pushed, x)) for a, pushed, x in held]
            for (a, pushed, _), (b, _, x) in itertools.combinations(held, 2):
                # a foot whose components are one variable has both entries off the diagonal on it
                weight = g.mul(pushed, x)
                found.append((min(a, b), max(a, b), g.mul(g.number(2), weight) if a == b else weight))
        return found

    def push(self, pull: list[Node], drift: Sequence[Node], *, moving: bool) -> dict[int, Node]:
        """Take the forces of the rods to what they stand on; beta + kappa b of each rod."""
        g, pushed = self.graph, dict[int, Node]()
        for rod in reversed(self.rods):
            across = g.sub(
                g.sum(g.sub(g.mul(c.cosine, pull[c.rate]), g.mul(c.sine, pushed[c.rate])) for c in rod.children),
                pull[rod.rate],
            )
            turned = g.sum(g.mul(c.sine, pull[c.rate]) for c in rod.children)
            if len(rod.children) == 1:
                (child,) = rod.children
                rest = g.sum([g.mul(child.cosine, pull[child.rate]), g.neg(pull[rod.rate])])
                share = g.mul(g.mul(rod.mass, rod.reciprocal), g.mul(child.cosine, pushed[child.rate]))
                slip = g.mul(g.mul(self._cross(rod), rod.reciprocal), rest)
                along = g.add(share, g.sub(turned, slip))
            else:
                along = g.add(g.sum(g.mul(c.cosine, pushed[c.rate]) for c in rod.children), turned)
                along = g.sub(along, g.mul(g.mul(self._cross(rod), rod.reciprocal), across))
            if moving:
                along = g.add(along, g.mul(rod.stiffness, rod.centripetal))
            pushed[rod.rate] = along
        for rod in self.roots:
            n, d = rod.axes(g)
            ground = self._ground(rod, drift, moving)
            reach = g.dot(d, ground)
            load = g.add(g.mul(rod.stiffness, reach), pushed[rod.rate])
            for i, along, across in zip(rod.foot, d, n, strict=True):
                if i is not None:
                    pull[i] = g.sub(pull[i], g.add(g.mul(along, load), g.mul(across, pull[rod.rate])))
        return pushed

    def _ground(self, rod: Rod, drift: Sequence[Node], moving: bool) -> tuple[Node, Node]:
        """The acceleration of a root's foot where no rate changes."""
        g, chain = self.graph, self.chain
        if not moving:
            return g.zero, g.zero
        x, y = (
            g.add(chain.offset[tip - chain.rates], g.zero if foot is None else drift[foot])
            for tip, foot in zip(rod.tip, rod.foot, strict=True)
        )
        return x, y

    def answer(
        self, found: list[Node], pull: Sequence[Node], drift: Sequence[Node], pushed: dict[int, Node], *, moving: bool
    ) -> None:
        """The rates of the rods, from roots to tips."""
        g = self.graph
        local: dict[int, tuple[Node, Node]] = {}  # n . A and d . A of the foot
        for rod in self.roots:
            ground = self._ground(rod, drift, moving)
            foot = [g.add(g.zero if i is None else found[i], a) for i, a in zip(rod.foot, ground, strict=True)]
            n, d = rod.axes(g)
            local[rod.rate] = (
                g.dot(n, foot),
                g.dot(d, foot),
            )
        for rod in self.rods:
            across, along = local[rod.rate]
            if moving:
                along = g.add(along, rod.centripetal)
            loads = []
            for c in rod.children:
                inner = g.add(pushed[c.rate], g.mul(c.stiffness, g.mul(c.cosine, along)))
                loads.append(g.sub(g.mul(c.cosine, pull[c.rate]), g.mul(c.sine, inner)))
            tip = g.mul(rod.reciprocal, g.sub(pull[rod.rate], g.sum(loads)))
            found[rod.rate] = g.sub(tip, across)
            for c in rod.children:
                local[c.rate] = (
                    g.add(g.mul(c.cosine, tip), g.mul(c.sine, along)),
                    g.sub(g.mul(c.cosine, along), g.mul(c.sine, tip)),
                )


# --- finding them ------------------------------------------------------------------------------------------------


def _find(chain: Chain) -> list[Rod]:
    """The rods, feet before tips."""
    users: list[list[int]] = [[] for _ in range(chain.size)]
    for k, terms in enumerate(chain.definitions):
        for c in terms:
            users[c].append(chain.rates + k)
    held = {i for key in chain.weights for i in key if key[0] != key[1]}
    made: dict[frozenset[int], tuple[int, dict[int, int | None]]] = {}
    for i in sorted(range(chain.rates), key=lambda i: min(users[i], default=0), reverse=True):
        pair = users[i]
        if len(pair) != 2 or (i, i) in chain.weights or held & {i, *pair}:
            continue
        feet = _feet(chain, i, pair)
        beyond = [j for tip in pair for j in users[tip]]
        if feet is None or not _only_rods(beyond, pair, made):
            continue
        made[frozenset(pair)] = i, feet
    return _orient(chain, made)


def _feet(chain: Chain, i: int, pair: Sequence[int]) -> dict[int, int | None] | None:
    """Which form each of the pair continues, where both are (foot + sine or cosine times the rate) with equal masses."""
    g, feet = chain.graph, dict[int, int | None]()
    angles = set()
    for j in pair:
        k = j - chain.rates
        terms = chain.definitions[k]
        others = [c for c in terms if c != i]
        trig = _trigonometric(g, terms[i])
        if len(others) > 1 or any(terms[c] != g.one for c in others) or trig is None:
            return None
        if not chain.steady[k] or chain.force[j] != g.zero:
            return None
        feet[j] = others[0] if others else None
        angles.add(trig)
    same = chain.weights.get((pair[0], pair[0])) == chain.weights.get((pair[1], pair[1]))
    return (
        feet if same and {name for name, _ in angles} == {"sin", "cos"} and len({a for _, a in angles}) == 1 else None
    )


def _only_rods(
    beyond: Sequence[int], pair: Sequence[int], made: dict[frozenset[int], tuple[int, dict[int, int | None]]]
) -> bool:
    """Whether all that continues the pair are rods with both feet on it."""
    home = {j: tips for tips in made for j in tips}
    return all(j in home and set(made[home[j]][1].values()) == set(pair) for j in beyond)


def _trigonometric(graph: Graph, node: Node) -> tuple[str, Node] | None:
    bare = graph.a[node] if graph.op[node] == NEG else node
    return (graph.op[bare], graph.a[bare]) if graph.op[bare] in ("sin", "cos") else None


def _orient(chain: Chain, made: dict[frozenset[int], tuple[int, dict[int, int | None]]]) -> list[Rod]:
    """Rods with the order of their pairs taken over from their feet."""
    g, rods = chain.graph, list[Rod]()
    order: dict[frozenset[int], tuple[int, int]] = {}
    for tips, (i, feet) in sorted(made.items(), key=lambda item: min(item[0])):
        first, second = sorted(tips)
        known = order.get(frozenset(x for x in feet.values() if x is not None))
        if known is not None and feet[first] == known[1]:
            first, second = second, first
        if known is not None and any(chain.offset[j - chain.rates] != g.zero for j in tips):
            return []
        order[tips] = first, second
        x, y = (chain.definitions[j - chain.rates][i] for j in (first, second))
        angle, sign, quarter = _direction(g, x, y)
        (rate,) = tangent(g, [angle], chain.along)
        spin = join(g, rate, chain.velocity[i], chain.parameters, chain.velocities)
        mass = chain.weights.get((first, first), g.zero)
        foot = (feet[first], feet[second])
        centripetal = spin if sign > 0 else g.neg(spin)
        rods.append(Rod(i, (first, second), foot, (x, y), angle, sign, quarter, mass, centripetal))
    return rods


def _direction(graph: Graph, x: Node, y: Node) -> tuple[Node, int, int]:
    """(phi, s, k) with (x, y) = (cos psi, sin psi), psi = s phi + k pi/2."""
    sx, sy = (-1 if graph.op[node] == NEG else 1 for node in (x, y))
    bare = graph.a[x] if sx < 0 else x
    phi = graph.a[bare]
    if graph.op[bare] == "cos":
        return (phi, sy, 0) if sx > 0 else (phi, -sy, 2)
    return (phi, -sx, 1) if sy > 0 else (phi, sx, 3)


def _between(graph: Graph, parent: Rod, child: Rod, at_hand: set[Node]) -> tuple[Node, Node]:
    """cos and sin of psi_child - psi_parent: of the difference, or by products where the four factors are needed anyhow."""
    g = graph
    (x, y), (u, v) = parent.direction, child.direction
    bare = {g.a[node] if g.op[node] == NEG else node for node in (x, y, u, v)}
    if bare <= at_hand:
        return g.add(g.mul(x, u), g.mul(y, v)), g.sub(g.mul(x, v), g.mul(y, u))
    difference = g.sub(g.scale(child.sign, child.angle), g.scale(parent.sign, parent.angle))
    cosine, sine = g.function("cos", difference), g.function("sin", difference)
    turns = (child.quarter - parent.quarter) % 4
    return [(cosine, sine), (g.neg(sine), cosine), (g.neg(cosine), g.neg(sine)), (sine, g.neg(cosine))][turns]
