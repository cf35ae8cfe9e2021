"""Antiderivatives of the constraints' terms: a combination of constraints that is closed has a sum of them for its integral.

Of sum_j a_j dq_j + a_0 dt each coefficient is multiplied out, and each product is integrated by its own differential.  Where the
form is closed these are the terms of its potential, up to numbers, which the search for integrals finds.
"""

from __future__ import annotations

from collections.abc import Iterator

from nhc.algebra.calculus import tangent
from nhc.algebra.expand import Monomial, TooLarge
from nhc.algebra.graph import POW, Graph, Node
from nhc.algebra.polynomial import normalise, polynomial
from nhc.mechanics.system import System

_MOST = 40  # terms of a coefficient
_HIGHEST = 6  # power of a sine times a cosine, or of a coordinate before a function
_SIGNLESS = {"sin": "cos", "cos": "sin", "sinh": "cosh", "cosh": "sinh", "exp": "exp"}  # up to a sign, integrals


def find_primitives(system: System) -> list[Node]:
    """Antiderivatives of all terms, up to numbers, where they are elementary at once; each once, in the constraints' order.

    Where an antiderivative has several terms, each stands by itself.
    """
    g, found = system.graph, list[Node]()
    for form in system.constraints:
        for x, a in zip((*system.q, system.t), (*form.coefficients, form.constant), strict=True):
            try:
                terms = polynomial(g, a, _MOST, circle=False)
            except TooLarge:
                continue
            found += [node for term in terms for node in integrate(g, term, x)]
    return list(dict.fromkeys(found))


def integrate(g: Graph, term: Monomial, x: Node) -> Iterator[Node]:
    """The terms of the integral of the product by x, up to numbers; those of its first rule that applies."""
    bases = [(g.a[node], g.b[node] * power) if g.op[node] == POW else (node, power) for node, power in term]
    inside = [(node, power) for node, power in bases if g.depends(node, g.deps[x])]
    outside = g.product([g.power(node, power) for node, power in term if not g.depends(node, g.deps[x])])
    if not inside:
        yield g.mul(outside, x)
        return
    for rule in (_substitute, _by_parts, _by_waves, _by_squares, _by_angles):
        found = list(rule(g, inside, x))
        if found:
            yield from (g.mul(normalise(g, g.mul(outside, factor), _MOST), node) for factor, node in found)
            return


_Factors = list[tuple[Node, int]]
"""Factors with x and their powers."""
_Terms = Iterator[tuple[Node, Node]]
"""Factors without x, and functions of x."""


def _substitute(g: Graph, inside: _Factors, x: Node) -> _Terms:
    """The rest of the product is the rate of one of its factors, or of its argument, up to what is free of x: f' f^p, f' sin f."""
    for k, (node, power) in enumerate(inside):
        rest = g.product([g.power(*other) for i, other in enumerate(inside) if i != k])
        if g.op[node] in _SIGNLESS and power == 1:
            ratio = _ratio(g, rest, g.a[node], x)
            if ratio is not None:
                yield ratio, g.function(_SIGNLESS[g.op[node]], g.a[node])
                return
        if g.op[node] == "tanh" and power == 1 and (ratio := _ratio(g, rest, g.a[node], x)) is not None:
            yield ratio, g.function("log", g.function("cosh", g.a[node]))
            return
        root = g.op[node] == "sqrt"  # a power of its half, of what is under it
        base = g.a[node] if root else node
        ratio = _ratio(g, rest, base, x)
        if ratio is None:
            continue
        raised = power + (2 if root else 1)
        # the logarithm has a value on either side of 0
        yield ratio, g.power(node, raised) if raised else g.function("log", g.function("abs", base))
        return


def _ratio(g: Graph, rest: Node, inner: Node, x: Node) -> Node | None:
    """The rest over the rate of the inner function, up to a number, where that is free of x."""
    (rate,) = tangent(g, [inner], {x: g.one})
    if rate == g.zero:
        return None
    if g.split_coefficient(rate)[1] == g.split_coefficient(rest)[1]:
        return g.one  # up to a number; exp(x)/exp(x) would stay as it is
    ratio = normalise(g, g.div(rest, rate), _MOST)
    return None if g.depends(ratio, g.deps[x]) else ratio


def _by_parts(g: Graph, inside: _Factors, x: Node) -> _Terms:
    """x^k f(r x + s): terms x^j f and x^j F, with 1/r once for every integration."""
    powers = dict(inside)
    highest = powers.pop(x, 0)
    if len(powers) != 1 or not 0 < highest <= _HIGHEST:
        return
    ((node, power),) = powers.items()
    ratio = _ratio(g, g.one, g.a[node], x) if g.op[node] in _SIGNLESS and power == 1 else None
    if ratio is None:
        return
    for k in range(highest + 1):
        for name in dict.fromkeys((g.op[node], _SIGNLESS[g.op[node]])):
            yield g.power(ratio, highest - k + 1), g.mul(g.power(x, k), g.function(name, g.a[node]))


def _by_waves(g: Graph, inside: _Factors, x: Node) -> _Terms:
    """sin^a cos^b of one angle r x + s: their products of degree a + b and of two, four, ... less, and x."""
    angles = {g.a[node] for node, _ in inside if g.op[node] in ("sin", "cos")}
    degree = sum(power for _, power in inside)
    plain = all(g.op[node] in ("sin", "cos") and power > 0 for node, power in inside)
    if not plain or len(angles) != 1 or degree > _HIGHEST:
        return
    (angle,) = angles
    ratio = _ratio(g, g.one, angle, x)
    if ratio is None:
        return
    sine, cosine = g.function("sin", angle), g.function("cos", angle)
    if degree % 2 == 0:
        yield g.one, x
    for size in range(degree, 0, -2):
        yield from ((ratio, g.mul(g.power(sine, k), g.power(cosine, size - k))) for k in range(size + 1))


def _by_squares(g: Graph, inside: _Factors, x: Node) -> _Terms:
    """1/Q, and 1/sqrt(Q), of Q = a x^2 + b x + c with numbers: arc tangents and sines, and logarithms."""
    if len(inside) != 1 or inside[0][1] != -1:
        return
    ((base, _),) = inside
    root = g.op[base] == "sqrt"
    square = g.a[base] if root else base
    (rate,) = tangent(g, [square], {x: g.one})
    (curvature,) = tangent(g, [rate], {x: g.one})
    twice = g.value(curvature)
    size = g.value(normalise(g, g.sub(g.mul_number(2, g.mul(curvature, square)), g.mul(rate, rate)), _MOST))
    if not twice or not size:
        return
    width = g.function("sqrt", g.number(abs(size)))  # size = 4 a c - b^2
    if root:
        lead = g.function("sqrt", g.number(abs(twice) / 2))
        if twice > 0:
            inner = g.add(g.mul(g.mul_number(2, lead), base), rate)
            made = g.function("log", g.function("abs", g.split_coefficient(inner)[1]))
        elif size < 0:
            made = g.function("asin", normalise(g, g.div(rate, width), _MOST))
        else:
            return  # without a real value
        yield g.inverse(lead), made
    elif size > 0:
        yield g.inverse(width), g.function("atan", normalise(g, g.div(rate, width), _MOST))
    else:
        ends = (normalise(g, g.sub(rate, width), _MOST), normalise(g, g.add(rate, width), _MOST))
        for end in ends:
            yield g.inverse(width), g.function("log", g.function("abs", g.split_coefficient(end)[1]))


def _by_angles(g: Graph, inside: _Factors, x: Node) -> _Terms:
    """1/sin, 1/cos and 1/sin^2, 1/cos^2 of r x + s: of loxodromes."""
    if len(inside) != 1 or g.op[inside[0][0]] not in ("sin", "cos") or inside[0][1] not in (-1, -2):
        return
    ((node, power),) = inside
    angle = g.a[node]
    ratio = _ratio(g, g.one, angle, x)
    if ratio is None:
        return
    sine, cosine = g.function("sin", angle), g.function("cos", angle)
    if power == -2:
        yield ratio, g.div(cosine, sine) if node == sine else g.div(sine, cosine)
        return
    other = cosine if node == sine else sine  # tan(angle/2) without halves: (1 - cos)/sin
    yield ratio, g.function("log", g.function("abs", g.div(g.sub(g.one, other), node)))
