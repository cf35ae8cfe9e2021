"""The velocities of a scene's start.

Given velocities and quasi-velocities are equations beside the constraints; what is left free is zero, independent
velocities first, so that dependent ones follow from the constraints.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.dense import RowSpace
from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.diagnostics import Bag
from nhc.language.spec import Initial, Scene
from nhc.mechanics.frame import coordinate_form
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.regular.trials import velocity_units
from nhc.mechanics.starts.contradictions import TOLERANCE, Claim, meet
from nhc.mechanics.system import Form, System


def start_velocities(
    system: System, scene: Scene, place: dict[Node, float], given: dict[tuple[str, str], float], bag: Bag
) -> tuple[float, ...]:
    """The start of all velocities: they satisfy the constraints, then what is given, then zeros for what is left free."""
    try:
        claims = _claims(system, scene, place, given)
    except (ArithmeticError, ValueError):
        what = f"{scene.called} starts at a singular point of the constraints"
        bag.error("E0409", what, scene.span, help=("start a little away from it",))
        return (0.0,) * system.n
    return _with_zeros(system, place, given, meet(bag, scene, claims))


def given_velocities(
    system: System, scene: Scene, place: dict[Node, float], given: dict[tuple[str, str], float]
) -> tuple[float, ...]:
    """The velocities that a scene gives, consistent or not: what it leaves out follows from the constraints that hold with what it
    gives, then zeros as in a consistent start.

    Raises:
        nhc.diagnostics.SpecError: what the scene gives contradicts itself, whatever the constraints say.
        ArithmeticError or ValueError: a form has no value there.
    """
    bag, claims = Bag(system.spec.origin), _claims(system, scene, place, given)
    solver = meet(bag, scene, [claim for claim in claims if claim.entry], projecting=True)
    bag.raise_if_errors()
    solver.size = system.n
    for claim in claims[: system.l]:
        solver.add(claim.row, claim.right)  # without effect where it does not hold
    return _with_zeros(system, place, given, solver)


def _with_zeros(
    system: System, place: dict[Node, float], given: dict[tuple[str, str], float], solver: RowSpace
) -> tuple[float, ...]:
    """What equations of velocities leave free is zero, in order."""
    units = velocity_units(system)
    solver.size = system.n
    for row, value in _equations_at(system, place, [(form, 0.0) for form in _free_order(system, given)]):
        solver.add([a * u for a, u in zip(row, units, strict=True)], value)
    return tuple(x * u for x, u in zip(solver.solution(), units, strict=True))


def _claims(system: System, scene: Scene, place: dict[Node, float], given: dict[tuple[str, str], float]) -> list[Claim]:
    """The constraints, and the velocities that are given, as equations at a place.

    Raises:
        ArithmeticError or ValueError: a form has no value there.
    """
    velocities = [(entry, given[entry.kind, entry.name]) for entry in scene.initial if entry.kind != "coordinate"]
    forms = [(form, 0.0) for form in system.constraints]
    forms += [(_form_of(system, entry), value) for entry, value in velocities]
    equations, units = _equations_at(system, place, forms), velocity_units(system)
    rows, right = [row for row, _ in equations], [value for _, value in equations]
    sizes = term_sizes(system, rows, right, _unseen(system, scene, place))
    scaled = [tuple(a * u for a, u in zip(row, units, strict=True)) for row in rows]
    found = list[Claim]()
    for k, (row, value, size) in enumerate(zip(scaled, right, sizes, strict=True)):
        if k < system.l:
            found.append(Claim(system.constraints[k].name, row, value, size))
        else:
            entry, said = velocities[k - system.l]
            name = f"{entry.name}'" if entry.kind == "velocity" else entry.name
            found.append(Claim(name, row, value, size, entry, said, entry.span != scene.span))
    return found


def _form_of(system: System, entry: Initial) -> Form:
    if entry.kind == "velocity":
        return coordinate_form(system, system.q_names.index(entry.name))
    return next(form for form in system.quasi if form.name == entry.name)


def _equations_at(
    system: System, place: dict[Node, float], forms: Sequence[tuple[Form, float]]
) -> list[tuple[list[float], float]]:
    """Coefficients of the velocities and right side of form = value at a place."""
    found = []
    for form, value in forms:
        *row, constant = (float(x) for x in evaluate(system.graph, [*form.coefficients, form.constant], place))
        found.append((row, value - constant))
    return found


def _unseen(system: System, scene: Scene, place: dict[Node, float]) -> list[float]:
    """Velocities so small that TOLERANCE of them is lost in the rounding of the coordinates in the whole scene."""
    duration = abs(float(scene.time[1] - scene.time[0]))
    return [2.0**-52 * abs(place[q]) / duration / TOLERANCE if duration else 0.0 for q in system.q]


def term_sizes(
    system: System, rows: Sequence[Sequence[float]], right: Sequence[float], least: Sequence[float] = ()
) -> list[float]:
    """How large the terms of each equation of velocities can be: its largest coefficient times the largest speed that any of the
    equations gives which share velocities with it, directly or through others, in the units in which coefficients are near 1.
    ``least``: what each velocity counts as in any case.
    """
    units = velocity_units(system)
    rests = [value / unit for value, unit in zip(least, units, strict=False)]
    lengths = [max((abs(a) * u for a, u in zip(row, units, strict=True)), default=0.0) for row in rows]
    speeds = [abs(value) / length if length else 0.0 for value, length in zip(right, lengths, strict=True)]
    for k, row in enumerate(rows):
        speeds[k] = max([speeds[k], *(rest for a, rest in zip(row, rests, strict=False) if a)])
    part = list(range(len(rows)))
    for j in range(system.n):
        joined = {part[k] for k, row in enumerate(rows) if row[j]}
        part = [min(joined) if p in joined else p for p in part]
    fastest = {p: max(speed for speed, other in zip(speeds, part, strict=True) if other == p) for p in part}
    return [length * fastest[p] for length, p in zip(lengths, part, strict=True)]


def _free_order(system: System, given: dict[tuple[str, str], float]) -> list[Form]:
    """What is set to zero, first come first served: quasi-velocities when the scene speaks in them, else independent velocities,
    with those of rotations (a zero rate of one entry of a quaternion is a spin, another one for each orientation).
    """
    dependent = system.dependent or choose_dependent(system).dependent
    independent = [i for i in range(system.n) if i not in dependent]
    coordinates = [coordinate_form(system, i) for i in (*independent, *dependent)]
    asked = [name for kind, name in given if kind == "quasi"]
    angular = [form for form in system.quasi if form.name in system.angular]
    if any(name not in system.angular for name in asked):
        return [*system.quasi, *coordinates]
    if asked:  # angular velocities alone say nothing of the spec's own quasi-velocities
        return [*angular, *coordinates]
    first = [coordinate_form(system, i) for i in independent if system.q_names[i] not in system.turned]
    return [*first, *angular, *coordinates]
