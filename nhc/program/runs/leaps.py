"""What a step must not leap over: arguments of functions that are short somewhere, or bend, along the motion of a step.

Adaptive steps see a force by its values at their stages.  Between two places where nothing happens they become long, and a bump in
the road, a thin wall or a body far away lies between the stages: the estimate of the error knows nothing of it.  The *argument* of
such a function is a slow function of time even where the function is not: ((x - 50)/w)^2 under an exponential, |x - 50| - w under a
maximum.  So a step is as long as the arguments at its ends and within it allow (``templates/c/methods/leaps.c.jinja``, and step for
step the same :mod:`nhc.simulate.stepping.leaping`): one that would pass by their special value, zero, is tried again with a quarter
of its length.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from nhc.algebra.bounds.interval import Interval, bounds, cannot_vanish
from nhc.algebra.graph import POW, SYM, Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.show import to_text
from nhc.algebra.walks import count, reachable
from nhc.mechanics.regular.regularity import intervals
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import System
from nhc.program.ir import CORNER, Leaps
from nhc.program.planning.base import PlannerBase
from nhc.program.runs.clock import CORNERS, HIGH, STEPS, list_reached

_GROWING = frozenset({"exp", "cosh", "sinh"})
_STEEP = _GROWING | STEPS  # beyond their arguments' zeros they are known: 0, 1 or negligible
_RELATIVE = frozenset({"sqrt", "powf", "log", POW})
_WIDE = 60  # characters of an argument that are shown
_RATE = "_dot"  # at the end of a label, after a definition's name: of its rate
_LARGE = 1000  # operations beyond which an argument is not followed
_MILD = 100.0  # how many times its least value an argument may be that has no narrow place
_TURN = 0.0, 1.0  # of the half turn at which an angle of two lengths jumps, on one side of its argument's zero
_BOUNDED, _NOUGHT = 1e100, Fraction(1, 10**30)
_FAR = 10**100  # from its special value: nothing comes of an argument beyond
_PARTS = {
    **dict.fromkeys(_RELATIVE, (1.5, 0.0)),
    **dict.fromkeys((*STEPS, "cosh", "sinh"), (0.75, 1.0)),
    **dict.fromkeys(CORNERS, CORNER),
    "atan2": _TURN,
    "exp": (1.5, 2.0),
}
"""The part of an argument by which it may change towards zero in a step, and by how much it always may.

A step towards a Gaussian leaves a quarter of the way to it or more, one away from it is at most three times as long as its way.
"""


def find_leaps(planner: PlannerBase, known: Mapping[Node, Interval] | None = None) -> Leaps | None:
    """The arguments that the steps of a planner's motion are watched by; None where the spec has nothing short.

    ``known``: intervals of symbols beside those of the spec, such as a scene's parameters.
    """
    found = find_functions(planner, known)
    if not found:
        return None
    nodes = [node for node, _ in found]
    function = planner.lower_out("places", "arguments that a step must not leap over", nodes)
    told = [_tell_held(planner.system, source) if part == CORNER else "" for (_, part), source in found.items()]
    return Leaps(function, tuple(part for _, part in found), tuple(told))


def find_functions(
    planner: PlannerBase, known: Mapping[Node, Interval] | None = None
) -> dict[tuple[Node, tuple[float, float]], Node]:
    """The functions of the system that are short somewhere or bend, by their arguments on the motion and what
    :class:`nhc.program.ir.Leaps` says of them, in its order.
    """
    system, g = planner.system, planner.graph
    moved = (system.t, *system.q, *system.v)
    held = {g.sum([g.power(e, 2) for e in rotation.e]) for rotation in system.rotations}  # to 1, after each step
    wanted, ranges = dict[tuple[Node, tuple[float, float]], Node](), {**intervals(system), **(known or {})}
    values = {symbol: ranges[symbol] for symbol in system.p if symbol in ranges}
    for node in list_reached(system, moved):
        op = g.op[node]
        if g.a[node] in held:
            continue
        part, high = _PARTS.get(op), _as_exponential(g, node, values)
        if high is not None:
            wanted[high, _PARTS["exp"]] = node
        if part is None or (op == POW and g.b[node] > 0) or (op in _RELATIVE and not _is_plain(g, g.a[node], moved)):
            continue
        argument = _argument(g, node)
        key = (argument, part) if (g.neg(argument), part) not in wanted else (g.neg(argument), part)
        if key not in wanted or op == "sign":  # of all that bend there it alone may hold a motion
            wanted[key] = node
    if not wanted:
        return {}
    on = moving(system, planner.full_equations.motion.velocities)
    nodes = substitute(g, substitute(g, [argument for argument, _ in wanted], on), planner.put_in)
    kept = ~g.mask((*planner.state_loads,))
    found = dict[tuple[Node, tuple[float, float]], Node]()
    for node, ((_, part), source) in zip(nodes, wanted.items(), strict=True):
        told = not g.deps[node] & kept and not planner.is_constant(node) and count(g, [node]) <= _LARGE
        if told and not _is_mild(g, node, part, ranges):
            found[_bounded(g, node), part] = source
    return found


def _argument(graph: Graph, node: Node) -> Node:
    """What a function is of; of the lesser or larger of two, their difference."""
    return graph.sub(graph.a[node], graph.b[node]) if graph.op[node] in ("min", "max") else graph.a[node]


def name_argument(system: System, function: Node) -> str:
    """The argument of a function in the spec's words, or a root itself: a velocity's name, a definition's, or what it is."""
    g = system.graph
    node = function if g.op[function] == "sqrt" else _argument(g, function)
    named = {form.value: form.name for form in system.quasi}
    for rotation, spec in zip(system.rotations, system.spec.rotations, strict=True):
        named |= dict(zip(rotation.omega, spec.velocities, strict=True))
    name = named.get(node, g.labels.get(node, "") if g.op[node] != SYM else "")
    if name.endswith(_RATE) and name.removesuffix(_RATE) in g.labels.values():
        return f"{name.removesuffix(_RATE)}'"
    return name or to_text(g, node, _WIDE)


def _tell_held(system: System, function: Node) -> str:
    """What it means that the motion cannot leave the zero of a function's argument."""
    where = f"`{name_argument(system, function)}` is zero"
    return (
        f"the motion is held where {where}, as dry friction holds what sticks: the forces jump there, and drive it back from "
        "either side. `nhc run` goes on where the force acts along what it holds; else `tanh(v/eps)` in place of `sign(v)` does, "
        "or a constraint from here on"
    )


def _as_exponential(graph: Graph, node: Node, values: Mapping[Node, Interval]) -> Node | None:
    """The exponent of a high power of what has bounds wherever it is, such as sin(x)^1000, written as an exponential: zero at its
    peaks.  ``values``: of the parameters.
    """
    g = graph
    power = g.b[node] if g.op[node] == POW else g.value(g.b[node]) if g.op[node] == "powf" else None
    if power is None or power < HIGH:
        return None
    most = max(map(abs, bounds(g, g.a[node], values)))
    if not 0.0 < most < _BOUNDED:
        return None
    part = g.power(g.div(g.a[node], g.number(Fraction(most))), 2)
    return g.mul(g.number(Fraction(power) / 2), g.function("log", g.add(part, g.number(_NOUGHT))))


def _bounded(graph: Graph, node: Node) -> Node:
    """The argument within what doubles hold: one that grows like an exponential may be infinite far from where it matters."""
    if all(graph.op[child] not in _GROWING for child in reachable(graph, [node])):
        return node
    far = graph.number(_FAR)
    return graph.function("max", graph.function("min", node, far), graph.neg(far))


def _is_plain(graph: Graph, node: Node, moved: tuple[Node, ...]) -> bool:
    """Whether it moves by anything but steep functions, whose own arguments say where it does."""
    within = graph.mask(moved)
    steep = {child for child in reachable(graph, [node], within) if graph.op[child] in _STEEP}
    return any(child in moved for child in reachable(graph, [node], within, known=steep))


def _is_mild(graph: Graph, node: Node, part: tuple[float, float], ranges: Mapping[Node, Interval]) -> bool:
    """Whether the argument comes nowhere near its special value."""
    if part[0] == 0.0:
        return cannot_vanish(graph, node, ranges)
    low, high = bounds(graph, node, ranges)
    if part[1] > 0.0:
        return high - low < part[1]
    return low > 0.0 and high < _MILD * low
