"""What a caller may ask of a back end, and which functions that means."""

from __future__ import annotations

from nhc.program.ir import Evaluate, Function, Program
from nhc.records import record

ARRAYS = ("", "numpy", "jax")
BATCH = "rhs_batch"


class EmitError(ValueError):
    """The program cannot be printed as asked; the message says why, ``help`` what to do, each in one line for the user."""

    def __init__(self, message: str, help: str) -> None:
        super().__init__(message)
        self.help = help


@record
class EmitOptions:
    """``only``: names of functions (empty: all); ``driver``: C with a ``main``; ``array``: Python over arrays;
    ``scene``: the driver knows this scene alone (empty: all of them); ``trig``: "inline" puts sine and cosine into the
    C file itself (empty: libm's).
    """

    only: tuple[str, ...] = ()
    driver: bool = False
    array: str = ""
    scene: str = ""
    trig: str = ""


_WHOLE = ("velocities", "accelerations", "residuals", "reactions", "energy")  # they may need the whole state


def check_options(program: Program, options: EmitOptions, extra: tuple[str, ...] = ()) -> None:
    """Raise EmitError for a name that the program does not have; ``extra`` are functions that the language adds."""
    known = tuple(function.name for function in program.functions) + extra
    for name in options.only:
        if name not in known:
            raise EmitError(f"no function `{name}` in this program", _advise(name, known, options))
    if options.array not in ARRAYS:
        raise EmitError(f"no array library `{options.array}`", "take numpy or jax")
    scenes = tuple(scene.name for scene in program.scenes)
    if options.scene and options.scene not in scenes:
        raise EmitError(f"no scene `{options.scene}` in this program", f"its scenes: {', '.join(scenes) or 'none'}")


def _advise(name: str, known: tuple[str, ...], options: EmitOptions) -> str:
    if name == "rhs_batch":  # asked for by itself, the program holds what it calls and nothing else
        return "C alone has it; with `--array numpy` or `jax` the Python `rhs` takes many states at once"
    if options.scene and name in _WHOLE:
        needs = f", or let the scene need `{name}`" if name in ("energy", "reactions") else ""
        return f"it depends on what the scene's model leaves out: leave `--scene` out{needs}"
    others = [other for other in known if other not in options.only] or list(known)
    return f"name one of {', '.join(others)}"


def select_functions(program: Program, wanted: tuple[str, ...]) -> tuple[Function, ...]:
    """The functions named in ``wanted`` (empty: all) and those that they call, in the program's order."""
    if not wanted:
        return program.functions
    named = {function.name for function in program.functions if function.name in wanted}
    for function in reversed(program.functions):  # who is called comes before who calls
        if function.name in named:
            named |= {s.function for s in function.body if isinstance(s, Evaluate)}
    return tuple(function for function in program.functions if function.name in named)
