"""Shapes of ``draw`` that are given on a body's axes, put into space."""

from __future__ import annotations

from nhc.diagnostics import Span
from nhc.language.bodies import pieces
from nhc.language.bodies.declarations import BodyReader
from nhc.language.bodies.kinematics import Frame
from nhc.language.bodies.pieces import Piece, Triple, each, write
from nhc.language.drawing import has_corners
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text


def put_into_space(table: Table, frame: Frame, reader: BodyReader) -> Table:
    """A shape without its ``parent``; what has no such shape is left for the decoder to report."""
    entries: list[tuple[Text, Node]] = []
    for key, node in table.entries:
        match key.value, node:
            case "parent", _:
                continue
            case "point", Items():
                entries.append((key, _points((node,), frame, reader)[0]))
            case "line", Items():
                entries.append((key, Items(_points(node.items, frame, reader), node.span)))
            case "circle", Table():
                entries.append((key, _circle(node, frame, reader)))
            case "body", Table():
                entries.append(_body(key, node, frame, reader))
            case _:
                entries.append((key, node))
    return Table(tuple(entries), table.span)


def _circle(table: Table, frame: Frame, reader: BodyReader) -> Table:
    """Its centre and normal; without one the circle lies across the body's third axis."""
    entries: list[tuple[Text, Node]] = []
    for key, node in table.entries:
        if key.value == "centre":
            entries.append((key, _points((node,), frame, reader)[0]))
        elif key.value != "normal":
            entries.append((key, node))
    normal = table.get("normal")
    across = reader.vector(normal, frame.place, "the normal") if normal is not None else None
    if normal is None and frame.heading is None:
        across = each(lambda k: write("1" if k == 2 else "0", frame.place))
    if across is not None:
        place = normal.span if normal is not None else table.span
        turned = each(lambda x: pieces.dot(across, each(lambda k: frame.axes[k][x]), frame.place))
        entries.append((Text("normal", place, True), _listed(turned, 3, place)))
    return Table(tuple(entries), table.span)


def _body(key: Text, table: Table, frame: Frame, reader: BodyReader) -> tuple[Text, Node]:
    """A polygon in the plane where the body stays in it and its corners lie there; in space the outline, as a line."""
    shape = table.get("shape")
    for text, _ in table.entries:
        if text.value in ("at", "angle"):
            help = "leave it out: with `parent` the shape is given on the axes of that body"
            reader.bag.error("E0303", f"`{text.value}` beside `parent`", text.span, help=(help,))
    if not isinstance(shape, Items) or not shape.items:
        return key, table
    if not has_corners(reader.bag, shape):
        return key, table
    read = [(reader.vector(node, frame.place, "a place"), node.span) for node in shape.items]
    corners = [(vector, span) for vector, span in read if vector is not None]
    if len(corners) < len(read):
        return key, table
    flat = frame.origin[2].is_zero and all(vector[2].is_zero for vector, _ in corners)
    if frame.heading is not None and flat:
        polygon = Items(tuple(_listed(vector, 2, span) for vector, span in corners), shape.span)
        entries: list[tuple[Text, Node]] = [
            (Text("at", key.span, True), _listed(frame.origin, 2, key.span)),
            (Text("angle", key.span, True), frame.heading.as_text(key.span)),
            *((text, polygon if text.value == "shape" else node) for text, node in table.entries),
        ]
        return key, Table(tuple(entries), table.span)
    outline = _points((*shape.items, shape.items[0]), frame, reader)
    return Text("line", key.span, True), Items(outline, shape.span)


def _points(nodes: tuple[Node, ...], frame: Frame, reader: BodyReader) -> tuple[Node, ...]:
    """Points in space, or in the plane where all of them lie in it."""
    read = [reader.vector(node, frame.place, "a place") for node in nodes]
    known = [_spot(vector, frame) for vector in read if vector is not None]
    if len(known) < len(nodes):
        return nodes
    count = 2 if all(spot[2].is_zero for spot in known) else 3
    return tuple(_listed(spot, count, node.span) for spot, node in zip(known, nodes, strict=True))


def _spot(vector: Triple, frame: Frame) -> Triple:
    out = each(lambda x: pieces.dot(vector, each(lambda k: frame.axes[k][x]), frame.place))
    return pieces.plus(frame.origin, out, frame.place)


def _listed(parts: tuple[Piece, ...], count: int, span: Span) -> Items:
    return Items(tuple(part.as_text(span) for part in parts[:count]), span)
