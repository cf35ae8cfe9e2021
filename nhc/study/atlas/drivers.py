"""C8, all of it: energy over 2e4 units of time, and the drivers that break the symmetry structure-preserving methods live on."""

from __future__ import annotations

import math
import re
from dataclasses import replace

from nhc.language import read
from nhc.records import record
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings
from nhc.simulate.run import run as run_scene
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, spec_path

END, ROWS = 2e4, 20001
METHODS = ("leapfrog", "dla", "perlmutter", "midpoint", "energy")
LIVES, DIES = 1.1, 5.0
ROUNDING = 1e-8


@record
class Problem:
    """``kept``: methods whose energy error stays bounded; ``lost``: those whose error grows; others are not judged.

    ``eps``: in place of the spec's.
    """

    system: str
    step: float
    kept: tuple[str, ...]
    lost: tuple[str, ...]
    eps: str = ""

    @property
    def name(self) -> str:
        return f"{self.system} with eps = {self.eps}" if self.eps else self.system


PROBLEMS = (
    Problem("contact_oscillator", 0.2, METHODS, ()),
    Problem("nh_particle_pot", 0.1, METHODS, ()),
    Problem("cvt", 0.2, METHODS, ()),
    Problem("chaotic", 0.1, ("energy",), ()),  # the errors of the others wander as the motion does
    Problem("cvt_eps", 0.2, ("leapfrog", "energy"), ("dla", "perlmutter")),
    Problem("cvt_eps", 0.2, ("leapfrog", "energy"), ("dla", "perlmutter"), "0.5"),
)


def run() -> Verdict:
    """Largest energy error in the first tenth and in the last, for each method that nhc offers."""
    told, grown, naive, right = [], 0.0, list[float](), True
    for problem in PROBLEMS:
        ratios = {}
        for method in METHODS:
            first, last = _errors(problem, method)
            ratios[method] = 1.0 if last < ROUNDING else last / first if math.isfinite(last) else math.inf
        first, last = _errors(problem, "rk4")
        naive.append(last / first)
        grown = max(grown, *(ratios[name] for name in problem.kept))
        right = right and all(ratios[name] <= LIVES for name in problem.kept)
        right = right and all(ratios[name] >= DIES for name in problem.lost)
        told.append(f"{problem.name}: " + ", ".join(f"{name} {_told(ratio)}" for name, ratio in ratios.items()))
    return Verdict(
        Measure(f"RK4: last tenth over first {', '.join(f'{x:.2g}' for x in naive)}", max(naive)),
        Measure("last tenth over first: " + "; ".join(told), grown),
        "at most 1.1 on reversible problems for every method (on a chaotic one for energy); on cvt_eps dla and perlmutter "
        "are told to grow, and do",
        right and min(naive) > 3.0,
    )


def _told(ratio: float) -> str:
    return f"{ratio:.2g}" if math.isfinite(ratio) else "does not come to the end"


def _errors(problem: Problem, method: str) -> tuple[float, float]:
    """(largest energy error in the first tenth, in the last); infinite where the run does not end."""
    source = read(str(spec_path(problem.system)))
    if problem.eps:
        source = replace(source, text=re.sub(r"eps: \{value: [0-9.]+", f"eps: {{value: {problem.eps}", source.text))
    job = open_scene(source, "reference", needs=("energy",), method=method)
    found = run_scene(replace(job, time=(0.0, END)), Settings(method, step=problem.step, points=ROWS))
    if found.ended != "done":
        return math.inf, math.inf
    off = [abs(row[0] - found.rows[0][0]) for row in found.rows]
    return max(off[: ROWS // 10]), max(off[-(ROWS // 10) :])


SCENARIO = Scenario("C8b", "energy over a very long time", "cvt_eps", run, slow=True)
