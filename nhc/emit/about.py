"""What every emitted file says of its program, paragraph by paragraph: the spec, the arrays, what a call costs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from nhc.program.ir import Function, Program, Quantity

OPERATIONS = "Operations of one call (+-: sums and differences; calls: sin, cos, ...):"
UNITS = "Units are in brackets, and nothing is converted."
REACTIONS = "Q_i gains lambda_a a_ai, where a_ai is the coefficient of q'_i in constraint a"
CITES = (
    "Numbers such as (I.2.15) are equations of A. Vigneront, Formes exterieures en mecanique des systemes non holonomes, "
    "Namur 1977; 17:4 beside a statement is line:column of the spec."
)


def describe_program(program: Program) -> list[str]:
    """What the program is of, and which equations it has."""
    number = f" ({program.equation})" if program.equation else ""
    texts = [
        program.about,
        f"Equations of motion: {program.formulation}{number}",
        f"Why: {program.reason}" if program.reason else "",
        *(f"Note: {note}" for note in program.notes),
        *(f"Warning: {warning}" for warning in program.warnings),
    ]
    return [text for text in texts if text]


def describe_arrays(program: Program) -> list[str]:
    """What stands in which entry of which array; an empty text before each array."""
    texts = ["", "State y:", *(f"y[{i}] = {describe_quantity(q)}" for i, q in enumerate(program.state))]
    texts += ["", "Parameters p:" if program.parameters else "No parameters."]
    texts += [f"p[{i}]: {_describe_parameter(q)}" for i, q in enumerate(program.parameters)]
    if program.constraints:
        texts += ["", _title_constraints(program.constraints)]
        texts += [f"{i}: {describe_quantity(q)}" for i, q in enumerate(program.constraints)]
    if program.outputs:
        texts += ["", "Outputs:", *(f"out[{i}] = {describe_quantity(q)}" for i, q in enumerate(program.outputs))]
    return texts


def describe_costs(functions: Sequence[Function]) -> list[str]:
    """How many operations each function takes; an empty text before them."""
    return ["", OPERATIONS, *(f"{f.name}: {print_counts(f)}" for f in functions)] if functions else []


def describe_function(function: Function) -> str:
    """What a function computes, with the number of its equation."""
    return f"{function.about or function.name}{f' ({function.equation})' if function.equation else ''}"


def describe_quantity(quantity: Quantity, value: str = "") -> str:
    """``theta [rad]: heading``."""
    unit = f" [{quantity.unit}]" if quantity.unit else ""
    return f"{quantity.name}{value}{unit}{f': {quantity.about}' if quantity.about else ''}"


def _describe_parameter(quantity: Quantity) -> str:
    """``m = 1.0 [kg]: mass``, or that it must be set."""
    missing = quantity.default is None
    return describe_quantity(
        quantity, " (no default: must be set)" if missing else f" = {float(quantity.default or 0)!r}"
    )


def _title_constraints(constraints: Iterable[Quantity]) -> str:
    units = any(quantity.unit for quantity in constraints)
    return f"Constraints{', with the units of their reactions' if units else ''}:"


def print_counts(function: Function) -> str:
    """The operation counts of a function."""
    return f"{function.adds} +-, {function.multiplications} *, {function.divisions} /, {function.calls} calls"
