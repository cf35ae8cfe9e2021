"""A tree that a few constraints hold: solved as if it were free, then with the reactions that bring it back.

With M q'' = f + A^T lambda and A q'' = -A' q' - a', the free tree is solved once for f and once for each row of A, and lambda from

    (A M^-1 A^T) lambda = -(A' q' + a') - A M^-1 f,

a small matrix, positive where the constraints are independent.  The cost is that of the tree, times one and the number of rows.

What is light without the constraints and is carried by them (a rod without mass at the end of a chain that hangs at both ends) has
large answers there, whose difference is the small one that is looked for: a mass of 1e-8 costs eight digits, none at all has no
pivot.  Such a tree is left to the dense way, whose matrix is that of the motions that the constraints allow.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.associate import Equations
from nhc.mechanics.energies.whole_forms import whole_kinetic
from nhc.mechanics.frame import form_value, total_derivative
from nhc.mechanics.motion import Motion
from nhc.mechanics.regular.given_rank import given_states
from nhc.mechanics.system import Form, System
from nhc.mechanics.trees.choice import tree_of
from nhc.mechanics.trees.tree import Elimination
from nhc.mechanics.values import scene_values
from nhc.program.plan import factor, solve_factored
from nhc.records import record

KEPT = 1e-3
"""Of a pivot's entry: what must be left of it at some state, for the parameters' values in the spec and in each scene."""

Pivots = list[tuple[Node, Node]]


@record
class HeldTree:
    """Rates of the kept velocities; (pivot, scale) pairs that must not vanish: of the free tree, and of the reactions' matrix.

    ``solve(right)`` is x with M x = right, M the mass matrix of the kept velocities.
    """

    rates: list[Node]
    pivots: Pivots
    held: Pivots
    solve: Callable[[Sequence[Node]], list[Node]]


def held_tree(equations: Equations, kept: Sequence[Form]) -> HeldTree | None:
    """The rates of the ``kept`` forms; None where T is not positive without the constraints, or light."""
    system, motion = equations.system, equations.motion
    g = system.graph
    if system.rotations:
        return None
    kinetic = whole_kinetic(system)
    if kinetic is None or not kinetic.is_positive():
        return None
    beside = [a for form in system.constraints for a in form.coefficients]
    tree = tree_of(system, Motion(system.v, (), system.v, ()), kinetic, beside)
    if tree is None:
        return None
    holding = _Holding(equations, tree)
    if not _keeps_digits(system, tree.pivots, holding.pivots):
        return None
    rates = dict(zip(system.v, holding.accelerations(), strict=True))
    found = [total_derivative(system, form_value(system, form), system.v, rates) for form in kept]
    pivots = [node for pair in (*tree.pivots, *holding.pivots) for node in pair]
    on_motion = dict(zip(system.v, motion.velocities, strict=True))
    made = substitute(g, [*found, *pivots], on_motion)
    flat = made[len(found) :]
    pairs = list(zip(flat[::2], flat[1::2], strict=True))

    def solve(right: Sequence[Node]) -> list[Node]:
        force = [g.dot([form.coefficients[i] for form in kept], right) for i in range(len(system.v))]
        answer = holding.hold(tree.solve(force), [g.zero] * len(system.constraints))
        return substitute(g, [g.dot(form.coefficients, answer) for form in kept], on_motion)

    return HeldTree(made[: len(found)], pairs[: len(tree.pivots)], pairs[len(tree.pivots) :], solve)


def _keeps_digits(system: System, pivots: Pivots, held: Pivots) -> bool:
    """Whether for each of the given values of the parameters there is a state at which the pivots keep KEPT of their entries."""
    flat = [node for pair in (*pivots, *held) for node in pair]
    for values in scene_values(system):
        best = -1.0
        for state in given_states(system):
            try:
                found = [float(x) for x in evaluate(system.graph, flat, {**state, **values})]
            except (ArithmeticError, ValueError):
                continue
            free, bound = found[: 2 * len(pivots)], found[2 * len(pivots) :]
            if min(free[::2]) > 0.0:
                best = max(best, min(x / scale if scale > 0.0 else -1.0 for x, scale in _pairs(bound)))
        if best < KEPT:
            return False
    return True


def _pairs(flat: Sequence[float]) -> list[tuple[float, float]]:
    return list(zip(flat[::2], flat[1::2], strict=True))


class _Holding:
    """What the constraints do to a free tree: the answers to their rows, and the matrix A M^-1 A^T of the reactions."""

    def __init__(self, equations: Equations, tree: Elimination) -> None:
        self.system, self.tree = equations.system, tree
        g = self.system.graph
        self._rows = [form.coefficients for form in self.system.constraints]
        self._answers = [tree.solve(row) for row in self._rows]
        matrix = [[g.dot(row, answer) for answer in self._answers] for row in self._rows]
        self._factors = factor(g, matrix)
        self.pivots = [(d, matrix[k][k]) for k, d in zip(self._factors.order, self._factors.pivots, strict=True)]

    def accelerations(self) -> list[Node]:
        """q'' in terms of (q, q', t)."""
        system = self.system
        still = {v: system.graph.zero for v in system.v}
        moved = [total_derivative(system, form_value(system, form), system.v, still) for form in system.constraints]
        return self.hold(self.tree.rates, moved)

    def hold(self, free: Sequence[Node], moved: Sequence[Node]) -> list[Node]:
        """The free tree's answer, brought back to A x + moved = 0."""
        g = self.system.graph
        right = [g.neg(g.add(own, g.dot(row, free))) for own, row in zip(moved, self._rows, strict=True)]
        reactions = solve_factored(g, self._factors, right)
        columns = zip(free, *self._answers, strict=True)
        return [g.sum([x, *(g.mul(r, y) for r, y in zip(reactions, ys, strict=True))]) for x, *ys in columns]
