"""``extends``: a spec takes over another and changes some of it.

The base is read relative to the spec's folder.  Mappings merge by name at every depth, an entry of the spec in the place of
the base's; lists and texts replace, and ``null`` leaves the base's entry out, as in a JSON merge patch (RFC 7396).  Where a mapping
has one of several forms (``U`` or ``V``, a body's ``turns`` or ``rotation``), the spec's form takes the place of the base's.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path, PurePosixPath

from nhc.diagnostics import Bag, Source, Span, SpecError
from nhc.language.expressions.names import fold
from nhc.language.keys import forms_at
from nhc.language.yaml_tree.nodes import Items, Node, Table, Text
from nhc.language.yaml_tree.reader import EXTENDS as KEY
from nhc.language.yaml_tree.reader import is_null, read_nodes

DEEPEST = 8


def base_name(source: Source) -> Text | None:
    """Return the value of ``extends`` in a source, None without one (or where the text is no YAML: decode says so)."""
    if KEY not in source.text:  # in flow style it may stand anywhere
        return None
    root = read_nodes(source, Bag(source))
    value = root.get(KEY) if isinstance(root, Table) else None
    return value if isinstance(value, Text) else None


def what_is_wrong(name: str) -> str:
    """Say why a name cannot be that of a base; empty where it can."""
    path = PurePosixPath(name)
    if path.is_absolute() or "\\" in name or ":" in name:
        return f"`{name}` is not a path from the spec's own folder"
    if ".." in path.parts:
        return f"`{name}` leads out of the spec's own folder"
    return "" if path.suffix in (".yaml", ".yml") else f"`{name}` is not the name of a .yaml file"


def refuse(source: Source, span: Span, message: str) -> SpecError:
    """Return the error at an ``extends``."""
    bag = Bag(source)
    help = "name a .yaml file in the spec's folder, or below it, that does not extend this one"
    bag.error("E0112", message, span, help=(help,))
    return SpecError(bag.diagnostics, source)


def folder_of(source: Source) -> Path:
    """Return the folder that names of bases start from."""
    return Path(source.path).parent


def merge_bases(source: Source, root: Table, bag: Bag) -> Table:
    """Return the root with what its bases add; entries to leave out that no base has go into ``bag`` (E0109).

    Raises ``SpecError``: a base was not read (a spec from standard input has no folder), or is no mapping.
    """
    value = root.get(KEY)
    if value is None:
        return root
    if not isinstance(value, Text):
        raise refuse(source, value.span, "`extends` names one file")
    if not source.bases:
        raise refuse(source, value.span, f"the base `{value.value}` was not read: this spec has no folder")
    start = len(source.text) + 1
    tables = [root]
    for base in source.bases:
        own = Bag(base)
        node = read_nodes(base, own)
        own.raise_if_errors()
        if not isinstance(node, Table):
            raise refuse(source, value.span, f"the base `{base.path}` is not a spec")
        tables.append(_shift_table(node, start))
        start += len(base.text) + 1
    made = tables[-1]
    for table in reversed(tables[:-1]):
        made = _merge_roots(made, table)
    return replace(_without_nulls(made, bag), span=root.span)


def _without_nulls(table: Table, bag: Bag) -> Table:
    """The table without what is to be left out and is in no base, at every depth of mappings."""
    entries = []
    for key, node in table.entries:
        if is_null(node):
            help = "give it a value, or remove it: `null` leaves out what a base has"
            bag.error(
                "E0109", f"no base has `{key.value}` here, so that it cannot be left out", node.span, help=(help,)
            )
        else:
            entries.append((key, _without_nulls(node, bag) if isinstance(node, Table) else node))
    return replace(table, entries=tuple(entries))


def _merge_roots(base: Table, own: Table) -> Table:
    base = replace(base, entries=tuple(entry for entry in base.entries if entry[0].value != KEY))
    return _merge(base, own, coordinate_names(base, own), ())


def _merge(base: Table, own: Table, rates: frozenset[str], path: tuple[str, ...]) -> Table:
    """Merge by name, however it is spelled; the base's order first, then what is new.

    ``rates`` are the coordinates whose velocities may be written ``xdot`` and ``x'`` here, ``path`` the keys that lead here.
    """
    replaced = _replaced(own, path)
    new: dict[str, tuple[Text, Node]] = {}
    twice = []  # in one mapping: the decoder says so
    for text, node in own.entries:
        name = _spell(text.value, rates)
        if name in new:
            twice.append((text, node))
        else:
            new[name] = text, node
    entries = []
    for text, node in base.entries:
        name = _spell(text.value, rates)
        if name not in new:
            if text.value not in replaced:
                entries.append((text, node))
            continue
        key, value = new.pop(name)
        if isinstance(node, Table) and isinstance(value, Table):
            merged: Node = _merge(node, value, rates, (*path, name))
            if not path and node.entries and merged == Table((), value.span):
                continue  # a section of which all is left out is left out itself
        else:
            merged = value
        if not is_null(merged):
            entries.append((key, merged))
    return Table((*entries, *new.values(), *twice), own.span)


def _replaced(own: Table, path: tuple[str, ...]) -> set[str]:
    """Keys of the base for which the spec has another form."""
    forms = forms_at(path)
    given = [text.value for text, node in own.entries if not is_null(node)]
    meant = [form for form in forms if any(key in given for key in form)]
    return {key for form in forms if meant and form not in meant for key in form}


def _spell(name: str, rates: frozenset[str]) -> str:
    """The one spelling of a key."""
    name = fold(name)
    return f"{name[:-3]}'" if name.endswith("dot") and name not in rates and name[:-3] in rates else name


def coordinate_names(*tables: Table) -> frozenset[str]:
    """The coordinates that specs declare, as a list or as a mapping."""
    return frozenset[str]().union(*(declared_names(table, "coordinates") for table in tables))


def declared_names(table: Table, key: str) -> frozenset[str]:
    """The names under a key of a spec, which has a list or a mapping."""
    node = table.get(key)
    if isinstance(node, Table):
        return frozenset(fold(text.value) for text, _ in node.entries)
    return frozenset(
        fold(item.value) for item in (node.items if isinstance(node, Items) else ()) if isinstance(item, Text)
    )


def _shift(node: Node, by: int) -> Node:
    match node:
        case Text():
            span = _move(node.span, by)
            return Text(node.value, span, node.plain, tuple(offset + by for offset in node.offsets))
        case Items():
            return Items(tuple(_shift(item, by) for item in node.items), _move(node.span, by))
        case Table():
            return _shift_table(node, by)


def _shift_table(table: Table, by: int) -> Table:
    entries = []
    for text, node in table.entries:
        key = Text(text.value, _move(text.span, by), text.plain, tuple(offset + by for offset in text.offsets))
        entries.append((key, _shift(node, by)))
    return Table(tuple(entries), _move(table.span, by))


def _move(span: Span, by: int) -> Span:
    return Span(span.start + by, span.end + by)
