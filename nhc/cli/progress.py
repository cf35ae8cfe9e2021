"""How far a run has come."""

from __future__ import annotations

import sys
import time

from nhc.cli.terminal import is_terminal, say, terminal_width

QUIET = 30.0
"""Seconds after which a command that is not on a terminal says for the first time that it is at work."""


def show_line(text: str) -> None:
    """Put ``text`` in the place of a terminal's last line, as much of it as fits; nothing elsewhere."""
    width = terminal_width(sys.stderr) - 1  # a full line would begin the next one
    if width <= 0:
        return
    sys.stderr.write(f"\r{text[:width]:{width}}" + ("" if text else "\r"))
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
        self.wanted = is_terminal(sys.stderr)
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
        show_line(f"[{'#' * full}{'.' * (self.BAR - full)}] {100 * part:3.0f} %  {where}")
        self.shown = True

    def clear(self) -> None:
        """Take the bar away."""
        if self.shown:
            show_line("")


class Parts:
    """How much of several parts is done, and which is next: on a terminal, elsewhere a line whenever the clock strikes."""

    def __init__(self) -> None:
        self.clock = Clock()

    def show(self, part: float, what: str) -> None:
        """Say it; when all is done, take it away."""
        if is_terminal(sys.stderr):
            show_line(f"{100 * part:3.0f} %  {what}" if part < 1 else "")
        elif part < 1 and self.clock.strikes():
            say(f"after {self.clock.passed:.0f} s at {100 * part:.0f} %: {what}")
