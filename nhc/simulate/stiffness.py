"""Whether an explicit method's steps are held by its stability: their mean length times the size of the fastest mode.

The modes are those of the right-hand side's derivative where the run has come to.  Von Mises's iteration with differences
of the right-hand side finds the size of the largest eigenvalue without a Jacobian (as RKC does: B. P. Sommeijer, L. F. Shampine and
J. G. Verwer, J. Comput. Appl. Math. 88 (1998) 315-326).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import cos, inf, isfinite, sqrt

from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.prepare import Job

Slope = Callable[[Sequence[float]], Sequence[float]]
IMPLICIT = "radau5"
HELD = {"dop853": 3.0, "dopri5": 1.8}
"""Of h |lambda|: beyond this a step is as long as stability allows, about 6 and 3.3 on the negative axis."""
FREE = 1.0
"""Of h |lambda|: below this an implicit method takes steps that an explicit one could take as well."""
PAYS = 10.0
"""An implicit step costs about this many explicit ones; it has to be as much longer."""
FIRST, TRIAL, MORE = 400, 60, 4
"""Steps before the first look, steps of the implicit method's trial, and how much later each further look is."""
_TURNS, _COUNTED = 60, 20
_PART, _LEAST = 1e-7, 1e-13  # of the size of the state, over which differences are taken


def fastest_mode(job: Job, t: float, y: Sequence[float], length: float = inf) -> float:
    """|lambda| of the largest eigenvalue of d rhs / d y, roughly; 0 where the right-hand side has no value nearby.

    ``length``: of the steps, which are very short where the state is near to what the right-hand side changes by.
    """
    functions = tuple(f for f in job.program.functions if f.name == "rhs")
    model = InterpretedModel(replace(job.program, functions=functions), 0)
    try:
        return spectral_size(lambda at: model.rhs(t, at, job.p), y, length)
    except ArithmeticError:
        return 0.0


def spectral_size(slope: Slope, y: Sequence[float], length: float = inf) -> float:
    """The mean growth of a vector under repeated multiplication with the derivative of ``slope`` at y.

    Components are measured by their own size at y, or by a thousandth of the largest.  Differences are over what a step of this
    ``length`` changes, but for the digits of y, and no more than a small part of its size.
    """
    largest = max((abs(x) for x in y), default=0.0) or 1.0
    sizes = [max(abs(x), 1e-3 * largest) for x in y]
    base, x, grown = slope(y), [cos(1.0 + 2.0 * k) for k in range(len(y))], list[float]()
    change = max((abs(a) / s for a, s in zip(base, sizes, strict=True)), default=0.0)
    part = min(_PART, max(_LEAST, length * change)) if change > 0.0 else _PART
    for _ in range(_TURNS):
        norm = sqrt(sum(a * a for a in x))
        if not 0.0 < norm < float("inf"):
            return 0.0
        grown.append(norm)
        x = [a / norm for a in x]
        moved = slope([a + part * d * s for a, d, s in zip(y, x, sizes, strict=True)])
        x = [(b - a) / (part * s) for a, b, s in zip(base, moved, sizes, strict=True)]
    product, last = 1.0, grown[-_COUNTED:]
    for norm in last:
        product *= norm ** (1.0 / len(last))
    return product if isfinite(product) else 0.0
