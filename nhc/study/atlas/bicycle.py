"""C9: what the eigenvalues of the bicycle promise, the nonlinear equations keep."""

from __future__ import annotations

import numpy as np
from scipy.linalg import expm

from nhc.mechanics.about import scene_about, state_of
from nhc.mechanics.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.scenes import Start, start_of
from nhc.mechanics.system import System
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_runner, open_system
from nhc.study.field import SteadyModel
from nhc.study.linearize import eigenvalues, linearise_at
from nhc.study.motion import steady_model
from nhc.study.steady import find_steady

END, NUDGE = 6.0, 1e-5
SPEEDS = (4.2, 4.4, 6.1)  # below and above the weave speed, above the capsize speed


def run() -> Verdict:
    """Nudged by 1e-5 rad/s in lean: lean and steer after 6 s, against exp(A t)."""
    system = open_system("bicycle")
    worst, told = 0.0, []
    for speed in SPEEDS:
        model, start = _model(system, "voronec", speed, NUDGE)
        steady = find_steady(model, state_of(model.flow, model.frame, _start(system, speed, 0.0)))
        made = linearise_at(model, steady)
        told.append(max(x.real for x in eigenvalues(made)))
        rest = list(made.rest)
        linear = expm(made.full * END) @ (np.array(start) - np.array(steady.y))[rest]
        runner = open_runner(system, _about(speed, NUDGE), "dop853", "voronec")
        end = np.array(runner.run((0.0, END), tolerance=1e-13).y)
        places = [rest.index(system.q_names.index(name)) for name in ("roll", "steer")]
        moved = (end - np.array(steady.y))[rest]
        size = float(np.max(np.abs(linear[places])))
        worst = max(worst, float(np.max(np.abs((moved - linear)[places]))) / size)
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
            + ", ".join(f"{x:.4f} at {v}" for x, v in zip(told, SPEEDS, strict=True))
            + f"; nonlinear runs within {worst:.1e} of exp(A t)",
            worst,
        ),
        "signs +, -, + and nonlinear runs within 1e-5",
        zeros > 10 and [x > 0 for x in told] == [True, False, True] and worst < 1e-5,
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
