"""Differences of coordinates stay differences: a motion far from the origin, or from t = 0, is that at the origin."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.support import python_model

SKATE = """nhc: 1
system: skate
about: Two masses on a rod whose middle has a knife edge along the rod; positions are Cartesian.
coordinates: [x1, y1, x2, y2]
parameters: {m1: 1, m2: 1.4, l: 0.8}
T: m1/2*(x1'^2 + y1'^2) + m2/2*(x2'^2 + y2'^2)
constraints:
  - blade: (x2 - x1)*(y1' + y2') - (y2 - y1)*(x1' + x2') = 0
holonomic:
  - rod: (x2 - x1)^2 + (y2 - y1)^2 = l^2
"""


@pytest.mark.parametrize("formulation", ["euler-lagrange", "voronec", "multipliers"])
def test_a_rod_far_away_moves_as_at_the_origin(formulation: str) -> None:
    """The determinant is the rod's length squared, as (x1 - x2)^2 + (y1 - y2)^2; multiplied out it lost ten digits here."""
    (text,) = emit(
        Source("s.yaml", SKATE), "python", Options(formulation=formulation, only=("accelerations", "state"))
    ).values()
    module = python_model(text, f"skate_{formulation}".replace("-", "_"))
    far = 2.0**16  # such that the coordinates are moved without rounding
    rod, speed, turn = (0.6 + 2.0**-30 - 0.6 % 2.0**-30, 0.5), 0.75, 0.5
    along = [speed * rod[0], speed * rod[1]]
    v = [along[0] + turn * rod[1], along[1] - turn * rod[0], along[0] - turn * rod[1], along[1] + turn * rod[0]]
    found = []
    for shift in (0.0, far):
        q = [shift, shift, shift + rod[0], shift + rod[1]]
        found.append(module.accelerations(0.0, module.state(0.0, q, v)))
    assert found[1] == pytest.approx(found[0], rel=1e-12, abs=1e-13)


def test_a_run_far_away_is_not_said_to_be_nearly_singular() -> None:
    """The rod's energy in the free velocities is (m1 + m2) |v2|^2/2 everywhere; the note went by the size of the coordinates."""
    scenes = "scenes: {far: {initial: {x1: 20, x2: 20 + l, x1': 0.5, x2': 0.5, y1': -0.3, y2': 0.3}, time: [0, 80]}}\n"
    job = open_scene(Source("s.yaml", SKATE + scenes), "far", "euler-lagrange")
    found = run(job, Settings("dop853", points=3))
    assert found.ended == "done" and not [note for note in found.notes if "nearly singular" in note]


TURNING = """nhc: 1
system: turning
coordinates: [x, y, phi, z]
T: (x'^2 + y'^2 + phi'^2 + z'^2)/2
constraints:
  - blade: sin(phi)*x' - cos(phi)*y' = 0
  - lift: z' = 0.7
scenes:
"""


@pytest.mark.parametrize("begin", [86400, 1700000000])
def test_a_scene_far_from_t_0_is_one_that_starts_there(begin: int) -> None:
    """phi turns at a constant rate; as a function of the time it had few digits, and the steps became as short as doubles allow."""
    initial = "initial: {phi: 0.3, phi': 1, x': 1, z: 0.1}"
    scenes = f"  far: {{{initial}, time: [{begin}, {begin + 1}]}}\n  near: {{{initial}, time: [0, 1]}}\n"
    found = {}
    for scene in ("far", "near"):
        job = open_scene(Source("turning.yaml", TURNING + scenes), scene)
        done = run(job, Settings("dop853", points=2, tolerance=1e-12))
        assert done.ended == "done" and done.outcome.steps < 50
        found[scene] = done.rows
    assert found["far"][0] == found["near"][0]
    assert found["far"][1] == pytest.approx(found["near"][1], rel=1e-12)
