"""Angular velocities of axes among T's forms: recognised, computed along the chain of turns, differentiated by Euler's rule.

For the components Omega_i of the angular velocity of turned axes on themselves, dOmega(X, e) = -Omega(X) x Omega(e).  A form that
differs from Omega_i by an exact one (a wheel's spin about its axle) has the same derivative.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable
from nhc.mechanics.energies.kinetic import Kinetic, exterior_derivative
from nhc.mechanics.moving.axes import Setting
from nhc.mechanics.moving.bodies import Bodies
from nhc.mechanics.moving.rates import Solution
from nhc.mechanics.rotations.turning import Direction
from nhc.mechanics.rotations.turns import Path, Turn, Vector, cross
from nhc.records import record


@record
class Spin:
    """``members[i]`` are the numbers of T's forms whose derivative is that of the i-th component.

    ``forms`` are the numbers of the forms that are the vector itself (-1: zero), where T has them: the angular velocity, or the
    velocity of a point whose momentum has a part from it.
    """

    path: Path
    members: tuple[tuple[int, ...], tuple[int, ...], tuple[int, ...]]
    forms: tuple[int, ...] | None = None


def spatial_paths(setting: Setting) -> list[Path]:
    """Axes turned in space, and those turned back from a tilt, on which a spec may have its components."""
    found = dict[Path, None]()
    for path in setting.paths:
        for length in range(2, len(path) + 1):
            found.setdefault(path[:length])
            for back in setting.backs:
                found.setdefault((*path[:length], back))
        if len(path) > 2 and not setting.graph.deps[path[-2].angle] & setting.graph.mask(setting.system.q):
            tilt = path[-2]
            found.setdefault((*path, Turn(tilt.plane, setting.graph.neg(tilt.angle))))
    return [path for path in found if len({axis for turn in path for axis in turn.plane}) == 3]


def recognise(setting: Setting, kinetic: Kinetic, roots: Sequence[Node]) -> None:
    """Expressions of the spec that are components of an angular velocity are replaced by the chain's."""
    g, paths = setting.graph, spatial_paths(setting)
    if not paths:
        return
    moving = g.mask(setting.system.v)
    names = {setting.marks.of(node): node for node in reversed(reachable(g, [*kinetic.atoms, *roots], moving))}
    for path in paths:
        for component in setting.spin(path):
            if component == g.zero or component in setting.system.v:
                continue
            mark = setting.marks.of(component)
            same, opposite = names.get(mark), names.get(setting.marks.negative(mark))
            if same is not None and same not in setting.system.v:
                setting.replaced.setdefault(same, component)
            elif opposite is not None and opposite not in setting.system.v:
                setting.replaced.setdefault(opposite, g.neg(component))


def find_spins(setting: Setting, kinetic: Kinetic, done: Sequence[bool], near: Collection[Path]) -> list[Spin]:
    """T's forms whose exterior derivative is that of a component of an angular velocity; ``near`` are tried first."""
    g, system = setting.graph, setting.system
    open_forms = [k for k, carried in enumerate(done) if not carried and not kinetic.is_exact(k)]
    if not open_forms:
        return []
    first = tuple(g.symbol(f"first_{i}", "test") for i in range(system.n + 1))
    second = tuple(g.symbol(f"second_{i}", "test") for i in range(system.n))
    x, e = Direction(system, first[:-1], first[-1]), Direction(system, second)
    derivative = {k: setting.marks.of(exterior_derivative(system, kinetic.form(k), x, e)) for k in open_forms}
    spins: list[Spin] = []
    for path in sorted(spatial_paths(setting), key=lambda path: path not in near):
        spin = setting.spin(path)
        along_x = substitute(g, spin, dict(zip(system.v, first[:-1], strict=True)))
        along_e = substitute(g, spin, dict(zip(system.v, second, strict=True)))
        turned = cross(g, (along_e[0], along_e[1], along_e[2]), (along_x[0], along_x[1], along_x[2]))
        members: list[tuple[int, ...]] = []
        for node in turned:
            mark = setting.marks.of(node)
            members.append(tuple(k for k in open_forms if derivative[k] == mark))
            open_forms = [k for k in open_forms if k not in members[-1]]
        if any(members):
            spins.append(Spin(path, (members[0], members[1], members[2])))
    return spins


def find_turning(setting: Setting, bodies: Bodies, inertial: Sequence[bool]) -> list[Spin]:
    """What turns with axes: angular velocities among T's forms, and the points whose momentum has a part from these."""
    members: dict[Path, list[list[int]]] = {
        path: [[k] if k >= 0 else [] for k in numbers] for path, numbers in bodies.spins.items()
    }
    own = {k for numbers in bodies.spins.values() for k in numbers}
    for spin in find_spins(
        setting, bodies.kinetic, [flag or k in own for k, flag in enumerate(inertial)], bodies.spins
    ):
        for known, more in zip(members.setdefault(spin.path, [[], [], []]), spin.members, strict=True):
            known += more
    found = [Spin(path, (tuple(x), tuple(y), tuple(z)), bodies.spins.get(path)) for path, (x, y, z) in members.items()]
    for point in bodies.points:
        if point.is_joined:
            x, y, z = ([k] if k >= 0 else [] for k in point.members)
            found.append(Spin(point.path, (tuple(x), tuple(y), tuple(z)), point.members))
    return found


def spin_weights(solution: Solution, path: Path, symbols: Sequence[Node]) -> tuple[Vector, ...]:
    """Omega(e_j) for the vectors of the frame that belong to the symbols."""
    setting = solution.setting
    spin = substitute(setting.graph, setting.spin(path), solution.found)
    weights = []
    for x, y, z in solution.columns(spin, symbols):
        weights.append((x, y, z))
    return tuple(weights)
