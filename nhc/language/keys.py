"""The one table of the keys of a spec; the decoder's checks, the JSON Schema and the reference are made from it."""

from __future__ import annotations

from nhc.language.spec import FORMULATIONS, ROTATION_FRAMES
from nhc.records import record

VERSION = 1
SYSTEM_PATTERN = "[a-z][a-z0-9_]*"
START_FORMS = (("axis", "angle"), ("order", "angles"), ("yaw", "pitch", "roll"))
"""The keys of each form that the start of a rotation may have."""
Forms = tuple[tuple[str, ...], ...]
_FORMS: tuple[tuple[tuple[str, ...], Forms], ...] = (
    ((), (("U",), ("V",))),
    (("bodies", "*"), (("turns",), ("rotation",))),
    (("scenes", "*", "initial", "*"), START_FORMS),
)


@record
class Key:
    """One key of a mapping. ``kind`` names the shape of its value (see ``schema.SHAPES``)."""

    name: str
    kind: str
    required: bool
    about: str
    choices: tuple[str, ...] = ()

    def optional(self) -> Key:
        """The same key where it may be left out."""
        return Key(self.name, self.kind, False, self.about, self.choices)


_TURNS = "turns from the axes of its parent to its own, one after another: `[z: yaw, x: roll]`; `[]` if left out"
_INERTIA = (
    "about the centre of mass on its own axes: one moment about every axis, `[A, B, C]`, or entries of the matrix"
)
_COORDINATES = "a list of names, or each name with `unit`, `about`, `range`; may be left out beside `rotation`"

SPEC_KEYS = (
    Key("nhc", "version", True, f"language version; {VERSION} is the only one"),
    Key(
        "extends",
        "text",
        False,
        "a base spec, by its path from this folder; keys that are not given here are taken from it",
    ),
    Key("system", "system", True, f"name of files and functions, `{SYSTEM_PATTERN}`"),
    Key("about", "text", False, "what the system is, in a sentence"),
    Key("source", "texts", False, "where the system comes from: a list of citations"),
    Key("coordinates", "coordinates", True, _COORDINATES),
    Key(
        "rotation",
        "rotations",
        False,
        "orientations in space: each name with `velocities`, `frame`, or a list of names",
    ),
    Key("parameters", "parameters", False, "constants: each name with its number, or with `value`, `unit`, `about`"),
    Key("bodies", "bodies", False, "rigid bodies, by name: mass, inertia, place and turns, from which nhc makes T"),
    Key("points", "points", False, "points on bodies, by name: their places and velocities"),
    Key("gravity", "place", False, "acceleration of gravity on all bodies: `[X, Y]` or `[X, Y, Z]`, in space"),
    Key("define", "expressions", False, "named expressions, in any order without a cycle"),
    Key("T", "expression", True, "kinetic energy; that of `bodies` is added, and it may be left out beside them"),
    Key("U", "expression", False, "force function, Q_i = + dU/dq_i; not together with `V`"),
    Key("V", "expression", False, "potential energy, Q_i = - dV/dq_i; not together with `U`"),
    Key(
        "forces", "expressions", False, "forces on coordinates, positions and velocities; torques by angular velocities"
    ),
    Key("constraints", "equations", False, "constraints linear in the velocities: a list of `text` or `name: text`"),
    Key("holonomic", "equations", False, "constraints `f(q, t) = 0`: a list of `text` or `name: text`"),
    Key(
        "quasi_velocities",
        "expressions",
        False,
        "names of linear forms in the velocities that the constraints leave free, in order",
    ),
    Key("dependent", "names", False, "the coordinates whose velocities the constraints are solved for"),
    Key("formulation", "choice", False, "how the equations are formed; `auto` if left out", FORMULATIONS),
    Key("outputs", "expressions", False, "named quantities besides the state; `T`, `U`, `V`, `energy` may be used"),
    Key("draw", "figures", False, "a list of shapes that the page of a run draws and moves"),
    Key("scenes", "scenes", False, "concrete situations, by name"),
)

BODILY = ("bodies", "points", "gravity")
"""Keys that are written out as definitions and energies before anything else reads the spec."""

INSTEAD = {"coordinates": "rotation", "T": "bodies"}
"""Required keys that may be left out beside another one."""

COORDINATE_KEYS = (
    Key("unit", "unit", False, "unit, such as `m` or `rad`"),
    Key("about", "text", False, "what it is"),
    Key("range", "interval", False, "where it is expected to stay: `[low, high]`"),
)

ROTATION_KEYS = (
    Key("velocities", "three", False, "names of the angular velocity's components; `R_w1`, `R_w2`, `R_w3` if left out"),
    Key("frame", "choice", False, "the axes of these components; `body` if left out", ROTATION_FRAMES),
    Key("quaternion", "four", False, "names of the quaternion, its scalar part first; `R_0` to `R_3` if left out"),
    Key("about", "text", False, "what it is"),
)

BODY_KEYS = (
    Key("parent", "name", False, "the body on whose axes it is placed; space if left out"),
    Key(
        "at", "place", False, "its origin on the axes of its parent: `[X, Y]` or `[X, Y, Z]`; their origin if left out"
    ),
    Key("turns", "turns", False, _TURNS),
    Key("rotation", "name", False, "in place of `turns`: a rotation, from its own axes to those of its parent"),
    Key("mass", "expression", False, "its mass; none if left out"),
    Key("centre", "place", False, "its centre of mass on its own axes; its origin if left out"),
    Key("inertia", "inertia", False, _INERTIA),
    Key("about", "text", False, "what it is"),
)

INERTIA_KEYS = (
    Key("xx", "expression", False, "moment about the first axis"),
    Key("yy", "expression", False, "moment about the second axis"),
    Key("zz", "expression", False, "moment about the third axis"),
    Key("yz", "expression", False, "entry of the matrix: minus the sum of m*y*z"),
    Key("xz", "expression", False, "entry of the matrix: minus the sum of m*x*z"),
    Key("xy", "expression", False, "entry of the matrix: minus the sum of m*x*y"),
)

POINT_KEYS = (
    Key("parent", "name", False, "the body on whose axes it is placed; space if left out"),
    Key("at", "place", True, "where it is on these axes: `[X, Y]` or `[X, Y, Z]`"),
    Key("of", "name", False, "the body whose matter moves there; the parent if left out"),
    Key("about", "text", False, "what it is"),
)

START_KEYS = (
    Key("axis", "vector", False, "axis of any length, with `angle`"),
    Key("angle", "expression", False, "angle about `axis`, in radians"),
    Key("angles", "vector", False, "three angles in radians, with `order`"),
    Key("order", "order", False, "the axes about which the body turns one after another, such as `zxz`"),
    Key("yaw", "expression", False, "first turn, about the body's third axis"),
    Key("pitch", "expression", False, "second turn, about the body's second axis"),
    Key("roll", "expression", False, "third turn, about the body's first axis"),
)

NEAR_KEYS = (Key("near", "expression", True, "where to look for it: the start follows from `holonomic`"),)

PARAMETER_KEYS = (
    Key("value", "number", False, "a number or a constant such as `pi/10`; without it each scene must give one"),
    Key("unit", "unit", False, "unit, such as `kg*m^2`"),
    Key("about", "text", False, "what it is"),
)

_NEED = (
    "what is wanted: coordinates, velocities, quasi-velocities, outputs, `energy`, `reactions`; "
    "all coordinates if left out"
)

SCENE_KEYS = (
    Key("about", "text", False, "what happens in it"),
    Key("parameters", "numbers", False, "values of parameters in this scene"),
    Key(
        "initial",
        "start",
        False,
        "coordinates (or `{near: ...}`), velocities (`x'`), quasi-velocities and rotations at the start; 0 if left out",
    ),
    Key("time", "interval", True, "start and end: `[0, 20]`"),
    Key("need", "needs", False, _NEED),
    Key("tolerance", "number", False, "wanted relative accuracy of what is needed; 1e-8 if left out"),
)

DRAW_KEYS = (
    Key("point", "place", False, "a dot at `[X, Y]` or `[X, Y, Z]`"),
    Key(
        "line", "places", False, "straight from point to point: `[[X1, Y1], [X2, Y2], ...]`, or with three numbers each"
    ),
    Key("circle", "circle", False, "a circle: `{centre: [X, Y], radius: R}`"),
    Key("body", "body", False, "a polygon that moves in the plane: `{at: [X, Y], angle: A, shape: [[x, y], ...]}`"),
    Key("parent", "name", False, "the body on whose axes all of it is given; a `body` then takes `shape` alone"),
    Key("trace", "flag", False, "`true`: the point leaves its path behind"),
    Key("name", "text", False, "a label beside it"),
)

CIRCLE_KEYS = (
    Key("centre", "place", True, "`[X, Y]` or `[X, Y, Z]`"),
    Key("radius", "expression", True, "its radius"),
    Key("normal", "vector", False, "its axis in space, of any length; `[0, 0, 1]` if left out"),
)

DRAWN_BODY_KEYS = (
    Key("at", "spot", True, "`[X, Y]`, where the origin of the body's axes is; not beside `parent`"),
    Key(
        "angle",
        "expression",
        True,
        "from the x axis to the body's first axis, counterclockwise, in radians; not beside `parent`",
    ),
    Key("shape", "polygon", True, "three corners or more on the body's axes"),
)


def forms_at(path: tuple[str, ...]) -> Forms:
    """The forms of which a mapping has one, as the keys of each; ``path`` are the keys that lead to it."""
    for pattern, forms in _FORMS:
        if len(pattern) == len(path) and all(p in ("*", key) for p, key in zip(pattern, path, strict=True)):
            return forms
    return ()
