"""Where a choice is regular: sampling at ordinary and at special points, bounds, and the choice of dependent velocities."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from itertools import combinations

from nhc.algebra.blocks import determinant_of
from nhc.algebra.calculus import reachable
from nhc.algebra.evaluate import evaluate, evaluate_into
from nhc.algebra.graph import Node
from nhc.algebra.interval import Interval, cannot_vanish
from nhc.algebra.minors import balance_columns, relative_minors
from nhc.algebra.polynomial import normalise
from nhc.mechanics.system import Form, System
from nhc.mechanics.values import constant_value, default_values, parameter_ranges
from nhc.records import record

_TRIALS = 12
_LATEST = 2.0  # time of states that are in no scene
_WEAK = 0.03  # of the largest determinant that rows of these lengths can have (per row)
_NOTHING = 1e-9  # what rounding leaves of a pivot
_MANY = 250  # subsets of columns that are tried one by one


@record
class Choice:
    """Dependent velocities with the determinant of their block; ``regular`` if it can be shown never to vanish."""

    dependent: tuple[int, ...]
    determinant: Node | None
    regular: bool


def intervals(system: System) -> dict[Node, Interval]:
    """Parameters over their values in the spec and its scenes, coordinates over their declared ranges."""
    known: dict[Node, Interval] = dict(parameter_ranges(system))
    for symbol, coordinate in zip(system.q, system.spec.coordinates, strict=True):
        if coordinate.range is not None:
            known[symbol] = (float(coordinate.range[0]), float(coordinate.range[1]))
    return known


def trial_points(system: System) -> list[dict[Node, float]]:
    """Ordinary states, the special ones (quarter turns) where careless choices are singular, and random ones.

    Velocities are random throughout.
    """
    rng, defaults = random.Random(11), default_values(system)
    quarter = (0.0, math.pi / 2, math.pi / 4, math.pi)
    turned = [[quarter[(k + j * (k > 1)) % 4] for j in range(system.n)] for k in range(1, 4)]
    special = [_state_at(system, defaults, rng, angles, 0.0) for angles in turned]
    drawn = [_state_at(system, defaults, rng, [0.0] * system.n, 3.0) for _ in range(_TRIALS - 4)]
    return ordinary_points(system) + special + drawn


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


def _starts(system: System) -> list[dict[Node, float]]:
    """The scenes' own starts among the trial points."""
    return _kept_points(system, ordinary=False)[: 2 * len(_scene_starts(system)) : 2]


def _scene_starts(system: System) -> list[tuple[list[float], tuple[float, float]]]:
    """Initial coordinates and time of the first scenes (velocities play no part in regularity)."""
    starts = []
    parameters = dict(zip((p.name for p in system.spec.parameters), default_values(system).values(), strict=True))
    for scene in system.spec.scenes[:3]:
        try:
            given = {e.name: constant_value(e.value, parameters) for e in scene.initial if e.kind == "coordinate"}
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
) -> list[list[list[float]]]:
    """The matrix of the forms' coefficients, in the units of :func:`velocity_units`, at each of the points (trial points, or
    ordinary ones, by default) where it can be evaluated; the points are told what was evaluated at them.
    """
    chosen = _kept_points(system, ordinary=ordinary) if points is None else points
    units = velocity_units(system)
    return [[[a * u for a, u in zip(row, units, strict=True)] for row in rows] for rows in _rows(system, forms, chosen)]


def _rows(system: System, forms: Sequence[Form], points: Sequence[dict[Node, float]]) -> list[list[list[float]]]:
    g = system.graph
    flat = [a for form in forms for a in form.coefficients]
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
    """Units of the velocities in which the coefficients of the constraints and of the spec's quasi-velocities are near 1, whatever
    the spec's units of lengths and of angles are: how singular a choice is does not hang on those.

    The largest coefficients over the trial points are what is balanced (see :func:`nhc.algebra.minors.balance_columns`).
    """
    forms = (*system.constraints, *system.quasi)
    known: dict[tuple[tuple[Node, ...], ...], list[float]] = system.graph.memory.setdefault("velocity units", {})
    key = tuple(form.coefficients for form in forms)
    if key not in known:
        rows = _rows(system, forms, _kept_points(system, ordinary=False))
        largest = [[max((abs(m[i][j]) for m in rows), default=0.0) for j in range(system.n)] for i in range(len(forms))]
        known[key] = balance_columns(largest, system.n)
    return known[key]


def _kept_points(system: System, *, ordinary: bool) -> list[dict[Node, float]]:
    """The points with everything that was evaluated at them before."""
    name = "ordinary points" if ordinary else "trial points"
    found: list[dict[Node, float]] | None = system.graph.memory.get(name)
    if found is None:
        found = system.graph.memory[name] = ordinary_points(system) if ordinary else trial_points(system)
    return found


def _scattered(system: System) -> list[dict[Node, float]]:
    """The trial points with other values of the parameters: those of the spec may make rows equal that are independent."""
    rng = random.Random(5)
    return [point | {symbol: rng.uniform(0.4, 1.6) for symbol in system.p} for point in trial_points(system)]


def relative_determinant(matrix: Sequence[Sequence[float]], columns: Sequence[int]) -> float:
    """|det| of the columns over the product of the norms of the whole rows (Hadamard), its l-th root: in [0, 1]."""
    return relative_minors(matrix, [columns])[0]


def pivot_weakness(system: System) -> Callable[[Sequence[Node], Sequence[Node]], list[int]]:
    """A measure for elimination: at how many trial points a pivot is small against its row (its scale)."""
    points: list[dict[Node, float]] = []

    def measure(pivots: Sequence[Node], scales: Sequence[Node]) -> list[int]:
        points.extend(() if points else trial_points(system))
        counts = [0] * len(pivots)
        for point in points:
            try:
                values = evaluate(system.graph, [*pivots, *scales], point)
            except (ArithmeticError, ValueError):
                continue
            for k in range(len(pivots)):
                counts[k] += not abs(values[k]) > _WEAK * abs(values[len(pivots) + k])
        return counts

    return measure


def weakness(values: Sequence[float]) -> tuple[int, float]:
    """How often a choice is close to singular, and how weak it is on the whole: smaller is better."""
    if not values:
        return 10**6, 0.0
    low = sorted(values)[: max(1, len(values) // 2)]
    return sum(value < _WEAK for value in values), -round(sum(low) / len(low), 3)


def weak_where_constraints_are_not(system: System, forms: Sequence[Form]) -> int:
    """At how many ordinary states (see :func:`ordinary_points`) the coframe is weak although the constraints have full rank."""
    matrices = sampled_rows(system, forms, ordinary=True)
    count = 0
    for matrix in matrices:
        if relative_determinant(matrix, range(system.n)) < _WEAK and _full_rank(matrix[: system.l]):
            count += 1
    return count


def _full_rank(rows: Sequence[Sequence[float]], least: float = _WEAK) -> bool:
    """Clearly independent rows: elimination with full pivoting leaves no small pivot."""
    work = [list(row) for row in rows]
    norms = [math.sqrt(sum(x * x for x in row)) for row in work]
    for step in range(len(work)):
        sizes = [max(map(abs, work[i])) / max(norms[i], 1e-300) for i in range(step, len(work))]
        best = max(sizes)
        if best < least:
            return False
        i = step + sizes.index(best)
        j = max(range(len(work[i])), key=lambda j: abs(work[i][j]))
        work[step], work[i] = work[i], work[step]
        norms[step], norms[i] = norms[i], norms[step]
        for k in range(step + 1, len(work)):
            factor = work[k][j] / work[step][j]
            if factor:
                work[k] = [x - factor * y for x, y in zip(work[k], work[step], strict=True)]
    return True


def coframe_weakness(system: System, forms: Sequence[Form]) -> tuple[int, float]:
    """The weakness of n forms as a coframe."""
    every = range(system.n)
    return weakness([relative_determinant(matrix, every) for matrix in sampled_rows(system, forms)])


def choose_dependent(system: System) -> Choice:
    """The l velocities to solve for: never singular where there is such a choice, else singular as rarely as possible.

    The graph keeps the choice: a system with other values in the same constraints has the same one.
    """
    known: Choice | None = system.graph.memory.get("dependent velocities")
    if known is None:
        known = system.graph.memory["dependent velocities"] = _choose(system)
    return known


def _choose(system: System) -> Choice:
    n, lower = system.n, system.l
    if lower == 0:
        return Choice((), system.graph.one, True)
    samples = sampled_rows(system, system.constraints)
    begun = sampled_rows(system, system.constraints, _starts(system))
    if not any(_full_rank(matrix, _NOTHING) for matrix in samples):
        samples, begun = sampled_rows(system, system.constraints, _scattered(system)), []
    if math.comb(n, lower) <= _MANY:
        candidates = [list(c) for c in combinations(range(n), lower)]
    else:
        chosen = [
            _greedy(system, points) for points in (begun, [*begun, *samples[-3:]], samples[-3:] or samples) if points
        ]
        candidates = [list(columns) for columns in dict.fromkeys(map(tuple, chosen))]
    own = _own_columns(system, samples)
    scored = _scored(candidates, samples, begun)
    best: Choice | None = None
    for first, weak, _, columns in scored[:8]:
        choice = judge(system, tuple(columns))
        if best is None or (choice.regular and not best.regular):
            best = choice
        if best.regular or (first, weak) > scored[0][:2]:
            break
    assert best is not None
    if own and not all(set(columns) & set(best.dependent) for columns in own):
        return judge(system, tuple(sorted(columns[0] for columns in own)))
    return best


def _scored(
    candidates: Sequence[Sequence[int]],
    samples: Sequence[Sequence[Sequence[float]]],
    begun: Sequence[Sequence[Sequence[float]]],
) -> list[tuple[int, int, float, list[int]]]:
    """(how often lost at the scenes' starts, how often weak, how weak, columns) of each candidate, the best first."""
    minors = [relative_minors(matrix, candidates) for matrix in samples]
    begin = [relative_minors(matrix, candidates) for matrix in begun]
    lost = [sum(row[k] < _WEAK for row in begin) for k in range(len(candidates))]
    return sorted(
        (lost[k], *weakness([row[k] for row in minors]), list(columns)) for k, columns in enumerate(candidates)
    )


def ranked(system: System, columns: Sequence[int], fits: Callable[[Sequence[int]], bool]) -> list[Choice]:
    """Every choice of dependent velocities among ``columns`` alone that ``fits`` and is not singular at all the trial points, those
    that never are first, then in the order of :func:`choose_dependent`; none where there are too many to try.
    """
    if math.comb(len(columns), system.l) > _MANY:
        return []
    samples = sampled_rows(system, system.constraints)
    begun = sampled_rows(system, system.constraints, _starts(system))
    scored = _scored([list(c) for c in combinations(columns, system.l)], samples, begun)
    found = [judge(system, tuple(chosen)) for _, weak, _, chosen in scored if weak < len(samples) and fits(chosen)]
    return sorted(found, key=lambda choice: not choice.regular)


def _own_columns(system: System, samples: Sequence[Sequence[Sequence[float]]]) -> list[list[int]]:
    """For each constraint the velocities that no other one contains and that it can always be solved for, the heaviest first.

    Empty where a constraint has none: with one from each the block is diagonal, and there is nothing to solve.
    """
    g, known = system.graph, intervals(system)
    rows, found = [form.coefficients for form in system.constraints], list[list[int]]()
    for k, row in enumerate(rows):
        columns = [
            j
            for j, entry in enumerate(row)
            if entry != g.zero
            and all(other[j] == g.zero for i, other in enumerate(rows) if i != k)
            and cannot_vanish(g, normalise(g, entry, 60), known)
        ]
        if not columns:
            return []
        found.append(sorted(columns, key=lambda j: -min((abs(matrix[k][j]) for matrix in samples), default=0.0)))
    return found


def _greedy(system: System, samples: Sequence[Sequence[Sequence[float]]]) -> list[int]:
    """Column by column: the one whose smallest pivot over the samples is largest (for systems with many constraints)."""
    work = [[list(row) for row in matrix] for matrix in samples]
    chosen: list[int] = []
    for row in range(system.l):
        best = max(
            (j for j in range(system.n) if j not in chosen),
            key=lambda j: (round(min(abs(m[row][j]) for m in work), 9), j),
        )
        chosen.append(best)
        for matrix in work:
            pivot = matrix[row][best]
            if pivot == 0.0:
                continue
            for i in range(row + 1, system.l):
                factor = matrix[i][best] / pivot
                if factor:
                    matrix[i] = [x - factor * y for x, y in zip(matrix[i], matrix[row], strict=True)]
    return sorted(chosen)


def judge(system: System, dependent: tuple[int, ...]) -> Choice:
    """The block's determinant in canonical form (None for large blocks) and whether it can vanish."""
    g = system.graph
    block = [[form.coefficients[j] for j in dependent] for form in system.constraints]
    if len(block) > 5:
        return Choice(dependent, None, False)
    determinant = normalise(g, determinant_of(g, block), 200)
    return Choice(dependent, determinant, cannot_vanish(g, determinant, intervals(system)))
