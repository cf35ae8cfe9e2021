"""What a user may have meant."""

from __future__ import annotations

from collections.abc import Iterable


def nearest(name: str, names: Iterable[str]) -> str | None:
    """Return the known name most like ``name``, or None where none is near."""
    known = list(dict.fromkeys(names))
    for other in known:
        if other.casefold() == name.casefold() and other != name:
            return other
    from difflib import get_close_matches  # needed for mistakes only, and slow to import

    found = get_close_matches(name, known, n=1, cutoff=0.6)
    return found[0] if found else None
