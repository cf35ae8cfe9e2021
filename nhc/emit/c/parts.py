"""A long body in several functions: compilers take more than twice as long over one that is twice as long.

A part finds what others have computed in an array, ``kept`` (doubles) or, inside a sweep, ``carried`` (vectors), and reads it
just before it is first needed: what compilers take longest over is finding places for values that live at once.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

from nhc.emit.c.body import BodyPrinter
from nhc.emit.c.dense import list_entries
from nhc.emit.c.lines import Block, Blocks, wrap_code
from nhc.emit.statements import ZERO, collect_refs
from nhc.program.ir import Argument, Evaluate, Function, Let, Load, Section, Solve, Statement, Store, Sweep
from nhc.records import record

OWN = ("kept", "carried", "first", "seed", "slope", "offset", "entry", "status")
SLOW = frozenset(
    ("velocities", "accelerations", "state", "residuals", "positions", "reactions", "energy", "jacobian", "outputs")
)  # functions that no integrator calls at each stage: where they are long, they shall be compiled soon above all
LONG = 40  # statements from which on this holds
LENGTHS = (250, 200)  # statements that one function may have, those of a part where there are more
RHS_LENGTHS = (1200, 750)  # it must be fast above all: what parts leave for others costs stores and loads


@record
class Layout:
    """The parts of a body, and the names that one of them leaves for others, each with its place in ``kept``.

    ``divided``: there are several parts, or sweeps.  ``blocks``: the dense solves that parts fill, in the first ``size`` places.
    """

    parts: tuple[tuple[Statement, ...], ...]
    kept: dict[str, int]
    divided: bool
    blocks: Blocks
    size: int


def list_bound(statement: Statement) -> tuple[str, ...]:
    """The names that a statement computes; a load is repeated wherever it is needed."""
    if isinstance(statement, Let):
        return (statement.name,)
    if isinstance(statement, Solve):
        return tuple(name for column in statement.names for name in column)
    return ()


def choose_lengths(function: Function) -> tuple[int, int]:
    """The statements that a function may have, and those of its parts where it has more."""
    return RHS_LENGTHS if function.name == "rhs" else LENGTHS


def is_long(function: Function, body: Sequence[Statement]) -> bool:
    """Whether a function that is called seldom is so long that the compiler shall not take pains over it."""
    straight = [s for s in body if not isinstance(s, Evaluate | Load | Sweep)]
    return function.name in SLOW and (len(straight) > LONG or any(isinstance(s, Sweep) for s in body))


def cut(body: Sequence[Statement], longest: int, usual: int) -> tuple[tuple[Statement, ...], ...]:
    """The body in parts of about the usual length, or in one if that is not too long."""
    count = 1 if len(body) <= longest else -(-len(body) // usual)
    size = -(-len(body) // count) if body else 1
    return tuple(tuple(body[k : k + size]) for k in range(0, len(body), size))


def find_crossing(parts: Iterable[Iterable[Statement]]) -> dict[str, int]:
    """The names that one part of a function computes and another uses, each with its place in the array that is handed on."""
    home: dict[str, int] = {}
    crossing: set[str] = set()
    for number, part in enumerate(parts):
        for statement in part:
            if number:  # the first part has nothing from others
                crossing.update([name for name in collect_refs(statement) if home.get(name, number) != number])
            for name in list_bound(statement):
                home[name] = number
    return {name: place for place, name in enumerate([name for name in home if name in crossing])}


def find_tail(straight: Sequence[Statement]) -> int:
    """Where a dense solve begins after which only stores come: they take its unknowns from where it leaves them."""
    solves = [place for place, statement in enumerate(straight) if isinstance(statement, Solve)]
    if solves and all(isinstance(s, Section | Store) for s in straight[solves[-1] + 1 :]):
        return solves[-1]
    return len(straight)


def lay_out(function: Function, body: tuple[Statement, ...]) -> Layout:
    """The parts of a body without its loads, calls and sweeps; a sweep counts as a part that uses what it uses."""
    sweeps = [(statement,) for statement in body if isinstance(statement, Sweep)]
    straight, blocks, places, size = spread(function, [s for s in body if not isinstance(s, Evaluate | Load | Sweep)])
    end = find_tail(straight)
    parts = cut(straight[:end], *choose_lengths(function)) if function.output is not None else (tuple(straight[:end]),)
    if end < len(straight):
        parts = (*parts[:-1], (*(parts[-1] if parts else ()), *straight[end:]))
    crossing = {name: size + place for name, place in find_crossing((*parts, *sweeps)).items()}
    return Layout(parts, crossing | places, bool(sweeps) or len(parts) > 1, blocks, size)


def spread(function: Function, straight: Sequence[Statement]) -> tuple[list[Statement], Blocks, dict[str, int], int]:
    """Long dense solves as stores of their entries, which parts may share, and solves of what is then in ``kept``.

    These bind no names: the unknowns have their places in ``kept``.
    """
    made: list[Statement] = []
    blocks, places, size = Blocks(), dict[str, int](), 0
    for statement in straight:
        entries = list_entries(statement) if isinstance(statement, Solve) and function.name in SLOW else []
        if not isinstance(statement, Solve) or len(entries) - entries.count(ZERO) <= LENGTHS[0]:
            made.append(statement)
            continue
        made += [Store("kept", size + k, entry) for k, entry in enumerate(entries) if entry != ZERO]
        rows, columns = statement.matrix, statement.columns
        mark = (("kept", str(size)),)
        made.append(
            replace(
                statement,
                matrix=tuple((ZERO,) * len(row) for row in rows),
                columns=tuple((ZERO,) * len(column) for column in columns),
                names=mark,
            )
        )
        blocks[mark] = Block(size, statement.masses)
        width = len(rows) + len(columns)
        for c, names in enumerate(statement.names):
            places |= {name: size + i * width + len(rows) + c for i, name in enumerate(names)}
        size += len(entries)
    return made, blocks, places, size


def list_names(part: Iterable[Statement]) -> set[str]:
    """The names that the statements use and do not compute."""
    own = {name for statement in part for name in list_bound(statement)}
    return {name for statement in part for name in collect_refs(statement)} - own


def list_arguments(function: Function) -> tuple[Argument, ...]:
    """What a part may read: the function's inputs, and the outputs of the functions that it calls."""
    return (*function.inputs, *(Argument(s.array, s.size) for s in function.body if isinstance(s, Evaluate)))


def print_slow(printer: BodyPrinter, function: Function) -> str:
    """What stands before a part of a function, or a function, that is called seldom; nothing for others."""
    if function.name not in SLOW:
        return ""
    printer.helpers.add("slow")
    return f"{printer.prefix.upper()}_SLOW "


def print_argument(name: str, size: int) -> str:
    """An input in a parameter list."""
    return f"double {name}" if size < 0 else f"const double *{name}"


def find_sources(printer: BodyPrinter, function: Function, part: Sequence[Statement]) -> dict[str, Load | str]:
    """Where a part has the names from that it uses and does not compute: loads of its own, lines that read ``kept``."""
    used = list_names(part)
    found: dict[str, Load | str] = {s.name: s for s in function.body if isinstance(s, Load) and s.name in used}
    taken = {name: place for name, place in printer.kept.items() if name in used}
    return found | {name: f"const double {printer.scope[name]} = kept[{place}];" for name, place in taken.items()}


def print_unread(
    printer: BodyPrinter, function: Function, sources: Mapping[str, Load | str], own: Sequence[str]
) -> None:
    """The first lines of a part: the arguments that it does not read; ``own`` are those that it writes."""
    read = {source.array for source in sources.values() if isinstance(source, Load)} | set(own)
    read |= {"kept"} if any(isinstance(source, str) for source in sources.values()) else set()
    given = [*(argument.name for argument in list_arguments(function)), "kept"]
    printer.lines += [f"    (void){name};" for name in given if name not in read]


def print_in_turn(
    printer: BodyPrinter,
    part: Sequence[Statement],
    sources: Mapping[str, Load | str],
    print_one: Callable[[Statement], None],
) -> None:
    """The statements of a part, before each what it is the first to read."""
    waiting = {name: place for place, name in enumerate(sources)}
    for statement in part:
        for name in sorted(collect_refs(statement) & waiting.keys(), key=waiting.__getitem__):
            del waiting[name]
            source = sources[name]
            if isinstance(source, Load):
                printer.print_statement(source)
            else:
                printer.add(source)
        print_one(statement)


def is_kept(statement: Statement) -> bool:
    """Whether a statement fills a dense solve."""
    return isinstance(statement, Store) and statement.array == "kept"


def print_part(printer: BodyPrinter, function: Function, part: Sequence[Statement], name: str) -> list[str]:
    """A part of a function's straight code as a function of its own, from its first line to its last."""
    assert function.output is not None
    inner, output = printer.fork(), function.output.name
    inputs = [print_argument(argument.name, argument.size) for argument in list_arguments(function)]
    leaves = any(name in printer.kept for statement in part for name in list_bound(statement))
    leaves = leaves or (bool(printer.blocks) and any(isinstance(s, Solve) or is_kept(s) for s in part))
    stores = any(isinstance(statement, Store) and not is_kept(statement) for statement in part)
    arguments = ", ".join((*inputs, "double *kept", f"double *{output}"))
    head = wrap_code(f"{print_slow(printer, function)}static int {name}({arguments})", "")
    inner.lines += [] if stores else [f"    (void){output};"]
    sources = find_sources(inner, function, part)
    print_unread(inner, function, sources, ("kept",) if leaves else ())
    print_in_turn(inner, part, sources, inner.print_statement)
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
