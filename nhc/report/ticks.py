"""Round numbers for axes, and their spelling."""

from __future__ import annotations

import math

from nhc.records import record


@record
class Scale:
    """From values to places along an axis of ``length`` pixels; ``ticks`` are (place, label), ``grid`` further places."""

    low: float
    high: float
    log: bool
    length: float
    ticks: tuple[tuple[float, str], ...]

    def place(self, value: float) -> float:
        """Pixels from the axis's beginning; not a number for what a logarithmic axis cannot show."""
        if self.log:
            if not value > 0:
                return math.nan
            value = math.log10(value)
        return self.length * (value - self.low) / (self.high - self.low)


def linear_scale(low: float, high: float, length: float, count: int = 6, exact: bool = False) -> Scale:
    """An axis that holds [low, high], widened to round ends unless ``exact``."""
    if not low < high:
        half = max(abs(low), 1.0) * 0.5
        low, high = low - half, high + half
    step = _round_step((high - low) / count)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    if exact:
        first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    else:
        low, high = first * step, last * step
    values = [k * step for k in range(first, last + 1)]
    scale = Scale(low, high, False, length, ())
    ticks = tuple((scale.place(v), label(v, step)) for v in values)
    return Scale(low, high, False, length, ticks)


def log_scale(low: float, high: float, length: float, count: int = 10) -> Scale:
    """A logarithmic axis with whole decades; ``low`` and ``high`` are positive."""
    first, last = math.floor(math.log10(low) + 1e-9), math.ceil(math.log10(high) - 1e-9)
    last = max(last, first + 1)
    stride = max(1, math.ceil((last - first) / count))
    scale = Scale(float(first), float(last), True, length, ())
    ticks = tuple((length * (k - first) / (last - first), f"1e{k}") for k in range(first, last + 1, stride))
    return Scale(scale.low, scale.high, True, length, ticks)


def _round_step(wish: float) -> float:
    """1, 2 or 5 times a power of ten, not less than the wish by much."""
    power = 10.0 ** math.floor(math.log10(wish))
    return next(m * power for m in (1.0, 2.0, 5.0, 10.0) if m * power >= wish * 0.999)


def label(value: float, step: float) -> str:
    """A tick's text, without digits that say nothing."""
    if abs(value) < 1e-9 * step:
        return "0"
    if max(abs(value), step) >= 1e5 or step < 1e-4:
        digits = max(0, math.floor(math.log10(abs(value)) + 1e-9) - math.floor(math.log10(step) + 1e-9))
        mantissa, exponent = f"{value:.{digits}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    return f"{value:.{max(0, -math.floor(math.log10(step) + 1e-9))}f}"
