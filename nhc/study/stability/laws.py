"""By which law perturbations grow: exponentially, as a power of t, or by none that could be told.

Over a short time each looks like the other.  A power of t grows as much from T/2 to T as from T/4 to T/2, an exponential twice as
much, and sooner or later by more than any power does that a motion has.  An exponential is only told where the growth went on in
both parts of the last half, and was either strong or did not slow down.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from nhc.records import record

Series = NDArray[np.float64]

ROUNDING = 2.0**-53
_SEEN = 0.01 / ROUNDING  # growth by which rounding has come to one per cent of the motion
_LOOKS = (math.inf, 4.0, 2.0, 1.0)  # lengths of the scene: a strong growth may end, for the motion becomes another one
_STRONG, _CLEAR = 5.0, 2.5  # e-folds in the last half
_STEEPEST = 5.0  # powers of t above it are none that a motion grows by
_EXPLAINED = 0.5  # of the variation of log norm: a line that explains less says nothing of what comes
_FAR = 10.0  # times the look: what is beyond is far


@record
class Law:
    """``name`` is "exponential" (norm ~ exp(rate t)), "power" (norm ~ t^rate) or "none", from ``since`` to ``until``.

    ``horizon``: the time at which rounding of the start has grown to one per cent of the motion: the time when it has (``seen``),
    or by the exponential, or infinite where a power is far from it.  Otherwise it is no number, nor is the rate without a law.
    """

    name: str
    rate: float
    horizon: float
    since: float
    until: float
    seen: bool = False


def find_law(times: Sequence[float], norms: Sequence[float], scene: float) -> Law:
    """That of norms at equally spaced times, of which the first ``scene`` are the scene."""
    start, duration = times[0], times[-1] - times[0]
    t = (np.array(times) - start) / duration
    y = np.log(np.maximum(np.array(norms), 1e-300))
    parts = [min(lengths * scene / duration, 1.0) for lengths in _LOOKS]
    lines = ((part, _exponential(t, y, part, _STRONG if part < 1.0 else _CLEAR)) for part in parts)
    found = next(((part, *line) for part, line in lines if line is not None), None)
    law = (
        _by_exponential(start, duration, *found)
        if found
        else _by_power(start, duration, t, y, min(scene / duration, 1 / 3))
    )
    beyond = np.flatnonzero(np.array(norms) >= _SEEN)
    if len(beyond):
        return replace(law, horizon=float(times[beyond[0]]), seen=True)
    return law


def _exponential(t: Series, y: Series, part: float, least: float) -> tuple[float, float] | None:
    """(slope, base) of log norm in the last half of a part of the look, if it grows exponentially there."""
    slope, base = _line(t, y, 0.5 * part, part)
    before, first, second = (_line(t, y, x * part, z * part)[0] for x, z in ((0.25, 0.5), (0.5, 0.75), (0.75, 1.0)))
    folds = 0.5 * part * slope
    if folds < least or min(first, second) < 0.2 * slope:
        return None
    told = folds >= _STRONG or (slope > 0.75 * before and second > 0.8 * first)
    return (slope, base) if told else None


def _line(t: Series, y: Series, first: float, last: float) -> tuple[float, float]:
    """(slope, base) by least squares."""
    inside = (t >= first - 1e-9) & (t <= last + 1e-9)
    slope, base = np.polyfit(t[inside], y[inside], 1)
    return float(slope), float(base)


def _by_exponential(start: float, duration: float, part: float, slope: float, base: float) -> Law:
    reach = (math.log(_SEEN) - base) / slope
    since, until = (start + x * part * duration for x in (0.5, 1.0))
    return Law("exponential", slope / duration, start + duration * reach, since, until)


def _by_power(start: float, duration: float, t: Series, y: Series, first: float) -> Law:
    """A power of t over all but the first part, if it explains that; where the norm goes up and down, as beside a periodic motion,
    or grows by more than that, there is no law.
    """
    inside = t > first - 1e-9
    x, y, since, until = np.log(t[inside]), y[inside], start + first * duration, start + duration
    slope, base = (float(number) for number in np.polyfit(x, y, 1))
    rest = float(np.sum((y - slope * x - base) ** 2))
    if rest > (1.0 - _EXPLAINED) * float(np.sum((y - y.mean()) ** 2)) or slope > _STEEPEST:
        return Law("none", math.nan, math.nan, since, until)
    far = slope <= 1e-3 or (math.log(_SEEN) - base) / slope > math.log(_FAR)
    return Law("power", slope, math.inf if far else math.nan, since, until)
