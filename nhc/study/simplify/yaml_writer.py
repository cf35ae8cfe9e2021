"""Nodes of a spec back to YAML; comments are lost, all else reads back the same."""

from __future__ import annotations

import json
import re

from nhc.language.yaml_tree.nodes import Items, Node, Table, Text

_PLAIN = re.compile(r"-?[A-Za-z0-9_(][A-Za-z0-9_ .+*/^()'=-]*")
_DEPTH = 2  # mappings inside one another that get lines of their own; deeper ones stand in braces


def write_nodes(root: Table) -> str:
    """The text of a whole spec."""
    return "\n".join(_block(root, 0)) + "\n"


def _block(table: Table, depth: int) -> list[str]:
    indent, lines = "  " * depth, []
    for key, node in table.entries:
        head = f"{indent}{_scalar(key)}:"
        if isinstance(node, Table) and node.entries and depth < _DEPTH and not _is_short(node, depth):
            lines += [head, *_block(node, depth + 1)]
        elif isinstance(node, Items) and depth == 0 and not all(isinstance(item, Text) for item in node.items):
            lines += [head, *(f"  - {_flow(item)}" for item in node.items)]
        else:
            lines.append(f"{head} {_flow(node)}")
    return lines


def _is_short(table: Table, depth: int) -> bool:
    """Whether a mapping below the first level holds texts alone: a coordinate or parameter with what is known of it."""
    return depth > 0 and all(isinstance(node, Text) for _, node in table.entries)


def _flow(node: Node) -> str:
    match node:
        case Text():
            return _scalar(node)
        case Items():
            return f"[{', '.join(_flow(item) for item in node.items)}]"
        case Table():
            return "{" + ", ".join(f"{_scalar(key)}: {_flow(value)}" for key, value in node.entries) + "}"


def _scalar(text: Text) -> str:
    """Without quotes where it stood without them and needs none; a `: ` cannot come, for `:` is quoted."""
    value = text.value
    if text.plain and _PLAIN.fullmatch(value) and not value.endswith(" "):
        return value
    return json.dumps(value, ensure_ascii=False)
