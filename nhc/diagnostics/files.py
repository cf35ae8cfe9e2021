"""Files to texts."""

from __future__ import annotations

import sys
from pathlib import Path

from .data import Bag, SpecError
from .source import Source, Span

LARGEST = 1 << 20  # bytes of a spec
STDIN = "<stdin>"


def _refuse(path: str, text: str, code: str, message: str, span: Span, help: str) -> SpecError:
    source = Source(path, text)
    bag = Bag(source)
    bag.error(code, message, span, help=(help,))
    return SpecError(bag.diagnostics, source)


def _read_bytes(path: str) -> bytes:
    if path == "-":
        if sys.stdin is None:  # it was closed before Python began
            raise ValueError("it is closed")
        return sys.stdin.buffer.read(LARGEST + 1)
    with Path(path).open("rb") as stream:
        return stream.read(LARGEST + 1)


def read_source(path: str) -> Source:
    """Return the text of a file, or of standard input for ``-``, by itself; line ends become ``\\n``.

    Raises ``SpecError`` where the file cannot be opened (E0101), is not UTF-8 (E0102) or is over 1 MiB (E0103).
    """
    return Source(STDIN if path == "-" else path, read_text(path))


def read_text(path: str) -> str:
    """Return the text of a file; raises like :func:`read_source`."""
    name = STDIN if path == "-" else path
    nowhere = Span(0, 0)
    try:
        data = _read_bytes(path)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        message = f"cannot read `{name}`: {reason.lower()}"
        help = "give the path of a spec, or `-` for standard input"
        raise _refuse(name, "", "E0101", message, nowhere, help) from None
    if len(data) > LARGEST:
        message = f"the file is larger than 1 MiB ({LARGEST} bytes)"
        raise _refuse(
            name, "", "E0103", message, nowhere, "name what repeats under `define:`, or take over a base by `extends:`"
        )
    data = data.removeprefix(b"\xef\xbb\xbf")
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        before = _lines(data[: error.start].decode("utf-8"))
        shown = _lines(data.decode("utf-8", errors="replace"))
        span = Span(len(before), len(before) + 1)
        message = f"byte 0x{data[error.start]:02x} is not UTF-8"
        raise _refuse(name, shown, "E0102", message, span, "save the file as UTF-8") from None
    return _lines(text)


def _lines(text: str) -> str:
    return text.replace("\r\n", "\n").replace("\r", "\n")
