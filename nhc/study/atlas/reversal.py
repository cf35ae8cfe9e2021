"""C10: the rattleback's reversal, which low accuracy delays or loses."""

from __future__ import annotations

from nhc.simulate.task import DONE
from nhc.study.atlas.scenario import Measure, Runner, Scenario, Verdict, grid, open_runner, open_system

END, ROWS = 3.0, 6001
LATER, KNOWN = 12.0, (2.35118487, 11.46842521)
"""First reversals, spun against its sense and with it: an independent derivation by another program."""


def run() -> Verdict:
    """Spun at -5 rad/s against its sense: the first zero of the spin."""
    system = open_system("rattleback")
    coarse = open_runner(system, "wrong_way", "rk4")
    lost, _ = _reversal(coarse, 0.01)
    found, drift = _reversal(open_runner(system, "wrong_way", "dop853"))
    second, _ = _reversal(open_runner(system, "wrong_way", "gauss6"), 1e-3)
    later, _ = _reversal(open_runner(system, "right_way", "dop853"), end=LATER)
    apart = max(abs(found - second), abs(found - KNOWN[0]), abs(later - KNOWN[1]))
    told = "none at all" if lost == END else f"at {lost:.4f} s"
    return Verdict(
        Measure(f"RK4 with steps of 0.01 s: reversal within 3 s {told}", abs(lost - second)),
        Measure(
            f"dop853 at {found:.7f} s, in the other sense at {later:.5f} s; gauss6 and the catalogue within {apart:.1e} s; "
            f"energy changes by {drift:.1e} of itself",
            apart,
        ),
        "two methods and the catalogue within 1e-4 s, energy to 1e-6",
        abs(lost - second) > 0.05 and found < END and apart <= 1e-4 and drift <= 1e-6,
    )


def _reversal(runner: Runner, step: float = 0.0, end: float = END) -> tuple[float, float]:
    """(the first zero of the spin, or the end; the energy's relative change)."""
    times = grid(end, ROWS)
    outcome = runner.run(times, step=step)
    energy = runner.checks(times, outcome, "energy")[:, 0]
    drift = float(max(abs(energy - energy[0])) / abs(energy[0]))
    spins = [row[-1] for row in outcome.states]  # the last quasi-velocity
    if outcome.kind != DONE:
        return end, drift
    k = next((k for k in range(1, len(spins)) if (spins[k - 1] < 0) != (spins[k] < 0)), None)
    if k is None:
        return end, drift
    return times[k] - (times[k] - times[k - 1]) * spins[k] / (spins[k] - spins[k - 1]), drift


SCENARIO = Scenario("C10", "the rattleback's reversal", "rattleback", run)
