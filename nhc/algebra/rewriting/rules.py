"""The rewriting rules by name, and a graph on which some of them are not applied: to measure and to test what they do.

The graph goes through the whole compiler, so it carries the choice: ``resolve(spec, WithoutRules({"common factors"}))`` is
the system compiled without that rule.  nhc itself always applies all of them.
"""

from __future__ import annotations

from collections.abc import Iterable

from nhc.algebra.graph import Graph, Node
from nhc.records import record


@record
class Rule:
    """``about`` says what becomes what, ``where`` names the module that does it."""

    name: str
    about: str
    where: str


RULES = (
    Rule("common factors", "k P + l P becomes (k + l) P, for a factor P of both products", "algebra/graph.py"),
    Rule("cancelled terms", "x + (u - x) becomes u", "algebra/graph.py"),
    Rule("cancelled factors", "(u P^m) P^-n becomes u P^(m-n)", "algebra/graph.py"),
    Rule("circle", "k sin^2 a + k cos^2 a becomes k", "algebra/graph.py"),
    Rule(
        "canonical forms",
        "a short expression becomes a polynomial modulo sin^2 + cos^2 = 1 with common factors taken out, if that costs less",
        "algebra/rewriting/shorten.py",
    ),
    Rule(
        "divided sums",
        "x^2/(l^2 - x^2) + 1 becomes l^2/(l^2 - x^2): what stands above a fraction line is divided by the sum below it",
        "algebra/divided.py",
    ),
    Rule(
        "gathered sums",
        "a mass or speed that many products of a sum share is taken out of the sum; "
        "so is the direction along which a potential and another force act",
        "algebra/rewriting/gather.py",
    ),
    Rule(
        "Cramer's rule",
        "blocks of up to 3 constraints, and up to 4 that elimination leaves, are solved by determinants in canonical form",
        "algebra/solving/blocks.py",
    ),
    Rule(
        "orthonormal rows",
        "three velocities on the axes of a body, with factors in front or not, are solved for by the transpose of its matrix",
        "algebra/solving/orthonormal.py",
    ),
    Rule(
        "completed squares",
        "an energy that was multiplied out becomes squares of velocities of points and of angular velocities again",
        "mechanics/energies/squares.py",
    ),
    Rule(
        "found positions",
        "a velocity that was written out is the rate of the position that it integrates to, and the weight of its mass is at that",
        "mechanics/energies/positions.py",
    ),
    Rule(
        "moving axes",
        "velocities in T are written on axes that turn with a body, if constraints make them short there",
        "mechanics/moving/move.py",
    ),
    Rule(
        "body axes",
        "what constraints make of the velocities of a body with a rotation is read on its own axes: one row of the matrix is left",
        "mechanics/moving/on_body.py",
    ),
    Rule(
        "own axes",
        "bodies that stand on one another are written on the axes of the one that carries them or of each, not on those of space",
        "mechanics/trees/views.py",
    ),
    Rule(
        "leaning joints",
        "a turn and the constant lean of the joint behind it, in the same plane, become one turn by the sum of both angles",
        "mechanics/moving/askew.py",
    ),
    Rule(
        "trees",
        "accelerations of chains and trees are solved from the leaves to the root, not by L D L^T",
        "program/planning/mass_route.py",
    ),
    Rule(
        "composite inertias",
        "the matrix of a few bodies in space comes from what each carries, on its own axes, and the forces by recursion",
        "mechanics/trees/composite.py",
    ),
    Rule(
        "short rows",
        "a constraint that is long as it is written becomes a sum of velocities times their coefficients in canonical form",
        "mechanics/resolving/short_rows.py",
    ),
    Rule(
        "constant brackets",
        "of quasi-velocities whose brackets are numbers, rows are those of Poincaré and Hamel: no direction cosine is left in them",
        "mechanics/moving/structure.py",
    ),
    Rule(
        "uniform motion",
        "what constraints have beside velocities leaves equations that do not depend on it: a belt that moves uniformly",
        "mechanics/uniform.py",
    ),
    Rule(
        "detours",
        "equations in the rates of angles are solved for the rates of T's own angular velocities, then transformed back",
        "mechanics/detour.py",
    ),
    Rule(
        "directions",
        "where T does not depend on the direction from which angles are counted, it is counted from the first of them",
        "mechanics/invariant.py",
    ),
    Rule(
        "spherical tops",
        "the angular velocity of a body with three equal moments of inertia is solved for in space, and brought back to its axes",
        "mechanics/spherical_tops.py",
    ),
    Rule(
        "other axes",
        "an angular velocity is solved for on the axes on which quasi-velocities and constraints do not hold the orientation",
        "mechanics/rotations/other_axes.py",
    ),
    Rule(
        "short inverses",
        "pairs of rates whose determinant is short are solved for by Cramer's rule, a diagonal and a product v v^T by rank one",
        "program/planning/short_inverse.py",
    ),
    Rule(
        "order of pivots",
        "L D L^T takes rows with few entries first, if this creates fewer new entries",
        "program/plan.py",
    ),
    Rule(
        "still pivots",
        "behind a pivot that does not move, entries of L D L^T lose the angles that they do not depend on",
        "program/plan.py",
    ),
    Rule(
        "shared products",
        "pairs of factors that occur in several products are multiplied once; parameters are multiplied with one another first",
        "algebra/rewriting/products.py",
    ),
    Rule(
        "shared sums",
        "pairs of terms that occur in several sums are added or subtracted once",
        "algebra/rewriting/sums.py",
    ),
    Rule(
        "pieces",
        "in a spec that is large or contains numbers, expressions between shared nodes become canonical forms, if shorter",
        "algebra/rewriting/pieces.py",
    ),
    Rule(
        "joined angles",
        "cos a cos b + sin a sin b becomes cos(a - b), where fewer sines and cosines are called then",
        "algebra/rewriting/differences.py",
    ),
    Rule(
        "related angles",
        "sines and cosines of sums, differences and multiples of angles come from those of the angles, if these are needed anyway; "
        "those of arcs such as atan x take roots",
        "algebra/rewriting/related.py",
    ),
    Rule(
        "equal values",
        "expressions of equal or opposite value are computed once, however they were derived; so are products of such values",
        "algebra/rewriting/values.py",
    ),
    Rule(
        "shared powers",
        "x^12 is computed as (x^6)^2, x^6 as (x^3)^2, shared with other powers; 1/x^2 and 1/x^3 are powers of 1/x",
        "program/lowering/powers.py",
    ),
    Rule(
        "shared reciprocals",
        "several quotients by d become products with 1/d, which is computed once, in advance if d consists of parameters",
        "program/lowering/lower.py",
    ),
    Rule(
        "folded numbers",
        "2 (x y) becomes x' y where all that is used of x is x' = 2 x: so the 2 of a rotation's entries goes into 2/|q|^2",
        "algebra/rewriting/numbers.py",
    ),
)
NAMES = frozenset(rule.name for rule in RULES)


class WithoutRules(Graph):
    """A graph on which the rules named ``off`` are not applied.

    Raises:
        KeyError: there is no rule of that name.
    """

    def __init__(self, off: Iterable[str]) -> None:
        self.off = frozenset(off)
        unknown = self.off - NAMES
        if unknown:
            raise KeyError(f"no rule {', '.join(sorted(unknown))}; there are {', '.join(sorted(NAMES))}")
        super().__init__()

    def _common_factor(self, x: Node, y: Node, ux: Node, uy: Node) -> Node | None:
        return None if "common factors" in self.off else super()._common_factor(x, y, ux, uy)

    def _cancel_terms(self, x: Node, y: Node, total: Node) -> Node | None:
        return None if "cancelled terms" in self.off else super()._cancel_terms(x, y, total)

    def _cancel(self, product: Node, base: Node, exponent: int) -> Node | None:
        return None if "cancelled factors" in self.off else super()._cancel(product, base, exponent)

    def _is_circle(self, p: Node, q: Node) -> bool:
        return "circle" not in self.off and super()._is_circle(p, q)
