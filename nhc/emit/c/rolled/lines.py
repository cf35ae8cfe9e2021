"""What a loop is made of.  Only long C is rolled, so these are no part of a program."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from nhc.emit.statements import collect_refs
from nhc.program.ir import Guard, Let, Section, Statement, Store
from nhc.records import record

KEPT, CARRIED = "kept", "carried"
"""The arrays in which a function's and a sweep's values stand."""


@record
class Fetch:
    """In pass k ``name`` is entry ``first + step * k`` of an array."""

    name: str
    array: str
    first: int
    step: int


@record
class Leave:
    """In pass k the value of ``name`` goes to place ``first + step * k`` of the array that is handed on."""

    name: str
    first: int
    step: int = 0


@record
class Put:
    """In pass k an entry of the output, ``step`` entries further in each pass."""

    store: Store
    step: int


@record
class Loop:
    """``count`` passes over the body; what it binds is each pass's own; ``outside`` are the names that it takes from elsewhere."""

    count: int
    body: tuple[Fetch | Let | Leave | Put, ...]
    outside: frozenset[str]


Line = Statement | Loop | Leave


@record
class Body:
    """Lines, and the places of the values that they hand on; ``bound`` are the names that only loops have."""

    lines: tuple[Line, ...]
    places: Mapping[str, tuple[int, ...]]
    size: int
    bound: tuple[str, ...]


def list_needs(line: Line) -> frozenset[str]:
    """The names that a line uses and does not bind."""
    if isinstance(line, Loop):
        return line.outside
    if isinstance(line, Leave):
        return frozenset((line.name,))
    return collect_refs(line)


def count_lines(line: Line) -> int:
    """How long a line is, in statements."""
    return len(line.body) if isinstance(line, Loop) else 1


def may_roll(body: Sequence[Statement], longest: int) -> bool:
    """Whether a body is long, and made of what may stand in loops or beside them."""
    return len(body) > longest and all(isinstance(s, Section | Let | Guard | Store) for s in body)
