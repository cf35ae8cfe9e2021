"""C3: Euler's angles near their lock: the steps shrink with the distance, and right on it an integration may seem to succeed."""

from __future__ import annotations

from nhc.mechanics.about import scene_about
from nhc.mechanics.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.scenes import start_of
from nhc.simulate.task import CROSSED, DONE
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_runner, open_system
from nhc.study.stability.bench import open_bench
from nhc.study.stability.distance import NEAR, distances

END = 2.0


def run() -> Verdict:
    """A free body that turns past theta = 0 at the distance d."""
    system = open_system("free_rigid_body")
    calls, worst = {}, 1.0
    for d in ("0.1", "0.001"):
        about = f"theta=1, w1=-1, w2={d}"
        outcome = open_runner(system, about, "dop853", watch=False).run((0.0, END), tolerance=1e-10)
        calls[d] = outcome.calls if outcome.kind == DONE else 0
    form, scene = formulate(system, ""), scene_about(system.spec, "theta=1, w1=-1, w2=0.001")
    start = start_of(system, scene)
    bench = open_bench(equations_of(system, form), form, type(start)(scene, (0.0, END), start.p, start.q, start.v))
    worst = min(d.least for d in distances(bench))
    through = open_runner(system, "theta=1, w1=-1", "dop853").run((0.0, END), tolerance=1e-10)
    silent = open_runner(system, "theta=1, w1=-1", "dop853", watch=False).run((0.0, END), tolerance=1e-10)
    growth = calls["0.001"] / max(calls["0.1"], 1)
    return Verdict(
        Measure(
            f"{calls['0.1']} right-hand sides at d = 0.1, {calls['0.001']} at 0.001; through the lock it "
            + ("reports success" if silent.kind == DONE else "fails"),
            growth,
        ),
        Measure(
            f"the laboratory warns: {worst:.1e} from the lock at d = 0.001; through it "
            + (f"refused at t = {through.t:.6f}" if through.kind != DONE else "not refused"),
            worst,
        ),
        "a warning near the lock, and a refusal at it",
        growth > 1.5 and worst < NEAR and through.kind in (CROSSED, 1, 2),
    )


SCENARIO = Scenario("C3", "gimbal lock", "free_rigid_body", run)
