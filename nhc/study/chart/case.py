"""What a chart consists of: cases, what came out of them, the reference, the machine."""

from __future__ import annotations

import math

from nhc.records import record

RESOLVED = 100.0
"""An error counts as resolved when it is this many times the reference's own."""


@record
class Case:
    """One run of the grid; ``language`` is c, python or the name of a peer; ``step`` is positive for fixed steps.

    ``tolerance`` is what the integrator is given for each step, or the rung of the ladder behind ``step``.
    """

    formulation: str
    method: str
    language: str
    tolerance: float
    step: float = 0.0

    @property
    def series(self) -> tuple[str, str, str]:
        """What a line of the chart stands for."""
        return self.formulation, self.method, self.language


@record
class Result:
    """What a case gave; not a number where there is nothing to measure.

    ``error``: the largest error of a needed quantity at the end, relative to that quantity's largest magnitude;
    ``grid_error``: the root of the mean square of these over the output grid; ``energy``: the largest deviation from the
    reference's energy, relative to its largest magnitude; ``residual``: the largest left side of a constraint.
    ``best`` and ``median`` are seconds of one run, of ``repeats`` measurements.  ``failed`` says why there is nothing.
    """

    case: Case
    error: float = math.nan
    grid_error: float = math.nan
    energy: float = math.nan
    residual: float = math.nan
    calls: int = 0
    jacobians: int = 0
    steps: int = 0
    rejected: int = 0
    best: float = math.nan
    median: float = math.nan
    repeats: int = 0
    unresolved: bool = False
    failed: str = ""


@record
class Reference:
    """How the reference was made, how its second method was, and the distance of the two: its own error, relative."""

    method: str
    confirmed_by: str
    arithmetic: str
    error: float
    energy_error: float


@record
class Cost:
    """What a formulation costs: the size of its state, the operations and the time in seconds of one right-hand side.

    ``left``: (entry, reason) of what a scene's model leaves out of the ``full_states`` entries of the whole state;
    ``twin``: the formulation whose code this one's is, statement for statement, so that its numbers are those of that one.
    """

    formulation: str
    number: str
    reason: str
    states: int
    operations: str
    c: float
    python: float
    left: tuple[tuple[str, str], ...] = ()
    full_states: int = 0
    twin: str = ""


@record
class Machine:
    """Where the numbers come from."""

    processor: str
    cores: int
    compiler: str
    flags: str
    python: str
    nhc: str

    @property
    def line(self) -> str:
        """All of it in one line."""
        cores = f"{self.cores} core" + ("s" if self.cores != 1 else "")
        parts = [f"{self.processor} ({cores})", f"{self.compiler} {self.flags}".strip(), f"Python {self.python}"]
        return "; ".join([*parts, f"nhc {self.nhc}"])


@record
class Study:
    """A chart's data.  ``left_out`` are (what, why); ``notes`` say what was changed, and what could not be had here."""

    system: str
    about: str
    scene: str
    time: tuple[float, float]
    needs: tuple[str, ...]
    tolerances: tuple[float, ...]
    methods: tuple[str, ...]
    languages: tuple[str, ...]
    points: int
    costs: tuple[Cost, ...]
    results: tuple[Result, ...]
    reference: Reference
    left_out: tuple[tuple[str, str], ...]
    notes: tuple[str, ...]
    machine: Machine
