"""Moving axes for a system and a frame: vectors are read, placed bases first, and the constraints are solved on their axes."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import tangent
from nhc.algebra.dense import Singular
from nhc.algebra.exact.field import Unlucky
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NamedBlock, solve_rows
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.frame import Frame, form_value
from nhc.mechanics.moving.askew import count_from_joint, find_lean
from nhc.mechanics.moving.axes import Setting
from nhc.mechanics.moving.bodies import Bodies, Placed, gather_bodies
from nhc.mechanics.moving.loads import find_loads
from nhc.mechanics.moving.moved import Moved, Spread, Turning, Weights
from nhc.mechanics.moving.rates import OnMotion, Rates, Solution
from nhc.mechanics.moving.rolling import apply_rolling, peel_rolling, read_rolling
from nhc.mechanics.moving.rows import (
    direction_vector,
    order_roots,
    read_group,
    read_vector,
    rewrite_row,
    square_groups,
)
from nhc.mechanics.moving.signatures import Signatures
from nhc.mechanics.moving.spin import Spin, find_turning, recognise, spatial_paths, spin_weights
from nhc.mechanics.moving.vectors import Chained, Reader
from nhc.mechanics.regular.regularity import pivot_weakness
from nhc.mechanics.rotations.directions import Sided, along_direction
from nhc.mechanics.rotations.turns import Turn, change_axes
from nhc.mechanics.row_factors import strip_factor
from nhc.mechanics.system import System

_LEANS = 4  # leaning joints that are looked for


def move(system: System, kinetic: Kinetic, frame: Frame, backs: tuple[Turn, ...] = ()) -> Moved | None:
    """The frame and T on moving axes; None where T has no vector that turns.

    ``backs`` are turns from axes on which the next joint stands straight to those of the spec (:mod:`nhc.mechanics.moving.askew`).
    """
    g = system.graph
    groups = square_groups(system, kinetic)
    if not groups:
        return None
    held = tuple(g.symbol(f"held_{j}", "quasi") for j in range(system.n))
    written = [form_value(system, form) for form in frame.forms]
    bare = [strip_factor(g, row, g.mask(system.p), system.v) for row in written[: system.l]]
    values = [*(own.row for own in bare), *written[system.l :]]
    try:
        marks = Signatures(g, [*values, *kinetic.atoms])
    except Unlucky:
        return None
    marks.bind(dict(zip(held, values, strict=True)))
    forms: dict[tuple[int, ...], Node] = {}
    for symbol in held:
        signature = marks.of(symbol)
        forms.setdefault(signature, symbol)
        forms.setdefault(marks.negative(signature), g.neg(symbol))
    moving = g.mask((*system.q, system.t))
    setting = Setting(
        system, held, tuple(values), marks, forms, Reader(g, moving), Reader(g, moving), tuple(bare), backs=backs
    )
    vectors: list[Placed] = []
    for group in order_roots(setting, kinetic, groups):
        vectors.append(read_group(setting, kinetic, group))
        lean = find_lean(g, [part.path for part in vectors[-1][1].parts]) if len(backs) < _LEANS else None
        straight = None if lean is None else move(*count_from_joint(lean, system, kinetic, frame), (*backs, lean.back))
        if straight is not None:
            return straight
    for sided in _directions(g, values):
        read_vector(setting, direction_vector(g, sided)[0])
        setting.paths.append(sided.path)
    for vector in _known(setting):
        setting.paths += [part.path for part in vector.parts if part.path]
    setting.paths = list(dict.fromkeys(setting.paths))
    if not spatial_paths(setting):
        setting.paths += peel_rolling(setting, values)
    recognise(setting, kinetic, values)
    setting.paths += [path for path in spatial_paths(setting) if path not in setting.paths]
    rolling = read_rolling(setting, values)
    vectors = _standing(setting, vectors, [equation.base for equation in rolling])
    if not vectors:
        return None
    setting.pairs.update((is_position, vector.components) for group, vector, is_position in vectors if len(group) == 2)
    for equation in rolling:
        apply_rolling(setting, equation)
    for _, vector, is_position in vectors:
        setting.home(vector, is_position)
    return _finish(setting, kinetic, frame, values, vectors)


def _directions(graph: Graph, rows: Sequence[Node]) -> list[Sided]:
    found = (along_direction(graph, row) for row in rows)
    return [sided for sided in found if sided is not None]


def _known(setting: Setting) -> list[Chained]:
    return [vector for reader in (setting.positions, setting.velocities) for vector in reader.known.values()]


def _standing(setting: Setting, vectors: list[Placed], rolling: Sequence[Chained]) -> list[Placed]:
    """Vectors that turn, or on which something turning stands, or of which a row is a component.

    The other pairs only look like vectors: two rates whose squares have one factor.
    """
    g = setting.graph
    own = {id(vector) for _, vector, _ in vectors}
    used = {id(v.base) for v in _known(setting) if v.base is not None}
    used |= {id(v) for v in _known(setting) if id(v) not in own}
    used |= {id(v) for v in rolling}
    along = {direction_vector(g, sided)[0] for sided in _directions(g, setting.values)}
    return [p for p in vectors if p[1].turned or id(p[1]) in used or setting.velocity_of(p[1], p[2]) in along]


def _finish(
    setting: Setting,
    kinetic: Kinetic,
    frame: Frame,
    values: Sequence[Node],
    vectors: Sequence[Placed],
) -> Moved | None:
    system, g = setting.system, setting.graph
    rows = _rewrite_rows(setting, values)
    try:
        solution, guards = _solve(setting, rows)
    except Singular:
        return None
    held = {symbol: g.zero if j < system.l else frame.omega[j] for j, symbol in enumerate(setting.held)}

    def solve(everything: bool) -> tuple[Sequence[Node], Sequence[tuple[Node, Node]]]:
        own = _solve(setting, rows, everything=True)[0] if everything else solution
        return own.finish([own.found[v] for v in system.v], {}), guards

    on_motion = OnMotion(solution, held)
    kinematics = on_motion.of([solution.found[v] for v in system.v])
    bodies = gather_bodies(setting, kinetic, vectors)
    general = solution.put(bodies.values)
    rates = Rates(on_motion, kinematics)
    moved = rates.on_motion(general)
    drift, inertial = _drift_of(bodies, rates, moved)
    turning = find_turning(setting, bodies, inertial)
    carried = list(inertial)
    for k in (k for own in turning for axis in own.members for k in axis):
        carried[k] = True

    def whole() -> tuple[Solution, list[Node]]:
        own = _solve(setting, rows, everything=True)[0]
        return own, substitute(g, bodies.values, own.found)

    loads, potential, places = find_loads(setting, bodies, len(moved))
    done = solution.finish([*kinematics, *moved, *drift], held)
    size, count = system.n, len(moved)
    _name(setting, bodies, done[size : size + count])
    return Moved(
        frame=Frame(system, frame.forms, frame.omega, setting.symbols, solve),
        velocities=tuple(done[:size]),
        kinetic=bodies.kinetic,
        u=tuple(done[size : size + count]),
        drift=tuple(done[size + count :]),
        weights=_weigh(solution, general, turning, setting.held[system.l :]),
        weigh=lambda: _weigh(*whole(), turning, setting.symbols[: system.l]),
        spread=lambda: _spread(*whole()),
        carried=tuple(carried),
        inertial=tuple(inertial),
        loads=loads,
        potential=potential,
        places=places,
        settled=all(home.known for home in setting.homes.values() if home.root),
        turning=tuple(_turn(rates, own, held) for own in turning),
    )


def _rewrite_rows(setting: Setting, values: Sequence[Node]) -> list[Node]:
    """The forms on moving axes where they are components there."""
    rows = []
    for j, value in enumerate(values):
        rewritten = rewrite_row(setting, value) if j not in setting.rows else None
        # the vector that a row is a component of may find on its axes that it is this row
        rows.append(setting.rows.get(j, rewritten or value))
    return rows


def _drift_of(bodies: Bodies, rates: Rates, moved: Sequence[Node]) -> tuple[list[Node], list[bool]]:
    """The forms' rates with the kept velocities' rates left out, and which of them are components of accelerations."""
    setting, g = rates.setting, rates.setting.graph
    drift, inertial = list(tangent(g, moved, rates.seeds)), [False] * len(moved)
    for point in bodies.points:
        home = setting.home(point.vector, point.is_position)
        there = change_axes(g, rates.acceleration(point.vector, point.is_position), home.path, point.path)
        for k, node in zip(point.members, there, strict=False):
            if k >= 0:
                drift[k], inertial[k] = node, True
    return drift, inertial


def _solve(
    setting: Setting, rows: Sequence[Node], *, everything: bool = False
) -> tuple[Solution, Sequence[tuple[Node, Node]]]:
    """The velocities from the rows, the constraints' forms being zero unless ``everything`` is asked for."""
    system, g = setting.system, setting.graph
    still = setting.as_written if everything else dict.fromkeys(setting.held[: system.l], g.zero)
    full = [
        g.sub(row, x) for j, (row, x) in enumerate(zip(rows, setting.held, strict=True)) if j not in setting.dropped
    ]
    full = substitute(g, substitute(g, full, setting.given), still)  # rows may hold one another's symbols
    unknowns = [*(v for v in system.v if v not in setting.given), *setting.unknown]
    blocks = list[NamedBlock]()
    found, guards = solve_rows(g, full, unknowns, pivot_weakness(system), None if everything else blocks)

    def tidy(nodes: Sequence[Node]) -> list[Node]:
        return substitute(g, substitute(g, nodes, setting.meaning), still)

    known = dict(zip(unknowns, found, strict=True))
    given = substitute(g, list(setting.given.values()), known)
    known.update(zip(setting.given, given, strict=True))
    meaning = setting.meaning
    if everything:  # in terms of the forms as the spec wrote them
        meaning = {**meaning, **setting.as_written}
        meaning = dict(zip(meaning, substitute(g, list(meaning.values()), setting.as_written), strict=True))
    known = {**meaning, **dict(zip(known, tidy(list(known.values())), strict=True))}
    guards = [*((divisor, divisor) for own in setting.bare for divisor in own.divisors), *guards]
    return Solution(setting, known, tuple(block.mapped(tidy) for block in blocks)), guards


def _name(setting: Setting, bodies: Bodies, values: Sequence[Node]) -> None:
    """Names for components on moving axes, after the point or the angle that they belong to."""
    g = setting.graph
    named = [(point.vector.components[0], point.members, "v") for point in bodies.points]
    named += [(path[-1].angle, numbers, "w") for path, numbers in bodies.spins.items()]
    for node, members, letter in named:
        symbol = g.symbol_of(node)
        name = g.labels.get(node) if symbol is None else symbol.name
        for axis, k in enumerate(members, start=1):
            if name is not None and k >= 0 and len(g.children(values[k])) > 1:
                g.labels.setdefault(values[k], f"{letter}{axis}_{name}")


def _turn(rates: Rates, own: Spin, held: dict[Node, Node]) -> Turning:
    x, y, z = rates.solution.finish(rates.value(rates.setting.spin(own.path)), held)
    return Turning(own.members, (x, y, z), own.forms)


def _spread(solution: Solution, forms: Sequence[Node]) -> Spread:
    system, held = solution.setting.system, solution.setting.symbols
    return Spread(tuple(forms), tuple(solution.found[v] for v in system.v), held[: system.l])


def _weigh(
    solution: Solution, forms: Sequence[Node], turning: Sequence[Spin], symbols: Sequence[Node]
) -> tuple[Weights, ...]:
    """Along the vectors that belong to the symbols; ``forms`` are T's in terms of these."""
    along = [tuple(column) for column in solution.columns(forms, symbols)]
    spins = [spin_weights(solution, own.path, symbols) for own in turning if own.forms is None]
    return tuple(Weights(own, tuple(spin[j] for spin in spins)) for j, own in enumerate(along))
