"""States at which choices are judged, the rows of forms there, and the units in which rows are compared."""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.evaluate import evaluate, evaluate_into
from nhc.algebra.graph import Node
from nhc.algebra.minors import balance_columns
from nhc.algebra.solving.sizes import size_of
from nhc.algebra.walks import reachable
from nhc.mechanics.system import Form, System
from nhc.mechanics.values import constant_value, default_values, start_values

_TRIALS = 12
_LATEST = 2.0  # time of states that are in no scene
_NEAR = 1e-5  # of its scale: a determinant that comes nearer than this is not thought to be small by the units
_ROUNDING = 1e-9  # of the terms of a determinant: less is taken for zero
_NOISE = 1e-13  # of a row's largest entry: less is no entry, but rounding
_FAR = 1e3  # between units of velocities: metres and radians go together, and so do millimetres and radians


def trial_points(system: System) -> list[dict[Node, float]]:
    """Ordinary states, the special ones (quarter turns) where careless choices are singular, and random ones.

    Velocities are random throughout.
    """
    rng, defaults = random.Random(11), default_values(system)
    quarter = (0.0, math.pi / 2, math.pi / 4, math.pi)
    turned = [[quarter[(k + j * (k > 1)) % 4] for j in range(system.n)] for k in range(1, 4)]
    special = [_state_at(system, defaults, rng, _in_range(system, angles), 0.0) for angles in turned]
    drawn = [_state_at(system, defaults, rng, [0.0] * system.n, 3.0) for _ in range(_TRIALS - 4)]
    return ordinary_points(system) + special + drawn


def _in_range(system: System, values: Sequence[float]) -> list[float]:
    """Values of the coordinates, those beyond their ranges at the ends of these."""
    ranges = [c.range or (-math.inf, math.inf) for c in system.spec.coordinates]
    return [min(max(x, float(low)), float(high)) for x, (low, high) in zip(values, ranges, strict=True)]


def ordinary_points(system: System) -> list[dict[Node, float]]:
    """The scenes' own starts, each with its neighbourhood at some time of the scene, and zero."""
    rng, defaults = random.Random(7), default_values(system)
    found = []
    for start, (begin, end) in _scene_starts(system):
        found.append({**_state_at(system, defaults, rng, start, 0.0), system.t: begin})
        near = _state_at(system, defaults, rng, start, 0.2)
        found.append({**near, system.t: begin + (end - begin) * near[system.t] / _LATEST})
    zero = [float(c.start) for c in system.spec.coordinates]
    return [*found, *(_state_at(system, defaults, rng, zero, spread) for spread in (0.0, 0.2))]


def start_points(system: System) -> list[dict[Node, float]]:
    """The scenes' own starts among the trial points."""
    return _kept_points(system, ordinary=False)[: 2 * len(_scene_starts(system)) : 2]


def _scene_starts(system: System) -> list[tuple[list[float], tuple[float, float]]]:
    """Initial coordinates and time of the first scenes (velocities play no part in regularity)."""
    starts = []
    defaults = tuple(default_values(system).values())
    for scene in system.spec.scenes[:3]:
        names = start_values(system.spec, scene, defaults)
        try:
            given = {e.name: constant_value(e.value, names) for e in scene.initial if e.kind == "coordinate"}
        except (ArithmeticError, ValueError):
            continue  # said of the scene itself
        start = [given.get(c.name, float(c.start)) for c in system.spec.coordinates]
        starts.append((start, (float(scene.time[0]), float(scene.time[1]))))
    return starts


def _state_at(
    system: System, defaults: dict[Node, float], rng: random.Random, centre: Sequence[float], spread: float
) -> dict[Node, float]:
    point = dict(defaults)
    for symbol, coordinate, middle in zip(system.q, system.spec.coordinates, centre, strict=True):
        value = middle + rng.uniform(-spread, spread)
        if coordinate.range is not None and spread > 1.0:
            value = rng.uniform(float(coordinate.range[0]), float(coordinate.range[1]))
        point[symbol] = value
    for symbol in system.v:
        point[symbol] = rng.uniform(-1, 1)
    point[system.t] = rng.uniform(0, _LATEST)
    return point


def sampled_rows(
    system: System,
    forms: Sequence[Form],
    points: Sequence[dict[Node, float]] | None = None,
    *,
    ordinary: bool = False,
    units: Sequence[float] | None = None,
) -> list[list[list[float]]]:
    """The matrix of the forms' directions, in these units (by default those of :func:`velocity_units`), at each of the points
    (trial points, or ordinary ones, by default) where it can be evaluated; the points are told what was evaluated at them.
    """
    chosen = _kept_points(system, ordinary=ordinary) if points is None else points
    own = velocity_units(system) if units is None else units
    if all(u == 1.0 for u in own):
        return _rows(system, forms, chosen)
    return [[[a * u for a, u in zip(row, own, strict=True)] for row in rows] for rows in _rows(system, forms, chosen)]


def _rows(system: System, forms: Sequence[Form], points: Sequence[dict[Node, float]]) -> list[list[list[float]]]:
    g = system.graph
    flat = [a for form in forms for a in form.direction]
    order, result = reachable(g, flat), []
    for known in points:
        try:
            evaluate_into(known, g, order)
        except (ArithmeticError, ValueError):
            continue
        values = [float(known[x]) for x in flat]
        result.append([values[r * system.n : (r + 1) * system.n] for r in range(len(forms))])
    return result


def velocity_units(system: System) -> list[float]:
    """Units of the velocities in which how singular a choice is does not hang on the spec's unit of length: the balanced ones; 1
    throughout where the coefficients are near enough to 1 already.
    """
    units = balanced_units(system)
    return units if max(units) > _FAR * min(units) else [1.0] * system.n


def balanced_units(system: System) -> list[float]:
    """Units of the velocities in which the coefficients of the constraints and of the spec's quasi-velocities are near 1.

    The largest coefficients over the trial points are what is balanced (see :func:`nhc.algebra.minors.balance_columns`).
    """
    forms = (*system.constraints, *system.quasi)
    known: dict[tuple[tuple[Node, ...], ...], list[float]] = system.graph.memory.setdefault("velocity units", {})
    key = tuple(form.coefficients for form in forms)
    if key not in known:
        rows = _rows(system, forms, _kept_points(system, ordinary=False))
        largest = [
            [
                max((abs(m[i][j]) for m in rows), default=0.0) if node else 0.0
                for j, node in enumerate(form.coefficients)
            ]
            for i, form in enumerate(forms)
        ]
        largest = [[x if x > _NOISE * max(row) else 0.0 for x in row] for row in largest]
        known[key] = balance_columns(largest, system.n)
    return known[key]


def _kept_points(system: System, *, ordinary: bool) -> list[dict[Node, float]]:
    """The points with everything that was evaluated at them before."""
    name = "ordinary points" if ordinary else "trial points"
    found: list[dict[Node, float]] | None = system.graph.memory.get(name)
    if found is None:
        found = system.graph.memory[name] = ordinary_points(system) if ordinary else trial_points(system)
    return found


def scattered_points(system: System) -> list[dict[Node, float]]:
    """The trial points with other values of the parameters: those of the spec may make rows equal that are independent."""
    rng = random.Random(5)
    return [point | {symbol: rng.uniform(0.4, 1.6) for symbol in system.p} for point in trial_points(system)]


def usual_digits(system: System, value: Node, scale: Node) -> int:
    """By how many powers of ten a determinant stays below its ``scale`` wherever it is looked at; 0 where it comes near it.

    Rows that hold lengths and angles have sizes that hang on the unit of length: then the largest ratio over the trial points, with
    the parameters' values in the spec, stands for the one in units in which lengths are near 1.
    """
    if scale in (system.graph.zero, system.graph.one):
        return 0
    largest = _largest_part(system, value, scale)
    return 0 if largest >= _NEAR else -math.ceil(math.log10(largest))


def usual_part(system: System, value: Node, scale: Node) -> Fraction:
    """The largest part of its ``scale`` that a determinant is anywhere it is looked at, in two digits."""
    return Fraction(f"{_largest_part(system, value, scale):.2g}")


def _largest_part(system: System, value: Node, scale: Node) -> float:
    known: dict[tuple[Node, Node], float] = system.graph.memory.setdefault("usual parts", {})
    if (value, scale) not in known:
        ratios, nodes = [], [value, scale, size_of(system.graph, value)]
        for point in _kept_points(system, ordinary=False):
            try:
                found, size, terms = (float(x) for x in evaluate(system.graph, nodes, point))
            except (ArithmeticError, ValueError, KeyError):
                continue
            if size and math.isfinite(found / size) and abs(found) > _ROUNDING * terms:
                ratios.append(abs(found / size))
        known[value, scale] = max(ratios, default=1.0)
    return known[value, scale]
