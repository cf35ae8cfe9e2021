"""Sheets as plain text, readable in a terminal of 100 columns or of fewer."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Sequence
from itertools import zip_longest

from nhc.emit.layout import Piece, fill
from nhc.emit.prose import clean
from nhc.emit.text.math import TextMath, print_mark
from nhc.program.contents import walk
from nhc.program.ir import Ref
from nhc.program.sheets.model import Derivation, Formula, Item, Prose, Sheet, Statement, Table, Term

WIDTH = 100
_INDENT, _HANGING = "  ", "      "
_NARROWEST = 16  # columns of a table's widest cells, at least


class TextSheets:
    """Prints the sheets of one derivation."""

    def __init__(self, derivation: Derivation, width: int = WIDTH) -> None:
        self.width = width
        self.derivation = derivation
        self.math = TextMath(derivation.symbols)

    def sheets(self, sheets: Sequence[Sheet]) -> str:
        """The sheets with what they use of others' abbreviations in front."""
        lines: list[str] = []
        missing = self._missing(sheets)
        if missing:
            lines += ["abbreviations", "", *self._statements(missing), ""]
        for sheet in sheets:
            lines += [sheet.title, "-" * len(sheet.title), ""]
            head, tail = sheet.items[: sheet.lets_at], sheet.items[sheet.lets_at :]
            lines += [*self._items(head), ""] if head else []
            if sheet.lets:
                lines += ["With the abbreviations", *self._statements(sheet.lets), ""]
            lines += [*self._items(tail), ""]
        return "\n".join(lines).rstrip() + "\n"

    def _missing(self, sheets: Sequence[Sheet]) -> list[Statement]:
        """Abbreviations of sheets that are not printed, needed by those that are; in the order in which they were made."""
        own = {_name(let) for sheet in sheets for let in sheet.lets}
        needed: set[str] = set()
        items = [item for sheet in sheets for item in sheet.items if isinstance(item, Statement)]
        pending = [*items, *(let for sheet in sheets for let in sheet.lets)]
        while pending:
            for name in _references(pending.pop()):
                if name in self.derivation.lets and name not in own and name not in needed:
                    needed.add(name)
                    pending.append(self.derivation.lets[name])
        return [let for name, let in self.derivation.lets.items() if name in needed]

    def _items(self, items: Sequence[Item]) -> list[str]:
        """Displays follow their sentence at once; a blank line stands before the next sentence."""
        lines: list[str] = []
        before: Item | None = None
        for item in items:
            if isinstance(item, Prose):
                lines += [""] if before is not None and not isinstance(before, Prose) else []
                lines += self._prose(item)
            elif isinstance(item, Formula):
                lines += self._formula(item)
            elif isinstance(item, Table):
                lines += self._table(item)
            else:
                same = isinstance(before, Statement) and before.equation == item.equation
                lines += self._statement(item, "" if same else item.equation)
            before = item
        return lines

    def _prose(self, prose: Prose) -> list[str]:
        text = clean(prose.plain)
        return textwrap.wrap(
            text, self.width, subsequent_indent="  " if text.startswith("- ") else "", break_long_words=False
        )

    def _formula(self, formula: Formula) -> list[str]:
        parts = [part.strip() for part in formula.text.split(",  ")]
        lines = []
        for k, part in enumerate(parts):
            tag = f"   ({formula.equation})" if formula.equation and k == 0 else ""
            lines += textwrap.wrap(
                part + ("," if k < len(parts) - 1 else "") + tag, self.width, initial_indent=_INDENT, subsequent_indent=_HANGING,
                break_long_words=False, break_on_hyphens=False,
            )  # fmt: skip
        return lines

    def _table(self, table: Table) -> list[str]:
        rows = [[clean(cell) if isinstance(cell, str) else print_mark(cell) for cell in row] for row in table.rows]
        widths = [max(len(row[k]) for row in rows) for k in range(len(table.head))]
        widest = max(range(len(widths)), key=widths.__getitem__)
        room = self.width - sum(width + 2 for k, width in enumerate(widths) if k != widest) - len(_INDENT)
        widths[widest] = min(widths[widest], max(room, _NARROWEST))
        lines = []
        for row in rows:
            words = textwrap.wrap(row[widest], widths[widest], break_long_words=False, break_on_hyphens=False)
            columns = [words if k == widest else [cell] for k, cell in enumerate(row)]
            for parts in zip_longest(*columns, fillvalue=""):
                cells = [part.ljust(width) for part, width in zip(parts, widths, strict=True)]
                lines.append((_INDENT + "  ".join(cells)).rstrip())
        return lines

    def _statements(self, statements: Iterable[Statement]) -> list[str]:
        return [line for statement in statements for line in self._statement(statement, "")]

    def _statement(self, statement: Statement, number: str) -> list[str]:
        left, right = self.math.side(statement.left), self.math.side(statement.right)
        label = f"{print_mark(statement.label)}:  " if statement.label is not None else ""
        tail = "   ".join(part for part in (f"({number})" if number else "", statement.note) if part)
        relation = Piece(f" {statement.relation} ", 3, int(len(left) > 12))
        pieces = [Piece(label, len(label)), *left, relation, *right]
        lines = fill(pieces, self.width - len(_INDENT), self.width - len(_HANGING))
        lines = [(_INDENT if k == 0 else _HANGING) + line.strip() for k, line in enumerate(lines)]
        if tail and len(lines[-1]) + 3 + len(tail) <= self.width:
            lines[-1] += f"   {tail}"
        elif tail:
            lines.append(f"{_HANGING}{tail}")
        return lines

    def statement_text(self, statement: Statement) -> tuple[str, str]:
        """Both sides on one line each."""
        sides = (self.math.side(statement.left), self.math.side(statement.right))
        left, right = ("".join(piece.text for piece in side) for side in sides)
        return left, right


def _name(let: Statement) -> str:
    (term,) = let.left
    assert isinstance(term.coefficient, Ref)
    return term.coefficient.name


def _references(statement: Statement) -> list[str]:
    terms: tuple[Term, ...] = (*statement.left, *statement.right)
    return [part.name for term in terms for part in walk(term.coefficient) if isinstance(part, Ref)]
