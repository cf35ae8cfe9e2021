"""Lines of C: expressions, declarations with remarks, blocks, and what a function keeps in hand while it is printed."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from fractions import Fraction

from nhc.emit.c.arrange import TURNED
from nhc.emit.c.literals import PI, print_comment, print_double
from nhc.emit.expressions import ATOM, ExpressionPrinter, Text
from nhc.emit.names import Scope
from nhc.emit.prose import wrap
from nhc.program.ir import Binary, Expr, Guard, Number, Origin
from nhc.records import record

WIDTH = 110
C_NAMES = {"abs": "fabs"}  # functions that C calls otherwise
ANY = "_any({})"  # this file's own sine and cosine, for any angle
HELPERS = {"sign": "sign", "min": "minimum", "max": "maximum"}  # functions that this file must bring itself
Blocks = dict[tuple[tuple[str, ...], ...], "Block"]
"""By the names of their unknowns."""


@record
class Block:
    """Where in ``kept`` the matrix of a dense solve stands with its right sides; ``masses`` as in the solve."""

    place: int
    masses: int


@record
class CDialect:
    """C's leaves; ``helpers`` collects the static functions that the file needs, ``prefix`` is the system's name.

    ``turned``: (function, angle) -> where that sine or cosine is already.  ``quick``: the machine's root in place of libm's.
    """

    prefix: str
    helpers: set[str]
    trig: str  # what follows the name of this file's own sine or cosine, {} for the angle; empty: libm's
    turned: dict[tuple[str, str], str]
    quick: bool

    def print_number(self, value: Fraction) -> str:
        return print_double(value)

    def print_pi(self) -> str:
        return PI

    def print_power(self, base: Text, exponent: int) -> Text:
        return Text(f"pow({base.text}, {exponent}.0)", ATOM)

    def print_call(self, function: str, arguments: tuple[str, ...]) -> str:
        if self.trig and function in TURNED:
            known = self.turned.get((function, arguments[0]))
            if known is not None:
                return known
            self.helpers.update(("trig", "one", function + self.trig.partition("(")[0]))
            return f"{self.prefix}_{function}{self.trig.format(arguments[0])}"
        if function == "sqrt" and self.quick:
            self.helpers.add("root")
            return f"{self.prefix}_root({arguments[0]})"
        if function not in HELPERS:
            return f"{C_NAMES.get(function, function)}({', '.join(arguments)})"
        helper = HELPERS[function]
        self.helpers.add(helper)
        if function == "sign":
            return f"{self.prefix}_{helper}({arguments[0]})"
        text = arguments[0]
        for argument in arguments[1:]:
            text = f"{self.prefix}_{helper}({text}, {argument})"
        return text


def bound_test(guard: Guard) -> Expr:
    """What the guarded value's magnitude must exceed: ``tolerance * scale``."""
    if guard.scale == Number(Fraction(0)):
        return guard.scale
    bound = Number(Fraction(guard.tolerance))
    return bound if guard.scale == Number(Fraction(1)) else Binary("*", bound, guard.scale)


_BREAKS = re.compile(r"(?<!const)(?<!double)(?<!int)(?<!size_t)(?<!restrict) ")
"""Blanks at which a line may end: not those within a declaration such as ``const double *y``."""


def wrap_code(text: str, indent: str) -> list[str]:
    """One statement or head of a function, broken at blanks round binary operators and after commas."""
    if len(indent) + len(text) <= WIDTH:
        return [indent + text]
    lines: list[str] = []
    line = indent
    for word in _BREAKS.split(text):
        if len(line) + len(word) + 1 > WIDTH and line.strip():
            lines.append(line.rstrip())
            line = indent + "    "
        line += word + " "
    lines.append(line.rstrip())
    return lines


class CodePrinter:
    """Collects the ``lines`` of one C function.

    ``element(array, index)`` is how the function reaches an entry of an array, ``scalar`` whether it returns a number, NaN from
    a singular block, in place of a status, ``quick`` whether speed counts above all: short dense solves are written out, and roots
    are the machine's; ``used`` the names that something reads, ``helpers`` collects the static functions
    that are needed.
    """

    def __init__(
        self,
        prefix: str,
        scope: Scope,
        helpers: set[str],
        element: Callable[[str, int], str],
        used: frozenset[str],
        trig: str = "",
        scalar: bool = False,
        quick: bool = False,
    ) -> None:
        self.prefix = prefix
        self.scope = scope
        self.helpers = helpers
        self.element = element
        self.used = used
        self.indent = "    "
        self.lines: list[str] = []
        self.trig = trig
        self.scalar = scalar
        self.turned: dict[tuple[str, str], str] = {}
        self.printer = ExpressionPrinter(CDialect(prefix, helpers, trig, self.turned, quick), scope.spellings)
        self.kept: dict[str, tuple[int, ...]] = {}  # names that others find in the array `kept`, and all their places
        self.blocks: Blocks = {}  # dense solves that parts have filled
        self.arguments: tuple[str, ...] = ()  # what other functions are called with
        self.paired = False  # whether angles are turned two at a time
        self.quick = quick
        self._origin = ""
        self._last_origin = Origin()

    def add(self, text: str) -> None:
        """One line of code, broken where it is too long."""
        if len(self.indent) + len(text) <= WIDTH:
            self.lines.append(self.indent + text)
        else:
            self.lines += wrap_code(text, self.indent)

    def add_comment(self, text: str) -> None:
        """A comment on its own lines; ``text`` must have gone through ``print_comment``."""
        if text:
            self.lines += [f"{self.indent}/* {line} */" for line in wrap(text, WIDTH - len(self.indent) - 6)]

    def add_noted(self, code: str, about: str) -> None:
        """Code with a remark: behind it where there is room, else above it."""
        note = print_comment(about)
        if note and len(self.indent) + len(code) + len(note) + 7 <= WIDTH:
            self.lines.append(f"{self.indent}{code} /* {note} */")
        else:
            self.add_comment(note)
            self.add(code)

    def keep(self, name: str) -> None:
        """Put a value where parts of the function find it."""
        for place in self.kept.get(name, ()):
            self.lines.append(f"{self.indent}kept[{place}] = {self.scope[name]};")

    def clear(self, array: str, size: int) -> None:
        """Zero for all entries of an array of doubles; all bits of 0.0 are zero (IEC 60559, C99 annex F)."""
        self.helpers.add("memset")
        self.add(f"memset({array}, 0, {size} * sizeof *{array});")

    def open_unless(self, tests: Sequence[str]) -> None:
        """Begin a block for where one of the tests fails; each has its line where they are long."""
        condition = f"if (!({' && '.join(tests)})) {{"
        if len(self.indent) + len(condition) <= WIDTH:
            self.add(condition)
        else:
            self.add(f"if (!({tests[0]}")
            for test in tests[1:]:
                self.add(f"    && {test}")
            self.lines[-1] += ")) {"
        self.indent += "    "

    def close(self) -> None:
        """End a block."""
        self.indent = self.indent[:-4]
        self.lines.append(f"{self.indent}}}")
