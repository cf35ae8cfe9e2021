"""How far a run has come."""

from __future__ import annotations

import sys
import time

from nhc.cli.terminal import say

QUIET = 30.0
"""Seconds after which a command that is not on a terminal says for the first time that it is at work."""
WIDTH = 78


def rewrite_line(text: str) -> None:
    """On a terminal, put a line in place of the one before; an empty one takes it away."""
    if sys.stderr.isatty():
        sys.stderr.write(f"\r{text[:WIDTH]:{WIDTH}}" + ("" if text else "\r"))
        sys.stderr.flush()


class Clock:
    """The seconds that have passed, and whether it is time to say so: after half a minute, after one, two, four and so on."""

    def __init__(self) -> None:
        self._began, self._due = time.monotonic(), QUIET

    @property
    def passed(self) -> float:
        return time.monotonic() - self._began

    def strikes(self) -> bool:
        """Whether it is time."""
        late = self.passed >= self._due
        self._due *= 2 if late else 1
        return late


class Progress:
    """A bar on a terminal, after half a second; elsewhere a line whenever the clock strikes."""

    BAR = 30

    def __init__(self, start: float, end: float, what: str = "t") -> None:
        self.start, self.end, self.what = start, end, what
        self.clock = Clock()
        self.wanted = sys.stderr.isatty()
        self.shown = False

    def show(self, t: float) -> None:
        """Draw the part that is done."""
        part = min(max((t - self.start) / (self.end - self.start), 0.0), 1.0)
        if not self.wanted:
            if self.clock.strikes():
                done = f"{self.what} = {t:.6g} of {self.end:.6g}" if self.what else f"{100 * part:.0f} %"
                say(f"after {self.clock.passed:.0f} s at {done}")
            return
        if self.clock.passed < 0.5:
            return
        full = round(part * self.BAR)
        where = f"{self.what} = {t:.6g}" if self.what else ""
        rewrite_line(f"[{'#' * full}{'.' * (self.BAR - full)}] {100 * part:3.0f} %  {where}")
        self.shown = True

    def clear(self) -> None:
        """Take the bar away."""
        if self.shown:
            rewrite_line("")
