"""Models that do not hang on one another, measured in as many processes as there are processors.

A process is forked, so that it has the reference and all that was derived for it; elsewhere than on Linux they come one after
another.  What is measured is counted, never timed, and so the same either way.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

Result = TypeVar("Result")
_work: list[Callable[[str], object]] = []  # of a forked process, which inherits it


def measure_abreast(work: Callable[[str], Result], texts: Sequence[str]) -> Iterator[Result]:
    """``work`` of each text, in their order; ``work`` keeps its exceptions to itself, and its results can be pickled."""
    count = min(_processors(), len(texts))
    if count < 2:
        yield from map(work, texts)
        return
    # `with` ends the processes, whatever ends the loop
    with multiprocessing.get_context("fork").Pool(count, _begin, (work,)) as pool:
        yield from pool.imap(_measure, texts)


def _processors() -> int:
    """How many may be used; 1 where a fork is not safe, or other threads are at work."""
    if sys.platform != "linux" or threading.active_count() > 1:
        return 1
    return len(os.sched_getaffinity(0))


def _begin(work: Callable[[str], object]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that waits hears it, and ends these
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    _work[:] = [work]


def _measure(text: str) -> object:
    return _work[0](text)
