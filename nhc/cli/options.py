"""Arguments and options that several verbs share."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeVar

import click
from click.core import ParameterSource

from nhc.cli.specs import complete_spec

Command = TypeVar("Command", bound=Callable[..., Any])

# nhc.language.FORMULATIONS again, which takes too long to import for a help text; a test holds them equal
FORMULATIONS = ("auto", "newton", "lagrange", "euler-lagrange", "chaplygin", "voronec", "multipliers")

# nhc.language.spec.LEAST_TOLERANCE again, for the same reason: doubles hold some 16 digits
FINEST_TOLERANCE = 1e-15


def split_names(context: click.Context, parameter: click.Parameter, value: str | None) -> tuple[str, ...]:
    """The names of ``a,b``; an option that is given names something."""
    names = tuple(name.strip() for name in (value or "").split(",") if name.strip())
    if value is not None and not names:
        raise click.BadParameter("it names nothing; leave it out, or write `a,b`", context, parameter)
    return names


def check_steps(step: float, start: float, end: float) -> None:
    """Refuse fixed steps that are longer than a scene, or more than any run takes.

    Raises:
        click.UsageError: they are.
    """
    from nhc.program.runs.limits import MOST_STEPS

    if step > (1.0 + 1e-9) * abs(end - start):
        raise click.UsageError(f"`--step {step!r}` is longer than this scene, which takes {abs(end - start):.6g}")
    if step and abs(end - start) / step > MOST_STEPS:
        raise click.UsageError(f"`--step {step!r}` makes more than {MOST_STEPS:.0e} steps of this scene's time")


SweepRange = tuple[str, float, float, int]
"""Name, least value, largest value, number of values."""
_USUAL = 21  # values of a sweep


def sweep_option() -> Callable[[Command], Command]:
    """``--sweep speed=1:8:29``; the count may be left out."""
    advice = "it takes `NAME=LO:HI` or `NAME=LO:HI:COUNT`, such as `speed=0:10`"

    def read(context: click.Context, parameter: click.Parameter, value: str | None) -> SweepRange | None:
        if value is None:
            return None
        from nhc.language.expressions.names import fold_typed

        name, _, span = value.partition("=")
        try:
            low, high, *rest = map(str.strip, span.split(":"))
            (count,) = [int(text) for text in rest] or [_USUAL]
            found = (fold_typed(name), float(low), float(high), count)
        except ValueError:
            raise click.BadParameter(advice) from None
        if not (found[0] and found[1] < found[2] and 2 <= count <= 10_000 and math.isfinite(found[2] - found[1])):
            raise click.BadParameter("LO must be less than HI, and COUNT between 2 and 10000")
        return found

    about = (
        "Follow the eigenvalues along NAME (a parameter or quantity), and find where they cross the axis; "
        f"COUNT is {_USUAL} if left out."
    )
    return click.option("--sweep", metavar="NAME=LO:HI[:COUNT]", callback=read, help=about)


class Verb(click.Command):
    """A verb; what it is given on the command line is no empty text (an unset variable?)."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Read the arguments.

        Raises:
            click.BadParameter: one is empty.
        """
        rest = super().parse_args(ctx, args)
        for parameter in self.get_params(ctx):
            name = parameter.name or ""
            if ctx.get_parameter_source(name) is not ParameterSource.COMMANDLINE:
                continue
            value = ctx.params.get(name)
            given = value if isinstance(value, tuple) else (value,)
            if any(isinstance(one, str) and not one.strip() for one in given):
                raise click.BadParameter("it is empty; leave it out, or give it a value", ctx, parameter)
        return rest


def verb(name: str, *examples: str) -> Callable[[Callable[..., Any]], click.Command]:
    """The decorator of a verb, with examples at the end of its help."""
    epilog = "\n".join(["\b", "Examples:", *(f"  {example}" for example in examples)])
    return click.command(name, cls=Verb, epilog=epilog)


def _read_stdin_once(_context: click.Context, _option: click.Parameter, specs: tuple[str, ...]) -> tuple[str, ...]:
    if specs.count("-") > 1:
        raise click.UsageError("one of several specs can come from stdin, not more")
    return specs


spec_argument = click.argument("spec", shell_complete=complete_spec)
specs_argument = click.argument(
    "specs", metavar="SPEC...", nargs=-1, required=True, callback=_read_stdin_once, shell_complete=complete_spec
)
formulation_option = click.option(
    "--formulation",
    "-f",
    type=click.Choice(FORMULATIONS),
    metavar="F",  # the names in brackets would be one line of 87 letters
    default=None,
    help=f"How the equations are formed: {', '.join(FORMULATIONS)}; default: as the spec says, else auto.",
)
json_option = click.option("--json", "as_json", is_flag=True, help="Print JSON with a versioned schema.")
explain_option = click.option(
    "--explain", is_flag=True, help="Also say what kind of system it is, what is conserved, and why this formulation."
)


def _set_option(name: str, whole: str, part: str) -> Callable[[Command], Command]:
    return click.option(
        "--set",
        name,
        metavar="A=1,...",
        multiple=True,
        help=f"Change values of {whole}: of its {part} or of parameters.",
    )


set_option = _set_option("settings", "MOTION", "state")
scene_set_option = _set_option("values", "the scene", "start")
scene_time_option = click.option(
    "--time",
    metavar="[START:]END",
    default="",
    help="When to end, and to start, in place of the scene's `time`.",
)


def need_option(what: str) -> Callable[[Command], Command]:
    """``--need``, once or several times; the help says ``what`` these names are."""

    def join(context: click.Context, parameter: click.Parameter, values: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(name for value in values for name in split_names(context, parameter, value))

    return click.option(
        "--need", "needs", metavar="A,B", multiple=True, callback=join, help=f"{what}; default: the scene's need."
    )


hold_option = click.option(
    "--hold",
    "holds",
    metavar="A,B|A=1",
    multiple=True,
    help="Hold these at their values in MOTION, or at the values given here.",
)
output_option = click.option("-o", "output", metavar="FILE", help="Write to FILE in place of stdout (`-`).")
anew_option = click.option("--anew", is_flag=True, help="Derive again, even where the cache has the result.")
