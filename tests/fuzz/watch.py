"""Watches what the interpreter does while an input is read: nothing may be written, run or connected to."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import CodeType

_FORBIDDEN = (
    *(
        "compile",
        "subprocess",
        "os.system",
        "os.exec",
        "os.fork",
        "os.posix_spawn",
        "os.spawn",
        "os.startfile",
        "os.mkdir",
    ),
    *(
        "os.remove",
        "os.rename",
        "os.rmdir",
        "os.link",
        "os.symlink",
        "os.truncate",
        "os.chmod",
        "os.chown",
        "os.putenv",
    ),
    *(
        "shutil",
        "socket",
        "urllib",
        "http",
        "ftplib",
        "smtplib",
        "tempfile",
        "pickle.find_class",
        "ctypes.dlopen",
        "code.__new__",
    ),
    *("pty.spawn", "webbrowser"),
)
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND


class Watch:
    """Collects the audit events that must not happen between ``start`` and ``stop``."""

    def __init__(self) -> None:
        self.active = False
        self.seen: list[str] = []
        sys.addaudithook(self._hook)

    def _hook(self, event: str, arguments: tuple[object, ...]) -> None:
        if not self.active:
            return
        if event == "open":
            _, mode, flags = (*arguments, None, None)[:3]
            writes = isinstance(mode, str) and any(letter in mode for letter in "wax+")
            if writes or (isinstance(flags, int) and flags & _WRITING):
                self.seen.append(f"open {arguments[0]!r} for writing")
        elif event == "exec":
            code = arguments[0]  # a module that is imported late comes from a file; a text never does
            if not (isinstance(code, CodeType) and os.path.isfile(code.co_filename)):
                self.seen.append("exec")
        elif event.startswith(_FORBIDDEN):
            self.seen.append(f"{event} {arguments!r}"[:200])

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Watch the body, the reading of one input."""
        self.active = True
        try:
            yield
        finally:
            self.active = False
