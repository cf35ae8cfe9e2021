"""A function in a fixed order of elimination, and behind a small pivot the same with rows exchanged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.emit.c.large import list_all
from nhc.emit.c.lines import wrap_code
from nhc.emit.c.names import print_singular
from nhc.program.ir import Function, Solve
from nhc.program.planning.base import SINGULAR_FRAME
from nhc.records import record

ORDERED, EXCHANGED = "ordered", "exchanged"


@record
class Way:
    """A printed function: its definition's head, its body, what stands before it."""

    definition: str
    body: Sequence[str]
    parts: Sequence[str]


def find_largest_block(functions: Sequence[Function]) -> int:
    """The size of the largest dense solve in functions and what stands in for them."""
    every = [f for function in functions for f in (function, function.otherwise) if f]
    return max((len(s.matrix) for f in every for s in f.body if isinstance(s, Solve)), default=0)


def rename(other: Function, function: Function) -> Function:
    """What stands in for a function, under a name of its own."""
    return replace(other, name=f"{function.name}_{EXCHANGED}")


def print_either(prefix: str, function: Function, own: Way, other: Way) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Both ways, which stand before the function, and its body, which chooses."""
    name, scalar = f"{prefix}_{function.name}", function.output is None
    given, kind = ", ".join(argument.name for argument in list_all(function)), "double" if scalar else "int"
    good = "result == result" if scalar else f"result != {print_singular(prefix, SINGULAR_FRAME)}"
    parts = (
        *own.parts,
        "",
        *own.definition.replace(f"{kind} {name}(", f"static {kind} {name}_{ORDERED}(").split("\n"),
        "{",
        *own.body,
        "}",
        *other.parts,
        "",
        "/* rows are exchanged: for places where a pivot of the fixed order is small */",
        "#if defined(__GNUC__)",
        "__attribute__((cold, noinline))",
        "#endif",
        *other.definition.replace(f"{kind} {name}_", f"static {kind} {name}_").split("\n"),
        "{",
        *other.body,
        "}",
    )
    body = (
        *wrap_code(f"const {kind} result = {name}_{ORDERED}({given});", "    "),
        *wrap_code(f"return {good} ? result : {name}_{EXCHANGED}({given});", "    "),
    )
    return parts, body
