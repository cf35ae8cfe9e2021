"""The equations under ``constraints`` and ``holonomic``: their names and sides, parsed; what the names in them mean comes later."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.diagnostics import Bag, Span
from nhc.language.expressions.names import fold
from nhc.language.expressions.parser import parse_equation
from nhc.language.expressions.syntax import Syntax
from nhc.language.scope import check_name
from nhc.language.shape import Shapes
from nhc.language.spec import Rotation
from nhc.language.yaml_tree.nodes import Node, Table

Equation = tuple[str, Span, Syntax, Syntax]
"""Name, place, left side, right side."""


class Equations:
    """``taken`` are the names of constraints met so far; ``uncounted``: mistakes leave open how many constraints are meant."""

    def __init__(self, root: Table, shapes: Shapes, bag: Bag, rotations: Sequence[Rotation]) -> None:
        self._root, self._shapes, self._bag = root, shapes, bag
        self.taken: dict[str, Span] = {f"{rotation.name}_norm": rotation.span for rotation in rotations}
        self.uncounted = False
        self.count = len(rotations)

    def read(self, key: str, prefix: str) -> list[Equation]:
        """Those of one key; an entry without a name is called by its number after the prefix."""
        found: list[Equation] = []
        for index, item in enumerate(self._items(key), start=1):
            self.count += 1
            named = self._named(item, key, f"{prefix}{index}")
            if named is None:
                continue
            name, span, value = named
            if name in self.taken:
                self.uncounted = True
                self._bag.error("E0305", f"two constraints are named `{name}`", span, help=("rename one of them",))
            self.taken.setdefault(name, span)
            text = self._shapes.text(value, "an equation")
            sides = parse_equation(text.value, text.locate, self._bag) if text else None
            if sides is not None:
                found.append((name, span, *sides))
        return found

    def _items(self, key: str) -> tuple[Node, ...]:
        node = self._root.get(key)
        help = "write `- name: left = right`"
        if isinstance(node, Table) and node.entries and node.entries[0][0].value.startswith("-"):
            help = f"put a blank after the `-`: `- {node.entries[0][0].value.lstrip('-')}: left = right`"
        items = self._shapes.items(node, "a list of equations", help) if node else None
        self.uncounted = self.uncounted or (node is not None and items is None)
        return items.items if items else ()

    def _named(self, item: Node, key: str, name: str) -> tuple[str, Span, Node] | None:
        """The name of an entry, its place, and what holds the equation; None after a mistake."""
        if not isinstance(item, Table):
            return name, item.span, item
        if len(item.entries) != 1:
            message = f"an entry of `{key}` holds one name with its equation, found {len(item.entries)}"
            place = item.entries[1][0].span if len(item.entries) > 1 else item.span
            self._bag.error("E0301", message, place, help=("begin each equation with `- `",))
            return None
        text, value = item.entries[0]
        return (fold(text.value), text.span, value) if check_name(text, self._bag) else None
