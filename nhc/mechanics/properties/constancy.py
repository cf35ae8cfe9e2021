"""Whether functions of the state are constant along the motion, and whether they jump: rates at points of a prime field."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from types import MappingProxyType

from nhc.algebra.bounds.interval import Interval
from nhc.algebra.bounds.jumps import TooLong, find_breaks
from nhc.algebra.bounds.jumps import jumps as find_jumps
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.signs import Signs, may_hold, points_for
from nhc.algebra.graph import Node
from nhc.algebra.walks import reachable
from nhc.mechanics.frame import total_derivative
from nhc.mechanics.properties.sampling import Sampler
from nhc.mechanics.system import System
from nhc.mechanics.values import scene_values

_OPEN = frozenset(("sign", "abs", "min", "max", "atan2", "atan", "asin", "acos", "tanh", "exp", "sinh", "cosh"))
_MOST_POINTS = 96  # modulo each of two primes, where signs occur
_DRAWN = 6  # sets of values that a spec may give its parameters elsewhere


def are_constant(sampler: Sampler, nodes: Sequence[Node]) -> list[bool]:
    """Zero rates at a point modulo each of two primes, and at more where signs occur; what holds too many is not constant."""
    rates = rates_of(sampler, nodes)
    primes = primes_of(sampler.system.graph)[:2]
    rows = [row for prime in primes for row in sampler.residues(rates, 1, prime)]
    alive = [k for k in range(len(rates)) if all(row[k] == 0 for row in rows)]
    degrees = _degrees_in_signs(sampler, [rates[k] for k in alive])
    needed = {k: points_for(degree, 0) // 2 for k, degree in zip(alive, degrees, strict=True)}
    alive = [k for k in alive if needed[k] <= _MOST_POINTS]
    each = max((needed[k] for k in alive), default=0)
    if each:
        chosen = [rates[k] for k in alive]
        rows = [row for prime in primes for row in sampler.residues(chosen, each, prime, seed=2)]
        alive = [k for i, k in enumerate(alive) if all(row[i] == 0 for row in rows)]
    return [k in alive for k in range(len(rates))]


def _degrees_in_signs(sampler: Sampler, rates: Sequence[Node]) -> list[int]:
    """Degrees of the rates in signs, on the motion."""
    system, reference = sampler.system, sampler.reference
    g = system.graph
    nodes = [*rates, *reference.nodes(), *sampler.velocities.nodes]
    if not rates or not may_hold(g, nodes):
        return [0] * len(rates)
    signs = Signs(g, nodes, sampler.settle, sampler.moving | g.mask((*sampler.zeroed, *sampler.leaf.solved)))
    signs.stand(sampler.velocities.standing())
    mask, solved = signs.solve([x for row in reference.matrix for x in row], reference.right)
    affine = [signs.mask_and_degree([*c, d]) for c, d in (*reference.accelerations, *reference.reactions)]
    for part, _ in affine:
        mask |= part
    degree = min(mask.bit_count(), solved + max((d for _, d in affine), default=0))
    signs.put((*sampler.rates, *sampler.multipliers), mask, degree)
    return [signs.degree([rate]) for rate in rates]


def rates_of(sampler: Sampler, nodes: Sequence[Node]) -> list[Node]:
    """d/dt of each, with the accelerations' symbols."""
    system = sampler.system
    moving = dict(zip(system.v, sampler.rates, strict=True))
    return [total_derivative(system, node, system.v, moving) for node in nodes]


def jumps(sampler: Sampler, node: Node) -> bool:
    """Whether the node, whose rate is zero, may change in steps along the motion, for the parameters' values in the spec or one of
    its scenes; also where that is too long to decide.

    Where it is continuous it cannot; nor can a sign, the branch of an angle or a quotient while what they are taken of is a
    constant of the motion.
    """
    if node not in sampler.jumping:
        sampler.jumping[node] = _jumps(sampler, node)
    return sampler.jumping[node]


def _jumps(sampler: Sampler, node: Node) -> bool:
    system, still = sampler.system, dict.fromkeys(sampler.zeroed, 0.0)
    given = [{p: x if x and math.isfinite(x) else 0.7 for p, x in values.items()} for values in scene_values(system)]
    moving = (*system.q, *system.v, system.t)
    try:
        return any(
            find_jumps(system.graph, node, moving, values | still, lambda inner: are_constant(sampler, [inner])[0])
            for values in given
        )
    except TooLong:
        return True


def has_jumps(
    system: System,
    nodes: Sequence[Node],
    *,
    undecided: bool = True,
    elsewhere: bool = False,
    openly: bool = False,
    ranges: Mapping[Node, Interval] = MappingProxyType({}),
) -> bool:
    """Whether one of the functions of (q, q', t) jumps somewhere, on a motion or not, for the parameters' values in the spec or one
    of its scenes; ``undecided`` where that takes too long.

    ``elsewhere``: for other values, too: of either sign, as somebody may give them to what was emitted.  ``openly``: square roots
    alone do not count, which change their branch where coordinates are singular (a wheel lies flat).  Coordinates that have
    ``ranges`` keep to them.
    """
    g, moving = system.graph, (*system.q, *system.v, system.t)
    if openly and not any(g.op[node] in _OPEN for node in reachable(g, nodes, g.mask(moving))):
        return False
    if not find_breaks(g, nodes, g.mask(moving)):
        return False
    rng, given = random.Random(23), scene_values(system)
    if elsewhere and system.p:
        given += [{p: rng.choice((-1.0, 1.0)) * rng.uniform(0.4, 1.6) for p in system.p} for _ in range(_DRAWN)]
    try:
        roots = dict.fromkeys(nodes)
        return any(
            find_jumps(g, node, moving, values, lambda inner: False, ranges) for values in given for node in roots
        )
    except TooLong:
        return undecided
