"""The document: sections of prose, tables and aligned displays, with the thesis's numbers as tags."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby

from nhc.emit.environment import create_environment
from nhc.emit.latex.inline import print_inline
from nhc.emit.latex.math import LatexMath
from nhc.emit.latex.names import name_document
from nhc.emit.latex.spelling import count_shown, escape, escape_breakable, spell_unit, spell_value, split_shown
from nhc.emit.latex.width import estimate, widest_group
from nhc.emit.layout import Piece, fill, total
from nhc.emit.prose import clean, fold_ascii, wrap
from nhc.program.sheets.model import Derivation, Formula, Item, Mark, Prose, Sheet, Statement, Table
from nhc.records import record
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

TEMPLATE = "latex/derivation.tex.jinja"
_LINE = 440.0  # points between the margins, less a little
_TAG = 52.0  # a tag and the space before it
_HANGING = 24.0
_ZERO = 24.0  # the end "= 0" of a row
_MOST_ROWS = 40  # of a table on one page
_LONG_NOTE, _LONG_PHRASE = 100.0, 320.0  # points of a name or a sentence beside a formula
_PARAGRAPH = 40  # characters that may make another line of a cell
_PHRASE = 65  # of a sentence below a formula
_LONG_NAME, _LONG_FORMULA = 15, 250  # letters of a name and of a formula in a sentence that leave no good end of a line
_WIDE_GROUP = 60.0  # points of a part of such a formula within which no line ends
_LONG_CELL = 55  # characters from which a column is set as a paragraph
_LINE_CELLS = 75  # characters of all columns
_SHORT_MARK, _CHARACTER, _WIDE_CHARACTER = 40.0, 5.0, 6.0  # points
_ALIGNED = 120.0  # widest left side that is aligned at its relation


@record
class Section:
    """A section of the document, as the template places it: its title and its paragraphs as LaTeX."""

    title: str
    paragraphs: tuple[str, ...]


@record
class _Block:
    """A sentence (``opens``: it starts a paragraph unless it follows another) or what belongs to the one before."""

    text: str
    opens: bool = False


def _paragraphs(blocks: Sequence[_Block]) -> tuple[str, ...]:
    """A sentence with its displays is one paragraph, so that no blank line stands before a display."""
    found: list[list[str]] = []
    for block in blocks:
        if block.opens or not found:
            found.append([])
        found[-1].append(block.text)
    return tuple("\n".join(paragraph) for paragraph in found)


def _kind(item: Item) -> str:
    """Neighbours of the same kind are printed together."""
    match item:
        case Statement():
            return f"statement {item.equation}"
        case Prose():
            return "point" if item.text.startswith("- ") else "prose"
        case Formula():
            return "formula"
        case Table():
            return "table"


def render(derivation: Derivation) -> str:
    """The document's text, not yet stamped."""
    return create_environment().get_template(TEMPLATE).render(list_context(derivation))


def list_context(derivation: Derivation) -> dict[str, object]:
    """Exactly what the template may use."""
    spec = derivation.system.spec
    sources = escape_breakable("; ".join(clean(source) for source in spec.sources))
    printer = _Printer(derivation)
    return {
        "comment": (
            f"{spec.system}: equations of motion, written by nhc {__version__}",
            f"{PLACEHOLDER} edit the spec, not this file",
            f"formulation: {derivation.formulation} ({fold_ascii(derivation.equation)})",
        ),
        "title": escape_breakable(clean(spec.system.replace("_", " ").capitalize())),
        "about": escape_breakable(clean(spec.about)),
        "sources": sources,
        "names": printer.names_apart(),
        "loose": any(count_shown(name) > _LONG_NAME for name in printer.spelling.names)
        or printer.is_wordy(derivation.sheets),
        "sections": tuple(printer.section(sheet) for sheet in derivation.sheets),
    }


class _Printer:
    """Prints the sheets of one derivation."""

    def __init__(self, derivation: Derivation) -> None:
        self.spelling = name_document(derivation)
        self.math = LatexMath(derivation.symbols, self.spelling)
        system = derivation.system
        self.names = {*system.q_names, *(p.name for p in system.spec.parameters)}
        self.placed = {body.name for body in system.spec.bodies} | {point.name for point in system.spec.points}
        self.constraints = {form.name for form in system.constraints}
        self.names |= {f"{name}{dots}" for name in system.q_names for dots in ("'", "''")}

    def section(self, sheet: Sheet) -> Section:
        blocks = self._blocks(sheet.items[: sheet.lets_at])
        if sheet.lets:
            blocks += [_Block("With the abbreviations", True), _Block(self._aligned(sheet.lets))]
        blocks += self._blocks(sheet.items[sheet.lets_at :])
        return Section(escape(sheet.title), _paragraphs(blocks))

    def names_apart(self) -> tuple[str, ...]:
        """How the names are set that would look like others, or would fill a line."""
        rows = tuple((Mark(name), name) for name in self.spelling.listed)
        return tuple(self._tables(Table(("written", "name in the spec"), rows))) if rows else ()

    def is_wordy(self, sheets: Sequence[Sheet]) -> bool:
        """Whether a sentence holds a formula of several lines, or one with a part that is no small part of a line."""
        texts = [item.text for sheet in sheets for item in sheet.items if isinstance(item, Prose)]
        formulas = {formula for text in texts for formula in re.findall(r"\$([^$]*)\$", text)}
        return any(
            len(x) > _LONG_FORMULA or widest_group(print_inline(x, self.spelling)) > _WIDE_GROUP for x in formulas
        )

    def _blocks(self, items: Sequence[Item]) -> list[_Block]:
        """Statements of one number are one display, points of a list one list."""
        blocks: list[_Block] = []
        for kind, run in groupby(items, _kind):
            members = list(run)
            if kind == "point":
                points = "\n".join(rf"\item {self._prose(m.text[2:])}" for m in members if isinstance(m, Prose))
                blocks.append(_Block(f"\\begin{{itemize}}\n{points}\n\\end{{itemize}}"))
                continue
            if isinstance(members[0], Statement):
                blocks.append(_Block(self._aligned([m for m in members if isinstance(m, Statement)])))
                continue
            for member in members:
                match member:
                    case Prose():
                        blocks.append(_Block(self._prose(member.text), True))
                    case Formula():
                        blocks.append(_Block(self._formula(member)))
                    case Table():
                        blocks += [_Block(part, True) for part in self._tables(member)]
        return blocks

    # --- prose and tables -------------------------------------------------------------------------------------

    def _prose(self, text: str) -> str:
        """Expressions between dollar signs and names of quantities between back-ticks are set as math, other names as words."""
        pieces = re.split(r"(`[^`]*`|\$[^$]*\$)", clean(text))
        return "".join(self._marked(part) if k % 2 else escape_breakable(part) for k, part in enumerate(pieces))

    def _marked(self, part: str) -> str:
        return print_inline(part[1:-1], self.spelling) if part[0] == "$" else self._name(part[1:-1])

    def _name(self, name: str) -> str:
        if name not in self.names:
            own = "" if name in self.placed else self._constraint(name)
            return own or rf"\emph{{{escape(name)}}}"
        bare = name.rstrip("'")
        return f"${self.spelling.print_mark(Mark(bare, dots=len(name) - len(bare)))}$"

    def _constraint(self, name: str) -> str:
        """The name of a constraint as it stands at forms, momenta and reactions; empty where it is none, or long."""
        shown = self.spelling.print_index(name) if name in self.constraints else ""
        return f"${shown}$" if shown and estimate(shown) <= _LONG_NOTE else ""

    def _tables(self, table: Table) -> list[str]:
        """The table in parts that fit a page."""
        parts: list[list[tuple[str | Mark, ...]]] = [[]]
        height = 0
        for row in table.rows:
            own = max(1 + self._length(cell) // _PARAGRAPH for cell in row)
            if height + own > _MOST_ROWS and parts[-1]:
                parts.append([])
                height = 0
            parts[-1].append(row)
            height += own
        return [self._table(table.head, part) for part in parts]

    def _table(self, head: tuple[str, ...], rows: Sequence[tuple[str | Mark, ...]]) -> str:
        columns = _columns([max(self._length(row[k]) for row in rows) for k in range(len(head))])
        lines = [rf"\begin{{tabular}}{{@{{\qquad}}{''.join(columns)}@{{}}}}"]
        lines.append(" & ".join(rf"\emph{{{escape(title)}}}" for title in head) + r" \\")
        for row in rows:
            cells = [self._cell(cell, title) for cell, title in zip(row, head, strict=True)]
            lines.append(" & ".join(cells) + r" \\")
        return "\n".join([*lines, r"\end{tabular}"])

    def _cell(self, cell: str | Mark, title: str) -> str:
        if isinstance(cell, Mark):
            return f"${self.spelling.print_mark(cell)}$"
        if title == "unit":
            return spell_unit(cell)
        return spell_value(cell) if title == "value" else escape_breakable(clean(cell))

    def _length(self, cell: str | Mark) -> int:
        """Of a cell, in characters; symbols and short words are one."""
        if isinstance(cell, str):
            return max(count_shown(cell), round(estimate(escape(cell)) / _WIDE_CHARACTER))
        width = estimate(self.spelling.print_mark(cell))
        return 1 if width <= _SHORT_MARK else round(width / _CHARACTER)

    # --- displays ---------------------------------------------------------------------------------------------

    def _formula(self, formula: Formula) -> str:
        tag = rf" \tag{{{formula.equation}}}" if formula.equation else ""
        environment = "equation" if tag else "equation*"
        return f"\\begin{{{environment}}}\n  {formula.latex}{tag}\n\\end{{{environment}}}"

    def _aligned(self, statements: Sequence[Statement]) -> str:
        """One block, its tag on the first line; aligned at the relations where the left sides are short."""
        lefts = [self.math.side(s.left) for s in statements]
        widths = [total(left) + self._label_width(s) for left, s in zip(lefts, statements, strict=True)]
        column = max(widths) if max(widths) <= _ALIGNED else 0.0
        rows: list[str] = []
        for k, statement in enumerate(statements):
            tag = statement.equation if k == 0 else ""
            rows += self._rows(statement, lefts[k], column, tag)
        return "\\begin{align*}\n  " + " \\\\\n  ".join(rows) + "\n\\end{align*}"

    def _label_width(self, statement: Statement) -> float:
        return 0.0 if statement.label is None else estimate(self.spelling.print_mark(statement.label)) + 20.0

    def _rows(self, statement: Statement, left: list[Piece], column: float, tag: str) -> list[str]:
        right = self.math.side(statement.right)
        label = "" if statement.label is None else rf"{self.spelling.print_mark(statement.label)}\colon\quad "
        relation = {"=": "=", "!=": r"\neq"}[statement.relation]
        wide = max(7.0 * len(statement.note), estimate(escape(statement.note)))
        phrase = " " in statement.note
        beside = not phrase or total(right) <= _LINE - _TAG - wide - column - 14.0
        if wide > (_LONG_PHRASE if phrase else _LONG_NOTE) or not beside:
            rows = self._rows(replace(statement, note=""), left, column, tag)
            lines = wrap(clean(f"({statement.note})"), _PHRASE) if phrase else [f"({statement.note})"]
            parts = [part for line in lines for part in split_shown(line, _PHRASE if phrase else _PARAGRAPH)]
            return rows + [rf"&\quad \text{{{part}}}" for part in parts]
        shown = self._constraint(statement.note) or escape(statement.note)
        note = rf"\qquad \text{{({shown})}}" if shown else ""
        tail = note + (rf" \tag{{{tag}}}" if tag else "")
        space = _LINE - _TAG - wide
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
        if not statement.right and len(lines) > 1 and estimate(lines[-1]) + _ZERO <= _LINE - _TAG - _HANGING:
            return [*rows[:-1], f"{rows[-1]} {relation} {after[0].strip()}"]
        return [*rows, rf"&\quad {relation} {after[0].strip()}", *(rf"&\qquad {line.strip()}" for line in after[1:])]


def _columns(lengths: Sequence[int]) -> list[str]:
    """As wide as their cells, but for those that are set as paragraphs: the long ones, and the longest until the line holds all."""
    long = {k for k, length in enumerate(lengths) if length > _LONG_CELL}
    by_length = sorted(range(len(lengths)), key=lambda k: -lengths[k])
    for k in by_length:
        if sum(length for j, length in enumerate(lengths) if j not in long) > _LINE_CELLS - _LONG_CELL // 2 * len(long):
            long.add(k)
    others = sum(length for k, length in enumerate(lengths) if k not in long)
    share = 0.85 - 0.012 * others
    width = max(0.3, min(0.55, share)) if len(long) == 1 else share / max(1, len(long))
    return [rf"p{{{width:.2f}\linewidth}}" if k in long else "l" for k in range(len(lengths))]
