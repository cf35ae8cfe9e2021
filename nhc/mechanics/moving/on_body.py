"""The velocities of a rolling body's points on its own axes, where a rotation turns it: a ball, an ellipsoid, a disc.

What the constraints make of a point's velocity is u_i = R_i . V for the rows R_i of the matrix, but few specs say so: a ball has
x' = a R_y . omega.  With gamma = R_k for one of the three axes of space, the normal of the plane, and i, j, k in cyclic order,

    R_j = gamma x R_i,    R_i = R_j x gamma,

so that a component that is linear in R_i and R_j is one of R_i alone: alpha . R_i + beta . R_j = (alpha + beta x gamma) . R_i.
Where both rows give one V over gamma, and V . gamma is the third component, T's squares are those of V, which needs one row of
the matrix in place of three; accelerations are read in the same way.  (E. J. Routh, Advanced Rigid Dynamics, 6th ed. (1905),
article 241, has these equations of a body that rolls on a plane.)
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.calculus import tangent
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.known_values import known_value
from nhc.algebra.parts import split_powers
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.mechanics.energies.kinetic import Kinetic, is_exact_rate
from nhc.mechanics.frame import Frame
from nhc.mechanics.moving.moved import Moved, Weights
from nhc.mechanics.moving.rows import lone_squares
from nhc.mechanics.rotations.rotation import Rotation, Spelled, spell
from nhc.mechanics.rotations.turning import along, moving
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.mechanics.system import System
from nhc.records import record


@record
class _Seen:
    """A rotation by symbols; ``kept`` is the mask of all velocities that the motion keeps."""

    rotation: Rotation
    spelled: Spelled
    kept: int

    @property
    def rows(self) -> tuple[Vector, ...]:
        """The symbols of the entries."""
        x = self.spelled.entries
        return tuple((x[k], x[k + 1], x[k + 2]) for k in (0, 3, 6))

    def normals(self, graph: Graph, components: Vector) -> list[int]:
        """The axes of space along which a vector has no entries of the matrix but that axis's own, the last one first."""
        g = graph
        named = substitute(g, components, self.spelled.words, named=False)
        across = [g.mask([x for i, row in enumerate(self.rows) if i != k for x in row]) for k in range(3)]
        return [k for k in (2, 0, 1) if not g.depends(named[k], across[k])]

    def read(self, graph: Graph, components: Vector, k: int, *, oriented: bool = False) -> tuple[Vector, Vector] | None:
        """V on the body's axes of a vector with these components in space, over the row ``k`` of the matrix, and the components
        with the signs by which they are those of V: their own if ``oriented``.  None where there is no V.
        """
        g = graph
        named = substitute(g, components, self.spelled.words, named=False)
        i, j = (k + 1) % 3, (k + 2) % 3
        first, second = (self._by_rows(g, named[axis], i, j) for axis in (i, j))
        if first is None or second is None:
            return None
        x, y, z = substitute(
            g, add_vectors(g, first[0], cross(g, first[1], self.rows[k])), self.spelled.meaning, named=False
        )
        local, matrix, signs = (x, y, z), self.rotation.matrix, (1,) if oriented else (1, -1)
        signed, still = list(components), [g.zero] * 3
        along = g.dot(matrix[k], local)  # what the rows i and j say nothing of
        sign = self._sign(g, along, components[k], signs)
        if sign is not None:
            signed[k] = g.scale(sign, components[k])
        elif oriented or components[k] == g.zero:
            local = add_vectors(g, local, scale_vector(g, g.sub(components[k], along), matrix[k]))
        else:
            return None
        sign = self._sign(g, g.dot(matrix[j], local), g.sub(components[j], second[2]), signs)
        if sign is None:
            return None
        still[i], still[j], signed[j] = first[2], g.scale(sign, second[2]), g.scale(sign, components[j])
        x, y, z = (g.dot(column, still) for column in zip(*matrix, strict=True))
        return add_vectors(g, local, (x, y, z)), (signed[0], signed[1], signed[2])

    def _sign(self, g: Graph, x: Node, y: Node, signs: Sequence[int]) -> int | None:
        """The sign with which x = y, exactly; None where there is none."""
        return next((sign for sign in signs if is_zero(g, g.sub(x, g.scale(sign, y)))), None)

    def _by_rows(self, g: Graph, node: Node, i: int, j: int) -> tuple[Vector, Vector, Node] | None:
        """What stands before the rows i and j of the matrix in a sum of their entries, and what else there is, as on a turntable
        that moves by itself; None where that moves with the velocities.
        """
        try:
            parts, rest = linear_form(g, node, (*self.rows[i], *self.rows[j]))
        except NotLinear:
            return None
        if g.depends(rest, self.kept | g.mask(self.rotation.e)):
            return None
        found = (
            g.zero if zero else part for part, zero in zip((*parts, rest), are_zero(g, [*parts, rest]), strict=True)
        )
        a, b, c, x, y, z, still = found
        return (a, b, c), (x, y, z), substitute(g, [still], self.spelled.meaning, named=False)[0]


@record
class _Squares:
    """h/2 (x^2 + y^2 + z^2) in T: the numbers of the forms along axes of space that may be meant (-1: no form, and zero), what they
    are to be multiplied with to be x, y, z, and h.
    """

    ways: tuple[tuple[int, int, int], ...]
    scale: dict[int, Node]
    factor: Node


@record
class _Placed:
    """Such a vector on its body's axes: x, y, z over the velocities' symbols, V on the motion, and the acceleration there, in which
    the kept velocities have no rates.
    """

    group: tuple[int, int, int]
    factor: Node
    written: Vector
    rotation: Rotation
    velocity: Vector
    acceleration: Vector


def move_on_bodies(system: System, kinetic: Kinetic, frame: Frame) -> Moved | None:
    """T's vectors on the axes of the rotations in whose matrices their velocities are linear; None where there are none."""
    g, seen = system.graph, list[_Seen]()
    for rotation in frame.turned:
        if rotation.sign > 0:
            own = spell(g, rotation)
            seen.append(_Seen(rotation, own, g.mask((*frame.free, *own.omega))))
    squares = _squares(system, kinetic) if seen else []
    if not squares:
        return None
    on_motion = moving(system, frame.kinematics)
    seeds = {**along(system, frame.kinematics), system.t: g.one}
    placed: list[_Placed] = []
    for group in squares:
        for way in group.ways:
            written = [g.mul(group.scale[k], kinetic.atoms[k]) if k >= 0 else g.zero for k in way]
            there = substitute(g, written, on_motion)
            found = next((x for one in seen if (x := _place(g, one, way, group, written, there, seeds))), None)
            if found is not None:
                placed.append(found)
                break
    return _moved(system, kinetic, frame, placed, on_motion, seeds) if placed else None


def _squares(system: System, kinetic: Kinetic) -> list[_Squares]:
    """Exact forms by threes, as they are written; two where there is no third."""
    g, classes = system.graph, list[tuple[Node, dict[int, Node]]]()
    for k in lone_squares(g, kinetic):
        factor = kinetic.hessian[k][k]
        for first, members in classes:
            scale = _root(g, g.div(factor, first))
            if scale is not None and is_exact_rate(system, g.mul(scale, kinetic.atoms[k])):
                members[k] = scale
                break
        else:
            if kinetic.is_exact(k):
                classes.append((factor, {k: g.one}))
    found = []
    for factor, members in classes:
        every = list(members)
        for k in range(0, len(every) - 1, 3):
            match every[k : k + 3]:
                case [x, y, z]:
                    found.append(_Squares(((x, y, z),), members, factor))
                case [x, y]:
                    found.append(_Squares(((x, y, -1), (-1, x, y), (x, -1, y)), members, factor))
    return found


def _root(graph: Graph, ratio: Node) -> Node | None:
    """A root of a product of even powers and a rational square; None of anything else."""
    number, powers = split_powers(graph, ratio)
    root = known_value("sqrt", Fraction(number))
    if root is None or any(n % 2 for n in powers.values()):
        return None
    return graph.product([graph.number(root), *(graph.power(base, n // 2) for base, n in powers.items())])


def _place(
    g: Graph,
    one: _Seen,
    way: tuple[int, int, int],
    squares: _Squares,
    written: Sequence[Node],
    there: Sequence[Node],
    seeds: dict[Node, Node],
) -> _Placed | None:
    """The vector with components ``written``, which are ``there`` on the motion, on the axes of a rotation."""
    x, y, z = there
    ways = ((k, one.read(g, (x, y, z), k)) for k in one.normals(g, (x, y, z)))
    axis, found = next(((k, own) for k, own in ways if own is not None), (0, None))
    if found is None:
        return None
    velocity, signed = found
    x, y, z = (a if b == c else g.neg(a) for a, b, c in zip(written, there, signed, strict=True))
    rates = tangent(g, signed, seeds)
    again = one.read(g, (rates[0], rates[1], rates[2]), axis, oriented=True)
    if again is not None:
        acceleration = again[0]
    else:
        a, b, c = tangent(g, velocity, seeds)
        turning = one.rotation.turning(g, [seeds[e] for e in one.rotation.e])
        acceleration = add_vectors(g, (a, b, c), cross(g, turning[1:], velocity))
    return _Placed(way, squares.factor, (x, y, z), one.rotation, velocity, acceleration)


def _moved(
    system: System,
    kinetic: Kinetic,
    frame: Frame,
    placed: Sequence[_Placed],
    on_motion: dict[Node, Node],
    seeds: dict[Node, Node],
) -> Moved:
    g, numbers = system.graph, []
    for own in placed:
        kinetic, number = _with_vector(kinetic, own)
        numbers.append(number)
    u = substitute(g, kinetic.atoms, on_motion)
    drift = tangent(g, u, seeds)
    carried = [False] * len(u)
    for number, own in zip(numbers, placed, strict=True):
        for k, velocity, rate in zip(number, own.velocity, own.acceleration, strict=True):
            u[k], drift[k], carried[k] = velocity, rate, True

    def weigh() -> tuple[Weights, ...]:
        made = []
        for e in frame.vectors[: system.l]:
            forms = substitute(g, tangent(g, kinetic.atoms, moving(system, e)), on_motion)
            for number, own in zip(numbers, placed, strict=True):
                in_space = [forms[k] for k in number]
                for k, column in zip(number, zip(*own.rotation.matrix, strict=True), strict=True):
                    forms[k] = g.dot(column, in_space)
            made.append(Weights(tuple(forms), ()))
        return tuple(made)

    return Moved(
        frame=frame,
        velocities=frame.kinematics,
        kinetic=kinetic,
        u=tuple(u),
        drift=tuple(drift),
        weights=tuple(Weights(tuple(tangent(g, u, {w: g.one})), ()) for w in frame.free),
        weigh=weigh,
        spread=None,
        carried=tuple(carried),
        inertial=tuple(carried),
        loads=(g.zero,) * len(u),
        potential=system.U,
        places={},
        settled=False,
        turning=(),
    )


def _with_vector(kinetic: Kinetic, placed: _Placed) -> tuple[Kinetic, list[int]]:
    """T with the vector's components for forms, and their numbers; a component that is no form of T yet comes behind the others."""
    g = kinetic.system.graph
    number = [k if k >= 0 else len(kinetic.u) for k in placed.group]
    more = int(len(kinetic.u) in number)
    size, zeros = len(kinetic.u) + more, [g.zero] * more
    u = [*kinetic.u, *(g.symbol(f"u{size}", "form") for _ in zeros)]
    atoms, slope = [*kinetic.atoms, *zeros], [*kinetic.slope, *zeros]
    hessian = [[*row, *zeros] for row in kinetic.hessian] + [[g.zero] * size for _ in zeros]
    rest = substitute(g, [kinetic.tau], {u[k]: g.zero for k in number})[0]
    for k, component in zip(number, placed.written, strict=True):
        atoms[k], slope[k], hessian[k][k] = component, g.mul(placed.factor, u[k]), placed.factor
    squares = g.sum([g.power(u[k], 2) for k in number])
    tau = g.add(rest, g.mul(g.div(placed.factor, g.number(2)), squares))
    made = Kinetic(kinetic.system, tuple(atoms), tuple(u), tau, tuple(slope), tuple(tuple(row) for row in hessian))
    return made, number
