"""The functions of a C file: comment, prototype, body, and the static ones that stand before."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from nhc.emit.c.arrange import arrange
from nhc.emit.c.batch import Batch, mark_unused
from nhc.emit.c.body import BodyPrinter
from nhc.emit.c.dense import FEW
from nhc.emit.c.either import Way, print_either, rename
from nhc.emit.c.finish import choose_finish, print_finish
from nhc.emit.c.header import frame, print_function_comment
from nhc.emit.c.large import AT, LARGE, TURNED, list_angles, print_near, print_twice
from nhc.emit.c.lines import ANY, wrap_code
from nhc.emit.c.names import make_scope
from nhc.emit.c.parts import OWN, Layout, is_long, lay_out, print_calls, print_part, print_slow
from nhc.emit.c.sweep import SweepPrinter
from nhc.emit.options import BATCH
from nhc.emit.statements import (
    drop_unread,
    drop_unused,
    list_missing,
    list_used_names,
    place_guards,
)
from nhc.program.ir import Argument, Evaluate, Function, Guard, Load, Program, Statement, Sweep
from nhc.records import record


@record
class PrintedFunction:
    """What a template places: the comment above the prototype, the prototype, the body."""

    comment: tuple[str, ...]
    prototype: str
    definition: str
    body: tuple[str, ...]
    parts: tuple[str, ...] = ()  # what stands before the function: its own static ones


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
