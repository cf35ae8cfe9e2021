"""Round numbers for axes, and their spelling."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nhc.records import record

_LEAST_SPAN = 1e-12
"""Of the size of the values: what moves by less is rounding, and shows as a constant."""
_MOST_STEPS = 5e3  # from zero: further away, labels tell the distance from a number near them
_LARGE, _SMALL = 1e5, 1e-2
_FEW_DECADES = 2  # of an axis that has ticks between them
_LARGEST = 1e300  # beyond it spans overflow


@record
class Scale:
    """From values to places along an axis of ``length`` pixels; ``ticks`` are (place, label).

    ``note`` says what makes values of the labels, such as ``×1e8 + 0.25``; empty where they are the values.
    """

    low: float
    high: float
    log: bool
    length: float
    ticks: tuple[tuple[float, str], ...]
    note: str = ""

    def place(self, value: float) -> float:
        """Pixels from the axis's beginning; not a number for what a logarithmic axis cannot show."""
        if self.log:
            if not value > 0:
                return math.nan
            value = math.log10(value)
        return self.length * (value - self.low) / (self.high - self.low)


def linear_scale(low: float, high: float, length: float, count: int = 6, exact: bool = False) -> Scale:
    """An axis that holds [low, high], widened to round ends unless ``exact``."""
    low, high = max(low, -_LARGEST), min(high, _LARGEST)
    size = max(abs(low), abs(high))
    if size < 1.0 / _LARGEST:
        size = low = high = 0.0
    if not high - low > _LEAST_SPAN * size:
        half, middle = 0.5 * size or 0.5, 0.5 * low + 0.5 * high
        low, high = middle - half, middle + half
    step = _round_step((high - low) / count)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    if exact:
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    else:
        low, high = first * step, last * step
    values = [k * step for k in range(first, last + 1)]
    scale = Scale(low, high, False, length, ())
    labels, note = label(values, step)
    return Scale(low, high, False, length, tuple(zip(map(scale.place, values), labels, strict=True)), note)


def log_scale(low: float, high: float, length: float, count: int = 10) -> Scale:
    """A logarithmic axis with whole decades, at 2 and 5 too where these are few; ``low`` and ``high`` are positive."""
    first, last = math.floor(math.log10(low) + 1e-9), math.ceil(math.log10(high) - 1e-9)
    last = max(last, first + 1)
    stride = max(1, math.ceil((last - first) / count))
    scale = Scale(float(first), float(last), True, length, ())
    steps = (1, 2, 5) if last - first <= _FEW_DECADES else (1,)
    values = [(m, k) for k in range(first, last + 1, stride) for m in steps if k < last or m == 1]
    ticks = tuple((scale.place(float(f"{m}e{k}")), f"{m}e{k}") for m, k in values)
    return Scale(scale.low, scale.high, True, length, ticks)


def _round_step(wish: float) -> float:
    """1, 2 or 5 times a power of ten, not less than the wish by much."""
    power = 10.0 ** math.floor(math.log10(wish))
    return next(m * power for m in (1.0, 2.0, 5.0, 10.0) if m * power >= wish * 0.999)


def label(values: Sequence[float], step: float) -> tuple[list[str], str]:
    """Short texts of ticks that are a ``step`` apart, and what makes the values of them: a power of ten, what is to be added."""
    offset, added = _offset(values[0], values[-1]) if _size(values) > _MOST_STEPS * step else (0.0, "")
    left = [v - offset for v in values]
    size = _size(left)
    power = math.floor(math.log10(size) + 1e-9) if size >= _LARGE or 0.0 < size < _SMALL else 0
    unit = 10.0**power
    digits = max(0, power - math.floor(math.log10(step) + 1e-9))
    # rounding of what is far from zero is no sign: a tick within a thousandth of a step is at zero
    labels = ["0" if abs(v) < 1e-3 * step else f"{v / unit:.{digits}f}" for v in left]
    return labels, " ".join(part for part in (f"\u00d71e{power}" if power else "", added) if part)


def _size(values: Sequence[float]) -> float:
    return max(map(abs, values))


def _offset(low: float, high: float) -> tuple[float, str]:
    """A number of few digits near values that differ little, and its text behind a sign."""
    middle, span = 0.5 * low + 0.5 * high, high - low
    for power in range(math.floor(math.log10(abs(middle))), math.floor(math.log10(span)) - 1, -1):
        near = float(f"{round(middle / 10.0**power)}e{power}")
        if abs(near - middle) <= 5.0 * span:
            break
    return near, f"{'-' if near < 0 else '+'} {repr(abs(near)).removesuffix('.0')}"
