"""Differences in double precision, at states of the scenes and at random ones."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from nhc.algebra.dense import Singular
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.diagnostics import SpecError
from nhc.mechanics.certificates.claims import Claim, Guards, Velocities, solve_in_doubles
from nhc.mechanics.regular.trials import trial_points
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.system import System
from nhc.records import record

_SPECIAL = 4  # the first of the trial points stand where careless choices are singular

_NEAR = 1e-7
"""Of what a determinant changes by where the state moves by 1: states closer to a frame's singular set tell of its conditioning."""
_SHIFT = 1e-6
_JUMP = 0.5
"""Of the accelerations, by which they may change with that shift: where they do by more, the coordinates are singular (a pole)."""


@record
class State:
    """Values of every symbol, and what the reference says there."""

    values: dict[Node, float]
    accelerations: list[float]
    reactions: list[float]


@record
class Distance:
    """Largest differences from the reference, each relative to the larger of 1 and the largest component of the truth.

    ``states`` is at how many states the derivation answers; its frame may be singular at others.
    """

    accelerations: float
    reactions: float
    states: int


def states_of(system: System, velocities: Velocities, reference: Claim) -> list[State]:
    """The scenes' starts and the random trial points where the reference has a motion; velocities satisfy the constraints."""
    points: list[dict[Node, float]] = []
    for scene in system.spec.scenes:
        try:
            points.append(start_of(system, scene).values(system))
        except SpecError:
            continue
    points += trial_points(system)[_SPECIAL:]
    states = []
    for point in points:
        try:
            values = dict(point)
            if not _is_regular(system, velocities.guards, values):
                continue
            state = _solve_reference(system, velocities, reference, values)
            near = _solve_reference(system, velocities, reference, _shift(system, values))
        except (Singular, ArithmeticError, ValueError):
            continue
        found = (*state.accelerations, *state.reactions)
        if all(map(math.isfinite, found)) and _relative(near.accelerations, state.accelerations) < _JUMP:
            states.append(state)
    return states


def _solve_reference(system: System, velocities: Velocities, reference: Claim, values: Mapping[Node, float]) -> State:
    known = dict(values)
    found = [float(x) for x in evaluate(system.graph, velocities.nodes, known)]
    known.update(zip(velocities.symbols, found, strict=True))
    return State(known, *solve_in_doubles(reference, system.graph, known))


def _shift(system: System, values: Mapping[Node, float]) -> dict[Node, float]:
    near = dict(values)
    for k, symbol in enumerate((*system.q, system.t)):
        near[symbol] += _SHIFT * max(1.0, abs(near[symbol])) * math.cos((k + 1.0) ** 1.5)
    return near


def measure(system: System, claim: Claim, states: Sequence[State]) -> Distance:
    """How far a claim is from the reference."""
    far_q, far_r, answered = 0.0, 0.0, 0
    for state in states:
        found = _solve(claim, system.graph, state.values) if _is_regular(system, claim.guards, state.values) else None
        if found is None:
            continue
        answered += 1
        far_q = max(far_q, _relative(found[0], state.accelerations))
        if found[1]:
            far_r = max(far_r, _relative(found[1], state.reactions))
    return Distance(far_q, far_r, answered)


def _is_regular(system: System, guards: Guards, values: dict[Node, float]) -> bool:
    """Whether the state is well away from where a frame does not exist: a small shift changes no guard by much.

    What bounds the terms of a pivot (its scale) says little after some pivots: it grows with each of them, and the pivots do not.
    """
    nodes = [value for value, _ in guards]
    try:
        here, there = (evaluate(system.graph, nodes, state) for state in (values, _shift(system, values)))
    except (ArithmeticError, ValueError):
        return False
    return all(
        abs(x) > _NEAR * abs(x - y) / _SHIFT and x for x, y in zip(map(float, here), map(float, there), strict=True)
    )


def _solve(claim: Claim, graph: Graph, values: dict[Node, float]) -> tuple[list[float], list[float]] | None:
    try:
        found = solve_in_doubles(claim, graph, values)
    except (Singular, ArithmeticError, ValueError):
        return None
    return found if all(math.isfinite(x) for part in found for x in part) else None


def _relative(found: Sequence[float], truth: Sequence[float]) -> float:
    scale = max([1.0, *(abs(x) for x in truth)])
    return max((abs(x - y) for x, y in zip(found, truth, strict=True)), default=0.0) / scale
