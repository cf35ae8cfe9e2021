"""The velocities of a rolling body's points on its own axes, where a rotation turns it: a ball, an ellipsoid, a disc.

What the constraints make of a point's velocity is u_i = R_i . V for the rows R_i of the matrix, but few specs say so: a ball has
x' = a R_y . omega.  With gamma = R_k for one of the three axes of space, the normal of the plane, and i, j, k in cyclic order,

    R_j = gamma x R_i,    R_i = R_j x gamma,

so that a component that is linear in R_i and R_j is one of R_i alone: alpha . R_i + beta . R_j = (alpha + beta x gamma) . R_i.
Where both rows give one V across gamma, and the third component is one over gamma (R_i x R_j is), T's squares are those of V, which
needs one row of the matrix in place of three; with gamma^2 = 1 an ellipsoid's V is k x omega again, k to its contact.
Accelerations are read in the same way, or V' + omega x V, if that is shorter.  (E. J. Routh, Advanced Rigid Dynamics, 6th ed.
(1905), article 241, has these equations of a body that rolls on a plane.)
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import islice

from nhc.algebra.calculus import tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.known_values import known_value
from nhc.algebra.parts import split_parameters
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import count
from nhc.mechanics.energies.kinetic import Kinetic, is_exact_rate
from nhc.mechanics.frame import Frame
from nhc.mechanics.moving.moved import Moved, Weights
from nhc.mechanics.moving.rows import lone_squares
from nhc.mechanics.moving.seen import Seen
from nhc.mechanics.rotations.rotation import Rotation, spell
from nhc.mechanics.rotations.turning import along, moving
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross
from nhc.mechanics.system import System
from nhc.records import record


@record
class _Squares:
    """h/2 (x^2 + y^2 + z^2) in T: the numbers of the forms along axes of space that may be meant (-1: no form, and zero), of which
    the first few are ``usual``, what they are to be multiplied with to be x, y, z, and h.
    """

    ways: tuple[tuple[int, int, int], ...]
    usual: int
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
    g, seen = system.graph, list[Seen]()
    for rotation in frame.turned:
        if rotation.sign > 0:
            own = spell(g, rotation)
            seen.append(Seen(rotation, own, g.mask((*frame.free, *own.omega))))
    squares = _squares(system, kinetic) if seen else []
    if not squares:
        return None
    on_motion = moving(system, frame.kinematics)
    seeds = {**along(system, frame.kinematics), system.t: g.one}
    placed: list[_Placed] = []
    for group in squares:
        ways = [
            (way, [g.mul(group.scale[k], kinetic.atoms[k]) if k >= 0 else g.zero for k in way]) for way in group.ways
        ]
        options = [(way, written, substitute(g, written, on_motion)) for way, written in ways]
        for one in seen:
            order = [*options[: group.usual], *(x for x in options[group.usual :] if one.fits(g, x[2]))]
            fitting = any(one.fits(g, x[2]) for x in options[: group.usual])
            places = (_place(g, one, way, group, written, there, seeds) for way, written, there in order)
            found = list(islice((x for x in places if x), 1 if fitting else 2))
            if found:
                placed.append(min(found, key=lambda x: count(g, [*x.velocity, *x.acceleration])))
                break
    return _moved(system, kinetic, frame, placed, on_motion, seeds) if placed else None


def _squares(system: System, kinetic: Kinetic) -> list[_Squares]:
    """Exact forms by threes, as they are written; two where there is no third."""
    g, classes = system.graph, list[tuple[Node, dict[int, Node]]]()
    for k in lone_squares(g, kinetic):
        factor = kinetic.hessian[k][k]
        for first, members in classes:
            scale = _root(system, g.div(factor, first))
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
                    found.append(_Squares(_orders(x, y, z), 1, members, factor))
                case [x, y]:
                    found.append(_Squares(_orders(x, y, -1), 3, members, factor))
    return found


def _orders(x: int, y: int, z: int) -> tuple[tuple[int, int, int], ...]:
    """Along which axes the components may be: as they are written first, then with others between."""
    return (x, y, z), (z, x, y), (x, z, y), (y, x, z), (z, y, x), (y, z, x)


def _root(system: System, ratio: Node) -> Node | None:
    """A root of a product of even powers of parameters and a rational square; None of anything else."""
    g = system.graph
    factor, rest = split_parameters(g, ratio, g.mask(system.p))
    root = known_value("sqrt", factor.number)
    if root is None or rest != g.one or any(n % 2 for n in factor.powers.values()):
        return None
    return g.product([g.number(root), *(g.power(base, n // 2) for base, n in factor.powers.items())])


def _place(
    g: Graph,
    one: Seen,
    way: tuple[int, int, int],
    squares: _Squares,
    written: Sequence[Node],
    there: Sequence[Node],
    seeds: dict[Node, Node],
) -> _Placed | None:
    """The vector with components ``written``, which are ``there`` on the motion, on the axes of a rotation."""
    x, y, z = there
    ways = ((k, one.read(g, own, k)) for k, own in one.normals(g, (x, y, z)))
    axis, found = next(((k, own) for k, own in ways if own is not None), (0, None))
    if found is None:
        return None
    velocity, signs = found
    x, y, z = map(g.scale, signs, written)
    rates = tangent(g, [*map(g.scale, signs, there)], seeds)
    again = one.read(g, (rates[0], rates[1], rates[2]), axis, oriented=True)
    a, b, c = tangent(g, velocity, seeds)
    turning = one.rotation.turning(g, [seeds[e] for e in one.rotation.e])
    acceleration = add_vectors(g, (a, b, c), cross(g, turning[1:], velocity))
    if again is not None and count(g, again[0]) < count(g, acceleration):
        acceleration = again[0]
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
        velocities=_in_space(system, frame.kinematics, placed),
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


def _in_space(system: System, velocities: Sequence[Node], placed: Sequence[_Placed]) -> tuple[Node, ...]:
    """The velocities, of which those that are components of a vector are taken from it, R_i . V, where that is shorter."""
    g, made = system.graph, list(velocities)
    for own in placed:
        for component, row in zip(own.written, own.rotation.matrix, strict=True):
            for i, v in enumerate(system.v):
                if v in (component, g.neg(component)):
                    value = g.dot(row, own.velocity)
                    known = (*own.acceleration, *row)  # what is computed anyhow
                    other = value if v == component else g.neg(value)
                    if count(g, [*known, other]) < count(g, [*known, made[i]]):
                        made[i] = other
    return tuple(made)


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
