"""Scenes whose coordinates follow from one another: the smaller model moves like the whole one."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from tests.support import python_model

SPEC = """nhc: 1
system: mutual
coordinates: [x, y, z]
T: x'^2/2 + y'^2/2 + z'^2/2
V: {potential}
holonomic: ["{holonomic}"]
constraints: ["{constraint}"]
scenes: {{go: {{time: [0, 1], initial: {{x': 1}}, need: [x, y]}}}}
"""
CASES = [
    ("y + x^2*z/2", "y = x^2", "z' = x*x' + t"),
    ("z*y", "z = y*t", "y' = x*x'"),
    ("z*y", "y = x^2 + t*z", "z' = x*x'"),
]


def steps(module: object, count: int, y: list[float]) -> list[float]:
    """Runge and Kutta's method with steps of 1/count."""
    rhs, h = module.rhs, 1.0 / count  # type: ignore[attr-defined]
    for k in range(count):
        t = k * h
        a = rhs(t, y)
        b = rhs(t + h / 2, [u + h / 2 * s for u, s in zip(y, a, strict=True)])
        c = rhs(t + h / 2, [u + h / 2 * s for u, s in zip(y, b, strict=True)])
        d = rhs(t + h, [u + h * s for u, s in zip(y, c, strict=True)])
        y = [u + h / 6 * (p + 2 * q + 2 * r + s) for u, p, q, r, s in zip(y, a, b, c, d, strict=True)]
    return y


@pytest.mark.parametrize(("potential", "holonomic", "constraint"), CASES)
def test_the_scene_model_moves_like_the_whole(potential: str, holonomic: str, constraint: str) -> None:
    text = SPEC.format(potential=potential, holonomic=holonomic, constraint=constraint)
    source = Source("mutual.yaml", text)
    small = python_model(emit(source, "python", Options(scene="go"))["mutual.py"], "small")
    whole = python_model(emit(source, "python", Options("multipliers"))["mutual.py"], "whole")
    state = {"x'": 1.0}  # at x = 0 and t = 0 the constraints leave the other velocities zero
    end = steps(whole, 400, [state.get(name, 0.0) for name in whole.STATE])
    seen = dict(zip(whole.STATE, end, strict=True))
    kept = steps(small, 400, [state.get(name, 0.0) for name in small.STATE])
    assert len(small.STATE) < len(whole.STATE)
    for name, value in zip(small.OUTPUTS, small.outputs(1.0, kept), strict=True):
        assert value == pytest.approx(seen[name], abs=1e-8)
