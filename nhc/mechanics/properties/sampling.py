"""Random points of a prime field that lie on the motion: admissible velocities, and the true accelerations and reactions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.algebra.dense import Singular, rank_modulo
from nhc.algebra.exact.draw import MOST_DRAWS, draw_points
from nhc.algebra.exact.modular import FieldPoint, Unlucky
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.graph import Node
from nhc.mechanics.certificates.claims import admissible_velocities, reference_claim, solve_exactly
from nhc.mechanics.formulate import rate_symbols
from nhc.mechanics.formulations.multipliers import multiplier_symbols
from nhc.mechanics.frame import Frame
from nhc.mechanics.properties.leaf import leaf_of
from nhc.mechanics.system import System

_RANK_POINTS = 4
_UNDETERMINED = 20
"""Points after which there is no motion at any: a determinant that is not zero vanishes at few points in 2^61."""


class Undetermined(Unlucky):
    """The equations have no solution at a point, or more than one."""


class Sampler:
    """Draws points on the motion, at positions that the constraints allow; parameters in ``zeroed`` are zero, all others random."""

    def __init__(self, system: System, frame: Frame | None, zeroed: Sequence[Node] = ()) -> None:
        self.system, self.zeroed = system, tuple(zeroed)
        self.reference = reference_claim(system)
        self.velocities = admissible_velocities(system, frame, [])
        self.rates = rate_symbols(system, system.v)
        self.multipliers = multiplier_symbols(system)
        self.leaf = leaf_of(system, [*self.velocities.nodes, *self.reference.nodes()])
        self.moving = system.graph.mask((*system.v, *self.rates, *self.multipliers))
        self.jumping: dict[Node, bool] = {}  # what was found of each: the energy is asked for as one of many things

    def residues(
        self, roots: Sequence[Node], count: int, prime: int, seed: int = 1, fixed: Mapping[Node, int] | None = None
    ) -> list[list[int]]:
        """The roots, which may contain q, q', q'', lambda and t, at ``count`` points; ``fixed`` are values of parameters.

        Raises:
            Unlucky: no regular point was found.
        """
        found: list[list[int]] = []
        undetermined = 0
        everything = [*self.velocities.nodes, *self.reference.nodes(), *roots]
        known = {**dict.fromkeys(self.zeroed, 0), **(fixed or {})}
        seeds = range(seed * 1_000_033, seed * 1_000_033 + MOST_DRAWS)
        for _, point in draw_points(
            self.system.graph, everything, prime, seeds, known, self.moving, settle=self.leaf.settling
        ):
            try:
                self.settle(point)
                found.append(point.evaluate(roots))
            except Unlucky as error:
                undetermined += isinstance(error, Undetermined)
                if undetermined == _UNDETERMINED and not found:
                    raise
                continue
            if len(found) == count:
                return found
        raise Unlucky

    def rank(self, rows: Sequence[Sequence[Node]]) -> int:
        """The generic rank of a matrix on the motion.

        Raises:
            Unlucky: no regular point was found.
        """
        prime, width = primes_of(self.system.graph)[0], len(rows[0])
        ranks = []
        for flat in self.residues([x for row in rows for x in row], _RANK_POINTS, prime, seed=3):
            matrix = [flat[k : k + width] for k in range(0, len(flat), width)]
            ranks.append(rank_modulo(matrix, prime))
        return max(ranks)

    def settle(self, point: FieldPoint) -> None:
        """Give the velocities, the accelerations and the multipliers their values at a point.

        Raises:
            Undetermined: there is no motion, or more than one.
            Unlucky: the point lies on a pole.
        """
        point.evaluate([], dict.fromkeys(self.zeroed, 0))
        self.leaf.settle(point)
        velocities = point.evaluate(self.velocities.nodes)
        point.evaluate([], dict(zip(self.velocities.symbols, velocities, strict=True)))
        try:
            accelerations, reactions = solve_exactly(self.reference, point)
        except Singular:
            raise Undetermined from None
        point.evaluate([], dict(zip((*self.rates, *self.multipliers), (*accelerations, *reactions), strict=True)))
