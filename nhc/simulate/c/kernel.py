"""A function of the program for the inside of a loop: one state or several lanes at once, and nothing left early.

What depends on the parameters alone is computed once for a run.  Sine and cosine have no branch.  A singular block is only
noted, like an angle too large for them: who called asks the model itself then, which says what it is.
"""

from __future__ import annotations

from fractions import Fraction

from nhc.emit.c.body import BodyPrinter
from nhc.emit.c.lines import C_NAMES, HELPERS, bound_test, wrap_code
from nhc.emit.c.literals import PI, print_double
from nhc.emit.c.names import make_scope
from nhc.emit.expressions import ATOM, ExpressionPrinter, Text
from nhc.emit.names import Scope
from nhc.emit.statements import collect_refs, drop_unused, fill_stores, iterate_refs, split_hoisted
from nhc.program.ir import Call, Expr, Function, Guard, Let, Load, Program, Solve, Statement, Store
from nhc.records import record
from nhc.simulate.c.angles import TURNED, Turn, gather_angles, name_turned
from nhc.simulate.c.layers import Split, split_layers

ONE, PACK, LANES = "one", "pack", "lanes"
_MAPPED = ("fabs", "sqrt", "exp", "log", "pow", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh")
_OWN = (
    *("fixed", "far", "bad", "kept", "layers", "pack", "lanes", "spread", "spread_pack", "duo"),
    *("turn_one", "turn_pack", "square_pack", "total_pack"),
    *(f"{name}_{kind}" for name in ("sin", "cos", *_MAPPED) for kind in (ONE, PACK, LANES)),
)
_SPREAD = {PACK: "spread_pack", LANES: "spread"}
_PACK = 4
"""Angles turned together; as many doubles as a 256-bit vector holds."""
_SHORT = 40  # statements: a longer body is called and not repeated at each stage
_LONGEST = 1500  # statements: beyond them the compiler would take too long for what a kernel gains


@record
class PrintedLayer:
    """A layer's body for several stages at once; ``entries`` and ``reads`` as in ``Layer``."""

    entries: tuple[int, ...]
    reads: tuple[int, ...]
    lines: tuple[str, ...]
    short: bool


@record
class Kernel:
    """``prepare`` fills ``fixed`` with ``count`` numbers from p; ``one`` and ``lanes`` are the bodies for one state and for many.

    ``layers``: what ``one`` leaves to be done later, from ``kept`` values, the first of which are ``handed`` over by it and the
    others by the layers to one another; ``packed`` and ``calls``: C's functions of (one, two) arguments that layers and lanes
    need, entry by entry; ``reads``: the entries of the state that a stage asks for, ``waiting``: the others.
    """

    name: str
    about: str
    output: str
    count: int
    prepare: tuple[str, ...]
    one: tuple[str, ...]
    lanes: tuple[str, ...]
    layers: tuple[PrintedLayer, ...]
    kept: int
    handed: int
    packed: tuple[tuple[str, ...], tuple[str, ...]]
    calls: tuple[tuple[str, ...], tuple[str, ...]]
    reads: tuple[int, ...]
    waiting: tuple[int, ...]
    short: bool


@record
class _Dialect:
    """C's leaves for numbers of one kind; ``called`` collects name -> number of arguments."""

    prefix: str
    kind: str
    called: dict[str, int]

    def print_number(self, value: Fraction) -> str:
        return print_double(value)

    def print_pi(self) -> str:
        return PI

    def print_power(self, base: Text, exponent: int) -> Text:
        return Text(self._call("pow", (base.text, f"{exponent}.0")), ATOM)

    def print_call(self, function: str, arguments: tuple[str, ...]) -> str:
        if function in TURNED:
            return f"{function}_{self.kind}({arguments[0]}, far)"
        if function in HELPERS:
            name = f"{self.prefix}_{HELPERS[function]}"
            text = arguments[0] if len(arguments) > 1 else self._call(name, arguments)
            for argument in arguments[1:]:
                text = self._call(name, (text, argument))
            return text
        return self._call(C_NAMES.get(function, function), arguments)

    def _call(self, name: str, arguments: tuple[str, ...]) -> str:
        if self.kind == ONE:
            return f"{name}({', '.join(arguments)})"
        self.called[name] = len(arguments)
        return f"{name}_{self.kind}({', '.join(f'{_SPREAD[self.kind]}({argument})' for argument in arguments)})"


class _Printer:
    """Statements of a kernel's body for one kind of number."""

    def __init__(self, prefix: str, kind: str, scope: Scope, called: dict[str, int]) -> None:
        self.kind, self.scope = kind, scope
        self.type = "double" if kind == ONE else kind
        self.printer = ExpressionPrinter(_Dialect(prefix, kind, called), scope.spellings)
        self.lines: list[str] = []

    def add(self, text: str) -> None:
        self.lines += wrap_code(text, "    ")

    def print_value(self, value: Expr) -> str:
        """A number alone is no vector."""
        text = self.printer.print(value)
        return text if self.kind == ONE or any(True for _ in iterate_refs(value)) else f"{_SPREAD[self.kind]}({text})"

    def print_statement(self, statement: Statement) -> None:
        if isinstance(statement, Load):
            source = statement.array if statement.index < 0 else f"{statement.array}[{statement.index}]"
            self.add(f"const {self.type} {self.scope[statement.name]} = {source};")
        elif isinstance(statement, Let):
            self.add(f"const {self.type} {self.scope[statement.name]} = {self.print_value(statement.value)};")
        elif isinstance(statement, Guard):
            value = self.print_value(Call("abs", (statement.value,)))
            bound = self.print_value(bound_test(statement))
            self.add(f"*bad |= {'!' if self.kind == ONE else '~'}({value} > {bound});")
        elif isinstance(statement, Store):
            self.add(f"{statement.array}[{statement.index}] = {self.print_value(statement.value)};")

    def print_turn(self, turn: Turn) -> None:
        """Sines and cosines under the names of ``gather_angles``: one angle's side by side, those of more in two vectors.

        Two angles are not put together: each would wait for the other.
        """
        for first in range(0, len(turn.angles), _PACK):
            some = [self.print_value(angle) for angle in turn.angles[first : first + _PACK]]
            if len(some) > 2:
                places = self._print_pack(some)
            else:
                names = [self.scope.fresh("turned") for _ in some]
                for name, angle in zip(names, some, strict=True):
                    self.add(f"const duo {name} = turn_one({angle}, far);")
                places = [(f"{name}[0]", f"{name}[1]") for name in names]
            for k, pair in enumerate(places):
                for function, place in zip(TURNED, pair, strict=True):
                    self.scope.alias(name_turned(function, turn.first + first + k), place)

    def _print_pack(self, some: list[str]) -> list[tuple[str, str]]:
        angles, sines, cosines = (self.scope.fresh(name) for name in ("angles", "sines", "cosines"))
        self.add(f"const pack {angles} = {{{', '.join(some + ['0.0'] * (_PACK - len(some)))}}};")
        self.add(f"*far += square_pack({angles});")
        self.add(f"const pack {sines} = turn_pack({angles}, 0);")
        self.add(f"const pack {cosines} = turn_pack({angles}, 1);")
        return [(f"{sines}[{k}]", f"{cosines}[{k}]") for k in range(len(some))]


def print_kernel(program: Program, function: Function) -> Kernel | None:
    """The kernel of a function; None where it holds a linear system, which a loop over lanes cannot pivot."""
    body = drop_unused(function.body)
    if function.output is None or len(body) > _LONGEST or any(isinstance(s, Solve) for s in body):
        return None
    outside, inside = split_hoisted(tuple(s for s in body if not isinstance(s, Store)) + fill_stores(function))
    scope = make_scope(program, (*function.inputs, function.output), body, _OWN)
    bound = [statement.name for statement in outside if isinstance(statement, Load | Let)]
    read = {name for statement in inside for name in collect_refs(statement)}
    fixed = [name for name in bound if name in read]
    split = split_layers(inside) if function.name == "rhs" else Split(inside, (), ())
    packed: dict[str, int] = {}
    called: dict[str, int] = {}
    bodies = _Bodies(program, function, split, fixed, scope)
    return Kernel(
        name=function.name,
        about=function.about,
        output=function.output.name,
        count=len(fixed),
        prepare=_print_prepare(program, outside, fixed, scope),
        one=bodies.print_one(),
        lanes=bodies.print_lanes(called),
        layers=tuple(
            PrintedLayer(layer.entries, layer.reads, bodies.print_layer(place, packed), len(layer.body) <= _SHORT)
            for place, layer in enumerate(split.layers)
        ),
        kept=len(split.kept),
        handed=len(_list_bound(split.early).intersection(split.kept)),
        packed=(_named(packed, 1), _named(packed, 2)),
        calls=(_named(called, 1), _named(called, 2)),
        reads=tuple(sorted({s.index for s in split.early if isinstance(s, Load) and s.array == "y"})),
        waiting=split.waiting,
        short=len(split.early) <= _SHORT,
    )


@record
class _Bodies:
    """The same statements for each kind of number."""

    program: Program
    function: Function
    split: Split
    fixed: list[str]
    scope: Scope

    def print_one(self) -> tuple[str, ...]:
        """What each stage needs; it hands over the values that the layers need."""
        printer = self._begin(ONE, {}, self.split.early)
        for statement in gather_angles(self.split.early):
            if isinstance(statement, Turn):
                printer.print_turn(statement)
            else:
                printer.print_statement(statement)
        bound = _list_bound(self.split.early)
        for k, name in enumerate(self.split.kept):
            if name in bound:
                printer.add(f"kept[{k}] = {self.scope[name]};")
        return tuple(printer.lines)

    def print_layer(self, place: int, called: dict[str, int]) -> tuple[str, ...]:
        """A layer for several stages; it finds in ``kept`` what was handed over, and hands over what it binds."""
        body = self.split.layers[place].body
        printer = self._begin(PACK, called, body)
        bound = _list_bound(body)
        used = {name for statement in body for name in collect_refs(statement)}
        kept = {name: k for k, name in enumerate(self.split.kept)}
        for name, k in kept.items():
            if name in used and name not in bound:
                printer.add(f"const pack {self.scope[name]} = kept[{k}];")
        for statement in body:
            printer.print_statement(statement)
        for name, k in kept.items():
            if name in bound:
                printer.add(f"kept[{k}] = {self.scope[name]};")
        return tuple(printer.lines)

    def print_lanes(self, called: dict[str, int]) -> tuple[str, ...]:
        """All of it, the layers one inside the other."""
        whole = self.split.early + tuple(s for layer in self.split.layers for s in layer.body)
        printer = self._begin(LANES, called, whole)
        seen: set[str] = set()
        for place, body in enumerate((self.split.early, *(layer.body for layer in self.split.layers))):
            if place:
                printer.add(f"if (layers >= {place}) {{")
            for statement in body:
                if not isinstance(statement, Load) or statement.name not in seen:
                    printer.print_statement(statement)
            seen |= _list_bound(body)
        printer.lines += ["    }" for _ in self.split.layers]
        return tuple(printer.lines)

    def _begin(self, kind: str, called: dict[str, int], body: tuple[Statement, ...]) -> _Printer:
        """A printer that has marked the arguments that a body need not use, and has the fixed values that it does."""
        printer = _Printer(self.program.system, kind, self.scope, called)
        loads = {statement.array for statement in body if isinstance(statement, Load)}
        used = {name for statement in body for name in collect_refs(statement)}
        unused = [argument.name for argument in self.function.inputs if argument.name not in {*loads, "p"}]
        unused += ["far", "bad"] if kind != PACK else ["far", "kept"]
        unused += ["layers"] if kind == LANES and self.split.layers else []
        fixed = [(k, name) for k, name in enumerate(self.fixed) if name in used]
        printer.lines += [f"    (void){name};" for name in (*unused, *(() if fixed else ("fixed",)))]
        for k, name in fixed:
            value = f"spread_pack(fixed[{k}])" if kind == PACK else f"fixed[{k}]"
            printer.add(f"const {printer.type} {self.scope[name]} = {value};")
        return printer


def _list_bound(body: tuple[Statement, ...]) -> set[str]:
    return {statement.name for statement in body if isinstance(statement, Load | Let)}


def _print_prepare(program: Program, outside: tuple[Statement, ...], fixed: list[str], scope: Scope) -> tuple[str, ...]:
    """libm's functions do here: it is done once."""
    helpers: set[str] = set()
    used = frozenset(fixed)
    for statement in reversed(outside):
        if isinstance(statement, Guard) or (isinstance(statement, Let) and statement.name in used):
            used |= collect_refs(statement)
    printer = BodyPrinter(program.system, scope, helpers, lambda array, index: f"{array}[{index}]", used)
    printer.print_all(tuple(s for s in outside if not isinstance(s, Load | Let) or s.name in used))
    lines = printer.lines + [f"    fixed[{k}] = {scope[name]};" for k, name in enumerate(fixed)]
    loads = any(isinstance(s, Load) and s.name in used for s in outside)
    return (*(() if loads else ("    (void)p;",)), *(() if fixed else ("    (void)fixed;",)), *lines, "    return 0;")


def _named(called: dict[str, int], count: int) -> tuple[str, ...]:
    return tuple(sorted(name for name, arguments in called.items() if arguments == count))
