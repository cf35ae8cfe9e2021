"""What Newton's form of the equations asks of a system: each hypothesis with the reason that names it."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source, SpecError
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.formulations.newton import broken_hypotheses
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System

COUPLED = ["the kinetic energy couples `x'` to another velocity", "the kinetic energy couples `y'` to another velocity"]


def make(energy: str, more: str = "") -> System:
    text = f"nhc: 1\nsystem: s\ncoordinates: [x, y]\nparameters: {{m: 2, k: 0.5}}\nT: {energy}\n{more}"
    return resolve(decode(Source("s.yaml", text)))


@pytest.mark.parametrize(
    ("energy", "reasons"),
    [
        ("m*x'^2/2 + y'^2/2", []),
        ("m*x'^2/2 + y'^2/2 + k", []),
        ("m*x'^2/2 + y'^2/2 + k*x'*y'", COUPLED),
        ("m*x'^2/2 + (1 + x^2)*y'^2/2", ["the inertia of `y` is not constant"]),
        ("m*x'^2/2 + exp(t)*y'^2/2", ["the inertia of `y` is not constant"]),
        ("m*x'^2/2 + y'^4", ["the inertia of `y` is not constant"]),
        ("m*x'^2/2 + y'^2/2 + k*x'", ["T is not homogeneous quadratic in `x'`"]),
        ("m*x'^2/2 + y'^2/2 + k*y*x'", ["T is not homogeneous quadratic in `x'`"]),
        ("m*(x'^2 + y'^2)/2 + x*y' - y*x'", [f"T is not homogeneous quadratic in `{name}'`" for name in "xy"]),
    ],
)
def test_newton_s_equations_want_free_particles_of_constant_mass(energy: str, reasons: list[str]) -> None:
    system = make(energy)
    assert broken_hypotheses(system) == reasons
    if reasons:
        with pytest.raises(SpecError):
            formulate(system, "newton")
    else:
        assert equations_of(system, formulate(system, "newton")).formulation == "newton"


def test_it_knows_no_constraint() -> None:
    assert broken_hypotheses(make("x'^2/2 + y'^2/2", "constraints: [x' = y']\n")) == [
        "the system has 1 constraint; Newton's equations (II.1) are for free points"
    ]
