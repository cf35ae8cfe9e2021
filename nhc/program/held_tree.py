"""A tree that a few constraints hold: solved as if it were free, then with the reactions that bring it back.

With M q'' = f + A^T lambda and A q'' = -A' q' - a', the free tree is solved once for f and once for each row of A, and lambda from

    (A M^-1 A^T) lambda = -(A' q' + a') - A M^-1 f,

a small matrix, positive where the constraints are independent.  The cost is that of the tree, times one and the number of rows.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import substitute
from nhc.algebra.graph import Node
from nhc.mechanics.associate import Equations
from nhc.mechanics.frame import form_value, total_derivative
from nhc.mechanics.motion import Motion
from nhc.mechanics.system import Form
from nhc.mechanics.tree import Elimination
from nhc.mechanics.tree_choice import FEW, tree_of
from nhc.mechanics.whole_forms import whole_kinetic
from nhc.program.plan import factor, solve_factored
from nhc.records import record


@record
class HeldTree:
    """Rates of the kept velocities; (pivot, scale) pairs that must not vanish."""

    rates: list[Node]
    pivots: list[tuple[Node, Node]]


def held_tree(equations: Equations, kept: Sequence[Form]) -> HeldTree | None:
    """The rates of the ``kept`` forms; None where T is not positive without the constraints, or these leave few rates."""
    system, motion = equations.system, equations.motion
    g, free = system.graph, len(motion.w)
    if not 0 < 2 * system.l <= free or free <= FEW:
        return None
    kinetic = whole_kinetic(system)
    if kinetic is None or not kinetic.is_positive():
        return None
    beside = [a for form in system.constraints for a in form.coefficients]
    tree = tree_of(system, Motion(system.v, (), system.v, ()), kinetic, beside)
    if tree is None:
        return None
    accelerations, scales = _held(equations, tree)
    rates = dict(zip(system.v, accelerations, strict=True))
    found = [total_derivative(system, form_value(g, form, system.v), system.v, rates) for form in kept]
    pivots = [node for pair in scales for node in pair]
    on_motion = dict(zip(system.v, motion.velocities, strict=True))
    made = substitute(g, [*found, *pivots], on_motion)
    flat = made[len(found) :]
    return HeldTree(made[: len(found)], list(zip(flat[::2], flat[1::2], strict=True)))


def _held(equations: Equations, tree: Elimination) -> tuple[list[Node], list[tuple[Node, Node]]]:
    """q'' in terms of (q, q', t), and all pivots."""
    system = equations.system
    g, still = system.graph, {v: system.graph.zero for v in system.v}
    rows = [form.coefficients for form in system.constraints]
    answers = [tree.solve(row) for row in rows]
    matrix = [[g.dot(row, answer) for answer in answers] for row in rows]
    right = []
    for form, row in zip(system.constraints, rows, strict=True):
        moved = total_derivative(system, form_value(g, form, system.v), system.v, still)
        right.append(g.neg(g.add(moved, g.dot(row, tree.rates))))
    factors = factor(g, matrix)
    reactions = solve_factored(g, factors, right)
    columns = zip(tree.rates, *answers, strict=True)
    accelerations = [g.sum([a, *(g.mul(x, y) for x, y in zip(reactions, ys, strict=True))]) for a, *ys in columns]
    return accelerations, tree.pivots + [(d, matrix[k][k]) for k, d in enumerate(factors.pivots)]
