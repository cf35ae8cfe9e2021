"""What an integration is asked for and what comes out of it, whoever does it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from nhc.program.ir import Stop
from nhc.program.runs.limits import MOST_STEPS
from nhc.records import record

DONE, SINGULAR, UNDERFLOW, STOPPED, EVENT, TOO_MANY, NO_SOLUTION, CROSSED, STALLED, HELD = range(10)


@record
class Task:
    """``times``: the rows wanted, from the start to the end.  ``tolerance``: relative to each component's size so far;
    ``step``: fixed steps of at most that length, where positive.  ``stops``: where adaptive steps have to end
    (:mod:`nhc.program.runs.clock`), in the order of the run.  ``sizes``: the largest magnitudes of the state's entries before the
    start, where the task goes on with another one's run.  ``logged``: the ends of its steps are wanted, of a Runge-Kutta method.
    """

    p: Sequence[float]
    y: Sequence[float]
    times: Sequence[float]
    tolerance: float
    step: float = 0.0
    most: int = MOST_STEPS
    stops: Sequence[Stop] = ()
    sizes: Sequence[float] = ()
    logged: bool = False


@dataclass(slots=True)
class Outcome:
    """``kind`` is one of the constants above, ``status`` the model's code (SINGULAR), the watched value's index, or the argument's
    at whose jump the motion is HELD (:class:`nhc.program.ir.Leaps`).

    ``states`` are the rows that were reached; ``t, y`` is where it ended, ``h`` the last step's length; ``sizes`` are the largest
    magnitudes of the entries so far, of methods that look at them; ``ends`` are the ends of its steps, where the task wants them.
    """

    kind: int
    status: int
    t: float
    y: list[float]
    h: float
    steps: int = 0
    rejected: int = 0
    calls: int = 0
    jacobians: int = 0
    states: list[list[float]] = field(default_factory=list)
    sizes: list[float] = field(default_factory=list)
    ends: list[float] = field(default_factory=list)


class News:
    """Shared with whoever waits for the integration: the time reached, a wish to stop, and of many starts how many ended."""

    def __init__(self) -> None:
        self.t = 0.0
        self.stop = False
        self.done = 0


class ModelError(ArithmeticError):
    """A quantity of a run cannot be computed: the model is singular at row ``row``, with the emitted ``status``."""

    def __init__(self, row: int, status: int) -> None:
        super().__init__(f"singular at row {row}, status {status}")
        self.row, self.status = row, status
