"""The statements of one C function."""

from __future__ import annotations

from nhc.emit.c.dense import print_solve
from nhc.emit.c.lines import CodePrinter, bound_test, wrap_code
from nhc.emit.c.literals import NAN, print_comment
from nhc.emit.c.names import print_singular
from nhc.emit.c.pairs import Pair, pair_angles
from nhc.emit.c.rolled.lines import Fetch, Leave, Line, Loop, Put
from nhc.emit.c.rolled.printing import print_index, print_loop
from nhc.emit.prose import describe_guard, describe_load, show_origin
from nhc.program.ir import (
    Call,
    Evaluate,
    Guard,
    Let,
    Load,
    Origin,
    Result,
    Section,
    Solve,
    Statement,
    Store,
)


class BodyPrinter(CodePrinter):
    """Prints statements one after the other into ``lines``."""

    def fork(self) -> BodyPrinter:
        """A printer for another part of the same function."""
        made = BodyPrinter(
            self.prefix, self.scope, self.helpers, self.element, self.used, self.trig, self.scalar, self.quick
        )
        made.kept, made.blocks, made.arguments = self.kept, self.blocks, self.arguments
        return made

    def mark_origin(self, origin: Origin) -> None:
        """Say where the next statements come from, when that changes."""
        if origin is self._last_origin:
            return
        self._last_origin = origin
        text = print_comment(show_origin(origin))
        if text and text != self._origin:
            self._origin = text
            self.add_comment(text)

    def print_all(self, body: tuple[Statement, ...]) -> None:
        """All statements of a body, in order."""
        pairs = pair_angles(body) if self.paired else []
        for place, statement in enumerate(body):
            while pairs and pairs[0].place == place:
                self.print_pair(pairs.pop(0))
            self.print_statement(statement)

    def print_pair(self, pair: Pair) -> None:
        """The sines and cosines of two angles, for the statements that follow."""
        name, angles = self.scope.fresh("turned"), [self.printer.print(angle) for angle in pair.angles]
        self.helpers.update(("trig", "two", "two" + self.trig.partition("(")[0]))
        self.add(f"const {self.prefix}_turned {name} = {self.prefix}_two{self.trig.format(', '.join(angles))};")
        for k, angle in enumerate(angles):
            self.turned |= {("sin", angle): f"{name}.sine[{k}]", ("cos", angle): f"{name}.cosine[{k}]"}

    def print_statement(self, statement: Line) -> None:
        """One statement, or a loop."""
        if isinstance(statement, Loop):
            print_loop(self.lines, statement, self.add, self.print_in_loop)
        elif isinstance(statement, Leave):
            self.print_in_loop(statement)
        elif isinstance(statement, Section):
            if self.lines:
                self.lines.append("")
            self.add_comment(print_comment(statement.title))
            self.mark_origin(statement.origin)
        elif isinstance(statement, Load):
            source = self.element(statement.array, statement.index)
            if source != self.scope[statement.name]:
                spelling = self.scope[statement.name]
                self.add_noted(f"const double {spelling} = {source};", describe_load(statement, spelling))
        elif isinstance(statement, Let):
            self.mark_origin(statement.origin)
            self.add(f"const double {self.scope[statement.name]} = {self.printer.print(statement.value)};")
            self.keep(statement.name)
        elif isinstance(statement, Guard):
            self.print_guard(statement)
        elif isinstance(statement, Solve):
            print_solve(self, statement)
        elif isinstance(statement, Store):
            self.mark_origin(statement.origin)
            target = self.element(statement.array, statement.index)
            self.add_noted(f"{target} = {self.printer.print(statement.value)};", statement.about)
        elif isinstance(statement, Result):
            self.mark_origin(statement.origin)
            self.add(f"return {self.printer.print(statement.value)};")
        elif isinstance(statement, Evaluate):
            self.print_evaluate(statement)

    def print_in_loop(self, line: Fetch | Let | Leave | Put) -> None:
        """What stands in a loop."""
        if isinstance(line, Let):
            self.add(f"const double {self.scope[line.name]} = {self.printer.print(line.value)};")
        elif isinstance(line, Leave):
            self.add(f"kept[{print_index(line.first, line.step)}] = {self.scope[line.name]};")
        elif isinstance(line, Fetch):
            self.add(f"const double {self.scope[line.name]} = {line.array}[{print_index(line.first, line.step)}];")
        else:
            store = line.store
            self.add(f"{store.array}[{print_index(store.index, line.step)}] = {self.printer.print(store.value)};")

    def print_good(self, guard: Guard) -> str:
        """The condition under which the guard's block is regular; a NaN makes it false."""
        value, bound = self.print_sides(guard)
        return f"{value} > {bound}"

    def print_sides(self, guard: Guard) -> tuple[str, str]:
        """A magnitude, and what it must exceed."""
        return self.printer.print(Call("abs", (guard.value,))), self.printer.print(bound_test(guard))

    def print_guard(self, guard: Guard) -> None:
        """Leave where the block is singular."""
        self.add_comment(print_comment(describe_guard(guard, self.printer.print(guard.value))))
        self.print_exit(self.print_good(guard), NAN if self.scalar else self.print_refusal(guard))

    def print_refusal(self, guard: Guard) -> str:
        """The status to leave with."""
        self.helpers.add("refuse")
        value, bound = self.print_sides(guard)
        return f"{self.prefix}_refuse({value}, {bound}, {print_singular(self.prefix, guard.status)})"

    def print_exit(self, good: str, result: str) -> None:
        """Leave with the result where what should hold does not."""
        self.add(f"if (!({good})) {{")
        self.lines += [*wrap_code(f"return {result};", self.indent + "    "), f"{self.indent}}}"]

    def print_evaluate(self, evaluate: Evaluate) -> None:
        """Another function's output; leave where that is singular."""
        status = self.scope.fresh("status")
        call = f"{self.prefix}_{evaluate.function}({', '.join(self.arguments)}, {evaluate.array})"
        self.lines += [f"{self.indent}double {evaluate.array}[{evaluate.size}];"]
        self.add(f"const int {status} = {call};")
        self.lines += [
            f"{self.indent}if ({status} != {self.prefix.upper()}_OK) {{",
            f"{self.indent}    return {status};",
            f"{self.indent}}}",
        ]
