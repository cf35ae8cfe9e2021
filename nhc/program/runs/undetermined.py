"""What keeps a scene from running at its start, and what to do about it."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nhc.algebra.dense import Singular, solve_double
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.diagnostics import quote
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.regular.given_rank import find_dependent_row
from nhc.mechanics.regular.undefined import find_pole, find_undefined
from nhc.mechanics.starts.scenes import Start, kept_velocities, left_at_zero
from nhc.program.planning.planner import Planner

Told = tuple[str, tuple[str, ...], tuple[str, ...]]
"""A message, notes and help."""
_NOTHING: tuple[str, tuple[str, ...]] = ("", ())


def explain_start(
    equations: Equations, formulation: Formulation, start: Start
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Notes and help on a scene that fails at its start, as `nhc check` has them; empty where it says nothing."""
    told = tell_undetermined(Planner(equations, formulation), start)
    from nhc.program.runs.friction import RUNS  # here: commands that do without it start sooner

    return ((), ()) if told is None else (told[1], tuple(help for help in told[2] if help != RUNS))


def tell_undetermined(planner: Planner, start: Start) -> Told | None:
    """What keeps a scene from running at its start, with notes and help; None where nothing does."""
    system, values = planner.system, start.values(planner.system)
    nodes = [system.T, *(a for form in system.constraints for a in form.coefficients)]
    what, zero = _find_dependent(planner, start)
    if not what:
        what, zero = find_undetermined(planner, start)
    part = None
    if not what:
        what, part = find_undefined(system, values)
    if not what:
        what, _, part = find_pole(system, values)
    if not what:
        return None
    held: tuple[str, ...] = ()
    if part is not None:
        from nhc.program.runs.friction import RUNS, is_at_rest  # here: commands that do without it start sooner

        if is_at_rest(system, part, values):
            return f"emitted functions refuse the start of the scene `{start.scene.name}`: {what} there", (), (RUNS,)
        nodes, held = [part], _held_by(planner, part)
    notes, help = _advise(planner, start, nodes, zero, held)
    message = f"the scene `{start.scene.name}` cannot run: {what} at its start"
    return message, notes, (help, *_advise_flat(planner, values))


def _advise_flat(planner: Planner, values: dict[Node, float]) -> tuple[str, ...]:
    """Help where the slopes of a holonomic equation vanish at a state that satisfies it, as those of a square do everywhere."""
    form = find_dependent_row(planner.system, values)
    if form is None or form.equation is None or any(evaluate(planner.graph, form.coefficients, values)):
        return ()
    return (f"if the slopes of `{form.name}` vanish wherever it holds, write `x = y` for `(x - y)^2 = 0`",)


def _advise(
    planner: Planner, start: Start, nodes: Sequence[Node], zero: Sequence[str], held: Sequence[str]
) -> tuple[tuple[str, ...], str]:
    """Notes and help on a scene that cannot run: by the parameters that are zero, by those alone that an expression without a value
    depends on, or by the coordinates in the nodes whose start was left out.
    """
    names, where = quote(zero or held), "under `parameters:` or in the scene"
    if zero:
        return (f"{names} {'is' if len(zero) == 1 else 'are'} zero there",), f"give {names} a value, {where}"
    if held:
        value = "another value" if len(held) == 1 else "other values"
        return ("no start changes this: it depends on parameters alone",), f"give {names} {value}, {where}"
    left = left_at_zero(planner.system, start.scene, start.values(planner.system), nodes)
    if left:
        return (f"{left} at 0, since `initial` does not give a value",), f"say in `initial` where {left}"
    return (), "let it start elsewhere"


def _held_by(planner: Planner, node: Node) -> tuple[str, ...]:
    """The parameters of an expression that depends on nothing else; empty where it varies with the state or the time."""
    g, system = planner.graph, planner.system
    if g.depends(node, g.mask((system.t, *system.q, *system.v))):
        return ()
    named = zip(system.p, system.spec.parameters, strict=True)
    return tuple(parameter.name for symbol, parameter in named if g.depends(node, g.deps[symbol]))


def tell_needed(planner: Planner, start: Start) -> Told | None:
    """A needed output without a value at a scene's start, with notes and help; None where all have one."""
    system, values = planner.system, start.values(planner.system)
    outputs = dict(system.outputs)
    for need in start.scene.need:
        what, part = find_undefined(system, values, [outputs[need.name]]) if need.name in outputs else ("", None)
        if part is None:
            continue
        from nhc.program.runs.friction import is_at_rest  # here: commands that do without it start sooner

        if is_at_rest(system, part, values):
            continue
        notes, help = _advise(planner, start, [part], (), _held_by(planner, part))
        message = f"the scene `{start.scene.name}` needs `{need.name}`, and {what} at its start"
        return message, notes, (help,)
    return None


def find_undetermined(planner: Planner, start: Start) -> tuple[str, tuple[str, ...]]:
    """What is singular at a start, and the parameters in it that are zero; empty where the accelerations are determined.

    A coframe that is singular there is not asked for: a run begins with another.
    """
    g, system = planner.graph, planner.system
    rates = kept_velocities(system, planner.kept_forms(), start)
    values = {**dict(zip(planner.equations.motion.w, rates, strict=True)), **start.values(system)}
    for guard in planner.mass_guards:
        try:
            value, scale = (float(x) for x in evaluate(g, [guard.value, guard.scale], values))
        except (ArithmeticError, ValueError, KeyError):
            return _NOTHING  # the coframe, or a function outside its domain
        if math.isnan(value):
            return _NOTHING  # a pole
        if not abs(value) > guard.tolerance * scale:
            return guard.what, blame(planner, start, guard.value)
    for solve in planner.solves:
        flat = [entry for row in solve.matrix for entry in row]
        try:
            numbers = [float(x) for x in evaluate(g, flat, values)]
            size = len(solve.matrix)
            solve_double([numbers[i * size : (i + 1) * size] for i in range(size)], [0.0] * size)
        except Singular:
            return solve.what, blame(planner, start, *flat)
        except (ArithmeticError, ValueError, KeyError):
            return _NOTHING
    return _NOTHING


def _find_dependent(planner: Planner, start: Start) -> tuple[str, tuple[str, ...]]:
    """A constraint whose row vanishes, or depends on the others, at a start; empty where there is none."""
    values = start.values(planner.system)
    form = find_dependent_row(planner.system, values)
    if form is None:
        return _NOTHING
    moves = any(float(x) for x in evaluate(planner.graph, form.coefficients, values))
    how = "depends on the others" if moves else "restricts no velocity"
    return f"the constraint `{form.name}` {how}", blame(planner, start, *form.coefficients)


def blame(planner: Planner, start: Start, *nodes: Node, negative: bool = False) -> tuple[str, ...]:
    """The parameters in these nodes that are zero at a start, or negative."""
    g, system = planner.graph, planner.system
    return tuple(
        parameter.name
        for symbol, parameter, value in zip(system.p, system.spec.parameters, start.p, strict=True)
        if (value < 0.0 if negative else value == 0.0) and any(g.depends(node, g.deps[symbol]) for node in nodes)
    )
