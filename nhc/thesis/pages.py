"""The registry as text: the page of one equation, the table of all, the list of errata."""

from __future__ import annotations

from nhc.thesis.entries import Equation
from nhc.thesis.errata import ERRATA
from nhc.thesis.plain import plain
from nhc.thesis.registry import EQUATIONS


def equation_page(number: str) -> str:
    """What ``nhc explain`` prints for a number.

    Raises:
        KeyError: no equation has that number.
    """
    entry = EQUATIONS[number]
    lines = [f"({entry.number}) {entry.about}", "", f"    {plain(entry.latex)}", "", *_status(entry)]
    for name in entry.errata:
        erratum = ERRATA[name]
        lines += [
            "",
            f"in print ({name}, {erratum.place}): {erratum.printed}",
            f"corrected: {erratum.correction}",
            f"evidence: {erratum.evidence} ({erratum.test})",
        ]
    return "\n".join([*lines, "", f"LaTeX: {entry.latex}"])


def erratum_page(number: str) -> str:
    """What ``nhc explain`` prints for an erratum, such as E7.

    Raises:
        KeyError: no erratum has that number.
    """
    erratum = ERRATA[number]
    equations = ", ".join(entry.number for entry in EQUATIONS.values() if number in entry.errata)
    return "\n".join(
        [
            f"erratum {number}: {erratum.title}",
            "",
            f"in print ({erratum.place}): {erratum.printed}",
            f"corrected: {erratum.correction}",
            f"evidence: {erratum.evidence} ({erratum.test})",
            *([f"equations: {equations}"] if equations else []),
        ]
    )


def _status(entry: Equation) -> list[str]:
    lines = [f"implemented by {place}" for place in entry.places]
    if entry.test:
        lines.append(f"shown by {entry.test}")
    if entry.reason:
        lines.append(f"not needed: {entry.reason}" if entry.status == "not needed" else entry.reason)
    return lines


def equation_table() -> str:
    """``docs/thesis/equations.md``."""
    rows = []
    for entry in EQUATIONS.values():
        where = [*(f"`{place.removeprefix('nhc.')}`" for place in entry.places)]
        if entry.test:
            where.append(f"`{entry.test}`")
        if entry.reason:
            where.append(entry.reason)
        errata = ", ".join(f"[{name}](errata.md#{name.lower()})" for name in entry.errata)
        cells = (entry.number, entry.about, f"${entry.latex}$", entry.status, "<br>".join(where), errata)
        rows.append(f"| {' | '.join(cell.replace('|', chr(92) + 'vert ') for cell in cells)} |")
    return "\n".join([_TABLE_HEAD, *rows, ""])


_TABLE_HEAD = """# The thesis's equations

Every number of A. Vigneront, *Formes extérieures en mécanique des systèmes non holonomes* (Namur 1977), with the formula as it
should stand and what nhc does with it. `I.3`, `II.3`, `III.3` and `III.4` stand for the unnumbered final equations of those
sections. Summation and indices as in the text: i, j, k, m = 1..n, r, s, t = 1..n+1, alpha, beta, gamma = 1..l,
mu, nu, sigma = l+1..n.
This file is written from `nhc/thesis/`; `pytest --update tests/thesis` rewrites it.

| number | statement | formula | status | where | errata |
|---|---|---|---|---|---|"""


def errata_page() -> str:
    """``docs/thesis/errata.md``."""
    parts = [_ERRATA_HEAD]
    for erratum in ERRATA.values():
        equations = ", ".join(entry.number for entry in EQUATIONS.values() if erratum.number in entry.errata)
        parts += [
            f'<a id="{erratum.number.lower()}"></a>',
            f"## {erratum.number}: {erratum.title}",
            "",
            f"- place: {erratum.place}" + (f" (equations {equations})" if equations else ""),
            f"- printed: {erratum.printed}",
            f"- correction: {erratum.correction}",
            f"- evidence: {erratum.evidence}",
            f"- test: `{erratum.test}`",
            "",
        ]
    return "\n".join(parts)


_ERRATA_HEAD = """# Errata

What does not hold as it stands in the available text of the thesis, whether by a slip of the mathematics, the pen or the scan.
Each entry has a test that builds the printed formula with nhc's own graph and forms, and shows on systems of the gallery that it
disagrees with Lagrange's equations with multipliers (or with an exact identity) where the corrected one agrees. The wrong variants
themselves are kept in `nhc/mechanics/certificates/wrong.py`. This file is written from `nhc/thesis/errata.py`;
`pytest --update tests/thesis` rewrites it.
"""
