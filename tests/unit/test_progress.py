"""What a long run says of itself."""

from __future__ import annotations

import io
import sys

import pytest

from nhc.cli import progress
from nhc.cli.progress import Parts, Progress


class Screen(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [100.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])
    return now


def test_a_line_after_ever_longer_times_where_there_is_no_terminal(
    clock: list[float], capsys: pytest.CaptureFixture[str]
) -> None:
    bar, part = Progress(0.0, 8.0), Progress(0.0, 1.0, "")
    for seconds in range(0, 130, 10):
        clock[0] = 100.0 + seconds
        bar.show(seconds / 100)
    part.show(0.25)
    bar.clear()
    lines = ["after 30 s at t = 0.3 of 8", "after 60 s at t = 0.6 of 8", "after 120 s at t = 1.2 of 8"]
    assert capsys.readouterr().err.splitlines() == [*lines, "after 120 s at 25 %"]


def test_a_bar_on_a_terminal(clock: list[float], monkeypatch: pytest.MonkeyPatch) -> None:
    screen = Screen()
    monkeypatch.setattr(sys, "stderr", screen)
    bar = Progress(0.0, 8.0)
    bar.show(1.0)
    assert screen.getvalue() == ""
    clock[0] += 40
    bar.show(4.0)
    assert "[" + "#" * 15 + "." * 15 + "]  50 %  t = 4" in screen.getvalue() and "\n" not in screen.getvalue()
    bar.clear()
    assert screen.getvalue().endswith("\r")


def test_parts_where_there_is_no_terminal(clock: list[float], capsys: pytest.CaptureFixture[str]) -> None:
    parts = Parts()
    for seconds, part in ((0, 0.0), (35, 0.25), (50, 0.5), (61, 0.75), (125, 1.0)):
        clock[0] = 100.0 + seconds
        parts.show(part, f"part {4 * part:.0f}")
    assert capsys.readouterr().err.splitlines() == ["after 35 s at 25 %: part 1", "after 61 s at 75 %: part 3"]
