"""C11: a start whose velocities violate the constraints."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from nhc.diagnostics import SpecError
from nhc.mechanics.about import scene_about
from nhc.mechanics.starts.scenes import start_of
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings
from nhc.simulate.run import run as run_scene
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, edit_spec, grid, open_runner, open_system

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
    shown = edit_spec(
        "chaplygin_sleigh", (), f"  pushed: {{initial: {{x': -0.6, y': {OFF}, theta': 1.3}}, time: [0, 10]}}"
    )
    found = run_scene(open_scene(shown, "pushed", "multipliers", project=True, checks=True), Settings(points=51))
    place = [column.group for column in found.job.checks].index("residual")
    left = max(abs(row[place]) for row in found.checks)
    return Verdict(
        Measure(
            f"the differentiated constraint keeps the slip of {kept:.3g} for ever, and the energy moves by {change:.2g}",
            kept,
        ),
        Measure(
            (f"refused with {code}" if code else "accepted")
            + f"; projected on request, with {len(found.notes)} notes on what changed, a slip of {left:.0e} is left",
            left,
        ),
        "refused with a diagnostic, or projected on request to 1e-12 with a report",
        abs(kept - OFF) < 1e-9 and change > 1e-2 and code == "E0409" and left <= 1e-12 and len(found.notes) == 2,
    )


SCENARIO = Scenario("C11", "inconsistent start", "chaplygin_sleigh", run)
