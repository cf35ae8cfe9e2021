"""The derivation and the program as plain text, and the derivation as JSON."""

from __future__ import annotations

import textwrap
from typing import Any

from nhc.emit.prose import clean
from nhc.emit.text.math import print_mark
from nhc.emit.text.program import print_program
from nhc.emit.text.sheets import WIDTH, TextSheets
from nhc.program.sheets.model import Derivation, Formula, Item, Prose, Sheet, Statement, Table
from nhc.version import __version__

__all__ = ["derivation_json", "print_derivation", "print_equations", "print_form", "print_program"]

FORM = ("kinematics", "kinetic", "form")
EQUATIONS = ("associated", "motion", "reactions", "energy")


def print_derivation(derivation: Derivation, width: int = 0) -> str:
    """Everything, under the system's name, on lines of the usual width or of another one."""
    spec = derivation.system.spec
    head = [spec.system, "=" * len(spec.system)]
    about = [clean(spec.about)] if spec.about else []
    about += [f"After {'; '.join(clean(source) for source in spec.sources)}."] if spec.sources else []
    head += [line for text in about for line in (textwrap.wrap(text, width) if width else [text])]
    return "\n".join(head) + "\n\n" + TextSheets(derivation, width or WIDTH).sheets(derivation.sheets)


def print_form(derivation: Derivation) -> str:
    """The coframe, the one-form and the 2-forms."""
    return _print_some(derivation, FORM)


def print_equations(derivation: Derivation) -> str:
    """The associated rows, the equations of motion, the reactions, the energy."""
    return _print_some(derivation, EQUATIONS)


def _print_some(derivation: Derivation, keys: tuple[str, ...]) -> str:
    return TextSheets(derivation).sheets([sheet for sheet in derivation.sheets if sheet.key in keys])


def derivation_json(derivation: Derivation) -> dict[str, Any]:
    """The sheets as data, expressions in the spelling of the spec language; ``nhc_derivation`` is the version too."""
    printer = TextSheets(derivation)
    return {
        "schema": "nhc.derivation/1",
        "nhc": __version__,
        "nhc_derivation": 1,
        "system": derivation.system.name,
        "formulation": derivation.formulation,
        "equation": derivation.equation,
        "sheets": [_sheet(printer, sheet) for sheet in derivation.sheets],
    }


def _sheet(printer: TextSheets, sheet: Sheet) -> dict[str, Any]:
    return {
        "key": sheet.key,
        "title": sheet.title,
        "abbreviations": [_item(printer, let) for let in sheet.lets],
        "items": [_item(printer, item) for item in sheet.items],
    }


def _item(printer: TextSheets, item: Item) -> dict[str, Any]:
    match item:
        case Prose():
            return {"kind": "prose", "text": item.plain}
        case Formula():
            return {"kind": "formula", "text": item.text, "latex": item.latex, "equation": item.equation}
        case Table():
            rows = [[cell if isinstance(cell, str) else print_mark(cell) for cell in row] for row in item.rows]
            return {"kind": "table", "head": list(item.head), "rows": rows}
        case Statement():
            left, right = printer.statement_text(item)
            found = {"kind": "statement", "left": left, "relation": item.relation, "right": right}
            found |= {"equation": item.equation, "place": item.place, "note": item.note}
            return found | ({"row": print_mark(item.label)} if item.label is not None else {})
