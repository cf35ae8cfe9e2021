"""A long body in several functions: compilers take more than twice as long over one that is twice as long.

A part finds what others have computed in an array, ``kept`` (doubles) or, inside a sweep, ``carried`` (vectors).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nhc.emit.c.body import BodyPrinter, wrap_code
from nhc.emit.statements import collect_refs
from nhc.program.ir import Argument, Evaluate, Function, Let, Load, Solve, Statement, Store, Sweep
from nhc.records import record

OWN = ("kept", "carried", "first", "seed", "slope", "offset", "entry", "status")
LONGEST, USUAL = 400, 250  # statements that one function may have; those of a part where there are more
RHS = 3  # how many times as long ``rhs`` may be, which must be fast above all: what parts leave for others costs stores and loads


@record
class Layout:
    """The parts of a body, and the names that one of them leaves for others, each with its place in ``kept``.

    ``divided``: there are several parts, or sweeps.
    """

    parts: tuple[tuple[Statement, ...], ...]
    kept: dict[str, int]
    divided: bool


def list_bound(statement: Statement) -> tuple[str, ...]:
    """The names that a statement computes; a load is repeated wherever it is needed."""
    if isinstance(statement, Let):
        return (statement.name,)
    if isinstance(statement, Solve):
        return tuple(name for column in statement.names for name in column)
    return ()


def cut(body: Sequence[Statement], longest: int, usual: int) -> tuple[tuple[Statement, ...], ...]:
    """The body in parts of about the usual length, or in one if that is not too long."""
    count = 1 if len(body) <= longest else -(-len(body) // usual)
    size = -(-len(body) // count) if body else 1
    return tuple(tuple(body[k : k + size]) for k in range(0, len(body), size))


def find_crossing(parts: Iterable[Iterable[Statement]]) -> dict[str, int]:
    """The names that are used in another part than they are computed in, numbered in the order of their computation."""
    home: dict[str, int] = {}
    crossing: set[str] = set()
    for number, part in enumerate(parts):
        for statement in part:
            crossing.update(name for name in collect_refs(statement) if home.get(name, number) != number)
            home.update((name, number) for name in list_bound(statement))
    return {name: place for place, name in enumerate(name for name in home if name in crossing)}


def lay_out(function: Function, body: tuple[Statement, ...]) -> Layout:
    """The parts of a body without its loads, calls and sweeps; a sweep counts as a part that uses what it uses."""
    sweeps = [(statement,) for statement in body if isinstance(statement, Sweep)]
    straight = [s for s in body if not isinstance(s, Evaluate | Load | Sweep)]
    longer = RHS if function.name == "rhs" else 1
    parts = cut(straight, longer * LONGEST, longer * USUAL) if function.output is not None else (tuple(straight),)
    return Layout(parts, find_crossing((*parts, *sweeps)), bool(sweeps) or len(parts) > 1)


def list_names(part: Iterable[Statement]) -> set[str]:
    """The names that the statements use and do not compute."""
    own = {name for statement in part for name in list_bound(statement)}
    return {name for statement in part for name in collect_refs(statement)} - own


def list_arguments(function: Function) -> tuple[Argument, ...]:
    """What a part may read: the function's inputs, and the outputs of the functions that it calls."""
    return (*function.inputs, *(Argument(s.array, s.size) for s in function.body if isinstance(s, Evaluate)))


def print_argument(name: str, size: int) -> str:
    """An input in a parameter list."""
    return f"double {name}" if size < 0 else f"const double *{name}"


def print_head(printer: BodyPrinter, function: Function, part: Sequence[Statement], own: Sequence[str]) -> None:
    """The first lines of a part: arguments that it does not read, its loads, and what it takes from others.

    ``own`` are the arguments besides the function's that it does use.
    """
    used = list_names(part)
    loads = tuple(s for s in function.body if isinstance(s, Load) and s.name in used)
    taken = [(name, place) for name, place in printer.kept.items() if name in used]
    read = {load.array for load in loads} | set(own) | ({"kept"} if taken else set())
    given = [*(argument.name for argument in list_arguments(function)), "kept"]
    printer.lines += [f"    (void){name};" for name in given if name not in read]
    printer.print_all(loads)
    printer.lines += [f"    const double {printer.scope[name]} = kept[{place}];" for name, place in taken]


def print_part(printer: BodyPrinter, function: Function, part: Sequence[Statement], name: str) -> list[str]:
    """A part of a function's straight code as a function of its own, from its first line to its last."""
    assert function.output is not None
    inner, output = printer.fork(), function.output.name
    inputs = [print_argument(argument.name, argument.size) for argument in list_arguments(function)]
    leaves = any(name in printer.kept for statement in part for name in list_bound(statement))
    stores = any(isinstance(statement, Store) for statement in part)
    arguments = ", ".join((*inputs, "double *kept", f"double *{output}"))
    head = wrap_code(f"static int {name}({arguments})", "")
    inner.lines += [] if stores else [f"    (void){output};"]
    print_head(inner, function, part, ("kept",) if leaves else ())
    inner.print_all(tuple(part))
    return ["", *head, "{", *inner.lines, f"    return {printer.prefix.upper()}_OK;", "}"]


def print_calls(printer: BodyPrinter, function: Function, names: Sequence[str]) -> list[str]:
    """The calls of the parts, one after the other; leave where one of them is singular."""
    assert function.output is not None
    given = [argument.name for argument in list_arguments(function)]
    arguments = ", ".join((*given, "kept", function.output.name))
    good = f"{printer.prefix.upper()}_OK"
    lines = wrap_code(f"int status = {names[0]}({arguments});", "    ")
    for name in names[1:]:
        lines += [f"    if (status == {good}) {{", *wrap_code(f"status = {name}({arguments});", " " * 8), "    }"]
    return [*lines, f"    if (status != {good}) {{", "        return status;", "    }"]
