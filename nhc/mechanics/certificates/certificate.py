"""The agreement certificate: all formulations that apply predict the same accelerations and reactions, decided exactly.

At random points of a prime field, with velocities that satisfy the constraints, the linear system of every formulation is
solved modulo the prime and its q'' and lambda are compared with those of the reference, d'Alembert's equations with
multipliers taken straight from T (I.4.1).  Where a formulation differs from the reference as rational functions of degree d,
one point shows it except with probability d/p (Schwartz 1980, Zippel 1979), or 1 - 2**-k where k signs are multiplied with
each other (then more points are taken); points multiply.  ``simplify`` plays no part.  The same systems are solved in double
precision, and so are the derivations of :mod:`nhc.mechanics.certificates.wrong`, whose distance from the truth is measured.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence

from nhc.algebra.dense import Singular
from nhc.algebra.exact.degree import Degrees
from nhc.algebra.exact.draw import MOST_DRAWS, draw_points
from nhc.algebra.exact.modular import FieldPoint, Unlucky
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.signs import Signs, may_hold, points_for
from nhc.algebra.graph import Graph, Node
from nhc.algebra.walks import reachable
from nhc.mechanics.associate import Equations
from nhc.mechanics.certificates.claims import (
    Claim,
    Velocities,
    Wrong,
    admissible_velocities,
    formulation_claim,
    reference_claim,
    solve_exactly,
    wrong_claims,
)
from nhc.mechanics.certificates.distances import Distance, measure, states_of
from nhc.mechanics.choosing.choose import Formulation, applicable
from nhc.mechanics.energies.kinetic import kinetic_structure
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import Frame, coordinate_frame
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.system import System
from nhc.records import record

POINTS = 3
_FEW_POINTS, _MOST_POINTS = 64, 3072
"""Where signs occur; more than a few of them as long as so many nodes are not exceeded."""
_MOST_WORK = 600_000
SURE = -9.0
"""log10 of a probability that leaves no doubt."""
_ROUNDING = 1e-15
_CLEAR = 10.0
"""Times the rounding: a distance that is no rounding."""


@record
class Agreement:
    """One formulation beside the reference; ``distance`` is the double-precision difference."""

    name: str
    number: str
    accelerations: bool
    reactions: bool
    distance: Distance


@record
class Rejection:
    """A wrong derivation; ``told_apart`` if its accelerations differ in the exact test (None: it determines none)."""

    name: str
    erratum: str
    about: str
    told_apart: bool | None
    distance: Distance


@record
class Point:
    """A place in a prime field; ``seed`` draws it again, ``digest`` is the hash of the reference's q'' and lambda there."""

    prime: int
    seed: int
    digest: str


@record
class Certificate:
    """What was compared, where, and what came out; ``degree`` is d of the bound, ``states`` how many double-precision states.

    ``signs``: so many are multiplied with each other (abs, sign, min, max, and roots of what may be squares); each is right by
    chance at every second point.
    """

    system: str
    seed: int
    points: tuple[Point, ...]
    degree: int
    signs: int
    states: int
    agreements: tuple[Agreement, ...]
    rejections: tuple[Rejection, ...]

    @property
    def holds(self) -> bool:
        """Whether every formulation agrees exactly in accelerations and reactions."""
        return all(a.accelerations and a.reactions for a in self.agreements)

    def is_far(self, rejection: Rejection) -> bool:
        """Whether double precision shows a wrong derivation's distance: by more than rounding parts the right ones."""
        rounding = max([_ROUNDING, *(a.distance.accelerations for a in self.agreements)])
        return rejection.distance.accelerations > _CLEAR * rounding

    @property
    def signed(self) -> bool:
        """Whether signs occur."""
        return self.signs > 0

    @property
    def is_sure(self) -> bool:
        """Whether no difference can have passed; signs that are multiplied may hide one at nearly every point."""
        return self.log10_bound <= SURE

    @property
    def log10_bound(self) -> float:
        """log10 of the probability that two different derivations pass."""
        return log10_of_passing(self.degree, self.signs, [point.prime for point in self.points])


def log10_of_passing(degree: int, signs: int, primes: Sequence[int]) -> float:
    """log10 of the probability that a difference passes points modulo these primes: the product of d/p over them."""
    least = math.log1p(-(2.0**-signs)) / math.log(10) if signs else -math.inf
    logs = [math.log10(max(1, degree)) - math.log10(prime) for prime in primes]
    return sum(min(0.0, max(least, x)) for x in logs)


Derived = Sequence[tuple[Formulation, Equations]]


def derive_all(system: System) -> Derived:
    """The equations of every formulation that applies."""
    kinetic = kinetic_structure(system)
    return [(formulation, equations_of(system, formulation, kinetic)) for formulation in applicable(system)]


def certify(system: System, points: int = POINTS, seed: int = 1, derived: Derived | None = None) -> Certificate:
    """Compare every formulation that applies; ``derived`` are their equations where they are known.

    Raises:
        nhc.algebra.exact.modular.Unlucky: no regular point was found in the field.
    """
    derived = derive_all(system) if derived is None else derived
    formulations = [formulation for formulation, _ in derived]
    reference = reference_claim(system)
    claims = [formulation_claim(equations) for _, equations in derived]
    wrongs = wrong_claims(system, formulations)
    base = _base_frame(system, [f.frame for f in formulations if f.name == "voronec"])
    velocities = admissible_velocities(system, base, formulations)
    signs = _count_signs(system, [reference, *claims], velocities)
    nodes = [*(n for claim in (reference, *claims) for n in claim.nodes()), *velocities.nodes]
    needed = count_points(system.graph, nodes, signs, points)
    seen = list[_Look]()
    apart: list[list[bool | None]] = [[] for _ in wrongs]
    for k in range(needed):
        left = [i for i, found in enumerate(apart) if k < points or True not in found]
        seen.append(_Look(reference, claims, [wrongs[i] for i in left], velocities, system, k, seed))
        for i, found in zip(left, seen[-1].apart, strict=True):
            apart[i].append(found)
    states = states_of(system, velocities, reference)
    return Certificate(
        system=system.name,
        seed=seed,
        points=tuple(look.point for look in seen),
        degree=_degree(system, reference, claims, velocities),
        signs=signs,
        states=len(states),
        agreements=tuple(
            Agreement(
                claim.name,
                claim.number,
                all(look.equal[k][0] for look in seen),
                all(look.equal[k][1] for look in seen),
                measure(system, claim, states),
            )
            for k, claim in enumerate(claims)
        ),
        rejections=tuple(
            Rejection(
                one.claim.name,
                one.erratum,
                one.about,
                _any(apart[k]),
                measure(system, one.claim, states),
            )
            for k, one in enumerate(wrongs)
        ),
    )


def _count_signs(system: System, claims: Sequence[Claim], velocities: Velocities) -> int:
    """The degree in signs of the accelerations and reactions, on the motion."""
    g = system.graph
    nodes = [*(n for claim in claims for n in claim.nodes()), *velocities.nodes]
    if not may_hold(g, nodes):
        return 0

    def settle(point: FieldPoint) -> None:
        values = point.evaluate(velocities.nodes)
        point.evaluate([], dict(zip(velocities.symbols, values, strict=True)))

    signs = Signs(g, nodes, settle, g.mask(velocities.symbols))
    signs.stand(velocities.standing())
    every, degree = 0, 0
    for claim in claims:
        mask, solved = signs.solve([x for row in claim.matrix for x in row], claim.right)
        for coefficients, constant in (*claim.accelerations, *claim.reactions):
            outer, factor = signs.mask_and_degree(coefficients)
            own, alone = signs.mask_and_degree([constant])
            degree = max(degree, alone, solved + factor)
            mask |= outer | own
        every |= mask
    return min(degree, every.bit_count())


def count_points(graph: Graph, nodes: Sequence[Node], signs: int, points: int) -> int:
    """How many points are looked at: ``points``, or as many as signs need and can be afforded."""
    affordable = max(_FEW_POINTS, min(_MOST_POINTS, _MOST_WORK // len(reachable(graph, nodes))))
    return max(points, min(affordable, points_for(signs, points)))


def _base_frame(system: System, known: Sequence[Frame | None]) -> Frame | None:
    """The frame whose free velocities are drawn: the one of the reduced formulations, where there is one."""
    if not system.constraints:
        return None
    if known and known[0] is not None:
        return known[0]
    return coordinate_frame(system, choose_dependent(system).dependent)


def _any(found: Sequence[bool | None]) -> bool | None:
    known = [x for x in found if x is not None]
    return any(known) if known else None


class _Look:
    """All claims at one random point: ``equal[k]`` = (accelerations, reactions), ``apart[k]`` for the wrong ones."""

    def __init__(
        self,
        reference: Claim,
        claims: Sequence[Claim],
        wrongs: Sequence[Wrong],
        velocities: Velocities,
        system: System,
        index: int,
        seed: int,
    ) -> None:
        primes = primes_of(system.graph)
        prime = primes[index % len(primes)]
        everything = [n for c in (reference, *claims, *(w.claim for w in wrongs)) for n in c.nodes()]
        start = (seed * 1009 + index) * 100_003
        moving = system.graph.mask(velocities.symbols)
        nodes = [*velocities.nodes, *everything]
        for self.seed, point in draw_points(system.graph, nodes, prime, range(start, start + MOST_DRAWS), later=moving):
            try:
                values = point.evaluate(velocities.nodes)
                point.evaluate([], dict(zip(velocities.symbols, values, strict=True)))
                truth = solve_exactly(reference, point)
                found = [solve_exactly(claim, point) for claim in claims]
                self.apart = [_differs(one.claim, point, truth[0]) for one in wrongs]
            except (Unlucky, Singular):
                continue
            self.equal = [(q == truth[0], r == truth[1]) for q, r in found]
            text = ",".join(str(x) for x in (*truth[0], *truth[1]))
            self.point = Point(prime, self.seed, hashlib.sha256(text.encode()).hexdigest())
            return
        raise Unlucky


def _differs(claim: Claim, point: FieldPoint, truth: Sequence[int]) -> bool | None:
    """Whether a wrong claim's accelerations differ at the point; None where it determines none."""
    try:
        return solve_exactly(claim, point)[0] != list(truth)
    except Singular:
        return None


def _degree(system: System, reference: Claim, claims: Sequence[Claim], velocities: Velocities) -> int:
    """d of the bound: a difference of two solutions by Cramer's rule has numerator and denominator of no larger degree."""
    nodes = [n for claim in (reference, *claims) for n in claim.nodes()]
    degrees = Degrees(system.graph, nodes, velocities.standing())
    own = [_claim_degree(claim, degrees) for claim in claims]
    return degrees.inflate(_claim_degree(reference, degrees) + max(own))


def _claim_degree(claim: Claim, degrees: Degrees) -> int:
    """Degree of q'' and lambda as quotients: the determinant row by row, then the affine map to the outputs."""
    rows = [degrees.over_common([*row, b]) for row, b in zip(claim.matrix, claim.right, strict=True)]
    outputs = [degrees.over_common([*c, d]) for c, d in (*claim.accelerations, *claim.reactions)]
    return 2 * sum(rows) + max(outputs, default=0)
