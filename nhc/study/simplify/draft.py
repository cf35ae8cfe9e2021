"""A spec of which parts can be left out: its expressions as trees, its candidates, and the text of what is left."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from nhc.diagnostics import Bag, Source, Span
from nhc.language import Spec, decode
from nhc.language.extend import merge_bases
from nhc.language.names import fold
from nhc.language.nodes import Items, Node, Table, Text
from nhc.language.parser import parse_expression
from nhc.language.scope import names_in
from nhc.language.spec import Scene
from nhc.language.syntax import Name, Syntax, same
from nhc.language.unparse import unparse
from nhc.language.yaml_reader import read_nodes
from nhc.study.simplify.yaml_writer import write_nodes
from nhc.study.simplify.zero import is_zero, list_terms, vanish

Place = tuple[str, str]  # a top-level key and a name below it, or nothing
_SINGLE, _NAMED = ("T", "U", "V"), ("define", "forces")


@dataclass(frozen=True, eq=False)
class Candidate:
    """A term (``node``) or a parameter (``name``) that may be set to 0; ``about`` says what it is."""

    about: str
    node: Syntax | None = None
    name: str = ""

    def takes(self, node: Syntax) -> bool:
        return node is self.node or (isinstance(node, Name) and bool(self.name) and node.name == self.name)


@dataclass(frozen=True)
class Draft:
    """``trees`` are the expressions that may lose terms; ``fixed`` the names that all else uses, ``locked`` those with all that
    their definitions use.
    """

    spec: Spec
    scene: Scene
    root: Table
    trees: Mapping[Place, Syntax]
    fixed: frozenset[str]
    locked: frozenset[str]

    def candidates(self) -> list[Candidate]:
        """Terms of T, U or V, the forces and of unlocked definitions, then unlocked parameters, as the spec has them."""
        found = []
        for (key, name), tree in self.trees.items():
            if key == "define" and name in self.locked:
                continue
            where = f"`{key}.{name}`" if name else f"`{key}`"
            for node, minus in list_terms(tree, key in ("U", "V", "forces")):
                found.append(Candidate(f"term `{'-' if minus else ''}{unparse(node)}` of {where}", node))
        used = {name for tree in self.trees.values() for name in names_in(tree)}
        for parameter in self.spec.parameters:
            if parameter.name in used and parameter.name not in self.locked:
                found.append(Candidate(f"parameter `{parameter.name}`, set to 0", name=parameter.name))
        return found

    def without(self, gone: Iterable[Candidate], about: str = "") -> str:
        """The text of the spec without some candidates, with the draft's scene alone; ``about`` is added to what it is."""
        taken = tuple(gone)
        new = {
            place: vanish(tree, lambda node: any(c.takes(node) for c in taken)) for place, tree in self.trees.items()
        }
        used_before, used = self._used(self.trees), self._used(new)
        idle = {name for name in used_before if name not in used}
        return write_nodes(replace(self.root, entries=tuple(self._entries(new, idle, about))))

    def _used(self, trees: Mapping[Place, Syntax]) -> set[str]:
        definitions = {name: tree for (key, name), tree in trees.items() if key == "define"}
        start = {name for (key, _), tree in trees.items() if key != "define" for name in names_in(tree)}
        return _reach(start | self.fixed, definitions)

    def _entries(self, new: Mapping[Place, Syntax], idle: set[str], about: str) -> Iterator[tuple[Text, Node]]:
        for key, node in self.root.entries:
            name = key.value
            if name in _SINGLE and isinstance(node, Text):
                yield key, self._text(node, (name, ""), new)
            elif name in (*_NAMED, "parameters") and isinstance(node, Table | Items):
                made = self._section(name, node, new, idle)
                if made is not None:
                    yield key, made
            elif name == "scenes" and isinstance(node, Table):
                yield key, self._scenes(node, idle)
            elif name == "about" and isinstance(node, Text) and about:
                yield key, replace(node, value=f"{' '.join(node.value.split())} {about}", plain=False)
            elif name != "extends":
                yield key, node
            if name == "system" and about and self.root.get("about") is None:
                yield _plain("about"), replace(_plain(about), plain=False)

    def _section(self, key: str, node: Table | Items, new: Mapping[Place, Syntax], idle: set[str]) -> Node | None:
        """A section without what nothing uses any more; None where nothing stays of it."""
        if isinstance(node, Items):
            items = tuple(item for item in node.items if not (isinstance(item, Text) and fold(item.value) in idle))
            return replace(node, items=items) if items else None
        entries = []
        for text, value in node.entries:
            place = (key, fold(text.value))
            gone = key != "forces" and fold(text.value) in idle
            if place in new and not gone and isinstance(value, Text):
                gone = key == "forces" and is_zero(new[place])
                value = self._text(value, place, new)
            if not gone:
                entries.append((text, value))
        return replace(node, entries=tuple(entries)) if entries else None

    def _text(self, text: Text, place: Place, new: Mapping[Place, Syntax]) -> Text:
        unchanged = new[place] is self.trees[place] or same(new[place], self.trees[place])
        return text if unchanged else _plain(unparse(new[place]))

    def _scenes(self, table: Table, idle: set[str]) -> Table:
        entries = []
        for text, node in table.entries:
            if fold(text.value) != self.scene.name or not isinstance(node, Table):
                continue
            kept = []
            for key, value in node.entries:
                if key.value == "parameters" and isinstance(value, Table):
                    value = replace(value, entries=tuple(e for e in value.entries if fold(e[0].value) not in idle))
                    if not value.entries:
                        continue
                kept.append((key, value))
            entries.append((text, replace(node, entries=tuple(kept))))
        return replace(table, entries=tuple(entries))


def draft_of(source: Source, scene: Scene) -> Draft:
    """The draft of a spec that decodes, for one of its scenes.

    Raises:
        nhc.diagnostics.SpecError: the spec has errors.
    """
    spec = decode(source)
    bag = Bag(source)
    read = read_nodes(source, bag)
    bag.raise_if_errors()
    assert isinstance(read, Table)
    root = merge_bases(source, read)
    trees: dict[Place, Syntax] = {}
    for key, node in root.entries:
        if key.value in _SINGLE and isinstance(node, Text):
            trees[key.value, ""] = _parse(node, bag)
        elif key.value in _NAMED and isinstance(node, Table):
            for text, value in node.entries:
                if isinstance(value, Text):
                    trees[key.value, fold(text.value)] = _parse(value, bag)
    fixed = frozenset(name for tree in _fixed_trees(spec, scene) for name in names_in(tree))
    locked = _reach(set(fixed), {d.name: d.value for d in spec.definitions})
    return Draft(spec, scene, root, trees, fixed, frozenset(locked))


def _parse(text: Text, bag: Bag) -> Syntax:
    tree = parse_expression(text.value, text.locate, bag)
    bag.raise_if_errors()
    assert tree is not None
    return tree


def _plain(value: str) -> Text:
    return Text(value, Span(0, 0), True)


def _fixed_trees(spec: Spec, scene: Scene) -> Iterator[Syntax]:
    """What stays as it is: constraints, quasi-velocities, outputs, drawings and the start."""
    for constraint in spec.constraints:
        yield from (constraint.left, constraint.right)
    for holonomic in spec.holonomic:
        yield from (holonomic.left, holonomic.right)
    yield from (definition.value for definition in (*spec.quasi_velocities, *spec.outputs))
    for figure in spec.draw:
        yield from figure.expressions
    yield from (initial.value for initial in scene.initial)


def _reach(start: set[str], definitions: Mapping[str, Syntax]) -> set[str]:
    """The names and all that their definitions use."""
    found, stack = set(start), sorted(start)
    while stack:
        name = stack.pop()
        for other in names_in(definitions[name]) if name in definitions else ():
            if other not in found:
                found.add(other)
                stack.append(other)
    return found
