"""The length of fixed steps that a wanted accuracy takes: halved until the rows agree with those of adaptive steps.

Two lengths that agree with each other prove little: a pulse that is shorter than both is in neither run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Protocol

from nhc.program.stepping import LEAST_TOLERANCE
from nhc.simulate.task import STOPPED, Outcome, Task

REFERENCE = "dop853"
MOST_HALVINGS = 20
FIRST = 64  # steps
MOST_STEPS = 1_000_000  # of the adaptive run
_LEAST = 1e-6  # of the largest column: what is zero but for rounding has no digits


class Found(Protocol):
    """What came out of a run, as :class:`nhc.simulate.run.Trajectory` has it."""

    @property
    def times(self) -> Sequence[float]: ...

    @property
    def rows(self) -> Sequence[Sequence[float]]: ...

    @property
    def outcome(self) -> Outcome: ...

    @property
    def ended(self) -> str: ...

    @property
    def reason(self) -> str: ...


Run = Callable[[Task], Found]


def find_step(go: Run, adaptive: Run, task: Task, tolerance: float) -> tuple[Task, str]:
    """(the task with the length found, a note); ``adaptive`` runs it with steps of their own.

    Where adaptive steps do not come to the end, two lengths in turn are compared.
    """
    finer = max(0.01 * task.tolerance, LEAST_TOLERANCE)
    known = adaptive(replace(task, tolerance=finer, step=0.0, most=MOST_STEPS))
    sure = known.ended in ("done", "event")
    step = abs(task.times[-1] - task.times[0]) / FIRST
    former = known if sure else None
    found = "do not reach the tolerance: no more halvings were tried"
    for _ in range(MOST_HALVINGS):
        here = go(replace(task, step=step))
        if here.outcome.kind == STOPPED:
            break
        if former is not None and _is_close(former, here, tolerance):
            found = "reach the tolerance (found by halving)"
            if not sure:
                found = f"agree with twice as long ones; {REFERENCE} could not confirm them ({known.reason})"
            break
        if not sure:
            former = here
        step /= 2
    return replace(task, step=step), f"steps of {step:.6g} {found}"


def _is_close(known: Found, here: Found, tolerance: float) -> bool:
    """Whether all rows agree, each column beside its own largest magnitude, and end alike."""
    if here.ended != known.ended or here.ended not in ("done", "event") or len(here.rows) != len(known.rows):
        return False
    sizes = [max(map(abs, column)) for column in zip(*known.rows, strict=True)]
    least = max(1e-300, _LEAST * max(sizes, default=0.0))
    allowed = [tolerance * max(size, least) for size in sizes]
    return abs(here.times[-1] - known.times[-1]) <= tolerance * abs(known.times[-1] - known.times[0]) and all(
        abs(a - b) <= most
        for one, other in zip(known.rows, here.rows, strict=True)
        for a, b, most in zip(one, other, allowed, strict=True)
    )
