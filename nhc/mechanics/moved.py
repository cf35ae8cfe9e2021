"""A frame and T's velocity forms by way of moving frames: what :mod:`nhc.mechanics.associate` needs, in shorter expressions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from nhc.algebra.calculus import gradient, substitute, tangent
from nhc.algebra.field import Unlucky
from nhc.algebra.graph import Graph, Node
from nhc.algebra.linear import Singular, solve_rows
from nhc.mechanics.frame import Frame, form_value
from nhc.mechanics.kinetic import Kinetic
from nhc.mechanics.moving import Scene
from nhc.mechanics.moving_bodies import Placed, gather_bodies
from nhc.mechanics.moving_loads import find_loads
from nhc.mechanics.moving_rolling import apply_rolling, read_rolling
from nhc.mechanics.moving_rows import (
    Sided,
    along_direction,
    direction_vector,
    read_square,
    read_vector,
    rewrite_row,
    square_groups,
)
from nhc.mechanics.moving_spin import Spin, find_turning, recognise, spatial_paths, spin_weights
from nhc.mechanics.regularity import pivot_weakness
from nhc.mechanics.signatures import Signatures
from nhc.mechanics.system import System
from nhc.mechanics.turns import Path, Vector, add_vectors, change_axes, cross
from nhc.mechanics.vectors import Chained, Reader

@dataclass(frozen=True)
class Turning:
    """Axes with angular velocity ``omega`` on the motion, and what the forms ``members`` are on them: that velocity, or a point's.

    With p_i the sum of T's slopes by the forms of ``members[i]``, what the velocities of points give to them left out, the terms
    domega along a vector of the frame add up to its weight . (omega x p); the weight is that of ``forms`` where T has them.
    """

    members: tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]
    omega: Vector
    forms: tuple[int, ...] | None


@dataclass(frozen=True)
class Weights:
    """W_k(e) of T's forms for a vector e of the frame, and along e what turns and is no form, in the order of ``Moved.turning``."""

    forms: tuple[Node, ...]
    spins: tuple[Vector, ...]


@dataclass(frozen=True)
class Moved:
    """T in the forms of ``kinetic`` on moving axes.

    ``u`` and ``drift`` are the forms on the motion and their rates with the kept velocities' rates left out; ``weights`` are those
    along the frame's free vectors, ``weigh()`` gives those along the constraints' vectors.  The drift of an ``inertial`` form is a
    component of an acceleration; ``loads`` are what U gives to each form, ``potential`` what is left of U.  A form that is ``carried`` needs no term domega of its own.  ``settled``: every vector that
    stands on no other has forms of the frame for its components, so that no other axes can be better.
    """

    frame: Frame
    velocities: tuple[Node, ...]
    kinetic: Kinetic
    u: tuple[Node, ...]
    drift: tuple[Node, ...]
    weights: tuple[Weights, ...]
    weigh: Callable[[], tuple[Weights, ...]]
    carried: tuple[bool, ...]
    inertial: tuple[bool, ...]
    loads: tuple[Node, ...]
    potential: Node
    settled: bool
    turning: tuple[Turning, ...]


def move(system: System, kinetic: Kinetic, frame: Frame) -> Moved | None:
    """The frame and T on moving axes; None where T has no vector that turns."""
    g = system.graph
    groups = square_groups(system, kinetic)
    if not groups:
        return None
    held = tuple(g.symbol(f"held_{j}", "quasi") for j in range(system.n))
    values = [form_value(g, form, system.v) for form in frame.forms]
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
    scene = Scene(
        system, held, tuple(values), marks, forms, *(Reader(g, g.mask((*system.q, system.t))) for _ in range(2))
    )
    vectors: list[Placed] = []
    for group in groups:
        components = [kinetic.atoms[k] for k in group] + [g.zero] * (3 - len(group))
        vectors.append((group, *read_square(scene, (components[0], components[1], components[2]))))
    for sided in _directions(g, values):
        read_vector(scene, direction_vector(g, sided)[0])
        scene.paths.append(sided.path)
    for vector in _known(scene):
        scene.paths += [part.path for part in vector.parts if part.path]
    scene.paths = list(dict.fromkeys(scene.paths))
    recognise(scene, kinetic, values)
    scene.paths += [path for path in spatial_paths(scene) if path not in scene.paths]
    rolling = read_rolling(scene, values)
    vectors = _standing(scene, vectors, [equation.base for equation in rolling])
    if not vectors:
        return None
    for equation in rolling:
        apply_rolling(scene, equation)
    for _, vector, is_position in vectors:
        scene.home(vector, is_position)
    return _finish(scene, kinetic, frame, values, vectors)


def _directions(graph: Graph, rows: Sequence[Node]) -> list[Sided]:
    found = (along_direction(graph, row) for row in rows)
    return [sided for sided in found if sided is not None]


def _known(scene: Scene) -> list[Chained]:
    return [vector for reader in (scene.positions, scene.velocities) for vector in reader.known.values()]


def _standing(scene: Scene, vectors: list[Placed], rolling: Sequence[Chained]) -> list[Placed]:
    """Vectors that turn, or on which something turning stands, or of which a row is a component.

    The other pairs only look like vectors: two rates whose squares have one factor.
    """
    g = scene.graph
    own = {id(vector) for _, vector, _ in vectors}
    used = {id(v.base) for v in _known(scene) if v.base is not None}
    used |= {id(v) for v in _known(scene) if id(v) not in own}
    used |= {id(v) for v in rolling}
    along = {direction_vector(g, sided)[0] for sided in _directions(g, scene.values)}
    return [p for p in vectors if p[1].turned or id(p[1]) in used or scene.velocity_of(p[1], p[2]) in along]


def _finish(
    scene: Scene,
    kinetic: Kinetic,
    frame: Frame,
    values: Sequence[Node],
    vectors: Sequence[Placed],
) -> Moved | None:
    system, g = scene.system, scene.graph
    rows = []
    for j, value in enumerate(values):
        row = scene.rows.get(j)
        if row is None:
            row = rewrite_row(scene, value) or value
        rows.append(row)
    matrix = [gradient(g, row, system.v) for row in rows]
    weakness = pivot_weakness(system)

    def solve(everything: bool) -> tuple[Sequence[Node], Sequence[tuple[Node, Node]]]:
        still = {} if everything else dict.fromkeys(scene.held[: system.l], g.zero)
        full = [g.sub(x, w) for x, w in zip(rows, scene.held, strict=True)]
        full = substitute(g, full, still)  # rows may hold one another's symbols
        found, guards = solve_rows(g, full, system.v, matrix, weakness)
        return substitute(g, substitute(g, found, scene.meaning), still), guards

    try:
        found, guards = solve(False)
    except Singular:
        return None
    solved = {**scene.meaning, **dict(zip(system.v, found, strict=True))}
    made = Frame(system, frame.forms, frame.omega, scene.held, lambda full: solve(True) if full else (found, guards))
    kinematics = _by_speed(g, made.kinematics, made.free_vectors, made.free)
    bodies = gather_bodies(scene, kinetic, vectors)
    general = substitute(g, bodies.values, solved)
    on_motion = {symbol: g.zero if j < system.l else frame.omega[j] for j, symbol in enumerate(scene.held)}
    rates = Rates(scene, solved, on_motion, kinematics)
    moved = rates.on_motion(general)
    drift = list(tangent(g, moved, rates.seeds))
    inertial = [False] * len(moved)
    for point in bodies.points:
        home = scene.home(point.vector, point.is_position)
        there = change_axes(g, rates.acceleration(point.vector, point.is_position), home.path, point.path)
        for k, node in zip(point.members, there, strict=False):
            if k >= 0:
                drift[k], inertial[k] = node, True
    turning = find_turning(scene, bodies, inertial)
    carried = list(inertial)
    for k in (k for own in turning for axis in own.members for k in axis):
        carried[k] = True
    weights = _weigh(scene, general, turning, solved, scene.held[system.l :])

    def weigh() -> tuple[Weights, ...]:
        everywhere = {**scene.meaning, **dict(zip(system.v, solve(True)[0], strict=True))}
        return _weigh(scene, substitute(g, bodies.values, everywhere), turning, everywhere, scene.held[: system.l])

    loads, potential = find_loads(scene, bodies, len(moved))
    return Moved(
        frame=made,
        velocities=tuple(kinematics),
        kinetic=bodies.kinetic,
        u=tuple(moved),
        drift=tuple(drift),
        weights=weights,
        weigh=weigh,
        carried=tuple(carried),
        inertial=tuple(inertial),
        loads=loads,
        potential=potential,
        settled=all(home.known for home in scene.homes.values() if home.root),
        turning=tuple(Turning(own.members, rates.value(scene.spin(own.path)), own.forms) for own in turning),
    )


def _weigh(
    scene: Scene, forms: Sequence[Node], turning: Sequence[Spin], solved: dict[Node, Node], symbols: Sequence[Node]
) -> tuple[Weights, ...]:
    """Along the vectors that belong to the symbols; ``forms`` are T's in terms of these."""
    along = [tuple(tangent(scene.graph, forms, {symbol: scene.graph.one})) for symbol in symbols]
    spins = [spin_weights(scene, own.path, solved, symbols) for own in turning if own.forms is None]
    return tuple(Weights(own, tuple(spin[j] for spin in spins)) for j, own in enumerate(along))


def _by_speed(
    graph: Graph, values: Sequence[Node], columns: Sequence[Sequence[Node]], speeds: Sequence[Node]
) -> list[Node]:
    """A value that is proportional to one speed as their product: the weight is there already."""
    g = graph
    still = {speed: g.zero for speed in speeds}
    rest = substitute(g, values, still)
    new = []
    for k, value in enumerate(values):
        own = [(column[k], speed) for column, speed in zip(columns, speeds, strict=True) if column[k] != g.zero]
        new.append(g.mul(*own[0]) if len(own) == 1 and rest[k] == g.zero else value)
    return new


class Rates:
    """Accelerations of placed vectors on their home axes, with the rates of the kept velocities left out."""

    def __init__(self, scene: Scene, solved: dict[Node, Node], on_motion: dict[Node, Node], q_rates: Sequence[Node]):
        system, g = scene.system, scene.graph
        self.scene, self.solved, self._on_motion = scene, solved, on_motion
        self.seeds = {**dict(zip(system.q, q_rates, strict=True)), system.t: g.one}
        self._known: dict[tuple[bool, Vector], Vector] = {}

    def value(self, vector: Vector) -> Vector:
        """Components on the motion."""
        x, y, z = self.on_motion(substitute(self.scene.graph, vector, self.solved))
        return x, y, z

    def on_motion(self, values: Sequence[Node]) -> list[Node]:
        """Values over the held symbols on the motion; what is proportional to one speed as the product with its weight."""
        g, system = self.scene.graph, self.scene.system
        free = self.scene.held[system.l :]
        columns = [tangent(g, values, {symbol: g.one}) for symbol in free]
        return _by_speed(g, substitute(g, values, self._on_motion), columns, [self._on_motion[s] for s in free])

    def rate(self, vector: Vector) -> Vector:
        x, y, z = tangent(self.scene.graph, vector, self.seeds)
        return x, y, z

    def acceleration(self, vector: Chained, is_position: bool) -> Vector:
        key = (is_position, vector.components)
        if key not in self._known:
            self._known[key] = self._find(vector, is_position)
        return self._known[key]

    def _carried(self, velocity: Vector, path: Path) -> Vector:
        """d/dt of the components + Omega x components."""
        g = self.scene.graph
        return add_vectors(g, self.rate(velocity), cross(g, self.value(self.scene.spin(path)), velocity))

    def _find(self, vector: Chained, is_position: bool) -> Vector:
        scene, g = self.scene, self.scene.graph
        home = scene.home(vector, is_position)
        if home.settled or vector.base is None:
            return self._carried(self.value(home.velocity), home.path)
        at = scene.home(vector.base, is_position).path
        total = self.acceleration(vector.base, is_position)
        parts = list(vector.parts)
        for there in (at, home.path):
            total = change_axes(g, total, at, there)
            at = there
            for part in [p for p in parts if p.path == there]:
                total = add_vectors(g, total, self._local(part.path, part, is_position))
                parts.remove(part)
        for part in parts:
            total = add_vectors(
                g, total, change_axes(g, self._local(part.path, part, is_position), part.path, home.path)
            )
        return total

    def _local(self, path: Path, part: object, is_position: bool) -> Vector:
        from nhc.mechanics.vectors import Part

        assert isinstance(part, Part)
        return self._carried(self.value(self.scene.local_velocity(part, is_position)), path)
