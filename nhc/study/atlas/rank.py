"""C5: the constraints themselves lose rank; and a row given twice."""

from __future__ import annotations

import math

import numpy as np

from nhc.algebra.evaluate import evaluate
from nhc.diagnostics import SpecError
from nhc.mechanics.about import scene_about
from nhc.mechanics.starts.scenes import start_of
from nhc.mechanics.values import default_values
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings
from nhc.simulate.run import run as run_scene
from nhc.simulate.task import SINGULAR
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, edit_spec, open_runner, open_system
from nhc.study.stability.distance import smallest_singular

THROUGH = """\
  through:
    initial: {theta: 0.2, p_b: 0.4, p_f: 0.4, x': 0.3, psi': 2, p_b': 1, p_f': 1}
    parameters: {sigma: 0, tau: 0}
    time: [0, 3]"""
CLOSED = math.pi / 2 - 0.4
WAYS = (("", "dop853", 0.0), ("", "rk4", 0.1), ("voronec", "rk4", 0.07), ("multipliers", "radau5", 0.0))


def run() -> Verdict:
    """The snakeboard with both axles along its board."""
    system = open_system("snakeboard")
    values = {**default_values(system), **dict.fromkeys((*system.q, system.t), 0.0)}
    for name in ("p_b", "p_f"):
        values[system.q[system.q_names.index(name)]] = math.pi / 2
    flat = [a for form in system.constraints for a in form.coefficients]
    rows = np.array([float(x) for x in evaluate(system.graph, flat, values)]).reshape(system.l, system.n)
    least = smallest_singular(rows)
    inverse = 1.0 / max(least, 1e-300)
    said = _refusal("p_b=pi/2, p_f=pi/2, psi'=2, theta'=0")
    stops = [_stop(*way) for way in WAYS]
    off = max(abs(t - CLOSED) for t in stops)
    return Verdict(
        Measure(
            f"sigma_min = {least:.1e}; a solver that does not look divides by it: entries of {inverse:.1e}", inverse
        ),
        Measure(
            (f"at the start it {said}" if said else "it runs on")
            + f"; on the way, where nothing changes its sign, {len(stops)} runs stop within {off:.1e} s of it",
            off,
        ),
        "refused with a reason, never a number; stopped on the way within 1e-4 s, whatever the steps",
        least < 1e-12 and inverse > 1e12 and bool(said) and off < 1e-4,
    )


def _stop(formulation: str, method: str, step: float) -> float:
    """When a run ends that turns both axles through the direction of the board; infinite where it does not."""
    source = edit_spec("snakeboard", ("dependent:",), THROUGH)
    job = open_scene(source, "through", formulation, method=method)
    found = run_scene(job, Settings(method, step=step, points=2))
    return found.outcome.t if found.ended == "failed" else math.inf


def _refusal(about: str) -> str:
    """How nhc refuses the state, by the formulation that never divides by a block of its own choice."""
    system = open_system("snakeboard")
    try:
        start = start_of(system, scene_about(system.spec, about))
        runner = open_runner(system, about, "dop853", "multipliers", start=start)
    except SpecError as error:
        return error.diagnostics[0].message
    outcome = runner.run((0.0, 0.1))
    return f"stops: {runner.job.meanings[outcome.status]}" if outcome.kind == SINGULAR else ""


SCENARIO = Scenario("C5", "rank loss of the constraints", "snakeboard", run)
