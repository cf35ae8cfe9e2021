"""Equilibria that the search among all states misses, as friction that grows with the speed leads it away."""

from __future__ import annotations

import math

import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, linearize
from nhc.study.linearization import steady as steady_module
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.motion import Findings, Request
from nhc.study.linearization.sweep import Sweep

VAN_DER_POL = """
nhc: 1
system: vdp
coordinates: [x]
parameters: {mu: 1}
T: x'^2/2
V: x^2/2
forces: {x: mu*(1 - x^2)*x'}
"""


def find(text: str, about: str, *settings: str, sweep: tuple[str, float, float, int] | None = None) -> Findings:
    return linearize(Source("spec.yaml", text), Request(about, settings, sweep=sweep), Options())


@pytest.mark.parametrize("about", ["x=2", "x=3", "x=1000", "x=-2, x'=1"])
@pytest.mark.parametrize("mu", [-1.0, 1.0, 100.0])
def test_van_der_pol_has_its_equilibrium_from_anywhere(about: str, mu: float) -> None:
    found = find(VAN_DER_POL, about, f"mu={mu}").linearisation
    assert found.steady.equilibrium and found.steady.y == pytest.approx((0.0, 0.0), abs=1e-12)


def test_friction_alone_leads_away_no_more() -> None:
    text = VAN_DER_POL.replace("mu*(1 - x^2)*x'", "-mu*x^2*x'")
    assert find(text, "x=5", "mu=0.5").linearisation.steady.y == pytest.approx((0.0, 0.0), abs=1e-12)


def test_of_two_equilibria_the_nearer_one_is_taken() -> None:
    text = VAN_DER_POL.replace("V: x^2/2", "V: -cos(x)").replace("1 - x^2", "1 - x^4")
    for turns in (0, 1):
        start = 2 * math.pi * turns + 0.9
        found = find(text, f"x={start}", "mu=50").linearisation.steady
        assert found.y[0] == pytest.approx(2 * math.pi * turns, abs=1e-12)


def test_a_sweep_begins_where_the_search_among_all_states_misses() -> None:
    swept = find(VAN_DER_POL, "x=2", sweep=("mu", -1.0, 1.5, 3)).swept
    assert isinstance(swept, Sweep)
    assert [round(one.value, 12) for one in swept.crossings] == [0.0]


@pytest.mark.parametrize("energy", ["exp(-x)", "1/x", "atan(x)", "x^3/3 + x"])
def test_where_there_is_none_a_force_that_fades_is_none_still(energy: str) -> None:
    text = VAN_DER_POL.replace("V: x^2/2", f"V: {energy}")
    for start in ("x=0.5", "x=2"):
        try:
            found = find(text, start).linearisation.steady
        except NotSteady:
            continue
        pytest.fail(f"{energy} from {start} has no equilibrium near, and {found.y} is found")


def test_rest_is_looked_for_only_where_the_search_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    """So nothing that is found without it becomes slower or another motion."""
    monkeypatch.setattr(steady_module, "_find_rest", lambda *_: pytest.fail("looked for rest"))
    assert find(VAN_DER_POL, "x=0.5").linearisation.steady.y == pytest.approx((0.0, 0.0), abs=1e-12)
