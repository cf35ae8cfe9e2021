"""How far a run has come."""

from __future__ import annotations

import sys
import time

from nhc.cli.terminal import say, terminal_width


def show_line(text: str) -> None:
    """Put ``text`` in the place of a terminal's last line, as much of it as fits; nothing elsewhere."""
    width = terminal_width(sys.stderr) - 1  # a full line would begin the next one
    if width <= 0:
        return
    sys.stderr.write(f"\r{text[:width]:{width}}" + ("" if text else "\r"))
    sys.stderr.flush()


def show_part(part: float, what: str) -> None:
    """Say on a terminal how much is done, and what is next; when all is, take it away."""
    show_line(f"{100 * part:3.0f} %  {what}" if part < 1 else "")


class Progress:
    """A bar on a terminal, after half a second; elsewhere a line after half a minute, after one, two, four and so on."""

    WIDTH = 30
    QUIET = 30.0  # seconds

    def __init__(self, start: float, end: float, what: str = "t") -> None:
        self.start, self.end, self.what = start, end, what
        self.began = time.monotonic()
        self.wanted = sys.stderr.isatty()
        self.shown = False
        self.due = self.QUIET

    def show(self, t: float) -> None:
        """Draw the part that is done."""
        passed = time.monotonic() - self.began
        part = min(max((t - self.start) / (self.end - self.start), 0.0), 1.0)
        if not self.wanted:
            if passed >= self.due:
                self.due *= 2
                done = f"{self.what} = {t:.6g} of {self.end:.6g}" if self.what else f"{100 * part:.0f} %"
                say(f"after {passed:.0f} s at {done}")
            return
        if passed < 0.5:
            return
        full = round(part * self.WIDTH)
        where = f"{self.what} = {t:.6g}" if self.what else ""
        show_line(f"[{'#' * full}{'.' * (self.WIDTH - full)}] {100 * part:3.0f} %  {where}")
        self.shown = True

    def clear(self) -> None:
        """Take the bar away."""
        if self.shown:
            show_line("")
