"""Jumps of the forces that steps of fixed length go over: where a sign changes in a step, its error is of the first order."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.show import to_text
from nhc.algebra.walks import reachable
from nhc.mechanics.properties.constancy import has_jumps
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.system import System
from nhc.program.planning.base import PlannerBase
from nhc.records import record

_LONGEST = 60

States = Sequence[Sequence[float]]


@record
class Jumping:
    """``arguments`` of the signs in the forces, by the symbols of the state and of the ``parameters``, and what to call them."""

    arguments: tuple[Node, ...]
    names: tuple[str, ...]
    parameters: tuple[Node, ...]


def find_jumping(planner: PlannerBase) -> Jumping | None:
    """The signs that the forces hold, of what moves; None where there is none whose argument the state tells."""
    system, g = planner.system, planner.graph
    reached = reachable(g, system.Q, g.mask((*system.q, *system.v)))
    own = list(dict.fromkeys(g.a[node] for node in reached if g.op[node] == "sign"))
    if not own:
        return None
    on = moving(system, planner.full_equations.motion.velocities)
    nodes = substitute(g, substitute(g, own, on), planner.put_in)
    told = g.mask((*planner.state_loads,))
    kept = [(node, to_text(g, a, _LONGEST)) for node, a in zip(nodes, own, strict=True) if not g.deps[node] & ~told]
    return Jumping(tuple(n for n, _ in kept), tuple(name for _, name in kept), planner.parameters) if kept else None


def tell_jumps(
    system: System,
    jumping: Jumping,
    symbols: Sequence[Node],
    p: Sequence[float],
    times: Sequence[float],
    states: States,
) -> tuple[str, ...]:
    """A note where one of the arguments changes its sign between two rows and the forces do jump; ``symbols``: of the states."""
    fixed = dict(zip(jumping.parameters, p, strict=True))
    rows = []
    for t, state in zip(times[: len(states)], states, strict=True):
        try:
            point = {**fixed, system.t: t, **dict(zip(symbols, state, strict=True))}
            rows.append([float(x) for x in evaluate(system.graph, jumping.arguments, point)])
        except (ArithmeticError, ValueError):
            continue
    changes = [sum(a * b < 0.0 for a, b in pairwise(column)) for column in zip(*rows, strict=True)]
    names = [name for name, count in zip(jumping.names, changes, strict=True) if count]
    if not names or not has_jumps(system, system.Q, undecided=False):
        return ()
    most = max(changes)
    listed = ", ".join(f"`{name}`" for name in names)
    return (
        f"the forces jump with the sign of {listed}, which changes {most} time{'s' if most > 1 else ''} from row to row: steps of"
        " fixed length go over such places, and err there by a part of the step's length, whatever the order of the method; an"
        " adaptive method without `--step` sees them",
    )
