"""``draw``: the shapes of which a run's page makes its moving picture."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

from nhc.diagnostics import Bag, quote
from nhc.language.expressions.syntax import Negate, Number, Syntax
from nhc.language.keys import CIRCLE_KEYS, DRAW_KEYS, DRAWN_BODY_KEYS
from nhc.language.shape import Shapes
from nhc.language.spec import FIGURES, Figure, Place
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.reader import is_empty

Read = Callable[[Node], Syntax | None]
_IN_PLANE, _ANYWHERE, _IN_SPACE = (2,), (2, 3), (3,)
_FORMS = {_IN_PLANE: "`[X, Y]`", _ANYWHERE: "`[X, Y]` or `[X, Y, Z]`", _IN_SPACE: "`[X, Y, Z]`"}
LEAST_CORNERS = 3  # of a body's shape
_POINTS = "write `[[x1, y1], [x2, y2], ...]`"
_COUNTS = {_IN_PLANE: "two", _ANYWHERE: "two or three", _IN_SPACE: "three"}


def decode_drawing(node: Node | None, shapes: Shapes, read: Read) -> tuple[Figure, ...]:
    """Return the shapes; ``read`` takes a node to an expression whose names are known, and reports what is wrong."""
    if node is None:
        return ()
    items = shapes.items(node, "a list of shapes", "write `- point: [x, y]`, one line for each shape")
    decoder = _Drawing(shapes, read)
    found = [decoder.figure(item) for item in items.items] if items is not None else []
    return tuple(figure for figure in found if figure is not None)


def has_corners(bag: Bag, items: Items, what: str = "the shape of a body", least: int = LEAST_CORNERS) -> bool:
    """Whether a list has so many points; reports where it has not."""
    if len(items.items) >= least:
        return True
    bag.error("E0301", f"{what} needs {least} points or more, found {len(items.items)}", items.span, help=(_POINTS,))
    return False


class _Drawing:
    def __init__(self, shapes: Shapes, read: Read) -> None:
        self.shapes, self.bag, self.read = shapes, shapes.bag, read

    def figure(self, item: Node) -> Figure | None:
        table = self.shapes.table(item, "a mapping for a shape", "write `- point: [x, y]`")
        if table is None:
            return None
        place = table.entries[0][0].span if table.entries else item.span
        meant = self.shapes.check_keys(table, DRAW_KEYS, "a shape of `draw`", place)
        kinds = [(text, value) for text, value in table.entries if text.value in FIGURES]
        self._refuse_parent(table)
        names = quote(FIGURES)
        if not kinds:
            if not any(name in FIGURES for name in meant):
                help = f"give one of {names}"
                self.bag.error("E0304", "this shape of `draw` does not say what it is", place, help=(help,))
            return None
        if len(kinds) > 1:
            message = f"a shape of `draw` is one of {names}, found {len(kinds)}"
            self.bag.error("E0301", message, kinds[1][0].span, help=("begin each shape with `- `",))
            return None
        text, value = kinds[0]
        name, trace = self.shapes.line(table.get("name")), self._trace(table, text.value)
        if is_empty(value):
            return None
        match text.value:
            case "point":
                points = self._points((value,), "a point", _ANYWHERE)
            case "line":
                points = self._list(value, "a line", 2, _ANYWHERE)
            case "circle":
                return self._circle(value, text, name)
            case _:
                return self._body(value, text, name)
        return Figure(text.value, name, text.span, points, trace) if points else None

    def _refuse_parent(self, table: Table) -> None:
        """What stands on a body that is known has been put into space before."""
        text = self.shapes.text(node, "the name of a body") if (node := table.get("parent")) is not None else None
        if text is not None:
            help = "declare it under `bodies`, or leave `parent` out"
            self.bag.error("E0302", f"unknown body `{text.value}`", text.span, help=(help,))

    def _trace(self, table: Table, kind: str) -> bool:
        key = next((text for text, _ in table.entries if text.value == "trace"), None)
        node = table.get("trace")
        text = self.shapes.text(node, "`true` or `false`") if node is not None else None
        if key is None or text is None:
            return False
        if text.value not in ("true", "false"):
            help = ("write `trace: true`, or leave it out",)
            self.bag.error("E0312", f"`trace` is `true` or `false`, not `{text.value}`", text.span, help=help)
            return False
        if kind != "point":
            help = ("add a `point` where the trace is wanted",)
            self.bag.error("E0303", f"`trace` belongs to a point, not to a {kind}", key.span, help=help)
        return text.value == "true"

    def _circle(self, node: Node, key: Text, name: str) -> Figure | None:
        table = self._table(node, "a circle", "circle: {centre: [x, y], radius: R}")
        if table is None:
            return None
        self.shapes.check_keys(table, CIRCLE_KEYS, "a circle", key.span)
        centre, radius, normal = table.get("centre"), table.get("radius"), table.get("normal")
        points = self._points((centre,), "the centre", _ANYWHERE) if centre is not None else ()
        axis = self._point(normal, "the normal", _IN_SPACE) if normal is not None else ()
        size = self.read(radius) if radius is not None else None
        if not points or size is None or axis is None:
            return None
        length = _written(size)
        if length is not None and length < 0:
            self.bag.error("E0313", "the radius of a circle is negative", size.span, help=("write its length",))
        if axis and all(_written(tree) == 0 for tree in axis):
            at = normal.span if normal is not None else key.span
            self.bag.error(
                "E0313",
                "a normal of zeros has no direction",
                at,
                help=("write `[0, 0, 1]` for a circle that lies flat",),
            )
        return Figure("circle", name, key.span, points, radius=size, normal=axis)

    def _body(self, node: Node, key: Text, name: str) -> Figure | None:
        table = self._table(node, "a body", "body: {at: [x, y], angle: theta, shape: [[0, 0], [1, 0], [0, 1]]}")
        if table is None:
            return None
        self.shapes.check_keys(table, DRAWN_BODY_KEYS, "a body", key.span)
        at, angle, shape = table.get("at"), table.get("angle"), table.get("shape")
        origin = self._point(at, "the place of a body", _IN_PLANE) if at is not None else None
        turn = self.read(angle) if angle is not None else None
        points = self._list(shape, "the shape of a body", LEAST_CORNERS, _IN_PLANE) if shape is not None else ()
        if origin is None or turn is None or not points:
            return None
        return Figure("body", name, key.span, points, at=origin, angle=turn)

    def _table(self, node: Node, what: str, example: str) -> Table | None:
        return self.shapes.table(node, f"a mapping for {what}", f"write `{example}`")

    def _list(self, node: Node, what: str, least: int, lengths: tuple[int, ...]) -> tuple[Place, ...]:
        """At least so many points, all with equally many expressions; empty where something is wrong."""
        items = self.shapes.items(node, f"a list of points for {what}", _POINTS)
        if items is None:
            return ()
        if not has_corners(self.bag, items, what, least):
            return ()
        points = self._points(items.items, f"a point of {what}", lengths)
        for place, item in zip(points, items.items, strict=False):
            if len(place) != len(points[0]):
                message = f"{what} mixes points of {len(points[0])} and of {len(place)} expressions"
                self.bag.error("E0301", message, item.span, help=("give all of its points two, or all three",))
                return ()
        return points

    def _points(self, nodes: tuple[Node, ...], what: str, lengths: tuple[int, ...]) -> tuple[Place, ...]:
        found = [self._point(node, what, lengths) for node in nodes]
        places = tuple(place for place in found if place is not None)
        return places if len(places) == len(found) else ()

    def _point(self, node: Node, what: str, lengths: tuple[int, ...]) -> Place | None:
        wanted = f"a list of {_COUNTS[lengths]} expressions for {what}"
        help = f"write {_FORMS[lengths]}"
        items = self.shapes.items(node, wanted, help)
        if items is None:
            return None
        if len(items.items) not in lengths:
            message = f"expected {wanted}, found {len(items.items)}"
            self.bag.error("E0301", message, items.span, help=(help,))
            return None
        trees = tuple(self.read(item) for item in items.items)
        known = tuple(tree for tree in trees if tree is not None)
        return known if len(known) == len(trees) else None


def _written(tree: Syntax) -> Fraction | None:
    """The value of a number that is written out."""
    match tree:
        case Number():
            return tree.value
        case Negate(operand=Number(value=value)):
            return -value
    return None
