"""Units of what is sound in a spec: where it has other mistakes, what does not fit is told together with these."""

from __future__ import annotations

from nhc.diagnostics import Bag, Severity
from nhc.language.spec import Spec
from nhc.language.units.check import check_units
from nhc.language.yaml_tree.nodes import Table

_LATE = frozenset(
    (
        *("nhc", "system", "about", "source", "formulation", "dependent"),
        *("T", "U", "V", "forces", "constraints", "holonomic", "outputs", "draw", "scenes"),
    )
)
"""Keys under which nothing is declared that has a unit of its own: a mistake there leaves those of other parts known."""


def check_sound_units(spec: Spec, written: Table, bag: Bag) -> None:
    """Report units that do not fit (E0413) in expressions without a mistake, if all mistakes so far are outside declarations."""
    broken = [diagnostic.span for diagnostic in bag.diagnostics if diagnostic.severity is Severity.ERROR]
    keys = sorted((text.span.start, text.value) for text, _ in written.entries)
    if broken and any(name == "extends" for _, name in keys):
        return  # a base may declare anything, at places of its own
    for span in broken:
        section = [name for start, name in keys if start <= span.start]
        if not section or section[-1] not in _LATE:
            return
    check_units(spec, bag, broken)
