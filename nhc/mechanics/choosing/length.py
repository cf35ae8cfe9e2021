"""How long a coframe is beside the constraints that it completes."""

from __future__ import annotations

from nhc.algebra.walks import count
from nhc.mechanics.frame import Frame
from nhc.mechanics.system import System

_TIMES, _SPARE = 2, 100


def is_unwieldy(system: System, frame: Frame) -> bool:
    """Whether the velocities beside the constraints take far more operations than these, as expanded minors of long rows do.

    The frame's inverse and its derivatives take a multiple of that, where multipliers take the rows alone.
    """
    own = [x for form in frame.forms[system.l :] for x in form.direction]
    rows = [x for form in system.constraints for x in form.coefficients]
    return count(system.graph, own) > _TIMES * count(system.graph, rows) + _SPARE
