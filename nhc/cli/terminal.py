"""What the verbs say, where they say it, and with which exit code they end.

The result of a verb goes to stdout, everything else to stderr; colour is used on a terminal only and never under
``NO_COLOR``.
"""

from __future__ import annotations

import io
import json
import os
import shutil
import sys
from collections.abc import Sequence
from enum import IntEnum
from typing import Any, TextIO

from nhc.cli import INTERRUPTED
from nhc.cli.fitting import LEAST, fit
from nhc.version import __version__


class Exit(IntEnum):
    """The exit codes of ``nhc``; a script may rely on them."""

    DONE = 0
    FAILED = 1  # the spec has errors, or a check failed
    USAGE = 2
    NUMERICAL = 3
    INTERNAL = 70  # sysexits' EX_SOFTWARE
    INTERRUPTED = INTERRUPTED  # by Ctrl-C
    BROKEN_PIPE = 141  # 128 + SIGPIPE, as for any program whose reader left


class Failure(Exception):
    """A verb cannot go on, for a reason outside the text of a spec: a file is not there, or must not be replaced.

    ``notes`` say what is the case, ``help`` what to do.
    """

    def __init__(
        self, message: str, help: Sequence[str], code: str = "", exit: Exit = Exit.USAGE, notes: Sequence[str] = ()
    ) -> None:
        super().__init__(message)
        self.message = message
        self.help = tuple(help)
        self.notes = tuple(notes)
        self.code = code
        self.exit = exit

    def __str__(self) -> str:
        head = f"error[{self.code}]" if self.code else "error"
        lines = [f"{head}: {self.message}", *(f"  = note: {line}" for line in self.notes)]
        return "\n".join([*lines, *(f"  = help: {line}" for line in self.help)])


def closed(help: str = "give `-o FILE`, or leave stdout open") -> Failure:
    """That there is no stdout."""
    return Failure("stdout is closed", [help])


def put(text: str) -> None:
    """Write a result to stdout, with a final line break."""
    if sys.stdout is None:
        raise closed()
    sys.stdout.write(text if text.endswith("\n") else text + "\n")


def put_text(text: str, hanging: int | None = None) -> None:
    """The same for a text for people, which is fitted to a terminal's width; a pipe gets its lines whole."""
    width = terminal_width(sys.stdout)
    put(fit(text, width, hanging) if width else text)


def terminal_width(stream: TextIO | None) -> int:
    """The columns of a terminal; 0 for what is none."""
    return shutil.get_terminal_size().columns if is_terminal(stream) else 0


def narrow_width(stream: TextIO | None, usual: int) -> int:
    """The columns of a terminal that has fewer than usual; else 0."""
    width = terminal_width(stream)
    return max(width, LEAST) if 0 < width < usual else 0


def put_json(schema: str, data: dict[str, Any]) -> None:
    """Write ``data`` to stdout as JSON under a versioned schema name such as ``nhc.check/1``."""
    put(json.dumps({"schema": schema, "nhc": __version__, **data}, indent=2, ensure_ascii=False))


def say(text: str) -> None:
    """Write a message to stderr, if there is one; a terminal gets lines that fit."""
    if sys.stderr is None:
        return
    width = terminal_width(sys.stderr)
    text = fit(text, width) if width else text
    try:
        sys.stderr.write(text if text.endswith("\n") else text + "\n")
    except BrokenPipeError:
        raise
    except OSError:  # messages that find no room do not keep a result back
        sys.stderr = None


def is_terminal(stream: TextIO | None) -> bool:
    """Say whether ``stream`` is a terminal; one that is closed is none."""
    return stream is not None and stream.isatty()


def wants_colour(stream: TextIO | None) -> bool:
    """Say whether ``stream`` is a terminal that takes colour (NO_COLOR set and not empty, or a dumb terminal: no)."""
    return is_terminal(stream) and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def set_up_streams() -> None:
    """Make both streams UTF-8 with plain line feeds: emitted text is the same bytes on a pipe as in a file.

    Under ``PYTHONUNBUFFERED`` Python drops without an error what a full disk or a reader who left does not take of a long
    text; a buffer in front of the file writes all of it, or fails.
    """
    if isinstance(sys.stdout, io.TextIOWrapper) and isinstance(sys.stdout.buffer, io.RawIOBase):
        whole = io.BufferedWriter(io.FileIO(sys.stdout.fileno(), "w", closefd=False))
        sys.stdout = io.TextIOWrapper(whole, line_buffering=sys.stdout.isatty())
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(encoding="utf-8", newline="\n", errors="backslashreplace")


def silence_streams() -> None:
    """Point stdout to the null device, so that the interpreter's last flush does not complain about a closed pipe."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def describe_os_error(error: OSError) -> str:
    """Return the reason of ``error`` in lower case, without number and path: ``no such file or directory``."""
    return (error.strerror or str(error)).lower()
