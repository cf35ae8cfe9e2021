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
_SMALL = 1e-6  # beside the largest column: what is less may be rounding, which has no digits


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
    coarse, known = (
        adaptive(replace(task, tolerance=max(part * task.tolerance, LEAST_TOLERANCE), step=0.0, most=MOST_STEPS))
        for part in (1.0, 0.01)
    )
    sure = coarse.ended == known.ended and known.ended in ("done", "event")
    digits = _find_digits(coarse, known) if sure else []
    step = abs(task.times[-1] - task.times[0]) / FIRST
    former = known if sure else None
    found = "do not reach the tolerance: no more halvings were tried"
    for _ in range(MOST_HALVINGS):
        here = go(replace(task, step=step))
        if here.outcome.kind == STOPPED:
            break
        if former is not None and _is_close(former, here, tolerance, digits):
            found = "reach the tolerance (found by halving)"
            if not sure:
                found = f"agree with twice as long ones; {REFERENCE} could not confirm them ({known.reason})"
            break
        if not sure:
            former = here
        step /= 2
    return replace(task, step=step), f"steps of {step:.6g} {found}"


def _find_digits(coarse: Found, known: Found) -> list[float]:
    """Of each column what two adaptive runs leave open, if it is so small that this may be rounding."""
    sizes = _find_sizes(known)
    gaps = [
        max((abs(a - b) for a, b in zip(one, other, strict=False)), default=0.0)
        for one, other in zip(zip(*coarse.rows, strict=True), zip(*known.rows, strict=True), strict=True)
    ]
    most = _SMALL * max(sizes, default=0.0)
    rows = zip(sizes, gaps, strict=True)
    return [most if size == 0.0 else 10.0 * gap if size < most else 0.0 for size, gap in rows]


def _find_sizes(found: Found) -> list[float]:
    """The largest magnitudes of the columns."""
    return [max(map(abs, column)) for column in zip(*found.rows, strict=True)]


def _is_close(known: Found, here: Found, tolerance: float, digits: Sequence[float]) -> bool:
    """Whether all rows agree, each column beside its own largest magnitude, and end alike."""
    if here.ended != known.ended or here.ended not in ("done", "event") or len(here.rows) != len(known.rows):
        return False
    allowed = [max(1e-300, tolerance * size) for size in _find_sizes(known)]
    allowed = [max(a, b) for a, b in zip(allowed, digits or allowed, strict=True)]
    return abs(here.times[-1] - known.times[-1]) <= tolerance * abs(known.times[-1] - known.times[0]) and all(
        abs(a - b) <= most
        for one, other in zip(known.rows, here.rows, strict=True)
        for a, b, most in zip(one, other, allowed, strict=True)
    )
