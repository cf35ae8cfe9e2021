"""The energy error of DLA depends on where its velocity is read: at the nodes, or at the scheme's own midpoints."""

from __future__ import annotations

import pytest

from nhc.language import read
from nhc.simulate.methods import STRUCTURE
from nhc.simulate.natural import NaturalModel
from nhc.simulate.opening import open_scene
from tests.support import spec_path


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
