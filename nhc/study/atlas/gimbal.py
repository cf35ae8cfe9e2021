"""C3: Euler's angles near their lock, and the same body with a quaternion, which has none."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.integrate import solve_ivp

from nhc.mechanics.about import scene_about
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.system import System
from nhc.simulate.task import CROSSED, DONE
from nhc.study.atlas.scenario import Measure, Runner, Scenario, Verdict, open_runner, open_system
from nhc.study.stability.bench import open_bench
from nhc.study.stability.distance import NEAR, distances

END, TOLERANCE = 2.0, 1e-10
ANGLES, QUATERNION = "theta=1, w1=-1", "R_0=cos(1/2), R_1=sin(1/2), w1=-1"
NEARER = ("0.1", "0.001", "0.000001")  # how far the body passes from the lock: w2 at the start


def run() -> Verdict:
    """A free body that turns past theta = 0 at the distance d."""
    angles, quaternion = open_system("free_rigid_body"), open_system("free_rigid_body_quaternion")
    by_hand = open_system("free_rigid_body", without=("detours",))
    calls, off = _pass_by(by_hand, ANGLES)
    own_calls, own_off = _pass_by(angles, ANGLES)
    free_calls, free_off = _pass_by(quaternion, QUATERNION)
    times = (0.0, END)
    silent = _open(by_hand, ANGLES).run(times, tolerance=TOLERANCE)
    through = open_runner(angles, ANGLES, "dop853").run(times, tolerance=TOLERANCE)
    free = open_runner(quaternion, QUATERNION, "dop853").run(times, tolerance=TOLERANCE)
    warning = _warned(angles, f"{ANGLES}, w2={NEARER[1]}")
    growth, spread = calls[-1] / max(calls[0], 1), max(free_calls) / max(min(free_calls), 1)
    own_growth = max(own_calls) / max(min(own_calls), 1)
    told = "reports success" if silent.kind == DONE else "fails"
    refused = f"refused at t = {through.t:.6f}" if through.kind != DONE else "not refused"
    return Verdict(
        Measure(
            f"{_listed(calls)} right-hand sides at d = {_listed(NEARER)}, w off by up to {max(off):.0e}; "
            f"through the lock it {told}",
            growth,
        ),
        Measure(
            f"with a quaternion {_listed(free_calls)}, w off by up to {max(free_off):.0e}, through the lock {free.calls}; "
            f"with angles by way of w {_listed(own_calls)}, w off by up to {max(own_off):.0e}; "
            f"the laboratory warns ({warning:.0e} from the lock at d = {NEARER[1]}), through it {refused}",
            spread,
        ),
        "as many evaluations for every d (within 1.5, by angles 10), w to 1e-9; with angles a warning near the lock, refused at it",
        growth > 100
        and spread <= 1.5
        and own_growth <= 10
        and max(*free_off, *own_off) <= 1e-9
        and free.kind == DONE
        and warning < NEAR
        and through.kind in (CROSSED, 1, 2),
    )


def _listed(values: Sequence[object]) -> str:
    return ", ".join(str(value) for value in values)


def _open(system: System, about: str) -> Runner:
    """Lagrange's equations for the angles, and nobody watches; nhc's own for the quaternion."""
    naive = "" if system.rotations else "lagrange"
    return open_runner(system, about, "dop853", naive, needs=("w1", "w2", "w3"), watch=bool(system.rotations))


def _pass_by(system: System, about: str) -> tuple[list[int], list[float]]:
    """Right-hand sides and the error of the angular velocity at the end, for each distance; 0 where a run fails."""
    calls, off = [], []
    for d in NEARER:
        runner = _open(system, f"{about}, w2={d}")
        outcome = runner.run((0.0, END), tolerance=TOLERANCE)
        done = outcome.kind == DONE
        calls.append(outcome.calls if done else 0)
        end = runner.model.quantities([END], outcome.states[-1:], runner.job.p)[0][:3] if done else [float("inf")] * 3
        off.append(float(np.max(np.abs(np.array(end) - _truth(float(d))))))
    return calls, off


def _truth(d: float) -> np.ndarray:
    """Euler's equations alone, with I = 1, 2, 3."""

    def rates(t: float, w: Sequence[float]) -> list[float]:
        return [(2 - 3) * w[1] * w[2] / 1, (3 - 1) * w[2] * w[0] / 2, (1 - 2) * w[0] * w[1] / 3]

    found = solve_ivp(rates, (0.0, END), [-1.0, d, 0.0], method="DOP853", rtol=1e-13, atol=1e-15)
    return np.asarray(found.y[:, -1])


def _warned(system: System, about: str) -> float:
    """The smallest distance from a singular point that the laboratory shows."""
    form, scene = formulate(system, ""), scene_about(system.spec, about)
    start = start_of(system, scene)
    bench = open_bench(equations_of(system, form), form, type(start)(scene, (0.0, END), start.p, start.q, start.v))
    return min(d.least for d in distances(bench))


SCENARIO = Scenario("C3", "gimbal lock", "free_rigid_body", run)
