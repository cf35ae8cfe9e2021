"""The document: sections of prose, tables and aligned displays, with the thesis's numbers as tags."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from nhc.emit.environment import create_environment
from nhc.emit.latex.math import LatexMath, estimate, print_mark
from nhc.emit.latex.spelling import escape
from nhc.emit.layout import fill, total
from nhc.emit.prose import fold_ascii
from nhc.program.sheets.model import Derivation, Formula, Item, Mark, Prose, Sheet, Statement, Table
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

TEMPLATE = "latex/derivation.tex.jinja"
_LINE = 440.0  # points between the margins, less a little
_TAG = 52.0  # a tag and the space before it
_HANGING = 24.0
_ALIGNED = 120.0  # widest left side that is aligned at its relation


@dataclass(frozen=True, slots=True)
class Section:
    """What the template places."""

    title: str
    blocks: tuple[str, ...]


def render(derivation: Derivation) -> str:
    """The document's text, not yet stamped."""
    return create_environment().get_template(TEMPLATE).render(list_context(derivation))


def list_context(derivation: Derivation) -> dict[str, object]:
    """Exactly what the template may use."""
    spec = derivation.system.spec
    sources = "; ".join(escape(source) for source in spec.sources)
    return {
        "comment": (
            f"{spec.system}: equations of motion, written by nhc {__version__}",
            f"{PLACEHOLDER} edit the spec, not this file",
            f"formulation: {derivation.formulation} ({fold_ascii(derivation.equation)})",
        ),
        "title": escape(spec.system.replace("_", " ").capitalize()),
        "about": escape(spec.about),
        "sources": sources,
        "sections": tuple(_Printer(derivation).section(sheet) for sheet in derivation.sheets),
    }


class _Printer:
    """Prints the sheets of one derivation."""

    def __init__(self, derivation: Derivation) -> None:
        self.math = LatexMath(derivation.symbols)
        system = derivation.system
        self.names = {*system.q_names, *(p.name for p in system.spec.parameters)}
        self.names |= {f"{name}{dots}" for name in system.q_names for dots in ("'", "''")}

    def section(self, sheet: Sheet) -> Section:
        blocks: list[str] = []
        if sheet.lets:
            blocks += ["With the abbreviations", self._aligned(sheet.lets)]
        blocks += self._blocks(sheet.items)
        return Section(escape(sheet.title), tuple(blocks))

    def _blocks(self, items: Sequence[Item]) -> list[str]:
        blocks: list[str] = []
        group: list[Statement] = []
        for item in items:
            if group and not (isinstance(item, Statement) and item.equation == group[0].equation):
                blocks.append(self._aligned(group))
                group = []
            match item:
                case Statement():
                    group.append(item)
                case Prose():
                    blocks.append(self._prose(item.text))
                case Formula():
                    blocks.append(self._formula(item))
                case Table():
                    blocks.append(self._table(item))
        return [*blocks, self._aligned(group)] if group else blocks

    # --- prose and tables -------------------------------------------------------------------------------------

    def _prose(self, text: str) -> str:
        """Names between back-ticks that stand for quantities are set as math, others as words."""
        item = text.startswith("- ")
        pieces = re.split(r"`([^`]*)`", text.removeprefix("- "))
        shown = "".join(self._name(part) if k % 2 else escape(part) for k, part in enumerate(pieces))
        return rf"\item {shown}" if item else shown

    def _name(self, name: str) -> str:
        if name not in self.names:
            return rf"\emph{{{escape(name)}}}"
        bare = name.rstrip("'")
        return f"${print_mark(Mark(bare, dots=len(name) - len(bare)))}$"

    def _table(self, table: Table) -> str:
        columns = "l" * len(table.head)
        widest = max(range(len(table.head)), key=lambda k: max(len(r[k]) if isinstance(r[k], str) else 1 for r in table.rows))
        columns = columns[:widest] + r"p{0.55\linewidth}" + columns[widest + 1 :]
        lines = [rf"\begin{{longtable}}[l]{{@{{\qquad}}{columns}@{{}}}}"]
        lines.append(" & ".join(rf"\emph{{{escape(title)}}}" for title in table.head) + r" \\")
        lines.append(r"\hline \endhead")
        for row in table.rows:
            cells = [escape(cell) if isinstance(cell, str) else f"${print_mark(cell)}$" for cell in row]
            lines.append(" & ".join(cells) + r" \\")
        return "\n".join([*lines, r"\end{longtable}"])

    # --- displays ---------------------------------------------------------------------------------------------

    def _formula(self, formula: Formula) -> str:
        tag = rf" \tag{{{formula.equation}}}" if formula.equation else ""
        environment = "equation" if tag else "equation*"
        return f"\\begin{{{environment}}}\n  {formula.latex}{tag}\n\\end{{{environment}}}"

    def _aligned(self, statements: Sequence[Statement]) -> str:
        """One block, its tag on the first line; aligned at the relations where the left sides are short."""
        widths = [total(self.math.side(s.left)) + self._label_width(s) for s in statements]
        column = max(widths) if max(widths) <= _ALIGNED else 0.0
        rows: list[str] = []
        for k, statement in enumerate(statements):
            tag = statement.equation if k == 0 else ""
            rows += self._rows(statement, column, tag)
        return "\\begin{align*}\n  " + " \\\\\n  ".join(rows) + "\n\\end{align*}"

    def _label_width(self, statement: Statement) -> float:
        return 0.0 if statement.label is None else estimate(print_mark(statement.label)) + 20.0

    def _rows(self, statement: Statement, column: float, tag: str) -> list[str]:
        left, right = self.math.side(statement.left), self.math.side(statement.right)
        label = "" if statement.label is None else rf"{print_mark(statement.label)}\colon\quad "
        relation = {"=": "=", "!=": r"\neq"}[statement.relation]
        note = rf"\qquad \text{{({escape(statement.note)})}}" if statement.note else ""
        tail = note + (rf" \tag{{{tag}}}" if tag else "")
        space = _LINE - _TAG - (7.0 * len(statement.note) if statement.note else 0.0)
        if column:
            lines = fill(right, space - column - 14.0, _LINE - _TAG - column - 14.0 - _HANGING)
            head = label + "".join(piece.text for piece in left)
            first = f"{head} &{relation} {lines[0].strip()}{tail}"
            return [first, *(rf"&\quad {line.strip()}" for line in lines[1:])]
        lines = fill(left, space - self._label_width(statement), _LINE - _TAG - _HANGING)
        rows = [f"& {label}{lines[0].strip()}", *(rf"&\quad {line.strip()}" for line in lines[1:])]
        after = fill(right, _LINE - _TAG - _HANGING - 14.0, _LINE - _TAG - 2 * _HANGING)
        if len(lines) == 1 and len(after) == 1 and total(left) + total(right) + 24.0 <= space:
            return [f"{rows[0]} {relation} {after[0].strip()}{tail}"]
        rows[0] += tail
        return [*rows, rf"&\quad {relation} {after[0].strip()}", *(rf"&\qquad {line.strip()}" for line in after[1:])]
