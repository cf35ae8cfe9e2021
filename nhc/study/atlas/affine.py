"""C14: a moving constraint does work: the energy of the right motion changes, and testing it would condemn the right equations."""

from __future__ import annotations

from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.starts.scenes import start_of
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, open_system
from nhc.study.stability.bench import open_bench
from nhc.study.stability.drift import LongRun, long_run


def run() -> Verdict:
    """The ball on the turning table."""
    system = open_system("ball_on_table")
    form = formulate(system, "")
    bench = open_bench(equations_of(system, form), form, start_of(system, system.spec.scenes[0]))
    found: LongRun = long_run(bench, lengths=2)
    energy = bench.table[:, bench.group("energy")[0]]
    change = float(max(energy) - min(energy)) / float(max(abs(energy)))
    moving = [i.text for i in bench.conserved.integrals if i.moving]
    balance = max(found.drifts[0].series)
    return Verdict(
        Measure(f"the energy test fails the right motion: it changes by {100 * change:.0f} %", change),
        Measure(
            f"the balance of power closes to {balance:.1e}; moving energy found: {'; '.join(moving) or 'none'}", balance
        ),
        "balance of power closed to 1e-8, a moving energy found",
        change > 0.1 and balance < 1e-8 and bool(moving),
    )


SCENARIO = Scenario("C14", "energy that rightly changes", "ball_on_table", run)
