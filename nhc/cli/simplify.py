"""``nhc reduce --tol``: approximate models of a scene, measured."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from nhc.cli.progress import Clock, show_line
from nhc.cli.terminal import Exit, Failure, is_terminal, put, put_json, put_text, say, terminal_width
from nhc.language import Source

if TYPE_CHECKING:
    from nhc.pipeline import Options


def check_options(tolerance: float | None, output: str | None, chart: str | None, fold: bool, as_json: bool) -> None:
    """Refuse options that do not go together.

    Raises:
        click.UsageError: with what would do.
    """
    if tolerance is None:
        if output is not None or chart is not None:
            raise click.UsageError("`-o` and `--chart` belong to `--tol`: without it nothing is approximated")
        return
    if not 1e-10 <= tolerance < 1:
        raise click.BadParameter(f"`{tolerance:g}`: from 1e-10 to less than 1", param_hint="--tol")
    if fold:
        raise click.UsageError("`--fold` does not go with `--tol`")
    if as_json and output == "-":
        raise click.UsageError("`--json` prints to stdout; name a file after `-o`")
    if output not in (None, "-") and not output.endswith((".yaml", ".yml")):
        raise click.UsageError("name a .yaml file after `-o`: the model is written as a spec")
    if chart is not None and output == chart:
        raise click.UsageError("`-o` and `--chart` name the same file")
    if chart is not None and not chart.endswith((".svg", ".html")):
        raise click.UsageError("name an .svg or .html file after `--chart`")


def approximate(
    source: Source,
    options: Options,
    tolerance: float,
    output: str | None,
    chart: str | None,
    force: bool,
    as_json: bool,
) -> int:
    """Measure, print the ladder (to stderr where the spec goes to stdout), and write what is asked for."""
    from nhc import pipeline
    from nhc.cli.write import check_place, refuse_to_overwrite, write_files
    from nhc.report.ladder import ladder_data, print_ladder, reduced_spec
    from nhc.report.ladder_picture import draw_ladder, make_ladder_page
    from nhc.study.simplify.measure import NotMeasured

    for name in (output, chart):
        if name not in (None, "-"):
            check_place(name)
    try:
        ladder = pipeline.simplify(source, tolerance, options, _show())
    except NotMeasured as error:
        raise Failure(str(error), error.help, exit=Exit.NUMERICAL) from error
    finally:
        show_line("")
    texts = {Path(output): reduced_spec(ladder)} if output is not None and output != "-" else {}
    if chart is not None:
        texts[Path(chart)] = (draw_ladder if chart.endswith(".svg") else make_ladder_page)(ladder)
    if not force:
        refuse_to_overwrite(texts, edited_only=False)
    for note in ladder.notes:
        say(f"note: {note}")
    if as_json:
        put_json("nhc.ladder/1", ladder_data(ladder))
    elif output == "-":
        say(print_ladder(ladder, terminal_width(sys.stderr)))
        put(reduced_spec(ladder))
    else:
        put_text(print_ladder(ladder, terminal_width(sys.stdout)))
    if texts:
        write_files(texts)
    return Exit.DONE


def _show() -> Callable[[int, str], None]:
    """Progress: a line that changes on a terminal; elsewhere one whenever the clock strikes."""
    clock = Clock()

    def show(runs: int, about: str) -> None:
        show_line(f"{runs}: without {about}")
        if not is_terminal(sys.stderr) and clock.strikes():
            say(f"after {clock.passed:.0f} s {runs} models are measured")

    return show
