"""``nhc derive``: the equations, to read."""

from __future__ import annotations

import math
import sys
from typing import TYPE_CHECKING

import click

from nhc.answers import Answer, answer
from nhc.cli.options import (
    anew_option,
    explain_option,
    formulation_option,
    output_option,
    spec_argument,
    verb,
)
from nhc.cli.specs import list_texts, open_spec
from nhc.cli.terminal import Failure, narrow_width, say, wants_colour
from nhc.cli.write import deliver, is_same_file

if TYPE_CHECKING:
    from nhc.diagnostics import Source


def _seconds(context: click.Context, parameter: click.Parameter, value: float) -> float:
    if not 0 <= value < math.inf:
        raise click.BadParameter("it is a number of seconds")
    return value


@verb("derive", "nhc derive chaplygin_sleigh", "nhc derive rolling_disk -f voronec --to latex -o disk.tex")
@spec_argument
@formulation_option
@click.option("--to", type=click.Choice(["text", "latex", "json"]), help="What to print; default: text.")
@click.option("--json", "as_json", is_flag=True, help="The same as `--to json`.")
@explain_option
@click.option(
    "--scene",
    metavar="NAME",
    default="",
    help="Show the parameters with the values of this scene; default: those of the spec.",
)
@click.option(
    "--dump",
    metavar="STAGE",
    help="Print the result of one stage of the compiler instead: read, decode, resolve, choose, form, associate, lower or render.",
)
@click.option(
    "--simplify",
    metavar="SECONDS",
    type=float,
    callback=_seconds,
    default=0.0,
    help="Let SymPy simplify what is printed, for so long at most; default: not at all.",
)
@anew_option
@output_option
@click.option("--force", is_flag=True, help="Replace the file after `-o` when it exists.")
def command(
    spec: str,
    formulation: str | None,
    to: str | None,
    as_json: bool,
    explain: bool,
    scene: str,
    dump: str | None,
    simplify: float,
    anew: bool,
    output: str | None,
    force: bool,
) -> int:
    """Derive the equations of motion.

    Prints the derivation of SPEC: the data, the 2-form, the equations of motion, each with its number in the thesis.
    """
    if as_json and to not in (None, "json"):
        raise click.UsageError(f"`--json` and `--to {to}` exclude one another")
    if dump is not None and (to or as_json):
        raise click.UsageError("`--dump` prints text: it goes with neither `--to` nor `--json`")
    to = to or ("json" if as_json else "text")
    source = open_spec(spec)
    if output not in (None, "-") and is_same_file(output, spec):
        raise click.UsageError(f"`-o {output}` is the spec itself, which the derivation would replace")
    shown = to == "text" and dump is None and output in (None, "-")
    width = narrow_width(sys.stdout, 100) if shown else 0  # 100 is the width of `nhc.emit.text.sheets`

    def make() -> Answer:
        from nhc import pipeline

        options = pipeline.Options(formulation=formulation or "", scene=scene, to=to, simplify=simplify, width=width)
        if dump is None:
            return {"": pipeline.derive(source, options)}
        stages = {stage.name: stage.about for stage in pipeline.STAGES}
        if dump not in stages:
            lines = [f"{name}: {about}" for name, about in stages.items()]
            raise Failure(f"no stage `{dump}`; the stages are {', '.join(stages)}", lines, "E0502")
        from nhc.dump import DUMPS

        return {"": DUMPS[dump](source, options)}

    asked = (formulation, scene, to, *([width] if width else []))
    kept = not (anew or dump or simplify)  # what a time limit decides may differ next time
    text = (answer(("derive", repr(asked), *list_texts(source)), make) if kept else make())[""]
    if explain:
        _explain(source, formulation)
    deliver(text, output, force=force)
    return 0


def _explain(source: Source, asked: str | None) -> None:
    """Say what ``nhc check`` finds; nothing of it keeps the derivation back, a scene that cannot start included."""
    from nhc.diagnostics import SpecError, render_text
    from nhc.pipeline import check

    try:
        report = check(source)
        diagnostics, facts = report.diagnostics, report.facts
    except SpecError as error:
        diagnostics, facts = error.diagnostics, ()
    if diagnostics:
        say(render_text(source, diagnostics, wants_colour(sys.stderr)))
    for fact in facts:
        say(fact)
    if asked:
        say(f"asked for: {asked}")
