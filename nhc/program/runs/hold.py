"""What brings a state back to its constraints: the shortest way in the metric of the kinetic energy.

``hold_v`` takes the velocities of the multiplier form to A v + a = 0, which it keeps only by its accelerations;
``hold_q`` takes the positions a Newton step towards f(q, t) = 0, which no form keeps by itself (E. Hairer and G.
Wanner, Solving Ordinary Differential Equations II, 2nd ed. (1996), sec. VII.2: projection methods).

The way is shortest among all displacements where the masses tell every displacement's length.  A coordinate without mass
that only the velocity rows hold has none, and the nearest state is not determined by it.  There ``hold_q`` goes where these rows
allow it, a d = 0: on what all the constraints leave free the masses of a well-posed system are regular.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import rank
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.associate import Equations
from nhc.mechanics.frame import form_value
from nhc.mechanics.properties.constancy import has_jumps
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import Form, System
from nhc.program.ir import Function, Hold
from nhc.program.plan import SolvePlan
from nhc.program.planning.planner import Planner

SINGULAR_HOLD = 3
SINGULAR = "the constraints, or the masses on them, are singular here, so that a state cannot be brought back"
TORN_HOLD = 90
TORN = (
    "a constraint jumps here, as a sign or the branch of an angle does, and no motion goes on beyond; "
    "write it without the jump"
)
STRAYED = "a step ends too far from the constraints to be brought back to the motion: it is too long"
_TOLERANCE = 1e-13
TURNS = 2  # Newton steps for positions: a step's drift is small, and each one squares it


def hold_functions(planner: Planner) -> tuple[tuple[Function, ...], tuple[tuple[str, ...], ...]]:
    """The functions, and the calls of a step in their order, each with what is called instead where it is singular; nothing
    where the formulation holds everything.
    """
    system = planner.system
    held = [form for form in system.constraints if form.equation is not None]
    functions: list[Function] = []
    calls: list[tuple[str, ...]] = []
    if held and {form.value for form in held} <= {rotation.growth for rotation in system.rotations}:
        functions.append(_normalise(planner))
        calls.append(("hold_q",))
    elif held:
        functions += _positions(planner, held)
        calls += [tuple(function.name for function in functions)] * TURNS
    if planner.equations.multipliers:
        right = [form_value(system, form) for form in system.constraints]
        about = "velocities on the constraints"
        functions.append(_function(planner, "hold_v", about, system.constraints, right, system.n))
        calls.append(("hold_v",))
    return tuple(functions), tuple(calls)


def make_hold(planner: Planner) -> Hold | None:
    """The same for a driver; None where its formulation holds everything."""
    functions, calls = hold_functions(planner)
    return Hold(functions, calls, SINGULAR_HOLD, SINGULAR, tell_torn(planner.system)) if calls else None


def tell_torn(system: System) -> str:
    """Why a step's end lies far from the constraints: only those that jump somewhere tear a motion."""
    forms = system.constraints
    nodes = [x for form in forms for x in (form.equation, *form.coefficients, form.constant) if x is not None]
    return TORN if has_jumps(system, nodes, openly=True) else STRAYED


def must_hold(equations: Equations) -> bool:
    """Whether a motion leaves its constraints by the errors of its steps; for the length of a quaternion that has no meaning."""
    growth = {rotation.growth for rotation in equations.system.rotations}
    held = {form.value for form in equations.system.constraints if form.equation is not None}
    return bool(equations.multipliers or held - growth)


def _positions(planner: Planner, held: Sequence[Form]) -> list[Function]:
    """``hold_q``, and ``hold_q_within`` for the places where the masses alone are singular."""
    system, zero = planner.system, planner.graph.zero
    about = "positions closer to the constraints"
    every = [zero if form.equation is None else form.equation for form in system.constraints]
    right = [form.equation for form in held if form.equation is not None]
    if len(held) == system.l:
        return [_function(planner, "hold_q", about, held, right, 0)]
    within = f"{about}, where the velocity rows allow it"
    if _has_massless(system):
        return [_function(planner, "hold_q", within, system.constraints, every, 0)]
    return [
        _function(planner, "hold_q", about, held, right, 0),
        _function(planner, "hold_q_within", within, system.constraints, every, 0),
    ]


def _has_massless(system: System) -> bool:
    """Whether some displacement, the growth of quaternions aside, has no mass anywhere."""
    g = system.graph
    momenta = gradient(g, system.T, system.v)
    rows = [gradient(g, p, system.v) for p in momenta]
    rows += [gradient(g, rotation.growth, system.v) for rotation in system.rotations]
    return rank(g, rows) < system.n


def _normalise(planner: Planner) -> Function:
    """y with quaternions of length 1: the model does not depend on their length, so nothing else moves."""
    system, g = planner.system, planner.graph
    state = [*system.q, *planner.equations.motion.w]
    scale = {}
    for rotation in system.rotations:
        length = g.function("sqrt", g.sum([g.power(e, 2) for e in rotation.e]))
        scale.update({k: g.inverse(length) for k in rotation.places})
    moved = [g.mul(node, scale[k]) if k in scale else node for k, node in enumerate(state)]
    return planner.lower_out("hold_q", "quaternions of length 1", moved)


def _function(
    planner: Planner, name: str, about: str, forms: Sequence[Form], right: Sequence[Node], first: int
) -> Function:
    """y with n entries from ``first`` on moved by d, where M d = A^T mu and A d = -right."""
    system, g, n = planner.system, planner.graph, planner.system.n
    motion = planner.equations.motion
    on = moving(system, motion.velocities)
    mass = [gradient(g, p, system.v) for p in gradient(g, system.T, system.v)]
    matrix = [[*mass[i], *(g.neg(form.coefficients[i]) for form in forms)] for i in range(n)]
    matrix += [[*(g.neg(a) for a in form.coefficients), *([g.zero] * len(forms))] for form in forms]
    flat = substitute(g, [*(x for row in matrix for x in row), *right], on)
    size = n + len(forms)
    rows = tuple(tuple(flat[k * size : (k + 1) * size]) for k in range(size))
    column = (*([g.zero] * n), *flat[size * size :])
    unknowns = tuple(g.symbol(f"{name}_{k}", "unknown") for k in range(size))
    solve = SolvePlan(rows, (column,), (unknowns,), _TOLERANCE, SINGULAR_HOLD, SINGULAR)
    state = [*system.q, *motion.w]
    for k in range(n):
        state[first + k] = g.add(state[first + k], unknowns[k])
    return planner.lower_out(name, about, state, solves=(solve,))
