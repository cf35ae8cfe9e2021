"""A scene that was changed, in the table of its spec: what is left of the spec is written with the values that were measured."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from nhc.diagnostics import Span
from nhc.language.expressions.names import fold
from nhc.language.expressions.syntax import Number, Syntax
from nhc.language.expressions.unparse import unparse
from nhc.language.spec import Initial, Scene
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text

_NOWHERE = Span(0, 0)


def with_scene(root: Table, scene: Scene) -> Table:
    """The table of a spec whose scene of that name has the start, the parameters' values, the time and the needs of ``scene``."""
    found = list[tuple[Text, Node]]()
    for key, node in root.entries:
        if key.value == "scenes" and isinstance(node, Table):
            entries = [
                (name, _change(own, scene) if fold(name.value) == scene.name else own) for name, own in node.entries
            ]
            node = replace(node, entries=tuple(entries))
        found.append((key, node))
    return replace(root, entries=tuple(found))


def _change(own: Node, scene: Scene) -> Node:
    """The scene's own table, with its keys in their order and new ones behind them."""
    assert isinstance(own, Table)
    new: dict[str, Node] = {"time": Items(tuple(_value(time) for time in scene.time), _NOWHERE)}
    if scene.initial:
        new["initial"] = _table((_key(entry), _start(entry)) for entry in scene.initial)
    if any(need.span == scene.span for need in scene.need):  # asked for in place of the spec's
        new["need"] = Items(tuple(_plain(need.name) for need in scene.need), _NOWHERE)
    if scene.parameters:
        new["parameters"] = _table((entry.name, _value(entry.value)) for entry in scene.parameters)
    kept = [(key, new.pop(key.value, node)) for key, node in own.entries]
    return replace(own, entries=(*kept, *((_plain(key), node) for key, node in new.items())))


def _key(entry: Initial) -> str:
    return f"{entry.name}'" if entry.kind == "velocity" else entry.name


def _start(entry: Initial) -> Node:
    return _table([("near", _value(entry.value))]) if entry.near else _value(entry.value)


def _value(value: Fraction | Syntax) -> Text:
    return _plain(unparse(Number(value, _NOWHERE) if isinstance(value, Fraction) else value))


def _table(pairs: Iterable[tuple[str, Node]]) -> Table:
    return Table(tuple((_plain(name), node) for name, node in pairs), _NOWHERE)


def _plain(value: str) -> Text:
    return Text(value, _NOWHERE, True)
