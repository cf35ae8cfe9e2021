"""Fixed steps beyond an explicit method's stability: what decays or oscillates grows from step to step, and the run ends anywhere.

On a mode lambda a step h of a method multiplies by a polynomial of h lambda.  Where that lies in the left half of the plane farther
from zero than ``LIMITS`` says, the polynomial is larger than 1, whatever the mode's angle is.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from nhc.simulate.stiffness import fastest_mode
from nhc.simulate.switching import Leg

LIMITS = {"dop853": 6.8, "dopri5": 3.4, "rk4": 3.0}
"""Of h |lambda|: how far the region of stability reaches into the left half of the plane, at any angle."""
_LOOKS = 6  # states of each leg
_PART = 1 / 3  # of the states that are looked at: a short passage may do no harm


def tell_unstable(legs: Sequence[Leg]) -> tuple[str, ...]:
    """A note where the fixed steps of a run are beyond stability at a good part of the states that it went through."""
    looks, beyond = 0, list[tuple[float, float, float, str]]()
    for leg in legs:
        limit, outcome = LIMITS.get(leg.method), leg.outcome
        if limit is None or outcome.steps == 0:
            continue
        length = abs(outcome.t - leg.task.times[0]) / outcome.steps
        for k in _spread(len(outcome.states)):
            looks += 1
            t = leg.task.times[k]
            size = length * fastest_mode(leg.job, t, outcome.states[k])
            if isfinite(size) and size > limit:
                beyond.append((t, size, length, leg.method))
    if not beyond or len(beyond) < _PART * looks:
        return ()
    t, size, length, method = beyond[0]
    return (
        f"fixed steps of {length:.3g} are beyond the stability of {method} (h |lambda| = {size:.2g} at t = {t:.6g}, its limit is"
        f" {LIMITS[method]:.2g}): what should decay or oscillate grows; take shorter steps, or leave `--step` out",
    )


def _spread(count: int) -> list[int]:
    """Some of so many numbers, the first and the last among them."""
    return sorted({round(k * (count - 1) / (_LOOKS - 1)) for k in range(_LOOKS)}) if count else []
