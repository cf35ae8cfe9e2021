"""``rhs`` with this file's own sine and cosine, and once more with libm's for angles that are too large for them.

One test at the end covers all angles: a test at each sine would be a branch each, and the call of libm behind it would cost the
function its registers and a frame.  The source holds one body; it is compiled twice, unless it is so long that compilers would feel
it: a test at each angle costs a long body 3 to 5 percent of its instructions, a short one up to a fifth.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.emit.c.body import BodyPrinter
from nhc.emit.c.lines import wrap_code
from nhc.program.contents import list_expressions, walk
from nhc.program.ir import Argument, Binary, Call, Expr, Function, Statement

LARGE, TURNED = "large", "turned"
"""The body's parameter that says which sine and cosine it takes, and the sum that it tests."""
AT = "_at({}, large)"
"""The sine and cosine that it takes."""
LONGEST = 200  # statements of a body that is compiled twice


def list_angles(body: Sequence[Statement]) -> tuple[Expr, ...]:
    """What a short body takes sines and cosines of, each once."""
    if len(body) > LONGEST:
        return ()
    parts = (part for statement in body for expression in list_expressions(statement) for part in walk(expression))
    turned = (part for part in parts if isinstance(part, Call) and part.function in ("sin", "cos"))
    return tuple(dict.fromkeys(part.arguments[0] for part in turned))


def square_all(angles: Sequence[Expr]) -> Expr:
    """The sum of the angles' squares."""
    total: Expr = Binary("*", angles[0], angles[0])
    for angle in angles[1:]:
        total = Binary("+", total, Binary("*", angle, angle))
    return total


def print_near(printer: BodyPrinter, function: Function, angles: Sequence[Expr]) -> tuple[str, str]:
    """Sum the angles' squares (zero where the body takes any angle); the test of the sum, and the call where it fails."""
    printer.add_comment("the squares of the angles: beyond 1e10, that is 1e5 for one, libm's sine and cosine are taken")
    printer.add(f"const double {TURNED} = {LARGE} ? 0.0 : {printer.printer.print(square_all(angles))};")
    given = ", ".join(argument.name for argument in list_all(function))
    return f"{TURNED} <= 1e10", f"{printer.prefix}_{function.name}_{LARGE}({given})"


def list_all(function: Function) -> tuple[Argument, ...]:
    """The inputs and the output."""
    return function.inputs if function.output is None else (*function.inputs, function.output)


def print_twice(prefix: str, function: Function, arguments: str, body: Sequence[str]) -> tuple[list[str], list[str]]:
    """What stands before the function (its body, compiled twice), and what it does itself."""
    name = f"{prefix}_{function.name}"
    given = ", ".join(a.name for a in list_all(function))
    again = wrap_code(f"static int {name}_{LARGE}({arguments})", "")
    before = [
        "",
        "#if defined(__GNUC__)",
        "__attribute__((cold, noinline))",
        "#endif",
        *again[:-1],
        f"{again[-1]};",
        "",
        "#if defined(__GNUC__)",
        "__attribute__((always_inline)) /* once with each sine and cosine */",
        "#endif",
        *wrap_code(f"static inline int {name}_body({arguments},", ""),
        f"    int {LARGE})",
        "{",
        *body,
        "}",
        "",
        "/* for angles beyond 1e5 */",
        *again,
        "{",
        f"    return {name}_body({given}, 1);",
        "}",
    ]
    return before, [f"    return {name}_body({given}, 0);"]
