"""The end of a step, brought back to the constraints (``templates/c/methods/hold.c.jinja`` in Python)."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Protocol

from nhc.program.runs.hold import TORN_HOLD
from nhc.simulate.methods.step import Step


class Held(Protocol):
    """A model whose states can be brought back."""

    def hold(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]: ...


def hold_end(s: Step, model: Held, reach: float, first: bool) -> bool:
    """The step's end on the constraints; False where it has none.

    A step's drift is small beside its way: where it is not, also in shorter steps, a constraint jumps, as a sign or the branch of
    an angle does.  The first step also takes up what the start is off.
    """
    reached = s.reached
    try:
        s.reached = model.hold(reach, reached, s.p)
    except ArithmeticError as singular:
        s.status = getattr(singular, "status", 0)
        return False
    least = max(sys.float_info.min, 1e-6 * max(*s.size, *s.foretold))
    sizes = [
        max(size, foretold, abs(end), least) for size, foretold, end in zip(s.size, s.foretold, reached, strict=True)
    ]
    moved = max(abs(b - a) / size for a, b, size in zip(reached, s.reached, sizes, strict=True))
    way = max(abs(b - a) / size for a, b, size in zip(s.y, reached, sizes, strict=True))
    most = 1e-3 if s.tolerance > 0 and way > 2e-3 else 0.5 * way
    s.status = TORN_HOLD if not first and moved > 1e-5 + most else 0
    return s.status == 0
