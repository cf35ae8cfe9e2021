"""``nhc stability``: what a scene's motion, and its integration, can be trusted with."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING

import click

from nhc.cli.options import (
    SweepRange,
    formulation_option,
    hold_option,
    json_option,
    scene_set_option,
    sweep_option,
    verb,
)
from nhc.cli.progress import Parts, show_line
from nhc.cli.specs import complete_spec, open_spec
from nhc.cli.terminal import Exit, Failure, put_json, put_text, say
from nhc.cli.write import refuse_existing

if TYPE_CHECKING:
    from nhc.study.stability.laboratory import Laboratory, Question


def _check_number(context: click.Context, parameter: click.Parameter, value: float) -> float:
    """A range lets a NaN pass."""
    if math.isnan(value):
        raise click.BadParameter("it must be a number")
    return value


@verb("stability", "nhc stability chaplygin_sleigh -o stability.html", "nhc stability bicycle --sweep speed=0:10")
@click.argument("spec", required=False, shell_complete=complete_spec)
@click.option("--scene", metavar="NAME", default="", help="The scene to look at; default: the first.")
@click.option(
    "--about",
    metavar="MOTION",
    default="",
    help="Where to start looking for a steady motion: a scene, or values; default: the scene.",
)
@scene_set_option
@hold_option
@sweep_option()
@click.option(
    "--long",
    "lengths",
    type=click.FloatRange(1, 1e6),
    callback=_check_number,
    default=10,
    help="Length of the long run, in lengths of the scene; default: 10.",
)
@click.option("--atlas", is_flag=True, help="Run the atlas of failures in place of a spec.")
@click.option("--slow", is_flag=True, help="With `--atlas`: the scenarios that take longer, too.")
@formulation_option
@click.option("-o", "output", metavar="FILE", help="Write the page with pictures to FILE (.html).")
@click.option("--force", is_flag=True, help="Overwrite FILE when it exists.")
@json_option
def command(
    spec: str | None,
    scene: str,
    about: str,
    values: tuple[str, ...],
    holds: tuple[str, ...],
    sweep: SweepRange | None,
    lengths: float,
    atlas: bool,
    slow: bool,
    formulation: str | None,
    output: str | None,
    force: bool,
    as_json: bool,
) -> int:
    """Study how stable a scene's motion and its integration are.

    Prints one table: steady motion and eigenvalues, largest stable steps, long-run drift, sensitivity to the start,
    distance from singular points.
    """
    if atlas:
        if spec is not None or output is not None:
            raise click.UsageError("`--atlas` takes neither a spec nor `-o`")
        return _run_atlas(slow, as_json)
    if spec is None:
        raise click.UsageError("missing argument `SPEC`")
    if slow:
        raise click.UsageError("`--slow` belongs to `--atlas`")
    target = _check_target(output, force)
    source = open_spec(spec)
    from nhc.pipeline import Options, stability
    from nhc.study.stability.laboratory import Question

    question = Question(scene, about, values, holds, sweep, lengths)
    try:
        found = stability(source, question, Options(formulation=formulation or ""), Parts().show)
    finally:
        show_line("")
    _deliver(found, question, target, as_json)
    if found.failed:
        advice = [f"`nhc run`: {found.conduct[-1]}"] if found.stopped else []
        if found.conduct and not advice:
            advice = [f"`nhc run` ends this scene: {found.conduct[0]}"]
            advice += ["leave `--formulation` out, if it is that which fails"] if formulation else []
        raise Failure(f"the scene cannot be studied: {found.failed}", advice, exit=Exit.NUMERICAL)
    if question.sweep is not None and (found.motion is None or found.motion.swept is None):
        why = dict(found.missing).get("steady motion", "no steady motion")
        raise Failure(f"nothing to sweep: {why}", ["give a steady motion with `--about`"], exit=Exit.NUMERICAL)
    return 0


def _run_atlas(slow: bool, as_json: bool) -> int:
    """Every scenario; 1 where one does not pass."""
    from nhc.study.atlas.table import lines, run_all, tree

    results = run_all(slow, say)
    if as_json:
        put_json("nhc.atlas/1", tree(results))
    else:
        put_text("\n".join(lines(results)))
    return Exit.DONE if all(verdict.passed for _, verdict in results) else Exit.FAILED


def _check_target(output: str | None, force: bool) -> Path | None:
    if output is None:
        return None
    path = Path(output)
    if path.suffix != ".html":
        raise click.UsageError(f"`{output}` should end in .html")
    refuse_existing(output, force)
    return path


def _deliver(found: Laboratory, question: Question, target: Path | None, as_json: bool) -> None:
    from nhc.study.stability.table import lines
    from nhc.study.stability.tree import tree

    for note in found.bench.notes:
        say(f"note: {note}")
    if as_json:
        put_json("nhc.stability/1", tree(found))
    else:
        put_text("\n".join(lines(found)))
    if target is not None:
        from nhc.cli.write import write_bytes
        from nhc.report.stability import make_page

        write_bytes(target, make_page(found).encode())
