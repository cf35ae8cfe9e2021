"""A program as ``<s>.h``, ``<s>.c`` and, where a driver is asked for, ``<s>_main.c``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.emit.c.arrange import arrange
from nhc.emit.c.batch import Batch, mark_unused, print_batch
from nhc.emit.c.body import BodyPrinter
from nhc.emit.c.dense import FEW
from nhc.emit.c.either import Way, find_largest_block, print_either, rename
from nhc.emit.c.finish import choose_finish, print_finish
from nhc.emit.c.header import frame, print_file_comment, print_function_comment, print_source_comment
from nhc.emit.c.large import AT, LARGE, TURNED, list_angles, print_near, print_twice
from nhc.emit.c.lines import ANY, wrap_code
from nhc.emit.c.literals import NAN, print_comment, print_float, print_string
from nhc.emit.c.names import make_scope, print_singular
from nhc.emit.c.parts import OWN, Layout, is_long, lay_out, print_calls, print_part, print_slow
from nhc.emit.c.sweep import SweepPrinter
from nhc.emit.environment import File
from nhc.emit.options import BATCH, EmitError, EmitOptions, check_options, select_functions
from nhc.emit.statements import (
    Status,
    drop_unread,
    drop_unused,
    find_not_finite,
    list_missing,
    list_statuses,
    list_used_names,
    place_guards,
)
from nhc.program.ir import Argument, Evaluate, Function, Guard, Load, Program, Quantity, Solve, Statement, Sweep
from nhc.records import record


@record
class PrintedFunction:
    """What a template places: the comment above the prototype, the prototype, the body."""

    comment: tuple[str, ...]
    prototype: str
    definition: str
    body: tuple[str, ...]
    parts: tuple[str, ...] = ()  # what stands before the function: its own static ones


@record
class Constant:
    """An enumerator with its remark."""

    name: str
    value: int
    about: str


@record
class Table:
    """A constant array; ``remark`` says so where the array is there for C's sake only."""

    declaration: str
    entries: tuple[str, ...]
    remark: str


def list_files(program: Program, options: EmitOptions) -> tuple[File, ...]:
    """The files of the C back end.  Raises EmitError for an option that the program cannot meet."""
    has_rhs = any(function.name == "rhs" for function in program.functions)
    check_options(program, options, (BATCH,) if has_rhs else ())
    driver, wanted = None, options.only
    if options.driver:
        from nhc.emit.c.driver import list_driver_functions, make_driver

        driver = make_driver(program, options.scene)
        wanted += list_driver_functions(driver) if wanted else ()
    batch = has_rhs and (not wanted or BATCH in wanted)
    inline = options.trig == "inline"
    if batch and wanted:
        wanted += ("rhs",)  # the batch calls it for a state that is singular or near it
    functions = select_functions(program, wanted)
    helpers: set[str] = set()
    made = Batch()
    printed = [print_function(program, function, helpers, inline=inline) for function in functions]
    if batch:
        (rhs,) = (function for function in program.functions if function.name == "rhs")
        made = print_batch(program, rhs, helpers, inline=inline)
        printed.append(print_batch_function(program, made))
    name = program.system
    shared: dict[str, object] = {"capitals": name.upper(), "functions": tuple(printed)}
    header = File(f"{name}.h", "c/model.h.jinja", shared | make_header_context(program, functions, batch))
    source = File(f"{name}.c", "c/model.c.jinja", shared | make_source_context(program, helpers, functions, made))
    if driver is None:
        return header, source
    own: set[str] = set()
    held, hold_context = make_hold_context(program, own)
    context = driver | make_watch_context(program, own) | hold_context
    needed = program.needed.function if program.needed else None
    context["needed_size"] = needed.output.size if needed and needed.output else 0
    context["own"] = (
        *([context["watch"]] if program.lookout else []),
        *([print_function(program, program.leaps.function, own)] if program.leaps else []),
        *([print_function(program, program.beats.function, own)] if program.beats else []),
        *held,
        *([print_function(program, needed, own)] if needed else []),
    )
    context["parts"] = program.leaps.parts if program.leaps else ()
    context["beats"] = program.beats.function.output.size if program.beats and program.beats.function.output else 0
    context["steady"] = program.beats is not None and program.beats.steady
    context["helpers"] = tuple(sorted(own))
    return header, source, File(f"{name}_main.c", "c/model_main.c.jinja", context)


def make_header_context(program: Program, functions: tuple[Function, ...], batch: bool) -> dict[str, object]:
    """What ``model.h.jinja`` uses besides the functions."""
    return {
        "comment": print_file_comment(program, functions, f"{program.system}.h"),
        "sizes": list_sizes(program),
        "statuses": list_codes(program),
        "tables": tuple(table.declaration for table in list_tables(program)),
        "batch": batch,
    }


def make_source_context(
    program: Program, helpers: set[str], functions: tuple[Function, ...], batch: Batch
) -> dict[str, object]:
    """What ``model.c.jinja`` uses besides the functions."""
    return {
        "name": program.system,
        "comment": print_source_comment(program),
        "tables": list_tables(program),
        "helpers": tuple(sorted(helpers)),
        "each": batch.each,
        "least": batch.least,
        "largest_block": find_largest_block(functions),
    }


def make_watch_context(program: Program, helpers: set[str]) -> dict[str, object]:
    """What a driver's template uses of the values that it watches; their function is one of its own file."""
    from nhc.emit.c.driver import Method

    watch = program.lookout
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
    hold, code = program.hold, find_not_finite(program) + 1
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
        "largest_block": find_largest_block(functions + ([program.needed.function] if program.needed else [])),
    }


def list_sizes(program: Program) -> tuple[Constant, ...]:
    """The enumerators of the sizes."""
    capitals = program.system.upper()
    return (
        Constant(f"{capitals}_NQ", len(program.coordinates), "coordinates"),
        Constant(f"{capitals}_NY", len(program.state), "state: the coordinates and the velocities that are kept"),
        Constant(f"{capitals}_NP", len(program.parameters), "parameters"),
        Constant(f"{capitals}_NC", len(program.constraints), "constraints"),
        Constant(f"{capitals}_NOUT", len(program.outputs), "outputs"),
    )


def list_codes(program: Program) -> tuple[Constant, ...]:
    """The enumerators of the return codes."""
    capitals = program.system.upper()
    return (
        Constant(f"{capitals}_OK", 0, "the result is good"),
        *(
            Constant(print_singular(program.system, status.code), status.code, print_comment(status.what))
            for status in list_statuses(program)
        ),
        Constant(f"{capitals}_NOT_FINITE", find_not_finite(program), "a result is infinite or not a number"),
    )


def list_tables(program: Program) -> tuple[Table, ...]:
    """Names and defaults; C99 has no empty array, so an empty table gets one entry that nothing reads."""
    name = program.system
    defaults = tuple(print_default(quantity) for quantity in program.parameters)
    unused = "no entry counts: C99 has no empty array"
    return (
        *(
            Table(f"const char *const {name}_{kind}_names[]", entries or ('""',), "" if entries else unused)
            for kind, entries in (
                ("coordinate", tuple(print_string(q.name) for q in program.coordinates)),
                ("state", tuple(print_string(q.name) for q in program.state)),
                ("parameter", tuple(print_string(q.name) for q in program.parameters)),
            )
        ),
        Table(f"const double {name}_parameter_defaults[]", defaults or ("0.0",), "" if defaults else unused),
    )


def print_default(quantity: Quantity) -> str:
    """A default as a double; NaN where the spec gives none, so that a forgotten parameter cannot pass unseen."""
    if quantity.default is None:
        return NAN
    try:
        return print_float(float(quantity.default))
    except OverflowError:
        message = f"the default of `{quantity.name}` is too large for a double (1.8e308)"
        raise EmitError(message, "choose other units") from None


def print_arguments(arguments: Sequence[Argument], output: Argument | None, *, promised: bool = False) -> str:
    """Those of a prototype; ``promised``: the output overlaps no input, as the header asks of the caller."""
    texts = []
    for argument in arguments:
        kind = "double *restrict " if promised else "double *"
        kind = "double " if argument.size < 0 else kind if argument is output else "const double *"
        texts.append(kind + argument.name)
    return ", ".join(texts)


def print_function(program: Program, function: Function, helpers: set[str], *, inline: bool = False) -> PrintedFunction:
    """A function of the program; its ``int`` is 0 only if every entry of its output is finite."""
    made = print_one(program, function, helpers, inline=inline)
    if function.otherwise is None:
        return made
    other = print_one(program, rename(function.otherwise, function), helpers, inline=inline)
    parts, body = print_either(program.system, function, *(Way(x.definition, x.body, x.parts) for x in (made, other)))
    return replace(made, definition=made.prototype, body=body, parts=parts)


def print_one(program: Program, function: Function, helpers: set[str], *, inline: bool) -> PrintedFunction:
    """A function by itself, without what stands in for it."""
    prefix, capitals, output = program.system, program.system.upper(), function.output
    body = arrange(place_guards(drop_unused(function.body)))
    layout = lay_out(function, body)
    arguments = function.inputs if output is None else (*function.inputs, output)
    whole = output is not None and output.size and not layout.divided
    finish = choose_finish(body) if whole else None
    angles = list_angles(body) if inline and finish is not None and function.name == "rhs" else ()
    own = OWN if layout.divided else (LARGE, TURNED) if angles else ()
    scope = make_scope(program, arguments, body, own)
    scope.bind_all(layout.bound)
    for statement in body:
        if isinstance(statement, Load) and statement.index < 0:
            scope.alias(statement.name, statement.array)  # the argument itself: it needs no copy
    printer = BodyPrinter(
        prefix,
        scope,
        helpers,
        lambda array, index: array if index < 0 else f"{array}[{index}]",
        frozenset(list_used_names(body)),
        AT if angles else ANY if inline else "",
        scalar=output is None,
        quick=function.name == "rhs",
    )
    printer.arguments, printer.kept = tuple(argument.name for argument in function.inputs), layout.kept
    printer.blocks = layout.blocks
    printer.paired = inline and function.name == "rhs"
    parts = print_statements(printer, function, body, layout, guarded=finish is None)
    if finish is not None and output is not None:
        near = print_near(printer, function, angles) if angles else ("", "")
        print_finish(printer, finish, body, output.name, output.size, near)
    elif output is not None and output.size:
        helpers.add("finish")
        printer.lines.append(f"    return {prefix}_finish({output.size}, {output.name});")
    elif output is not None:
        printer.lines += [f"    (void){output.name};", f"    return {capitals}_OK;"]
    texts = print_arguments(arguments, output, promised=printer.quick)
    if angles:
        parts, printer.lines = print_twice(prefix, function, texts, printer.lines)
    head = f"{'double' if output is None else 'int'} {prefix}_{function.name}"
    prototype, definition = (wrap_prototype(f"{head}({text})") for text in (print_arguments(arguments, output), texts))
    slow = print_slow(printer, function).rstrip() if is_long(function, body) else ""
    definition = f"{slow}\n{definition}" if slow else definition
    comment = print_function_comment(program, function)
    return PrintedFunction(comment, prototype, definition, tuple(printer.lines), tuple(parts))


def print_statements(
    printer: BodyPrinter, function: Function, body: tuple[Statement, ...], layout: Layout, *, guarded: bool
) -> list[str]:
    """Print the body into the printer's lines, with its guards or without; the functions of its parts."""
    functions: list[str] = []
    if layout.divided:
        size = max((1, layout.size, *(place + 1 for places in layout.kept.values() for place in places)))
        printer.lines.append(f"    double kept[{size}]; /* what parts of this function leave for others */")
    if layout.size:
        printer.clear("kept", layout.size)
    print_zeros(printer, function)
    if len(layout.parts) > 1 or layout.bound:
        printer.print_all(tuple(statement for statement in body if isinstance(statement, Evaluate)))
        names = [f"{printer.prefix}_{function.name}_part{number + 1}" for number in range(len(layout.parts))]
        for name, part in zip(names, layout.parts, strict=True):
            functions += print_part(printer, function, part, name)
        printer.lines += print_calls(printer, function, names)
    else:
        printer.lines += mark_unused(function, body)
        later = Sweep if guarded else Sweep | Guard
        straight = tuple(statement for statement in body if not isinstance(statement, later))
        printer.print_all(drop_unread(straight) if len(straight) < len(body) and guarded else straight)
    for number, sweep in enumerate(s for s in body if isinstance(s, Sweep)):
        printer.helpers |= {"lanes", "get", "sweep"}
        inner = SweepPrinter(printer, function, sweep, number + 1, layout.sweeps[number] if layout.sweeps else None)
        functions += inner.print_functions()
        printer.lines += inner.print_loop()
    return functions


def print_zeros(printer: BodyPrinter, function: Function) -> None:
    """Zero for the entries of the output that the body leaves out, before all others; many of them at once."""
    missing, output = list_missing(function), function.output
    if output is None or len(missing) <= FEW:
        printer.lines += [f"    {store.array}[{store.index}] = 0.0;" for store in missing]
    else:
        printer.clear(output.name, output.size)


def print_batch_function(program: Program, batch: Batch) -> PrintedFunction:
    """``rhs_batch``; the definition promises the compiler what the header asks of the caller."""
    head = f"int {program.system}_{BATCH}(size_t count, const double *t, const double *y, const double *p, double *"
    comment = (
        "rhs for count states at once, a structure of arrays: entry k of state i is y[k*count + i], its time t[i];",
        "the parameters are shared. Nonzero when any of the states is singular. dydt must not overlap the inputs.",
    )
    prototype, definition = wrap_prototype(f"{head}dydt)"), wrap_prototype(f"{head}restrict dydt)")
    return PrintedFunction(frame(comment), prototype, definition, batch.body, batch.parts)


def wrap_prototype(text: str) -> str:
    """A prototype, on several lines where it is long."""
    return "\n".join(wrap_code(text, ""))
