"""Nodes to values of a wanted shape; what has another shape is reported."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from fractions import Fraction

from nhc.diagnostics import Bag, Label, Span, nearest, quote
from nhc.language.expressions.constant import ConstantError, evaluate
from nhc.language.expressions.names import FUNCTIONS, PI, is_name
from nhc.language.expressions.numbers import DOUBLES, exact
from nhc.language.expressions.parser import parse_expression
from nhc.language.expressions.syntax import Binary, Name, Negate, Number, Syntax, walk
from nhc.language.keys import Key
from nhc.language.units.dimensions import UnitError, parse_unit
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text, describe
from nhc.language.yaml_tree.reader import is_empty

Elsewhere = Callable[[str, Collection[str]], tuple[str, str]]
_NOTHING: Mapping[str, Span] = {}
_PLAIN = r"[0-9]{1,9}(?:\.[0-9]{1,9})?"  # a number of few digits
_MEASURED = re.compile(r"([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)\s*([^\W\d_][^()]*)")


def _first(node: Node) -> Span:
    """The place to mark for a whole node: itself, or the first character of a list or mapping."""
    return node.span if isinstance(node, Text) else Span(node.span.start, node.span.start + 1)


def undashed(item: Node, flow: bool = False) -> str:
    """How to write an entry of a list where names are keys; ``flow``: the list stands in brackets."""
    if flow:
        return "write names with values in braces: `{m: 1, l: 2}`"
    name = item.get("name") if isinstance(item, Table) else None
    if isinstance(name, Text) and is_name(name.value):
        return f"write `{name.value}:` in place of `- name: {name.value}`, and the entry's other keys under it"
    return "leave out the `-` before each entry"


class Shapes:
    """Asks nodes for shapes; an empty value has been reported already and is passed over in silence."""

    def __init__(self, bag: Bag) -> None:
        self.bag = bag

    def _wrong(self, node: Node, wanted: str, help: str) -> None:
        if not is_empty(node):
            message = f"expected {wanted}, found {describe(node)}"
            self.bag.error("E0301", message, _first(node), help=(help or f"write {wanted} here",))

    def is_flow(self, node: Node) -> bool:
        """Whether a list is written in brackets."""
        return self.bag.source.text[node.span.start : node.span.start + 1] == "["

    def text(self, node: Node, wanted: str = "a text", help: str = "") -> Text | None:
        """Return a text that is not empty."""
        if isinstance(node, Text):
            return None if is_empty(node) else node
        self._wrong(node, wanted, help)
        return None

    def line(self, node: Node | None, wanted: str = "a text") -> str:
        """Return a text on one line, so that it can stand in a comment of any language; empty where there is none."""
        text = self.text(node, wanted) if node is not None else None
        return " ".join(text.value.split()) if text else ""

    def lines(self, node: Node | None) -> tuple[str, ...]:
        """Return the texts of a list, each on one line, or a single one."""
        if node is None:
            return ()
        if isinstance(node, Text):
            return tuple(line for line in (self.line(node),) if line)
        items = self.items(node, "a list of texts")
        lines = [self.line(item) for item in items.items] if items else []
        return tuple(line for line in lines if line)

    def table(self, node: Node, wanted: str = "a mapping", help: str = "") -> Table | None:
        """Return a mapping."""
        if isinstance(node, Table):
            return node
        if isinstance(node, Items) and node.items and all(isinstance(item, Table) for item in node.items):
            help = undashed(node.items[0], self.is_flow(node))  # a list of mappings: what it holds is right
        self._wrong(node, wanted, help)
        return None

    def items(self, node: Node, wanted: str = "a list", help: str = "") -> Items | None:
        """Return a list."""
        if isinstance(node, Items):
            return node
        self._wrong(node, wanted, help)
        return None

    def check_keys(
        self,
        table: Table,
        keys: Sequence[Key],
        what: str,
        place: Span,
        elsewhere: Elsewhere = lambda *_: ("", ""),
        left_out: Mapping[str, Span] = _NOTHING,
    ) -> tuple[str, ...]:
        """Report unknown and missing keys of a mapping; return the known keys that unknown ones may have meant.

        ``left_out``: where a spec leaves out what its base has; ``elsewhere`` knows what others call such keys (see
        :func:`nhc.language.advice.meant_key`).
        """
        known = [key.name for key in keys]
        present = {text.value for text, _ in table.entries}
        meant: list[str] = []
        for text, value in table.entries:
            if text.value in known or is_empty(value):  # an empty value has been reported
                continue
            near, help = elsewhere(text.value, present)
            if not help:
                near = nearest(text.value, known) or ""
                help = f"did you mean `{near}`?" if near else "known keys: " + quote(known)
            meant.extend([near] if near else [])
            self.bag.error("E0303", f"unknown key `{text.value}` in {what}", text.span, help=(help,))
        for key in keys:
            if key.required and key.name not in present and key.name not in meant:
                gone = left_out.get(key.name)
                about = f"{'it is left out here; give it a value' if gone else f'add `{key.name}`'}: {key.about}"
                self.bag.error("E0304", f"missing key `{key.name}` in {what}", gone or place, help=(about,))
        return tuple(meant)

    def refuse_unit(self, text: Text, known: Sequence[str] = (), *, declares: bool = False) -> bool:
        """Report a number with its unit behind it (``1 kg``), unless that is a ``known`` name, to be multiplied with.

        ``declares``: a unit has its place beside this value.
        """
        found = _MEASURED.fullmatch(text.value)
        if found is None or found.group(2).strip() in known:
            return False
        number, unit = found.groups()
        try:
            parse_unit(unit)
        except UnitError:
            return False
        help = f"write `{number}`; units are given where parameters and coordinates are declared"
        if unit == "deg":
            help = f"write `{number}*pi/180`: angles are in radians"
        elif declares:
            help = f"write `{{value: {number}, unit: {unit}}}`"
        place = text.locate(*found.span(2))
        self.bag.error("E0203", f"`{unit}` after a number: a value is written without its unit", place, help=(help,))
        return True

    def constant(self, node: Node, what: str, *, declares: bool = False) -> Fraction | Syntax | None:
        """Return a number, or an expression of numbers and ``pi`` that has a value; ``declares`` as :meth:`refuse_unit` has it."""
        text = self.text(node, f"a number for {what}")
        if text is None:
            return None
        try:
            value = exact(text.value)
        except ValueError as error:
            self.bag.error("E0210", f"the number {error}", text.span, help=(DOUBLES,))
            return None
        if value is not None:
            return value
        if self.refuse_unit(text, declares=declares) or self.refuse_infinite(text) or self._refuse_date(text, what):
            return None
        tree = parse_expression(text.value, text.locate, self.bag)
        if tree is None or not self._is_constant(tree, what, declares):
            return None
        return literal(tree) if literal(tree) is not None else tree

    def refuse_infinite(self, text: Text, known: Sequence[str] = ()) -> bool:
        """Report what YAML and others write for an infinite value or for none, unless that is a ``known`` name."""
        word = text.value.lstrip("+-").lower()
        if word not in (".inf", ".nan", "inf", "nan", "infinity") or text.value in known:
            return False
        help = "write a finite number; what has no value yet is left out"
        self.bag.error("E0313", f"`{text.value}` is no finite number", text.span, help=(help,))
        return True

    def _refuse_date(self, text: Text, what: str) -> bool:
        """Report 2024-01-05, which would be a difference of three numbers."""
        if not re.fullmatch(r"\d{4}-\d\d-\d\d", text.value):
            return False
        apart = " - ".join(str(int(part)) for part in text.value.split("-"))
        help = f"{what} is a number; a difference is written with spaces, `{apart}`"
        self.bag.error("E0301", f"expected a number for {what}, found the date `{text.value}`", text.span, help=(help,))
        return True

    def _is_constant(self, tree: Syntax, what: str, declares: bool) -> bool:
        for node in walk(tree):
            if isinstance(node, Name) and node.name != PI:
                if node.name in FUNCTIONS:
                    message = f"`{node.name}` needs its argument in parentheses"
                    self.bag.error("E0206", message, node.span, help=(f"write `{node.name}(1)`",))
                    return False
                message = f"`{node.name}` is not constant: {what} holds numbers and `pi` only"
                help = f"write the number in place of `{node.name}`"
                if declares:
                    help += ", or move the expression to `define`, where it may contain other names"
                if declares and isinstance(tree, Binary) and literal(tree.left) is not None and is_unit(node.name):
                    help += f"; a unit is written `{{value: ..., unit: {node.name}}}`"
                self.bag.error("E0314", message, node.span, help=(help,))
                return False
        try:
            evaluate(tree)
        except ConstantError as error:
            self.bag.error(error.code, error.message, error.span, help=(error.help,))
            return False
        return True

    def number(self, node: Node, what: str) -> Fraction | None:
        """Return a number; a constant expression is taken by its value."""
        value = self.constant(node, what)
        if value is None or isinstance(value, Fraction):
            return value
        return Fraction(evaluate(value))

    def interval(self, node: Node, what: str) -> tuple[Fraction, Fraction] | None:
        """Return two numbers of which the second is larger."""
        written = (
            re.fullmatch(rf"({_PLAIN})(?:\s*(?:\.\.+|-|to|,|;)\s*({_PLAIN}))?", node.value)
            if isinstance(node, Text)
            else None
        )
        help = "write `[low, high]`"
        if written:
            help = f"write `[{written[1]}, {written[2]}]`" if written[2] else f"write `[0, {written[1]}]`"
        items = self.items(node, f"a list of two numbers for {what}", help)
        if items is None:
            return None
        if len(items.items) != 2:
            message = f"expected two numbers for {what}, found {len(items.items)}"
            only = items.items[0] if len(items.items) == 1 else None
            parts = re.split(r"[\s;]+", only.value.strip()) if isinstance(only, Text) else []
            help = f"write `[{parts[0]}, {parts[1]}]`" if len(parts) == 2 else "write `[low, high]`"
            if len(items.items) > 2:
                help += "; decimal numbers are written with `.`"
            self.bag.error("E0301", message, items.span, help=(help,))
            return None
        low, high = (self.number(item, what) for item in items.items)
        if low is None or high is None:
            return None
        if low >= high:
            first = Label(items.items[0].span, "not before this")
            message = f"{what} ends where it starts, or before"
            help = "write `[low, high]`, the smaller number first"
            self.bag.error("E0313", message, items.items[1].span, labels=(first,), help=(help,))
            return None
        return low, high


def is_unit(text: str) -> bool:
    """Whether a text is a unit."""
    try:
        parse_unit(text)
    except UnitError:
        return False
    return True


def literal(tree: Syntax) -> Fraction | None:
    """Return the value of a number with or without a minus, None for any other expression."""
    if isinstance(tree, Negate) and isinstance(tree.operand, Number):
        return -tree.operand.value
    return tree.value if isinstance(tree, Number) else None
