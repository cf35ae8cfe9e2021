"""Every bad spec carries the diagnostics that it must give, in its first lines, and gives no others."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
import yaml

from nhc.diagnostics import Source, SpecError, codes, render_text
from nhc.language import decode, read
from nhc.language.yaml_tree import reader

BAD = sorted((Path(__file__).resolve().parents[1] / "bad").glob("*.yaml"))
EXPECTED = re.compile(r"# expect: ([EW]\d{4}) (\d+):(\d+) (.+)")
ELSEWHERE = {"E0101", "E0103", "E0112"}  # of files that cannot be kept here; see test_language_reading, test_extends


def expectations(path: Path) -> list[tuple[str, int, int, str]]:
    found = []
    for line in path.read_text(encoding="utf-8").split("\n"):
        match = EXPECTED.fullmatch(line)
        if not match:
            break
        found.append((match.group(1), int(match.group(2)), int(match.group(3)), match.group(4)))
    return found


def diagnose(source: Source) -> list[tuple[str, int, int, str]]:
    try:
        decode(source)
    except SpecError as error:
        assert render_text(source, error.diagnostics)
        assert all(found.help for found in error.diagnostics), "every diagnostic says what to do"
        return [(found.code, *source.position(found.span.start), found.message) for found in error.diagnostics]
    return []


def test_there_are_enough() -> None:
    assert len(BAD) >= 40


@pytest.mark.parametrize("path", BAD, ids=lambda path: path.stem)
def test_a_bad_spec_gets_the_messages_that_stand_in_it(path: Path) -> None:
    expected = expectations(path)
    assert expected, "a bad spec starts with what is expected of it"
    found = diagnose(read(path))
    assert [item[:3] for item in found] == [item[:3] for item in expected]
    for (*_, message), (*_, start) in zip(found, expected, strict=True):
        assert message.startswith(start)


def test_every_code_of_this_floor_is_met() -> None:
    met = {code for path in BAD for code, *_ in expectations(path)}
    assert {code for code in codes() if code[1:3] in ("01", "02", "03")} - met == ELSEWHERE
    assert {"E0413", "E0414", "E0417", "E0418", "E0419"} <= met


@pytest.mark.parametrize("path", BAD, ids=lambda path: path.stem)
def test_the_same_without_libyaml(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    source = read(path)
    expected = diagnose(source)
    monkeypatch.setattr(reader, "_FAST", yaml.SafeLoader)
    assert diagnose(source) == expected
