"""Whether the interpolant of a step is as good as its end (``templates/c/methods/explicit.c.jinja``, ``is_wild``)."""

from __future__ import annotations

from nhc.program.runs.limits import LIMITS
from nhc.simulate.methods.step import Step
from nhc.simulate.methods.tableau import Explicit, Tableau

_CUBIC = 3
"""Terms that the ends and their slopes give."""


def has_more_stages(method: Tableau) -> bool:
    """Whether the interpolant has slopes of its own, which the estimate of the error knows nothing of."""
    return isinstance(method, Explicit) and len(method.rows) > method.stages


def is_wild(s: Step) -> bool:
    """Whether an entry leaves, within the step, what its ends and their slopes tell, by more than may be told of it.

    Where a mode that decays fast has died away, steps become many times as long as it would let them be, until it is large enough
    at an end to count.  Each further stage multiplies it by the step times its rate, so that it is much larger in between.
    """
    assert s.shape is not None
    rows = zip(zip(*s.shape, strict=True), s.allowed(s.reached), strict=True)
    for terms, allowed in rows:
        last, known = abs(terms[-1]), sum(map(abs, terms[:_CUBIC]))
        if last > LIMITS.wild * known and last > LIMITS.within * allowed:
            return True
    return False
