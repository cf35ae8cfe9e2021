"""Emitted Python and C against the reference accelerations, reactions and energies, in every formulation that applies."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.support import c_model, cases, emitted_python, error, reference

POINTWISE = {entry["system"]: entry["states"] for entry in reference("pointwise")}
CASES = cases(sorted(POINTWISE))
TOLERANCE = 1e-10


def states(name: str) -> list[tuple[float, list[float], list[float], dict[str, Any]]]:
    return [(float(s["t"]), [float(x) for x in s["q"]], [float(x) for x in s["v"]], s) for s in POINTWISE[name]]


@pytest.mark.parametrize(("name", "formulation"), CASES)
def test_python_reproduces_the_reference(name: str, formulation: str) -> None:
    model = emitted_python(name, formulation)
    for t, q, v, expected in states(name):
        y = model.state(t, q, v)
        assert error(model.velocities(t, y), v) < TOLERANCE
        assert error(model.accelerations(t, y), expected["qdd"]) < TOLERANCE
        assert error(model.reactions(t, y), expected["lam"]) < TOLERANCE
        assert error([model.energy(t, y)], [float(expected["T"]) - float(expected["U"])]) < TOLERANCE
        assert error(model.residuals(t, q, v), [0.0] * len(model.CONSTRAINTS)) < TOLERANCE


@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "formulation"), CASES)
def test_c_reproduces_the_reference_and_python(name: str, formulation: str, tmp_path: Path) -> None:
    python, c = emitted_python(name, formulation), c_model(name, formulation, tmp_path)
    n, size, l = len(python.COORDINATES), len(python.STATE), len(python.CONSTRAINTS)  # noqa: E741
    p = c.defaults(len(python.PARAMETERS))
    assert p == list(python.DEFAULTS)
    for t, q, v, expected in states(name):
        y = c("state", size, t, q, v, p)
        assert error(c("accelerations", n, t, y, p), expected["qdd"]) < TOLERANCE
        assert error(c("reactions", l, t, y, p), expected["lam"]) < TOLERANCE
        assert error([c.energy(t, y, p)], [float(expected["T"]) - float(expected["U"])]) < TOLERANCE
        assert error(c("rhs", size, t, y, p), python.rhs(t, y)) < 1e-12
        assert error(c("velocities", n, t, y, p), python.velocities(t, y)) < 1e-13
        assert error(c("outputs", len(python.OUTPUTS), t, y, p), python.outputs(t, y)) < 1e-12
        flat = [x for row in python.jacobian(t, y) for x in row]
        assert error(c("jacobian", size * size, t, y, p), flat) < 1e-11


@pytest.mark.parametrize(("name", "formulation"), CASES)
def test_the_jacobian_is_the_derivative_of_the_right_hand_side(name: str, formulation: str) -> None:
    model = emitted_python(name, formulation)
    t, q, v, _ = states(name)[0]
    y = model.state(t, q, v)
    rows = model.jacobian(t, y)
    scale = max([1.0, *(abs(x) for row in rows for x in row)])
    for j in range(len(y)):
        h = 1e-6 * max(1.0, abs(y[j]))
        up, down = list(y), list(y)
        up[j] += h
        down[j] -= h
        slope = [(a - b) / (up[j] - down[j]) for a, b in zip(model.rhs(t, up), model.rhs(t, down), strict=True)]
        assert (
            max(abs(a - row[j]) for a, row in zip(slope, rows, strict=True)) < 2e-7 * scale * max(1.0, abs(y[j])) + 1e-6
        )
