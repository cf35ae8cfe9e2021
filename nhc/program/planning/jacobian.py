"""d rhs / d y: written out where that is short, else in sweeps, one direction or one row in each pass.

Written out, the code grows as rows times columns, and compilers take long over it.  In a sweep the statements stand once and
are passed through once for each column (a directional derivative of all rows) or once for each row (its gradient); what the
passes share is computed before them.  The velocities' rows are written out too where they are short or have many columns.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.algebra.calculus import gradient, pullback_gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.walks import count, reachable
from nhc.program.plan import Entry, FunctionPlan, SolvePlan, SweepPlan, Target
from nhc.program.planning.base import PlannerBase
from nhc.program.planning.mass_route import Solver
from nhc.records import record

LONGEST = 1500
"""Operations of the rates' rows, roughly, beyond which they are not written out."""
SPARED, SLOWER = 150, 1.5
"""Operations that a sweep over the velocities must save, and how many times as many its passes may take, two at once."""
WORTH = 0.8
"""Of a pass, what one over forces and accelerations along a tree may take to be preferred: what the passes share is longer."""

_SLOPES = 3
"""Operations of a gradient for each of those that it is the gradient of: about as many at most (Baur and Strassen 1983)."""


@record
class Slopes:
    """Entries row by row (written out), or sweeps in their place; the dense solves that the entries need."""

    entries: tuple[tuple[Node, ...], ...] = ()
    sweeps: tuple[SweepPlan, ...] = ()
    solves: tuple[SolvePlan, ...] = ()


def plan_jacobian(planner: PlannerBase) -> FunctionPlan:
    """The plan of ``jacobian``: row i, column j stands at i*NY + j."""
    g, motion, y = planner.graph, planner.equations.motion, planner.y_nodes
    size = len(y)
    slopes = differentiate_rates(planner) if motion.rates else Slopes()
    rows, swept = differentiate_velocities(planner)
    rows += slopes.entries
    plan = planner.plan(
        "jacobian",
        "Jacobian matrix of rhs, d rhs_i / d y_j",
        planner.equations.number,
        [Entry(node) for row in rows for node in row],
        planner.frame_guards() + planner.mass_guards,
        slopes.solves,
        size=size * size,
    )
    targets = tuple(target for target in plan.targets if target.node != g.zero)
    return replace(plan, targets=targets, sweeps=(*swept, *slopes.sweeps))


def differentiate(graph: Graph, nodes: Sequence[Node], wrt: Sequence[Node]) -> list[list[Node]]:
    """The rows d node / d symbol, by columns or by rows, whichever takes fewer operations."""
    columns = [tangent(graph, nodes, {symbol: graph.one}) for symbol in wrt]
    forward = [list(row) for row in zip(*columns, strict=True)] if nodes else []
    backward = [gradient(graph, node, wrt) for node in nodes]
    found = (forward, backward)
    return min(found, key=lambda rows: count(graph, [*nodes, *(entry for row in rows for entry in row)]))


def differentiate_velocities(planner: PlannerBase) -> tuple[list[Sequence[Node]], tuple[SweepPlan, ...]]:
    """The rows of the velocities written out, but for the coordinates' columns where a sweep is shorter, and this sweep."""
    g, y, split = planner.graph, planner.y_nodes, len(planner.kept_q)
    nodes = [planner.equations.motion.velocities[i] for i in planner.kept_q]
    rows = differentiate(g, nodes, y)
    left = [[*([g.zero] * split), *row[split:]] for row in rows]
    written, rest = (count(g, [*nodes, *(entry for row in made for entry in row)]) for made in (rows, left))
    if written - rest < SPARED:
        return list(rows), ()
    active = [j for j in range(split) if any(row[j] != g.zero for row in rows)]
    seeds = {y[j]: g.symbol(f"turn_{j}", "direction") for j in active}
    targets = _targets(g, tangent(g, nodes, seeds), [i * len(y) for i in range(split)])
    about = "one coordinate in each pass: a column of the velocities' rows"
    sweep = SweepPlan(about, tuple(seeds.values()), tuple(active), targets)
    once = count(g, [*nodes, *(target.node for target in targets)]) - count(g, nodes)
    short = written - rest - once >= SPARED and once * len(active) <= 2 * SLOWER * (written - rest)
    return (list(left), (sweep,)) if short and targets else (list(rows), ())


def differentiate_rates(planner: PlannerBase) -> Slopes:
    """The rows of the rates: differentiated themselves where a tree keeps them short, else by force - mass w' = 0.

    The latter takes the factors that are at hand, and no derivative of them.
    """
    g, y = planner.graph, planner.y_nodes
    if not planner.equations.definite:
        return _solve_densely(planner)
    route = planner.route
    solve = None if route.short else route.solve
    rates = planner.known(planner.equations.motion.rates) if solve is None else _shorter_residual(planner)
    backward = sweep_rows(planner, rates, solve)
    kept = [rates[k] for k in planner.kept_w]
    if len(kept) * _cost(g, backward) > LONGEST:
        sparse = _write_sparse(g, kept, y, backward) if solve is None else None
        if sparse is not None:
            return Slopes(tuple(map(tuple, sparse)))
        if solve is None and route.residual is not None and route.solve is not None:
            residual = route.residual(planner.equations.motion.rates)
            along = sweep_rows(planner, residual, route.solve)
            if _cost(g, along) <= WORTH * _cost(g, backward):
                rates, solve, backward = residual, route.solve, along
        active = sum(1 for symbol in y if any(g.deps[node] & g.deps[symbol] for node in rates))
        if 2 * len(backward.offsets) <= active:  # a pass by columns takes about as long as one by rows
            return Slopes((), (backward,))
        forward = sweep_columns(planner, rates, solve)
        return Slopes((), min(((backward,), forward), key=lambda sweeps: _passes(g, sweeps)))
    if solve is None:
        return Slopes(tuple(map(tuple, differentiate(g, kept, y))))
    slopes = zip(*(gradient(g, node, y) for node in rates), strict=True)
    solved = [solve(planner.known(column)) for column in slopes]
    flat = shorten(g, [node for column in solved for node in column])
    size = len(rates)
    return Slopes(tuple(tuple(flat[j * size + k] for j in range(len(y))) for k in planner.kept_w))


def _shorter_residual(planner: PlannerBase) -> list[Node]:
    """force - mass w': by the matrix, or along a tree where one was read and that is less; the solve behind it is the same."""
    g, residual = planner.graph, planner.route.residual
    dense = make_residual(planner, *planner.dense_system())
    if residual is None or len(planner.kept_w) * count(g, dense) <= LONGEST:
        return dense
    return min((dense, residual(planner.equations.motion.rates)), key=lambda nodes: count(g, nodes))


def make_residual(planner: PlannerBase, matrix: Sequence[Sequence[Node]], right: Sequence[Node]) -> list[Node]:
    """right - matrix x, row by row, where x are the rates' symbols and those of the multipliers."""
    g = planner.graph
    unknowns = (*planner.equations.motion.rates, *planner.equations.multipliers)
    return [g.sub(value, g.dot(row, unknowns)) for row, value in zip(matrix, right, strict=True)]


def _solve_densely(planner: PlannerBase) -> Slopes:
    """The columns as unknowns of a second dense solve; where they are long, the rows of the inverse as weights of a sweep."""
    g, y = planner.graph, planner.y_nodes
    matrix, right = planner.dense_system()
    residual = make_residual(planner, matrix, right)
    if all(matrix[i][j] == matrix[j][i] for i in range(len(matrix)) for j in range(i)):
        swept = _sweep_densely(planner, matrix, right, residual)
        if len(planner.kept_w) * sum(_cost(g, sweep) for sweep in swept.sweeps) > LONGEST:
            return swept
    columns = [list(column) for column in zip(*(gradient(g, node, y) for node in residual), strict=True)]
    held = {j: [g.symbol(f"d{i}_{j}", "unknown") for i in range(len(matrix))] for j in range(len(y)) if any(columns[j])}
    solves = (*planner.solves, planner.plan_dense_solve(matrix, [columns[j] for j in held], list(held.values())))
    rows = tuple(tuple(held[j][k] if j in held else g.zero for j in range(len(y))) for k in planner.kept_w)
    return Slopes(rows, (), solves if held else planner.solves)


def _sweep_densely(
    planner: PlannerBase, matrix: Sequence[Sequence[Node]], right: Sequence[Node], residual: Sequence[Node]
) -> Slopes:
    """A pass for each rate: the pull-back of the residual by its row of the symmetric matrix' inverse."""
    g, y, size = planner.graph, planner.y_nodes, len(matrix)
    unknowns = (*planner.equations.motion.rates, *planner.equations.multipliers)
    inverse = {k: [g.symbol(f"d{k}_{i}", "unknown") for i in range(size)] for k in planner.kept_w}
    units = [[g.one if i == k else g.zero for i in range(size)] for k in inverse]
    solve = planner.plan_dense_solve(matrix, [right, *units], [unknowns, *inverse.values()])
    seeds = [g.symbol(f"row_{k}", "direction") for k in inverse]
    weights = [
        g.sum([g.mul(seed, row[i]) for seed, row in zip(seeds, inverse.values(), strict=True)]) for i in range(size)
    ]
    slopes = pullback_gradient(g, list(zip(residual, weights, strict=True)), y)
    first = len(planner.kept_q)
    offsets = tuple((first + i) * len(y) for i in range(len(seeds)))
    about = "one rate in each pass: its row of the matrix"
    return Slopes((), (SweepPlan(about, tuple(seeds), offsets, _targets(g, slopes, range(len(y)))),), (solve,))


def sweep_rows(planner: PlannerBase, nodes: Sequence[Node], solve: Solver | None) -> SweepPlan:
    """A pass for each rate, the pull-back to y of its row: of the rates themselves without ``solve``, else of the residual.

    The residual's weights are a row of the inverse mass matrix.
    """
    g, y = planner.graph, planner.y_nodes
    unit = {k: g.symbol(f"row_{k}", "direction") for k in planner.kept_w}
    seeds = [unit.get(k, g.zero) for k in range(len(nodes))]
    weights = seeds if solve is None else solve(seeds)
    slopes = pullback_gradient(g, list(zip(nodes, weights, strict=True)), y)
    targets = _targets(g, planner.known(slopes), range(len(y)))
    first = len(planner.kept_q)
    offsets = tuple((first + i) * len(y) for i in range(len(unit)))
    return SweepPlan("one rate in each pass: its row of the matrix", tuple(unit.values()), offsets, targets)


def sweep_columns(planner: PlannerBase, nodes: Sequence[Node], solve: Solver | None) -> tuple[SweepPlan, ...]:
    """A pass for each coordinate, and in a sweep of their own one for each velocity: the rates' slopes along it."""
    y, split = planner.y_nodes, len(planner.kept_q)
    coordinates, velocities = range(split), range(split, len(y))
    found = (_sweep_group(planner, nodes, group, solve) for group in (coordinates, velocities))
    return tuple(sweep for sweep in found if sweep.targets)


def _sweep_group(planner: PlannerBase, nodes: Sequence[Node], group: Sequence[int], solve: Solver | None) -> SweepPlan:
    g, y = planner.graph, planner.y_nodes
    active = [j for j in group if any(g.deps[node] & g.deps[y[j]] for node in nodes)]
    seeds = {y[j]: g.symbol(f"along_{j}", "direction") for j in active}
    slopes = planner.known(tangent(g, nodes, seeds))
    solved = slopes if solve is None else solve(slopes)
    first = len(planner.kept_q)
    rows = [(first + i) * len(y) for i in range(len(planner.kept_w))]
    targets = _targets(g, [solved[k] for k in planner.kept_w], rows)
    return SweepPlan(
        "one direction in each pass: a column of the matrix", tuple(seeds.values()), tuple(active), targets
    )


def _targets(graph: Graph, nodes: Sequence[Node], places: Sequence[int]) -> tuple[Target, ...]:
    pairs = zip(places, nodes, strict=True)
    return tuple(Target(place, node) for place, node in pairs if node != graph.zero)


def _write_sparse(graph: Graph, rates: Sequence[Node], y: Sequence[Node], sweep: SweepPlan) -> list[list[Node]] | None:
    """The rates' rows where each is made of so little that written out they are short, or hardly longer than one pass for all."""
    mask, once = graph.mask(y), _cost(graph, sweep)
    most = _SLOPES * sum(len(reachable(graph, [rate], mask)) for rate in rates)
    if most > 4 * LONGEST and 2 * most > once * len(rates):
        return None  # it would take long to see
    rows = differentiate(graph, rates, y)
    written = count(graph, [*rates, *(entry for row in rows for entry in row)]) - count(graph, rates)
    return rows if written <= max(2 * once, LONGEST) else None


def _cost(graph: Graph, sweep: SweepPlan) -> int:
    """Operations of one pass."""
    mask = graph.mask(sweep.seeds)
    kids = graph.kids
    return sum([1 for n in reachable(graph, [target.node for target in sweep.targets], mask) if kids[n]])


def _passes(graph: Graph, sweeps: Sequence[SweepPlan]) -> int:
    """Operations of all passes together, and once more for their code."""
    return sum(_cost(graph, sweep) * (len(sweep.offsets) + 1) for sweep in sweeps)
