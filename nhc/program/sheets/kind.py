"""What kind of system it is: the findings of ``nhc check --explain`` that a reader of the derivation wants."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import replace

from nhc.algebra.walks import count
from nhc.diagnostics import Bag
from nhc.language.expressions.unparse import unparse
from nhc.language.scope import names_in
from nhc.language.spec import Spec
from nhc.mechanics.choosing.choose import Formulation, formulate
from nhc.mechanics.frame import coordinate_frame, form_value
from nhc.mechanics.properties.facts import describe
from nhc.mechanics.regular.regularity import judge
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from nhc.program.sheets.draft import Desk, DraftSheet

# beyond both of these the search takes longer than the derivation
_FEW = 6  # coordinates
_BUDGET = 1000  # coordinates times operations of the energies and constraints
_NAME = re.compile(r"[^\W\d]\w*")
_OMITTED = ("degrees", "applicable", "formulation")


def kind_sheet(desk: Desk) -> DraftSheet | None:
    """The facts, a paragraph each; nothing for systems without constraints that are plainly Lagrangian."""
    system = desk.system
    sheet = DraftSheet("kind", "What kind of system this is")
    if system.n > _FEW and system.n * _operations(system) > _BUDGET:
        sheet.say("`nhc check --explain` classifies this system; that takes longer than deriving its equations.")
        return sheet
    # the search makes nodes (and names for them) of its own: it gets a graph of its own
    fresh = resolve(system.spec)
    named = formulate(fresh, desk.formulation.name)
    made = _same_on(fresh, named, desk.formulation)  # another one than by its name: nhc has chosen it
    facts = describe(fresh, made, Bag(system.spec.origin), by_name=made is named)
    keys = [key for key in facts.marked if key not in _OMITTED]
    for key in keys:
        line = facts.marked[key]
        sheet.say(line[:1].upper() + line[1:] + ("" if line.endswith(".") else "."))
    found = (name for name in system.q_names if re.search(rf"\bp_{name}\b", facts.marked.get("conserved", "")))
    momenta = [name for name in found if f"p_{name}" not in system.q_names]
    if momenta:
        first, also = momenta[0], ", and so on" if len(momenta) > 1 else ""
        sheet.say(
            f"Here $p_{first}$ is the momentum of ${first}$, the derivative of $T$ with respect to ${first}'${also}."
        )
    shown = [f"${name} = {text}$" for name, text in _definitions(system.spec, [facts.marked[key] for key in keys])]
    if shown:
        sheet.say(f"Here {', '.join(shown)}, as the spec defines {'it' if len(shown) == 1 else 'them'}.")
    return sheet


def _definitions(spec: Spec, lines: Iterable[str]) -> list[tuple[str, str]]:
    """The definitions that stand in formulas of these lines, and in one another, with their expressions."""
    own = {entry.name: entry.value for entry in spec.definitions if not spec.is_brought(entry.name)}
    wanted = {name for line in lines for part in line.split("$")[1::2] for name in _NAME.findall(part)} & own.keys()
    for name, value in reversed(own.items()):
        if name in wanted:
            wanted |= own.keys() & set(names_in(value))
    return [(name, unparse(value)) for name, value in own.items() if name in wanted]


def _same_on(fresh: System, named: Formulation, formulation: Formulation) -> Formulation:
    """The formulation of a derivation on the same system in another graph, with the dependent velocities that it has."""
    wanted = formulation.dependent
    if wanted is None or named.dependent is None or named.dependent.dependent == wanted.dependent:
        return named
    frame = coordinate_frame(fresh, wanted.dependent)
    return replace(named, frame=frame, dependent=judge(fresh, wanted.dependent), broken=formulation.broken)


def _operations(system: System) -> int:
    """Of the energies and the constraints as the spec has them."""
    return count(system.graph, [system.T, system.U, *(form_value(system, form) for form in system.constraints)])
