"""``rhs`` over many states at once, as one loop that a compiler can vectorise."""

from __future__ import annotations

from nhc.emit.c.body import ANY, NEAR, BodyPrinter, print_singular
from nhc.emit.c.literals import print_comment
from nhc.emit.c.names import make_scope
from nhc.emit.names import Scope
from nhc.emit.statements import drop_unused, fill_stores, list_used_names, split_hoisted
from nhc.program.ir import Function, Guard, Load, Program, Solve, Statement, Store

# rows of one array that gcc takes for overlapping, and then gives up on the loop, when there are many of them
INDEPENDENT = ("#if defined(__GNUC__) && !defined(__clang__)", "#pragma GCC ivdep", "#endif")
OWN = ("count", "i", "k", "bad", "status", "one", "state", "slope")


class LoopPrinter(BodyPrinter):
    """Statements inside the loop: nothing leaves early, each guard has its flag instead."""

    flags: dict[int, str]

    def print_statement(self, statement: Statement) -> None:
        """As outside a loop, but a stored value is looked at at once."""
        if not isinstance(statement, Store):
            super().print_statement(statement)
            return
        self.mark_origin(statement.origin)
        value = self.scope.fresh("slope")
        self.add_noted(f"const double {value} = {self.printer.print(statement.value)};", statement.about)
        self.add(f"{self.element(statement.array, statement.index)} = {value};")
        self.add(f"bad |= !(fabs({value}) <= DBL_MAX);")

    def print_guard(self, guard: Guard) -> None:
        """Note that one of the states is singular, and go on."""
        self.add_comment(print_comment(guard.what))
        self.add(f"{self.flags[guard.status]} |= {self.print_test(guard)};")


def reach_element(array: str, index: int) -> str:
    """An entry of a structure of arrays; the parameters are shared."""
    if index < 0:
        return f"{array}[i]"
    if array == "p":
        return f"p[{index}]"
    if index == 0:
        return f"{array}[i]"
    return f"{array}[count + i]" if index == 1 else f"{array}[{index} * count + i]"


def print_batch(program: Program, function: Function, helpers: set[str], *, inline: bool) -> tuple[str, ...]:
    """The lines of ``rhs_batch``'s body for the function ``rhs``; ``inline``: with this file's own sine and cosine."""
    body = drop_unused(function.body)
    if any(isinstance(statement, Solve) for statement in body):
        return print_gathered(program, function)
    scope = make_scope(program, (*function.inputs, *([function.output] if function.output else [])), body, OWN)
    return print_loop(program, function, body, scope, helpers, inline=inline)


def print_loop(
    program: Program,
    function: Function,
    body: tuple[Statement, ...],
    scope: Scope,
    helpers: set[str],
    *,
    inline: bool,
) -> tuple[str, ...]:
    """The loop with the body inlined and the work on parameters in front of it.

    The inlined sine and cosine know no large angles: a state with one sends all of them to ``rhs``, one by one.
    """
    prefix = program.system
    outside, inside = split_hoisted(tuple(s for s in body if not isinstance(s, Store)) + fill_stores(function))
    used = frozenset(list_used_names(body))

    def leave(code: int) -> str:
        return print_singular(prefix, code)

    printer = LoopPrinter(prefix, scope, helpers, reach_element, leave, used, NEAR if inline else "")
    codes = sorted({s.status for s in inside if isinstance(s, Guard)})
    printer.flags = {code: scope.fresh("singular") for code in codes}
    before = BodyPrinter(prefix, scope, helpers, reach_element, leave, used, ANY if inline else "")
    before.print_all(outside)
    printer.indent = " " * 8
    printer.print_all(inside)
    lines = list(before.lines)
    lines += [f"    int {flag} = 0;" for flag in (*printer.flags.values(), "bad")]
    lines += mark_unused(function, body)
    lines += [*INDEPENDENT, "    for (size_t i = 0; i < count; ++i) {", *printer.lines, "    }"]
    for code, flag in printer.flags.items():
        lines += [f"    if ({flag}) {{", f"        return {leave(code)};", "    }"]
    if inline:
        again = [f"    {line}" for line in print_gathered(program, function)]
        return (*lines, "    if (bad) {", *again, "    }", f"    return {prefix.upper()}_OK;")
    lines.append(f"    return bad ? {prefix.upper()}_NOT_FINITE : {prefix.upper()}_OK;")
    return tuple(lines)


def mark_unused(function: Function, body: tuple[Statement, ...]) -> list[str]:
    """``(void)p;`` for each argument that the body does not read."""
    read = {statement.array for statement in body if isinstance(statement, Load)}
    return [f"    (void){argument.name};" for argument in function.inputs if argument.name not in read]


def print_gathered(program: Program, function: Function) -> tuple[str, ...]:
    """The loop for a model with a linear system to solve: one call of ``rhs`` per state."""
    prefix, capitals = program.system, program.system.upper()
    size = len(program.state)
    return (
        f"    int status = {capitals}_OK;",
        "    for (size_t i = 0; i < count; ++i) {",
        f"        double state[{size}];",
        f"        double slope[{size}];",
        f"        for (size_t k = 0; k < {size}; ++k) {{",
        "            state[k] = y[k * count + i];",
        "            slope[k] = NAN;",
        "        }",
        f"        const int one = {prefix}_{function.name}(t[i], state, p, slope);",
        f"        status = status == {capitals}_OK ? one : status;",
        f"        for (size_t k = 0; k < {size}; ++k) {{",
        "            dydt[k * count + i] = slope[k];",
        "        }",
        "    }",
        "    return status;",
    )
