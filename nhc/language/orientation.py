"""The start of a rotation: a quaternion, an axis with its angle, or three turns, as four expressions.

Turns follow one another about the axes of the body itself: ``order: zxz`` turns about its third axis, then about its first
axis where that is now, then again about the third.  The product of the turns' quaternions is that of the orientation.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from fractions import Fraction
from sys import float_info

from nhc.diagnostics import Span
from nhc.language.expressions.constant import ConstantError, evaluate
from nhc.language.expressions.names import PI
from nhc.language.expressions.syntax import Binary, Call, Name, Negate, Number, Syntax, walk
from nhc.language.keys import START_FORMS, START_KEYS
from nhc.language.shape import Shapes
from nhc.language.spec import Initial, Rotation, Scene
from nhc.language.yaml_tree.nodes import Items, Node, Table

Quaternion = tuple[Syntax, ...]
Read = Callable[[Node], Syntax | None]
_ROUNDING = 4 * float_info.epsilon
_WAYS = "write `[1, 0, 0, 0]`, `{axis: [0, 0, 1], angle: pi/2}` or `{order: zxz, angles: [0, pi/2, 0]}`"


def read_orientation(what: str, node: Node, shapes: Shapes, read: Read) -> Quaternion | None:
    """Four expressions for the quaternion, of length 1; ``read`` makes an expression of a start value."""
    if isinstance(node, Items):
        parts = _expressions(node, 4, f"a quaternion for {what}", shapes, read)
        return _normalise(parts, node.span, f"the quaternion of {what}", shapes) if parts is not None else None
    if not isinstance(node, Table):
        shapes.items(node, f"an orientation for {what}", _WAYS)
        return None
    meant = shapes.check_keys(node, START_KEYS, f"the start of {what}", node.span)
    if meant:
        return None
    given = {text.value for text, _ in node.entries}
    group = next((group for group in START_FORMS if given & set(group)), None)
    if group is None:
        if not node.entries:
            shapes.bag.error("E0317", f"the start of {what} is empty", node.span, help=(_WAYS,))
        return None
    wrong = next((text for text, _ in node.entries if text.value not in group and text.value in _known()), None)
    missing = [key for key in group if key not in given]
    if wrong is not None or (missing and group[0] != "yaw"):
        together = " and ".join(f"`{key}`" for key in group)
        message = f"the start of {what} mixes `{wrong.value}` with {together}" if wrong else _lacking(what, missing)
        shapes.bag.error("E0317", message, wrong.span if wrong else node.span, help=(_WAYS,))
        return None
    if group[0] == "axis":
        return _about_axis(what, node, shapes, read)
    if group[0] == "order":
        return _in_turns(what, node, shapes, read)
    angles = [read(value) if (value := node.get(key)) is not None else _number(0, node.span) for key in group]
    return _turn("zyx", angles, node.span)


def _known() -> set[str]:
    return {key for group in START_FORMS for key in group}


def _lacking(what: str, missing: Sequence[str]) -> str:
    return f"the start of {what} lacks {' and '.join(f'`{key}`' for key in missing)}"


def _expressions(node: Node, count: int, what: str, shapes: Shapes, read: Read) -> list[Syntax] | None:
    items = shapes.items(node, f"a list of {count} numbers as {what}", _WAYS)
    if items is None:
        return None
    if len(items.items) != count:
        message = f"expected {count} numbers as {what}, found {len(items.items)}"
        shapes.bag.error("E0317", message, items.span, help=(_WAYS,))
        return None
    found = [read(item) for item in items.items]
    known = [tree for tree in found if tree is not None]
    return known if len(known) == count else None


def _normalise(parts: Sequence[Syntax], span: Span, what: str, shapes: Shapes) -> Quaternion | None:
    """The parts over their length; what is zero as a constant is refused here."""
    numbers = [_constant(part) for part in parts]
    known = [number for number in numbers if number is not None]
    if len(known) == len(parts):
        if not any(known):
            shapes.bag.error("E0317", f"{what} is zero, which is no direction", span, help=(_WAYS,))
            return None
        if sum(number * number for number in known) == 1:
            return tuple(parts)
    return scaled(parts, span)


def with_unit_quaternions(rotations: Iterable[Rotation], scene: Scene, given: AbstractSet[str]) -> Scene:
    """The scene with the quaternions of which some part was ``given`` scaled to length 1: any other length says the same.

    Parts that nobody gives are those of (1, 0, 0, 0).  What has this length stays as it is written.
    """
    for rotation in rotations:
        names = rotation.coordinates
        own = {entry.name: entry for entry in scene.initial if entry.kind == "coordinate" and entry.name in names}
        if given.isdisjoint(names) or any(entry.near for entry in own.values()):
            continue
        unit = [_number(k == 0, scene.span) for k in range(4)]
        parts = [own[name].value if name in own else part for name, part in zip(names, unit, strict=True)]
        squares = [float(number * number) for part in parts if (number := _constant(part)) is not None]
        if len(squares) < len(parts) or abs(sum(squares) - 1) > _ROUNDING:
            parts = list(scaled(parts, scene.span))
        places = [own[name].span if name in own else scene.span for name in names]
        whole = [Initial("coordinate", *entry) for entry in zip(names, parts, places, strict=True)]
        others = [entry for entry in scene.initial if entry not in own.values()]
        scene = replace(scene, initial=(*others, *whole))
    return scene


def scaled(parts: Sequence[Syntax], span: Span) -> Quaternion:
    """The parts over their length."""
    squares = [_binary("^", part, _number(2, span), span) for part in parts]
    total = squares[0]
    for square in squares[1:]:
        total = _binary("+", total, square, span)
    length = Call("sqrt", (total,), span)
    return tuple(_binary("/", part, length, span) for part in parts)


def _constant(tree: Syntax) -> Fraction | float | None:
    if any(isinstance(node, Name) and node.name != PI for node in walk(tree)):
        return None
    try:
        return evaluate(tree)
    except ConstantError:
        return None


def _about_axis(what: str, node: Table, shapes: Shapes, read: Read) -> Quaternion | None:
    axis_node, angle_node = node.get("axis"), node.get("angle")
    if axis_node is None or angle_node is None:
        return None
    axis = _expressions(axis_node, 3, f"the axis of {what}", shapes, read)
    angle = read(angle_node)
    unit = _normalise(axis, axis_node.span, f"the axis of {what}", shapes) if axis is not None else None
    if unit is None or angle is None:
        return None
    cosine, sine = _half(angle, node.span)
    return (cosine, *(_binary("*", sine, part, node.span) for part in unit))


def _in_turns(what: str, node: Table, shapes: Shapes, read: Read) -> Quaternion | None:
    order_node, angles_node = node.get("order"), node.get("angles")
    if order_node is None or angles_node is None:
        return None
    order = shapes.text(order_node, "an order of axes such as `zxz`")
    angles = _expressions(angles_node, 3, f"the angles of {what}", shapes, read)
    if order is None or angles is None:
        return None
    good = len(order.value) == 3 and set(order.value) <= set("xyz")
    if not good or order.value[0] == order.value[1] or order.value[1] == order.value[2]:
        message = f"`{order.value[:20]}` is no order of axes"
        help = (
            "write three of x, y, z, no two neighbours the same: `zxz` for Euler's angles, `zyx` for yaw, pitch, roll"
        )
        shapes.bag.error("E0317", message, order.span, help=(help,))
        return None
    return _turn(order.value, angles, node.span)


def _turn(order: str, angles: Sequence[Syntax | None], span: Span) -> Quaternion | None:
    """The product of three turns about single axes."""
    made: list[Syntax | None] = []
    for axis, angle in zip(order, angles, strict=True):
        if angle is None:
            return None
        if _constant(angle) == 0:
            continue
        cosine, sine = _half(angle, span)
        turn: list[Syntax | None] = [cosine, None, None, None]
        turn["xyz".index(axis) + 1] = sine
        made = _multiply(made, turn, span) if made else turn
    if not made:
        made = [_number(1, span), None, None, None]
    return tuple(_number(0, span) if part is None else part for part in made)


def _multiply(p: Sequence[Syntax | None], q: Sequence[Syntax | None], span: Span) -> list[Syntax | None]:
    """The product of quaternions; None is zero."""
    # (i, j, k, negative): p_i q_j counts for the part k
    table = [(0, k, k, False) for k in range(4)] + [(k, 0, k, False) for k in range(1, 4)]
    table += [(k, k, 0, True) for k in range(1, 4)]
    for k in range(3):
        i, j = (k + 1) % 3 + 1, (k + 2) % 3 + 1
        table += [(i, j, k + 1, False), (j, i, k + 1, True)]
    result: list[Syntax | None] = [None] * 4
    for i, j, k, negative in table:
        a, b, sum_so_far = p[i], q[j], result[k]
        if a is None or b is None:
            continue
        product = _binary("*", a, b, span)
        if sum_so_far is None:
            result[k] = Negate(product, span) if negative else product
        else:
            result[k] = _binary("-" if negative else "+", sum_so_far, product, span)
    return result


def _half(angle: Syntax, span: Span) -> tuple[Syntax, Syntax]:
    half = _binary("/", angle, _number(2, span), angle.span)
    return Call("cos", (half,), span), Call("sin", (half,), span)


def angles_in(part: Syntax) -> list[Syntax]:
    """The half angles in a part of a quaternion that :func:`read_orientation` has made, by place and by order of turns.

    The calls that it makes stand at the place of the whole start, unlike any that a user writes.
    """
    calls = [node for node in walk(part) if isinstance(node, Call) and node.span == part.span]
    return [node.arguments[0] for node in calls if node.function in ("cos", "sin")]


def _binary(op: str, left: Syntax, right: Syntax, span: Span) -> Syntax:
    return Binary(op, left, right, span, span)


def _number(value: int, span: Span) -> Syntax:
    return Number(Fraction(value), span)
