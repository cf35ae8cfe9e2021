"""Dry friction that sticks: where sign(v) in the forces holds v at zero, the run goes on with v = 0 as one more constraint.

A force c sign(v) that acts along the constraint, Q_i = -c sign(v) dv/dq'_i, is at rest any Q_i = -s c dv/dq'_i with -1 <= s <= 1
(Coulomb's law; Filippov 1988, sec. 4).  That is the reaction of v = 0, lambda dv/dq'_i with lambda = -s c, as long as that is no
larger.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.algebra.walks import count, reachable
from nhc.mechanics.associate import Equations
from nhc.mechanics.system import Form, System
from nhc.program.planning.planner import Planner
from nhc.program.runs.needed import reactions_of
from nhc.records import record

_TERMS = 60  # of a friction's size, up to which it is brought to its canonical form

_MARGIN = Fraction(
    1, 10**9
)  # by which lambda^2 is more than c^2 where it breaks loose, so that it does not stick again at once


@record
class Friction:
    """``function`` is sign(v), ``form`` the constraint v = 0, ``size`` c > 0; ``value`` stands for s in what is computed of it."""

    function: Node
    form: Form
    size: Node
    value: Node


def list_releases(planner: Planner, frictions: Sequence[Friction]) -> list[Node]:
    """Values that are positive while friction holds; ``frictions`` are the last constraints of the planner's system."""
    g, (reactions, sizes) = planner.graph, _reactions(planner, frictions)
    most = g.number(1 + _MARGIN)
    return [
        g.sub(g.mul(most, g.power(size, 2)), g.power(reaction, 2))
        for reaction, size in zip(reactions, sizes, strict=True)
    ]


def put_values(planner: Planner, frictions: Sequence[Friction], nodes: Sequence[Node]) -> list[Node]:
    """Nodes on the motion with s by the reactions in place of each ``value``."""
    if not frictions:
        return list(nodes)
    g, (reactions, sizes) = planner.graph, _reactions(planner, frictions)
    found = {
        friction.value: g.neg(g.div(reaction, size))
        for friction, reaction, size in zip(frictions, reactions, sizes, strict=True)
    }
    return substitute(g, nodes, found)


def _reactions(planner: Planner, frictions: Sequence[Friction]) -> tuple[list[Node], list[Node]]:
    if not frictions:
        return [], []
    return reactions_of(planner)[-len(frictions) :], planner.on_motion([friction.size for friction in frictions])


def find_friction(system: System, function: Node) -> Friction | None:
    """sign(v) as a constraint v = 0, with the force that it is worth along that; None where it is none."""
    g = system.graph
    if g.op[function] != "sign":
        return None
    slip = g.a[function]
    try:
        coefficients, constant = linear_form(g, slip, system.v)
    except NotLinear:
        return None
    elsewhere = [system.T, system.U, *(x for form in system.constraints for x in (*form.coefficients, form.constant))]
    if function in reachable(g, elsewhere):
        return None
    ahead, behind, still = (_with(system, function, g.number(sign)) for sign in (1, -1, 0))
    jumps = [g.sub(a, b) for a, b in zip(ahead, behind, strict=True)]  # -2 c dv/dq'
    sums = [g.sub(g.add(a, b), g.add(c, c)) for a, b, c in zip(ahead, behind, still, strict=True)]
    square = g.dot(coefficients, coefficients)
    if not all(are_zero(g, sums)) or is_zero(g, square):
        return None
    single = [g.div(jump, a) for jump, a in zip(jumps, coefficients, strict=True) if not is_zero(g, a)]
    ratios = [normalise(g, ratio, _TERMS) for ratio in (g.div(g.dot(jumps, coefficients), square), *single)]
    whole = min(ratios, key=lambda ratio: count(g, [ratio]))  # what is longer may have a zero of its own below its line
    if not all(are_zero(g, [g.sub(jump, g.mul(whole, a)) for jump, a in zip(jumps, coefficients, strict=True)])):
        return None
    size = g.mul(g.number(Fraction(-1, 2)), whole)
    form = Form(f"held{function}", coefficients, constant, "", None, slip)
    return Friction(function, form, size, g.symbol(f"friction {function}", "friction"))


def _with(system: System, function: Node, value: Node) -> list[Node]:
    """Q with a value in place of sign(v)."""
    return substitute(system.graph, system.Q, _in_place(system, function, value))


def _in_place(system: System, function: Node, value: Node) -> dict[Node, Node]:
    """A value in place of sign(v), and what follows from that of sign(k v) with a number k."""
    g, found = system.graph, {function: value}
    for node in reachable(g, system.Q):
        if g.op[node] == "sign" and node != function:
            ratio = g.value(normalise(g, g.div(g.a[node], g.a[function]), _TERMS))
            if ratio is not None:
                found[node] = value if ratio > 0 else g.neg(value)
    return found


def hold(system: System, friction: Friction) -> System:
    """The system with v = 0 as its last constraint, and without sign(v) in its forces."""
    g = system.graph
    out = _in_place(system, friction.function, g.zero)
    told = substitute(g, [node for _, node in system.outputs], _in_place(system, friction.function, friction.value))
    names = [name for name, _ in system.outputs]
    torques = [tuple(substitute(g, three, out)) for three in system.torques]
    return replace(
        system,
        Q=tuple(substitute(g, system.Q, out)),
        torques=tuple((a, b, c) for a, b, c in torques),
        constraints=(*system.constraints, friction.form),
        outputs=tuple(zip(names, told, strict=True)),
        dependent=(),
        pulls=None,
        given=None,
    )


def let_idle(equations: Equations) -> System | None:
    """The system without the frictions of what the constraints hold at zero by themselves, which are taken to give nothing; None
    where there are none.
    """
    system, g = equations.system, equations.system.graph
    on = dict(zip(system.v, equations.motion.velocities, strict=True))
    signs = [node for node in reachable(g, system.Q) if g.op[node] == "sign"]
    still = are_zero(g, substitute(g, [g.a[node] for node in signs], on))
    out = {node: g.zero for node, idle in zip(signs, still, strict=True) if idle}
    return replace(system, Q=tuple(substitute(g, system.Q, out))) if out else None
