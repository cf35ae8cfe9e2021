"""Points that are fixed on the same turned axes are one rigid body: T in the velocity of one point and the axes' angular velocity.

With V the velocity of the reference point on the body's axes and S the angular velocity, a point at d has V + S x d.  Put into T,
masses add up to one mass, one first moment and one inertia, which consist of parameters only.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.shorten import shorten
from nhc.mechanics.energies.kinetic import Kinetic
from nhc.mechanics.moving.axes import Setting
from nhc.mechanics.moving.vectors import Chained
from nhc.mechanics.rotations.turns import Path, Vector, add_vectors, change_axes, cross, turn_in
from nhc.records import record

Placed = tuple[tuple[int, ...], Chained, bool]
"""Numbers of T's forms, the vector that they are, and whether it was read as a position."""


@record
class Point:
    """A vector among T's forms on the axes of ``path``: the numbers of its components (-1: zero)."""

    members: tuple[int, ...]
    vector: Chained
    is_position: bool
    path: Path
    is_joined: bool = False  # several points of T are fixed to it


@record
class Hung:
    """A position of T's: its point's forms on the axes of ``path``, and the body's angular velocity where it has an arm."""

    vector: Chained
    is_position: bool
    path: Path
    point: tuple[int, ...]
    spin: tuple[int, int, int] | None
    arm: Vector


@record
class Bodies:
    """T in new forms: the points' velocities on their axes, angular velocities, and what else T has.

    ``values`` are the forms over the velocities' symbols, ``spins[path]`` the numbers of the components of an angular velocity (-1:
    zero).
    """

    kinetic: Kinetic
    values: tuple[Node, ...]
    points: tuple[Point, ...]
    spins: dict[Path, tuple[int, int, int]]
    hung: tuple[Hung, ...]


def gather_bodies(setting: Setting, kinetic: Kinetic, vectors: Sequence[Placed]) -> Bodies:
    """The forms of T with points of one body put together; where there is no such body they stay what they are."""
    g = setting.graph
    values = list(kinetic.atoms)
    for group, vector, is_position in vectors:
        for k, node in zip(group, setting.home(vector, is_position).velocity, strict=False):
            values[k] = node
    points = [Point(group, v, kind, setting.home(v, kind).path) for group, v, kind in vectors]
    values = substitute(g, values, setting.replaced)
    still = (g.zero, g.zero, g.zero)
    hung = [Hung(p.vector, p.is_position, p.path, p.members, None, still) for p in points]
    plain = Bodies(kinetic, tuple(values), tuple(points), {}, tuple(hung))
    shared: dict[tuple[int, Path], list[tuple[Placed, Vector]]] = {}
    for placed in vectors:
        base, path, offset = _reference(setting, placed)
        shared.setdefault((id(base), path), []).append((placed, offset))
    bodies = {key: members for key, members in shared.items() if len(members) > 1}
    if not bodies:
        return plain
    return _Assembly(setting, kinetic, plain).join(list(bodies.values())) or plain


def _reference(setting: Setting, placed: Placed) -> tuple[Chained, Path, Vector]:
    """The point that a vector stands on by a constant arm, with the arm's axes; or the vector itself."""
    g, (_, vector, is_position) = setting.graph, placed
    home, zero = setting.home(vector, is_position), (g.zero, g.zero, g.zero)
    moving = ~g.mask(setting.system.p)
    if is_position and vector.base is not None and len(vector.parts) == 1:
        part = vector.parts[0]
        if part.path == home.path and not any(g.deps[x] & moving for x in part.local):
            return vector.base, part.path, part.local
    return vector, home.path, zero


class _Assembly:
    """The new forms and T in them."""

    def __init__(self, setting: Setting, kinetic: Kinetic, plain: Bodies) -> None:
        self.setting, self.kinetic, self.plain = setting, kinetic, plain
        self.graph: Graph = setting.graph
        self.symbols: list[Node] = []
        self.values: list[Node] = []
        self.spins: dict[Path, tuple[int, int, int]] = {}
        self.mapping: dict[Node, Node] = {}
        self.hung: list[Hung] = []

    def join(self, bodies: Sequence[Sequence[tuple[Placed, Vector]]]) -> Bodies | None:
        """None where T is not quadratic in the new forms with constant masses."""
        g, points = self.graph, []
        for members in bodies:
            (first, _) = members[0]
            base, path, _ = _reference(self.setting, first)
            is_position = first[2]
            home = self.setting.home(base, is_position)
            velocity = change_axes(g, home.velocity, home.path, path)
            numbers, point = self._new(velocity)
            spin = self._spin(path)
            points.append(Point(numbers, base, is_position, path, True))
            for (group, vector, _), arm in members:
                self.hung.append(Hung(vector, is_position, path, numbers, self.spins[path], arm))
                at = add_vectors(g, point, cross(g, spin, arm))
                self.mapping.update((self.kinetic.u[k], at[i]) for i, k in enumerate(group))
        self._map_rotations()
        return self._finish(points)

    def _new(self, components: Vector) -> tuple[tuple[int, ...], Vector]:
        """Numbers of new forms with these values, and their symbols."""
        g, numbers, symbols = self.graph, [], []
        for node in components:
            if node == g.zero:
                numbers.append(-1)
                symbols.append(g.zero)
                continue
            symbol = g.symbol(f"u_{len(self.symbols) + 1}", "form")
            numbers.append(len(self.symbols))
            symbols.append(symbol)
            self.symbols.append(symbol)
            self.values.append(node)
        return tuple(numbers), (symbols[0], symbols[1], symbols[2])

    def _spin(self, path: Path) -> Vector:
        if path not in self.spins:
            numbers, symbols = self._new(self.setting.spin(path))
            self.spins[path] = (numbers[0], numbers[1], numbers[2])
            return symbols
        x, y, z = (self.graph.zero if k < 0 else self.symbols[k] for k in self.spins[path])
        return x, y, z

    def _map_rotations(self) -> None:
        """Rotational forms of T that are components of a body's angular velocity, on its axes or on axes fixed to them."""
        g, fixed = self.graph, self.setting.graph.mask(self.setting.system.p)
        for path in list(self.spins):
            ways: list[Path] = [(), *({p[len(path) :] for p in self.setting.paths if p[: len(path)] == path} - {()})]
            for way in sorted(ways, key=lambda w: [(t.plane, t.angle) for t in w]):
                if any(g.deps[turn.angle] & ~fixed for turn in way):
                    continue
                spin, symbols = self.setting.spin((*path, *way)), self._spin(path)
                for turn in way:
                    symbols = turn_in(g, turn, symbols)
                self._match(spin, symbols)

    def _match(self, spin: Vector, symbols: Vector) -> None:
        g = self.graph
        for k, u in enumerate(self.kinetic.u):
            if u in self.mapping:
                continue
            value = self.plain.values[k]
            for component, symbol in zip(spin, symbols, strict=True):
                if component != g.zero and value in (component, g.neg(component)):
                    self.mapping[u] = symbol if value == component else g.neg(symbol)

    def _finish(self, points: list[Point]) -> Bodies | None:
        g, kinetic, plain = self.graph, self.kinetic, self.plain
        kept = [k for k, u in enumerate(kinetic.u) if u not in self.mapping]
        number = {k: len(self.symbols) + i for i, k in enumerate(kept)}
        for point in plain.points:
            if all(k in number for k in point.members):
                own = tuple(number[k] for k in point.members)
                points.append(Point(own, point.vector, point.is_position, point.path))
                still = (g.zero, g.zero, g.zero)
                self.hung.append(Hung(point.vector, point.is_position, point.path, own, None, still))
        symbols = (*self.symbols, *(kinetic.u[k] for k in kept))
        values = (*self.values, *(plain.values[k] for k in kept))
        tau = substitute(g, [kinetic.tau], self.mapping)[0]
        slopes = gradient(g, tau, symbols)
        upper = iter(shorten(g, [h for k, slope in enumerate(slopes) for h in gradient(g, slope, symbols[k:])]))
        hessian = [[g.zero] * len(symbols) for _ in symbols]
        for i, j in combinations_with_replacement(range(len(symbols)), 2):
            hessian[i][j] = hessian[j][i] = next(upper)
        mask = g.mask(symbols)
        if any(g.depends(entry, mask) for row in hessian for entry in row):
            return None
        at_rest = substitute(g, slopes, dict.fromkeys(symbols, g.zero), named=False)
        linear = [g.add(rest, g.dot(row, symbols)) for rest, row in zip(at_rest, hessian, strict=True)]
        made = Kinetic(
            system=kinetic.system,
            atoms=values,
            u=symbols,
            tau=tau,
            slope=tuple(linear),
            hessian=tuple(tuple(row) for row in hessian),
        )
        return Bodies(made, values, tuple(points), self.spins, tuple(self.hung))
