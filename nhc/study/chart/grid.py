"""What a chart runs by itself, and what it can be asked for."""

from __future__ import annotations

from nhc.records import record
from nhc.simulate.changes import UNCHANGED, Changes

METHODS = ("dop853", "dopri5", "rk4", "radau5", "gauss6")
STRUCTURE = ("leapfrog", "dla", "perlmutter", "energy")
LANGUAGES = ("c", "python")
TOLERANCES = tuple(float(f"1e-{k}") for k in range(2, 14))
POINTS = 65
SCOUT = "dop853"  # looks how long a scene is
PYTHON_STRIDE = 3  # the interpreter takes every third rung of the default ladder
MOST_PYTHON = 4000  # right-hand sides of an interpreted run that is still worth its time


@record
class Grid:
    """What to chart; empty: what nhc takes by itself.

    ``changes``: of the scene; ``budget``: seconds for the repeats of one case.
    """

    scene: str = ""
    needs: tuple[str, ...] = ()
    formulations: tuple[str, ...] = ()
    methods: tuple[str, ...] = ()
    languages: tuple[str, ...] = ()
    tolerances: tuple[float, ...] = ()
    peers: bool = True
    changes: Changes = UNCHANGED
    budget: float = 0.008


@record
class Runs:
    """With what each formulation of a chart is run.

    ``tolerances``: from coarse to fine; ``explicit``: the user named them, so that each is run, however slow; ``budget``: seconds
    for the repeats of one case.
    """

    languages: tuple[str, ...]
    tolerances: tuple[float, ...]
    explicit: bool
    budget: float


def settle_runs(grid: Grid, compiled: bool) -> Runs:
    """What a grid asks for, with what nhc takes by itself; without a compiler (``compiled`` False) in Python alone."""
    languages = tuple(x for x in grid.languages or LANGUAGES if compiled or x != "c") or ("python",)
    tolerances = tuple(sorted(grid.tolerances or TOLERANCES, reverse=True))
    return Runs(languages, tolerances, bool(grid.tolerances), grid.budget)
