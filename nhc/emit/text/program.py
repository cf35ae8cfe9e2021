"""A program as text, one statement a line: what ``--dump lower`` shows."""

from __future__ import annotations

from nhc.emit.about import print_counts
from nhc.emit.prose import describe_load
from nhc.program.ir import (
    Argument,
    Binary,
    Call,
    Evaluate,
    Expr,
    Function,
    Guard,
    Let,
    Load,
    Negate,
    Number,
    Pi,
    Power,
    Program,
    Quantity,
    Ref,
    Result,
    Section,
    Solve,
    Statement,
    Store,
    Sweep,
)

_LEVELS = {"+": 1, "-": 1, "*": 2, "/": 2}
_UNARY, _POWER, _ATOM = 3, 4, 5


def print_program(program: Program) -> str:
    """The quantities, then each function with its operation counts."""
    lines = [
        f"program {program.system}",
        f"formulation {program.formulation}  ({program.equation}): {program.reason}",
    ]
    groups = (
        ("coordinates", program.coordinates),
        ("state", program.state),
        ("parameters", program.parameters),
        ("constraints", tuple(Quantity(c.name) for c in program.constraints)),  # their units are those of the reactions
        ("outputs", program.outputs),
    )
    for title, quantities in groups:
        if quantities:
            lines.append(f"{title}: {', '.join(_quantity(q) for q in quantities)}")
    lines += [f"note: {note}" for note in program.notes]
    lines += [f"warning: {warning}" for warning in program.warnings]
    for function in program.functions:
        lines += ["", *_function(function)]
    return "\n".join(lines) + "\n"


def _quantity(quantity: Quantity) -> str:
    value = "" if quantity.default is None else f" = {quantity.default}"
    return f"{quantity.name}{value}{f' [{quantity.unit}]' if quantity.unit else ''}"


def _argument(argument: Argument) -> str:
    return argument.name if argument.size < 0 else f"{argument.name}[{argument.size}]"


def _function(function: Function) -> list[str]:
    inputs = ", ".join(_argument(a) for a in function.inputs)
    output = _argument(function.output) if function.output is not None else "scalar"
    counts = print_counts(function)
    number = f"  ({function.equation})" if function.equation else ""
    width = max((len(name) for s in function.body for name in _bound(s)), default=0)
    lines = [f"function {function.name}({inputs}) -> {output}{number}  # {function.about}; {counts}"]
    return lines + [f"  {line}" for s in function.body for line in _statement(s, width)]


def _bound(statement: Statement) -> tuple[str, ...]:
    match statement:
        case Load() | Let():
            return (statement.name,)
        case Store():
            return (f"{statement.array}[{statement.index}]",)
        case Sweep():
            return tuple(name for inner in statement.body for name in _bound(inner))
        case _:
            return ()


def _statement(statement: Statement, width: int) -> list[str]:
    match statement:
        case Section():
            return [f"-- {statement.title}"]
        case Load():
            source = statement.array if statement.index < 0 else f"{statement.array}[{statement.index}]"
            return [f"{statement.name.ljust(width)} := {source}{_remark(describe_load(statement, statement.name))}"]
        case Let():
            return [f"{statement.name.ljust(width)} := {_text(statement.value)}{_remark(statement.origin.equation)}"]
        case Guard():
            bound = f"|{_text(statement.value)}| > {statement.tolerance!r} * |{_text(statement.scale)}|"
            return [f"guard {bound} else {statement.status}{_remark(statement.what)}"]
        case Solve():
            return _solve(statement)
        case Store():
            place = f"{statement.array}[{statement.index}]".ljust(width)
            origin = " ".join(x for x in (statement.about, statement.origin.equation, statement.origin.place) if x)
            return [f"{place} <- {_text(statement.value)}{_remark(origin)}"]
        case Result():
            return [f"result {_text(statement.value)}"]
        case Evaluate():
            return [f"{statement.array} := {statement.function} at the same arguments"]
        case Sweep():
            return _sweep(statement, width)


def _solve(solve: Solve) -> list[str]:
    lines = [f"solve size {len(solve.matrix)}, tolerance {solve.tolerance!r}, else {solve.status}{_remark(solve.what)}"]
    lines += [f"  row [{', '.join(_text(entry) for entry in row)}]" for row in solve.matrix]
    for names, column in zip(solve.names, solve.columns, strict=True):
        lines.append(f"  ({', '.join(names)}) for ({', '.join(_text(entry) for entry in column)})")
    return lines


def _sweep(sweep: Sweep, width: int) -> list[str]:
    offsets = ", ".join(str(offset) for offset in sweep.offsets)
    lines = [f"sweep ({', '.join(sweep.seeds)}) from [{offsets}]{_remark(sweep.about)}"]
    return lines + [f"  {line}" for inner in sweep.body for line in _statement(inner, width)]


def _remark(text: str) -> str:
    return f"  # {text}" if text else ""


def _text(expression: Expr, least: int = 0) -> str:
    """Infix text with the parentheses that the tree needs."""
    match expression:
        case Number():
            text = str(expression.value)
            level = _ATOM if expression.value >= 0 and expression.value.denominator == 1 else _LEVELS["/"]
        case Pi():
            text, level = "pi", _ATOM
        case Ref():
            text, level = expression.name, _ATOM
        case Negate():
            text, level = f"-{_text(expression.operand, _UNARY)}", _UNARY
        case Power():
            text, level = f"{_text(expression.base, _ATOM)}^{expression.exponent}", _POWER
        case Call():
            text, level = f"{expression.function}({', '.join(_text(a) for a in expression.arguments)})", _ATOM
        case Binary():
            level = _LEVELS[expression.op]
            text = f"{_text(expression.left, level)} {expression.op} {_text(expression.right, level + 1)}"
    return text if level >= least else f"({text})"
