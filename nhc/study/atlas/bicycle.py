"""C9: what the eigenvalues of the bicycle promise, the nonlinear equations keep."""

from __future__ import annotations

import numpy as np
from scipy.linalg import expm

from nhc.mechanics.about import scene_about, state_of
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.starts.scenes import Start, start_of
from nhc.mechanics.system import System
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_runner, open_system
from nhc.study.linearization.field import SteadyModel
from nhc.study.linearization.linearize import eigenvalues, linearise_at
from nhc.study.linearization.motion import steady_model
from nhc.study.linearization.steady import find_steady

END, NUDGE = 6.0, 1e-5
GROWTH = {  # largest real part at each speed, by the published matrices (Meijaard, Papadopoulos, Ruina and Schwab 2007)
    3.5: 1.111251629,
    4.2: 0.1265590837,
    4.4: -0.1402448474,
    5.0: -0.322866429,
    6.0: -0.00406690077,
    6.1: 0.01204831669,
    7.0: 0.1026817057,
}


def run() -> Verdict:
    """Nudged by 1e-5 rad/s in lean: lean and steer after 6 s, against exp(A t)."""
    system = open_system("bicycle")
    worst, told = 0.0, []
    for speed, growth in GROWTH.items():
        nudge = NUDGE if growth < 1.0 else 0.1 * NUDGE  # what grows 800-fold is linear while it is small
        model, start = _model(system, "voronec", speed, nudge)
        steady = find_steady(model, state_of(model.flow, model.frame, _start(system, speed, 0.0)))
        made = linearise_at(model, steady)
        told.append(max(x.real for x in eigenvalues(made)))
        rest = list(made.rest)
        linear = expm(made.full * END) @ (np.array(start) - np.array(steady.y))[rest]
        runner = open_runner(system, _about(speed, nudge), "dop853", "voronec")
        end = np.array(runner.run((0.0, END), tolerance=1e-13).y)
        places = [rest.index(system.q_names.index(name)) for name in ("roll", "steer")]
        moved = (end - np.array(steady.y))[rest]
        size = float(np.max(np.abs(linear[places])))
        worst = max(worst, float(np.max(np.abs((moved - linear)[places]))) / size)
    off = max(abs(x - published) for x, published in zip(told, GROWTH.values(), strict=True))
    full, state = _model(system, "multipliers", 5.0, 0.0)
    values = np.linalg.eigvals(full.field(list(state))[1])
    zeros = int(np.sum(np.abs(values) < 1e-3))
    return Verdict(
        Measure(
            f"the Jacobian of the multiplier form at 5 m/s has {len(values)} eigenvalues, {zeros} of them zero up to rounding",
            float(zeros),
        ),
        Measure(
            "four eigenvalues; growth "
            + ", ".join(f"{x:.4f} at {v:g}" for x, v in zip(told, GROWTH, strict=True))
            + f" m/s, within {off:.1e} of the published matrices'; nonlinear runs within {worst:.1e} of exp(A t)",
            worst,
        ),
        "growth to 1e-8, nonlinear runs within 1e-5",
        zeros > 10 and off < 1e-8 and worst < 1e-5,
    )


def _about(speed: float, nudge: float) -> str:
    return f"z=-0.3, roll'={nudge!r}, thR'=-{speed!r}/r_R"


def _start(system: System, speed: float, nudge: float) -> Start:
    return start_of(system, scene_about(system.spec, _about(speed, nudge)))


def _model(system: System, name: str, speed: float, nudge: float) -> tuple[SteadyModel, tuple[float, ...]]:
    form = formulate(system, name)
    start = _start(system, speed, nudge)
    model = steady_model(equations_of(system, form), form, start.p)
    return model, state_of(model.flow, form.frame, start)


SCENARIO = Scenario("C9", "bifurcations of the bicycle", "bicycle", run, slow=True)
