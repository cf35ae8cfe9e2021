"""Positions whose rates velocity forms are: x for x' = l cos(a) a', where the spec wrote velocities out.

An exact form W_i dq_i + W_0 dt is the differential of the sum of what is found coordinate by coordinate: the terms of
W_i - d/dq_i (what is found so far) are integrated over q_i, each of which may hold one power of q_i, one sine or one cosine of an
angle that grows with q_i at a constant rate.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from fractions import Fraction

from nhc.algebra.calculus import derivative, tangent
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.expand import Monomial, TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import split_parameters
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.solving.linear import linear_form
from nhc.algebra.terms import divide
from nhc.mechanics.rotations.turning import along
from nhc.mechanics.system import System

_TERMS = 200
"""Terms of a form that is integrated."""


def find_positions(system: System, forms: Sequence[Node]) -> None:
    """Keep the positions of forms that are rates of some, with those that the spec differentiated: of a form as it stands, and of
    what is left of it without its parameters.
    """
    if system.rotations or "found positions" in system.graph.off:
        return
    g, found = system.graph, dict[Node, Node]()
    seen: set[Node] = g.memory.setdefault("forms that positions were sought of", set())
    parameters, coordinates = g.mask(system.p), g.mask((*system.q, system.t))
    for form in forms:
        factor, rest = split_parameters(g, form, parameters)
        known = form in seen or any(x in g.rate_of for x in (form, g.neg(form), rest, g.neg(rest)))
        place = position_of(system, rest) if not known and g.depends(rest, coordinates) else None
        if place is not None:
            found.update({rest: place, form: g.mul(factor.node(g), place)})
    seen.update(forms)
    rates = tangent(g, [*found.values()], {**along(system, system.v), system.t: g.one})
    exact = are_zero(g, [g.sub(rate, form) for rate, form in zip(rates, found, strict=True)])
    for (form, place), same in zip(found.items(), exact, strict=True):
        if same:
            g.rate_of.setdefault(form, place)


def position_of(system: System, form: Node) -> Node | None:
    """What the form would be the rate of, if it is exact; None where it holds other terms than those above.

    What turns with the first coordinates comes first, as the links of a chain do, and on one body the arm of the first parameters:
    the components of a vector then have their arms in one order.
    """
    g, symbols = system.graph, (*system.q, system.t)
    found, place, done = list[Node](), g.zero, 0
    coefficients, constant = linear_form(g, form, system.v)
    with suppress(TooLarge):
        for symbol, coefficient in zip(symbols, (*coefficients, constant), strict=True):
            for monomial, c in polynomial(g, g.sub(coefficient, derivative(g, place, symbol)), _TERMS).items():
                term = _integral(g, monomial, symbol)
                # what is left of an exact form holds none of the coordinates before
                if term is None or any(g.deps[f] & done for f, _ in monomial):
                    return None
                found.append(g.mul_number(c, term))
            place = g.sum(found)
            done |= g.deps[symbol]
        return g.sum(sorted(found, key=lambda term: _rank(system, term)))
    return None


def _rank(system: System, term: Node) -> tuple[object, ...]:
    """The last coordinate of a term, its parameters, its number."""
    g, symbols = system.graph, (*system.q, system.t)
    factor, _ = split_parameters(g, term, g.mask(system.p))
    last = max(k for k, x in enumerate(symbols) if g.depends(term, g.deps[x]))
    return last, sorted(factor.powers.items()), factor.number


def _integral(graph: Graph, monomial: Monomial, symbol: Node) -> Node | None:
    """The integral of a product over one of its symbols."""
    g, own = graph, graph.deps[symbol]
    rest = tuple(power for power in monomial if not g.depends(power[0], own))
    moving = [power for power in monomial if power not in rest]
    if len(moving) > 1:
        return None
    ((factor, exponent),) = moving or [(symbol, 0)]
    if factor == symbol and exponent >= 0:
        return g.mul(to_node(g, {rest: Fraction(1, exponent + 1)}), g.power(symbol, exponent + 1))
    if g.op[factor] not in ("sin", "cos") or exponent != 1:
        return None
    angle = g.a[factor]
    slope = polynomial(g, derivative(g, angle, symbol), _TERMS)
    if len(slope) != 1:
        return None
    ((by, c),) = slope.items()
    left = divide({rest: Fraction(1)}, Fraction(c), by)  # w cos(w t) has no w left
    if left is None:
        return None
    turned = g.neg(g.function("cos", angle)) if g.op[factor] == "sin" else g.function("sin", angle)
    return g.mul(to_node(g, left), turned)
