"""Sines and cosines of sums and multiples of coordinates in T, and T by those of the coordinates."""

from __future__ import annotations

from nhc.algebra.calculus import derivative
from nhc.algebra.graph import ADD, MUL, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable
from nhc.mechanics.system import System

_MOST = 4
"""Angles that are added in a sine that is taken apart."""


def sums_in_sines(system: System) -> dict[Node, dict[Node, int]]:
    """The sines and cosines in T of sums and multiples of coordinates: how many times each of these is in the angle."""
    g, found = system.graph, dict[Node, dict[Node, int]]()
    for node in reachable(g, [system.T]):
        if g.op[node] not in ("sin", "cos") or g.op[g.a[node]] not in (ADD, MUL):
            continue
        slopes = {x: g.value(derivative(g, g.a[node], x)) for x in system.q if g.depends(g.a[node], g.deps[x])}
        times = {x: int(slope) for x, slope in slopes.items() if slope is not None and slope == int(slope)}
        if len(times) == len(slopes) and 1 < sum(map(abs, times.values())) <= _MOST:
            found[node] = times
    return found


def are_products(system: System) -> bool:
    """Whether sines of T look as products of sines do that were written as sums: of 2 a, or of a + b beside a - b."""
    signs = dict[frozenset[Node], set[tuple[int, ...]]]()
    for times in sums_in_sines(system).values():
        if any(abs(n) > 1 for n in times.values()):
            return True
        first = next(iter(times.values()))
        signs.setdefault(frozenset(times), set()).add(tuple(first * n for n in times.values()))
    return any(len(found) > 1 for found in signs.values())


def take_apart(system: System, every: bool = False) -> Node:
    """T with sines and cosines of differences of two coordinates, or of ``every`` sum and multiple, by those of the coordinates."""
    g, mapping = system.graph, dict[Node, Node]()
    for node, times in sums_in_sines(system).items():
        (rest,) = substitute(g, [g.a[node]], dict.fromkeys(times, g.zero), named=False)
        if not every and (sorted(times.values()) != [-1, 1] or rest != g.zero):
            continue
        parts = [x if n > 0 else g.neg(x) for x, n in times.items() for _ in range(abs(n))]
        sine, cosine = g.zero, g.one
        for part in parts if rest == g.zero else (*parts, rest):
            s, c = g.function("sin", part), g.function("cos", part)
            sine, cosine = g.add(g.mul(sine, c), g.mul(cosine, s)), g.sub(g.mul(cosine, c), g.mul(sine, s))
        mapping[node] = sine if g.op[node] == "sin" else cosine
    return substitute(g, [system.T], mapping)[0]
