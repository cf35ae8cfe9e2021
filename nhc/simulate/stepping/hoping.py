"""Whether entries grow to the sizes that refused steps foretold, and the way back where they do not.

The same in C: ``templates/c/methods/hopes.c.jinja``.
"""

from __future__ import annotations

from nhc.program.runs.limits import LIMITS
from nhc.simulate.methods.explicit import find_errors
from nhc.simulate.methods.step import Step
from nhc.simulate.methods.tableau import Explicit, Tableau


def count_on_hopes(s: Step) -> None:
    """A step is taken whose errors counted relative to foretold sizes: from here on, until the time for which they were
    foretold, it is watched whether they come.
    """
    if not s.hoping:
        s.hope, s.seen, s.drift, s.until = [0.0] * len(s.y), s.size, [0.0] * len(s.y), s.t
    s.hope = [max(a, b) for a, b in zip(s.hope, s.coming, strict=True)]
    s.until = s.until if s.hoping and abs(s.until - s.t) > abs(s.ahead) else s.t + s.ahead
    s.hoping = True


def look_on(s: Step, method: Tableau) -> None:
    """The step is taken: note the sizes that came with it, and its errors."""
    if isinstance(method, Explicit):
        s.errors = find_errors(s, method)
    s.seen = [max(a, abs(b)) for a, b in zip(s.seen, s.reached, strict=True)]
    s.drift = [a + abs(b) for a, b in zip(s.drift, s.errors, strict=True)]


def find_hollow(s: Step) -> list[bool]:
    """Which entries have not come to a tenth of the size that their errors were counted relative to, or may have come there
    by these errors alone.
    """
    rows = zip(s.seen, s.hope, s.drift, strict=True)
    return [seen < 0.1 * hope or (hope > 0.0 and drift > 0.1 * seen) for seen, hope, drift in rows]


def go_back(s: Step, back: Step) -> None:
    """Back to the first step that counted on sizes which did not come, with the sizes that came instead."""
    rows, less = zip(find_hollow(s), s.hope, s.seen, strict=True), 0.1 if s.returns + 1 < LIMITS.returns else 0.0
    coming = [min(seen, less * hope) if hollow else hope for hollow, hope, seen in rows]
    kept = {"calls": s.calls, "jacobians": s.jacobians, "returns": s.returns + 1, "ahead": s.until - back.t}
    vars(s).update(vars(back) | kept)
    s.coming, s.first, s.status = coming, True, 0
