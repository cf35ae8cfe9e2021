"""Files that options name, read within bounds: an endless device or pipe ends with a message, not with the machine's memory."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from nhc.cli.terminal import Failure, describe_os_error

MIB = 1 << 20


def read_bounded(path: str, most: int, help: Sequence[str], *, stdin: bool = False) -> bytes:
    """The content of a file of at most ``most`` bytes, of standard input for ``-`` where ``stdin`` says so.

    Raises:
        Failure: it cannot be read, or there is more.
    """
    name = "standard input" if stdin and path == "-" else f"`{path}`"
    try:
        content = _read(path, most + 1, stdin)
    except OSError as error:
        raise Failure(f"cannot read {name}: {describe_os_error(error)}", help) from error
    except ValueError as error:  # closed, or a name with a zero byte
        raise Failure(f"cannot read {name}: {error}", help) from error
    if len(content) > most:
        raise Failure(f"{name} is larger than {most // MIB} MiB", help)
    return content


def _read(path: str, count: int, stdin: bool) -> bytes:
    if stdin and path == "-":
        if sys.stdin is None:
            raise ValueError("it is closed")
        return sys.stdin.buffer.read(count)
    with Path(path).open("rb") as stream:
        return stream.read(count)
