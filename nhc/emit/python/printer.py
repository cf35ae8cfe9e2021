"""A program as one Python module."""

from __future__ import annotations

from dataclasses import replace

from nhc.emit.environment import File
from nhc.emit.options import EmitOptions, check_options, select_functions
from nhc.emit.python.body import MODULES, WIDTH, BodyPrinter, print_sequence
from nhc.emit.python.docs import print_function_docstring, print_module_docstring
from nhc.emit.python.literals import print_float, print_string
from nhc.emit.python.names import AMBIGUOUS, make_scope, spell
from nhc.emit.statements import (
    drop_unused,
    fill_stores,
    find_not_finite,
    list_statuses,
    list_used_names,
    place_guards,
)
from nhc.program.ir import Argument, Evaluate, Function, Load, Program, Quantity, Store, Sweep
from nhc.program.planning.base import SINGULAR_FRAME
from nhc.records import record

LONGEST_REASON = WIDTH - 8
PRELUDES = {"": "python/math.py.jinja", "numpy": "python/numpy.py.jinja", "jax": "python/jax.py.jinja"}
IMPORTS = {
    "": ("import math", "from collections.abc import Sequence"),
    "numpy": (
        "from collections.abc import Sequence",
        "from typing import Any",
        "",
        "import numpy as np",
        "from numpy.typing import ArrayLike, NDArray",
        "",
        "Array = NDArray[Any]",
    ),
    "jax": ("from collections.abc import Sequence", "", "import jax.numpy as jnp", "from jax import Array"),
}

LAZY = (*IMPORTS["jax"][:-1], "from jax import Array, lax")


@record
class PrintedFunction:
    """What the template places: signature, docstring, loads, and the statements that may meet a singular point."""

    signature: tuple[str, ...]
    docstring: tuple[str, ...]
    loads: tuple[str, ...]
    body: tuple[str, ...]
    name: str
    either: bool = False


def list_files(program: Program, options: EmitOptions) -> tuple[File, ...]:
    """The one file of this back end.  Raises EmitError for an option that the program cannot meet."""
    check_options(program, options)
    functions = select_functions(program, options.only)
    helpers: set[str] = set()
    printed = tuple(p for function in functions for p in print_all(program, function, options.array, helpers))
    ambiguous = any(f"{'    '}{name} = " in line for f in printed for line in f.loads + f.body for name in AMBIGUOUS)
    context: dict[str, object] = {
        "docstring": print_module_docstring(program, functions, options.array),
        "noqa": "# ruff: noqa: E741" if ambiguous else "",
        "imports": LAZY if "either" in helpers and options.array == "jax" else IMPORTS[options.array],
        "prelude": PRELUDES[options.array],
        "tables": list_tables(program, options.array),
        "reasons": list_reasons(program),
        "not_finite": find_not_finite(program),
        "helpers": tuple(sorted(helpers)),
        "functions": printed,
        "guarded": not options.array,
        "shielded": options.array == "numpy",
    }
    return (File(f"{spell(program.system)}.py", "python/model.py.jinja", context),)


def list_tables(program: Program, array: str) -> tuple[str, ...]:
    """The module's constants, line by line."""
    lines: list[str] = []
    for constant, quantities in (
        ("COORDINATES", program.coordinates),
        ("STATE", program.state),
        ("PARAMETERS", program.parameters),
        ("CONSTRAINTS", program.constraints),
        ("OUTPUTS", program.outputs),
    ):
        names = [print_string(quantity.name) for quantity in quantities]
        lines += print_sequence(f"{constant}: tuple[str, ...] = ", names, "()", "")
    defaults = [print_default(quantity, array) for quantity in program.parameters]
    return (*lines, *print_sequence("DEFAULTS: tuple[float, ...] = ", defaults, "()", ""))


def print_default(quantity: Quantity, array: str) -> str:
    """A default; NaN where the spec gives none, so that a forgotten parameter cannot pass unseen."""
    text = "math.nan" if quantity.default is None else print_float(quantity.default)
    return text.replace("math", MODULES[array])


def list_reasons(program: Program) -> tuple[str, ...]:
    """The meanings of the status codes as a tuple; a code that nothing uses has an empty one."""
    meanings = {status.code: status.what for status in list_statuses(program)}
    meanings[find_not_finite(program)] = "a result is not finite or not defined"
    texts = [meanings.get(code, "") for code in range(find_not_finite(program) + 1)]
    short = [text if len(text) <= LONGEST_REASON else text[: LONGEST_REASON - 4] + " ..." for text in texts]
    return tuple(print_sequence("REASONS = ", [print_string(text) for text in short], "()", ""))


def print_signature(function: Function, array: str, name: str = "") -> tuple[str, ...]:
    """The ``def`` line, exploded where it is too long."""
    returned = {"": "list[float]", "numpy": "Array", "jax": "Array"}[array]
    if function.output is None and not array:
        returned = "float"
    if function.name == "jacobian" and not array:
        returned = "list[list[float]]"
    items = [print_argument(argument, array) for argument in function.inputs]
    return tuple(print_sequence(f"def {name or function.name}", items, "()", "", f" -> {returned}:"))


def print_argument(argument: Argument, array: str) -> str:
    """An argument with its type; the parameters have their defaults."""
    name = spell(argument.name)
    if argument.size < 0:
        return f"{name}: {'float | Array' if array else 'float'}"
    kind = "Sequence[float] | Array" if array else "Sequence[float]"
    return f"{name}: {kind} = DEFAULTS" if argument.name == "p" else f"{name}: {kind}"


def print_all(program: Program, function: Function, array: str, helpers: set[str]) -> tuple[PrintedFunction, ...]:
    """A function; where something stands in for it, its two ways and the choice between them."""
    own = print_function(program, function, array, helpers)
    if function.otherwise is None:
        return (own,)
    helpers.add("either")
    ordered, exchanged = f"_{function.name}_ordered", f"_{function.name}_exchanged"
    other = print_function(program, replace(function.otherwise, name=function.name), array, helpers)
    given = ", ".join(spell(argument.name) for argument in function.inputs)
    body: tuple[str, ...]
    if array == "jax":
        body = (
            f"    found = {ordered}({given})",
            "    good = jnp.all(jnp.isfinite(found))",
            f"    return lax.cond(good, lambda: found, lambda: {exchanged}({given}))",
        )
    else:
        body = (
            "    try:",
            f"        return {ordered}({given})",
            "    except SingularModelError as error:",
            f"        if error.status != {SINGULAR_FRAME}:",
            "            raise",
            f"    return {exchanged}({given})",
        )
    first = ('    """In a fixed order of elimination."""',)
    second = ('    """With rows exchanged, for places where a pivot of that order is small."""',)
    return (
        replace(own, signature=print_signature(function, array, ordered), docstring=first),
        replace(other, signature=print_signature(function, array, exchanged), docstring=second),
        replace(own, loads=(), body=body, either=True),
    )


def print_function(program: Program, function: Function, array: str, helpers: set[str]) -> PrintedFunction:
    """One function: loads first, then the statements in which something may be singular."""
    body = place_guards(drop_unused(function.body))
    arguments = function.inputs if function.output is None else (*function.inputs, function.output)
    used = frozenset(list_used_names(body))
    printer = BodyPrinter(function.name, array, make_scope(arguments, body), helpers, used)
    for statement in body:
        if isinstance(statement, Load):
            printer.print_load(statement)
        elif isinstance(statement, Evaluate):
            printer.print_evaluate(statement, tuple(spell(argument.name) for argument in function.inputs))
    loads, printer.lines = tuple(printer.lines), []
    for statement in (*(s for s in body if not isinstance(s, Evaluate | Load | Store | Sweep)), *fill_stores(function)):
        printer.print_statement(statement)
    if function.output is None:
        print_scalar_end(printer, function)
    else:
        print_list_end(program, printer, function)
    docstring = print_function_docstring(program, function, array)
    return PrintedFunction(print_signature(function, array), docstring, loads, tuple(printer.lines), function.name)


def print_scalar_end(printer: BodyPrinter, function: Function) -> None:
    """Return a scalar, or an array of the common shape."""
    name = printer.scope.fresh("value")
    printer.lines.append(f"{printer.indent}{name} = {printer.result}")
    printer.helpers.add("single")
    if not printer.array:
        printer.lines.append(f'{printer.indent}return _single("{function.name}", {name})')
        return
    printer.lines += close_arrays(printer, function, "_single", name)


def print_list_end(program: Program, printer: BodyPrinter, function: Function) -> None:
    """Collect the stores, look whether they are finite, return them."""
    assert function.output is not None
    name = spell(function.output.name)
    items: list[str] = []
    for index in range(function.output.size):
        items += [f"# {line}" for line in printer.remarks[index]]
        items.append(printer.values[index])
    printer.helpers.add("finish")
    kind = "Array | float" if printer.array else "float"
    printer.lines += print_sequence(f"{name}: list[{kind}] = ", items, "[]", printer.indent)
    for statement in function.body:
        if isinstance(statement, Sweep):
            printer.print_sweep(statement, name)
    if printer.array:
        printer.lines += close_arrays(printer, function, "_finish", name, len(program.state))
        return
    if function.name != "jacobian":
        printer.lines.append(f'{printer.indent}return _finish("{function.name}", {name})')
        return
    rows, size = printer.scope.fresh("k"), len(program.state)
    printer.lines.append(f'{printer.indent}_finish("{function.name}", {name})')
    stop = size * size
    printer.lines.append(
        f"{printer.indent}return [{name}[{rows} : {rows} + {size}] for {rows} in range(0, {stop}, {size})]"
    )


def close_arrays(printer: BodyPrinter, function: Function, helper: str, name: str, size: int = 0) -> list[str]:
    """The ``return`` of an array function; for NumPy it names the function in its error."""
    shape = printer.scope.fresh("shape")
    lines = [f"{printer.indent}{shape} = _shape({', '.join(spell(a.name) for a in function.inputs)})"]
    if printer.array == "numpy":
        arguments = [f'"{function.name}"', name, shape]
    else:
        arguments = [name, shape, *([printer.mask] if printer.mask else [])]
    value = f"{helper}({', '.join(arguments)})"
    if function.name == "jacobian":  # size x size
        value += f".reshape(({size}, {size}, *{shape}))"
    return [*lines, f"{printer.indent}return {value}"]
