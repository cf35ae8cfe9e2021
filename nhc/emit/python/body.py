"""The statements of one Python function, every one on a line of its own that a formatter has no reason to break.

Where an expression is too long for its line, its longest operand is stored under a name first; the operations and
their order stay the same, so the doubles do too.
"""

from __future__ import annotations

from fractions import Fraction

from nhc.emit.expressions import ATOM, POWER, ExpressionPrinter, Text, enclose
from nhc.emit.names import Scope
from nhc.emit.prose import describe_guard, describe_load, show_origin, wrap
from nhc.emit.python.literals import print_comment, print_float
from nhc.program.ir import (
    Binary,
    Call,
    Evaluate,
    Expr,
    Guard,
    Let,
    Load,
    Number,
    Origin,
    Result,
    Section,
    Solve,
    Statement,
    Store,
    Sweep,
)
from nhc.records import record

WIDTH = 88  # ruff's own default: what fits there is left alone at every wider setting too
LONGEST_VALUE = 68

# functions that the module brings: Python's own min and max lose a NaN, and its exp raises where IEEE's is infinite
OWN = {"sign": "sign", "min": "minimum", "max": "maximum", "exp": "exp", "sinh": "sinh", "cosh": "cosh"}
ARRAY = {
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "atan2": "arctan2",
    "min": "minimum",
    "max": "maximum",
    "pow": "power",
}
MODULES = {"": "math", "numpy": "np", "jax": "jnp"}


@record
class PythonDialect:
    """Python's leaves for one array library (empty: ``math``); ``helpers`` collects the module's own functions."""

    array: str
    helpers: set[str]

    def print_number(self, value: Fraction) -> str:
        return print_float(value)

    def print_pi(self) -> str:
        return f"{MODULES[self.array]}.pi"

    def print_power(self, base: Text, exponent: int) -> Text:
        hug = "" if is_simple(base) else " "
        return Text(f"{enclose(base, ATOM)}{hug}**{hug}{exponent}", POWER)

    def print_call(self, function: str, arguments: tuple[str, ...]) -> str:
        if self.array:
            name = f"{MODULES[self.array]}.{ARRAY.get(function, function)}"
        elif function in OWN:
            name = f"_{OWN[function]}"
            self.helpers.add(OWN[function])
        else:
            name = "abs" if function == "abs" else f"math.{function}"
        if function not in ("min", "max"):
            return f"{name}({', '.join(arguments)})"
        text = arguments[0]
        for argument in arguments[1:]:
            text = f"{name}({text}, {argument})"
        return text


def is_simple(base: Text) -> bool:
    """Whether ruff writes ``base**2`` without blanks: a name or a number."""
    return base.level == ATOM and not base.text.endswith(")")


def print_sequence(head: str, items: list[str], brackets: str, indent: str, tail: str = "") -> list[str]:
    """A list or tuple as ruff lays it out: on one line if it fits and holds no comment, else one item per line."""
    opening, closing = brackets[0], brackets[1]
    comma = "," if opening == "(" and len(items) == 1 else ""
    flat = f"{indent}{head}{opening}{', '.join(items)}{comma}{closing}{tail}"
    if not any("\n" in item or item.lstrip().startswith("#") for item in items) and len(flat) <= WIDTH:
        return [flat]
    lines = [f"{indent}{head}{opening}"]
    for item in items:
        commented = item.lstrip().startswith("#")
        lines += [f"{indent}    {line}" for line in (item if commented else f"{item},").split("\n")]
    return [*lines, f"{indent}{closing}{tail}"]


class BodyPrinter:
    """Prints statements one after the other into ``lines``; stores are kept back for the list that is returned."""

    def __init__(self, function: str, array: str, scope: Scope, helpers: set[str], used: frozenset[str]) -> None:
        self.function = function
        self.array = array
        self.scope = scope
        self.helpers = helpers
        self.used = used
        self.indent = " " * (4 if array == "jax" else 8)  # inside `try` or `with`; JAX needs neither
        self.lines: list[str] = []
        self.mask = ""  # JAX cannot raise: where this is false the result is NaN
        self.values: dict[int, str] = {}
        self.remarks: dict[int, list[str]] = {}
        self.result = ""
        self.dialect = PythonDialect(array, helpers)
        self._origin = ""

    def print_value(self, value: Expr, width: int) -> str:
        """An expression of at most ``width`` characters, after the lines that store its parts."""
        return ExpressionPrinter(self.dialect, self.scope.spellings, min(width, LONGEST_VALUE), self.spill).print(value)

    def spill(self, text: str) -> str:
        """Store a part of an expression under a name."""
        name = self.scope.fresh("s")
        self.lines.append(f"{self.indent}{name} = {text}")
        return name

    def assign(self, name: str, value: Expr) -> None:
        """``name = value``."""
        text = self.print_value(value, WIDTH - len(self.indent) - len(name) - 3)
        self.lines.append(f"{self.indent}{name} = {text}")

    def add_comment(self, text: str, indent: str) -> None:
        """A comment on its own lines."""
        self.lines += [f"{indent}# {line}" for line in wrap(print_comment(text), WIDTH - len(indent) - 2)]

    def mark_origin(self, origin: Origin) -> None:
        """Say where the next statements come from, when that changes."""
        text = print_comment(show_origin(origin))
        if text and text != self._origin:
            self._origin = text
            self.add_comment(text, self.indent)

    def print_load(self, load: Load) -> None:
        """A load, as a plain float or an array of doubles."""
        source = load.array if load.index < 0 else f"{load.array}[{load.index}]"
        if self.array:
            self.helpers.add("load")
        text = f"_load({source})" if self.array else f"float({source})"
        line = f"    {self.scope[load.name]} = {text}"
        note = print_comment(describe_load(load, self.scope[load.name]))
        if note and len(line) + len(note) + 4 <= WIDTH:
            self.lines.append(f"{line}  # {note}")
        else:
            self.add_comment(note, "    ")
            self.lines.append(line)

    def print_evaluate(self, evaluate: Evaluate, arguments: tuple[str, ...]) -> None:
        """Another function's output."""
        self.lines.append(f"    {evaluate.array} = {evaluate.function}({', '.join(arguments)})")

    def print_sweep(self, sweep: Sweep, output: str) -> None:
        """A loop over the passes, behind the list that it writes into."""
        k, offset, offsets = (self.scope.fresh(name) for name in ("k", "offset", "offsets"))
        self.add_comment(sweep.about, self.indent)
        self.lines += print_sequence(f"{offsets} = ", [str(number) for number in sweep.offsets], "()", self.indent)
        self.lines.append(f"{self.indent}for {k}, {offset} in enumerate({offsets}):")
        self.indent += "    "
        for number, seed in enumerate(sweep.seeds):
            self.lines.append(f"{self.indent}{self.scope[seed]} = 1.0 if {k} == {number} else 0.0")
        for statement in sweep.body:
            if isinstance(statement, Store):
                self.assign(
                    f"{output}[{offset} + {statement.index}]" if statement.index else f"{output}[{offset}]",
                    statement.value,
                )
            else:
                self.assign(self.scope[statement.name], statement.value)
        self.indent = self.indent[:-4]

    def print_statement(self, statement: Statement) -> None:
        """One statement that is no load."""
        if isinstance(statement, Section):
            self.add_comment(statement.title, self.indent)
            self.mark_origin(statement.origin)
        elif isinstance(statement, Let):
            self.mark_origin(statement.origin)
            self.assign(self.scope[statement.name], statement.value)
        elif isinstance(statement, Guard):
            self.print_guard(statement)
        elif isinstance(statement, Solve):
            self.print_solve(statement)
        elif isinstance(statement, Store):
            self.values[statement.index] = self.print_value(statement.value, WIDTH - len(self.indent) - 5)
            note = " ".join(part for part in (statement.about, show_origin(statement.origin)) if part)
            self.remarks[statement.index] = wrap(print_comment(note), WIDTH - len(self.indent) - 6)
        elif isinstance(statement, Result):
            self.mark_origin(statement.origin)
            self.result = self.print_value(statement.value, WIDTH - len(self.indent) - 10)

    def print_guard(self, guard: Guard) -> None:
        """Raise, or mask where nothing can be raised, unless the block is regular; what is no number is not called singular."""
        bound: Expr = Number(Fraction(guard.tolerance))
        if guard.scale == Number(Fraction(0)):
            bound = guard.scale
        elif guard.scale != Number(Fraction(1)):
            bound = Binary("*", bound, guard.scale)
        value, limit = self.print_value(Call("abs", (guard.value,)), 28), self.print_value(bound, 30)
        test = f"{value} > {limit}"
        self.add_comment(describe_guard(guard, value.partition("(")[2].removesuffix(")")), self.indent)
        if self.array == "jax":
            self.add_mask(test)
            return
        whole = f"np.all({test})" if self.array else test
        self.lines.append(f"{self.indent}if not {whole}:")
        self.helpers.add("refuse")
        items = [value, limit, str(guard.status), f'"{self.function}"']
        self.lines += print_sequence("raise _refuse", items, "()", f"{self.indent}    ")

    def add_mask(self, test: str) -> None:
        """Narrow the mask of the regular lanes."""
        if self.mask:
            self.lines.append(f"{self.indent}{self.mask} = {self.mask} & ({test})")
        else:
            self.mask = self.scope.fresh("ok")
            self.lines.append(f"{self.indent}{self.mask} = {test}")

    def print_solve(self, solve: Solve) -> None:
        """The rows of the matrix beside its right sides, the elimination, the names of the solutions."""
        self.helpers.add("solve")
        rows = []
        for i, row in enumerate(solve.matrix):
            entries = [self.print_value(e, LONGEST_VALUE) for e in (*row, *(c[i] for c in solve.columns))]
            rows.append("\n".join(print_sequence("", entries, "[]", "")))
            if len(self.indent) + 5 + len(rows[-1]) > WIDTH and "\n" not in rows[-1]:
                rows[-1] = "\n".join(["[", *(f"    {entry}," for entry in entries), "]"])
        kind = "Array | float" if self.array else "float"
        block, solution = self.scope.fresh("block"), self.scope.fresh("solution")
        self.add_comment(f"the matrix beside its right sides; {solve.what} where it has no pivot", self.indent)
        self.lines += print_sequence(f"{block}: list[list[{kind}]] = ", rows, "[]", self.indent)
        arguments = f"{block}, {solve.masses}, {print_float(solve.tolerance)}"
        if self.array == "jax":
            regular = self.scope.fresh("regular")
            self.lines.append(f"{self.indent}{solution}, {regular} = _solve({arguments})")
            self.add_mask(regular)
        else:
            arguments += f', {solve.status}, "{self.function}"'
            self.lines.append(f"{self.indent}{solution} = _solve({arguments})")
        for c, names in enumerate(solve.names):
            for i, name in enumerate(names):
                if name in self.used:
                    self.lines.append(f"{self.indent}{self.scope[name]} = {solution}[{c}][{i}]")
