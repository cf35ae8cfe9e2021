"""An inconsistent start, brought to the constraints: the nearest velocities in the metric of the kinetic energy."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.calculus import gradient
from nhc.algebra.dense import RowSpace
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, SpecError
from nhc.language.spec import Scene
from nhc.mechanics.regular.trials import velocity_units
from nhc.mechanics.starts.contradictions import PROJECT
from nhc.mechanics.starts.scenes import Start, initial_values, start_of
from nhc.mechanics.starts.velocities import given_velocities, term_sizes
from nhc.mechanics.system import System
from nhc.mechanics.values import start_values
from nhc.simulate.methods.linear import SingularMatrix, solve

SHOWN = 8  # changed velocities in a report


def projected_start(system: System, scene: Scene) -> tuple[Start, tuple[str, ...]]:
    """The scene's start and notes on what was changed: nothing where it is consistent.

    v = v0 - M^-1 A^T (A M^-1 A^T)^-1 (A v0 + a), where v0 has the given values, and for what is left out what follows from the
    constraints that hold, or zero.

    Raises:
        nhc.diagnostics.SpecError: the start is wrong in another way than by its velocities.
    """
    try:
        return start_of(system, scene), ()
    except SpecError as refused:
        # without the given velocities the positions and parameters must stand by themselves
        still = Scene(
            *(scene.name, scene.span, scene.about, scene.parameters),
            tuple(entry for entry in scene.initial if entry.kind == "coordinate"),
            *(scene.time, scene.need, scene.tolerance),
        )
        base = start_of(system, still)
        place = base.values(system)
        given = initial_values(system, scene, start_values(system.spec, scene, base.p), Bag(system.spec.origin))
        try:
            wanted = given_velocities(system, scene, place, given)
            v = _nearest(system, place, wanted)
        except (ArithmeticError, ValueError):
            raise _immovable(refused) from None
    units = velocity_units(system)
    speed = max(abs(x) / unit for x, unit in zip((*wanted, *v), (*units, *units), strict=True))
    changed = [
        f"{name}' {a:.9g} -> {b:.9g}"
        for name, a, b, unit in zip(system.q_names, wanted, v, units, strict=True)
        if abs(a - b) > 1e-12 * max(abs(a), abs(b), speed * unit)
    ]
    more = ", ..." if len(changed) > SHOWN else ""
    energy = [_energy(system, place, velocities) for velocities in (wanted, v)]
    notes = (
        f"the start violates the constraints; projected: {', '.join(changed[:SHOWN])}{more}",
        f"by this the energy changes from {energy[0]:.9g} to {energy[1]:.9g}",
    )
    return Start(scene, base.time, base.p, base.q, tuple(v)), notes


def _immovable(refused: SpecError) -> SpecError:
    """Why a start was refused, without the advice to project it."""
    return SpecError(
        (replace(one, help=tuple(text for text in one.help if text != PROJECT)) for one in refused.diagnostics),
        refused.source,
    )


def _nearest(system: System, place: dict[Node, float], v: Sequence[float]) -> list[float]:
    rows, right = [], []
    for form in system.constraints:
        numbers = _numbers(system, [*form.coefficients, form.constant], place)
        rows.append(numbers[:-1])
        right.append(-sum(a * x for a, x in zip(numbers[:-1], v, strict=True)) - numbers[-1])
    return [a + b for a, b in zip(v, _least_change(system, place, rows, right), strict=True)]


def _least_change(
    system: System, place: dict[Node, float], rows: Sequence[Sequence[float]], right: Sequence[float]
) -> list[float]:
    """d with rows d = right and the least kinetic energy.

    Rows that follow from others would make the matrix singular: they are left to the later check.

    Velocities, rows and energy are measured in units in which they are near 1, so that pivots can be compared.
    """
    g, n, units = system.graph, system.n, velocity_units(system)
    sizes = [size or 1.0 for size in term_sizes(system, rows, right)]
    flat = _numbers(system, [x for p in gradient(g, system.T, system.v) for x in gradient(g, p, system.v)], place)
    mass = [[flat[i * n + j] * units[i] * units[j] for j in range(n)] for i in range(n)]
    most = max((abs(x) for row in mass for x in row), default=0.0) or 1.0
    made = [[a * u for a, u in zip(row, units, strict=True)] for row in rows]
    lengths = [max(map(abs, row), default=0.0) or 1.0 for row in made]
    scaled = [[a / length for a in row] for row, length in zip(made, lengths, strict=True)]
    values, space = [value / length for value, length in zip(right, lengths, strict=True)], RowSpace(n)
    new = [k for k, row in enumerate(scaled) if space.add(row, 0.0) is None]
    scaled, values = [scaled[k] for k in new], [values[k] for k in new]
    matrix = [[*(x / most for x in mass[i]), *(row[i] for row in scaled)] for i in range(n)]
    matrix += [[*row, *([0.0] * len(scaled))] for row in scaled]
    found = solve(matrix, [*([0.0] * n), *values])[:n]
    for row, value, size in zip(made, right, sizes, strict=True):
        if not abs(sum(map(operator.mul, row, found)) - value) <= 1e-9 * size:
            raise SingularMatrix("the rows contradict one another")
    return [x * u for x, u in zip(found, units, strict=True)]


def _numbers(system: System, nodes: Sequence[Node], place: dict[Node, float]) -> list[float]:
    return [float(x) for x in evaluate(system.graph, list(nodes), place)]


def _energy(system: System, place: dict[Node, float], v: Sequence[float]) -> float:
    return _numbers(system, [system.energy], {**place, **dict(zip(system.v, v, strict=True))})[0]
