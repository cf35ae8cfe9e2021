"""Statements over several states at once: GCC's vectors where there are any, else one double.

Nothing leaves early: a singular block, an angle too large for this file's sine and cosine and a result that is not finite
are only noted, and who called asks the scalar function then.
"""

from __future__ import annotations

from fractions import Fraction

from nhc.emit.c.lines import HELPERS, bound_test, wrap_code
from nhc.emit.c.literals import PI, print_comment, print_double
from nhc.emit.c.rolled.lines import Fetch, Leave, Line, Loop, Put
from nhc.emit.c.rolled.printing import print_factor, print_index, print_loop
from nhc.emit.expressions import ATOM, ExpressionPrinter, Text
from nhc.emit.names import Scope
from nhc.emit.prose import describe_guard, show_origin
from nhc.emit.statements import iterate_refs
from nhc.program.ir import Call, Expr, Guard, Let, Load, Store
from nhc.records import record

_TURNED = ("sin", "cos")


@record
class Each:
    """A function of C that is called lane by lane: the helper's name, the function, its number of arguments."""

    name: str
    function: str
    arguments: int


class LanesPrinter:
    """Prints lets, guards and stores over lanes into ``lines``.

    ``scalars`` are names of single numbers.  ``each`` collects the functions that are called lane by lane.
    ``summed`` are the entries that tell whether all are finite (None: every one).
    """

    def __init__(
        self,
        prefix: str,
        scope: Scope,
        helpers: set[str],
        each: dict[str, Each],
        scalars: frozenset[str],
        summed: frozenset[int] | None,
    ) -> None:
        self.summed = summed
        self.prefix, self.scope, self.helpers, self.each, self.scalars = prefix, scope, helpers, each, scalars
        self.kind = f"{prefix}_lanes"
        self.printer = ExpressionPrinter(_Dialect(self), scope.spellings)
        self.lines: list[str] = []
        self.turned: dict[str, tuple[str, str]] = {}
        self.passing: set[str] = set()  # numbers of a loop's passes
        self.passes = 0
        self._origin = ""

    def add(self, text: str) -> None:
        """One line of code, broken where it is too long."""
        self.lines += wrap_code(text, "    ")

    def turn(self, function: str, angle: str) -> str:
        """The sine or cosine of an angle: both are computed when the first is asked for."""
        if angle not in self.turned:
            self.helpers.add("turn")
            names = self.scope.fresh("sine"), self.scope.fresh("cosine")
            self.turned[angle] = names
            self.add(f"{self.kind} {names[0]}, {names[1]};")
            self.add(f"{self.prefix}_turn_lanes({self.spread(angle)}, &far, &{names[0]}, &{names[1]});")
        return self.turned[angle][_TURNED.index(function)]

    def spread(self, text: str) -> str:
        """Lanes from lanes or from a single number."""
        return f"{self.prefix.upper()}_SPREAD({text})"

    def call_each(self, function: str, arguments: tuple[str, ...]) -> str:
        """A function of C in each lane."""
        name = f"{self.prefix}_each_{function.removeprefix(self.prefix + '_')}"
        self.each[name] = Each(name, function, len(arguments))
        return f"{name}({', '.join(self.spread(argument) for argument in arguments)})"

    def print_value(self, value: Expr) -> str:
        """An expression as lanes, a single number too."""
        text = self.printer.print(value)
        numbers = self.scalars | self.passing
        return text if any(name not in numbers for name in iterate_refs(value)) else self.spread(text)

    def print_statement(self, statement: Line) -> None:
        """A load, let, guard or store, or a loop."""
        if isinstance(statement, Loop):
            outside = dict(self.turned)
            self.passes = statement.count
            print_loop(self.lines, statement, self.add, self.print_in_loop)
            self.turned = outside  # the others were the passes' own
        elif isinstance(statement, Leave):
            self.print_in_loop(statement)
        elif isinstance(statement, Load):
            source = "t" if statement.index < 0 else f"y + {statement.index} * stride" if statement.index else "y"
            self.helpers.add("get")
            self.add(f"const {self.kind} {self.scope[statement.name]} = {self.prefix}_get({source});")
        elif isinstance(statement, Let):
            value = self.print_value(statement.value)
            self.add(f"const {self.kind} {self.scope[statement.name]} = {value};")
        elif isinstance(statement, Guard):
            what = print_comment(describe_guard(statement, self.printer.print(statement.value)))
            self.lines += [f"    /* {line} */" for line in (what,) if line]
            value, bound = self.print_value(Call("abs", (statement.value,))), self.print_value(bound_test(statement))
            self.helpers.add("misses")
            self.add(f"bad |= {self.prefix}_misses({value}, {bound});")
        elif isinstance(statement, Store):
            self.print_store(statement)

    def print_in_loop(self, line: Fetch | Let | Leave | Put) -> None:
        """What stands in a loop: ``fixed`` holds numbers, the other arrays lanes."""
        if isinstance(line, Let):
            self.print_statement(line)
        elif isinstance(line, Leave):
            name = self.scope[line.name]
            value = self.spread(name) if line.name in self.scalars else name
            index = print_factor(line.first, line.step)
            self.add(f"{self.prefix}_put(carried + {index} * {self.prefix.upper()}_LANES, {value});")
        elif isinstance(line, Put):
            self.print_put(line)
        elif line.array == "fixed":
            index = print_index(line.first, line.step)
            self.passing.add(line.name)
            self.add(f"const double {self.scope[line.name]} = fixed[{index}];")
        else:
            self.helpers.add("get")
            index = print_factor(line.first, line.step)
            place = f"y + {index} * stride" if line.array == "y" else f"carried + {index} * {self.prefix.upper()}_LANES"
            self.add(f"const {self.kind} {self.scope[line.name]} = {self.prefix}_get({place});")

    def print_put(self, put: Put) -> None:
        """A result of each pass; that of some passes may be tested without need."""
        name, store = self.scope.fresh("slope"), put.store
        self.add(f"const {self.kind} {name} = {self.print_value(store.value)};")
        if self.summed is None or any(store.index + put.step * k in self.summed for k in range(self.passes)):
            self.add(f"sum += {name};")
        self.add(f"{self.prefix}_put(dydt + {print_factor(store.index, put.step)} * stride, {name});")

    def print_store(self, store: Store) -> None:
        """A result, which may enter the sum that tells whether all of them are finite."""
        text = print_comment(show_origin(store.origin))
        if text and text != self._origin:
            self._origin = text
            self.lines.append(f"    /* {text} */")
        name = self.scope.fresh("slope")
        target = f"dydt + {store.index} * stride" if store.index else "dydt"
        self.add(f"const {self.kind} {name} = {self.print_value(store.value)};")
        if self.summed is None or store.index in self.summed:
            self.add(f"sum += {name};")
        self.add(f"{self.prefix}_put({target}, {name});")


@record
class _Dialect:
    """C's leaves for lanes."""

    owner: LanesPrinter

    def print_number(self, value: Fraction) -> str:
        return print_double(value)

    def print_pi(self) -> str:
        return PI

    def print_power(self, base: Text, exponent: int) -> Text:
        return Text(self.owner.call_each("pow", (base.text, f"{exponent}.0")), ATOM)

    def print_call(self, function: str, arguments: tuple[str, ...]) -> str:
        owner = self.owner
        if function in _TURNED:
            return owner.turn(function, arguments[0])
        if function == "abs":
            owner.helpers.add("size")
            return f"{owner.prefix}_size({owner.spread(arguments[0])})"
        if function not in HELPERS:
            return owner.call_each(function, arguments)
        owner.helpers.add(HELPERS[function])
        name = f"{owner.prefix}_{HELPERS[function]}"
        if function == "sign":
            return owner.call_each(name, arguments)
        text = arguments[0]
        for argument in arguments[1:]:
            text = owner.call_each(name, (text, argument))
        return text
