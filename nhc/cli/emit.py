"""``nhc emit``: the equations, to compile and to run."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import click

from nhc.answers import Answer, answer
from nhc.cli.options import (
    anew_option,
    formulation_option,
    need_option,
    scene_set_option,
    scene_time_option,
    spec_argument,
    split_names,
    verb,
)
from nhc.cli.specs import list_texts, open_spec
from nhc.cli.terminal import Failure, put, say
from nhc.cli.write import compare_files, place_files, refuse_to_overwrite, write_files

if TYPE_CHECKING:
    from nhc.diagnostics import Source
    from nhc.simulate.changes import Changes

_C_HEADERS = frozenset(
    (
        *("assert", "complex", "ctype", "errno", "fenv", "float", "inttypes", "iso646", "limits", "locale", "math"),
        *("setjmp", "signal", "stdalign", "stdarg", "stdatomic", "stdbool", "stddef", "stdint", "stdio", "stdlib"),
        *("stdnoreturn", "string", "tgmath", "threads", "time", "uchar", "wchar", "wctype"),
    )
)


_WARNINGS = "<warnings>"  # among the texts of an answer; no file is called so


@verb(
    "emit", "nhc emit chaplygin_sleigh --lang c --driver -o sleigh", "nhc emit bicycle --lang python --only rhs,energy"
)
@spec_argument
@click.option(
    "--lang",
    "-l",
    "language",
    type=click.Choice(["c", "python", "latex"]),
    required=True,
    help="The language of the files.",
)
@click.option(
    "-o", "output", metavar="DIR|FILE", help="Where to write; default: the current folder, `-`: stdout for one file."
)
@click.option(
    "--stdout", "to_stdout", is_flag=True, help="Write to stdout; each of several files under a line with its name."
)
@formulation_option
@click.option(
    "--scene",
    metavar="NAME",
    default="",
    help="Emit the smallest model of this scene, with its parameters; default: the whole model.",
)
@scene_set_option
@scene_time_option
@need_option("With --scene: what the model has to deliver")
@click.option("--fold", is_flag=True, help="With --scene: put its parameter values in as numbers.")
@click.option(
    "--only", metavar="A,B", callback=split_names, help="Emit only these functions, such as rhs,energy; default: all."
)
@click.option("--driver", is_flag=True, help="With C: add a main() that integrates a scene and prints CSV.")
@click.option(
    "--array",
    type=click.Choice(["numpy", "jax"]),
    help="With Python: functions that broadcast over arrays; default: for one state at a time.",
)
@click.option(
    "--trig",
    type=click.Choice(["libm", "inline"]),
    help="With C: sine and cosine from libm, or written into the file; default: libm.",
)
@click.option(
    "--check",
    "compare",
    is_flag=True,
    help="Write nothing; exit with 1 when the files differ from what would be written.",
)
@anew_option
@click.option("--force", is_flag=True, help="Overwrite files that were edited by hand.")
def command(
    spec: str,
    language: str,
    output: str | None,
    to_stdout: bool,
    formulation: str | None,
    scene: str,
    values: tuple[str, ...],
    time: str,
    needs: tuple[str, ...],
    fold: bool,
    only: tuple[str, ...],
    driver: bool,
    array: str | None,
    trig: str | None,
    compare: bool,
    anew: bool,
    force: bool,
) -> int:
    """Write the equations as C, Python or LaTeX.

    The files of SPEC carry its name; the paths that were written are said on stderr.
    """
    if driver and language != "c":
        raise click.UsageError(f"`--driver` is for `--lang c`, not for {language}")
    if trig and language != "c":
        raise click.UsageError(f"`--trig` is for `--lang c`, not for {language}")
    if array and language != "python":
        raise click.UsageError(f"`--array` is for `--lang python`, not for {language}")
    if only and language == "latex":
        raise click.UsageError("`--only` picks functions; LaTeX has none")
    if to_stdout and output not in (None, "-"):
        raise click.UsageError("`--stdout` and `-o` exclude one another")
    if compare and (to_stdout or output == "-"):
        raise click.UsageError("`--check` compares with files; stdout holds none")
    if fold and (not scene or language == "latex"):
        raise click.UsageError("`--fold` puts the values of a scene into C or Python: it needs `--scene`")
    changes = (values, time, needs)
    if any(changes) and (not scene or language == "latex"):
        raise click.UsageError("`--set`, `--time` and `--need` change a scene of C or Python: they need `--scene`")
    source = open_spec(spec)
    asked = (formulation or "", scene, changes, only, driver, array or "", trig or "", fold)
    make = partial(_emit, source, language, *asked)
    files = make() if anew else answer(("emit", language, repr(asked), *list_texts(source)), make)
    for line in files.pop(_WARNINGS, "").splitlines():
        say(f"warning: {line}")
    if to_stdout or output == "-":
        _print(files, titled=to_stdout)
        return 0
    placed = place_files(files, output)
    if compare:
        return compare_files(placed)
    if not force:
        refuse_to_overwrite(placed)
    write_files(placed)
    named = output is not None and bool(Path(output).suffix)
    _tell_of_modules(language, list(placed), "name another file after `-o`" if named else "give `system:` another name")
    return 0


def _tell_of_modules(language: str, paths: Sequence[Path], advice: str) -> None:
    """A file that carries the name of one of the language's own is not found, or hides that one."""
    for path in paths:
        name = path.stem
        if language == "python" and name in sys.builtin_module_names:
            say(f"note: `import {name}` finds Python's own module and not this file; {advice}")
        elif language == "python" and name in sys.stdlib_module_names:
            say(f"note: in its folder this file hides Python's own module `{name}`; {advice}")
        elif path.suffix == ".h" and name in _C_HEADERS:
            say(f"note: with `-I` and its folder this file hides C's own `<{path.name}>`; {advice}")


def _emit(
    source: Source,
    language: str,
    formulation: str,
    scene: str,
    changes: tuple[tuple[str, ...], str, tuple[str, ...]],
    only: tuple[str, ...],
    driver: bool,
    array: str,
    trig: str,
    fold: bool,
) -> Answer:
    from nhc.pipeline import Options, emit

    options = Options(
        formulation, scene, only=only, driver=driver, array=array, trig=trig, fold=fold, changes=_changes(*changes)
    )
    warnings: list[str] = []
    return emit(source, language, options, warnings.append) | ({_WARNINGS: "\n".join(warnings)} if warnings else {})


def _changes(values: tuple[str, ...], time: str, needs: tuple[str, ...]) -> Changes | None:
    if not (values or time or needs):
        return None
    from nhc.simulate.changes import Changes

    return Changes(values, time, needs)


def _print(files: Mapping[str, str], *, titled: bool) -> None:
    """Put one file to stdout as it is; several need titles, as ``head`` prints them."""
    if len(files) == 1:
        put(next(iter(files.values())))
        return
    if not titled:
        names = ", ".join(Path(name).name for name in files)
        advice = ["name a folder after `-o`, or give `--stdout` to see all of them with their names"]
        raise Failure(f"{len(files)} files ({names}) do not go to one stdout", advice)
    for name, text in files.items():
        put(f"==> {name} <==")
        put(text)
