"""The sections that declare coordinates and parameters."""

from __future__ import annotations

from collections.abc import Collection
from fractions import Fraction

from nhc.language.expressions.names import is_name
from nhc.language.expressions.syntax import Syntax
from nhc.language.keys import COORDINATE_KEYS, PARAMETER_KEYS
from nhc.language.scope import Scope
from nhc.language.shape import Shapes, is_unit, undashed
from nhc.language.spec import Coordinate, Parameter
from nhc.language.units.dimensions import UnitError, parse_unit
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.reader import is_empty


def _read_unit(table: Table, shapes: Shapes) -> str:
    node = table.get("unit")
    text = shapes.text(node, "a unit") if node is not None else None
    if text is None:
        return ""
    try:
        parse_unit(text.value)
    except UnitError as error:
        shapes.bag.error("E0316", error.message, text.locate(error.start, error.end), help=(error.help,))
    return " ".join(text.value.split())


def _of_parameter(key: str, present: Collection[str]) -> tuple[str, str]:
    """What a key of a parameter does at a coordinate."""
    return (
        ("", "a coordinate has none: parameters belong under `parameters:`, starts in scenes")
        if key == "value"
        else ("", "")
    )


def _entries(node: Node | None, key: str, shapes: Shapes, scope: Scope) -> list[tuple[Text, Node | None]]:
    """Return the names of a section with their values; the names of a list have none."""
    if node is None:
        return []
    if isinstance(node, Items):
        helps = [undashed(item, shapes.is_flow(node)) if isinstance(item, Table) else "" for item in node.items]
        texts = [shapes.text(item, "a name", help) for item, help in zip(node.items, helps, strict=True)]
        scope.open = scope.open or None in texts
        return [(text, None) for text in texts if text is not None]
    single = node.value if isinstance(node, Text) and is_name(node.value) else "x, y"
    help = f"write `[{single}]`, or one name per line with what is known of it"
    if key == "parameters" and isinstance(node, Text):
        help = "write one name per line with its value: `m: 1`"
    table = shapes.table(node, f"a list or mapping of {key}", help)
    if table is None:
        scope.open = True
        return []
    # the end of a text with a comma in it has been reported as an empty value
    whole = [(text, value) for text, value in table.entries if is_name(text.value) or not is_empty(value)]
    scope.open = scope.open or len(whole) < len(table.entries)
    return list(whole)


def decode_coordinates(node: Node | None, shapes: Shapes, scope: Scope) -> list[Coordinate]:
    """Declare the coordinates; at least one is needed."""
    entries = _entries(node, "coordinates", shapes, scope)
    if isinstance(node, Items | Table) and not entries and not scope.open:
        shapes.bag.error("E0301", "at least one coordinate is needed", node.span, help=("write `coordinates: [x]`",))
        scope.open = True
    if node is None:
        scope.open = True
    found = []
    for text, value in entries:
        name = scope.declare(text, "coordinate")
        coordinate = _decode_coordinate(name or "", text, value, shapes)
        if name is not None:
            found.append(coordinate)
    return found


def _decode_coordinate(name: str, text: Text, value: Node | None, shapes: Shapes) -> Coordinate:
    what = f"coordinate `{text.value}`"
    help = f"write `{text.value}: {{unit: m, about: ...}}`, or list the names: `coordinates: [{text.value}, ...]`"
    if isinstance(value, Text) and is_unit(value.value):
        help = f"write `{text.value}: {{unit: {value.value}}}`"
    table = shapes.table(value, f"a mapping for {what}", help) if value is not None else None
    if table is None:
        return Coordinate(name, text.span)
    shapes.check_keys(table, COORDINATE_KEYS, what, text.span, _of_parameter)
    node = table.get("range")
    range_ = shapes.interval(node, f"the range of `{text.value}`") if node is not None else None
    return Coordinate(name, text.span, _read_unit(table, shapes), shapes.line(table.get("about")), range_)


def decode_parameters(node: Node | None, shapes: Shapes, scope: Scope) -> list[Parameter]:
    """Declare the parameters."""
    found = []
    for text, value in _entries(node, "parameters", shapes, scope):
        name = scope.declare(text, "parameter")
        parameter = _decode_parameter(name or "", text, value, shapes)
        if name is not None:
            found.append(parameter)
    return found


def _value(node: Node, what: str, shapes: Shapes) -> Fraction | Syntax:
    """Return the value; 0 stands for one that has been refused, so that nothing else is said of it."""
    value = shapes.constant(node, what, declares=True)
    return Fraction(0) if value is None else value


def _decode_parameter(name: str, text: Text, value: Node | None, shapes: Shapes) -> Parameter:
    what = f"parameter `{text.value}`"
    if value is None:
        return Parameter(name, text.span)
    if not isinstance(value, Table):
        return Parameter(name, text.span, _value(value, what, shapes))
    meant = shapes.check_keys(value, PARAMETER_KEYS, what, text.span)
    refused = "value" in meant or any(is_empty(part) for _, part in value.entries)
    node = value.get("value")
    number = _value(node, what, shapes) if node is not None else Fraction(0) if refused else None
    return Parameter(name, text.span, number, _read_unit(value, shapes), shapes.line(value.get("about")))
