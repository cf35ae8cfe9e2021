"""What is said where a formulation does not apply."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.diagnostics import Bag, Span
from nhc.mechanics.system import System


class NotApplicable(Exception):
    """The formulation does not apply; ``reasons`` say why, ``where`` is the place to look at."""

    def __init__(self, formulation: str, reasons: Iterable[str], code: str = "E0411", key: str = "constraints") -> None:
        self.formulation, self.reasons, self.code, self.key = formulation, tuple(reasons), code, key
        super().__init__(formulation, self.reasons)


def refuse(system: System, error: NotApplicable, place: Span) -> None:
    """Raise the diagnostic; ``place`` is where a formulation that does not apply (E0411) is said."""
    bag = Bag(system.spec.origin)
    general = error.code == "E0411"
    bag.error(
        error.code,
        f"`{error.formulation}` does not apply to this system" if general else error.reasons[0],
        place if general else system.spec.key_span(error.key),
        notes=error.reasons if general else error.reasons[1:],
        help=(_help(system, error),),
    )
    bag.raise_if_errors()


def _help(system: System, error: NotApplicable) -> str:
    if error.code == "E0406":
        return "give forms that are independent of each other and of the constraints, or fewer: nhc completes them"
    if error.code == "E0407":
        return "choose other dependent velocities, or leave `dependent:` out: nhc chooses them"
    if error.formulation in ("newton", "lagrange"):
        return "use `formulation: multipliers`, or leave it out"
    if not system.constraints:
        return "use `formulation: lagrange` or `euler-lagrange`, or leave it out"
    return "use `formulation: voronec` or `euler-lagrange`, or leave it out"
