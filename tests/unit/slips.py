"""Slips of students: a spec in which one thing is written as it should not be, and what the help leads to."""

from __future__ import annotations

from functools import cache

from nhc.diagnostics import Diagnostic, Source, SpecError
from nhc.pipeline import check

Slip = tuple[str, str, str, str, str]
"""What stands in the spec, what is written instead, the code, part of the help; what the help says to write in its place."""


@cache
def find(text: str) -> tuple[Diagnostic, ...]:
    """All that is found in a spec."""
    try:
        return check(Source("slip.yaml", text)).diagnostics
    except SpecError as error:
        return error.diagnostics


def assert_helps(spec: str, slip: Slip) -> None:
    """One diagnostic with this code and help, and none of an error once the help is followed."""
    right, wrong, code, help, followed = slip
    assert spec.count(right) == 1
    (found,) = find(spec.replace(right, wrong))
    assert found.code == code and help in found.help[0], found.help
    assert not [later for later in find(spec.replace(right, followed)) if later.code.startswith("E")]
