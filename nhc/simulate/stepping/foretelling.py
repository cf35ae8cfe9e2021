"""Whether entries grow to the sizes that refused steps foretold, and the way back where they do not.

The same in C: ``templates/c/methods/foretold.c.jinja``.
"""

from __future__ import annotations

from nhc.program.runs.limits import LIMITS
from nhc.simulate.methods.explicit import find_errors
from nhc.simulate.methods.step import Step
from nhc.simulate.methods.tableau import Explicit, Tableau


def expect_foretold(s: Step) -> None:
    """A step is taken whose errors counted relative to foretold sizes: from here on, until the time for which they were
    foretold, it is watched whether they come.
    """
    if not s.expecting:
        s.expected, s.seen, s.summed_errors, s.until = [0.0] * len(s.y), s.size, [0.0] * len(s.y), s.t
    s.expected = [max(a, b) for a, b in zip(s.expected, s.foretold, strict=True)]
    s.until = s.until if s.expecting and abs(s.until - s.t) > abs(s.ahead) else s.t + s.ahead
    s.expecting = True


def look_on(s: Step, method: Tableau) -> None:
    """The step is taken: note the sizes that came with it, and its errors."""
    if isinstance(method, Explicit):
        s.errors = find_errors(s, method)
    s.seen = [max(a, abs(b)) for a, b in zip(s.seen, s.reached, strict=True)]
    s.summed_errors = [a + abs(b) for a, b in zip(s.summed_errors, s.errors, strict=True)]


def find_unmet(s: Step) -> list[bool]:
    """Which entries have not come to a tenth of the size that their errors were counted relative to, or may have come there
    by these errors alone.
    """
    rows = zip(s.seen, s.expected, s.summed_errors, strict=True)
    return [seen < 0.1 * size or (size > 0.0 and errors > 0.1 * seen) for seen, size, errors in rows]


def go_back(s: Step, back: Step) -> None:
    """Back to the first step that counted on sizes which did not come, with the sizes that came instead."""
    rows, less = zip(find_unmet(s), s.expected, s.seen, strict=True), 0.1 if s.returns + 1 < LIMITS.returns else 0.0
    foretold = [min(seen, less * size) if unmet else size for unmet, size, seen in rows]
    kept = {"calls": s.calls, "jacobians": s.jacobians, "returns": s.returns + 1, "ahead": s.until - back.t}
    vars(s).update(vars(back) | kept)
    s.foretold, s.first, s.status = foretold, True, 0
