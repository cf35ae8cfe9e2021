"""Every spec that is bad as mechanics carries the diagnostics that `nhc check` must give, and gives no others."""

from __future__ import annotations

from pathlib import Path

import pytest

from nhc.diagnostics import Diagnostic, Source, SpecError, render_text
from nhc.language import read
from nhc.pipeline import check
from tests.unit.test_language_bad import expectations

BAD = sorted((Path(__file__).resolve().parents[1] / "bad" / "mechanics").glob("*.yaml"))
CODES = {f"E04{k:02}" for k in (1, 2, 3, 4, 5, 6, 7, 9, 11, 12, 15, 17, 20)} | {
    "W0408",
    "W0410",
    "W0416",
    "W0421",
    "W0422",
}


def diagnose(source: Source) -> tuple[Diagnostic, ...]:
    try:
        return check(source).diagnostics
    except SpecError as error:
        return error.diagnostics


@pytest.mark.parametrize("path", BAD, ids=lambda path: path.stem)
def test_bad_mechanics(path: Path) -> None:
    expected, source = expectations(path), read(path)
    assert expected, "a bad spec starts with what is expected of it"
    found = diagnose(source)
    assert [(d.code, *source.position(d.span.start), d.message) for d in found] == expected
    assert all(d.help for d in found), "every diagnostic says what to do"
    assert render_text(source, found)


def test_every_code_of_the_mechanics_is_met() -> None:
    met = {code for path in BAD for code, *_ in expectations(path)}
    assert met >= CODES
