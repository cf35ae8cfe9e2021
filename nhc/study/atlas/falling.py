"""C7: a disk that falls almost flat and rises again, through rates of 1e4 rad/s within a moment."""

from __future__ import annotations

import math

from nhc.simulate.task import DONE
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, grid, open_runner, open_system

END = 0.6
SETTINGS = ("phi'=0.01",)


def run() -> Verdict:
    """Euler's disk let go at a tilt of 0.4: it turns by pi sqrt(1 + m R^2/A) in the bounce (Srinivasan and Ruina 2008)."""
    system, times = open_system("rolling_disk"), grid(END, 61)
    naive = open_runner(system, "bounce", "rk4", settings=SETTINGS, watch=False)
    rough = naive.run(times, step=1e-4)
    lost = math.inf
    if rough.kind == DONE:
        energy = naive.checks(times, rough, "energy")[:, 0]
        lost = float(max(abs(energy - energy[0])) / abs(energy[0]))
    own = open_runner(system, "bounce", "dop853", settings=SETTINGS)
    outcome = own.run(times, tolerance=1e-12)
    kept = own.checks(times, outcome, "energy")[:, 0]
    drift = float(max(abs(kept - kept[0])) / abs(kept[0]))
    place = system.q_names.index("phi")
    p = dict(zip((x.name for x in system.spec.parameters), own.job.p, strict=True))
    law = math.pi * math.sqrt(1 + p["m"] * p["R"] ** 2 / p["A"])
    off = abs(abs(outcome.y[place] - own.job.y[place]) / law - 1)
    told = (
        f"not finite from t = {rough.t:.3f} on" if rough.kind != DONE else f"the energy changes by {lost:.1e} of itself"
    )
    return Verdict(
        Measure(f"RK4 with steps of 1e-4 s: {told}", min(lost, 1e300)),
        Measure(
            f"dop853 in {outcome.steps} steps: energy to {drift:.1e}, the turn {100 * off:.2f} % from the law", off
        ),
        "energy to 1e-6, the turn within 1 % of the law for the flattest fall",
        lost > 1 and outcome.kind == DONE and drift < 1e-6 and off < 0.01,
    )


SCENARIO = Scenario("C7", "Euler's disk falls flat", "rolling_disk", run)
