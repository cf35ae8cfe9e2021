"""Whether the interpolant of a step is as good as its end (``templates/c/methods/explicit.c.jinja``, ``is_wild``)."""

from __future__ import annotations

from nhc.program.runs.limits import LIMITS
from nhc.simulate.methods.step import Step
from nhc.simulate.methods.tableau import Explicit, Tableau


def has_more_stages(method: Tableau) -> bool:
    """Whether the interpolant has slopes of its own, which the estimate of the error knows nothing of."""
    return isinstance(method, Explicit) and len(method.rows) > method.stages


def is_wild(s: Step) -> bool:
    """Whether an entry is further off within the step than its rows may be.

    A mode that is too fast for the step is multiplied by the step times its rate in each further stage, so that it is much larger
    within than at the end, where it may not count.  The last terms of the interpolant then grow, which those of smooth motions do
    not.
    """
    assert s.shape is not None
    rows = zip(zip(*s.shape, strict=True), s.allowed(s.reached), strict=True)
    for terms, allowed in rows:
        last, before = abs(terms[-1]), abs(terms[-3]) + 2.0 * abs(terms[-2])
        if last > LIMITS.wild * before and last > LIMITS.within * allowed:
            return True
    return False
