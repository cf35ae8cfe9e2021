"""Dry friction that sticks: where it holds a velocity at zero, a run goes on with that as one more constraint, or two in a plane.

A force c sign(v) that acts along the constraint, Q_i = -c sign(v) dv/dq'_i, is at rest any Q_i = -s c dv/dq'_i with -1 <= s <= 1
(Coulomb's law; Filippov 1988, sec. 4).  That is the reaction of v = 0, lambda dv/dq'_i with lambda = -s c, as long as that is no
larger.  In a plane the force is -c (v dv/dq'_i + w dw/dq'_i)/sqrt(v^2 + w^2), and at rest the reactions of v = 0 and w = 0 are
together no larger than c.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import Singular
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import POW, Graph, Node
from nhc.algebra.polynomial import normalise
from nhc.algebra.reading import Reading
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form, solve
from nhc.algebra.walks import count, reachable
from nhc.mechanics.associate import Equations
from nhc.mechanics.system import Form, System
from nhc.records import record

RUNS = "`nhc run` goes on from there: dry friction holds it, or it slips"
SIGN, ROOT = "sign", "sqrt"
_TERMS = 60  # of a friction's size, up to which it is brought to its canonical form


@record
class Friction:
    """``function`` is sign(v), or sqrt(v^2 + w^2) of what slips in a plane; ``forms`` are the constraints, ``size`` is c > 0.

    ``values`` stand for the parts of c, with opposite signs, that the reactions are, in what is computed of them.
    """

    function: Node
    forms: tuple[Form, ...]
    size: Node
    values: tuple[Node, ...]


def find_friction(system: System, function: Node) -> Friction | None:
    """The friction of sign(v), or of a root of squares; None where that is none along what it would hold."""
    g = system.graph
    slips = _list_slips(g, function)
    elsewhere = [system.T, system.U, *(x for form in system.constraints for x in (*form.coefficients, form.constant))]
    if not slips or function in reachable(g, elsewhere):
        return None
    try:
        forms = [linear_form(g, slip, system.v) for slip in slips]
    except NotLinear:
        return None
    none, one, two = (_with(system, function, g.number(value)) for value in (0, 1, 2))
    if g.op[function] == ROOT and function in reachable(g, one):
        return None
    pulls = [g.sub(a, b) for a, b in zip(one, none, strict=True)]  # -c sum of s_j dv_j/dq'
    more = [g.sub(g.add(a, b), g.add(c, c)) for a, b, c in zip(none, two, one, strict=True)]
    parts = [g.one] if g.op[function] == SIGN else slips
    along = [g.sum([g.mul(s, form[0][i]) for s, form in zip(parts, forms, strict=True)]) for i in range(system.n)]
    square = g.dot(along, along)
    if not all(are_zero(g, more)) or is_zero(g, square):
        return None
    single = [g.div(pull, a) for pull, a in zip(pulls, along, strict=True) if not is_zero(g, a)]
    ratios = [normalise(g, ratio, _TERMS) for ratio in (g.div(g.dot(pulls, along), square), *single)]
    whole = min(ratios, key=lambda ratio: count(g, [ratio]))  # what is longer may have a zero of its own below its line
    if not all(are_zero(g, [g.sub(pull, g.mul(whole, a)) for pull, a in zip(pulls, along, strict=True)])):
        return None
    names = [f"held{function}" + "_" * k for k in range(len(slips))]
    made = [Form(name, *form, "", None, slip) for name, form, slip in zip(names, forms, slips, strict=True)]
    return Friction(function, tuple(made), g.neg(whole), tuple(g.symbol(name, "friction") for name in names))


def is_at_rest(system: System, node: Node, values: Mapping[Node, float]) -> bool:
    """Whether one over a root has no value at a state since friction in a plane may hold what would slip there."""
    g = system.graph
    friction = find_friction(system, g.a[node]) if g.op[node] == POW and g.op[g.a[node]] == ROOT else None
    slips = [form.value for form in friction.forms if form.value is not None] if friction is not None else []
    return bool(slips) and not any(evaluate(g, slips, values))


def _list_slips(graph: Graph, function: Node) -> list[Node]:
    """What a function would hold: v of sign(v), v and w of sqrt(v^2 + w^2)."""
    g = graph
    if g.op[function] == SIGN:
        return [g.a[function]]
    if g.op[function] != ROOT:
        return []
    terms = [node for _, node in Reading(g).terms(g.a[function])]
    return [g.a[node] for node in terms] if all(g.op[node] == POW and g.b[node] == 2 for node in terms) else []


def _with(system: System, function: Node, value: Node) -> list[Node]:
    """Q with a value in place of sign(v), or of 1/sqrt(v^2 + w^2)."""
    return substitute(system.graph, system.Q, _in_place(system, function, value))


def _in_place(system: System, function: Node, value: Node) -> dict[Node, Node]:
    """A value in place of sign(v), and what follows from that of sign(k v) with a number k; or of what is one over a root."""
    g = system.graph
    if g.op[function] == ROOT:
        return {g.power(function, -1): value}
    found = {function: value}
    for node in reachable(g, system.Q):
        if g.op[node] == SIGN and node != function:
            ratio = g.value(normalise(g, g.div(g.a[node], g.a[function]), _TERMS))
            if ratio is not None:
                found[node] = value if ratio > 0 else g.neg(value)
    return found


def list_signs(system: System, friction: Friction) -> set[Node]:
    """The functions that a friction has in it: sign(v) and all sign(k v) with numbers k, or one root."""
    return set(_in_place(system, friction.function, system.graph.zero))


def hold(system: System, friction: Friction, follows: bool = False) -> System:
    """The system without the friction in its forces, and with what is held as its last constraints, unless it follows from others.

    Raises:
        nhc.algebra.dense.Singular: an output has a direction of what does not slip, in another way than friction has.
    """
    g = system.graph
    out = _in_place(system, friction.function, g.zero)
    torques = [tuple(substitute(g, three, out)) for three in system.torques]
    return replace(
        system,
        Q=tuple(substitute(g, system.Q, out)),
        torques=tuple((a, b, c) for a, b, c in torques),
        constraints=system.constraints if follows else (*system.constraints, *friction.forms),
        outputs=tuple((name, tell(system, friction, node)) for name, node in system.outputs),
        dependent=(),
        pulls=None,
        given=None,
    )


def tell(system: System, friction: Friction, output: Node) -> Node:
    """An output, or an event, with the friction's values in it.

    Raises:
        nhc.algebra.dense.Singular: it has a direction of what does not slip, in another way than friction has.
    """
    g, function = system.graph, friction.function
    if g.op[function] == SIGN:
        return substitute(g, [output], _in_place(system, function, friction.values[0]))[0]
    none, one, two = (substitute(g, [output], _in_place(system, function, g.number(value)))[0] for value in (0, 1, 2))
    pull = g.sub(one, none)
    if pull == g.zero:
        return output
    # pull = sum of k_j v_j: its slopes are sums of k_j dv_j/dq'
    rows = [form.coefficients for form in friction.forms]
    slopes = gradient(g, pull, system.v)
    matrix = [[g.dot(a, b) for b in rows] for a in rows]
    parts = solve(g, matrix, [[g.dot(a, slopes) for a in rows]]).unknowns[0]
    values = [form.value for form in friction.forms if form.value is not None]
    left = g.sub(pull, g.dot(parts, values))
    if not all(are_zero(g, [left, g.sub(g.add(none, two), g.add(one, one))])):
        raise Singular
    return g.add(none, g.dot(parts, friction.values))


def let_idle(equations: Equations) -> System | None:
    """The system without the frictions of what the constraints hold at zero by themselves, which are taken to give nothing; None
    where there are none.
    """
    system, g = equations.system, equations.system.graph
    on = dict(zip(system.v, equations.motion.velocities, strict=True))
    inside = reachable(g, system.Q)
    found = {node: g.a[node] for node in inside if g.op[node] == SIGN}
    found |= {node: g.a[g.a[node]] for node in inside if g.op[node] == POW and g.op[g.a[node]] == ROOT}
    still = are_zero(g, substitute(g, list(found.values()), on))
    out = {node: g.zero for node, idle in zip(found, still, strict=True) if idle}
    return replace(system, Q=tuple(substitute(g, system.Q, out))) if out else None
