"""The mark by which nhc knows its own work: a hash of the text inside the text.

A renderer writes ``PLACEHOLDER`` once into one of the first lines; ``stamp`` replaces its zeros by the hash of all the
rest.  A file whose mark no longer fits its text was edited by hand, and is not overwritten unasked.
"""

from __future__ import annotations

import re
from hashlib import sha256

_DIGITS = 16
_LINES = 12  # a mark further down is part of the content, not of the header
_MARK = re.compile(rf"\bnhc:([0-9a-f]{{{_DIGITS}}})\b")

PLACEHOLDER = "nhc:" + "0" * _DIGITS


def stamp(text: str) -> str:
    """Return ``text`` with the hash of its content in its mark; stamping twice changes nothing.

    Raises ``ValueError`` when none of the first lines holds a mark: a template forgot it.
    """
    match = _find(text)
    if match is None:
        raise ValueError(f"no `{PLACEHOLDER}` in the first {_LINES} lines of the text to be stamped")
    blank = text[: match.start()] + PLACEHOLDER + text[match.end() :]
    return text[: match.start()] + "nhc:" + _hash(blank) + text[match.end() :]


def is_untouched(text: str) -> bool:
    """Say whether ``text`` carries a mark that fits it: it is as nhc wrote it."""
    return _find(text) is not None and stamp(text) == text


def _find(text: str) -> re.Match[str] | None:
    end = 0
    for _ in range(_LINES):
        end = text.find("\n", end) + 1
        if end == 0:
            end = len(text)
            break
    return _MARK.search(text, 0, end)


def _hash(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:_DIGITS]
