"""What the registry records of an equation and of an erratum."""

from __future__ import annotations

from nhc.records import record


@record
class Equation:
    """One number of the thesis.

    ``latex`` is the corrected formula.  ``places`` are the functions that implement it, ``test`` is one that shows it,
    ``reason`` says why neither is needed; at least one of the three is given.  ``errata`` are the numbers of what is wrong in
    print.
    """

    number: str
    about: str
    latex: str
    places: tuple[str, ...] = ()
    test: str = ""
    reason: str = ""
    errata: tuple[str, ...] = ()

    @property
    def status(self) -> str:
        """One of implemented, shown, not needed."""
        if self.places:
            return "implemented"
        return "shown" if self.test else "not needed"


@record
class Erratum:
    """One erratum: ``evidence`` is what the test ``test`` computes and asserts."""

    number: str
    title: str
    place: str
    printed: str
    correction: str
    evidence: str
    test: str
