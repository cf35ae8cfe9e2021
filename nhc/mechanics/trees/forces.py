"""Weight at the bodies in place of the joints, and then as an acceleration of the ground.

A generalised force c a on a rate, where a is the rate's coefficient in one of the forms, is the force c on that form with -c
on the forms that it continues: m g l sin(th) at every joint of a chain becomes m g at every body.  Forces in proportion to
the masses are an acceleration of everything (d'Alembert), which costs nothing but its place at the root.
"""

from __future__ import annotations

from dataclasses import replace

from nhc.algebra.graph import ADD, MUL, NEG, Node
from nhc.algebra.parts import list_terms, split_parameters
from nhc.algebra.polynomial import normalise
from nhc.mechanics.trees.chain import Chain


def lift_forces(chain: Chain) -> Chain:
    """The same chain with constant forces on forms in place of rates where they fit, and these as offsets of accelerations."""
    g = chain.graph
    force = list(chain.force)
    holders: list[list[int]] = [[] for _ in range(chain.rates)]
    for k, terms in enumerate(chain.definitions):
        for c in terms:
            if c < chain.rates:
                holders[c].append(chain.rates + k)
    for i in reversed(range(chain.rates)):
        places: dict[Node, tuple[int, int]] = {}
        for j in holders[i]:
            a = chain.definitions[j - chain.rates][i]
            sign, bare = (-1, g.a[a]) if g.op[a] == NEG else (1, a)
            if g.value(bare) is None and g.deps[bare] & ~chain.parameters:
                places.setdefault(bare, (j, sign))
        if places:
            _lift(chain, force, i, places)
    for j, (lifted, before) in enumerate(zip(force, chain.force, strict=True)):
        if lifted != before and g.op[g.core[lifted]] in (ADD, MUL) and not g.deps[lifted] & ~chain.parameters:
            force[j] = normalise(g, lifted)  # (m2 + m3) g - m3 g
    return _as_offsets(replace(chain, force=tuple(force)))


def _lift(chain: Chain, force: list[Node], i: int, places: dict[Node, tuple[int, int]]) -> None:
    """Move the terms of the force on rate i that fit to the forms."""
    g = chain.graph
    kept, (common, whole) = g.zero, split_parameters(g, force[i], chain.parameters)
    for part in list_terms(g, whole):
        term = g.mul(common.node(g), part)
        outer, rest = split_parameters(g, term, chain.parameters)
        negative = g.op[rest] == NEG
        place = places.get(g.a[rest] if negative else rest)
        if place is None:
            kept = g.add(kept, term)
            continue
        j, sign = place
        value = outer.node(g)
        if negative == (sign > 0):
            value = g.neg(value)
        force[j] = g.add(force[j], value)
        for c, a in chain.definitions[j - chain.rates].items():
            if c != i:
                force[c] = g.sub(force[c], g.mul(a, value))
    force[i] = kept


def _as_offsets(chain: Chain) -> Chain:
    """Forces in proportion to the masses of forms that continue one another become one acceleration at their root."""
    g, rates = chain.graph, chain.rates
    home, roots, outside = _families(chain)
    mixed = {i for a, b in chain.weights if a != b for i in (a, b)}
    field: dict[int, Node | None] = {}
    for j in range(rates, chain.size):
        mass = chain.weights.get((j, j), g.zero)
        if mass == g.zero and chain.force[j] == g.zero:
            continue
        value = None if mass == g.zero or j in mixed else g.div(chain.force[j], mass)
        field[home[j]] = value if field.get(home[j], value) == value else None
    force, offset = list(chain.force), list(chain.offset)
    for family, value in field.items():
        if value in (None, g.zero) or family in outside:
            continue
        for j in range(rates, chain.size):
            if home[j] == family:
                force[j] = g.zero
        for j in roots[family]:
            offset[j - rates] = g.sub(offset[j - rates], value)
    return replace(chain, force=tuple(force), offset=tuple(offset))


def _families(chain: Chain) -> tuple[dict[int, int], dict[int, list[int]], set[int]]:
    """(first of its family for each form that continues another, roots by family, families that others are made of)."""
    g, rates = chain.graph, chain.rates
    home: dict[int, int] = {}
    roots: dict[int, list[int]] = {}
    outside: set[int] = set()
    for k, terms in enumerate(chain.definitions):
        j = rates + k
        before = [c for c, a in terms.items() if c >= rates and a == g.one]
        if len(before) == 1:
            home[j] = home[before[0]]
        else:
            home[j] = j
            roots[j] = [j]
        outside.update(home[c] for c, a in terms.items() if c >= rates and home[c] != home[j])
    return home, roots, outside
