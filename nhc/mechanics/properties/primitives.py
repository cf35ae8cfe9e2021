"""Antiderivatives of the constraints' terms: a combination of constraints that is closed has a sum of them for its integral.

Of sum_j a_j dq_j + a_0 dt each coefficient is multiplied out, and each product is integrated by its own differential.  Where the
form is closed these are the terms of its potential, up to numbers, which the search for integrals finds.
"""

from __future__ import annotations

from collections.abc import Iterator

from nhc.algebra.calculus import tangent
from nhc.algebra.expand import Monomial, TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import normalise, polynomial
from nhc.mechanics.system import System

_MOST = 40  # terms of a coefficient
_SIGNLESS = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh", "exp": "exp"}  # up to a sign, integrals


def find_primitives(system: System) -> list[Node]:
    """Antiderivatives of all terms, up to numbers, where they are elementary at once; each once, in the constraints' order."""
    g, found = system.graph, list[Node]()
    for form in system.constraints:
        for x, a in zip((*system.q, system.t), (*form.coefficients, form.constant), strict=True):
            try:
                terms = polynomial(g, a, _MOST, circle=False)
            except TooLarge:
                continue
            found += [node for term in terms for node in _integrate(g, term, x)]
    return list(dict.fromkeys(found))


def _integrate(g: Graph, term: Monomial, x: Node) -> Iterator[Node]:
    """At most one node: the integral of the product by x, up to a number; that of 1/x has a value on either side of 0."""
    inside = [(node, power) for node, power in term if g.depends(node, g.deps[x])]
    outside = g.product([g.power(node, power) for node, power in term if not g.depends(node, g.deps[x])])
    if not inside:
        yield g.mul(outside, x)
    elif len(inside) == 1:
        node, power = inside[0]
        if node == x:
            yield g.mul(outside, g.power(x, power + 1) if power != -1 else g.function("log", g.function("abs", x)))
        elif power == 1 and g.op[node] in _SIGNLESS:
            (rate,) = tangent(g, [g.a[node]], {x: g.one})
            if rate != g.zero and not g.depends(rate, g.deps[x]):
                yield g.mul(normalise(g, g.div(outside, rate), _MOST), g.function(_SIGNLESS[g.op[node]], g.a[node]))
