"""Dense solves in C: written out without exchanges where that is short and safe, else by the file's own elimination."""

from __future__ import annotations

from fractions import Fraction

from nhc.emit.c.lines import CodePrinter
from nhc.emit.c.literals import NAN, print_comment, print_double
from nhc.emit.c.names import print_singular
from nhc.emit.statements import ZERO
from nhc.program.ir import Expr, Solve
from nhc.program.lowering.written_out import WrittenOut, write_out

FEW = 8  # entries of zero that are stored one by one


def list_entries(solve: Solve) -> list[Expr]:
    """The matrix beside its right sides, row by row."""
    return [e for i, row in enumerate(solve.matrix) for e in (*row, *(column[i] for column in solve.columns))]


def print_solve(printer: CodePrinter, solve: Solve) -> None:
    """Fill the matrix with its right sides, eliminate, name the solutions."""
    printer.helpers.add("solve")
    size, sides = len(solve.matrix), len(solve.columns)
    width, block = size + sides, printer.blocks.get(solve.names)
    written = write_out(solve, printer.used) if printer.quick and block is None else None
    if written is not None:
        print_quickly(printer, written)
        return
    if block is not None:
        print_exchanges(printer, solve, f"kept + {block.place}" if block.place else "kept", block.masses)
        return  # the unknowns are read where they are needed
    array = printer.scope.fresh("block")
    print_block(printer, solve, array)
    print_exchanges(printer, solve, array, solve.masses)
    for c, names in enumerate(solve.names):
        for i, name in enumerate(names):
            place = f"{array}[{i * width + size + c}]"
            if sides > 1 and name not in printer.kept:
                printer.scope.alias(name, place)  # many names that are read once
            elif name in printer.used:
                printer.lines.append(f"{printer.indent}const double {printer.scope[name]} = {place};")
                printer.keep(name)


def print_exchanges(printer: CodePrinter, solve: Solve, where: str, masses: int) -> None:
    """The elimination by a function, of what stands in an array."""
    size, tolerance = len(solve.matrix), print_double(Fraction(solve.tolerance))
    width = size + len(solve.columns)
    status, singular = printer.scope.fresh("status"), print_singular(printer.prefix, solve.status)
    call = f"{printer.prefix}_solve({size}, {masses}, {width}, {where}, {tolerance}, {singular})"
    printer.add(f"const int {status} = {call};")
    left = NAN if printer.scalar else status
    printer.add(f"if ({status} != {printer.prefix.upper()}_OK) {{")
    printer.lines += [f"{printer.indent}    return {left};", f"{printer.indent}}}"]


def print_quickly(printer: CodePrinter, written: WrittenOut) -> None:
    """The elimination written out, and with exchanges where that is not good."""
    solve, size = written.solve, len(written.solve.matrix)
    unknowns = {name: i for i, name in enumerate(solve.names[0]) if name in printer.used}
    printer.add_comment("the masses, then the multipliers are eliminated, without exchanges while all pivots are good")
    for let in written.lets:
        if let.name not in unknowns:
            printer.scope.alias(let.name, printer.scope.fresh(let.name.partition(":")[0]))
        kind = "double" if let.name in unknowns else "const double"
        printer.add(f"{kind} {printer.scope[let.name]} = {printer.printer.print(let.value)};")
    texts = [f"{printer.printer.print(t.left)} {t.relation} {printer.printer.print(t.right)}" for t in written.tests]
    printer.open_unless(texts)
    array = printer.scope.fresh("block")
    print_block(printer, solve, array)
    print_exchanges(printer, solve, array, solve.masses)
    places = [(printer.scope[name], f"{array}[{i * (size + 1) + size}]") for name, i in unknowns.items()]
    printer.lines += [f"{printer.indent}{name} = {place};" for name, place in places]
    printer.close()
    for name in unknowns:
        printer.keep(name)


def print_block(printer: CodePrinter, solve: Solve, array: str) -> None:
    """The matrix of a dense solve beside its right sides."""
    what = f"the matrix beside its right sides, row by row; {solve.what} where it has no pivot"
    printer.add_comment(print_comment(what))
    entries = list_entries(solve)
    printer.lines.append(f"{printer.indent}double {array}[{len(entries)}];")
    skipped = print_zeros(printer, array, entries)
    for k, entry in enumerate(entries):
        if not (skipped and entry == ZERO):
            printer.add(f"{array}[{k}] = {printer.printer.print(entry)};")


def print_zeros(printer: CodePrinter, array: str, entries: list[Expr]) -> bool:
    """All entries zero at once, where many are; whether it was done."""
    if entries.count(ZERO) <= FEW:
        return False
    printer.clear(array, len(entries))
    return True
