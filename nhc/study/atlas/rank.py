"""C5: the constraints themselves lose rank; and a row given twice."""

from __future__ import annotations

import math

import numpy as np

from nhc.algebra.evaluate import evaluate
from nhc.diagnostics import SpecError
from nhc.mechanics.about import scene_about
from nhc.mechanics.regularity import default_values
from nhc.mechanics.scenes import start_of
from nhc.simulate.task import SINGULAR
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_runner, open_system
from nhc.study.stability.distance import smallest_singular


def run() -> Verdict:
    """The snakeboard with both axles along its board."""
    system = open_system("snakeboard")
    values = {**default_values(system), **dict.fromkeys((*system.q, system.t), 0.0)}
    for name in ("p_b", "p_f"):
        values[system.q[system.q_names.index(name)]] = math.pi / 2
    flat = [a for form in system.constraints for a in form.coefficients]
    rows = np.array([float(x) for x in evaluate(system.graph, flat, values)]).reshape(system.l, system.n)
    least = smallest_singular(rows)
    inverse = float(np.max(np.abs(np.linalg.pinv(rows @ rows.T + 0.0, rcond=0.0))))
    said = _refusal("p_b=pi/2, p_f=pi/2, psi'=2, theta'=0")
    return Verdict(
        Measure(
            f"sigma_min = {least:.1e}; a solver that does not look divides by it: entries of {inverse:.1e}", inverse
        ),
        Measure(said or "it runs on", 0.0 if said else 1.0),
        "refused with a reason, never a number",
        least < 1e-12 and inverse > 1e12 and bool(said),
    )


def _refusal(about: str) -> str:
    """How nhc refuses the state, by the formulation that never divides by a block of its own choice."""
    system = open_system("snakeboard")
    try:
        start = start_of(system, scene_about(system.spec, about))
        runner = open_runner(system, about, "dop853", "multipliers", start=start)
    except SpecError as error:
        return error.diagnostics[0].message
    outcome = runner.run((0.0, 0.1))
    return f"stops at t = {outcome.t:g}: {runner.job.meanings[outcome.status]}" if outcome.kind == SINGULAR else ""


SCENARIO = Scenario("C5", "rank loss of the constraints", "snakeboard", run)
