"""What a user may have meant, and how names are shown."""

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


def suggest(name: str, known: Iterable[str], otherwise: str) -> str:
    """The question for the nearest known name, or what is said where none is near."""
    near = nearest(name, known)
    return f"did you mean `{near}`?" if near else otherwise


def several(count: int, noun: str) -> str:
    """``1 constraint``, ``2 constraints``."""
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"


def quote(names: Iterable[str]) -> str:
    """The names in back-ticks, with commas between them."""
    return ", ".join(f"`{name}`" for name in names)
