"""T's quadratic forms P_ij v_i v_j by masses, as polynomials."""

from __future__ import annotations

from fractions import Fraction

from nhc.algebra.expand import Polynomial, TooLarge
from nhc.algebra.graph import Node
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.terms import put
from nhc.mechanics.energies.arms import linear_root
from nhc.mechanics.system import System

TERMS = 4000
"""Terms of an energy that is looked at."""

Entries = dict[tuple[int, int], Polynomial]
"""P_ij for i <= j, each off the diagonal half of what stands in T; the last index is that of what has no velocity."""

Mass = tuple[Node, ...]
"""Parameters whose product stands before entries."""


class Quadratic:
    """What makes entries of energies, and energies of entries; ``parameters`` is the mask of what does not move."""

    def __init__(self, system: System) -> None:
        self.system, self.graph = system, system.graph
        self.v = [*system.v, self.graph.one]
        self.parameters = self.graph.mask(system.p)

    def by_mass(self, energy: Polynomial) -> dict[Mass, Entries]:
        """The entries that belong to each product of parameters of which T is linear."""
        exponents: dict[Node, set[int]] = {p: set() for p in self.system.p}
        for monomial in energy:
            for factor, e in monomial:
                if factor in exponents:
                    exponents[factor].add(e)
        linear = {p for p, found in exponents.items() if found == {1}}
        place, velocities = {v: i for i, v in enumerate(self.system.v)}, self.graph.mask(self.system.v)
        found: dict[Mass, Entries] = {}
        for monomial, c in energy.items():
            mass = tuple(f for f, _ in monomial if f in linear)
            moved = [place[f] for f, e in monomial if f in place for _ in range(e)]
            rest = tuple((f, e) for f, e in monomial if (f not in place or e < 0) and f not in linear)
            i, j = sorted([*moved, len(place), len(place)][:2])
            if len(moved) > 2 or any(self.graph.deps[f] & velocities for f, _ in rest):
                raise TooLarge
            put(found.setdefault(mass, {}), (i, j), rest, c if i == j else Fraction(c) / 2)
        return found

    def node(self, entries: Entries) -> Node:
        """The energy that these are the entries of."""
        g, v = self.graph, self.v
        return g.sum(
            [
                g.mul(to_node(g, {m: c * (1 + (i != j)) for m, c in p.items()}), g.mul(v[i], v[j]))
                for (i, j), p in sorted(entries.items())
            ]
        )

    def moves(self, p: Polynomial) -> bool:
        """Whether it holds anything but parameters."""
        return any(self.graph.deps[f] & ~self.parameters for m in p for f, _ in m)

    def plus(self, entries: Entries, energy: Node, factor: Fraction) -> Entries:
        """The entries and ``factor`` times those of an energy of degree two, without what cancels."""
        place = {v: i for i, v in enumerate(self.system.v)}
        left = {key: dict(p) for key, p in entries.items()}
        for monomial, c in polynomial(self.graph, energy, TERMS).items():
            moved = [place[f] for f, e in monomial if f in place for _ in range(e)]
            i, j = sorted([*moved, len(place), len(place)][:2])
            rest = tuple((f, e) for f, e in monomial if f not in place)
            put(left, (i, j), rest, factor * c / (1 + (i != j)))
        return {key: p for key, p in left.items() if p}

    def join(self, entries: Entries) -> tuple[Entries, list[tuple[Node, Node]]]:
        """The entries with new symbols for sums of parameters, and these sums, as far as that leaves fewer terms."""
        g, back = self.graph, list[tuple[Node, Node]]()
        for n in range(len(self.system.v)):
            p = entries.get((n, n), {})
            parts = () if self.moves(p) else linear_root(p)
            single = next((k for k, (m, _) in enumerate(parts) if len(m) == 1 and m[0][1] == 1), -1)
            if single < 0:
                continue
            symbol, ((parameter, _),) = g.symbol(f"arm{n + 1}", "arm"), parts[single][0]
            arm = to_node(g, dict(parts))
            others = to_node(g, {m: c for k, (m, c) in enumerate(parts) if k != single})
            put_in = {parameter: g.mul_number(1 / parts[single][1], g.sub(symbol, others))}
            made = self.plus({}, substitute(g, [self.node(entries)], put_in)[0], Fraction(1))
            if sum(map(len, made.values())) < sum(map(len, entries.values())):
                self.parameters |= g.mask([symbol])
                entries = made
                back.append((symbol, arm))
        return entries, back
