"""How long steps are: the first one, and the next one by the error of this one."""

from __future__ import annotations

import math

from nhc.program.runs.limits import LIMITS
from nhc.simulate.methods.step import Step
from nhc.simulate.methods.tableau import Explicit, Tableau


def guess_length(step: Step, method: Tableau, duration: float) -> float:
    """The first step: the state moves by the part that the tolerance's root allows, with other methods by a hundredth.

    From a state at zero, which has no size, it is found from above: in very short steps what grows late has no digits yet.
    """
    trusted = isinstance(method, Explicit)
    part, longest = 0.01, (LIMITS.opening if trusted else 0.01) * abs(duration)
    if trusted and step.tolerance > 0:
        part = find_pace(step.tolerance, -1.0 / max(method.exponent, 1), 1.0, 0.0)
    size, speed = max(map(abs, step.y), default=0.0), max(map(abs, step.slope), default=0.0)
    wish = part * size / speed if size > 1e-5 and speed > 1e-5 else longest
    return min(wish, longest)


def limit_growth(method: Tableau) -> float:
    """How much longer than this one the next step may be."""
    return 10.0 if isinstance(method, Explicit) else 6.0


def find_growth(method: Tableau, error: float, former: float, refused: bool) -> float:
    """The next step's length by this one's: proportional and integral for explicit methods, whose ``error`` is squared.

    See ``LIMITS.integral`` for the formula.
    """
    q = max(method.exponent, 1)
    if not isinstance(method, Explicit):
        return float(0.9 * error ** (-1.0 / q))
    if refused:
        return LIMITS.caution * find_pace(error, 0.5 / q, 1.0, 0.0)
    return LIMITS.caution * find_pace(error, 0.5 * LIMITS.integral / q, former, 0.5 * LIMITS.proportional / q)


def find_pace(error: float, a: float, former: float, b: float) -> float:
    """error^-a former^b to 6 percent: logarithm and power are straight lines between the powers of two."""
    (x, i), (z, j) = math.frexp(error), math.frexp(former)
    power = b * (2.0 * z + j - 2.0) - a * (2.0 * x + i - 2.0)
    whole = math.floor(power)
    return math.ldexp(1.0 + (power - whole), whole)
