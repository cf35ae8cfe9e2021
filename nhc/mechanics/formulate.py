"""Formulation -> Equations: one builder for all of them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from nhc.algebra.dense import pivot_signs
from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.shorten import shorten
from nhc.algebra.walks import count
from nhc.mechanics.associate import Equations, Matrix, Projector, Row
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.energies.kinetic import Kinetic, kinetic_structure
from nhc.mechanics.frame import coordinate_frame, form_value, total_derivative
from nhc.mechanics.motion import Motion
from nhc.mechanics.moving.move import move
from nhc.mechanics.moving.moved import Moved
from nhc.mechanics.moving.on_body import move_on_bodies
from nhc.mechanics.moving.structure import move_by_structure
from nhc.mechanics.regular.determined import check_determined
from nhc.mechanics.regular.trials import trial_points
from nhc.mechanics.rotations.turning import moving
from nhc.mechanics.spherical_tops import turn_tops
from nhc.mechanics.system import System
from nhc.mechanics.trees import FEW
from nhc.mechanics.uniform import at_rest, drop_uniform
from nhc.mechanics.values import scene_values
from nhc.records import record

if TYPE_CHECKING:
    from nhc.mechanics.trees.tree import Elimination

_FEW_ROWS = 40
"""Coordinates times constraints up to which reactions are also made row by row."""
_SHORTER = 0.9
"""What rows at rest have to take of the operations of those in uniform motion."""
_SMALL = 400
"""Operations up to which a second route is worth a try."""
_WORTH_BRACKETS = 120
"""Operations from which constant brackets are looked for."""
_WORTH_AXES = 100
"""Operations of Lagrange's equations from which moving axes are tried."""


def motion_of(system: System, formulation: Formulation) -> Motion:
    """The kept velocities with their rates, and the kinematics."""
    g, frame = system.graph, formulation.frame
    if frame is None:
        unit = tuple(tuple(g.one if i == j else g.zero for i in range(system.n)) for j in range(system.n))
        return Motion(system.v, rate_symbols(system, system.v), system.v, unit)
    return Motion(frame.free, rate_symbols(system, frame.free), frame.kinematics, frame.free_vectors)


def rate_symbols(system: System, w: Sequence[Node]) -> tuple[Node, ...]:
    """Symbols for the rates of the kept velocities."""
    g = system.graph
    symbols = [g.symbol_of(node) for node in w]
    return tuple(g.symbol(s.name, "acceleration" if s.kind == "velocity" else "rate") for s in symbols if s is not None)


@record
class _Route:
    """One way to the rows of a formulation; all ways agree in value."""

    motion: Motion
    guards: tuple[tuple[Node, Node], ...]
    rows: list[Row]
    react: Callable[[], tuple[Row, ...]]
    sweeps: Callable[[], tuple[tuple[Node, ...], ...]]
    kinetic: Callable[[], Node | None]

    def cost(self, graph: Graph) -> int:
        """Operations of the matrix, the right side and the kinematics; a single rate's as it will be solved."""
        entries = _entries(self.rows)
        if len(self.rows) == 1 and entries[0] != graph.zero:
            entries = shorten(graph, [graph.div(entries[1], entries[0])])
        return count(graph, [*self.motion.velocities, *entries])


def equations_of(system: System, formulation: Formulation, kinetic: Kinetic | None = None) -> Equations:
    """The associated system of a formulation's Omega, as mass matrix, right side, and rows of the reactions."""
    tree = _tree(system, formulation)
    if tree is not None:
        return _from_leaves(system, formulation, tree, kinetic)
    route, kinetic = _route_on_axes(system, formulation, kinetic)
    rows, motion = route.rows, route.motion
    bordered = formulation.name == "multipliers" and system.l > 0
    check_determined(system, [row.mass for row in rows], bordered=bordered)
    return Equations(
        system=system,
        formulation=formulation.name,
        number=formulation.number,
        motion=motion,
        assemble=lambda: _assemble(rows),
        definite=not bordered and (kinetic.is_positive() or _is_definite(system, rows)),
        multipliers=_multipliers(system) if bordered else (),
        react=route.react,
        sweeps=route.sweeps,
        kinetic=route.kinetic,
        guards=route.guards,
    )


def _multipliers(system: System) -> tuple[Node, ...]:
    from nhc.mechanics.formulations.multipliers import multiplier_symbols  # here, for it comes with all forms on paper

    return multiplier_symbols(system)


def _tree(system: System, formulation: Formulation) -> Elimination | None:
    """The elimination along the tree of a system without constraints, where it is worth it and T is surely positive."""
    if not _is_free(system, formulation) or system.n - system.l <= FEW:
        return None
    from nhc.mechanics.energies.whole_forms import whole_kinetic
    from nhc.mechanics.trees.choice import worthwhile_tree

    kinetic = whole_kinetic(system)
    if kinetic is None or not kinetic.is_positive():
        return None
    return worthwhile_tree(system, motion_of(system, formulation), kinetic)


def _is_free(system: System, formulation: Formulation) -> bool:
    """Whether nothing is constrained but the lengths of quaternions, and their rates are those of angular velocities."""
    frame = formulation.frame
    if not system.rotations:
        return frame is None and not system.l
    return frame is not None and len(frame.turned) == len(system.rotations) == system.l


def _from_leaves(system: System, formulation: Formulation, tree: Elimination, kinetic: Kinetic | None) -> Equations:
    """Equations whose matrix is assembled only when something else than the rates needs it."""

    def assemble() -> tuple[Matrix, tuple[Node, ...]]:
        return _assemble(dense().rows)

    def dense() -> _Route:
        return _route(system, formulation, kinetic or kinetic_structure(system))

    def react() -> tuple[Row, ...]:
        """Of the lengths of quaternions: nothing, where they are seen by the entries and angular velocities alone."""
        from nhc.mechanics.trees.covectors import Sweeps

        if Sweeps(system, motion.velocities).hides_quaternions([system.T, system.U]):
            return (Row((system.graph.zero,) * len(motion.w), system.graph.zero),) * system.l
        return dense().react()

    motion = motion_of(system, formulation)
    return Equations(
        system=system,
        formulation=formulation.name,
        number=formulation.number,
        motion=motion,
        assemble=assemble,
        definite=True,
        multipliers=(),
        react=react,
        sweeps=lambda: (),
        kinetic=lambda: None,
        guards=formulation.frame.guards if formulation.frame is not None else (),
        tree=tree,
    )


def _route_on_axes(system: System, formulation: Formulation, kinetic: Kinetic | None) -> tuple[_Route, Kinetic]:
    """The cheapest route, with the omega of spherical tops in space where no velocity of the motion is on their own axes."""
    frame = formulation.frame
    turned = turn_tops(system, frame) if frame is not None else None
    if turned is None:
        kinetic = kinetic or kinetic_structure(system)
        return _route_at_rest(system, formulation, kinetic), kinetic
    there, kinetic = turned[0], kinetic_structure(turned[0])
    route = _route_at_rest(there, replace(formulation, frame=turned[1]), kinetic)

    def energy() -> Node:
        return substitute(there.graph, [there.T], moving(there, route.motion.velocities))[0]

    return replace(route, kinetic=energy), kinetic


def _route_at_rest(system: System, formulation: Formulation, kinetic: Kinetic) -> _Route:
    """The cheapest route; on a floor that moves uniformly, with the rows of one at rest if these are the same and shorter."""
    found, g = _cheapest_route(system, formulation, kinetic), system.graph
    entries = _entries(found.rows)
    calm = None if formulation.frame is None else at_rest(system, formulation.frame, entries)
    if calm is None:
        return found
    other = _cheapest_route(calm[0], replace(formulation, frame=calm[1]), kinetic).rows
    same = are_zero(g, [g.sub(x, y) for x, y in zip(entries, _entries(other), strict=True)])
    shorter = count(g, _entries(other)) < _SHORTER * count(g, entries)
    return replace(found, rows=other) if all(same) and shorter else found


def _cheapest_route(system: System, formulation: Formulation, kinetic: Kinetic) -> _Route:
    """The cheapest of those on axes, or by the brackets of the frame where these are constant."""
    found, frame, g = _cheapest_on_axes(system, formulation, kinetic), formulation.frame, system.graph
    if frame is None or "constant brackets" in g.off or found.cost(g) < _WORTH_BRACKETS:
        return found
    moved = move_by_structure(system, frame)
    other = None if moved is None else _route(moved[0], formulation, kinetic, moved[1])
    return found if other is None or other.cost(g) >= found.cost(g) else other


def _cheapest_on_axes(system: System, formulation: Formulation, kinetic: Kinetic) -> _Route:
    """On moving axes where T has vectors for them; also on the spec's where that may be shorter and is soon tried."""
    frame = formulation.frame
    if frame is None and not system.constraints:
        return _without_constraints(system, formulation, kinetic)
    rule, way = ("body axes", move_on_bodies) if system.rotations else ("moving axes", move)
    moved = way(system, kinetic, frame) if frame is not None and rule not in system.graph.off else None
    if moved is None:
        return _route(system, formulation, kinetic)
    there = _route(system, formulation, kinetic, moved)
    led = frame is not None and any(form.line is not None for form in frame.forms)  # what was found on the spec's axes
    if moved.settled and not led:
        return there
    cost = there.cost(system.graph)
    if cost > _SMALL and not led:
        return there
    here = _route(system, formulation, kinetic)
    return here if here.cost(system.graph) < cost else there


def _without_constraints(system: System, formulation: Formulation, kinetic: Kinetic) -> _Route:
    """Lagrange's equations, which moving axes make shorter where bodies turn on bodies in space."""
    here = _route(system, formulation, kinetic)
    cost = here.cost(system.graph)
    if cost <= _WORTH_AXES or system.rotations or "moving axes" in system.graph.off:
        return here
    moved = move(system, kinetic, coordinate_frame(system, ()))
    there = None if moved is None else _route(system, formulation, kinetic, moved)
    return here if there is None or there.cost(system.graph) >= cost else there


def _route(system: System, formulation: Formulation, kinetic: Kinetic, moved: Moved | None = None) -> _Route:
    frame = moved.frame if moved is not None else formulation.frame
    motion = motion_of(system, replace(formulation, frame=frame))
    if moved is not None:
        motion = replace(motion, velocities=moved.velocities)
    projector = Projector(system, kinetic, motion, moved, frame)
    rows = projector.rows()

    def react() -> tuple[Row, ...]:
        if frame is None:
            return ()
        weights = moved.weigh() if moved is not None else (None,) * system.l
        made = [projector.row(e, w) for e, w in zip(frame.vectors[: system.l], weights, strict=True)]
        return tuple(_polish(system.graph, made))

    def sweeps() -> tuple[tuple[Node, ...], ...]:
        if frame is None or not system.l or system.rotations:
            return ()
        spread = moved.spread() if moved is not None and moved.spread is not None else projector.spread(frame)
        ways = (False, True) if system.n * system.l <= _FEW_ROWS else (False,)
        found = [projector.work_on_constraints(spread, by_columns=way) for way in ways]
        return tuple(way for way in found if way is not None)

    def kinetic_energy() -> Node | None:
        return projector.kinetic_energy() if moved is not None else None

    guards = frame.guards if frame is not None else ()
    rows = _in_rows(drop_uniform(system, _entries(rows)), len(rows))
    rows = _polish(system.graph, rows, motion.velocities)
    return _Route(motion, guards, rows, react, sweeps, kinetic_energy)


def _assemble(rows: Sequence[Row]) -> tuple[Matrix, tuple[Node, ...]]:
    """The mass matrix with its upper triangle mirrored, so that equal entries are one node, and the right side."""
    size = len(rows)
    mass = tuple(tuple(rows[min(i, j)].mass[max(i, j)] for j in range(size)) for i in range(size))
    return mass, tuple(row.force for row in rows)


def _polish(graph: Graph, rows: list[Row], beside: Sequence[Node] = ()) -> list[Row]:
    """Entries that vanish identically become zero (exact test); then shorter equal expressions where there are any."""
    entries = _entries(rows)
    zero = are_zero(graph, entries)
    own = shorten(graph, [graph.zero if vanishes else n for n, vanishes in zip(entries, zero, strict=True)], beside)
    return _in_rows(own, len(rows))


def _entries(rows: Sequence[Row]) -> list[Node]:
    return [n for row in rows for n in (*row.mass, row.force)]


def _in_rows(entries: Sequence[Node], count: int) -> list[Row]:
    size = len(entries) // max(count, 1)
    return [Row(tuple(entries[k : k + size - 1]), entries[k + size - 1]) for k in range(0, len(entries), max(size, 1))]


def _is_definite(system: System, rows: Sequence[Row]) -> bool:
    """Whether the mass matrix is positive at every trial point (points where it is singular tell nothing)."""
    flat = [rows[min(i, j)].mass[max(i, j)] for i in range(len(rows)) for j in range(len(rows))]
    size, seen = len(rows), 0
    for point in (p | values for values in scene_values(system) for p in trial_points(system)):
        for symbol in _symbols(system.graph, flat):
            point.setdefault(symbol, 0.37)
        try:
            values = [float(x) for x in evaluate(system.graph, flat, point)]
        except (ArithmeticError, ValueError):
            continue
        signs = pivot_signs([values[i * size : (i + 1) * size] for i in range(size)])
        if -1 in signs:
            return False
        seen += 0 not in signs
    return seen > 0


def _symbols(graph: Graph, nodes: Sequence[Node]) -> list[Node]:
    return sorted({symbol for node in nodes for symbol in graph.symbols_in(node)})


def accelerations(equations: Equations) -> tuple[Node, ...]:
    """q''_i in terms of (q, w, t) and the rates' symbols."""
    motion, system = equations.motion, equations.system
    rates = dict(zip(motion.w, motion.rates, strict=True))
    return tuple(total_derivative(system, node, motion.velocities, rates) for node in motion.velocities)


def reaction_ways(equations: Equations) -> list[tuple[Node, ...]]:
    """lambda_alpha with the rates' symbols: by sweeps, and by the rows of the constraints' own vectors where these are few."""
    g, system = equations.system.graph, equations.system
    found = list(equations.sweeps())
    if not found or system.n * system.l <= _FEW_ROWS:
        rates = equations.motion.rates
        found.append(tuple(g.sub(g.dot(row.mass, rates), row.force) for row in equations.reactions))
    return found


def reaction_values(equations: Equations) -> tuple[Node, ...]:
    """The shortest of the ways."""
    return min(reaction_ways(equations), key=lambda way: count(equations.system.graph, way))


def bordered_system(equations: Equations) -> tuple[list[list[Node]], list[Node]]:
    """[M -A^T; -A 0] (q'', lambda) = (force, A' q' + a'): symmetric, regular wherever the motion is determined."""
    system, g = equations.system, equations.system.graph
    n, zero = system.n, g.zero
    still = {v: zero for v in system.v}
    matrix = [[*equations.mass[i], *(g.neg(c.coefficients[i]) for c in system.constraints)] for i in range(n)]
    matrix += [[*(g.neg(a) for a in c.coefficients), *([zero] * system.l)] for c in system.constraints]
    moved = [total_derivative(system, form_value(system, c), system.v, still) for c in system.constraints]
    return matrix, [*equations.force, *moved]
