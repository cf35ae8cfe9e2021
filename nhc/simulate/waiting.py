"""Work in a thread of its own, so that Ctrl-C is heard by the one that waits."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import TypeVar

from nhc.simulate.task import News

Result = TypeVar("Result")
Show = Callable[[float], None]


def wait_for(work: Callable[[], Result], news: News, show: Show | None) -> Result:
    """What ``work`` returns or raises; ``show`` is told the time in ``news`` some times a second, and Ctrl-C asks it to stop."""
    found: list[Result] = []
    broken: list[BaseException] = []

    def run() -> None:
        try:
            found.append(work())
        except BaseException as error:  # carried to the thread that waits
            broken.append(error)
        finally:
            done.set()

    # not Thread.join: an interrupt inside it makes the thread look finished
    done = threading.Event()
    threading.Thread(target=run, daemon=True).start()
    while not done.is_set():
        try:
            if not done.wait(0.1) and show is not None:
                show(news.t)
        except KeyboardInterrupt:
            news.stop = True
    if broken:
        raise broken[0]
    return found[0]
