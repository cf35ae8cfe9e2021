"""A sweep in C: its statements in functions of their own over vectors of passes, and the loop that calls them.

The vectors are GCC's, as wide as the machine that is compiled for; for another compiler a vector is one double.
"""

from __future__ import annotations

from nhc.emit.c.body import BodyPrinter
from nhc.emit.c.lines import wrap_code
from nhc.emit.c.literals import print_comment
from nhc.emit.c.parts import (
    choose_lengths,
    cut,
    find_crossing,
    find_sources,
    list_names,
    print_argument,
    print_in_turn,
    print_slow,
    print_unread,
)
from nhc.program.ir import Function, Let, Statement, Store, Sweep


class SweepPrinter:
    """Prints one sweep of a function; ``number`` counts the function's sweeps from 1."""

    def __init__(self, printer: BodyPrinter, function: Function, sweep: Sweep, number: int) -> None:
        assert function.output is not None
        self.printer, self.function, self.sweep = printer, function, sweep
        self.output = function.output.name
        self.name = f"{printer.prefix}_{function.name}_sweep{number}"
        self.width = f"{printer.prefix.upper()}_LANES"
        self.parts = cut(sweep.body, *choose_lengths(function))
        self.carried = find_crossing(self.parts)
        self.places = {s.index: k for k, s in enumerate(s for s in sweep.body if isinstance(s, Store))}

    def print_loop(self) -> list[str]:
        """The passes, several at once."""
        prefix, width, sweep = self.printer.prefix, self.width, self.sweep
        passes, entries = len(sweep.offsets), len(self.places)
        own = ("kept", "seed", "carried", "slope") if self.carried else ("kept", "seed", "slope")
        arguments = ", ".join((*self.printer.arguments, *own))
        lines = [
            "",
            f"    /* {print_comment(sweep.about)} */",
            f"    for (int first = 0; first < {passes}; first += {width}) {{",
            *wrap_code(f"static const int offset[] = {{{', '.join(map(str, sweep.offsets))}}};", " " * 8),
            *wrap_code(f"static const int entry[] = {{{', '.join(map(str, self.places))}}};", " " * 8),
            f"        double seed[{passes} * {width}];",
        ]
        lines += [f"        double carried[{len(self.carried)} * {width}];"] if self.carried else []
        lines += [
            f"        double slope[{entries} * {width}];",
            f"        {prefix}_unit({passes}, first, seed);",
        ]
        for number in range(len(self.parts)):
            lines += wrap_code(f"{self.name_part(number)}({arguments});", " " * 8)
        call = f"{prefix}_place({passes} - first, offset + first, {entries}, entry, slope, {self.output});"
        return [*lines, *wrap_code(call, " " * 8), "    }"]

    def name_part(self, number: int) -> str:
        """The function of one part of the sweep."""
        return self.name if len(self.parts) == 1 else f"{self.name}_part{number + 1}"

    def print_functions(self) -> list[str]:
        """The functions of the sweep's parts."""
        lines: list[str] = []
        for number, part in enumerate(self.parts):
            inputs = [print_argument(argument.name, argument.size) for argument in self.function.inputs]
            own = ["const double *kept", "const double *seed", "double *slope"]
            if self.carried:
                own.insert(2, "double *carried")
            slow = print_slow(self.printer, self.function)
            head = f"{slow}static void {self.name_part(number)}({', '.join((*inputs, *own))})"
            lines += ["", *wrap_code(head, ""), "{", *self.print_part(part), "}"]
        return lines

    def print_part(self, part: tuple[Statement, ...]) -> list[str]:
        """The statements of one part over vectors of passes."""
        inner, scope, prefix = self.printer.fork(), self.printer.scope, self.printer.prefix
        used = list_names(part)
        seeds = [(k, seed) for k, seed in enumerate(self.sweep.seeds) if seed in used]
        if not seeds:
            inner.lines.append("    (void)seed;")
        if (
            self.carried
            and not any(s.name in self.carried for s in part if isinstance(s, Let))
            and not used & set(self.carried)
        ):
            inner.lines.append("    (void)carried;")
        if not any(isinstance(statement, Store) for statement in part):
            inner.lines.append("    (void)slope;")
        sources = find_sources(inner, self.function, part)
        print_unread(inner, self.function, sources, ())
        vectors = [("seed", k, seed) for k, seed in seeds]
        vectors += [("carried", k, name) for name, k in self.carried.items() if name in used]
        for array, k, name in vectors:
            sources[name] = f"const {prefix}_lanes {scope[name]} = {prefix}_get({array} + {k} * {self.width});"
        print_in_turn(inner, part, sources, lambda statement: self.print_statement(inner, statement))
        return inner.lines

    def print_statement(self, inner: BodyPrinter, statement: Statement) -> None:
        """A let or a store."""
        prefix, width = inner.prefix, self.width
        if isinstance(statement, Let):
            name = inner.scope[statement.name]
            inner.add(f"const {prefix}_lanes {name} = {inner.printer.print(statement.value)};")
            if statement.name in self.carried:
                inner.add(f"{prefix}_put(carried + {self.carried[statement.name]} * {width}, {name});")
        elif isinstance(statement, Store):
            place = self.places[statement.index]
            inner.add(f"{prefix}_put(slope + {place} * {width}, {inner.printer.print(statement.value)});")
