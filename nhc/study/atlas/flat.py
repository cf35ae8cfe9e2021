"""C7, with losses: a constant torque takes the energy out of Euler's disk, and its tilt goes to zero in finite time."""

from __future__ import annotations

import math
from dataclasses import replace

from nhc.simulate.opening import open_scene
from nhc.simulate.prepare import Job
from nhc.simulate.run import Settings, Trajectory
from nhc.simulate.run import run as run_scene
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, edit_spec

END, TORQUE = 46.0, 0.002
TILTS, TIMES = (0.1, 0.03, 0.01, 0.003), (36.74702, 43.80662, 44.95124, 45.17902)
SPUN = f"""\
  spun:
    initial: {{theta: 0.3, phi': 16.296183499, psi': -15.568338730}}
    parameters: {{M: {TORQUE}}}
    time: [0, {END}]
    need: [theta, phi, x, y]"""


def run() -> Verdict:
    """Steady rolling at a tilt of 0.3, braked by a torque about the vertical of 0.002 N m."""
    source = edit_spec("rolling_disk", (), f"{SPUN}\nforces: {{phi: -M}}")
    source = replace(source, text=source.text.replace("parameters:\n", "parameters:\n  M: 0\n  level: 1\n", 1))
    naive = run_scene(open_scene(source, "spun", method="rk4", stay=True), Settings("rk4", step=1e-3, points=2))
    level = open_scene(source, "spun", until="theta - level")
    found = [_reach(level, tilt) for tilt in TILTS]
    off = max(abs(a.times[-1] - b) for a, b in zip(found, TIMES, strict=True))
    exponent = _exponent([a.times[-1] for a in found])
    ends = [
        run_scene(open_scene(source, "spun", name), Settings(tolerance=1e-9, points=2)) for name in ("", "multipliers")
    ]
    pairs = zip(ends[0].rows[-1], ends[1].rows[-1], strict=True)
    apart = max(abs(a - b) for a, b in pairs)
    said = any("digits are lost" in note for note in ends[0].notes)
    wrong = math.inf if naive.ended == "failed" else abs(naive.rows[-1][0] - ends[0].rows[-1][0])
    told = "fails" if naive.ended == "failed" else f"ends {wrong:.2g} rad off in tilt and reports success"
    return Verdict(
        Measure(f"RK4 with steps of 1e-3 s {told}", min(wrong, 1e300)),
        Measure(
            f"tilts of 0.1 to 0.003 rad reached within {off:.1e} s of the catalogue; (t_f - t) goes as tilt^{exponent:.4f}; "
            + ("the singularity is told" if said else "nothing is told")
            + f"; after it the disk rises again, two formulations {apart:.0e} apart",
            exponent,
        ),
        "exponent 1.5 to 0.02 (adiabatic theory), times to 1e-4 s, a note that the singularity is near, 1e-6 beyond it",
        wrong > 1e-3 and off < 1e-4 and abs(exponent - 1.5) <= 0.02 and said and apart <= 1e-6,
    )


def _reach(job: Job, tilt: float) -> Trajectory:
    """The run until the tilt is reached."""
    names = [p.name for p in job.system.spec.parameters]
    p = list(job.p)
    p[names.index("level")] = tilt
    return run_scene(replace(job, p=tuple(p)), Settings(tolerance=1e-10, points=2))


def _exponent(times: list[float]) -> float:
    """e of t_f - t = c tilt^e through three of the points, t_f and c being unknown."""
    (a, b, c), (s, t, u) = TILTS[:3], times[:3]
    low, high = 0.5, 3.0
    for _ in range(60):
        e = 0.5 * (low + high)
        low, high = (e, high) if (a**e - b**e) / (b**e - c**e) < (t - s) / (u - t) else (low, e)
    return low


SCENARIO = Scenario("C7b", "Euler's disk spun down", "rolling_disk", run)
