"""What is said of an expression that has no value at a state."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.regular.undefined import find_undefined
from nhc.mechanics.resolving.resolve import resolve


@pytest.mark.parametrize(
    ("potential", "wanted"),
    [
        ("0.1/cosh(1000*x)^2", "`cosh(1000*x)` is larger than a double can be (1.8e308)"),
        ("exp(800*x)", "`exp(800*x)` is larger than a double can be (1.8e308)"),
        ("sqrt(1 - x)", "`sqrt(1 - x)` has no real, finite value"),
        ("log(x - 5)", "`log(x - 5)` has no real, finite value"),
        ("x^2", ""),
    ],
)
def test_what_is_too_large_is_told_apart(potential: str, wanted: str) -> None:
    system = resolve(decode(Source("one.yaml", f"nhc: 1\nsystem: one\ncoordinates: [x]\nT: x'^2/2\nV: {potential}\n")))
    found, part = find_undefined(system, {system.t: 0.0, system.q[0]: 5.0, system.v[0]: 0.0})
    assert found == wanted and (part is None) == (wanted == "")
