"""Velocity forms that were read from polynomials, as a position's rate reads: those of the spec's positions are the spec's own."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction
from functools import cached_property

from nhc.algebra.expand import Coefficient, Monomial, Polynomial, TooLarge
from nhc.algebra.graph import Node
from nhc.algebra.parts import split_parameters
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.terms import put
from nhc.mechanics.system import System

_TERMS = 4000
"""Terms of a form that is looked at."""


class Names:
    """Of the forms of one system."""

    def __init__(self, system: System) -> None:
        self.system, self.graph = system, system.graph
        self.parameters = self.graph.mask(system.p)

    def named(self, form: Node) -> Node:
        """The rate of a position of the spec's that the form is, up to its sign; else the form."""
        p = polynomial(self.graph, form, _TERMS)
        known = self._rates.get(frozenset(p.items()))
        return self._along_chain(p) if known is None else known

    def _along_chain(self, form: Polynomial) -> Node:
        """The form as a position's rate reads: what turns with one angle together, in the order of the coordinates."""
        g, groups = self.graph, dict[Monomial, Polynomial]()
        fixed = g.mask((*self.system.p, *self.system.v))
        for m, c in form.items():
            put(
                groups,
                tuple(x for x in m if g.deps[x[0]] & ~fixed),
                tuple(x for x in m if not g.deps[x[0]] & ~fixed),
                c,
            )

        one, terms = Fraction(1), list[Node]()
        for unit in sorted(groups, key=lambda unit: (self._place(unit), unit)):
            still, moving = split_parameters(g, to_node(g, groups[unit]), self.parameters)
            terms.append(g.mul(still.node(g), g.mul(to_node(g, {unit: one}), moving)))
        return g.sum(terms)

    def leading_number(self, form: Node) -> Fraction:
        """The size of the number before the term that turns with the first coordinates: as another form of a chain begins."""
        p = polynomial(self.graph, form, _TERMS)
        return abs(Fraction(p[min(p, key=lambda m: (self._place(m), m))])) if p else Fraction(1)

    def _place(self, unit: Monomial) -> int:
        """The last coordinate in it that moves."""
        g, q = self.graph, self.system.q
        return max((i for i, x in enumerate(q) for f, _ in unit if g.deps[f] & g.deps[x]), default=-1)

    @cached_property
    def _rates(self) -> dict[frozenset[tuple[Monomial, Coefficient]], Node]:
        g, found = self.graph, dict[frozenset[tuple[Monomial, Coefficient]], Node]()
        for rate in list(g.rate_of):
            with suppress(TooLarge):
                p = polynomial(g, rate, _TERMS)
                found.setdefault(frozenset(p.items()), rate)
                found.setdefault(frozenset((m, -c) for m, c in p.items()), rate)
        return found
