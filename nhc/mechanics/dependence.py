"""What the rates of a state depend on, exactly: by values in a prime field, so that a dependence that cancels does not count.

One entry of the state is given another value at a random point; what changes depends on it.  Values and not slopes are compared,
because a sign depends on its argument although its slope is zero.  Where signs occur, also in the guise of roots, it is done at
more points: a sign stays the same at every second change, and others may hide it at every second point.
"""

from __future__ import annotations

import random
from collections.abc import Sequence

from nhc.algebra.graph import Node
from nhc.algebra.modular import FieldPoint, Unlucky
from nhc.algebra.primes import primes_of
from nhc.algebra.signs import Signs, may_hold, points_for
from nhc.mechanics.linearize import Flow, solve_modulo
from nhc.records import record

_POINTS, _DRAWS, _CHANGES = 2, 400, 60
_MOST_SIGNS = 4  # multiplied with each other: 384 points


@record
class Dependence:
    """``rates[j]`` are the entries of the state that y'_j depends on, ``needs[k]`` those of the k-th further quantity.

    ``still[j]``: y'_j vanishes identically, y_j is a constant of the motion; ``zero[k]`` likewise for the quantities.
    """

    rates: tuple[frozenset[int], ...]
    needs: tuple[frozenset[int], ...]
    still: tuple[bool, ...]
    zero: tuple[bool, ...]

    def closure(self, needs: Sequence[int]) -> frozenset[int]:
        """The entries that the given quantities depend on, directly or through the rates of other entries."""
        found = {j for k in needs for j in self.needs[k]}
        todo = sorted(found)
        while todo:
            new = self.rates[todo.pop()] - found
            found |= new
            todo += sorted(new)
        return frozenset(found)


def values_at(flow: Flow, needs: Sequence[Node], point: FieldPoint) -> list[int]:
    """Residues of all rates of the state, then of the needs (functions of the state, the rates and the multipliers).

    Raises:
        Unlucky: the motion is singular at this point.
    """
    size = len(flow.unknowns)
    flat = point.evaluate([*(x for row in flow.matrix for x in row), *flow.right])
    matrix = [flat[k * size : (k + 1) * size] for k in range(size)]
    right = [[x] for x in flat[size * size :]]
    solved = [row[0] for row in solve_modulo(matrix, right, point.prime)] if size else []
    found = point.evaluate([*flow.velocities, *needs], dict(zip(flow.unknowns, solved, strict=True)))
    n = len(flow.velocities)
    return [*found[:n], *solved[: flow.kept], *found[n:]]


def find_dependence(flow: Flow, needs: Sequence[Node]) -> Dependence:
    """Which entries of the state each rate and each need depends on.

    Missed with a probability of degree/p**2, and of e**-24 where signs occur.

    Raises:
        Unlucky: the motion is singular everywhere, or holds too many signs.
    """
    g, size, roots = flow.graph, len(flow.y), _roots(flow, needs)
    occurring = [any(g.depends(node, g.deps[y]) for node in roots) for y in flow.y]
    depends = [[False] * size for _ in range(size + len(needs))]
    zero = [True] * (size + len(needs))
    compared = [not found for found in occurring]
    seed, primes = 0, primes_of(g)
    for index in range(_count_points(flow, needs)):
        base, values, seed = _base(flow, needs, seed, primes[index % len(primes)])
        zero = [z and not value for z, value in zip(zero, values, strict=True)]
        for j in range(size):
            if not occurring[j]:
                continue
            changed = _changed(flow, needs, base, seed, j, values)
            compared[j] = compared[j] or bool(changed)
            for row, differs in zip(depends, changed, strict=bool(changed)):
                row[j] = row[j] or differs
    for j in range(size):
        if not compared[j]:  # no other regular value was found: nothing is known
            for row in depends:
                row[j] = True
    sets = [frozenset(j for j, found in enumerate(row) if found) for row in depends]
    return Dependence(tuple(sets[:size]), tuple(sets[size:]), tuple(zero[:size]), tuple(zero[size:]))


def _count_points(flow: Flow, needs: Sequence[Node]) -> int:
    g, roots = flow.graph, _roots(flow, needs)
    if not may_hold(g, roots):
        return _POINTS
    signs = Signs(g, roots, later=g.mask(flow.unknowns), changed=flow.y)
    signs.solve([x for row in flow.matrix for x in row], flow.right, flow.unknowns)
    degree = signs.degree([*flow.velocities, *flow.unknowns, *needs])
    if degree > _MOST_SIGNS:
        raise Unlucky
    return points_for(degree, _POINTS)


def _roots(flow: Flow, needs: Sequence[Node]) -> list[Node]:
    return [*flow.velocities, *needs, *(x for row in flow.matrix for x in row), *flow.right]


def _base(flow: Flow, needs: Sequence[Node], seed: int, prime: int) -> tuple[FieldPoint, list[int], int]:
    for draw in range(seed + 1, seed + 1 + _DRAWS):
        point = FieldPoint(flow.graph, 3_000_017 + draw, prime)
        try:
            point.prepare(_roots(flow, needs))
            return point, values_at(flow, needs, point), draw
        except Unlucky:
            continue
    raise Unlucky


def _changed(
    flow: Flow, needs: Sequence[Node], base: FieldPoint, seed: int, j: int, values: Sequence[int]
) -> list[bool]:
    """What has another value when y_j has; nothing where no other regular value is found."""
    g, prime = flow.graph, base.prime
    roots = _roots(flow, needs)
    mask = g.mask((flow.y[j], *flow.unknowns))
    carried = {node: value for node, value in base.values.items() if not g.depends(node, mask)}
    rng = random.Random(1_000_003 * seed + j)
    for _ in range(_CHANGES):
        point = FieldPoint(g, 3_000_017 + seed, prime)
        try:
            point.prepare(roots)
            point.values.update(carried)
            point.values[flow.y[j]] = rng.randrange(2, prime - 1)
            found = values_at(flow, needs, point)
        except Unlucky:
            continue
        return [x != y for x, y in zip(found, values, strict=True)]
    return []
