"""Where a choice is regular: bounds, measures at trial points, and the choice of dependent velocities."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import combinations

from nhc.algebra.bounds.interval import Interval, cannot_vanish
from nhc.algebra.dense import Singular
from nhc.algebra.evaluate import evaluate_into
from nhc.algebra.graph import Graph, Node
from nhc.algebra.minors import list_entries, relative_minors, row_size, subtract
from nhc.algebra.polynomial import normalise
from nhc.algebra.solving.blocks import block_order, determinant_of
from nhc.algebra.walks import reachable
from nhc.mechanics.regular.trials import sampled_rows, scattered_points, start_points, trial_points
from nhc.mechanics.system import Form, System
from nhc.mechanics.values import coordinate_ranges, parameter_ranges
from nhc.records import record

_WEAK = 0.03  # of the largest determinant that rows of these lengths can have (per row)
_SAME = 1e-9  # by which the sizes of a determinant differ that is the same at all states
_NOTHING = 1e-9  # what rounding leaves of a pivot
_MANY = 250  # subsets of columns that are tried one by one
_LARGEST = 5  # rows of a block whose determinant is expanded
_JUDGED = 8  # choices whose determinants are looked at


@record
class Choice:
    """Dependent velocities with the determinant of their block; ``regular`` if it can be shown never to vanish."""

    dependent: tuple[int, ...]
    determinant: Node | None
    regular: bool


def intervals(system: System) -> dict[Node, Interval]:
    """Parameters over their values in the spec and its scenes, coordinates over their declared ranges."""
    return {**parameter_ranges(system), **coordinate_ranges(system)}


def relative_determinant(matrix: Sequence[Sequence[float]], columns: Sequence[int]) -> float:
    """|det| of the columns over the product of the norms of the whole rows (Hadamard), its l-th root: in [0, 1]."""
    return relative_minors(matrix, [columns])[0]


def pivot_weakness(system: System) -> Callable[[Sequence[Node], Sequence[Node]], list[int]]:
    """A measure for elimination: at how many trial points a pivot is small against its row (its scale).

    Each pivot is made of those before it, so that a point remembers their values; one where some have none is out.
    """
    points: list[dict[Node, float]] = []
    walked = set[Node]()

    def measure(pivots: Sequence[Node], scales: Sequence[Node]) -> list[int]:
        if not walked:
            points.extend(map(dict, trial_points(system)))
        new = reachable(system.graph, [*pivots, *scales], known=walked)
        walked.update(new)
        points[:] = [point for point in points if _add_values(point, system, new)]
        pairs = list(zip(pivots, scales, strict=True))
        return [sum(not abs(point[d]) > _WEAK * abs(point[scale]) for point in points) for d, scale in pairs]

    return measure


def _add_values(point: dict[Node, float], system: System, nodes: Sequence[Node]) -> bool:
    try:
        evaluate_into(point, system.graph, nodes)
    except (ArithmeticError, ValueError):
        return False
    return True


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
    norms = [max(math.sqrt(sum(x * x for x in row)), 1e-300) for row in work]
    sizes = [max(map(abs, row)) / norm for row, norm in zip(work, norms, strict=True)]
    for step in range(len(work)):
        best = max(sizes[step:])
        if best < least:
            return False
        i = sizes.index(best, step)
        j = max(range(len(work[i])), key=lambda j: abs(work[i][j]))
        work[step], work[i] = work[i], work[step]
        norms[step], norms[i] = norms[i], norms[step]
        sizes[step], sizes[i] = sizes[i], sizes[step]
        entries = list_entries(work[step])
        for k in range(step + 1, len(work)):
            if work[k][j]:
                subtract(work[k], entries, work[k][j] / work[step][j])
                sizes[k] = max(map(abs, work[k])) / norms[k]
    return True


def coframe_weakness(system: System, forms: Sequence[Form]) -> tuple[int, float]:
    """The weakness of n forms as a coframe."""
    every = range(system.n)
    return weakness([relative_determinant(matrix, every) for matrix in sampled_rows(system, forms)])


def choose_dependent(system: System) -> Choice:
    """The l velocities to solve for: never singular where there is such a choice, else singular as rarely as possible.

    The graph keeps the choice: a system with other values in constraints of the same names has the same one.
    """
    known: dict[tuple[str, ...], Choice] = system.graph.memory.setdefault("dependent velocities", {})
    names = tuple(form.name for form in system.constraints)
    if names not in known:
        known[names] = _choose(system)
    return known[names]


def _choose(system: System) -> Choice:
    n, lower = system.n, system.l
    if lower == 0:
        return Choice((), system.graph.one, True)
    samples = sampled_rows(system, system.constraints)
    begun = sampled_rows(system, system.constraints, start_points(system))
    if not any(_full_rank(matrix, _NOTHING) for matrix in samples):
        samples, begun = sampled_rows(system, system.constraints, scattered_points(system)), []
    if math.comb(n, lower) <= _MANY:
        candidates = [list(c) for c in combinations(range(n), lower)]
    else:
        chosen = [
            _greedy(system, points) for points in (begun, [*begun, *samples[-3:]], samples[-3:] or samples) if points
        ]
        candidates = [list(columns) for columns in dict.fromkeys(map(tuple, chosen))]
    own = _own_columns(system, samples)
    scored = score(candidates, samples, begun, _JUDGED)
    best: Choice | None = None
    for k, (first, weak, _, _, columns) in enumerate(scored):
        if k >= _JUDGED and best is not None:
            break
        choice = judge(system, tuple(columns))
        if choice.determinant == system.graph.zero:
            continue  # rows that are nearly one another: all choices look alike in numbers
        if best is None or (choice.regular and not best.regular):
            best = choice
        if best.regular or (first, weak) > scored[0][:2]:
            break
    best = best or judge(system, tuple(scored[0][-1]))
    if own and not all(set(columns) & set(best.dependent) for columns in own):
        return judge(system, tuple(sorted(columns[0] for columns in own)))
    return best


def score(
    candidates: Sequence[Sequence[int]],
    samples: Sequence[Sequence[Sequence[float]]],
    begun: Sequence[Sequence[Sequence[float]]],
    enough: int,
) -> list[tuple[int, int, bool, float, list[int]]]:
    """(how often lost at the scenes' starts, how often weak, whether its determinant changes, how weak, columns) of each candidate,
    the best first.

    Where ``enough`` are lost less often than the others, these come behind them in any case and are left out.
    """
    if not candidates:
        return []
    begin = [relative_minors(matrix, candidates) for matrix in begun]
    lost = [sum(row[k] < _WEAK for row in begin) for k in range(len(candidates))]
    most = sorted(lost)[min(enough, len(lost)) - 1]
    left = [k for k, times in enumerate(lost) if times <= most]
    minors = [relative_minors(matrix, [candidates[k] for k in left]) for matrix in samples]
    sizes = [row_size(matrix) ** (1.0 / len(matrix)) for matrix in samples]
    scored = []
    for place, k in enumerate(left):
        values = [row[place] for row in minors]
        weak, strength = weakness(values)
        whole = [value * size for value, size in zip(values, sizes, strict=True)]
        changes = not whole or max(whole) - min(whole) > _SAME * max(whole)
        scored.append((lost[k], weak, changes, strength, list(candidates[k])))
    return sorted(scored)


def ranked(system: System, columns: Sequence[int], fits: Callable[[Sequence[int]], bool]) -> list[Choice]:
    """Every choice of dependent velocities among ``columns`` alone that ``fits`` and is not singular at all the trial points, those
    that never are first, then in the order of :func:`choose_dependent`; none where there are too many to try.
    """
    if math.comb(len(columns), system.l) > _MANY:
        return []
    samples = sampled_rows(system, system.constraints)
    begun = sampled_rows(system, system.constraints, start_points(system))
    candidates = [list(c) for c in combinations(columns, system.l)]
    scored = score(candidates, samples, begun, len(candidates))
    found = [judge(system, tuple(chosen)) for _, weak, _, _, chosen in scored if weak < len(samples) and fits(chosen)]
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
            entries = list_entries(matrix[row])
            for i in range(row + 1, system.l):
                if matrix[i][best]:
                    subtract(matrix[i], entries, matrix[i][best] / pivot)
    return sorted(chosen)


def judge(system: System, dependent: tuple[int, ...]) -> Choice:
    """The block's determinant in canonical form (None for what is large) and whether it can vanish."""
    g, known = system.graph, intervals(system)
    block = [[form.coefficients[j] for j in dependent] for form in system.constraints]
    factors = [block] if len(block) <= _LARGEST else _diagonal_blocks(g, block)
    if any(len(factor) > _LARGEST for factor in factors):
        return Choice(dependent, None, False)
    determinants = [normalise(g, determinant_of(g, factor), 200) for factor in factors]
    still = [x for x in determinants if not g.deps[x] & g.mask((*system.q, system.t))]
    whole = g.product([normalise(g, g.product(still), 200), *(x for x in determinants if x not in still)])
    return Choice(dependent, whole, all(cannot_vanish(g, x, known) for x in determinants))


def _diagonal_blocks(graph: Graph, block: Sequence[Sequence[Node]]) -> list[list[list[Node]]]:
    """Blocks whose determinants have the block's as their product: wheels follow from the body that they carry.

    The first has its first row with the other sign where rows and columns change places an odd number of times.
    """
    size = len(block)
    try:
        parts = block_order(size, lambda i, j: block[i][j] != graph.zero)
    except Singular:
        return [[[graph.zero]]]
    blocks = [[[block[i][j] for j in part[1]] for i in part[0]] for part in parts]
    rows, columns = ([place for part in parts for place in part[k]] for k in (0, 1))
    if _is_odd(rows) != _is_odd(columns):
        blocks[0][0] = [graph.neg(entry) for entry in blocks[0][0]]
    return blocks


def _is_odd(order: Sequence[int]) -> bool:
    return sum(x > y for k, x in enumerate(order) for y in order[k + 1 :]) % 2 == 1
