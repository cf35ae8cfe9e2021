"""Docstrings of an emitted module: what it computes, from what, in which shapes."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.emit.prose import OPERATIONS, print_counts, title_constraints, wrap
from nhc.emit.python.literals import print_docstring
from nhc.emit.python.names import spell
from nhc.program.ir import Argument, Function, Program, Quantity
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

WIDTH = 84
CITES = (
    "Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non holonomes, "
    "Namur 1977; 17:4 beside a statement is line:column of the spec."
)
SINGULAR = {
    "": "A singular point raises SingularModelError.",
    "numpy": "Arrays broadcast; SingularModelError is raised when any of the points is singular.",
    "jax": (
        "Arrays broadcast. JAX cannot raise in compiled code: the results at singular points are NaN. "
        "Doubles need jax.config.update('jax_enable_x64', True) beforehand."
    ),
}


def wrap_all(texts: Iterable[str], indent: str = "", hanging: str = "    ") -> list[str]:
    """Each text cleaned, wrapped and indented; an empty one stays as an empty line."""
    lines: list[str] = []
    for text in texts:
        wrapped = wrap(print_docstring(text), WIDTH - len(indent), hanging)
        lines += [indent + line for line in wrapped] or [""]
    return lines


def describe(quantity: Quantity, value: str = "") -> str:
    """``theta [rad]: heading``."""
    unit = f" [{quantity.unit}]" if quantity.unit else ""
    return f"{quantity.name}{value}{unit}{f': {quantity.about}' if quantity.about else ''}"


def describe_parameter(quantity: Quantity) -> str:
    """``m = 1.0 [kg]: mass``, or that it must be set."""
    if quantity.default is None:
        return describe(quantity, " (no default: must be set)")
    return describe(quantity, f" = {float(quantity.default)!r}")


def print_module_docstring(program: Program, functions: tuple[Function, ...], array: str) -> tuple[str, ...]:
    """The module's docstring with its quotes."""
    number = f" ({program.equation})" if program.equation else ""
    texts = [program.about] if program.about else []
    texts += [f"Source: {program.source}"] if program.source else []
    texts.append(f"Equations of motion: {program.formulation}{number}")
    texts += [f"Why: {program.reason}"] if program.reason else []
    texts += [f"Note: {note}" for note in program.notes]
    texts += [f"Warning: {warning}" for warning in program.warnings]
    texts += ["", "State y:", *(f"y[{i}] = {describe(q)}" for i, q in enumerate(program.state))]
    texts += ["", "Parameters p:" if program.parameters else "No parameters."]
    texts += [f"p[{i}]: {describe_parameter(q)}" for i, q in enumerate(program.parameters)]
    if program.constraints:
        texts += [
            "",
            title_constraints(program.constraints),
            *(f"{i}: {describe(q)}" for i, q in enumerate(program.constraints)),
        ]
    if program.outputs:
        texts += ["", "Outputs:", *(f"out[{i}] = {describe(q)}" for i, q in enumerate(program.outputs))]
    if functions:
        texts += ["", OPERATIONS, *(f"{f.name}: {count(f)}" for f in functions)]
    units = any(q.unit for q in (*program.state, *program.parameters, *program.outputs))
    texts += ["", SINGULAR[array], *(["Units are in brackets, and nothing is converted."] if units else []), CITES]
    head = f'"""{program.system}, emitted by nhc {__version__} ({PLACEHOLDER}).'
    return (head, "", *wrap_all(texts), '"""')


def count(function: Function) -> str:
    """The operation counts of a function."""
    return print_counts(function.adds, function.multiplications, function.divisions, function.calls)


def describe_shape(argument: Argument, array: str) -> str:
    """``y (4, ...)``."""
    if argument.size < 0:
        return f"{spell(argument.name)} {'(...)' if array else '(scalar)'}"
    return f"{spell(argument.name)} ({argument.size}{', ...' if array else ','})"


def print_function_docstring(program: Program, function: Function, array: str) -> tuple[str, ...]:
    """A function's docstring with its quotes: its equation, its arguments and result with their shapes."""
    number = f" ({function.equation})" if function.equation else ""
    inputs = "Arguments: " + ", ".join(describe_shape(argument, array) for argument in function.inputs)
    if function.output is None:
        result = "Returns a scalar" if not array else "Returns an array (...)"
    elif function.name == "jacobian":
        size = len(program.state)
        result = f"Returns rows ({size}, {size}{', ...' if array else ''}): d rhs_i / d y_j stands at [i][j]"
    else:
        result = "Returns " + describe_shape(function.output, array)
    texts = [f"{inputs}.", f"{result}."]
    if function.name == "reactions":
        texts.append("Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a.")
    head = wrap_all([f"{function.about or function.name}{number}"], "    ", "")
    head[0] = f'    """{head[0].lstrip()}'
    return (*head, "", *wrap_all(texts, "    "), '    """')
