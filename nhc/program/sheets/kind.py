"""What kind of system it is: the findings of ``nhc check --explain`` that a reader of the derivation wants."""

from __future__ import annotations

from nhc.diagnostics import Bag
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.properties.facts import describe
from nhc.mechanics.resolve import resolve
from nhc.program.sheets.draft import Desk, DraftSheet

_MOST = 6  # coordinates; beyond that the search takes longer than the derivation
_OMITTED = ("degrees", "applicable", "formulation")


def kind_sheet(desk: Desk) -> DraftSheet | None:
    """The facts, a paragraph each; nothing for systems without constraints that are plainly Lagrangian."""
    system = desk.system
    sheet = DraftSheet("kind", "What kind of system this is")
    if system.n > _MOST:
        sheet.say(f"`nhc check --explain` classifies the constraints; with {system.n} coordinates that takes its time.")
        return sheet
    # the search makes nodes (and names for them) of its own: it gets a graph of its own
    fresh = resolve(system.spec)
    facts = describe(fresh, formulate(fresh, desk.formulation.name), Bag(system.spec.origin))
    keys = [key for key in facts.lines_by_key if key not in _OMITTED]
    for key in keys:
        line = facts.lines_by_key[key]
        sheet.say(line[:1].upper() + line[1:] + ("" if line.endswith(".") else "."))
    return sheet
