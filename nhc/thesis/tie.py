"""``@equation("I.4.9")`` ties a function to a number of the thesis."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

F = TypeVar("F", bound=Callable[..., object])

IMPLEMENTED: dict[str, list[str]] = {}
"""number -> qualified names of the functions that implement it (filled as modules are imported)."""


def equation(*numbers: str) -> Callable[[F], F]:
    """Tie a function to numbered equations of the thesis."""

    def tie(function: F) -> F:
        for number in numbers:
            place = f"{function.__module__}.{function.__qualname__}"
            names = IMPLEMENTED.setdefault(number, [])
            if place not in names:
                names.append(place)
        return function

    return tie
