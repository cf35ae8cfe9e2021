"""C12: velocity constraints that are holonomic in disguise."""

from __future__ import annotations

import numpy as np

from nhc.mechanics.frame import coordinate_frame
from nhc.mechanics.properties.integrability import classify
from nhc.mechanics.properties.integrals import find_position_integrals
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, grid, open_runner, open_system


def run() -> Verdict:
    """The cart with two driven wheels: theta hangs on the angles of its wheels."""
    system = open_system("diff_drive")
    found = classify(system)
    frame = coordinate_frame(system, choose_dependent(system).dependent)
    integrals = find_position_integrals(system, frame, found.hidden, found.closed)
    runner, times = open_runner(system, "reference", "dop853"), grid(20.0, 201)
    states = np.array(runner.run(times).states)
    names, p = system.q_names, dict(zip((x.name for x in system.spec.parameters), runner.job.p, strict=True))
    theta, right, left = (states[:, names.index(name)] for name in ("theta", "p_R", "p_L"))
    leaf = 2 * p["b"] * theta - p["r"] * (right - left)
    moved = float(np.max(np.abs(leaf - leaf[0])))
    text = integrals[0].text if integrals else "none found"
    return Verdict(
        Measure(
            f"counted as nonholonomic, {system.l} constraints would leave all {system.n} coordinates within reach",
            system.n,
        ),
        Measure(
            f"finds a leaf of dimension {found.growth[-1]} and {text} = const, kept to {moved:.1e} over 20 s", moved
        ),
        "the hidden integral is found, and kept to 1e-10",
        found.hidden == 1 and found.growth[-1] == system.n - 1 and len(integrals) == 1 and moved < 1e-10,
    )


SCENARIO = Scenario("C12", "holonomic in disguise", "diff_drive", run)
