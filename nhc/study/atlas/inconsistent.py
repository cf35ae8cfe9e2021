"""C11: a start whose velocities violate the constraints."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nhc.diagnostics import SpecError
from nhc.mechanics.about import scene_about
from nhc.mechanics.scenes import start_of
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, grid, open_runner, open_system

OFF = 0.1


def run() -> Verdict:
    """The sleigh pushed sideways by 0.1 m/s."""
    system, times = open_system("chaplygin_sleigh"), grid(10.0, 101)
    good = start_of(system, scene_about(system.spec, "reference"))
    start = replace(good, v=(good.v[0], good.v[1] + OFF, good.v[2]))  # heading 0: y' is the slip
    naive = open_runner(system, "reference", "dop853", "multipliers", start=start, hold=False)
    outcome = naive.run(times)
    slip = naive.checks(times, outcome, "residual")
    energy = naive.checks(times, outcome, "energy")
    kept, change = float(np.min(np.abs(slip))), float(np.max(np.abs(energy - energy[0])))
    code = ""
    try:
        start_of(system, scene_about(system.spec, f"x'=-0.6, y'={OFF}, theta'=1.3"))
    except SpecError as error:
        code = error.diagnostics[0].code
    return Verdict(
        Measure(
            f"the differentiated constraint keeps the slip of {kept:.3g} for ever, and the energy moves by {change:.2g}",
            kept,
        ),
        Measure(f"refused with {code}" if code else "accepted", 0.0 if code else OFF),
        "refused with a diagnostic (or projected on request, and said so)",
        abs(kept - OFF) < 1e-9 and change > 1e-2 and code == "E0409",
    )


SCENARIO = Scenario("C11", "inconsistent start", "chaplygin_sleigh", run)
