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
    Rule(
        "common factors", "k P + l P becomes (k + l) P, for a factor P that stands in both products", "algebra/graph.py"
    ),
    Rule("cancelled terms", "x + (u - x) becomes u", "algebra/graph.py"),
    Rule("cancelled factors", "(u P^m) P^-n becomes u P^(m-n)", "algebra/graph.py"),
    Rule("circle", "k sin^2 a + k cos^2 a becomes k", "algebra/graph.py"),
    Rule(
        "canonical forms",
        "what is short becomes a polynomial modulo sin^2 + cos^2 = 1 with common factors taken out, where that costs less",
        "algebra/rewriting/shorten.py",
    ),
    Rule(
        "gathered sums",
        "a sum of products over the same mass and speed has them in front once",
        "algebra/rewriting/gather.py",
    ),
    Rule(
        "Cramer's rule",
        "blocks of up to 3 constraints are solved by determinants in canonical form, not by elimination",
        "algebra/solving/blocks.py",
    ),
    Rule(
        "completed squares",
        "an energy that was multiplied out becomes squares of velocities of points and of angular velocities again",
        "mechanics/squares.py",
    ),
    Rule(
        "moving axes",
        "vectors of T stand on axes that move, where constraints make them short",
        "mechanics/moving/move.py",
    ),
    Rule(
        "leaning joints",
        "a turn before a joint that leans by a constant angle goes by the sum of both angles, and the lean is gone",
        "mechanics/moving/askew.py",
    ),
    Rule(
        "trees",
        "accelerations of chains and trees from the leaves to the root, not by L D L^T",
        "program/mass_route.py",
    ),
    Rule(
        "detours",
        "Lagrange's equations are solved for the rates of T's own angular velocities, and these turned back",
        "mechanics/detour.py",
    ),
    Rule(
        "order of pivots",
        "L D L^T takes rows with few entries first, where fewer entries arise on the way",
        "program/plan.py",
    ),
    Rule(
        "still pivots",
        "behind a pivot that does not move, entries of L D L^T lose the angles that they do not depend on",
        "program/plan.py",
    ),
    Rule(
        "shared products",
        "pairs of factors that stand in several products are multiplied once; parameters stand together in front",
        "algebra/rewriting/products.py",
    ),
    Rule(
        "pieces",
        "where a spec has numbers, or is large, the trees between shared nodes become canonical forms over these, if shorter",
        "algebra/rewriting/pieces.py",
    ),
    Rule(
        "related angles",
        "sines and cosines of sums, differences and multiples of angles at hand come from theirs",
        "algebra/rewriting/related.py",
    ),
    Rule(
        "equal values",
        "nodes of one value, or of opposite ones, become one, however they were made; so do products of values at hand",
        "algebra/rewriting/values.py",
    ),
    Rule(
        "shared powers",
        "x^12 is (x^6)^2, x^6 is (x^3)^2, together with whatever else needs them; 1/x^2 and 1/x^3 are powers of 1/x",
        "program/powers.py",
    ),
    Rule("shared reciprocals", "x / d is x times 1/d, computed once; 1/d of parameters first", "program/lower.py"),
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
