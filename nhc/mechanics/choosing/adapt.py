"""Regular adapted coframes: free forms that complete the constraints, and the spec's own velocities, wherever these have full rank.

What completes them is chosen among velocities of coordinates, rows of minors (:mod:`nhc.mechanics.choosing.minors`) and
velocities along the axes of bodies (:mod:`nhc.mechanics.choosing.headings`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from nhc.algebra.dense import Singular
from nhc.algebra.exact.modular import rank
from nhc.algebra.graph import Node
from nhc.algebra.walks import reachable
from nhc.mechanics.choosing.energy import free_energy
from nhc.mechanics.choosing.headings import Axes, along_headings, on_axes
from nhc.mechanics.choosing.independence import MANY_ROWS, SOUND, independence, strongest
from nhc.mechanics.choosing.minors import adapted_forms, stepwise_forms, unused_name
from nhc.mechanics.choosing.orders import count_weak, list_orders, may_vanish, weak_factors
from nhc.mechanics.choosing.spins import spins
from nhc.mechanics.choosing.stepwise import order_stepwise
from nhc.mechanics.choosing.turned import turned_omegas
from nhc.mechanics.frame import coordinate_form, form_value, make_frame, velocity_symbol
from nhc.mechanics.regular.regularity import (
    choose_dependent,
    coframe_weakness,
    relative_determinant,
    weak_where_constraints_are_not,
)
from nhc.mechanics.regular.trials import ordinary_points, sampled_rows, trial_points
from nhc.mechanics.system import Form, System

_WEAK = 0.03  # of the largest determinant that rows of these lengths can have (per constraint)
_MOST_PLACES = 14  # coordinates, beyond which matrices in all velocities take longer than they are worth
_SAME = 1e-9  # of the largest entry of T's matrix
_ALIKE = 0.03  # what two completions on axes may differ by, of which the first is taken
_FEW_COORDINATES = 8  # of mechanisms up to which multipliers are short


def complete(system: System) -> tuple[tuple[Form, ...], tuple[str, ...]]:
    """The spec's quasi-velocities, completed to n - l free forms; (forms, names of what was added).

    Raises:
        nhc.algebra.dense.Singular: they are too many or no basis.
    """
    g, wanted, angular = system.graph, system.n - system.l, system.angular
    forms = [form for form in system.quasi if form.name not in angular]
    if len(forms) > wanted:
        raise Singular
    if len(forms) == wanted:
        return tuple(forms), ()  # whoever solves for them finds out whether they are a basis
    rows = [list(f.coefficients) for f in (*system.constraints, *forms)]
    if rank(g, rows) < len(rows):
        raise Singular
    if system.rotations:
        best = _least_weak_turning(system, forms)
    else:
        best = _least_weak(system, forms, wanted)
    return best, tuple(spelled(system, form) for form in best[len(forms) :] if form.name not in angular)


def _least_weak(system: System, forms: Sequence[Form], wanted: int) -> tuple[Form, ...]:
    """The completion that is least often near-singular; other velocities than the first ones only where that is gained."""

    pools, axes = _pools(system, not forms)

    def weigh(pool: Sequence[Form]) -> _Weighed:
        made = _extend(system, forms, wanted, pool)
        weak, size = coframe_weakness(system, (*system.constraints, *made))
        return (weak, any(found.halves(made) for found in axes), size), made

    weak, best = _soundest(system, [weigh(pool) for pool in pools], axes, bare=not forms)
    if system.l > MANY_ROWS:
        best = _along_rows(system, forms, best, pools[0])
        weak = coframe_weakness(system, (*system.constraints, *best))[0] if forms else 0
    measure = (weak, bool(forms) and may_vanish(system, [*system.constraints, *best]))
    for order in _other_orders(system, forms, pools[0]) if forms and any(measure) else ():
        (weak, _, _), made = weigh([*order, *pools[0]])
        trial = (weak, weak <= measure[0] and may_vanish(system, [*system.constraints, *made]))
        if trial < measure:
            measure, best = trial, made
    return best


def _other_orders(system: System, forms: Sequence[Form], pool: Sequence[Form]) -> Iterator[Sequence[Form]]:
    """What to complete a spec's quasi-velocities with first: other coordinates' velocities, or their own rows of minors, as if they
    were constraints.  Beside the velocity of a body along its axis that is the one across it.
    """
    yield from list_orders(system, pool)
    held = replace(system, constraints=(*system.constraints, *forms))
    adapted = adapted_forms(held, to_the_left=True) or ()
    if any(form.name not in system.q_names for form in adapted):
        yield adapted


_Weighed = tuple[tuple[int, bool, float], tuple[Form, ...]]
"""How weak a completion is, smaller is better, and its forms."""


def _soundest(
    system: System, weighed: Sequence[_Weighed], axes: Sequence[Axes], *, bare: bool
) -> tuple[int, tuple[Form, ...]]:
    """At how many trial points the best of the completions is weak, and that one; those on ``axes`` are the last."""
    (weak, halved, size), best = least = min(weighed, key=lambda found: found[0])
    if len(weighed) > 1 and weak and weak_where_constraints_are_not(system, (*system.constraints, *best)):
        # it may be weak more seldom than others; but it would be given up where it is
        lost = [weak_where_constraints_are_not(system, (*system.constraints, *made)) for _, made in weighed]
        (weak, halved, size), best = least = weighed[min(range(len(lost)), key=lambda k: (lost[k], weighed[k][0]))]
    first = len(weighed) - sum(len(found.pools) for found in axes)
    if least in weighed[first:]:  # one that leads along the heading's own body is shorter
        alike = ((own, made) for (*whole, own), made in weighed[first:] if whole == [weak, halved])
        best = next(made for own, made in alike if own <= size + _ALIKE)
    elif bare and all(form.name in system.q_names for form in best):
        # by the trial points alone nobody knows where the velocities of coordinates are singular
        for (own, _, _), made in weighed[:first]:
            minors = own <= weak and any(form.name not in system.q_names for form in made)
            if minors and not may_vanish(system, [*system.constraints, *made]):
                return own, made
    return weak, best


def _along_rows(
    system: System, forms: Sequence[Form], best: tuple[Form, ...], pool: Sequence[Form]
) -> tuple[Form, ...]:
    """The completion that follows the order of many rows, where it is as sound as the best one at ordinary states.

    The determinant of many rows says little: it is small where each velocity follows from those before it, too.  What counts is
    that the free velocities are independent on what the constraints allow.  Where a train runs backwards, say, those of its head
    are not: its tail swings out by a power of the number of wagons.  Then some of the head and some of the tail are better.
    """
    wanted, points = system.n - system.l, ordinary_points(system)
    along = adapted_forms(system) or stepwise_forms(system, order_stepwise(system)) or ()
    ordered = _extend(system, forms, wanted, [*along, *pool])
    least = weak_where_constraints_are_not(system, (*system.constraints, *best))
    if (
        weak_where_constraints_are_not(system, (*system.constraints, *ordered)) <= least
        and independence(system, ordered, points) >= SOUND
    ):
        return ordered
    every = [coordinate_form(system, j) for j in range(system.n)]
    strong = _extend(system, forms, wanted, [*strongest(system, forms, [every], points, SOUND), *pool])
    return max(best, strong, key=lambda made: independence(system, made, points))


def _pools(system: System, bare: bool) -> tuple[list[list[Form]], list[Axes]]:
    """Forms to complete with, the preferred ones first: what the spec's dependent velocities leave free, what nhc's
    own choice of them leaves free, and the adapted coframe; each ends with whatever coordinate is still needed.  Where there is no
    adapted one and the spec gives no velocities (``bare``), those along the axes of bodies follow, with what is known of these.

    Where all constraints are equations of positions, that of the constraints in turn takes the place of an adapted one: the minors
    of a row vanish together only where its equation has no slope, as for rods between points.  Of three new velocities only two
    have minors, which may vanish by themselves: small mechanisms of this kind are left to multipliers.
    """
    every = [coordinate_form(system, j) for j in range(system.n)]
    choices = [system.dependent] if system.dependent else []
    choices.append(choose_dependent(system).dependent)
    pools = [[every[j] for j in range(system.n) if j not in dependent] + every for dependent in choices]
    adapted = adapted_forms(system)
    held = all(form.equation is not None for form in system.constraints)
    if adapted is None and held:
        steps = order_stepwise(system)
        in_pairs = all(step.pivot is not None or len(step.columns) < 3 for step in steps or ())
        adapted = stepwise_forms(system, steps) if in_pairs or system.n > _FEW_COORDINATES else None
    if adapted is not None:
        pools.append([*along_headings(system, adapted), *every])
    turning = bare and system.l <= MANY_ROWS and all(form.name in system.q_names for form in adapted or ())
    axes = on_axes(system, unused_name(system, [])) if turning else []
    return [*pools, *([*own, *every] for found in axes for own in found.pools)], axes


def turning_choices(system: System, forms: Sequence[Form] = ()) -> list[tuple[Form, ...]]:
    """Completions of ``forms`` by angular velocities and other velocities, which differ in what the constraints take."""
    pools = _turning_pools(system, [coordinate_form(system, j) for j in range(system.n)])
    return _in_one_order([_extend(system, forms, system.n - system.l, pool) for pool in pools], pools[0])


def _least_weak_turning(system: System, forms: Sequence[Form]) -> tuple[Form, ...]:
    """The completion by angular and other velocities that is least weak at the scenes' starts, the first of equals.

    Where each that :func:`turning_choices` offers is singular there, the starts themselves say which velocities are free.
    """
    candidates = turning_choices(system, forms)
    best = max(candidates, key=lambda made: round(_least_at_starts(system, made), 2))
    best = _on_free_axes(system, forms, best)
    if _least_at_starts(system, best) >= _WEAK**system.l:
        return with_places(system, forms, _with_edges(system, forms, best))
    pool = _turning_pools(system, [coordinate_form(system, j) for j in range(system.n)])[0]
    angular = [form for form in pool if any(form is quasi for quasi in system.quasi)]
    # the rates of quaternions may be regular at more places, but nobody speaks in them
    strong = strongest(system, forms, [angular, pool[len(angular) : -system.n]], _start_points(system))
    made = _in_one_order([_extend(system, forms, system.n - system.l, [*strong, *pool])], pool)
    soundest = max([best, *made], key=lambda made: round(_least_at_starts(system, made), 2))
    return with_places(system, forms, soundest)


def _on_free_axes(system: System, forms: Sequence[Form], best: tuple[Form, ...]) -> tuple[Form, ...]:
    """``best`` with an angular velocity on the other axes where constraints take a part of it and fewer pivots may vanish so."""
    names = {form.name for form in best}
    taken = [not names.issuperset(rotation.velocities) for rotation in system.spec.rotations]
    if not any(taken) or not (weak := count_weak(system, best)):
        return best
    for own, part in zip(turned_omegas(system), taken, strict=True):
        for k in (0, 2, 1) if part else ():
            trial = _extend(system, forms, system.n - system.l, [*own[k:], *own[:k], *best[len(forms) :]])
            if count_weak(system, trial) < weak and _least_at_starts(system, trial) >= _WEAK**system.l:
                return trial
    return best


def _with_edges(system: System, forms: Sequence[Form], best: tuple[Form, ...]) -> tuple[Form, ...]:
    """``best`` with other velocities than the first coordinates', those along knife edges, where fewer pivots may vanish."""
    added = best[len(forms) :]
    bare = [form for form in added if form.name in system.q_names]
    if not bare or system.l == len(system.rotations):
        return best
    places = [k for rotation in system.rotations for k in rotation.places]
    regular = [form for form in adapted_forms(system) or () if not any(form.coefficients[k] for k in places)]
    angular = [form for form in added if form.name not in system.q_names]
    trial = _extend(system, forms, system.n - system.l, [*angular, *regular, *bare])
    if {form.name for form in trial} == {form.name for form in best}:
        return best
    if _least_at_starts(system, trial) < _WEAK**system.l or count_weak(system, trial) >= count_weak(system, best):
        return best
    return trial


def with_places(system: System, forms: Sequence[Form], best: tuple[Form, ...]) -> tuple[Form, ...]:
    """``best``, or the velocities of coordinates before angular ones, where these are regular where it is and T is simpler in them.

    Of a ball in a cone the angular velocity has a full matrix that moves; with the rates of its place and the spin about the normal
    the matrix is diagonal and holds the distance from the tip alone.  Where constraints hold roots, as those of a paraboloid's
    normal, what cancels there is too long to be seen, and other velocities come out longer.
    """
    if system.n > _MOST_PLACES:
        return best
    g, every = system.graph, [coordinate_form(system, j) for j in range(system.n)]
    written = [form_value(system, form) for form in system.constraints]
    if any(g.op[node] in ("sqrt", "powf") for node in reachable(g, written)):
        return best
    pools = _turning_pools(system, every)
    free = [form for form in pools[0][: -system.n] if form.name in system.q_names]
    spun = spins(system)
    first = [own for own in ([*free, *spun], free) if own]
    made = [_extend(system, forms, system.n - system.l, [*own, *pool]) for own in first for pool in pools]
    least, simplest = min(_least_at_starts(system, best), _WEAK**system.l), _moving_entries(system, best)
    weak = weak_factors(system, best)
    for trial in _in_one_order(made, [*spun, *pools[0]]):
        if {form.name for form in trial} == {form.name for form in best}:
            continue
        entries = _moving_entries(system, trial)
        if entries < simplest and _least_at_starts(system, trial) >= least and weak_factors(system, trial) <= weak:
            best, simplest = trial, entries
    return best


def _moving_entries(system: System, made: Sequence[Form]) -> tuple[int, int]:
    """How many entries of T's matrix in these velocities move, and how many are off its diagonal; all where it has no value."""
    size = len(made) * len(made)
    frame = make_frame(system, made, [velocity_symbol(system, form) for form in made])
    one, other = (free_energy(system, frame, dict(place)) for place in trial_points(system)[-2:])
    if not one or not other:
        return size, size
    pairs = [(i == k, one[i][k], other[i][k]) for i in range(len(one)) for k in range(i + 1)]
    least = _SAME * max((abs(x) for _, x, _ in pairs), default=0.0)
    moving = sum(abs(x - y) > least for _, x, y in pairs)
    return moving, sum(not own and max(abs(x), abs(y)) > least for own, x, y in pairs)


def _turning_pools(system: System, every: Sequence[Form]) -> list[list[Form]]:
    """Angular velocities first, then the velocities of coordinates that are no quaternion's.

    Where constraints take some of the angular velocities, the order says which: each rotation's components in turn, the first
    body's or the last one's.
    """
    places = {k for rotation in system.rotations for k in rotation.places}
    by_name = {form.name: form for form in system.quasi}
    groups = [[by_name[w] for w in rotation.velocities if w in by_name] for rotation in system.spec.rotations]
    rest = [*(form for j, form in enumerate(every) if j not in places), *every]
    orders = [groups, groups[::-1]] if len(groups) > 1 else [groups]
    turned = [[form for group in order for form in (*group[k:], *group[:k])] for k in (0, 2, 1) for order in orders]
    return [[*own, *rest] for own in turned]


def _extend(system: System, forms: Sequence[Form], wanted: int, pool: Sequence[Form]) -> tuple[Form, ...]:
    """The forms with the first of the pool that are independent of them and of the constraints."""
    made = list(forms)
    rows = [list(f.coefficients) for f in (*system.constraints, *made)]
    first = [*made, *pool[: wanted - len(made)]]
    trial = [list(f.coefficients) for f in (*system.constraints, *first)]
    if rank(system.graph, trial) == len(trial):  # as nearly always; one by one takes n times as long
        return tuple(first)
    for form in pool:
        if len(made) == wanted:
            break
        trial = [*rows, list(form.coefficients)]
        if rank(system.graph, trial) == len(trial):
            rows = trial
            made.append(form)
    return tuple(made)


def _in_one_order(candidates: Sequence[tuple[Form, ...]], pool: Sequence[Form]) -> list[tuple[Form, ...]]:
    """Different choices, each in the order of the pool (what the user gave stays in front)."""
    rank_of = {id(form): k for k, form in reversed(list(enumerate(pool)))}
    sets: dict[tuple[int, ...], tuple[Form, ...]] = {}
    for made in candidates:
        ordered = tuple(sorted(made, key=lambda form: rank_of.get(id(form), -1)))
        sets.setdefault(tuple(id(form) for form in ordered), ordered)
    return list(sets.values())


def _least_at_starts(system: System, made: Sequence[Form]) -> float:
    """How near to singular the coframe comes at the scenes' starts and beside them."""
    matrices = sampled_rows(system, (*system.constraints, *made), _start_points(system))
    return min((relative_determinant(m, range(system.n)) ** system.n for m in matrices), default=0.0)


def _start_points(system: System) -> list[dict[Node, float]]:
    points = ordinary_points(system)  # the last two are those of no scene
    return points[:-2] or points


def spelled(system: System, form: Form) -> str:
    """The velocity of a form as the language writes it."""
    return f"{form.name}'" if form.name in system.q_names else form.name
