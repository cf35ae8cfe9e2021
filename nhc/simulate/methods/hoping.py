"""Sizes to come that refused steps told: whether they come, and the way back (``templates/c/methods/hopes.c.jinja`` in Python)."""

from __future__ import annotations

from nhc.program.stepping import LIMITS
from nhc.simulate.methods.explicit import find_errors
from nhc.simulate.methods.step import Step
from nhc.simulate.methods.tableau import Explicit, Tableau


def count_on_hopes(s: Step) -> None:
    """A step is to be taken that was held to sizes to come: from here on it is looked whether they come, until the time for which
    they were told.
    """
    if not s.hoping:
        s.hope, s.seen, s.drift, s.until = [0.0] * len(s.y), s.size, [0.0] * len(s.y), s.t
    s.hope = [max(a, b) for a, b in zip(s.hope, s.coming, strict=True)]
    s.until = s.until if s.hoping and abs(s.until - s.t) > abs(s.ahead) else s.t + s.ahead
    s.hoping = True


def look_on(s: Step, method: Tableau) -> None:
    """The step is taken: what has come with it, and its errors."""
    if isinstance(method, Explicit):
        s.errors = find_errors(s, method)
    s.seen = [max(a, abs(b)) for a, b in zip(s.seen, s.reached, strict=True)]
    s.drift = [a + abs(b) for a, b in zip(s.drift, s.errors, strict=True)]


def find_hollow(s: Step) -> list[bool]:
    """Which entries have not come to a tenth of the size that they were held to, or may have come there by the errors of steps that
    were held to no less.
    """
    rows = zip(s.seen, s.hope, s.drift, strict=True)
    return [seen < 0.1 * hope or (hope > 0.0 and drift > 0.1 * seen) for seen, hope, drift in rows]


def go_back(s: Step, back: Step) -> None:
    """Back to the step that was held to sizes which did not come, with those that came instead."""
    rows, less = zip(find_hollow(s), s.hope, s.seen, strict=True), 0.1 if s.returns + 1 < LIMITS.returns else 0.0
    coming = [min(seen, less * hope) if hollow else hope for hollow, hope, seen in rows]
    kept = {"calls": s.calls, "jacobians": s.jacobians, "returns": s.returns + 1, "ahead": s.until - back.t}
    vars(s).update(vars(back) | kept)
    s.coming, s.first, s.status = coming, True, 0
