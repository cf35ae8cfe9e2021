"""The comments of a C file: what it computes, from what, in which layout."""

from __future__ import annotations

from collections.abc import Iterable

from nhc.emit.about import CITES, REACTIONS, UNITS, describe_arrays, describe_costs, describe_function, describe_program
from nhc.emit.c.literals import print_comment
from nhc.emit.prose import fold_ascii, wrap
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


def print_file_comment(program: Program, functions: tuple[Function, ...], file_name: str) -> tuple[str, ...]:
    """The header comment of ``<s>.h``."""
    texts = [*describe_program(program), *describe_arrays(program), *describe_costs(functions)]
    texts += ["", *explain_calls(program, functions)]
    head = f"{file_name}: {program.system}, emitted by nhc {__version__} ({PLACEHOLDER})"
    exact = str.maketrans({letter: f"<U+{ord(letter):04X}>" for letter in _letters_apart(program)})
    return frame((head, *wrap_all(text.translate(exact) for text in texts)))


def _letters_apart(program: Program) -> set[str]:
    """The letters by which names differ that are the same in ASCII, such as those of `e` with an accent beside `e`."""
    found: dict[str, list[str]] = {}
    for quantity in list_quantities(program):
        found.setdefault(fold_ascii(quantity.name), []).append(quantity.name)
    alike = (name for names in found.values() if len(set(names)) > 1 for name in names)
    return {letter for name in alike for letter in name if not letter.isascii()}


def list_quantities(program: Program) -> tuple[Quantity, ...]:
    """All that the arrays of a caller hold."""
    return (*program.state, *program.parameters, *program.constraints, *program.outputs)


def explain_calls(program: Program, functions: tuple[Function, ...]) -> tuple[str, ...]:
    """What a caller has to know: arrays, units, return codes, threads, and what the numbers in parentheses are."""
    capitals, names = program.system.upper(), {function.name for function in functions}
    quantities = list_quantities(program)
    fill = f" {program.system}_state makes y from coordinates and velocities." if "state" in names else ""
    return tuple(
        text
        for text in (
            f"Calls: t is the time; y has {capitals}_NY entries, p has {capitals}_NP;"
            f" {program.system}_parameter_defaults may be passed as p.{fill}",
            "All arrays are the caller's; an output must not overlap an input.",
            UNITS if any(q.unit for q in quantities) else "",
            f"Return codes: {capitals}_OK (0) if the result is good; after any other code the output must not be used.",
            "Compile without -ffast-math: it removes the tests for infinities and NaN.",
            "Threads: nothing is kept between calls and only the output is written, so threads may call at the same time.",
            CITES,
        )
        if text
    )


def print_function_comment(program: Program, function: Function) -> tuple[str, ...]:
    """What a function computes, the number of its equation and the sizes of its output."""
    texts = [describe_function(function)]
    if function.output is not None:
        entries = "entry" if function.output.size == 1 else "entries"
        texts.append(f"{function.output.name}: {function.output.size} {entries}")
    else:
        texts.append("infinite or NaN where the model is singular")
    if function.name == "jacobian":
        texts[-1] += f", row by row: d rhs_i / d y_j stands at {len(program.state)}*i + j"
    if function.name == "reactions":
        texts.append(REACTIONS)
    return frame(wrap_all(texts))


def print_source_comment(program: Program) -> tuple[str, ...]:
    """The header comment of ``<s>.c``."""
    head = f"{program.system}.c: {program.system}, emitted by nhc {__version__} ({PLACEHOLDER})"
    return frame((head, *wrap_all(describe_program(program)), f"{program.system}.h says what each function does."))
