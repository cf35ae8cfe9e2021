"""Short texts with long consequences: towers of powers, dozens of nested roots."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source, SpecError
from nhc.pipeline import Options, check, emit


def spec(force: str) -> Source:
    text = f'nhc: 1\nsystem: deep\ncoordinates: [x]\nT: "x\'^2/2"\nforces:\n  x: "{force}"\n'
    return Source("deep.yaml", text)


@pytest.mark.parametrize("text", ["(" * 20 + "3" + "^2)" * 20, "((9^999)^999)^999", "(2*x)^1000 * (2^1000)^999"])
def test_long_constants_are_refused(text: str) -> None:
    with pytest.raises(SpecError) as caught:
        check(spec(text))
    assert {d.code for d in caught.value.diagnostics} == {"E0210"}


def test_nested_roots_are_compiled() -> None:
    text = "x"
    for _ in range(50):
        text = f"sqrt(1 + {text})"
    assert any("not decided" in fact for fact in check(spec(text)).facts)
    for language in ("c", "python", "latex"):
        assert emit(spec(text), language, Options())
