"""The compiled right-hand side as SciPy and SUNDIALS call it: through ctypes, as their users do."""

from __future__ import annotations

import ctypes
from typing import Any, Literal

from nhc.study.chart.model import doubles
from nhc.study.chart.single import Rig

MOST_CALLS = 10_000
Rows = Literal["grid", "end", "steps"]
"""What is asked of a peer: the rows of the reference, the end alone, or those of its own steps."""


class TooManyCalls(Exception):
    """A peer's run is stopped."""


class Slope:
    """y'(t, y) of a rig's compiled model as an array of its own; ``calls`` counts.

    Raises, when called:
        ArithmeticError: it is singular there.
        TooManyCalls: there were enough.
    """

    def __init__(self, rig: Rig) -> None:
        import numpy as np

        self.function = getattr(rig.right_side.library, f"{rig.job.program.system}_slope")
        self.function.argtypes = (ctypes.c_double, ctypes.c_void_p, ctypes.POINTER(ctypes.c_double), ctypes.c_void_p)
        self.p = doubles(rig.job.p)
        self.state, self.slope = np.empty(len(rig.job.y)), np.empty(len(rig.job.y))
        self.into, self.out = self.state.ctypes.data, self.slope.ctypes.data
        self.calls = 0

    def __call__(self, t: float, y: Any) -> Any:
        self.calls += 1
        if self.calls > MOST_CALLS:
            raise TooManyCalls(f"stopped after {MOST_CALLS} right-hand sides")
        self.state[:] = y
        if self.function(t, self.into, self.p, self.out):
            raise ArithmeticError(f"singular at t = {t:.6g}")
        return self.slope.copy()


def absolute_tolerance(rig: Rig, tolerance: float) -> float:
    """Like nhc's own: relative to the size of the state, where a component is small."""
    return tolerance * 1e-6 * max(1e-3, *(abs(x) for x in rig.job.y))
