"""C15: what a motion magnifies cannot be had to more digits than the start has."""

from __future__ import annotations

from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.starts.scenes import start_of
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_system
from nhc.study.stability.bench import open_bench
from nhc.study.stability.sensitivity import sensitivity

SYSTEMS = ("rattleback", "double_pendulum", "chaplygin_sleigh")
ROUNDING, WANTED = 1e-13, 1e-12


def run() -> Verdict:
    """The end of a scene by two methods at 1e-13, and how much the scene magnifies changes of its start."""
    told, worst, apart = [], 0.0, 0.0
    for name in SYSTEMS:
        system = open_system(name)
        form = formulate(system)
        bench = open_bench(equations_of(system, form), form, start_of(system, system.spec.scenes[0]))
        growth = max(1.0, sensitivity(bench, lengths=1).largest)
        one = bench.integrate("dop853", bench.times, tolerance=ROUNDING).y
        other = bench.integrate("dopri5", bench.times, tolerance=ROUNDING).y
        off = max(abs(a - b) / size for a, b, size in zip(one, other, bench.sizes, strict=True))
        told.append(f"{name}: magnified {growth:.2g} times, {off:.1e} apart")
        worst, apart = max(worst, off / (growth * ROUNDING)), max(apart, off)
    return Verdict(
        Measure(
            f"two methods at 1e-13 end up to {apart:.1e} apart: a comparison at 1e-12 condemns right results", apart
        ),
        Measure("; ".join(told) + f": {worst:.2g} times growth x 1e-13 at most", worst),
        "the laboratory's growth times 1e-13 predicts the difference within a factor of 100",
        apart > WANTED and worst < 100.0,
    )


SCENARIO = Scenario("C15", "conditioning of a result", "rattleback", run)
