"""A scene's start: parameter values, positions, and velocities that satisfy the constraints."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.diagnostics import Bag, Span, quote, several, suggest
from nhc.language.expressions.syntax import Syntax
from nhc.language.spec import Scene, Spec
from nhc.mechanics.starts.assembly import assemble
from nhc.mechanics.starts.velocities import start_velocities
from nhc.mechanics.system import Form, System
from nhc.mechanics.values import constant_value, start_values
from nhc.records import record


@record
class Start:
    """``p`` in the spec's order; ``q`` and ``v`` at ``time[0]``."""

    scene: Scene
    time: tuple[float, float]
    p: tuple[float, ...]
    q: tuple[float, ...]
    v: tuple[float, ...]

    def values(self, system: System) -> dict[Node, float]:
        """Every symbol of the system with its value."""
        return {
            system.t: self.time[0],
            **dict(zip(system.p, self.p, strict=True)),
            **dict(zip(system.q, self.q, strict=True)),
            **dict(zip(system.v, self.v, strict=True)),
        }


def check_scene_name(spec: Spec, scene: str) -> None:
    """Refuse a name that no scene of the spec has; an empty one asks for none.

    Raises:
        nhc.diagnostics.SpecError: with the scenes that there are.
    """
    names = [s.name for s in spec.scenes]
    if not scene or scene in names:
        return
    help = suggest(scene, names, "name one of them after `--scene`, or add it under `scenes:`")
    bag = Bag(spec.origin)
    report_scene(bag, spec.key_span("scenes"), scene, spec, help)
    bag.raise_if_errors()


def report_scene(bag: Bag, span: Span, scene: str, spec: Spec, help: str, *notes: str) -> None:
    """E0503: a scene that the spec does not have, with those that it has and further notes."""
    known = f"the spec's scenes: {quote(s.name for s in spec.scenes) or 'none'}"
    bag.error("E0503", f"no scene `{scene}`", span, notes=(known, *notes), help=(help,))


def start_of(system: System, scene: Scene) -> Start:
    """The consistent start of a scene.

    Raises:
        nhc.diagnostics.SpecError: a parameter without value, or a start that violates the constraints.
    """
    bag = Bag(system.spec.origin)
    p, place, given = _positions(system, scene, bag)
    _check_positions(system, scene, place, bag)
    v = start_velocities(system, scene, place, given, bag)
    bag.raise_if_errors()
    return Start(scene, (float(scene.time[0]), float(scene.time[1])), p, tuple(place[q] for q in system.q), v)


def place_of(system: System, scene: Scene) -> dict[Node, float]:
    """The time, the parameters and the coordinates where a scene starts, whatever its velocities are.

    Raises:
        nhc.diagnostics.SpecError: a parameter or a coordinate has no value.
    """
    return _positions(system, scene, Bag(system.spec.origin))[1]


def _positions(
    system: System, scene: Scene, bag: Bag
) -> tuple[tuple[float, ...], dict[Node, float], dict[tuple[str, str], float]]:
    """Parameters, the place of the start, and all that the scene gives."""
    p = _parameters(system, scene, bag)
    bag.raise_if_errors()
    given = initial_values(system, scene, start_values(system.spec, scene, p), bag)
    bag.raise_if_errors()
    q = [given.get(("coordinate", c.name), float(c.start)) for c in system.spec.coordinates]
    place = {
        system.t: float(scene.time[0]),
        **dict(zip(system.p, p, strict=True)),
        **dict(zip(system.q, q, strict=True)),
    }
    near = _near(system, scene)
    return p, assemble(system, place, near) if near else place, given


def _near(system: System, scene: Scene) -> list[int]:
    """The coordinates that the scene says only roughly."""
    return [system.q_names.index(entry.name) for entry in scene.initial if entry.near]


def initial_values(system: System, scene: Scene, names: dict[str, float], bag: Bag) -> dict[tuple[str, str], float]:
    """The numbers that the scene gives, for its values of the parameters."""
    turned = {system.q_names[k] for rotation in system.rotations for k in rotation.places}
    given: dict[tuple[str, str], float] = {}
    for entry in scene.initial:
        value = _constant(entry.value, names)
        if not math.isfinite(value) and not any(d.labels[0].span == entry.span for d in bag.diagnostics):
            what = f"the start of `{entry.name}` in {scene.called} has no real, finite value"
            zero = "; a quaternion must not be zero" if entry.name in turned else ""
            advice = f"correct the expression, or the values of the parameters in the scene{zero}"
            bag.error("E0313", what, entry.span, help=(advice,))
        given[entry.kind, entry.name] = value
    return given


def _constant(tree: Syntax, names: dict[str, float]) -> float:
    """The value, not a number where there is none."""
    try:
        return constant_value(tree, names)
    except (ArithmeticError, ValueError):
        return math.nan


def _parameters(system: System, scene: Scene, bag: Bag) -> tuple[float, ...]:
    override = {entry.name: entry.value for entry in scene.parameters}
    values, names = [], dict[str, float]()
    for parameter in system.spec.parameters:
        value = override.get(parameter.name, parameter.value)
        if value is None:
            bag.error(
                "E0418",
                f"{scene.called} gives no value to the parameter `{parameter.name}`",
                scene.span,
                help=(
                    f"add `parameters: {{{parameter.name}: ...}}` to the scene, or a value under `parameters:`"
                    if scene.name
                    else f"write `{parameter.name}=...` beside it, or a value under `parameters:`",
                ),
            )
            value = Fraction(1)
        number = float(value) if isinstance(value, Fraction) else _constant(value, names)
        if not math.isfinite(number):
            what = f"`{parameter.name}` has no real, finite value in {scene.called}"
            place = next((entry.span for entry in scene.parameters if entry.name == parameter.name), scene.span)
            bag.error("E0313", what, place, help=("correct the expression: it may divide by zero",))
        names[parameter.name] = number
        values.append(number)
    return tuple(values)


def _check_positions(system: System, scene: Scene, place: dict[Node, float], bag: Bag) -> None:
    off = _distances(system, place)
    if not off:
        return
    names = [f"`{name}` by {value:.3g}" for name, value, _ in off]
    what = (
        f"the constraint {names[0]}"
        if len(names) == 1
        else f"{several(len(names), 'constraint')}: {', '.join(names[:6])}"
    )
    more = ", ..." if len(names) > 6 else ""
    near = _near(system, scene)
    left = left_at_zero(system, scene, place, [node for _, _, node in off])
    source = "`initial` does not give a value" if scene.name else "`--about` gives no value"
    notes = [f"{left} at 0, since {source}"] if left else []
    if near:
        names = [f"`{system.q_names[i]}`" for i in near]
        notes.append(f"this is left at the best place for {', '.join(names)} near what `initial` says")
    bag.error(
        "E0409",
        f"{scene.called} starts off {what}{more}",
        scene.span,
        notes=tuple(notes),
        help=_advise(system, scene, place),
    )


def _distances(system: System, place: dict[Node, float]) -> list[tuple[str, float, Node]]:
    """(name, value, equation) of the holonomic constraints that do not hold at a place."""
    found = []
    for form in system.constraints:
        if form.equation is None:
            continue
        try:
            off = float(evaluate(system.graph, [form.equation], place)[0])
        except (ArithmeticError, ValueError):
            off = math.nan
        if not abs(off) <= 1e-6:
            found.append((form.name, off, form.equation))
    return found


def _advise(system: System, scene: Scene, place: dict[Node, float]) -> tuple[str, ...]:
    """Coordinates at which the constraints hold, if there are any near the start."""
    free = [i for i, name in enumerate(system.q_names) if name not in system.turned]
    there = assemble(system, place, free)
    moved = [(system.q_names[i], there[system.q[i]]) for i in free if there[system.q[i]] != place[system.q[i]]]
    if not moved or _distances(system, there):
        return ("give initial coordinates that satisfy the constraints",)
    if not scene.name:
        pairs = ", ".join(f"{name}={value:.10g}" for name, value in moved)
        return (f"the nearest place where the constraints hold: `{pairs}`",)
    some = ", ".join(f"{name}: {value:.10g}" for name, value in moved[:8])
    few = moved[: max(1, min(len(system.constraints), 4))]
    if _distances(system, assemble(system, place, [system.q_names.index(name) for name, _ in few])):
        few = moved[:8]  # one of the others is given where no place is
    near = ", ".join(f"{name}: {{near: {value:.2g}}}" for name, value in few)
    return (
        f"the nearest place where the constraints hold: `{some}{', ...' if len(moved) > 8 else ''}`",
        f"or let coordinates follow from the others: `{near}`",
    )


def left_at_zero(system: System, scene: Scene, place: dict[Node, float], nodes: Sequence[Node]) -> str:
    """`` `x`, `y` start`` of the coordinates that some of the nodes depend on and that the scene leaves at 0; empty for none."""
    g = system.graph
    given = {entry.name for entry in scene.initial if entry.kind == "coordinate"}
    names = [
        f"`{name}`"
        for symbol, name in zip(system.q, system.q_names, strict=True)
        if place[symbol] == 0.0 and name not in given and any(g.depends(node, g.deps[symbol]) for node in nodes)
    ]
    return f"{', '.join(names)} {'starts' if len(names) == 1 else 'start'}" if names else ""


def kept_velocities(system: System, forms: Sequence[Form], start: Start) -> list[float]:
    """The values of velocity forms at the start; not a number where a form has none (log(x) x' at x = 0)."""
    place = start.values(system)
    result = []
    for form in forms:
        try:
            numbers = [float(x) for x in evaluate(system.graph, [*form.coefficients, form.constant], place)]
        except (ArithmeticError, ValueError):
            numbers = [math.nan] * (system.n + 1)
        result.append(sum(a * v for a, v in zip(numbers[:-1], start.v, strict=True)) + numbers[-1])
    return result
