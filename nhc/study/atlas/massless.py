"""C13: coordinates without mass, and rows given twice."""

from __future__ import annotations

import numpy as np

from nhc.algebra.calculus import gradient
from nhc.algebra.evaluate import evaluate
from nhc.diagnostics import Source, SpecError
from nhc.language import decode
from nhc.mechanics.about import scene_about
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.starts.scenes import start_of
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_runner, open_system

_TWICE = """nhc: 1
system: twice
coordinates: [x, y, theta]
T: (x'^2 + y'^2 + theta'^2)/2
constraints:
  - slip: -sin(theta)*x' + cos(theta)*y' = 0
  - again: -2*sin(theta)*x' + 2*cos(theta)*y' = 0
"""


def run() -> Verdict:
    """The cart with wheels that weigh nothing: M has rank 3 of 5, the motion is determined all the same."""
    system = open_system("diff_drive")
    settings = ("J_w=0",)
    at = start_of(system, scene_about(system.spec, "reference", settings)).values(system)
    g, n = system.graph, system.n
    flat = [x for p in gradient(g, system.T, system.v) for x in gradient(g, p, system.v)]
    mass = np.array([float(x) for x in evaluate(g, flat, at)]).reshape(n, n)
    rank = int(np.linalg.matrix_rank(mass))
    ends = [
        open_runner(system, "reference", "dop853", form, settings).run((0.0, 5.0)).y[:n]
        for form in ("euler-lagrange", "multipliers")
    ]
    apart = float(np.max(np.abs(np.array(ends[0]) - np.array(ends[1]))))
    code = ""
    try:
        resolve(decode(Source("twice", _TWICE)))
    except SpecError as error:
        code = error.diagnostics[0].code
    return Verdict(
        Measure(
            f"M has rank {rank} of {n}: A M^-1 A^T, which eliminates the accelerations, does not exist", float(rank)
        ),
        Measure(
            f"reduced and bordered forms agree to {apart:.1e} after 5 s; a row given twice is "
            + (f"refused with {code}" if code else "accepted"),
            apart,
        ),
        "both forms within 1e-8, redundant rows refused",
        rank < n and apart <= 1e-8 and bool(code),
    )


SCENARIO = Scenario("C13", "massless coordinates, redundant rows", "diff_drive", run)
