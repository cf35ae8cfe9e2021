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
from contextlib import suppress
from typing import TYPE_CHECKING, Any, TypeVar

if TYPE_CHECKING:
    from multiprocessing.pool import IMapIterator

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
        results = pool.imap(_measure, texts)
        for _ in texts:
            yield _wait_for(results)


def _wait_for(results: IMapIterator[Any]) -> Any:
    """The next result; an interrupt that comes just before a wait is heard after it, and so no wait is long."""
    while True:
        with suppress(multiprocessing.TimeoutError):
            return results.next(0.2)


def _processors() -> int:
    """How many may be used; 1 where a fork is not safe, or other threads are at work."""
    if sys.platform != "linux" or threading.active_count() > 1:
        return 1
    return len(os.sched_getaffinity(0))


def _begin(work: Callable[[str], object]) -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the process that waits hears it, and ends these
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    _work[:] = [work]


def _measure(text: str) -> Any:
    return _work[0](text)
