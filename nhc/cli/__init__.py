"""The command line: one module per verb, imported when the verb is used."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from types import FrameType

__all__ = ["main"]

INTERRUPTED = 130
"""128 + SIGINT, as shells have it.  It stands here because an interrupt may come before anything is imported."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run ``nhc`` with ``arguments`` (default: those of the process) and return its exit code.

    An interrupt ends it without a traceback whenever it comes, also while modules are imported.  A request to end (SIGTERM,
    SIGHUP) is an interrupt too, so that nothing unfinished stays behind; the exit code is then 128 + the signal's number.
    """
    received: list[int] = []
    with suppress(KeyboardInterrupt), _heard(received.append):
        from nhc.cli.entry import main as enter

        code = enter(arguments)
        if code != INTERRUPTED:
            return code
    return 128 + received[0] if received else INTERRUPTED


@contextmanager
def _heard(tell: Callable[[int], None]) -> Iterator[None]:
    """Make requests to end interrupts meanwhile; one that is handled otherwise, or ignored as under ``nohup``, stays so."""

    def end(number: int, frame: FrameType | None) -> None:
        tell(number)
        raise KeyboardInterrupt

    asked = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    changed = [number for number in asked if signal.getsignal(number) is signal.SIG_DFL]
    with suppress(ValueError):  # signals are the main thread's
        for number in changed:
            signal.signal(number, end)
    try:
        yield
    finally:
        with suppress(ValueError):
            for number in changed:
                signal.signal(number, signal.SIG_DFL)
