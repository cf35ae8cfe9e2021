"""Structure-preserving runs: the emitted Python of M, dL/dq, A and T + V under the methods for natural systems."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence

from nhc.program.ir import Program
from nhc.simulate.interpreted import TextModel
from nhc.simulate.methods import STRUCTURE
from nhc.simulate.methods.linear import Matrix
from nhc.simulate.methods.step import NoSolution
from nhc.simulate.task import DONE, NO_SOLUTION, SINGULAR, STOPPED, TOO_MANY, News, Outcome, Task


class NaturalModel(TextModel):
    """A natural system; the rows of its outcomes are the program's states, like those of the other models.

    ``unit`` is what L is multiplied by, which leaves the motion the same: a power of 2 that brings masses near 1, so that what
    Newton's method takes for rounding, and the length that a discrete gradient is taken along, do not hang on the unit of mass.
    """

    def __init__(self, program: Program) -> None:
        super().__init__(program)
        self.n, self.l = len(program.coordinates), len(program.constraints)
        self.p: Sequence[float] = ()
        self.t, self.calls, self.unit = 0.0, 0, 1.0

    # --- the system as the methods see it

    def mass(self, q: Sequence[float]) -> Matrix:
        return self._block([self.unit * x for x in self.module.mass(self.t, q, self._still, self.p)], self.n)

    def rows(self, q: Sequence[float]) -> Matrix:
        return self._block(self.module.rows(self.t, q, self._still, self.p), self.l)

    def slope(self, q: Sequence[float], v: Sequence[float]) -> list[float]:
        self.calls += 1
        return [self.unit * x for x in self.module.slope(self.t, q, v, self.p)]

    def total(self, q: Sequence[float], v: Sequence[float]) -> float:
        values: list[float] = self.module.total(self.t, q, v, self.p)
        return self.unit * values[0]

    @property
    def _still(self) -> list[float]:
        return [0.0] * self.n

    def _block(self, flat: list[float], count: int) -> Matrix:
        return [flat[k * self.n : (k + 1) * self.n] for k in range(count)]

    def _find_unit(self, q: Sequence[float]) -> float:
        self.unit = 1.0
        largest = max((abs(x) for row in self.mass(q) for x in row), default=0.0)
        return math.ldexp(1.0, 1 - math.frexp(largest)[1]) if 0.0 < largest < math.inf else 1.0

    # --- the run

    def integrate(self, task: Task, method: str, news: News) -> Outcome:
        """Fixed steps to the end; rows between them by Hermite's cubic."""
        scheme, (start, end) = STRUCTURE[method], (task.times[0], task.times[-1])
        self.p, self.calls = task.p, 0
        count = max(1, math.ceil(abs(end - start) / task.step - 1e-9))
        h = (end - start) / count
        outcome = Outcome(DONE, 0, start, list(task.y), h, states=[list(task.y)])
        try:
            q = list(task.y[: self.n])
            self.unit = self._find_unit(q)
            v = self.module.velocities(start, task.y, task.p)
            point = scheme.start(self, q, v, h)
            for k in range(1, count + 1):
                if news.stop or k > task.most:
                    outcome.kind = STOPPED if news.stop else TOO_MANY
                    break
                point = scheme.advance(self, point, h)
                t = end if k == count else start + (end - start) * (k / count)
                q1, v1 = scheme.read(self, point, h)
                self._fill(task, outcome, outcome.t, h, (q, v), (q1, v1))
                q, v = q1, v1
                outcome.t, outcome.steps = t, k
                news.t = t
        except NoSolution:
            outcome.kind = NO_SOLUTION
        except ArithmeticError as error:
            outcome.kind, outcome.status = SINGULAR, getattr(error, "status", 0)
        outcome.calls = self.calls
        outcome.y = self.module.state(outcome.t, q, v, task.p)
        return outcome

    def _fill(
        self,
        task: Task,
        outcome: Outcome,
        t: float,
        h: float,
        before: tuple[list[float], list[float]],
        after: tuple[list[float], list[float]],
    ) -> None:
        """Rows of this step."""
        (q0, v0), (q1, v1) = before, after
        # late times are rounded by more than a billionth of a short step
        slack = 1e-9 + 4.0 * sys.float_info.epsilon * max(abs(task.times[0]), abs(task.times[-1])) / abs(h)
        while len(outcome.states) < len(task.times):
            time = task.times[len(outcome.states)]
            x = (time - t) / h
            if x > 1.0 + slack:
                return
            q, v = (q1, v1) if x >= 1.0 - slack else _hermite(x, h, q0, v0, q1, v1)
            outcome.states.append(self.module.state(time, q, v, task.p))


def _hermite(
    x: float, h: float, q0: list[float], v0: list[float], q1: list[float], v1: list[float]
) -> tuple[list[float], list[float]]:
    """Position and velocity at the part x of a step."""
    a, b = x * x * (3 - 2 * x), 6 * x * (1 - x) / h
    c, d = x * (1 - x) ** 2 * h, -x * x * (1 - x) * h
    e, f = (1 - x) * (1 - 3 * x), x * (3 * x - 2)
    rows = list(zip(q0, v0, q1, v1, strict=True))
    return (
        [s + a * (u - s) + c * w + d * z for s, w, u, z in rows],
        [b * (u - s) + e * w + f * z for s, w, u, z in rows],
    )
