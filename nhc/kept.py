"""Files that nhc keeps from one run to the next: each is taken whole or not at all.

A kept file appears by a rename, so that a killed process leaves no part of it under its name, and its first line is the hash of
the rest, so that what a crash of the machine, a full disk or another program left of it is never used.
"""

from __future__ import annotations

import os
import re
import shutil
import time
from contextlib import suppress
from hashlib import sha256
from pathlib import Path

ABANDONED = 86400.0
"""Seconds after which what is still unfinished has no process that finishes it."""
_UNFINISHED = re.compile(r"\.[0-9a-f]{32,64}\.")


def recall(path: Path) -> bytes | None:
    """The content kept in ``path``; None without one, where it cannot be read, and where it is not what was kept."""
    try:
        mark, _, content = path.read_bytes().partition(b"\n")
    except OSError:
        return None
    return content if mark == hash_of(content) else None


def keep(path: Path, content: bytes) -> None:
    """Keep ``content`` in ``path``, whose folder is made where it is missing.

    Raises:
        OSError: the folder does not take it; nothing of it is left then.
    """
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        temporary.write_bytes(hash_of(content) + b"\n" + content)
        os.replace(temporary, path)
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)


def clear(folder: Path) -> None:
    """Remove what killed processes have left in ``folder``, from ``ABANDONED`` on.

    Only what is named by a dot and the hash of something kept: the folder is of the user's choice and may be their home.
    """
    for path in folder.glob(".*"):
        if not _UNFINISHED.match(path.name):
            continue
        with suppress(OSError):
            if time.time() - path.stat().st_mtime > ABANDONED:
                shutil.rmtree(path) if path.is_dir() else path.unlink()


def hash_of(content: bytes) -> bytes:
    """The SHA-256 of ``content`` in hexadecimal digits."""
    return sha256(content).hexdigest().encode()
