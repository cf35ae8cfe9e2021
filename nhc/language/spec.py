"""The Spec: a spec's whole content, names resolved, as frozen data with places."""

from __future__ import annotations

from fractions import Fraction
from functools import cached_property
from typing import Any

from nhc.diagnostics import Source, Span
from nhc.language.expressions.syntax import Syntax
from nhc.records import record

DEFAULT_TOLERANCE = Fraction(1, 10**8)
LEAST_TOLERANCE = Fraction(1, 10**15)
LEAST_PART = Fraction(1, 10**12)
"""Of its times that a scene lasts."""
LEAST_TIME = Fraction(1, 10**100)
"""That a scene lasts: squares of steps are doubles, too."""
FORMULATIONS = ("auto", "newton", "lagrange", "euler-lagrange", "chaplygin", "voronec", "multipliers")
ROTATION_FRAMES = ("body", "space")
FIGURES = ("point", "line", "circle", "body")
Place = tuple[Syntax, ...]


@record
class Coordinate:
    """A generalized coordinate; ``range`` is where it is meant to stay, ``start`` where a scene starts that says nothing."""

    name: str
    span: Span
    unit: str = ""
    about: str = ""
    range: tuple[Fraction, Fraction] | None = None
    start: Fraction = Fraction(0)


@record
class Rotation:
    """An orientation: the names of its quaternion (4), of its angular velocity (3) and of its matrix (9, row by row).

    ``frame`` says on which axes the angular velocity has its components: "body" or "space".  The quaternion's names are
    among the spec's coordinates, those of the angular velocity among its quasi-velocities.
    """

    name: str
    span: Span
    frame: str
    coordinates: tuple[str, ...]
    velocities: tuple[str, ...]
    entries: tuple[str, ...]
    about: str = ""


@record
class Body:
    """A body as the spec says it, for people: its mechanics stand among definitions and energies.

    Expressions are texts of the language; ``on`` is empty in space, ``at`` and ``centre`` where they are the origin, ``turns``
    are pairs of an axis and an angle, ``rotation`` names what turns it in their place; ``inertia`` are pairs of an entry
    ("xx", or "" for what counts about every axis) and its text, ``place`` is where it stands.
    """

    name: str
    on: str
    at: tuple[str, ...]
    turns: tuple[tuple[str, str], ...]
    rotation: str
    mass: str
    centre: tuple[str, ...]
    inertia: tuple[tuple[str, str], ...]
    about: str
    place: Span


@record
class Point:
    """A point as the spec says it, for people: ``at`` on the axes of ``on`` (empty: space), with the matter of ``of`` there."""

    name: str
    on: str
    of: str
    at: tuple[str, ...]
    about: str


@record
class Parameter:
    """A constant of the system: a number, a constant expression (``pi/10``), or None where each scene gives it."""

    name: str
    span: Span
    value: Fraction | Syntax | None = None
    unit: str = ""
    about: str = ""


@record
class Definition:
    """A name with its expression: an entry of ``define``, ``quasi_velocities``, ``forces`` or ``outputs``."""

    name: str
    value: Syntax
    span: Span


@record
class Constraint:
    """``left = right``; ``form`` is "velocity" (x' and so on) or "differential" (dx, dt)."""

    name: str
    left: Syntax
    right: Syntax
    form: str
    span: Span


@record
class Holonomic:
    """``left = right`` between positions and time."""

    name: str
    left: Syntax
    right: Syntax
    span: Span


@record
class Override:
    """A scene's own value of a parameter."""

    name: str
    value: Fraction | Syntax
    span: Span


@record
class Initial:
    """A scene's start: ``kind`` is "coordinate", "velocity" (of the coordinate ``name``) or "quasi".

    The value holds numbers, ``pi``, parameters and definitions of these only.  ``near``: a coordinate that starts near it,
    where the holonomic constraints hold.
    """

    kind: str
    name: str
    value: Syntax
    span: Span
    near: bool = False


@record
class Figure:
    """A shape to draw: ``kind`` is one of ``FIGURES``, ``name`` its label or empty.

    ``points``: of a point or line, two or three expressions each; a circle's centre; a body's corners on its own axes.
    A circle has ``radius``, and ``normal`` (three, or empty); a body ``at`` (two) and ``angle``. ``trace``: points only.
    """

    kind: str
    name: str
    span: Span
    points: tuple[Place, ...]
    trace: bool = False
    radius: Syntax | None = None
    normal: Place = ()
    at: Place = ()
    angle: Syntax | None = None

    @property
    def expressions(self) -> tuple[Syntax, ...]:
        """Everything that it is made of."""
        places = (*self.points, self.normal, self.at)
        single = tuple(tree for tree in (self.radius, self.angle) if tree is not None)
        return (*(tree for place in places for tree in place), *single)

    @property
    def spatial(self) -> bool:
        """Whether it leaves the plane z = 0."""
        return bool(self.normal) or any(len(place) == 3 for place in self.points)


def reaction_name(constraint: str) -> str:
    """What the reaction of a constraint is called in tables, and where a scene needs it alone."""
    return f"lambda_{constraint}"


@record
class Need:
    """What a scene needs.

    ``kind`` is "coordinate", "velocity" (``name`` is ``x'``), "quasi", "output", "energy", "reactions" (all of them) or "reaction"
    (``name`` is :func:`reaction_name` of its constraint).
    """

    kind: str
    name: str
    span: Span


@record
class Scene:
    """A concrete situation; what ``initial`` leaves out is 0; ``need`` is never empty.

    ``name`` is empty for a motion that the command line describes.
    """

    name: str
    span: Span
    about: str
    parameters: tuple[Override, ...]
    initial: tuple[Initial, ...]
    time: tuple[Fraction, Fraction]
    need: tuple[Need, ...]
    tolerance: Fraction

    @property
    def called(self) -> str:
        """What messages call it."""
        return f"the scene `{self.name}`" if self.name else "the motion of `--about`"


@record
class Spec:
    """One decoded spec.

    ``definitions`` are in an order in which each needs only earlier ones (quasi-velocities aside); ``named_order`` is
    such an order of the names of definitions and quasi-velocities together, without what rotations bring.
    ``potential_kind`` is "U", "V" or "". ``T``, ``U``, ``V`` and ``energy`` may stand in outputs and then mean nhc's,
    unless the spec declares them. An output may bear the name of a definition; its value is that name then.
    ``velocities`` are names of definitions that stand for velocities of bodies and points, whatever they hold.
    """

    origin: Source
    version: int
    system: str
    about: str
    sources: tuple[str, ...]
    coordinates: tuple[Coordinate, ...]
    parameters: tuple[Parameter, ...]
    definitions: tuple[Definition, ...]
    kinetic: Syntax
    potential: Syntax | None
    potential_kind: str
    forces: tuple[Definition, ...]
    constraints: tuple[Constraint, ...]
    holonomic: tuple[Holonomic, ...]
    quasi_velocities: tuple[Definition, ...]
    named_order: tuple[str, ...]
    dependent: tuple[str, ...]
    formulation: str
    outputs: tuple[Definition, ...]
    draw: tuple[Figure, ...]
    scenes: tuple[Scene, ...]
    key_spans: tuple[tuple[str, Span], ...]
    rotations: tuple[Rotation, ...] = ()
    bodies: tuple[Body, ...] = ()
    points: tuple[Point, ...] = ()
    velocities: frozenset[str] = frozenset()

    @cached_property
    def memory(self) -> dict[str, Any]:
        """What is known of it by now, under the names of those who found it."""
        return {}

    def key_span(self, key: str) -> Span:
        """Return the place of a top-level key (``constraints``); the spec's start where it is not written."""
        return dict(self.key_spans).get(key, Span(0, 0))

    def is_brought(self, name: str) -> bool:
        """Whether the name is one that a body or a point brings, as ``wheel_x``."""
        placed = [*(body.name for body in self.bodies), *(point.name for point in self.points)]
        return any(name.startswith(f"{own}_") for own in placed)

    @property
    def named_values(self) -> list[tuple[str, Syntax]]:
        """Definitions and quasi-velocities in ``named_order``."""
        values = {item.name: item.value for item in (*self.definitions, *self.quasi_velocities)}
        return [(name, values[name]) for name in self.named_order]

    @property
    def time_unit(self) -> str:
        """Seconds where something has a unit of its own; else none."""
        turned = {name for rotation in self.rotations for name in rotation.coordinates}
        units = [*(c.unit for c in self.coordinates if c.name not in turned), *(p.unit for p in self.parameters)]
        return "s" if any(units) else ""

    @property
    def constraint_spans(self) -> dict[str, Span]:
        """The place of each constraint, holonomic ones as well, by its name."""
        rows: tuple[Constraint | Holonomic, ...] = (*self.constraints, *self.holonomic)
        return {row.name: row.span for row in rows}
