"""The comments of a C file: what it computes, from what, in which layout."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.emit.c.literals import print_comment
from nhc.emit.prose import OPERATIONS, print_counts, title_constraints, wrap
from nhc.program.ir import Function, Program, Quantity
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

WIDTH = 107


def wrap_all(texts: Iterable[str], hanging: str = "    ") -> tuple[str, ...]:
    """Each text cleaned and wrapped; an empty one stays as an empty line."""
    lines: list[str] = []
    for text in texts:
        lines += wrap(print_comment(text), WIDTH, hanging) or [""]
    return tuple(lines)


def frame(lines: Iterable[str]) -> tuple[str, ...]:
    """The lines of a comment block between its first and its last."""
    return tuple(f" * {line}".rstrip() for line in lines)


def describe_quantity(quantity: Quantity) -> str:
    """``theta [rad]: heading``."""
    unit = f" [{quantity.unit}]" if quantity.unit else ""
    return f"{quantity.name}{unit}{f': {quantity.about}' if quantity.about else ''}"


def describe_parameter(quantity: Quantity) -> str:
    """``m = 1.0 [kg]: mass``, or that it must be set."""
    unit = f" [{quantity.unit}]" if quantity.unit else ""
    value = " (no default: must be set)" if quantity.default is None else f" = {float(quantity.default)!r}"
    return f"{quantity.name}{value}{unit}{f': {quantity.about}' if quantity.about else ''}"


def describe_program(program: Program) -> tuple[str, ...]:
    """The paragraphs that head every file of a program."""
    number = f" ({program.equation})" if program.equation else ""
    return tuple(
        text
        for text in (
            program.about,
            f"Source: {program.source}" if program.source else "",
            f"Equations of motion: {program.formulation}{number}",
            f"Why: {program.reason}" if program.reason else "",
            *(f"Note: {note}" for note in program.notes),
            *(f"Warning: {warning}" for warning in program.warnings),
        )
        if text
    )


def print_file_comment(program: Program, functions: tuple[Function, ...], file_name: str) -> tuple[str, ...]:
    """The header comment of ``<s>.h``."""
    texts = [*describe_program(program), "", "State y:"]
    texts += [f"y[{i}] = {describe_quantity(quantity)}" for i, quantity in enumerate(program.state)]
    texts += ["", "Parameters p:" if program.parameters else "No parameters."]
    texts += [f"p[{i}]: {describe_parameter(quantity)}" for i, quantity in enumerate(program.parameters)]
    if program.constraints:
        texts += ["", title_constraints(program.constraints)]
        texts += [f"{i}: {describe_quantity(quantity)}" for i, quantity in enumerate(program.constraints)]
    if program.outputs:
        texts += ["", "Outputs:"]
        texts += [f"out[{i}] = {describe_quantity(quantity)}" for i, quantity in enumerate(program.outputs)]
    if functions:
        texts += ["", OPERATIONS]
        texts += [f"{function.name}: {count(function)}" for function in functions]
    texts += ["", *explain_calls(program, functions)]
    head = f"{file_name}: {program.system}, emitted by nhc {__version__} ({PLACEHOLDER})"
    return frame((head, *wrap_all(texts)))


def explain_calls(program: Program, functions: tuple[Function, ...]) -> tuple[str, ...]:
    """What a caller has to know: arrays, units, return codes, threads, and what the numbers in parentheses are."""
    capitals, names = program.system.upper(), {function.name for function in functions}
    quantities = (*program.state, *program.parameters, *program.constraints, *program.outputs)
    fill = f" {program.system}_state makes y from coordinates and velocities." if "state" in names else ""
    cites = "Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non"
    return tuple(
        text
        for text in (
            f"Calls: t is the time; y has {capitals}_NY entries, p has {capitals}_NP;"
            f" {program.system}_parameter_defaults may be passed as p.{fill}",
            "All arrays are the caller's; an output must not overlap an input.",
            "Units are in brackets, and nothing is converted." if any(q.unit for q in quantities) else "",
            f"Return codes: {capitals}_OK (0) if the result is good; after any other code the output must not be used.",
            "Compile without -ffast-math: it removes the tests for infinities and NaN.",
            "Threads: nothing is kept between calls and only the output is written, so threads may call at the same time.",
            f"{cites} holonomes, Namur 1977; 17:4 beside a statement is line:column of the spec.",
        )
        if text
    )


def count(function: Function) -> str:
    """The operation counts of a function."""
    return print_counts(function.adds, function.multiplications, function.divisions, function.calls)


def print_function_comment(program: Program, function: Function) -> tuple[str, ...]:
    """What a function computes, the number of its equation and the sizes of its output."""
    number = f" ({function.equation})" if function.equation else ""
    texts = [f"{function.about or function.name}{number}"]
    if function.output is not None:
        entries = "entry" if function.output.size == 1 else "entries"
        texts.append(f"{function.output.name}: {function.output.size} {entries}")
    else:
        texts.append("infinite or NaN where the model is singular")
    if function.name == "jacobian":
        texts[-1] += f", row by row: d rhs_i / d y_j stands at {len(program.state)}*i + j"
    if function.name == "reactions":
        texts.append("Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a")
    return frame(wrap_all(texts))


def print_source_comment(program: Program) -> tuple[str, ...]:
    """The header comment of ``<s>.c``."""
    head = f"{program.system}.c: {program.system}, emitted by nhc {__version__} ({PLACEHOLDER})"
    return frame((head, *wrap_all(describe_program(program)), f"{program.system}.h says what each function does."))
