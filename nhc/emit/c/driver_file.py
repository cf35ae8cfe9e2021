"""``<s>_main.c``: a driver's own functions and what its template is told of them."""

from __future__ import annotations

from dataclasses import replace

from nhc.emit.c.driver import Method
from nhc.emit.c.either import find_largest_block
from nhc.emit.c.functions import PrintedFunction, print_function
from nhc.emit.c.literals import print_comment, print_string
from nhc.emit.c.names import print_singular
from nhc.emit.environment import File
from nhc.emit.statements import (
    Status,
    find_not_finite,
)
from nhc.program.ir import Function, Guard, Program, Solve


def print_driver(program: Program, context: dict[str, object]) -> File:
    """The file of a driver; ``context`` is from :func:`nhc.emit.c.driver.make_driver`."""
    driving, own = program.driving, set[str]()
    held, hold_context = make_hold_context(program, own)
    watched = make_watch_context(program, own)
    needed = driving.needed.function if driving.needed else None
    beats = driving.beats.function if driving.beats else None
    functions = [one for one in (driving.leaps.function if driving.leaps else None, beats) if one is not None]
    made = {
        "needed_size": needed.output.size if needed and needed.output else 0,
        "own": (
            *([watched["watch"]] if driving.lookout else []),
            *(print_function(program, function, own) for function in functions),
            *held,
            *([print_function(program, needed, own)] if needed else []),
        ),
        "collocations": False,
        "parts": driving.leaps.parts if driving.leaps else (),
        "held": tuple(print_string(print_comment(text)) for text in driving.leaps.held) if driving.leaps else (),
        "lands": driving.leaps is not None and driving.leaps.lands,
        "beats": beats.output.size if beats and beats.output else 0,
        "steady": driving.beats is not None and driving.beats.steady,
    }
    context = context | watched | hold_context | made | {"helpers": tuple(sorted(own))}
    return File(f"{program.system}_main.c", "c/model_main.c.jinja", context)


def make_watch_context(program: Program, helpers: set[str]) -> dict[str, object]:
    """What a driver's template uses of the values that it watches; their function is one of its own file."""
    watch = program.driving.lookout
    return {
        "watch": print_function(program, watch.function, helpers) if watch else None,
        "losses": tuple(print_string(print_comment(text)) for text in watch.losses) if watch else (),
        "first_dip": watch.dips if watch else 0,
        "watched": watch is not None,
        "events": 0,
        "dips": watch is not None,
        "hermite": watch is not None,
        "method": Method(),
    }


def make_hold_context(program: Program, helpers: set[str]) -> tuple[list[PrintedFunction], dict[str, object]]:
    """The functions that bring a state back, and what it uses of them; their status comes after all of the model's own."""
    hold, needed, code = program.driving.hold, program.driving.needed, find_not_finite(program) + 1
    functions: list[Function] = []
    for function in hold.functions if hold else ():
        body = tuple(replace(s, status=code) if isinstance(s, Solve | Guard) else s for s in function.body)
        functions.append(replace(function, body=body))
    return [print_function(program, function, helpers) for function in functions], {
        "holds": hold.calls if hold else (),
        "singular_hold": print_singular(program.system, code),
        "torn_hold": f"{program.system.upper()}_TORN",
        "hold_statuses": tuple(
            Status(code + k, print_string(print_comment(text))) for k, text in enumerate((hold.what, hold.torn))
        )
        if hold
        else (),
        "largest_block": find_largest_block([*functions, *([needed.function] if needed else [])]),
    }
