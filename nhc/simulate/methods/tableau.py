"""Coefficients of Runge-Kutta methods: one source for the emitted C and for Python."""

from __future__ import annotations

from nhc.program.runs.limits import LIMITS
from nhc.records import record

Row = tuple[float, ...]


@record
class Explicit:
    """An explicit method whose last slope, at the new point, is the first of the next step.

    ``rows[i]`` are the weights of the slopes before stage ``i + 1``; the last of the first ``stages`` rows are
    those of the step itself. Further rows are stages that only the interpolant needs.  ``errors`` weigh all slopes
    of a step in its error estimates (none: fixed steps only).  The interpolant is, with x the part of the step and
    d the step's difference, y + x (d + (1 - x) (h f0 - d + x (2 d - h (f0 + f1) + (1 - x) (h D1 k + x (h D2 k +
    ...))))) with D the rows of ``dense``. ``exponent``: a step is scaled by error^(-1/exponent).
    ``trust``: the largest estimated error, relative to a refused step's end, with which that end still has the right size; beyond
    its stability a method ends anywhere.
    ``turn``: radians of a clock in a step up to which an estimate tells what the clock does (:mod:`nhc.program.runs.beats`).
    """

    name: str
    order: int
    citation: str
    nodes: Row
    rows: tuple[Row, ...]
    stages: int
    errors: tuple[Row, ...]
    dense: tuple[Row, ...]
    exponent: int
    trust: float = LIMITS.trust
    turn: float = LIMITS.turn

    @property
    def adaptive(self) -> bool:
        return bool(self.errors)


@record
class Collocation:
    """An implicit method: y_i = y + h a_ij f(t + c_j h, y_j), the step y + h b_j f_j.

    ``stiff``: the last stage is the step, and ``errors`` are the weights of the embedded estimate
    (pole - h J)^-1 (h f0 + errors_i (y_i - y)); without them the steps are fixed.
    ``trust``: as above; where Newton's iteration has solved a stiff step, its end has the right size, and the estimate of a motion
    that grows with a power of the time is off by 0.11 (t^4) to 0.83 (high powers) of it.
    """

    name: str
    order: int
    citation: str
    nodes: Row
    rows: tuple[Row, ...]
    advance: Row
    errors: Row
    pole: float
    exponent: int
    trust: float = 1.0
    turn: float = LIMITS.turn

    @property
    def adaptive(self) -> bool:
        return bool(self.errors)


Tableau = Explicit | Collocation
