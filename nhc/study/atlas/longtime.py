"""C8: energy over a long time on a driven contact oscillator."""

from __future__ import annotations

from nhc.mechanics.about import scene_about
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.starts.scenes import start_of
from nhc.simulate.prepare import Recipe, prepare
from nhc.simulate.task import DONE, Task
from nhc.simulate.workshop import load
from nhc.study.atlas.scenario import Measure, Scenario, Verdict, grid, open_runner, open_system

END, STEP, ROWS = 2000.0, 0.2, 2001


def run() -> Verdict:
    """2000 units of time in steps of 0.2: RK4 of the multiplier form, and the nonholonomic leapfrog."""
    system, times = open_system("contact_oscillator"), grid(END, ROWS)
    naive = open_runner(system, "reference", "rk4", "multipliers", hold=False)
    rough = naive.run(times, step=STEP)
    energy = naive.checks(times, rough, "energy")[:, 0]
    grown = float(max(abs(energy - energy[0])))
    form = formulate(system, "multipliers")
    start = start_of(system, scene_about(system.spec, "reference"))
    job = prepare(Recipe(equations_of(system, form), system.q_names, checks=True), form, start, natural=True)
    model, _ = load(job, "leapfrog")
    outcome = model.integrate(Task(job.p, job.y, times, 1e-12, STEP), "leapfrog", model.news())
    place = len(job.columns) + next(k for k, column in enumerate(job.checks) if column.group == "energy")
    kept = [row[place] for row in model.quantities(times[: len(outcome.states)], outcome.states, job.p)]
    off, tenth = [abs(x - kept[0]) for x in kept], ROWS // 10
    first, last = max(off[:tenth]), max(off[-tenth:])
    return Verdict(
        Measure(f"RK4: the energy changes by {grown:.2g}", grown),
        Measure(f"leapfrog: by {first:.3f} in the first tenth, {last:.3f} in the last", last / first),
        "ratio of last to first tenth at most 1.1",
        grown > 10 * last and outcome.kind == DONE and last <= 1.1 * first,
    )


SCENARIO = Scenario("C8", "energy over a long time", "contact_oscillator", run)
