"""Diagnostics for a program (``--json``)."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from .data import Diagnostic, Label, localize
from .source import Source

SCHEMA_VERSION = 1


def _place(source: Source, label: Label) -> dict[str, Any]:
    line, column = source.position(label.span.start)
    end_line, end_column = source.position(label.span.end)
    return {"line": line, "column": column, "end_line": end_line, "end_column": end_column}


def _item(whole: Source, found: Diagnostic) -> dict[str, Any]:
    source, diagnostic = localize(whole, found)
    return {
        **({} if source is whole else {"file": source.path}),  # a base that the spec extends
        "code": diagnostic.code,
        "severity": diagnostic.severity.value,
        "message": diagnostic.message,
        **_place(source, diagnostic.labels[0]),
        "labels": [{**_place(source, label), "text": label.text} for label in diagnostic.labels],
        "notes": list(diagnostic.notes),
        "help": list(diagnostic.help),
    }


def to_json(source: Source, diagnostics: Iterable[Diagnostic]) -> dict[str, Any]:
    """Return the diagnostics as a tree for ``json.dumps``; lines and columns count from 1, ends are exclusive."""
    return {
        "nhc_diagnostics": SCHEMA_VERSION,
        "file": source.path,
        "diagnostics": [_item(source, diagnostic) for diagnostic in diagnostics],
    }
