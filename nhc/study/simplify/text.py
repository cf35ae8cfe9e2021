"""The text of a spec of which parts are left out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from nhc.diagnostics import Span
from nhc.language.expressions.names import fold
from nhc.language.expressions.syntax import Syntax, same
from nhc.language.expressions.unparse import unparse
from nhc.language.scope import names_in
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.records import record
from nhc.study.simplify.draft import Changed, Draft, Place, reach
from nhc.study.simplify.yaml_writer import write_nodes
from nhc.study.simplify.zero import is_infinite, is_zero

_NOWHERE = Span(0, 0)


class NoLimit(Exception):
    """What is left cannot be written: a limit is not finite."""


def write_draft(draft: Draft, changed: Changed, about: str = "") -> str:
    """The text of the spec with some candidates gone, with the draft's scene alone; ``about`` is added to what it is.

    Raises:
        NoLimit: an expression grows without bound.
    """
    if any(is_infinite(tree) for tree in (*changed.trees.values(), *changed.copied.values())):
        raise NoLimit("it has no limit there")
    return _Writer(draft, changed, about).write()


@record
class _Writer:
    draft: Draft
    changed: Changed
    about: str

    def write(self) -> str:
        return write_nodes(replace(self.draft.root, entries=tuple(self._entries())))

    def _idle(self) -> set[str]:
        """Definitions and parameters that were used and are not any more."""
        changed = {**self.changed.trees, **{("copy", n): tree for n, tree in self.changed.copied.items()}}
        before, after = self._used(self.draft.trees, False), self._used(changed, True)
        idle = {name for name in before if name not in after}
        return idle - self._used_beside(idle)

    def _used(self, trees: Mapping[Place, Syntax], copies: bool) -> set[str]:
        definitions = {name: tree for (key, name), tree in trees.items() if key == "define"}
        if copies:
            definitions |= {self.changed.copies[name]: tree for name, tree in self.changed.copied.items()}
        roots = {n for (key, _), tree in trees.items() if key not in ("define", "copy") for n in names_in(tree)}
        shown = self.draft.shown if not (copies and self._redrawn()) else self._started()
        return reach(roots | set(shown), definitions)

    def _redrawn(self) -> bool:
        """A drawing is left out together with a coordinate."""
        return bool(self.changed.coordinates)

    def _started(self) -> set[str]:
        gone = self.changed.coordinates
        return {n for entry in self.draft.scene.initial if entry.name not in gone for n in names_in(entry.value)}

    # --- entries

    def _entries(self) -> Iterator[tuple[Text, Node]]:
        idle, brought = self._idle(), self._brought()
        for key, node in self.draft.root.entries:
            made = self._entry(key.value, node, idle)
            if key.value == "parameters" and isinstance(made, Table | Items | None) and brought:
                made, brought = self._with(made, brought), []
            if made is not None:
                yield key, made
            if key.value == "system" and self.about and self.draft.root.get("about") is None:
                yield _plain("about"), replace(_plain(self.about), plain=False)
            if key.value == "coordinates" and self.draft.root.get("parameters") is None and brought:
                yield _plain("parameters"), self._with(None, brought)
                brought = []

    def _entry(self, key: str, node: Node, idle: set[str]) -> Node | None:
        """What becomes of a top-level entry; None where it goes."""
        removed = self.changed.coordinates
        match key, node:
            case "extends", _:
                return None
            case (("draw" | "dependent"), _) if removed:
                return None
            case (("T" | "U" | "V"), Text()):
                return self._potential(key, node)
            case (("define" | "forces" | "quasi_velocities" | "outputs"), Table()):
                return self._expressions(key, node, idle)
            case (("constraints" | "holonomic"), Items()):
                items = tuple(self._equation(key, k, item) for k, item in enumerate(node.items))
                return replace(node, items=items)
            case "parameters", (Table() | Items()):
                return _without(node, idle)
            case "coordinates", (Table() | Items()) if removed:
                return _without(node, set(removed))
            case "scenes", Table():
                return self._scenes(node, idle)
            case "about", Text() if self.about:
                return replace(node, value=f"{' '.join(node.value.split())} {self.about}", plain=False)
        return node

    def _potential(self, key: str, node: Text) -> Node | None:
        text = self._text(node, (key, ""))
        return None if key != "T" and is_zero(self.changed.trees[key, ""]) else text

    def _expressions(self, key: str, table: Table, idle: set[str]) -> Table | None:
        entries = []
        for text, node in table.entries:
            name = fold(text.value)
            if (key, name) not in self.changed.trees or not isinstance(node, Text):
                entries.append((text, node))
                continue
            zero = is_zero(self.changed.trees[key, name])
            gone = key == "forces" and (zero or name in self.changed.coordinates)
            gone = gone or (key == "quasi_velocities" and zero and self._redrawn())
            if not gone and not (key == "define" and name in idle):
                entries.append((text, self._text(node, (key, name))))
            copy = self.changed.copies.get(name, "") if key == "define" else ""
            if copy and copy in self._used_now(idle):
                entries.append((_plain(copy), _plain(unparse(self.changed.copied[name]))))
        if key == "define":
            entries += self._copies_of_made({fold(text.value) for text, _ in table.entries}, idle)
        return replace(table, entries=tuple(entries)) if entries else None

    def _copies_of_made(self, written: set[str], idle: set[str]) -> list[tuple[Text, Node]]:
        """Copies of definitions that nhc makes of bodies and rotations, which have no entry to stand behind."""
        made = [(name, copy) for name, copy in self.changed.copies.items() if name not in written]
        used = self._used_now(idle) if made else set()
        return [
            (_plain(copy), _plain(unparse(self.changed.copied[name]))) for name, copy in sorted(made) if copy in used
        ]

    def _used_now(self, idle: set[str]) -> set[str]:
        changed = {**self.changed.trees, **{("copy", n): tree for n, tree in self.changed.copied.items()}}
        return self._used(changed, True) | self._used_beside(idle)

    def _used_beside(self, idle: set[str]) -> set[str]:
        """What definitions use that stay, also those that stand there for the names of forces or for readers alone."""
        copies = {self.changed.copies[name]: tree for name, tree in self.changed.copied.items()}
        definitions = {name: tree for (key, name), tree in self.changed.trees.items() if key == "define"}
        used = {n for name, tree in definitions.items() if name not in idle for n in names_in(tree)}
        return reach(used, definitions | copies)

    def _text(self, text: Text, place: Place) -> Text:
        new, old = self.changed.trees[place], self.draft.trees[place]
        return text if new is old or same(new, old) else _plain(unparse(new))

    def _equation(self, key: str, k: int, item: Node) -> Node:
        """A constraint as it stands, or from its trees where they have changed."""
        sides = [(key, f"{k} {side}") for side in ("left", "right")]
        new, old = [self.changed.trees[s] for s in sides], [self.draft.trees[s] for s in sides]
        if all(same(a, b) for a, b in zip(new, old, strict=True)):
            return item
        text = _plain(f"{unparse(new[0])} = {unparse(new[1])}")
        if isinstance(item, Table):
            return replace(item, entries=((item.entries[0][0], text),))
        return text

    def _scenes(self, table: Table, idle: set[str]) -> Table:
        entries = []
        for text, node in table.entries:
            if fold(text.value) != self.draft.scene.name or not isinstance(node, Table):
                continue
            kept = []
            for key, own in node.entries:
                value: Node | None = own
                if key.value == "parameters" and isinstance(value, Table):
                    value = _without(value, idle)
                if key.value == "initial" and isinstance(value, Table):
                    value = _without(value, self._unset())
                if value is not None:
                    kept.append((key, value))
            entries.append((text, replace(node, entries=tuple(kept))))
        return replace(table, entries=tuple(entries))

    def _unset(self) -> set[str]:
        """Names of a start that are no longer there."""
        gone = self.changed.coordinates
        velocities = {f"{name}{mark}" for name in gone for mark in ("'", "dot", "\u2032")}
        zero = {n for (key, n), tree in self.changed.trees.items() if key == "quasi_velocities" and is_zero(tree)}
        return set(gone) | velocities | (zero if gone else set())

    # --- parameters that held coordinates bring

    def _brought(self) -> list[tuple[Text, Node]]:
        units = {c.name: c.unit for c in self.draft.spec.coordinates}
        found: list[tuple[Text, Node]] = []
        for candidate in self.changed.coordinates.values():
            for name, value, unit in candidate.parameters(units[candidate.name]):
                entry: list[tuple[Text, Node]] = [(_plain("value"), _plain(value))]
                entry += [(_plain("unit"), _plain(unit))] if unit else []
                found.append((_plain(name), Table(tuple(entry), _NOWHERE)))
        return found

    def _with(self, node: Table | Items | None, brought: list[tuple[Text, Node]]) -> Table:
        own = node.entries if isinstance(node, Table) else ()
        return Table((*own, *brought), _NOWHERE)


def _without(node: Node, names: set[str]) -> Node | None:
    """A table or list without some names; None where nothing stays."""
    if isinstance(node, Items):
        items = tuple(item for item in node.items if not (isinstance(item, Text) and fold(item.value) in names))
        return replace(node, items=items) if items else None
    if isinstance(node, Table):
        entries = tuple(entry for entry in node.entries if fold(entry[0].value) not in names)
        return replace(node, entries=entries) if entries else None
    return node


def _plain(value: str) -> Text:
    return Text(value, _NOWHERE, True)
