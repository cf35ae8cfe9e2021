"""All equations by number, in the order of the text."""

from __future__ import annotations

from nhc.thesis import chapter1, chapter2, chapter3
from nhc.thesis.entries import Equation

EQUATIONS: dict[str, Equation] = {
    entry.number: entry for chapter in (chapter1, chapter2, chapter3) for entry in chapter.EQUATIONS
}
