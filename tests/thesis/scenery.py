"""What the tests of the thesis share: gallery systems, random states, and the reference by multipliers (dense, by numpy)."""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache
from pathlib import Path

import numpy as np

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import linear_form
from nhc.exterior import Form as ExteriorForm
from nhc.exterior import interior
from nhc.language import decode, read
from nhc.mechanics.formulations import multipliers, voronec
from nhc.mechanics.frame import Frame, coordinate_frame, make_frame, total_derivative
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import Form, System
from nhc.mechanics.values import default_values

ROOT = Path(__file__).resolve().parents[2]
Values = dict[Node, float]


@cache
def system_of(name: str) -> System:
    return resolve(decode(read(ROOT / "specs" / f"{name}.yaml")))


def reduced_of(system: System, dependent: Sequence[str] = ()) -> voronec.Reduced:
    """The reduced system for dependent velocities by name; without names the spec's, or nhc's choice."""
    indices = tuple(system.q_names.index(name) for name in dependent) or system.dependent
    indices = indices or choose_dependent(system).dependent
    return voronec.reduce(coordinate_frame(system, indices), indices)


def rates_of(graph: Graph, count: int, name: str = "rate") -> tuple[Node, ...]:
    return tuple(graph.symbol(f"{name}{k + 1}", "test") for k in range(count))


def generic_frame(system: System, seed: int = 5) -> Frame:
    """Quasi-velocities that are not integrable, not homogeneous and depend on the time, completing the constraints."""
    g, rng = system.graph, random.Random(seed)
    lead = choose_dependent(system).dependent if system.l else ()
    free = [i for i in range(system.n) if i not in lead]
    forms, symbols = [], []

    def wave() -> Node:
        angle = g.add(g.mul(number(), rng.choice(system.q)), g.mul(number(), system.t))
        return g.mul(number(), g.function("sin", angle))

    def number() -> Node:
        return g.number(Fraction(rng.randint(1, 5), 7))

    for k, i in enumerate(free):
        coefficients = [wave() for _ in range(system.n)]
        coefficients[i] = g.add(coefficients[i], g.number(Fraction(7 + k, 5)))
        forms.append(Form(f"generic{k + 1}", tuple(coefficients), g.add(wave(), number())))
        symbols.append(g.symbol(f"generic{k + 1}", "quasi"))
    return make_frame(system, forms, symbols)


def random_states(frame: Frame, count: int, seed: int = 11) -> list[Values]:
    """States (q, t and the free velocities at random, parameters at their defaults; the constraints hold by construction):
    of many drawn, those at which the frame is best conditioned."""
    rng = random.Random(seed)
    drawn = [_draw(frame, rng) for _ in range(12 * count)]
    return sorted(drawn, key=lambda values: -_conditioning(frame, values))[:count]


def any_states(frame: Frame, count: int = 4, seed: int = 11) -> list[Values]:
    """Random states as they come."""
    rng = random.Random(seed)
    return [_draw(frame, rng) for _ in range(count)]


def _draw(frame: Frame, rng: random.Random) -> Values:
    system = frame.system
    values: Values = dict(default_values(system))
    for symbol, coordinate in zip(system.q, system.spec.coordinates, strict=True):
        low, high = (-1.0, 1.0) if coordinate.range is None else (float(end) for end in coordinate.range)
        middle, half = (low + high) / 2, 0.35 * (high - low)
        values[symbol] = rng.uniform(middle - half, middle + half)
    values[system.t] = rng.uniform(0.1, 1.5)
    for symbol in frame.free:
        values[symbol] = rng.choice((-1, 1)) * rng.uniform(0.3, 1.0)
    return values


def _conditioning(frame: Frame, values: Values) -> float:
    """How far the coframe is from singular, and its free vectors from dependent: their mass matrix has the square of that."""
    flat = evaluate(frame.graph, [node for pair in frame.guards for node in pair], values)
    guard = min((abs(size) / scale for size, scale in zip(flat[::2], flat[1::2], strict=True)), default=1.0)
    vectors = np.array([evaluate(frame.graph, list(e), values) for e in frame.free_vectors], dtype=float)
    return float(guard / np.linalg.cond(vectors) ** 2)


def truth(frame: Frame, states: Iterable[Values]) -> list[list[float]]:
    """q'' by the bordered system of Lagrange's equations with multipliers at states (q, free velocities, t)."""
    system, g = frame.system, frame.graph
    rates, reactions = rates_of(g, system.n, "second"), multipliers.multiplier_symbols(system)
    rows = [*multipliers.printed_rows(system, rates), *multipliers.constraint_rates(system, rates)]
    unknowns = (*rates, *reactions)
    entries = [x for row in rows for part in [linear_form(g, row, unknowns)] for x in (*part[0], part[1])]
    found = []
    for values in states:
        known = dict(values)
        known.update(zip(system.v, evaluate(g, list(frame.kinematics), values), strict=True))
        table = np.array(evaluate(g, entries, known), dtype=float).reshape(len(rows), len(unknowns) + 1)
        found.append([float(x) for x in np.linalg.solve(table[:, :-1], -table[:, -1])[: system.n]])
    return found


def predict(frame: Frame, rows: Sequence[Node], rates: Sequence[Node], states: Iterable[Values]) -> list[list[float]]:
    """q'' that rows linear in ``rates`` predict at states (q, free velocities, t)."""
    system, g = frame.system, frame.graph
    entries = [x for row in rows for part in [linear_form(g, row, rates)] for x in (*part[0], part[1])]
    moving = dict(zip(frame.free, rates, strict=True))
    second = [total_derivative(system, node, frame.kinematics, moving) for node in frame.kinematics]
    found = []
    for values in states:
        table = np.array(evaluate(g, entries, values), dtype=float).reshape(len(rows), len(rates) + 1)
        solved = [float(x) for x in np.linalg.solve(table[:, :-1], -table[:, -1])]
        found.append([float(x) for x in evaluate(g, second, {**values, **dict(zip(rates, solved, strict=True))})])
    return found


def error_of(frame: Frame, rows: Sequence[Node], rates: Sequence[Node], states: Sequence[Values]) -> float:
    """Largest relative distance, over the states, of the accelerations that the rows predict from the true ones."""
    pairs = zip(predict(frame, rows, rates, states), truth(frame, states), strict=True)
    return max(distance(found, expected) for found, expected in pairs)


def distance(found: Sequence[float], expected: Sequence[float]) -> float:
    """Largest difference, relative to the largest entry expected (or 1)."""
    size = max(1.0, *(abs(x) for x in expected))
    return max(abs(x - y) for x, y in zip(found, expected, strict=True)) / size


def projected_truth(frame: Frame, rates: Sequence[Node]) -> list[Node]:
    """The multiplier rows contracted with the free vectors, on the constraints: the reactions drop out, nothing else is done."""
    system, g = frame.system, frame.graph
    moving = dict(zip(frame.free, rates, strict=True))
    second = tuple(total_derivative(system, node, frame.kinematics, moving) for node in frame.kinematics)
    places = rates_of(g, system.n, "second")
    rows = multipliers.printed_rows(system, places)
    on = {**dict(zip(system.v, frame.kinematics, strict=True)), **dict(zip(places, second, strict=True))}
    rows = substitute(g, rows, on)
    return [g.sum([g.mul(x, row) for x, row in zip(e, rows, strict=True)]) for e in frame.free_vectors]


def kernel(form: ExteriorForm, values: Mapping[Node, float]) -> list[float]:
    """The components of X with i_X form = 0 and last (time) component 1, from all rows but the last."""
    g, size = form.graph, len(form.coframe)
    unit = [[g.one if i == k else g.zero for i in range(size)] for k in range(size)]
    rows = [interior(unit[k], form) for k in range(size - 1)]
    flat = evaluate(g, [row.coefficient(j) for row in rows for j in range(size)], values)
    table = np.array(flat, dtype=float).reshape(size - 1, size)
    return list(np.linalg.solve(table[:, :-1], -table[:, -1]))


def state_of(system: System, seed: int = 11) -> Values:
    """A random state of an unconstrained system, with q' in place of quasi-velocities."""
    values = any_states(generic_frame(system), 1, seed)[0]
    return {**values, **{v: 0.3 + 0.2 * k for k, v in enumerate(system.v)}}


def dot(g: Graph, x: Sequence[Node], y: Sequence[Node]) -> Node:
    return g.sum([g.mul(a, b) for a, b in zip(x, y, strict=True)])
