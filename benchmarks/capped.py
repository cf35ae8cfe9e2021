"""Run something for at most so many seconds."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable
from dataclasses import dataclass
from types import FrameType
from typing import Generic, TypeVar

CAP = 60.0
T = TypeVar("T")


class TooLongError(Exception):
    """The time is used up."""


@dataclass(frozen=True)
class Timed(Generic[T]):
    """A result, or None where it was stopped; the seconds it took until then."""

    result: T | None
    seconds: float
    capped: bool


def run_capped(run: Callable[[], T], seconds: float = CAP) -> Timed[T]:
    """Call ``run`` in this process (main thread) and stop it after ``seconds``."""

    def stop(_: int, __: FrameType | None) -> None:
        raise TooLongError

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    start = time.perf_counter()
    try:
        result = run()
        return Timed(result, time.perf_counter() - start, False)
    except TooLongError:
        return Timed(None, time.perf_counter() - start, True)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
