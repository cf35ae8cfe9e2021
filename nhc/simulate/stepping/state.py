"""What the loop around a Runge-Kutta method in Python keeps from step to step."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

from nhc.simulate.methods.step import Step
from nhc.simulate.methods.tableau import Tableau
from nhc.simulate.stepping.beating import Beating
from nhc.simulate.stepping.holding import Held
from nhc.simulate.stepping.leaping import Placed
from nhc.simulate.stepping.watching import Watching
from nhc.simulate.task import News, Outcome, Task

LEAST_ERROR = 1e-8  # explicit methods give the error's square


class Watched(Placed, Beating, Held, Watching, Protocol):
    """A model with values to watch."""

    @property
    def events(self) -> int: ...

    @property
    def watched(self) -> bool: ...

    @property
    def holds(self) -> Sequence[Sequence[str]]: ...


@dataclass
class Run:
    """``landing`` is the part of the last attempt at which it passes its first corner, ``landings`` such attempts in a row."""

    model: Watched
    method: Tableau
    task: Task
    news: News
    step: Step
    states: list[list[float]]
    steps: int = 0
    rejected: int = 0
    next: float = 0.0
    growth: float = 0.0
    former: float = LEAST_ERROR
    marked: int = 0
    stalls: int = 0
    stop: int = 0
    most: float = math.inf
    landing: float = 1.0
    landings: int = 0
    bound: float = 0.0
    since: float = 0.0
    back: Run | None = None
    before: list[float] = field(default_factory=list)
    ends: list[float] = field(default_factory=list)
    trend: list[float] = field(default_factory=list)
    span: float = 0.0
    halved: int = 0

    def leave(self, kind: int, status: int = 0) -> Outcome:
        s, counts = self.step, (self.steps, self.rejected, self.step.calls, self.step.jacobians)
        return Outcome(kind, status, s.t, list(s.y), s.h, *counts, self.states, s.size, self.ends)
