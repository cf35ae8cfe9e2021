"""A tree that a few constraints hold: solved as if it were free, then with the reactions that bring it back.

With M q'' = f + A^T lambda and A q'' = -A' q' - a', the free tree is solved once for f and once for each row of A, and lambda from

    (A M^-1 A^T) lambda = -(A' q' + a') - A M^-1 f,

a small matrix, positive where the constraints are independent.  The cost is that of the tree, times one and the number of rows.

What is light without the constraints and is carried by them (a rod without mass at the end of a chain that hangs at both ends) has
large answers there, whose difference is the small one that is looked for: a mass of 1e-8 costs eight digits, none at all has no
pivot.  Such a tree is left to the dense way, whose matrix is that of the motions that the constraints allow.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import substitute
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.mechanics.associate import Equations
from nhc.mechanics.frame import form_value, total_derivative
from nhc.mechanics.motion import Motion
from nhc.mechanics.regular.given_rank import given_states
from nhc.mechanics.system import Form, System
from nhc.mechanics.trees.choice import tree_of
from nhc.mechanics.trees.tree import Elimination
from nhc.mechanics.values import scene_values
from nhc.mechanics.whole_forms import whole_kinetic
from nhc.program.plan import factor, solve_factored
from nhc.records import record

KEPT = 1e-3
"""Of a pivot's entry: what must be left of it at some state, for the parameters' values in the spec and in each scene."""

Pivots = list[tuple[Node, Node]]


@record
class HeldTree:
    """Rates of the kept velocities; (pivot, scale) pairs that must not vanish: of the free tree, and of the reactions' matrix."""

    rates: list[Node]
    pivots: Pivots
    held: Pivots


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
    accelerations, held = _held(equations, tree)
    if not _keeps_digits(system, tree.pivots, held):
        return None
    rates = dict(zip(system.v, accelerations, strict=True))
    found = [total_derivative(system, form_value(system, form), system.v, rates) for form in kept]
    pivots = [node for pair in (*tree.pivots, *held) for node in pair]
    on_motion = dict(zip(system.v, motion.velocities, strict=True))
    made = substitute(g, [*found, *pivots], on_motion)
    flat = made[len(found) :]
    pairs = list(zip(flat[::2], flat[1::2], strict=True))
    return HeldTree(made[: len(found)], pairs[: len(tree.pivots)], pairs[len(tree.pivots) :])


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


def _held(equations: Equations, tree: Elimination) -> tuple[list[Node], Pivots]:
    """q'' in terms of (q, q', t), and the pivots of the reactions' matrix."""
    system = equations.system
    g, still = system.graph, {v: system.graph.zero for v in system.v}
    rows = [form.coefficients for form in system.constraints]
    answers = [tree.solve(row) for row in rows]
    matrix = [[g.dot(row, answer) for answer in answers] for row in rows]
    right = []
    for form, row in zip(system.constraints, rows, strict=True):
        moved = total_derivative(system, form_value(system, form), system.v, still)
        right.append(g.neg(g.add(moved, g.dot(row, tree.rates))))
    factors = factor(g, matrix)
    reactions = solve_factored(g, factors, right)
    columns = zip(tree.rates, *answers, strict=True)
    accelerations = [g.sum([a, *(g.mul(x, y) for x, y in zip(reactions, ys, strict=True))]) for a, *ys in columns]
    return accelerations, [(d, matrix[k][k]) for k, d in zip(factors.order, factors.pivots, strict=True)]
