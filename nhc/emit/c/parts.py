"""A long body in several functions: compilers take more than twice as long over one that is twice as long.

A part finds what others have computed in an array, ``kept`` (doubles) or, inside a sweep, ``carried`` (vectors), and reads it
just before it is first needed: what compilers take longest over is finding places for values that live at once.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace

from nhc.emit.c.body import BodyPrinter
from nhc.emit.c.dense import list_entries
from nhc.emit.c.either import EXCHANGED
from nhc.emit.c.lanes import LanesPrinter
from nhc.emit.c.lines import Block, Blocks, wrap_code
from nhc.emit.c.rolled.lines import Body, Fetch, Leave, Line, Loop, Put, count_lines, list_needs, may_roll
from nhc.emit.c.rolled.printing import TURN
from nhc.emit.statements import ZERO
from nhc.program.ir import Argument, Evaluate, Function, Let, Load, Section, Solve, Statement, Store, Sweep
from nhc.records import record

OWN = ("kept", "carried", "first", "seed", "slope", "offset", "entry", "status", TURN)
_SLOW = ("velocities", "accelerations", "state", "residuals", "positions", "reactions", "energy", "jacobian", "outputs")
SLOW = frozenset((*_SLOW, *(f"{name}_{EXCHANGED}" for name in ("rhs", *_SLOW))))
"""Functions that no integrator calls at each stage: where they are long, they shall be compiled soon above all."""
LONG = 40  # statements from which on this holds
LENGTHS = (250, 200)  # statements that one function may have, those of a part where there are more
RHS_LENGTHS = (1200, 750)  # it must be fast above all: what parts leave for others costs stores and loads


@record
class Layout:
    """The parts of a body, and the names that one of them leaves for others, each with its places in ``kept``.

    ``divided``: there are several parts, sweeps or loops.  ``sweeps``: their lines where they have loops; ``bound``: their names.
    ``blocks``: the dense solves that parts fill, in the first ``size`` places.
    """

    parts: tuple[tuple[Line, ...], ...]
    kept: dict[str, tuple[int, ...]]
    divided: bool
    blocks: Blocks
    size: int
    sweeps: tuple[Body | None, ...] = ()
    bound: tuple[str, ...] = ()


def list_bound(statement: Line) -> tuple[str, ...]:
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


def cut(body: Sequence[Line], longest: int, usual: int) -> tuple[tuple[Line, ...], ...]:
    """The body in parts of about the usual length, or in one if that is not too long."""
    length = sum(map(count_lines, body))
    count = 1 if length <= longest else -(-length // usual)
    size = -(-length // count) if body else 1
    parts: list[tuple[Line, ...]] = []
    begin = filled = 0
    for place, line in enumerate(body):
        if filled and filled + count_lines(line) > size:
            parts.append(tuple(body[begin:place]))
            begin, filled = place, 0
        filled += count_lines(line)
    return (*parts, tuple(body[begin:])) if body else ()


def find_crossing(parts: Iterable[Iterable[Line]], placed: Collection[str] = ()) -> dict[str, int]:
    """The names that one part of a function computes and another uses, each with its place in the array that is handed on.

    Those that are ``placed`` already are left out.
    """
    home: dict[str, int] = {}
    crossing: set[str] = set()
    for number, part in enumerate(parts):
        for statement in part:
            if number:  # the first part has nothing from others
                crossing.update([name for name in list_needs(statement) if home.get(name, number) != number])
            for name in list_bound(statement):
                home[name] = number
    return {
        name: place for place, name in enumerate([name for name in home if name in crossing and name not in placed])
    }


def find_carried(
    parts: Iterable[Iterable[Line]], places: Mapping[str, tuple[int, ...]], size: int
) -> dict[str, tuple[int, ...]]:
    """The places in the array that parts hand on: those given, which end at ``size``, and behind them those of what crosses."""
    crossing = find_crossing(parts, places)
    return dict(places) | {name: (size + place,) for name, place in crossing.items()}


def find_tail(straight: Sequence[Statement]) -> int:
    """Where a dense solve begins after which only stores come: they take its unknowns from where it leaves them."""
    solves = [place for place, statement in enumerate(straight) if isinstance(statement, Solve)]
    if solves and all(isinstance(s, Section | Store) for s in straight[solves[-1] + 1 :]):
        return solves[-1]
    return len(straight)


def lay_out(function: Function, body: tuple[Statement, ...]) -> Layout:
    """The parts of a body without its loads, calls and sweeps; a sweep counts as a part that uses what it uses."""
    sweeps = [statement for statement in body if isinstance(statement, Sweep)]
    straight, blocks, places, size = spread(function, [s for s in body if not isinstance(s, Evaluate | Load | Sweep)])
    longest = choose_lengths(function)[0]
    bodies = (straight, *(sweep.body for sweep in sweeps))
    if function.output is not None and not size and any(may_roll(part, longest) for part in bodies):
        from nhc.emit.c.rolled.whole import roll_function

        loads = {s.name: s for s in body if isinstance(s, Load)}
        rolled = roll_function(loads, straight, sweeps, longest)
        if rolled is not None:
            return lay_out_rolled(function, *rolled, sweeps)
    end = find_tail(straight)
    parts = cut(straight[:end], *choose_lengths(function)) if function.output is not None else (tuple(straight[:end]),)
    if end < len(straight):
        parts = (*parts[:-1], (*(parts[-1] if parts else ()), *straight[end:]))
    swept = [(sweep,) for sweep in sweeps]
    crossing = {name: (size + place,) for name, place in find_crossing((*parts, *swept)).items()}
    return Layout(parts, crossing | places, bool(sweeps) or len(parts) > 1, blocks, size)


def lay_out_rolled(function: Function, main: Body, turned: Sequence[Body | None], sweeps: Sequence[Sweep]) -> Layout:
    """The same where there are loops: what these need has its places already."""
    parts = cut(main.lines, *choose_lengths(function))
    others = [body.lines if body else (sweep,) for body, sweep in zip(turned, sweeps, strict=True)]
    kept = find_carried((*parts, *others), main.places, main.size)
    bound = (*main.bound, *(name for body in turned if body for name in body.bound))
    return Layout(parts, kept, True, {}, 0, tuple(turned), bound)


def spread(
    function: Function, straight: Sequence[Statement]
) -> tuple[list[Statement], Blocks, dict[str, tuple[int, ...]], int]:
    """Long dense solves as stores of their entries, which parts may share, and solves of what is then in ``kept``.

    These bind no names: the unknowns have their places in ``kept``.
    """
    made: list[Statement] = []
    blocks, places, size = Blocks(), dict[str, tuple[int, ...]](), 0
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
            places |= {name: (size + i * width + len(rows) + c,) for i, name in enumerate(names)}
        size += len(entries)
    return made, blocks, places, size


def list_names(part: Iterable[Line]) -> set[str]:
    """The names that the statements use and do not compute."""
    own = {name for statement in part for name in list_bound(statement)}
    return {name for statement in part for name in list_needs(statement)} - own


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


def find_sources(printer: BodyPrinter, function: Function, part: Sequence[Line]) -> dict[str, Load | str]:
    """Where a part has the names from that it uses and does not compute: loads of its own, lines that read ``kept``."""
    used = list_names(part)
    found: dict[str, Load | str] = {s.name: s for s in function.body if isinstance(s, Load) and s.name in used}
    taken = {name: places for name, places in printer.kept.items() if name in used and name not in found}
    return found | {name: f"const double {printer.scope[name]} = kept[{places[0]}];" for name, places in taken.items()}


def print_unread(
    printer: BodyPrinter, function: Function, sources: Mapping[str, Load | str], own: Sequence[str]
) -> None:
    """The first lines of a part: the arguments that it does not read; ``own`` are those that it writes."""
    read = {source.array for source in sources.values() if isinstance(source, Load)} | set(own)
    read |= {"kept"} if any(isinstance(source, str) for source in sources.values()) else set()
    given = [*(argument.name for argument in list_arguments(function)), "kept"]
    printer.lines += [f"    (void){name};" for name in given if name not in read]


def print_in_turn(
    printer: BodyPrinter | LanesPrinter,
    part: Sequence[Line],
    sources: Mapping[str, Load | str],
    print_one: Callable[[Line], None],
) -> None:
    """The statements of a part, before each what it is the first to read."""
    waiting = {name: place for place, name in enumerate(sources)}
    for statement in part:
        for name in sorted(list_needs(statement) & waiting.keys(), key=waiting.__getitem__):
            del waiting[name]
            source = sources[name]
            if isinstance(source, Load):
                printer.print_statement(source)
            else:
                printer.add(source)
        print_one(statement)


def list_fetched(part: Iterable[Line]) -> list[str]:
    """The arrays that loops read."""
    fetched = (line.array for loop in part if isinstance(loop, Loop) for line in loop.body if isinstance(line, Fetch))
    return list(dict.fromkeys(fetched))


def is_kept(statement: Line) -> bool:
    """Whether a statement fills a dense solve."""
    return isinstance(statement, Store) and statement.array == "kept"


def print_part(printer: BodyPrinter, function: Function, part: Sequence[Line], name: str) -> list[str]:
    """A part of a function's straight code as a function of its own, from its first line to its last."""
    assert function.output is not None
    inner, output = printer.fork(), function.output.name
    inputs = [print_argument(argument.name, argument.size) for argument in list_arguments(function)]
    leaves = any(name in printer.kept for statement in part for name in list_bound(statement))
    leaves = leaves or (bool(printer.blocks) and any(isinstance(s, Solve) or is_kept(s) for s in part))
    inside = [line for statement in part for line in (statement.body if isinstance(statement, Loop) else (statement,))]
    leaves = leaves or any(isinstance(line, Leave) for line in inside)
    stores = any(isinstance(line, Put) or (isinstance(line, Store) and not is_kept(line)) for line in inside)
    arguments = ", ".join((*inputs, "double *kept", f"double *{output}"))
    head = wrap_code(f"{print_slow(printer, function)}static int {name}({arguments})", "")
    inner.lines += [] if stores else [f"    (void){output};"]
    sources = find_sources(inner, function, part)
    print_unread(inner, function, sources, (*(["kept"] if leaves else []), *list_fetched(part)))
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
