"""``nhc chart``: which equations and which method give which accuracy in which time?"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from nhc.cli.options import (
    FINEST_TOLERANCE,
    FORMULATIONS,
    json_option,
    need_option,
    scene_set_option,
    scene_time_option,
    specs_argument,
    split_names,
    verb,
)
from nhc.cli.progress import Parts
from nhc.cli.specs import open_spec
from nhc.cli.terminal import Exit, Failure, put, put_text, say

if TYPE_CHECKING:
    from nhc.study.chart.case import Study
    from nhc.study.chart.fidelity import Comparison

# nhc.simulate.methods.RUNGE_KUTTA and STRUCTURE again, which take too long to import for a help text; a test holds them equal
RUNGE_KUTTA = ("dop853", "dopri5", "rk4", "radau5", "gauss4", "gauss6", "midpoint")
STRUCTURE = ("leapfrog", "dla", "perlmutter", "energy")
METHODS = (*RUNGE_KUTTA, *STRUCTURE)
LANGUAGES = ("c", "python")
KINDS = (".svg", ".html", ".json", ".md")


Reader = Callable[[click.Context, click.Parameter, str | None], tuple[str, ...]]


def _names_of(known: tuple[str, ...], what: str) -> Reader:
    def read(context: click.Context, parameter: click.Parameter, value: str | None) -> tuple[str, ...]:
        names = tuple(dict.fromkeys(split_names(context, parameter, value)))
        for name in names:
            if name not in known:
                raise click.BadParameter(f"no {what} `{name}`; it can be {', '.join(known)}")
        return names

    return read


def _tolerances(context: click.Context, parameter: click.Parameter, value: str | None) -> tuple[float, ...]:
    found = []
    for text in split_names(context, parameter, value):
        try:
            number = float(text)
        except ValueError:
            raise click.BadParameter(f"`{text}` is no number") from None
        if not FINEST_TOLERANCE <= number < 1:
            raise click.BadParameter(f"`{text}` is no tolerance: from {FINEST_TOLERANCE!r} to less than 1")
        found.append(number)
    return tuple(dict.fromkeys(found))


@verb(
    "chart",
    "nhc chart chaplygin_sleigh -o chart.html",
    "nhc chart ladder/rigid_bicycle --against ladder/relaxing_tyres",
)
@specs_argument
@click.option("--scene", metavar="NAME", default="", help="The scene to chart; default: the first.")
@scene_set_option
@scene_time_option
@need_option("The quantities whose error is measured")
@click.option(
    "--formulations",
    metavar="F,...",
    callback=_names_of(FORMULATIONS, "formulation"),
    help="The formulations to compare; default: all that apply.",
)
@click.option(
    "--methods",
    metavar="M,...",
    callback=_names_of(METHODS, "method"),
    help="The integrators; default: dop853, dopri5, rk4, radau5, gauss6, and leapfrog, dla, perlmutter, energy where they apply.",
)
@click.option(
    "--langs",
    "languages",
    metavar="L,...",
    callback=_names_of(LANGUAGES, "language"),
    help="The languages to compare; default: c,python.",
)
@click.option(
    "--tolerances",
    metavar="T,...",
    callback=_tolerances,
    help="The tolerances to run at; default: 1e-2, 1e-3, ... 1e-13.",
)
@click.option(
    "--no-peers", is_flag=True, help="Leave out other integrators (SciPy, heyoka), even where they are installed."
)
@click.option(
    "--against",
    metavar="SPEC",
    default="",
    help="Compare models: errors of the specs against this finest one, on a scene that all have.",
)
@click.option(
    "-o",
    "output",
    metavar="FILE|DIR",
    help="A .svg, .html, .json or .md file, or a folder for all four; default: Markdown on stdout.",
)
@click.option("--force", is_flag=True, help="Overwrite files that exist.")
@json_option
def command(
    specs: tuple[str, ...],
    scene: str,
    values: tuple[str, ...],
    time: str,
    needs: tuple[str, ...],
    formulations: tuple[str, ...],
    methods: tuple[str, ...],
    languages: tuple[str, ...],
    tolerances: tuple[float, ...],
    no_peers: bool,
    against: str,
    output: str | None,
    force: bool,
    as_json: bool,
) -> int:
    """Chart time against error and recommend equations and a method.

    Runs a scene by every formulation, method, language and tolerance, measures errors against a reference of much higher
    accuracy, and says which is the fastest for which accuracy, and why.  With `--scene` it runs the scene's reduced models.
    With `--against FINEST` it compares models instead: the error of each spec against the finest one, and its cost.  Without
    `-o` it prints Markdown.
    """
    target = _check_target(output, 1 if against else len(specs), as_json, force)
    if against and (formulations or languages):
        raise click.UsageError(
            "`--against` compares models, each as nhc runs it: leave `--formulations` and `--langs` out"
        )
    if against and set(methods) & set(STRUCTURE):
        raise click.UsageError("`--against` takes Runge-Kutta methods, which run on the scene's reduced models")
    sources = [open_spec(spec) for spec in specs]
    finest = open_spec(against) if against else None
    from nhc import pipeline
    from nhc.simulate.changes import Changes
    from nhc.study.chart.grid import Grid
    from nhc.study.chart.reference import NoReference

    grid = Grid(scene, needs, formulations, methods, languages, tolerances, not no_peers, Changes(values, time))
    try:
        if finest is not None:
            _deliver_comparison(pipeline.compare_models(sources, finest, grid, Parts().show), target, as_json, force)
            return Exit.DONE
        for source in sources:
            _deliver(pipeline.chart(source, grid, Parts().show), target, as_json, force)
    except NoReference as error:
        advice = [f"`nhc run -f {error.formulation} --stay` says where they fail; other equations may not"]
        raise Failure(str(error), advice, exit=Exit.NUMERICAL) from error
    return Exit.DONE


def _check_target(output: str | None, count: int, as_json: bool, force: bool) -> Path | None:
    """The file or folder to write to; None for stdout."""
    if as_json and output is not None:
        raise click.UsageError("`--json` prints to stdout; name a .json file after `-o` instead")
    if as_json and count > 1:
        raise click.UsageError("`--json` takes one SPEC; name a folder after `-o`")
    if output is None or output == "-":
        return None
    from nhc.cli.write import check_place, refuse_existing

    path = Path(output)
    if path.suffix in KINDS and not path.is_dir():
        if count > 1:
            raise click.UsageError("several specs need a folder after `-o`")
        refuse_existing(output, force)
        return path
    if path.suffix or path.is_file():
        raise click.UsageError(f"`{output}` should be a folder, or end in {', '.join(KINDS)}")
    check_place(path, inside=True)
    return path


def _deliver(study: Study, target: Path | None, as_json: bool, force: bool) -> None:
    from nhc.report.chart_file import make_file

    _put_or_write(
        study.notes, f"{study.system}_{study.scene}_chart", lambda kind: make_file(study, kind), target, as_json, force
    )


def _deliver_comparison(made: Comparison, target: Path | None, as_json: bool, force: bool) -> None:
    from nhc.report.comparison_page import make_comparison_file

    stem = f"{made.scene}_against_{made.finest.replace('/', '_')}"
    _put_or_write(made.notes, stem, lambda kind: make_comparison_file(made, kind), target, as_json, force)


def _put_or_write(
    notes: tuple[str, ...], stem: str, make: Callable[[str], str], target: Path | None, as_json: bool, force: bool
) -> None:
    """Print, or write one file or all four kinds; ``make`` takes a suffix."""
    for note in notes:
        say(f"note: {note}")
    if target is None:
        if as_json:
            put(make(".json"))
        else:
            put_text(make(".md"))
        return
    from nhc.cli.write import refuse_to_overwrite, write_files

    paths = [target] if target.suffix in KINDS else [target / f"{stem}{kind}" for kind in KINDS]
    files = {path: make(path.suffix) for path in paths}
    if not force:
        refuse_to_overwrite(files, edited_only=False)
    write_files(files)
