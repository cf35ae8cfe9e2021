"""C6: a fast decay that the solution no longer shows still dictates the steps of an explicit method."""

from __future__ import annotations

import math

import numpy as np

from nhc.simulate.methods import RUNGE_KUTTA
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings
from nhc.simulate.run import run as run_scene
from nhc.simulate.task import DONE
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, edit_spec, open_runner, open_system
from nhc.study.stability.stepsize import amplification

RATE, END = 5e5, 3.0  # c/m, and the scene's time
SPRINGS = (1e2, 1e4, 1e6)
THICK = """\
  thick:
    initial: {z: 10, x': 3, y': -1, z': 4}
    parameters: {c: 1e6}
    time: [0, 3]"""


def run() -> Verdict:
    """A falling mass with strong drag: it sinks at g m/c after some microseconds."""
    system, settings = open_system("point_mass"), (f"c={2 * RATE}",)
    limit = _limit() / RATE
    naive = open_runner(system, "reference", "rk4", settings=settings)
    ends = [naive.run((0.0, 2000 * limit), step=factor * limit) for factor in (0.95, 1.05)]
    sizes = [max(abs(x) for x in end.y) if end.kind == DONE else math.inf for end in ends]
    own = open_runner(system, "reference", "radau5", settings=settings)
    outcome = own.run((0.0, END), tolerance=1e-8)
    height = 10 - 9.81 / RATE * END + (4 + 9.81 / RATE) * -math.expm1(-RATE * END) / RATE
    error = abs(outcome.y[2] - height) / 10
    gain = END / outcome.steps / limit
    auto = _by_itself()
    springs = [_spring(k) for k in SPRINGS]
    return Verdict(
        Measure(
            f"RK4 may step {limit:.3g} s: stable at 0.95 of it, "
            + ("not a number" if not math.isfinite(sizes[1]) else f"grown to {sizes[1]:.1e}")
            + f" at 1.05; of {len(springs)} springs (k = 100 to 1e6) {sum(springs)} likewise, at 2.828/omega",
            limit,
        ),
        Measure(
            f"radau5 steps {gain:.2g} times as long on average, height right to {error:.1e}; "
            f"a run without a method finds that out and takes {auto} steps in all",
            gain,
        ),
        "steps at least 100 times the explicit limit, error at most 1e-6, also when no method is named",
        sizes[0] < 100
        and sizes[1] > 1e6
        and all(springs)
        and gain >= 100
        and error <= 1e-6
        and outcome.kind == DONE
        and 0 < auto <= END / limit / 100,
    )


def _by_itself() -> int:
    """Steps of a run that chooses its method; 0 where it does not end well or does not say what it did."""
    job = open_scene(edit_spec("point_mass", (), THICK), "thick")
    found = run_scene(job, Settings(points=2))
    told = any("the scene is stiff" in note and "radau5" in note for note in found.notes)
    return found.outcome.steps if found.ended == "done" and told else 0


def _spring(k: float) -> bool:
    """Whether RK4 on the two disks is stable at 0.95 of 2.828/omega, and is not at 1.05."""
    runner = open_runner(open_system("disk_chain2"), "stiff", "rk4", settings=(f"k={k}",))
    p = dict(zip((x.name for x in runner.job.system.spec.parameters), runner.job.p, strict=True))
    limit = 2 * math.sqrt(2) / math.sqrt(2 * k / (p["m"] + p["I"] / p["R"] ** 2))
    sizes = []
    for factor in (0.95, 1.05):
        end = runner.run((0.0, 2000 * factor * limit), step=factor * limit)
        sizes.append(max(abs(x) for x in end.y) if end.kind == DONE else math.inf)
    return sizes[0] < 1.0 and sizes[1] > 1e6


def _limit() -> float:
    """The end of RK4's interval of stability on the negative axis."""
    low, high = 2.0, 3.0
    for _ in range(60):
        middle = (low + high) / 2
        grows = abs(amplification(RUNGE_KUTTA["rk4"], np.array([complex(-middle)]))[0]) > 1
        low, high = (low, middle) if grows else (middle, high)
    return low


SCENARIO = Scenario("C6", "stiffness", "point_mass", run)
