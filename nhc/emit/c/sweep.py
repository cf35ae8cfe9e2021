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
    find_carried,
    find_sources,
    list_fetched,
    list_names,
    print_argument,
    print_in_turn,
    print_slow,
    print_unread,
)
from nhc.emit.c.rolled.lines import Body, Fetch, Leave, Line, Loop, Put
from nhc.emit.c.rolled.printing import print_factor, print_index, print_loop
from nhc.program.ir import Function, Let, Store, Sweep


class SweepPrinter:
    """Prints one sweep of a function; ``number`` counts the function's sweeps from 1."""

    def __init__(
        self, printer: BodyPrinter, function: Function, sweep: Sweep, number: int, rolled: Body | None
    ) -> None:
        assert function.output is not None
        self.printer, self.function, self.sweep = printer, function, sweep
        self.output = function.output.name
        self.name = f"{printer.prefix}_{function.name}_sweep{number}"
        self.width = f"{printer.prefix.upper()}_LANES"
        self.parts = cut(rolled.lines if rolled else sweep.body, *choose_lengths(function))
        placed, first = (rolled.places, rolled.size) if rolled else ({}, 0)
        self.carried = find_carried(self.parts, placed, first)
        self.size = first + len(self.carried) - len(placed)
        entries = [entry for part in self.parts for line in part for entry in list_entries(line)]
        self.places = {entry: k for k, entry in enumerate(entries)}

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
        lines += [f"        double carried[{self.size} * {width}];"] if self.carried else []
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

    def print_part(self, part: tuple[Line, ...]) -> list[str]:
        """The statements of one part over vectors of passes."""
        inner, scope, prefix = self.printer.fork(), self.printer.scope, self.printer.prefix
        used = list_names(part)
        seeds = [(k, seed) for k, seed in enumerate(self.sweep.seeds) if seed in used]
        fetched = list_fetched(part)
        inside = [line for outer in part for line in (outer.body if isinstance(outer, Loop) else (outer,))]
        if not seeds and "seed" not in fetched:
            inner.lines.append("    (void)seed;")
        if (
            self.carried
            and "carried" not in fetched
            and not any(isinstance(line, Leave) for line in inside)
            and not any(s.name in self.carried for s in part if isinstance(s, Let))
            and not used & set(self.carried)
        ):
            inner.lines.append("    (void)carried;")
        if not any(isinstance(line, Store | Put) for line in inside):
            inner.lines.append("    (void)slope;")
        sources = find_sources(inner, self.function, part)
        print_unread(inner, self.function, sources, fetched)
        vectors = [("seed", k, seed) for k, seed in seeds]
        vectors += [("carried", places[0], name) for name, places in self.carried.items() if name in used]
        for array, k, name in vectors:
            sources[name] = f"const {prefix}_lanes {scope[name]} = {prefix}_get({array} + {k} * {self.width});"
        print_in_turn(inner, part, sources, lambda statement: self.print_statement(inner, statement))
        return inner.lines

    def print_statement(self, inner: BodyPrinter, statement: Line) -> None:
        """A let, a store or a loop."""
        prefix, width = inner.prefix, self.width
        if isinstance(statement, Loop):
            print_loop(inner.lines, statement, inner.add, lambda line: self.print_in_loop(inner, line))
        elif isinstance(statement, Leave):
            self.print_in_loop(inner, statement)
        elif isinstance(statement, Let):
            name = inner.scope[statement.name]
            inner.add(f"const {prefix}_lanes {name} = {inner.printer.print(statement.value)};")
            for place in self.carried.get(statement.name, ()):
                inner.add(f"{prefix}_put(carried + {place} * {width}, {name});")
        elif isinstance(statement, Store):
            place = self.places[statement.index]
            inner.add(f"{prefix}_put(slope + {place} * {width}, {inner.printer.print(statement.value)});")

    def print_in_loop(self, inner: BodyPrinter, line: Fetch | Let | Leave | Put) -> None:
        """What stands in a loop: numbers come from ``kept`` and from inputs, vectors from the other arrays."""
        prefix, width, scope = inner.prefix, self.width, inner.scope
        if isinstance(line, Let):
            inner.add(f"const {prefix}_lanes {scope[line.name]} = {inner.printer.print(line.value)};")
        elif isinstance(line, Leave):
            inner.add(f"{prefix}_put(carried + {print_factor(line.first, line.step)} * {width}, {scope[line.name]});")
        elif isinstance(line, Put):
            place = self.places[line.store.index]
            index = print_factor(place, 1)
            inner.add(f"{prefix}_put(slope + {index} * {width}, {inner.printer.print(line.store.value)});")
        elif line.array in ("seed", "carried"):
            index = print_factor(line.first, line.step)
            inner.add(f"const {prefix}_lanes {scope[line.name]} = {prefix}_get({line.array} + {index} * {width});")
        else:
            inner.add(f"const double {scope[line.name]} = {line.array}[{print_index(line.first, line.step)}];")


def list_entries(line: Line) -> list[int]:
    """The entries of the output that a line stores, in their order."""
    if isinstance(line, Store):
        return [line.index]
    if isinstance(line, Loop):
        puts = [inner for inner in line.body if isinstance(inner, Put)]
        return [put.store.index + put.step * k for put in puts for k in range(line.count)]
    return []
