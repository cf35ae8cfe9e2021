"""What a derivation on paper is made of; the printers of text and LaTeX read nothing else.

Supported: prose, tables, general formulas as the thesis prints them, and statements ``left = right`` whose sides are sums of
coefficients times basis elements.
Not supported, on purpose: graph nodes, simplification, decisions about what to show.
"""

from __future__ import annotations

from collections.abc import Mapping

from nhc.mechanics.system import System
from nhc.program.ir import Expr
from nhc.records import record

LATIN = {
    "Alpha": "A",
    "Beta": "B",
    "Epsilon": "E",
    "Zeta": "Z",
    "Eta": "H",
    "Iota": "I",
    "Kappa": "K",
    "Mu": "M",
    "Nu": "N",
}
LATIN |= {"Omicron": "O", "Rho": "P", "Tau": "T", "Chi": "X", "omicron": "o"}
"""Greek letters that look like Latin ones."""

OTHER = "!"
"""Ends the base of a symbol of the theory that takes another shape, for a name of the spec has its own."""


@record
class Mark:
    """A symbol: ``base`` and indices are names of the spec or of the thesis ("theta", "gamma"); ``prefix`` is "d" or "".

    ``dots`` counts time derivatives; ``star`` says that the constraints have been used, ``at`` is an argument, "(X)".
    """

    base: str
    lower: tuple[str, ...] = ()
    upper: tuple[str, ...] = ()
    dots: int = 0
    prefix: str = ""
    star: bool = False
    at: str = ""


@record
class Term:
    """``coefficient`` times the wedge of ``factors`` (one factor: a basis form or a rate; none: the coefficient alone)."""

    coefficient: Expr
    factors: tuple[Mark, ...] = ()


Side = tuple[Term, ...]
"""A sum; the empty one is zero."""


@record
class Statement:
    """``left relation right`` with the thesis's number, the place in the spec and a note.

    ``label`` heads the line (the basis form whose row it is).
    """

    left: Side
    right: Side
    relation: str = "="
    equation: str = ""
    place: str = ""
    note: str = ""
    label: Mark | None = None


@record
class Formula:
    """A general formula in both spellings."""

    text: str
    latex: str
    equation: str = ""


@record
class Prose:
    """A sentence; what stands between back-ticks is a name of the spec, what stands between dollar signs an expression.

    ``plain`` is without the dollar signs.
    """

    text: str

    @property
    def plain(self) -> str:
        return self.text.replace("$", "")


@record
class Table:
    """Rows of cells: a mark, or text."""

    head: tuple[str, ...]
    rows: tuple[tuple[str | Mark, ...], ...]


Item = Statement | Formula | Prose | Table


@record
class Sheet:
    """One section; ``lets`` are the abbreviations that its items use and no earlier sheet has introduced."""

    key: str
    title: str
    lets: tuple[Statement, ...]
    items: tuple[Item, ...]

    @property
    def lets_at(self) -> int:
        """The item before which the abbreviations stand: the sentence of the first statement."""
        first = next((k for k, item in enumerate(self.items) if isinstance(item, Statement)), 0)
        return first - 1 if first and isinstance(self.items[first - 1], Prose) else first


RANK_STEP = 1000
"""Between the ranks of two kinds of symbols; within a kind the spec's order counts."""


@record
class Symbol:
    """How a name of the expressions is written; factors of a product are sorted by ``rank``."""

    mark: Mark
    rank: int


@record
class Derivation:
    """``symbols`` knows every name that stands in an expression; ``lets`` finds an abbreviation by its name."""

    system: System
    formulation: str
    equation: str
    sheets: tuple[Sheet, ...]
    symbols: Mapping[str, Symbol]
    lets: Mapping[str, Statement]
