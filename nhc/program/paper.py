"""Omega on paper: a formulation's derivation as data that text and LaTeX print alike.

Every coefficient is brought to canonical form where that is small and shorter, tested for zero exactly, and lowered with
abbreviations for what repeats: the output is linear in the graph, whatever the system.  What would fill pages is said in its
factored form.
"""

from __future__ import annotations

from collections.abc import Callable

from nhc.language import Scene
from nhc.mechanics.associate import Equations
from nhc.mechanics.choosing.choose import Formulation
from nhc.mechanics.system import System
from nhc.program.sheets.bodies import explain_names
from nhc.program.sheets.data import add_letters, data_sheet, reason_sheet
from nhc.program.sheets.draft import Desk, DraftSheet
from nhc.program.sheets.forms import energy_sheet, form_sheet, make_forms
from nhc.program.sheets.frames import kinematics_sheet
from nhc.program.sheets.kind import kind_sheet
from nhc.program.sheets.model import Derivation, Formula, Item, Mark, Prose, Sheet, Side, Statement, Symbol, Table, Term
from nhc.program.sheets.motion import associated_sheet, energy_theorem_sheet, motion_sheet, reaction_sheet
from nhc.program.sheets.write import write_sheets

__all__ = [
    "SHEETS",
    "Derivation",
    "Formula",
    "Item",
    "Mark",
    "Prose",
    "Sheet",
    "Side",
    "Statement",
    "Symbol",
    "Table",
    "Term",
    "derivation",
]

SHEETS = ("data", "kind", "formulation", "kinematics", "kinetic", "form", "associated", "motion", "reactions", "energy")
"""The keys of all sheets in their order; a formulation has no sheet for what it does not know."""


def derivation(
    system: System,
    formulation: Formulation,
    equations: Equations,
    scene: Scene | None = None,
    simplify: float = 0.0,
) -> Derivation:
    """The sheets of one derivation, the parameters' values being those of ``scene`` where one is given.

    ``simplify`` gives SymPy that many seconds on what is printed (0: none; the text then is the same on every machine).
    """
    desk = Desk(system, formulation, equations, simplify)
    forms = make_forms(desk)
    makers: tuple[Callable[[], DraftSheet | None], ...] = (
        lambda: data_sheet(desk, scene),
        lambda: kind_sheet(desk),
        lambda: reason_sheet(desk),
        lambda: kinematics_sheet(desk),
        lambda: energy_sheet(desk),
        lambda: form_sheet(desk, forms),
        lambda: associated_sheet(desk, forms),
        lambda: motion_sheet(desk),
        lambda: reaction_sheet(desk),
        lambda: energy_theorem_sheet(desk),
    )
    drafts = [sheet for make in makers if (sheet := make()) is not None]
    add_letters(desk, next(sheet for sheet in drafts if sheet.key == "formulation"))
    sheets, symbols, lets = write_sheets(desk, drafts)
    sheets = explain_names(system.spec, sheets, symbols)
    return Derivation(system, formulation.name, equations.number, sheets, symbols, lets)
