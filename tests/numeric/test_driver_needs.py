"""A driver delivers every quantity that its scenes need, whether the formulation keeps it or not."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from nhc.language import decode, read
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.numeric.test_driver_stop import drive
from tests.support import needs_full, spec_path


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("name", "formulation"),
    [
        ("chaplygin_sleigh", "multipliers"),
        ("rolling_disk", "voronec"),
        ("rolling_disk", "multipliers"),
        ("suslov", "multipliers"),
        ("heavy_top_quaternion", "multipliers"),
        ("free_rigid_body", "lagrange"),
    ],
)
def test_quasi_velocities_beside_another_state(name: str, formulation: str, tmp_path: Path) -> None:
    """The same columns as a run, and the same numbers; a body that turns over magnifies what rounding leaves 1e5 times."""
    source = read(str(spec_path(name)))
    spec = decode(source)
    names = {quasi.name for quasi in spec.quasi_velocities}
    scene = next(scene for scene in spec.scenes if any(need.name in names for need in scene.need))
    done = drive(source, tmp_path, scene.name, "2", "1e-13", formulation=formulation)
    assert done.returncode == 0, done.stderr
    head, _, last = (line.split(",") for line in done.stdout.splitlines())
    found = run(open_scene(source, scene.name, formulation), Settings(tolerance=1e-13, points=2))
    assert tuple(head[1:]) == found.headings
    assert [float(x) for x in last[1:]] == pytest.approx(found.rows[-1], rel=1e-6, abs=1e-7)


def test_a_wanted_quantity_of_the_state_costs_no_function(tmp_path: Path) -> None:
    drive(read(str(spec_path("chaplygin_sleigh"))), tmp_path)
    assert "_needed" not in (tmp_path / "chaplygin_sleigh_main.c").read_text()


@needs_full
def test_output_that_cannot_be_written_is_said(tmp_path: Path) -> None:
    drive(read(str(spec_path("pendulum"))), tmp_path)
    with Path("/dev/full").open("w") as full:
        done = subprocess.run([tmp_path / "pendulum"], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
    assert (done.returncode, done.stderr) == (1, "pendulum: the output cannot be written\n")
