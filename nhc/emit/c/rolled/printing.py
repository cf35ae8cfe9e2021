"""Loops in C: over doubles in a function, over vectors in a sweep and in lanes."""

from __future__ import annotations

from collections.abc import Callable

from nhc.emit.c.rolled.lines import Fetch, Leave, Loop, Put
from nhc.program.ir import Let

TURN = "turn"
"""The loop's counter."""


def print_index(first: int, step: int) -> str:
    """Entry ``first + step * turn``."""
    if not step:
        return str(first)
    if step < 0:
        return f"{first} - {TURN}" if step == -1 else f"{first} - {-step} * {TURN}"
    product = TURN if step == 1 else f"{step} * {TURN}"
    return f"{product} + {first}" if first else product


def print_factor(first: int, step: int) -> str:
    """The same where it is to be multiplied."""
    index = print_index(first, step)
    return index if index in (TURN, str(first)) else f"({index})"


def print_loop(
    lines: list[str],
    loop: Loop,
    add: Callable[[str], None],
    print_one: Callable[[Fetch | Let | Leave | Put], None],
) -> None:
    """The head, the body and the end of a loop; ``add`` and ``print_one`` write into ``lines``."""
    add("/* the same for one body of the chain after the other */")
    add(f"for (size_t {TURN} = 0; {TURN} < {loop.count}; ++{TURN}) {{")
    begin = len(lines)
    for line in loop.body:
        print_one(line)
    lines[begin:] = [f"    {text}" if text else text for text in lines[begin:]]
    add("}")
