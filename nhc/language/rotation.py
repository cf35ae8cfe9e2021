"""``rotation``: orientations of bodies by quaternions, and what they bring into a spec.

A rotation ``R`` takes components on the body's axes to components in space. It brings

- four coordinates, a quaternion e that is not zero; it stands for the orientation e/|e|, so its length means nothing;
- the holonomic constraint |e|^2 = 1, which the kinematics keep by themselves and whose reaction is zero;
- three quasi-velocities, the angular velocity on the body's axes or in space;
- the entries of the matrix, ``R_x3`` being the x component in space of the body's third axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from nhc.diagnostics import Bag, Source, Span, quote, suggest
from nhc.language.expressions.names import fold
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Number, Syntax
from nhc.language.keys import ROTATION_KEYS
from nhc.language.scope import Scope
from nhc.language.shape import Shapes
from nhc.language.spec import ROTATION_FRAMES, Coordinate, Definition, Holonomic, Rotation
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text

_SIGNS = {"body": 1, "space": -1}


def decode_rotations(node: Node | None, shapes: Shapes, scope: Scope) -> list[Rotation]:
    """Declare the rotations and all names that they bring."""
    if node is None:
        return []
    if isinstance(node, Items):
        texts = [shapes.text(item, "a name") for item in node.items]
        scope.open = scope.open or None in texts
        entries: list[tuple[Text, Node | None]] = [(text, None) for text in texts if text is not None]
    else:
        help = "write `R: {velocities: [w1, w2, w3]}`, or a list of names"
        table = shapes.table(node, "a mapping of rotations by name", help)
        scope.open = scope.open or table is None
        entries = list(table.entries) if table is not None else []
    if isinstance(node, Items | Table) and not entries and not scope.open:
        shapes.bag.error("E0301", "at least one rotation is needed", node.span, help=("write `rotation: [R]`",))
        scope.open = True
    found = [decode_rotation(text, value, shapes, scope) for text, value in entries]
    return [rotation for rotation in found if rotation is not None]


def decode_rotation(text: Text, value: Node | None, shapes: Shapes, scope: Scope) -> Rotation | None:
    """Declare one rotation; ``value`` None: with the default names, on the body's axes."""
    what = f"rotation `{text.value}`"
    help = f"write `{text.value}: {{velocities: [w1, w2, w3]}}`"
    table = shapes.table(value, f"a mapping for {what}", help) if value is not None else None
    if table is not None:
        shapes.check_keys(table, ROTATION_KEYS, what, text.span)
    elif value is not None:
        scope.open = True
    name = scope.declare(text, "rotation")
    if name is None:
        scope.open = True
        return None
    frame = _frame(table.get("frame") if table is not None else None, shapes)
    coordinates = _names(table, "quaternion", [f"{name}_{k}" for k in range(4)], "coordinate", text, shapes, scope)
    velocities = _names(table, "velocities", velocity_names(name, frame), "quasi", text, shapes, scope)
    made = entry_names(name)
    taken = [scope.declare(Text(entry, text.span, False), "entry") for entry in made]
    if coordinates is None or velocities is None or None in taken:
        scope.open = True
        return None
    about = shapes.line(table.get("about")) if table is not None else ""
    return Rotation(name, text.span, frame, tuple(coordinates), tuple(velocities), tuple(made), about)


def velocity_names(name: str, frame: str) -> list[str]:
    """The components of the angular velocity where the spec does not name them."""
    return [f"{name}_w{k}" for k in ("123" if frame == "body" else "xyz")]


def entry_names(name: str) -> list[str]:
    """The entries of the matrix, row by row."""
    return [f"{name}_{row}{column}" for row in "xyz" for column in "123"]


def foretell_rotations(node: Node | None) -> dict[str, tuple[list[str], bool]]:
    """The names of each rotation's angular velocity, and whether it is on the body's axes, before anything is declared.

    Mistakes are passed over: they are reported where rotations are decoded.
    """
    entries: list[tuple[Text, Node | None]] = []
    if isinstance(node, Table):
        entries = list(node.entries)
    elif isinstance(node, Items):
        entries = [(item, None) for item in node.items if isinstance(item, Text)]
    found: dict[str, tuple[list[str], bool]] = {}
    for text, value in entries:
        name, table = fold(text.value), value if isinstance(value, Table) else None
        frame, given = (table.get("frame"), table.get("velocities")) if table is not None else (None, None)
        on_body = not (isinstance(frame, Text) and frame.value == "space")
        names = [fold(item.value) for item in given.items if isinstance(item, Text)] if isinstance(given, Items) else []
        found[name] = names if len(names) == 3 else velocity_names(name, "body" if on_body else "space"), on_body
    return found


def _frame(node: Node | None, shapes: Shapes) -> str:
    text = shapes.text(node, "`body` or `space`") if node is not None else None
    if text is None or text.value in ROTATION_FRAMES:
        return text.value if text is not None else ROTATION_FRAMES[0]
    help = suggest(text.value, ROTATION_FRAMES, "write `body` for the body's axes, or `space`")
    shapes.bag.error("E0312", f"unknown frame `{text.value}` of angular velocity", text.span, help=(help,))
    return ROTATION_FRAMES[0]


def _names(
    table: Table | None, key: str, default: Sequence[str], kind: str, owner: Text, shapes: Shapes, scope: Scope
) -> list[str] | None:
    """Declare the names of a key, or the default ones; None where they cannot be had."""
    node = table.get(key) if table is not None else None
    if node is None:
        declared = [scope.declare(Text(name, owner.span, False), kind) for name in default]
        return None if None in declared else [name for name in declared if name is not None]
    example = "[w1, w2, w3]" if len(default) == 3 else "[e0, e1, e2, e3]"
    items = shapes.items(node, f"a list of {len(default)} names for `{key}`", f"write `{key}: {example}`")
    if items is None:
        return None
    if len(items.items) != len(default):
        message = f"`{key}` of a rotation takes {len(default)} names, found {len(items.items)}"
        shapes.bag.error("E0317", message, items.span, help=(f"write `{key}: {example}`",))
        return None
    texts = [shapes.text(item, "a name") for item in items.items]
    declared = [scope.declare(text, kind) if text is not None else None for text in texts]
    return None if None in declared else [name for name in declared if name is not None]


def pushes_quaternion(text: Text, rotations: Sequence[Rotation], bag: Bag) -> bool:
    """Report a force on a part of a quaternion: only torques do work."""
    rotation = next((r for r in rotations if fold(text.value) in r.coordinates), None)
    if rotation is None:
        return False
    names = quote(rotation.velocities)
    help = f"write the torque by the components {names} of the angular velocity"
    bag.error("E0317", f"a force on `{text.value}`, a part of a quaternion", text.span, help=(help,))
    return True


# --- what a rotation brings into the spec ---------------------------------------------------------------


def coordinates_of(rotation: Rotation) -> tuple[Coordinate, ...]:
    """The quaternion as coordinates; without a start it is the orientation in which both sets of axes agree."""
    about = f"quaternion of {rotation.name}"
    return tuple(
        Coordinate(name, rotation.span, "1", f"{about}, {part}", None, Fraction(k == 0))
        for k, (name, part) in enumerate(
            zip(rotation.coordinates, ("scalar part", "along x", "along y", "along z"), strict=True)
        )
    )


def norm_of(rotation: Rotation) -> Holonomic:
    """|e|^2 = 1, named ``R_norm``."""
    left = _parse(_square(rotation), rotation.span)
    return Holonomic(f"{rotation.name}_norm", left, Number(Fraction(1), rotation.span), rotation.span)


def velocities_of(rotation: Rotation) -> tuple[Definition, ...]:
    """The angular velocity as forms: 2 Im(conj(e) e')/|e|^2 on the body's axes, 2 Im(e' conj(e))/|e|^2 in space."""
    e, sign = rotation.coordinates, _SIGNS[rotation.frame]
    found = []
    for k, name in enumerate(rotation.velocities):
        i, j = (k + 1) % 3, (k + 2) % 3
        own = f"{e[0]}*{e[k + 1]}' - {e[k + 1]}*{e[0]}'"
        cross = f"{e[j + 1]}*{e[i + 1]}' - {e[i + 1]}*{e[j + 1]}'"
        text = f"2*({own} {'+' if sign > 0 else '-'} ({cross}))/({_square(rotation)})"
        found.append(Definition(name, _parse(text, rotation.span), rotation.span))
    return tuple(found)


def entries_of(rotation: Rotation) -> tuple[Definition, ...]:
    """The entries of the matrix, row by row, without dimension and homogeneous of degree 0 in the quaternion."""
    e, square, found = rotation.coordinates, _square(rotation), []
    for row in range(3):
        for column in range(3):
            if row == column:
                i, j = (row + 1) % 3, (row + 2) % 3
                text = f"1 - 2*({e[i + 1]}^2 + {e[j + 1]}^2)/({square})"
            else:
                other = 3 - row - column
                sign = "-" if (column - row) % 3 == 1 else "+"
                text = f"2*({e[row + 1]}*{e[column + 1]} {sign} {e[0]}*{e[other + 1]})/({square})"
            name = rotation.entries[3 * row + column]
            found.append(Definition(name, _parse(text, rotation.span), rotation.span))
    return tuple(found)


def _square(rotation: Rotation) -> str:
    return " + ".join(f"{name}^2" for name in rotation.coordinates)


def _parse(text: str, span: Span) -> Syntax:
    tree = parse_expression(text, lambda start, end: span, Bag(Source("", text)))
    assert tree is not None
    return tree
