"""By how much the accelerations of two specs differ, in double precision: at the starts of their scenes and at random states."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from nhc.algebra.bounds.common_zero import find_common_zero
from nhc.algebra.dense import RowSpace, Singular
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.diagnostics import SpecError
from nhc.mechanics.certificates.claims import Claim, reference_claim, solve_in_doubles
from nhc.mechanics.pairs.points import PairPoints
from nhc.mechanics.regular.trials import scattered_points, trial_points
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.system import System
from nhc.mechanics.values import coordinate_ranges, default_values
from nhc.records import record

_DRAWN = 8  # the last of the trial points are random ones
_FITS = 1e-9  # of the speeds: what velocities may miss the constraints by

Values = dict[Node, float]


@record
class Worst:
    """The state where the accelerations differ most: its name, what stands there (names with values), and both accelerations, by
    common coordinate.
    """

    state: str
    values: tuple[tuple[str, float], ...]
    first: tuple[float, ...]
    second: tuple[float, ...]


@record
class Measured:
    """``states`` is at how many states both systems have a motion; ``differences`` are the largest ones, by common coordinate, each
    relative to the larger of 1 and the largest acceleration at their state.  ``worst`` is None where there is no state.
    """

    states: int = 0
    differences: tuple[float, ...] = ()
    worst: Worst | None = None


def measure_pair(points: PairPoints, names: tuple[str, str]) -> Measured:
    """Compare at the states; ``names`` are what the two specs are called."""
    pairing = points.pairing
    claims = reference_claim(pairing.first), reference_claim(pairing.second)
    largest, count, worst = [0.0] * len(points.common), 0, None
    for label, place, own in _states(points, names):
        found = _compare(points, claims, place, own)
        if found is None:
            continue
        count += 1
        first, second, shown = found
        scale = max([1.0, *map(abs, first), *map(abs, second)])
        here = [abs(x - y) / scale for x, y in zip(first, second, strict=True)]
        if worst is None or max(here) > max(largest):
            worst = Worst(label, shown, tuple(first), tuple(second))
        largest = list(map(max, largest, here))
    return Measured(count, tuple(largest) if count else (), worst)


def count_fitting(points: PairPoints, names: tuple[str, str]) -> int:
    """At how many positions that the second system's equations allow those of the first hold, too; 0 where they do not at one."""
    count = 0
    for _, place, _ in _states(points, names):
        found = _place(points, place, points.laws[1].equations)
        if found is not None:
            if not _vanish(points, _equations_of_first(points), found):
                return 0
            count += 1
    return count


def _states(points: PairPoints, names: tuple[str, str]) -> Iterator[tuple[str, Values, Values]]:
    """Names of states, each with values of the second system's symbols and of the first's own coordinates and velocities."""
    pairing = points.pairing
    first, second = pairing.first, pairing.second
    extra = pairing.alone[0]
    for scene in second.spec.scenes:
        try:
            yield f"the start of `{scene.name}` in {names[1]}", start_of(second, scene).values(second), {}
        except SpecError:
            continue  # nhc check says why
    for scene in first.spec.scenes if pairing.is_renaming else ():
        try:
            values = start_of(first, scene).values(first)
        except SpecError:
            continue
        place = {**trial_points(second)[-1], **default_values(second)}
        place.update((second.q[j], 0.0) for j in pairing.alone[1])
        place.update((second.v[j], 0.0) for j in pairing.alone[1])
        place[second.t] = values[first.t]
        for i in points.common:
            j = pairing.place_of(i)
            assert j is not None
            place[second.q[j]], place[second.v[j]] = values[first.q[i]], values[first.v[i]]
        place.update((node, values[p]) for p, node in pairing.parameters if node in second.p)
        own = {node: values[node] for i in extra for node in (first.q[i], first.v[i])}
        yield f"the start of `{scene.name}` in {names[0]}", place, own
    drawn = trial_points(first)[-_DRAWN:]
    for k, place in enumerate(trial_points(second)[-_DRAWN:]):
        yield "a random state", place, {node: drawn[k][node] for i in extra for node in (first.q[i], first.v[i])}
    for k, place in enumerate(scattered_points(second)[-_DRAWN:]):
        own = {node: drawn[k][node] for i in extra for node in (first.q[i], first.v[i])}
        yield "a random state with random parameters", place, own


def _compare(
    points: PairPoints, claims: tuple[Claim, Claim], place: Values, own: Values
) -> tuple[list[float], list[float], tuple[tuple[str, float], ...]] | None:
    """The common accelerations in both systems, and the state; None where one of them has no motion there."""
    pairing, g = points.pairing, points.graph
    second = pairing.second
    try:
        settled = _settle(points, place)
        if settled is None or _leaves_ranges(points, settled):
            return None
        values, other = settled, _state_of_first(points, settled, own)
        if other is None:
            return None
        x = solve_in_doubles(claims[1], g, values)[0]
        y = solve_in_doubles(claims[0], pairing.first.graph, other)[0]
        turned = evaluate(g, points.turning, {**values, **dict(zip(points.rates, x, strict=True))})
    except (Singular, ArithmeticError, ValueError):
        return None
    found = [y[i] for i in points.common], [float(a) for a in turned]
    if not all(map(math.isfinite, (*found[0], *found[1]))):
        return None
    same = {pairing.place_of(i) for i in points.common} - set(pairing.alone[1])
    alone = [node for j in range(second.n) if j not in same for node in (second.q[j], second.v[j])]
    shown = _named(pairing.first, other) + _named(second, {node: values[node] for node in alone})
    return *found, shown


def _leaves_ranges(points: PairPoints, values: Values) -> bool:
    """Whether a state lies where roots have other signs than those that were taken."""
    second = points.pairing.second
    ranges = {q: limits for q, limits in coordinate_ranges(second).items() if second.symbol_name(q) in points.ranged}
    return any(not low <= values[q] <= high for q, (low, high) in ranges.items())


def _named(system: System, values: Values) -> tuple[tuple[str, float], ...]:
    """Coordinates and velocities, then parameters and the time, of those that have values."""
    marked = list(zip(system.q, system.q_names, strict=True))
    marked += [(node, f"{name}'") for node, name in zip(system.v, system.q_names, strict=True)]
    marked += [(node, system.symbol_name(node)) for node in (*system.p, system.t)]
    return tuple((name, values[node]) for node, name in marked if node in values)


def _settle(points: PairPoints, place: Values) -> Values | None:
    """The state moved to positions and velocities that the second system allows; None where none was found nearby."""
    second = points.pairing.second
    values = _place(points, place, [*points.laws[1].equations, *_equations_of_first(points)])
    if values is None:
        return None
    v = _admissible(second, values, [(j, values[node]) for j, node in enumerate(second.v)])
    if v is None:
        return None
    values.update(zip(second.v, v, strict=True))
    return values


def _equations_of_first(points: PairPoints) -> list[Node]:
    first = points.laws[0]
    return [f for k, f in zip(first.holonomic, first.equations, strict=True) if first.names[k] in points.told]


def _place(points: PairPoints, place: Values, equations: Sequence[Node]) -> Values | None:
    """The state moved to positions where the equations hold; None where none was found nearby."""
    values, left = dict(place), [f for f in dict.fromkeys(equations) if points.graph.deps[f]]
    try:
        if not left or _vanish(points, left, values):
            return values
        found = find_common_zero(points.graph, left, points.pairing.second.q, [values])
        return found if found is not None and _vanish(points, left, found) else None
    except (ArithmeticError, ValueError):
        return None


def _vanish(points: PairPoints, equations: Sequence[Node], values: Values) -> bool:
    return all(abs(float(x)) <= _FITS for x in evaluate(points.graph, equations, values))


def _admissible(
    system: System, values: Values, wanted: Sequence[tuple[int, float]], *, exact: int = 0
) -> list[float] | None:
    """Velocities on the constraints with the wanted values as far as these leave them open, the first ones first.

    The first ``exact`` of them must be taken as they are: None where the constraints do not allow that.
    """
    space = RowSpace(system.n)
    for j, value in wanted[:exact]:
        space.add([float(i == j) for i in range(system.n)], value)
    speed = max([1.0, *(abs(value) for _, value in wanted)])
    for form in system.constraints:
        *row, constant = (float(x) for x in evaluate(system.graph, [*form.coefficients, form.constant], values))
        off = space.add(row, -constant)
        size = max([abs(a) for a in row], default=0.0) * speed + abs(constant)
        if off is not None and not abs(off) <= _FITS * size:
            return None
    for j, value in wanted[exact:]:
        space.add([float(i == j) for i in range(system.n)], value)
    return space.solution()


def _state_of_first(points: PairPoints, values: Values, own: Values) -> Values | None:
    """The first system's values at a state of the second; what ``own`` does not say of its own coordinates is zero."""
    pairing, g = points.pairing, points.graph
    first = pairing.first
    made = {**default_values(first), first.t: values[pairing.second.t]}
    images = [float(x) for x in evaluate(g, [node for _, node in pairing.images], values)]
    speeds = [float(x) for x in evaluate(g, points.motion, values)]
    made.update((first.q[i], x) for i, x in zip(points.common, images, strict=True))
    made.update((p, float(evaluate(g, [node], values)[0])) for p, node in pairing.parameters)
    made.update((first.q[i], own.get(first.q[i], 0.0)) for i in pairing.alone[0])
    wanted = list(zip(points.common, speeds, strict=True))
    wanted += [(i, own.get(first.v[i], 0.0)) for i in pairing.alone[0]]
    v = _admissible(first, made, wanted, exact=len(points.common))
    if v is None:
        return None
    made.update(zip(first.v, v, strict=True))
    return made
