"""Whether functions of the state are constant along the motion, and whether they jump: rates at points of a prime field."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import reachable
from nhc.algebra.field import INVERSE
from nhc.algebra.graph import POW, Node
from nhc.algebra.primes import primes_of
from nhc.algebra.signs import Signs, may_hold, points_for
from nhc.mechanics.frame import total_derivative
from nhc.mechanics.sampling import Sampler

_MOST_POINTS = 96  # modulo each of two primes, where signs occur
_BREAKS = ("sign", "atan2", "powf", "log")  # not continuous, or not everywhere; reciprocals too


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
    signs = Signs(g, nodes, sampler.settle, sampler.moving | g.mask(sampler.zeroed))
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
    """Whether the node, whose rate is zero, may change in steps.

    Where it is continuous it cannot; nor can a sign, the branch of an angle or the denominator's sign, while what they are taken
    of is a constant of the motion.
    """
    system = sampler.system
    g = system.graph
    moving = g.mask((*system.q, *system.v, system.t))
    inner = reachable(g, [node], moving)
    breaks = [n for n in inner if g.op[n] in _BREAKS or (g.op[n] == POW and g.b[n] < 0)]
    if _all_constant(sampler, [x for n in breaks for x in g.children(n)], moving):
        return False
    signs = Signs(g, [node])
    signs.degree([node])
    arguments = [x for group in signs.arguments for x in group]
    arguments += [x for n in inner if g.op[n] in INVERSE for x in g.children(n)]
    return not _all_constant(sampler, arguments, moving)


def _all_constant(sampler: Sampler, nodes: Sequence[Node], moving: int) -> bool:
    open_ = [x for x in dict.fromkeys(nodes) if sampler.system.graph.depends(x, moving)]
    return not open_ or all(are_constant(sampler, open_))
