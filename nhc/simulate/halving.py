"""The length of fixed steps that a wanted accuracy takes: halved until the rows agree with those of adaptive steps.

Two lengths that agree with each other prove little: a pulse that is shorter than both is in neither run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from math import ceil, inf, log
from typing import Protocol

from nhc.program.runs.limits import LEAST_TOLERANCE
from nhc.records import record
from nhc.simulate.task import STOPPED, Outcome, Task

REFERENCE = "dop853"
FIRST = 64  # steps
MOST_FOUND = 16  # halvings: steps beyond, four million, are taken only where they are asked for
MANY = 10  # halvings from which on errors must fall
BARREN = 3  # lengths in a row of which none has half the error of those before
LIKELY = 4.0  # by which a halving divides the error of a method of order 2
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


@record
class _Try:
    """Steps of ``step``, the first length halved ``halvings`` times; ``error`` in tolerances, infinite where they do not arrive."""

    halvings: int
    step: float
    error: float


def find_step(go: Run, adaptive: Run, task: Task, tolerance: float) -> tuple[Task, str]:
    """(the task with the length found, a note); ``adaptive`` runs it with steps of their own.

    Where adaptive steps do not come to the end, two lengths in turn are compared.  Once errors fall by the same factor from one
    length to the next, the length that the tolerance takes is tried next.
    """
    coarse, known = (
        adaptive(replace(task, tolerance=max(part * task.tolerance, LEAST_TOLERANCE), step=0.0, most=MOST_STEPS))
        for part in (1.0, 0.01)
    )
    sure = coarse.ended == known.ended and known.ended in ("done", "event")
    digits = _find_digits(coarse, known) if sure else []
    first = abs(task.times[-1] - task.times[0]) / FIRST
    former = known if sure else None
    tries, halvings = list[_Try](), 0
    while True:
        step = first / 2**halvings
        here = go(replace(task, step=step))
        if here.outcome.kind == STOPPED:
            return replace(task, step=step), f"steps of {step:.6g}: stopped while their length was looked for"
        error = inf if former is None else _measure(former, here, tolerance, digits)
        if error <= 1.0:
            found = "reach the tolerance (found by halving)"
            if not sure:
                found = f"agree with twice as long ones; {REFERENCE} could not confirm them ({known.reason})"
            return replace(task, step=step), f"steps of {step:.6g} {found}"
        tries.append(_Try(halvings, step, error))
        halvings, why = _foretell(tries)
        if why:
            best = min(tries, key=lambda one: (one.error, one.step))
            off = f", but come to {best.error:.2g} times it" if best.error < inf else ""
            return replace(task, step=best.step), f"steps of {best.step:.6g} do not reach the tolerance{off}: {why}"
        if not sure:
            former = here
            halvings = tries[-1].halvings + 1  # nothing is known of lengths between


def _foretell(tries: Sequence[_Try]) -> tuple[int, str]:
    """(halvings of the first length that are tried next, why none are): errors that fall by one factor with each halving go on so.

    Where they have stopped falling rounding is left, or runs fail.  Few steps tell nothing of this: a pulse may lie between them.
    """
    last, known = tries[-1], {one.halvings: one.error for one in tries}
    if last.error == inf and any(one.error < inf for one in tries) and last.halvings - 1 not in known:
        return last.halvings - 1, ""  # what was foretold fails
    if known.get(last.halvings + 1) == inf:
        return 0, "shorter ones fail"
    factor, sure = _find_factor(tries)
    needed = last.halvings + (max(1, ceil(log(last.error) / log(factor) - 0.1)) if factor > 1.0 else 1)
    if needed > MOST_FOUND and (sure or last.halvings >= MANY):
        if last.halvings < MANY:
            return MANY, ""
        return 0, f"that would take {'about' if sure else 'more than'} {FIRST * 2**needed} steps"
    best = min((one.error for one in tries[:-BARREN]), default=inf)
    if last.halvings >= MANY and len(tries) > BARREN and all(not one.error < 0.5 * best for one in tries[-BARREN:]):
        return 0, "shorter ones are no better"
    return needed if sure else last.halvings + 1, ""


def _find_factor(tries: Sequence[_Try]) -> tuple[float, bool]:
    """(by which each halving divides the error, whether the last two times agree on it); 0 where nothing is known."""
    if len(tries) < 3 or max(one.error for one in tries[-3:]) == inf:
        return 0.0, False
    one, other = (
        (before.error / after.error) ** (1.0 / (after.halvings - before.halvings))
        for before, after in pairwise(tries[-3:])
    )
    sure = abs(one - other) < 0.1 * other and other > 1.5
    return (other if sure else max(other, LIKELY)), sure


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


def _measure(known: Found, here: Found, tolerance: float, digits: Sequence[float]) -> float:
    """How far the rows are apart, each column beside its own largest magnitude, in tolerances; infinite where ends differ."""
    if here.ended != known.ended or here.ended not in ("done", "event") or len(here.rows) != len(known.rows):
        return inf
    allowed = [max(1e-300, tolerance * size) for size in _find_sizes(known)]
    allowed = [max(a, b) for a, b in zip(allowed, digits or allowed, strict=True)]
    late = abs(here.times[-1] - known.times[-1]) / max(1e-300, tolerance * abs(known.times[-1] - known.times[0]))
    apart = (
        abs(a - b) / most
        for one, other in zip(known.rows, here.rows, strict=True)
        for a, b, most in zip(one, other, allowed, strict=True)
    )
    return max(late, *apart)
