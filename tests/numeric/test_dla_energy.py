"""Structure-preserving methods: where the energy error of DLA is read, and that the unit of mass means nothing."""

from __future__ import annotations

import math

import pytest

from nhc.language import Source, read
from nhc.simulate.methods import STRUCTURE
from nhc.simulate.natural import NaturalModel
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.support import spec_path


@pytest.mark.sample(3)
@pytest.mark.parametrize(
    ("name", "h", "nodes", "midpoints"),
    [
        ("contact_oscillator", 0.2, 0.0073, 0.0142),
        ("contact_oscillator_eps", 0.2, 0.0081, 0.0179),
        ("nh_particle_pot", 0.1, 0.00020, 0.00146),
    ],
)
def test_energy_at_nodes_and_at_midpoints(name: str, h: float, nodes: float, midpoints: float) -> None:
    """Both errors are bounded; they are those of docs/run.md."""
    job = open_scene(read(str(spec_path(name))), method="dla")
    system, scheme = NaturalModel(job.program), STRUCTURE["dla"]
    system.p = job.p
    q = list(job.y[: system.n])
    v = system.module.velocities(0.0, job.y, job.p)
    energy, point = system.total(q, v), scheme.start(system, q, v, h)
    at_nodes = at_midpoints = 0.0
    for _ in range(2000):
        before, point = point.q, scheme.advance(system, point, h)
        at_nodes = max(at_nodes, abs(system.total(*scheme.read(system, point, h)) - energy))
        pairs = list(zip(before, point.q, strict=True))
        middle = system.total([0.5 * (a + b) for a, b in pairs], [(b - a) / h for a, b in pairs])
        at_midpoints = max(at_midpoints, abs(middle - energy))
    assert at_nodes == pytest.approx(nodes, rel=0.03)
    assert at_midpoints == pytest.approx(midpoints, rel=0.03)


WHEELSET = """nhc: 1
system: wheelset
coordinates: [s, y, psi, chi]
parameters: {m: MASS, Jx: 0.6*MASS, Jy: 0.1*MASS}
T: m/2*(s'^2 + y'^2) + Jx/2*psi'^2 + Jy/2*chi'^2
constraints: [y' - psi*s' = 0, 0.75*psi' + 0.05*y*chi' = 0, s' - chi'/2 = 0]
scenes: {sway: {initial: {y: 0.005, s': 20}, time: [0, 1], need: [y, psi]}}
"""


@pytest.mark.sample(4)
@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", ["energy", "dla", "leapfrog", "perlmutter", "midpoint"])
def test_the_unit_of_mass_means_nothing(method: str, compiled: bool) -> None:
    """Klingel's motion: y goes as cos(w t) with w = v sqrt(0.05/(0.75 * 0.5)), whatever the wheelset weighs."""
    ends = []
    for mass in ("1", "1000", "1e8", "1e-9"):
        text = WHEELSET.replace("0.6*MASS", f"{0.6 * float(mass)}").replace("0.1*MASS", f"{0.1 * float(mass)}")
        job = open_scene(Source("wheelset.yaml", text.replace("MASS", mass)), method=method)
        found = run(job, Settings(points=2, method=method, step=0.005, compiled=compiled))
        assert found.ended == "done", (mass, found.reason)
        ends.append(found.rows[-1])
    assert ends[0][0] == pytest.approx(0.005 * math.cos(20 * math.sqrt(0.05 / 0.375)), abs=1e-5)
    for end in ends[1:]:
        assert end == pytest.approx(ends[0], rel=1e-9)


@pytest.mark.parametrize("compiled", [True, False])
@pytest.mark.parametrize("method", ["energy", "dla", "leapfrog", "perlmutter"])
def test_late_times_lose_no_row(method: str, compiled: bool) -> None:
    """A million seconds after zero the times are rounded by more than a billionth of a short step."""
    text = "nhc: 1\nsystem: free\ncoordinates: [x]\nT: x'^2/2\nscenes: {go: {initial: {x': 1}, time: [1000000, 1000000.001]}}\n"
    job = open_scene(Source("free.yaml", text), method=method)
    found = run(job, Settings(points=65, method=method, step=1.5625e-5, compiled=compiled))
    assert found.ended == "done" and len(found.rows) == len(found.times) == 65
    assert found.rows[-1][0] == pytest.approx(found.times[-1] - 1e6, rel=1e-9)
