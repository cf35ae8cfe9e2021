"""Units for the forms of a recursion in which coefficients are free of parameters.

A unit is a product of parameters, chosen so that nothing is divided by a parameter that a regular system may have at zero.
"""

from __future__ import annotations

from fractions import Fraction

from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import Factor, common, split_parameters
from nhc.mechanics.trees.recursion import Recursion, Weights


def _users(recursion: Recursion) -> dict[int, list[tuple[int, Node]]]:
    """What is made of a variable, with its coefficient there."""
    users: dict[int, list[tuple[int, Node]]] = {}
    for k, terms in enumerate(recursion.definitions):
        for c, a in terms.items():
            users.setdefault(c, []).append((recursion.rates + k, a))
    return users


def scales(g: Graph, recursion: Recursion, weights: Weights, mask: int) -> list[Node]:
    """A factor of parameters for each variable; none of them can vanish without the mass matrix becoming singular."""
    rates = recursion.rates
    masses = {key: split_parameters(g, h, mask)[0] for key, h in weights.items()}
    factors = _form_scales(g, recursion, masses, mask)
    parts: list[list[Factor]] = [[] for _ in range(rates)]
    for k, terms in enumerate(recursion.definitions):
        own_unit = factors[rates + k].node(g)
        for c, a in terms.items():
            if c < rates:
                parts[c].append(split_parameters(g, g.mul(a, own_unit), mask)[0])
    for i in range(rates):
        factor = common(parts[i])
        if all(mass.divisible_by(factor, (a == i) + (b == i)) for (a, b), mass in masses.items() if i in (a, b)):
            factors[i] = factor
    return [factor.node(g) for factor in factors]


def _form_scales(g: Graph, recursion: Recursion, masses: dict[tuple[int, int], Factor], mask: int) -> list[Factor]:
    """What stands squared in the masses of forms that belong together and is a factor wherever others are made of them."""
    factors = [Factor()] * recursion.size
    users = _users(recursion)
    for group in sorted(_groups(g, recursion), reverse=True):
        inside = set(group)
        own = [masses[i, i] for i in group if (i, i) in masses]
        beyond = [
            split_parameters(g, g.mul(a, factors[j].node(g)), mask)
            for i in group
            for j, a in users.get(i, ())
            if j not in inside
        ]
        outer = [factor for factor, _ in beyond]
        parts = [*(Factor(powers={base: n // 2 for base, n in mass.powers.items()}) for mass in own), *outer]
        continued = all(g.value(rest) in (1, -1) for _, rest in beyond)  # 2 x' + ..., which is x' + ... in other units
        shared = Factor(common(outer).number if continued else Fraction(1), common(parts).powers)
        for i in group:
            factors[i] = shared
    return factors


def _groups(g: Graph, recursion: Recursion) -> list[list[int]]:
    """Forms that are joined by a coefficient 1: they keep one unit."""
    group: dict[int, list[int]] = {}
    found: list[list[int]] = []
    for k, terms in enumerate(recursion.definitions):
        i = recursion.rates + k
        parents = [c for c, a in terms.items() if c >= recursion.rates and g.value(a) in (1, -1)]
        if not parents:
            group[i] = [i]
            found.append(group[i])
            continue
        home = group[parents[0]]
        home.append(i)
        group[i] = home
    return found


def common_mass(g: Graph, recursion: Recursion, weights: Weights, mask: int) -> Node:
    """A parameter that most of the masses have in common, if without it some rate would move nothing."""
    rates = recursion.rates
    found: list[Factor | None] = [None] * recursion.size
    masses: dict[int, list[Factor]] = {}
    for (a, b), h in weights.items():
        for i in {a, b}:
            masses.setdefault(i, []).append(split_parameters(g, h, mask)[0])
    for i in reversed(range(recursion.size)):
        below = found[i]
        here = [*masses.get(i, ()), *([below] if below is not None else [])]
        own = common(here)
        found[i] = own
        if i >= rates and here:
            for c in recursion.definitions[i - rates]:
                before = found[c]
                found[c] = own if before is None else common([before, own])
    count: dict[Node, int] = {}
    for i in range(rates):
        carried = found[i]
        for base in carried.powers if carried is not None else ():
            count[base] = count.get(base, 0) + 1
    best = [base for base, seen in count.items() if 2 * seen > rates]
    return min(best) if best else g.one
