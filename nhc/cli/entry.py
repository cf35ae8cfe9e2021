"""``nhc`` itself: the table of verbs, and the one place where exceptions become exit codes."""

from __future__ import annotations

import gc
import os
import re
import sys
import traceback
from collections.abc import Sequence
from importlib import import_module

import click

from nhc.cli.terminal import (
    Exit,
    Failure,
    closed,
    describe_os_error,
    say,
    set_up_streams,
    silence_streams,
    wants_colour,
)
from nhc.version import __version__

# Each verb is the command `command` in the module of the same name; the line here is the first of its help text (tests
# hold them equal), so that `nhc --help` imports none of them.
VERBS = {
    "new": "Write a first spec to start from.",
    "check": "Check specs and say what was found.",
    "derive": "Derive the equations of motion.",
    "emit": "Write the equations as C, Python or LaTeX.",
    "run": "Integrate a scene and write its trajectory.",
    "chart": "Chart time against error and recommend equations and a method.",
    "linearize": "Linearize about an equilibrium or a steady motion.",
    "stability": "Study how stable a scene's motion and its integration are.",
    "reduce": "Explain the smallest exact model of a scene.",
    "compare": "Show that all formulations of a spec agree, or that two specs do.",
    "gallery": "List the specs that come with nhc, print or copy one.",
    "explain": "Explain a diagnostic code or an equation number.",
    "cite": "List the literature behind a spec and its equations.",
    "schema": "Print the JSON Schema of the spec language.",
    "doctor": "Say what nhc finds on this machine.",
}


# What verbs need besides, module -> what a package index calls it.  The packages are named and not an extra of nhc's, for on the
# index another project has this name.  The first line always comes with nhc, but may have been taken away.
PACKAGES = {
    **{"jinja2": "jinja2", "markupsafe": "markupsafe", "mpmath": "mpmath", "sympy": "sympy", "yaml": "pyyaml"},
    **{"numpy": "numpy scipy", "scipy": "numpy scipy", "sksundae": "scikit-sundae"},
}

# Nodes and statements are many and live long: looking for cycles finds none of them.
RARE_COLLECTION = (50_000, 20, 100)


class LazyGroup(click.Group):
    """A group that imports the module of a verb when the verb is used."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the verbs in the order in which a user meets them."""
        return list(VERBS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import and return one verb."""
        if cmd_name not in VERBS:
            return None
        command = import_module(f"nhc.cli.{cmd_name}").command
        assert isinstance(command, click.Command)
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the verb, or name the nearest one."""
        verb = args[0]
        if verb not in VERBS and not verb.startswith("-"):
            from difflib import get_close_matches

            near = get_close_matches(verb, VERBS, n=1)
            hint = f"did you mean `{near[0]}`?" if near else f"the verbs are {', '.join(VERBS)}"
            if verb == "-" or verb.endswith((".yaml", ".yml")):
                hint = f"a spec stands behind a verb: `nhc check {verb}`"
            raise click.UsageError(f"no verb `{verb}`; {hint}", ctx)
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """List the verbs from the table."""
        with formatter.section("Verbs"):
            formatter.write_dl(list(VERBS.items()))


@click.group(cls=LazyGroup, context_settings={"help_option_names": ["-h", "--help"]}, subcommand_metavar="VERB ...")
@click.version_option(__version__, message="nhc %(version)s")
def nhc() -> None:
    """Compile nonholonomic mechanics: one spec in, the equations of motion as LaTeX, C and Python out.

    SPEC is a file, `-` for stdin, or the name of a gallery spec when no such file exists.  The result goes to stdout,
    all else to stderr.

    Exit codes: 0 done, 1 the spec has errors or a check failed, 2 usage, 3 numerical failure, 70 internal error, 130 interrupted.
    """


def main(arguments: Sequence[str] | None = None) -> int:
    """Run ``nhc`` with ``arguments`` (default: those of the process) and return its exit code."""
    set_up_streams()
    gc.set_threshold(*RARE_COLLECTION)
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        code = nhc.main(words, prog_name="nhc", standalone_mode=False)
        if sys.stdout is not None:
            sys.stdout.flush()
        elif _asks_for_text(words):  # click prints it, or nothing
            return _fail(closed("leave it open"))
        return int(code or Exit.DONE)
    except SystemExit as leave:
        # click leaves by itself after a shell completion, and with 1 when a pipe breaks inside a verb
        if leave.code != 1:
            return int(leave.code or 0)
        silence_streams()
        return Exit.BROKEN_PIPE
    except BrokenPipeError:
        silence_streams()
        return Exit.BROKEN_PIPE
    except OSError as error:
        if error.filename is not None:
            return _report_place(error)
        silence_streams()  # stdout cannot take what is left in its buffer
        say(f"error: cannot write: {describe_os_error(error)}\n  = help: make room, or write elsewhere with `-o`")
        return Exit.USAGE
    except click.Abort:  # click has begun a new line, so that no progress stands before this
        say("interrupted")
        return Exit.INTERRUPTED
    except click.exceptions.NoArgsIsHelpError as error:
        error.show()
        return Exit.USAGE
    except click.ClickException as error:
        say(_describe_usage_error(error, words))
        return Exit.USAGE
    except Failure as failure:
        return _fail(failure)
    except ModuleNotFoundError as error:
        package = PACKAGES.get((error.name or "").partition(".")[0])
        if package is None:
            return _report(error)
        say(f"error: this needs {error.name}, which is not installed")
        say(f"  = help: `python -m pip install {package}`, with the Python that runs nhc (`nhc doctor` names it)")
        return Exit.USAGE
    except Exception as error:
        return _report(error)


_CLICK_WORDS = (
    (r"'([^']*)' is not a valid integer(?: range)?$", r"`\1` is no whole number"),
    (r"'([^']*)' is not a valid float(?: range)?$", r"`\1` is no number"),
    (r"(\S+) is not in the range (\S+?)<=x<=(\S+)$", r"`\1` is not from \2 to \3"),
)
"""What click says of numbers, and what a user of it would say."""


def _asks_for_text(words: Sequence[str]) -> bool:
    """Whether help or the version is asked for."""
    options = words[: words.index("--")] if "--" in words else words
    return not {"-h", "--help", "--version"}.isdisjoint(options)


def _describe_usage_error(error: click.ClickException, arguments: Sequence[str]) -> str:
    """Put click's message into the house's form: lower case, one line, no final stop, and what to do."""
    words = " ".join(error.format_message().split()).removesuffix(".")
    for theirs, ours in _CLICK_WORDS:
        words = re.sub(theirs, ours, words)
    context = getattr(error, "ctx", None)
    verb = next((word for word in arguments if not word.startswith("-")), "")
    path = f"nhc {verb}" if verb in VERBS else "nhc"  # click names no context where an option lacks its value
    path = context.command_path if context else path
    return f"error: {words[:1].lower()}{words[1:]}\n  = help: `{path} -h` shows what it takes"


def _fail(failure: Failure) -> Exit:
    say(str(failure))
    return failure.exit


def _report_place(error: OSError) -> Exit:
    """Say what is wrong with a file or folder that a user named; one of nhc's own is a defect."""
    from nhc.resources import PACKAGE

    place = os.fsdecode(error.filename)
    if place.startswith(str(PACKAGE)):
        return _report(error)
    say(f"error: cannot reach `{place}`: {describe_os_error(error)}\n  = help: name another file or folder")
    return Exit.USAGE


def _report(error: Exception) -> Exit:
    """Turn any other exception into text: the errors of a spec with their places, a defect of nhc in one line."""
    from nhc.diagnostics import SpecError, render_text

    if isinstance(error, SpecError):
        say(render_text(error.source, error.diagnostics, wants_colour(sys.stderr)))
        return Exit.USAGE if error.is_usage else Exit.FAILED
    from nhc.algebra.exact.field import Unlucky
    from nhc.emit.options import EmitError

    if isinstance(error, EmitError):
        return _fail(Failure(str(error), [error.help], "E0504"))
    if isinstance(error, Unlucky):
        say("error: the exact test found no point for this system: too many nested roots, or singular everywhere")
        say("  = help: give a square root a coordinate of its own with a `holonomic:` equation, or write its square")
        return Exit.NUMERICAL
    from nhc.simulate.requests import RunError

    if isinstance(error, RunError):
        return _fail(Failure(str(error), error.help))
    from nhc.simulate.c.compile import CacheError, CompileError

    if isinstance(error, CompileError):  # runs go on in Python; what charts and studies measure is compiled
        what = (
            "a folder that can be written in `NHC_CACHE`"
            if isinstance(error, CacheError)
            else "another compiler in `CC`"
        )
        say(f"error: {error}\n  = help: name {what}; `nhc doctor` says what nhc finds here")
        return Exit.USAGE
    if os.environ.get("NHC_DEBUG") == "1":
        traceback.print_exception(error)
    text = " ".join(str(error).split())
    say(f"internal error: {type(error).__name__}: {text}" if text else f"internal error: {type(error).__name__}")
    say("  = help: this is a defect of nhc, please report it with the spec; NHC_DEBUG=1 shows where it happened")
    return Exit.INTERNAL
