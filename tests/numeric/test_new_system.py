"""A system outside the gallery, as a new user writes it: two skates joined by a hinge, with a spring and a motor."""

from __future__ import annotations

import math
import subprocess
from functools import cache
from pathlib import Path

import pytest
from scipy.integrate import solve_ivp

from nhc.language import decode, read
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, check, emit
from tests.support import compile_c, error, python_model

SPEC = str(Path(__file__).resolve().parents[1] / "specs" / "two_skates.yaml")
REGULAR = ("multipliers", "euler-lagrange", "voronec")  # on the way of its scene
FORMULATIONS = (*REGULAR, "chaplygin")
Q, V = [0.3, -0.2, 0.7, 0.4], [0.9, 0.35]


def consistent(model: object) -> list[float]:
    """q' with x' and y' given and the turning rates from the constraints, by one Newton step on their linear residuals."""
    start = [*V, 0.0, 0.0]
    zero = model.residuals(0.0, Q, start)  # type: ignore[attr-defined]
    slopes = [
        [b - a for a, b in zip(zero, model.residuals(0.0, Q, [*V, *unit]), strict=True)]  # type: ignore[attr-defined]
        for unit in ((1.0, 0.0), (0.0, 1.0))
    ]
    (a, c), (b, d) = slopes
    det = a * d - b * c
    return [*V, (-zero[0] * d + zero[1] * b) / det, (-zero[1] * a + zero[0] * c) / det]


def test_it_has_no_warnings_and_the_certificate_holds() -> None:
    source = read(SPEC)
    assert check(source).diagnostics == ()
    certificate = certify(resolve(decode(source)))
    assert certificate.holds
    assert {agreement.name for agreement in certificate.agreements} == set(FORMULATIONS)


def test_the_formulations_agree() -> None:
    found = []
    for formulation in FORMULATIONS:
        (text,) = emit(read(SPEC), "python", Options(formulation=formulation)).values()
        model = python_model(text, f"two_skates_{formulation.replace('-', '_')}")
        v = consistent(model)
        y = model.state(0.6, Q, v)
        found.append((model.accelerations(0.6, y), model.reactions(0.6, y), [model.energy(0.6, y)]))
    for other in found[1:]:
        for mine, theirs in zip(other, found[0], strict=True):
            assert error(mine, theirs) < 1e-12


@pytest.mark.parametrize("formulation", REGULAR)
def test_its_c_compiles_and_runs(formulation: str, tmp_path: Path) -> None:
    files = emit(read(SPEC), "c", Options(formulation=formulation, driver=True))
    program = compile_c(files, tmp_path, "two_skates", ("-O2",), library=False)
    done = subprocess.run([program, "go", "3", "1e-12"], capture_output=True, text=True, check=True)
    last = [float(x) for x in done.stdout.splitlines()[-1].split(",")]
    assert error(last, [5.0, *by_scipy()]) < 1e-10


@cache
def by_scipy() -> tuple[float, ...]:
    """x, y, the hinge's angle and the energy at the end: multipliers in Python, integrated by somebody else's code."""
    (text,) = emit(read(SPEC), "python", Options(formulation="multipliers")).values()
    model = python_model(text, "two_skates_scipy")
    start, turned = [0.0, 0.0, 0.2, -0.1], [1.0, 0.0]
    # the scene gives x' and leaves y' to its independent value, zero
    alpha, beta = start[2], start[3]
    v = [*turned, math.sin(alpha) * turned[0] / 0.4, -math.sin(beta) * turned[0] / 0.5]
    run = solve_ivp(model.rhs, (0.0, 5.0), model.state(0.0, start, v), method="DOP853", rtol=2.3e-14, atol=1e-14)
    end = list(run.y[:, -1])
    return (end[0], end[1], end[2] - end[3], model.energy(5.0, end))
