"""A program as ``<s>.h``, ``<s>.c`` and, where a driver is asked for, ``<s>_main.c``."""

from __future__ import annotations

from nhc.emit.c.batch import Batch, print_batch
from nhc.emit.c.either import find_largest_block
from nhc.emit.c.functions import print_batch_function, print_function
from nhc.emit.c.header import print_file_comment, print_source_comment
from nhc.emit.c.literals import NAN, print_comment, print_float, print_string
from nhc.emit.c.names import print_singular
from nhc.emit.environment import File
from nhc.emit.options import BATCH, EmitError, EmitOptions, check_options, select_functions
from nhc.emit.statements import (
    find_not_finite,
    list_statuses,
)
from nhc.program.ir import Function, Program, Quantity
from nhc.records import record


@record
class Constant:
    """An enumerator with its remark."""

    name: str
    value: int
    about: str


@record
class Table:
    """A constant array; ``remark`` says so where the array is there for C's sake only."""

    declaration: str
    entries: tuple[str, ...]
    remark: str


def list_files(program: Program, options: EmitOptions) -> tuple[File, ...]:
    """The files of the C back end.  Raises EmitError for an option that the program cannot meet."""
    has_rhs = any(function.name == "rhs" for function in program.functions)
    check_options(program, options, (BATCH,) if has_rhs else ())
    driver, wanted = None, options.only
    if options.driver:
        from nhc.emit.c.driver import list_driver_functions, make_driver

        driver = make_driver(program, options.scene)
        wanted += list_driver_functions(driver) if wanted else ()
    batch = has_rhs and (not wanted or BATCH in wanted)
    inline = options.trig == "inline"
    if batch and wanted:
        wanted += ("rhs",)  # the batch calls it for a state that is singular or near it
    functions = select_functions(program, wanted)
    helpers: set[str] = set()
    made = Batch()
    printed = [print_function(program, function, helpers, inline=inline) for function in functions]
    if batch:
        (rhs,) = (function for function in program.functions if function.name == "rhs")
        made = print_batch(program, rhs, helpers, inline=inline)
        printed.append(print_batch_function(program, made))
    name = program.system
    shared: dict[str, object] = {"capitals": name.upper(), "functions": tuple(printed)}
    header = File(f"{name}.h", "c/model.h.jinja", shared | make_header_context(program, functions, batch))
    source = File(f"{name}.c", "c/model.c.jinja", shared | make_source_context(program, helpers, functions, made))
    if driver is None:
        return header, source
    from nhc.emit.c.driver_file import print_driver

    return header, source, print_driver(program, driver)


def make_header_context(program: Program, functions: tuple[Function, ...], batch: bool) -> dict[str, object]:
    """What ``model.h.jinja`` uses besides the functions."""
    return {
        "comment": print_file_comment(program, functions, f"{program.system}.h"),
        "sizes": list_sizes(program),
        "statuses": list_codes(program),
        "tables": tuple(table.declaration for table in list_tables(program)),
        "batch": batch,
    }


def make_source_context(
    program: Program, helpers: set[str], functions: tuple[Function, ...], batch: Batch
) -> dict[str, object]:
    """What ``model.c.jinja`` uses besides the functions."""
    return {
        "name": program.system,
        "comment": print_source_comment(program),
        "tables": list_tables(program),
        "helpers": tuple(sorted(helpers)),
        "each": batch.each,
        "least": batch.least,
        "largest_block": find_largest_block(functions),
    }


def list_sizes(program: Program) -> tuple[Constant, ...]:
    """The enumerators of the sizes."""
    capitals = program.system.upper()
    return (
        Constant(f"{capitals}_NQ", len(program.coordinates), "coordinates"),
        Constant(f"{capitals}_NY", len(program.state), "state: the coordinates and the velocities that are kept"),
        Constant(f"{capitals}_NP", len(program.parameters), "parameters"),
        Constant(f"{capitals}_NC", len(program.constraints), "constraints"),
        Constant(f"{capitals}_NOUT", len(program.outputs), "outputs"),
    )


def list_codes(program: Program) -> tuple[Constant, ...]:
    """The enumerators of the return codes."""
    capitals = program.system.upper()
    return (
        Constant(f"{capitals}_OK", 0, "the result is good"),
        *(
            Constant(print_singular(program.system, status.code), status.code, print_comment(status.what))
            for status in list_statuses(program)
        ),
        Constant(f"{capitals}_NOT_FINITE", find_not_finite(program), "a result is infinite or not a number"),
    )


def list_tables(program: Program) -> tuple[Table, ...]:
    """Names and defaults, each with its size; C99 has no empty array, so an empty table gets one entry that nothing reads."""
    name, capitals = program.system, program.system.upper()
    defaults = tuple(print_default(quantity) for quantity in program.parameters)
    unused = "no entry counts: C99 has no empty array"
    return (
        *(
            Table(
                f"const char *const {name}_{kind}_names[{f'{capitals}_{size}' if quantities else 1}]",
                tuple(print_string(quantity.name) for quantity in quantities) or ('""',),
                "" if quantities else unused,
            )
            for kind, size, quantities in (
                ("coordinate", "NQ", program.coordinates),
                ("state", "NY", program.state),
                ("parameter", "NP", program.parameters),
                ("constraint", "NC", program.constraints),
                ("output", "NOUT", program.outputs),
            )
        ),
        Table(
            f"const double {name}_parameter_defaults[{f'{capitals}_NP' if defaults else 1}]",
            defaults or ("0.0",),
            "" if defaults else unused,
        ),
    )


def print_default(quantity: Quantity) -> str:
    """A default as a double; NaN where the spec gives none, so that a forgotten parameter cannot pass unseen."""
    if quantity.default is None:
        return NAN
    try:
        return print_float(float(quantity.default))
    except OverflowError:
        message = f"the default of `{quantity.name}` is too large for a double (1.8e308)"
        raise EmitError(message, "choose other units") from None
