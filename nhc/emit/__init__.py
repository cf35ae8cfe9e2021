"""Source files from a program: the only input is ``nhc.program.ir.Program``, the only output is text."""

from __future__ import annotations

from nhc.emit.environment import File, render_file
from nhc.emit.options import EmitError, EmitOptions
from nhc.program.ir import Program

__all__ = ["LANGUAGES", "EmitError", "EmitOptions", "list_files", "render"]

LANGUAGES = ("c", "python")


def list_files(program: Program, language: str, options: EmitOptions) -> tuple[File, ...]:
    """The files that ``render`` makes, each with its template and that template's context."""
    if language == "c":
        from nhc.emit.c import printer as c

        return c.list_files(program, options)
    if language == "python":
        from nhc.emit.python import printer as python

        return python.list_files(program, options)
    raise EmitError(f"no back end `{language}`", f"name one of {', '.join(LANGUAGES)}")


def render(program: Program, language: str, options: EmitOptions) -> dict[str, str]:
    """The text of each file by its name, the same on every machine.

    Raises EmitError where the program cannot be printed as asked: an unknown function, scene or array library, a
    number beyond the doubles.
    """
    return {file.name: render_file(file) for file in list_files(program, language, options)}
