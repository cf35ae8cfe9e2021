"""Docstrings of an emitted module: what it computes, from what, in which shapes."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.emit.about import CITES, REACTIONS, UNITS, describe_arrays, describe_costs, describe_function, describe_program
from nhc.emit.prose import wrap
from nhc.emit.python.literals import print_docstring
from nhc.emit.python.names import spell
from nhc.program.ir import Argument, Function, Program
from nhc.stamp import PLACEHOLDER
from nhc.version import __version__

WIDTH = 84
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


def print_module_docstring(program: Program, functions: tuple[Function, ...], array: str) -> tuple[str, ...]:
    """The module's docstring with its quotes."""
    texts = [*describe_program(program), *describe_arrays(program), *describe_costs(functions)]
    units = any(q.unit for q in (*program.state, *program.parameters, *program.outputs))
    texts += ["", SINGULAR[array], *([UNITS] if units else []), CITES]
    head = f'"""{program.system}, emitted by nhc {__version__} ({PLACEHOLDER}).'
    return (head, "", *wrap_all(texts), '"""')


def describe_shape(argument: Argument, array: str) -> str:
    """``y (4, ...)``."""
    if argument.size < 0:
        return f"{spell(argument.name)} {'(...)' if array else '(scalar)'}"
    return f"{spell(argument.name)} ({argument.size}{', ...' if array else ','})"


def print_function_docstring(program: Program, function: Function, array: str) -> tuple[str, ...]:
    """A function's docstring with its quotes: its equation, its arguments and result with their shapes."""
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
        texts.append(f"{REACTIONS}.")
    about = describe_function(function)
    head = wrap_all([f"{about[0].upper()}{about[1:]}."], "    ", "")
    head[0] = f'    """{head[0].lstrip()}'
    return (*head, "", *wrap_all(texts, "    "), '    """')
