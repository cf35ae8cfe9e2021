"""``rhs`` over many states at once: as many states in one pass as the machine's vectors have lanes."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.emit.c.body import BodyPrinter
from nhc.emit.c.finish import choose_finish
from nhc.emit.c.lanes import Each, LanesPrinter
from nhc.emit.c.lines import ANY, wrap_code
from nhc.emit.c.names import make_scope
from nhc.emit.c.parts import cut, find_carried, list_fetched, list_names, print_in_turn
from nhc.emit.c.rolled.lines import KEPT, Body, Leave, Line, Loop, Put, may_roll
from nhc.emit.c.rolled.printing import TURN
from nhc.emit.statements import collect_refs, drop_unused, fill_stores, split_hoisted
from nhc.program.ir import Function, Guard, Let, Load, Program, Solve, Statement, Store
from nhc.records import record

OWN = (
    "count", "i", "bad", "far", "sum", "stride", "fixed", "carried", "check", "status", "left", "one", "time", "state",
    "slope", TURN,
)  # fmt: skip
LONGEST, USUAL = 600, 400  # statements of one function, and of a part where there are more
SHORT = 250  # statements that are compiled for vectors of two doubles too, where little is won


@record
class Batch:
    """The body of ``rhs_batch``, the functions before it, and the functions of C that these call lane by lane.

    ``least``: the lanes that a vector must have for them.
    """

    body: tuple[str, ...] = ()
    parts: tuple[str, ...] = ()
    each: tuple[Each, ...] = ()
    least: int = 2


def print_batch(program: Program, function: Function, helpers: set[str], *, inline: bool) -> Batch:
    """``rhs_batch`` for the function ``rhs``; ``inline``: with this file's own sine and cosine."""
    helpers.add("one_by_one")
    if any(isinstance(statement, Solve) for statement in function.body):
        return Batch(print_one_by_one(program))  # elimination with pivots takes another way for each state
    helpers |= {"lanes", "batch"} | ({"near"} if inline else set())
    return BatchPrinter(program, function, helpers, ANY if inline else "").print()


def print_one_by_one(program: Program) -> tuple[str, ...]:
    """All states through ``rhs``."""
    return (f"    return {program.system}_one_by_one(count, 0, count, t, y, p, dydt);",)


def mark_unused(function: Function, body: tuple[Statement, ...]) -> list[str]:
    """``(void)p;`` for each argument that the body does not read."""
    read = {statement.array for statement in body if isinstance(statement, Load)}
    return [f"    (void){argument.name};" for argument in function.inputs if argument.name not in read]


class _OncePrinter(BodyPrinter):
    """Prints what is done once for all states: where a block of parameters alone seems singular, rhs is asked for each of them."""

    def print_refusal(self, guard: Guard) -> str:
        return f"{self.prefix}_one_by_one(count, 0, count, t, y, p, dydt)"


class BatchPrinter:
    """Prints the states' work, in several functions where it is long, and the loop that calls them."""

    def __init__(self, program: Program, function: Function, helpers: set[str], trig: str) -> None:
        self.program, self.prefix, self.helpers, self.trig = program, program.system, helpers, trig
        self.capitals = self.prefix.upper()
        self.width = f"{self.capitals}_LANES"
        body = drop_unused(function.body)
        output = () if function.output is None else (function.output,)
        self.scope = make_scope(program, (*function.inputs, *output), body, OWN)
        finish = choose_finish(body)
        self.summed = None if finish is None else frozenset(finish.entries)
        tested = body if finish is None else finish.guards
        lasting = tuple(s for s in body if not isinstance(s, Store | Guard) or any(s is guard for guard in tested))
        straight = tuple(s for s in lasting if not isinstance(s, Store)) + fill_stores(function)
        self.outside, inside = split_hoisted(straight)
        self.loads = {s.name: s for s in inside if isinstance(s, Load)}
        used = {name for statement in inside for name in collect_refs(statement)}
        bound = [s.name for s in self.outside if isinstance(s, Let | Load)]
        self.fixed = [name for name in bound if name in used]
        straight = tuple(s for s in inside if not isinstance(s, Load))
        numbers = {name: Load(name, "fixed", k) for k, name in enumerate(self.fixed)}
        self.rolled: Body | None = None
        if may_roll(straight, LONGEST):
            from nhc.emit.c.rolled.whole import roll_body

            self.rolled = roll_body(self.loads | numbers, straight, LONGEST)
        lines: Sequence[Line] = self.rolled.lines if self.rolled else straight
        self.scope.bind_all(self.rolled.bound if self.rolled else ())
        self.parts = cut(lines, LONGEST, USUAL)
        placed, first = (self.rolled.places, self.rolled.size) if self.rolled else ({}, 0)
        self.carried = find_carried(self.parts, placed, first)
        self.size = first + len(self.carried) - len(placed)
        self.each: dict[str, Each] = {}

    def print(self) -> Batch:
        """Everything, under the condition that the machine's vectors are worth it."""
        least = 2 if sum(map(len, self.parts)) <= SHORT else 4
        condition = f"#if {self.width} >= {least}"
        functions = [line for number, part in enumerate(self.parts) for line in ("", *self.print_part(number, part))]
        functions += ["", *self.print_tail()]
        body = (
            condition,
            *self.print_hoisted(),
            *self.print_loop(),
            "#else",
            *print_one_by_one(self.program),
            "#endif",
        )
        each = tuple(self.each[name] for name in sorted(self.each))
        return Batch(body, ("", condition, *functions[1:], "#endif"), each, least)

    def print_hoisted(self) -> list[str]:
        """The work on parameters, once for all states."""
        used = frozenset(self.fixed)
        for statement in reversed(self.outside):
            if isinstance(statement, Guard) or (isinstance(statement, Let) and statement.name in used):
                used |= collect_refs(statement)
        printer = _OncePrinter(
            self.prefix,
            self.scope,
            self.helpers,
            lambda array, index: f"{array}[{index}]",
            used,
            self.trig,
        )
        printer.print_all(tuple(s for s in self.outside if not isinstance(s, Load | Let) or s.name in used))
        if not self.fixed:
            return [*printer.lines, "    const double *fixed = p;"]
        names = ", ".join(self.scope[name] for name in self.fixed)
        return printer.lines + wrap_code(f"const double fixed[] = {{{names}}};", "    ")

    def print_part(self, number: int, part: tuple[Line, ...]) -> list[str]:
        """A function of the states' work; what one leaves for others stands in ``carried``."""
        printer = LanesPrinter(self.prefix, self.scope, self.helpers, self.each, frozenset(self.fixed), self.summed)
        used = list_names(part)
        sources: dict[str, Load | str] = {}
        for name, places in self.carried.items():
            if name in used and name not in self.loads and name not in self.fixed:
                self.helpers.add("get")
                value = f"{self.prefix}_get(carried + {places[0]} * {self.width})"
                sources[name] = f"const {self.prefix}_lanes {self.scope[name]} = {value};"
        sources |= {name: load for name, load in self.loads.items() if name in used}
        if self.rolled:  # what a loop leaves cannot be read before it
            print_in_turn(printer, part, sources, lambda line: self.print_line(printer, line))
        else:
            for source in sources.values():
                if isinstance(source, Load):
                    printer.print_statement(source)
                else:
                    printer.add(source)
            for line in part:
                self.print_line(printer, line)
        carried = "double *carried, " if self.carried else ""
        head = (
            f"static __attribute__((noinline)) void {self.name_part(number)}(const double *fixed, size_t stride, const double *t, "
            f"const double *y, {carried}double *restrict dydt, double *check)"
        )
        unread = [f"    (void){name};" for name in self.list_unread(part, used)]
        return [*wrap_code(head, ""), "{", *unread, *self.print_notes(used), *printer.lines, *self.print_end(), "}"]

    def print_line(self, printer: LanesPrinter, line: Line) -> None:
        """A statement, and what of it is left for others; or a loop."""
        printer.print_statement(line)
        if isinstance(line, Let):
            for place in self.carried.get(line.name, ()):
                printer.add(f"{self.prefix}_put(carried + {place} * {self.width}, {self.scope[line.name]});")

    def list_unread(self, part: tuple[Line, ...], used: set[str]) -> list[str]:
        """Arguments that a part does not use."""
        fetched = list_fetched(part)
        inside = [line for outer in part for line in (outer.body if isinstance(outer, Loop) else (outer,))]
        read = {self.loads[name].array for name in used if name in self.loads} | set(fetched)
        stores = [line.store if isinstance(line, Put) else line for line in inside if isinstance(line, Store | Put)]
        unread = [name for name in ("t", "y") if name not in read] + ([] if stores else ["dydt"])
        unread += [] if used & set(self.fixed) or "fixed" in fetched else ["fixed"]
        spaced = "y" in fetched or any(self.loads[name].index > 0 for name in used if name in self.loads)
        spaced = spaced or any(isinstance(line, Put) for line in inside)
        unread += [] if spaced or any(store.index > 0 for store in stores) else ["stride"]
        passed = any(isinstance(s, Let) and s.name in self.carried for s in part) or bool(used & set(self.carried))
        passed = passed or KEPT in fetched or any(isinstance(line, Leave) for line in inside)
        return unread + (["carried"] if self.carried and not passed else [])

    def print_notes(self, used: set[str]) -> list[str]:
        """What is noted on the way, and the numbers that all states share."""
        return [
            f"    {self.prefix}_lanes far = {{0}}; /* the squares of the angles */",
            f"    {self.prefix}_lanes sum = {{0}}; /* an infinity or a NaN among the results stays in it */",
            f"    {self.prefix}_bits bad = {{0}}; /* singular blocks */",
            *(f"    const double {self.scope[n]} = fixed[{k}];" for k, n in enumerate(self.fixed) if n in used),
        ]

    def print_end(self) -> list[str]:
        """One number for each state tells whether it must be asked again."""
        return [f"    {self.prefix}_put(check, {self.prefix}_mark(far + (sum - sum), bad));"]

    def name_part(self, number: int) -> str:
        """The function of one part."""
        return f"{self.prefix}_rhs_lanes" + (f"_part{number + 1}" if len(self.parts) > 1 else "")

    def print_tail(self) -> list[str]:
        """The last states, fewer than there are lanes, filled up to a whole vector."""
        prefix, width, size = self.prefix, self.width, len(self.program.state)
        carried = "double *carried, " if self.carried else ""
        head = (
            f"static __attribute__((noinline)) void {prefix}_rhs_tail(const double *fixed, size_t left, size_t count, "
            f"const double *t, const double *y, {carried}double *restrict dydt, double *check)"
        )
        return [
            *wrap_code(head, ""),
            "{",
            f"    double time[{width}];",
            f"    double state[{size} * {width}];",
            f"    double slope[{size} * {width}];",
            f"    {prefix}_fill(left, count, t, y, time, state);",
            *self.print_calls(width, "time", "state", "slope", "    "),
            f"    {prefix}_pour(left, count, slope, dydt);",
            "}",
        ]

    def print_loop(self) -> list[str]:
        """The loop over the states."""
        prefix, width, parts = self.prefix, self.width, len(self.parts)
        good = f"{self.capitals}_OK"
        carried = "carried, " if self.carried else ""
        lines = [
            f"    double check[{parts} * {width}];",
            *([f"    double carried[{self.size} * {width}];"] if self.carried else []),
            f"    int status = {good};",
            f"    for (size_t i = 0; i < count; i += {width}) {{",
            f"        const size_t left = count - i < {width} ? count - i : {width};",
            f"        if (left == {width}) {{",
            *self.print_calls("count", "t + i", "y + i", "dydt + i", " " * 12),
            "        } else {",
            f"            {prefix}_rhs_tail(fixed, left, count, t + i, y + i, {carried}dydt + i, check);",
            "        }",
            f"        if (!{prefix}_is_good({parts} * {width}, check)) {{",
            f"            const int one = {prefix}_one_by_one(count, i, left, t, y, p, dydt);",
            f"            status = status == {good} ? one : status;",
            "        }",
            "    }",
            "    return status;",
        ]
        return lines

    def print_calls(self, stride: str, time: str, state: str, slope: str, indent: str) -> list[str]:
        """The calls of all parts."""
        lines = []
        for number in range(len(self.parts)):
            check = f"check + {number} * {self.width}" if number else "check"
            arguments = ["fixed", stride, time, state, *(["carried"] if self.carried else []), slope, check]
            lines += wrap_code(f"{self.name_part(number)}({', '.join(arguments)});", indent)
        return lines
