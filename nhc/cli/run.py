"""``nhc run``: a scene, integrated."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from nhc.cli.options import (
    FINEST_TOLERANCE,
    check_steps,
    formulation_option,
    need_option,
    scene_set_option,
    scene_time_option,
    spec_argument,
    verb,
)
from nhc.cli.progress import Progress
from nhc.cli.specs import open_spec
from nhc.cli.terminal import Exit, Failure, put, say
from nhc.cli.write import refuse_existing, write_bytes

if TYPE_CHECKING:
    from nhc.simulate.prepare import Job
    from nhc.simulate.run import Settings, Trajectory

# nhc.simulate.methods again, which takes too long to import for a help text; a test holds them equal
METHODS = (
    *("dop853", "dopri5", "rk4", "radau5", "gauss4", "gauss6", "midpoint"),
    *("leapfrog", "dla", "perlmutter", "energy"),
    *("scipy-dop853", "scipy-rk45", "scipy-radau", "scipy-bdf", "scipy-lsoda", "cvode-adams", "cvode-bdf"),
)
PICTURES = (".svg", ".html")
KINDS = (".csv", ".npz", *PICTURES)
LONG, SLOW = 200_000, 5_000
"""Steps of a run, compiled or not, that is not made again for the sake of its picture."""


def _positive(context: click.Context, parameter: click.Parameter, value: float | None) -> float:
    if value is not None and not (value > 0 and math.isfinite(value)):
        raise click.BadParameter("it must be positive and finite")
    return value or 0.0


def _expression(context: click.Context, parameter: click.Parameter, value: str | None) -> str:
    if value is not None and not value.strip():
        raise click.BadParameter("it holds no expression; leave it out, or write one such as `theta - 1`")
    sides = [side.strip() for side in re.split("[<>=]+", value or "")]
    if len(sides) == 2 and all(sides):
        right = f"({sides[1]})" if re.search("[-+]", sides[1]) else sides[1]
        wanted = sides[0] if right == "0" else f"{sides[0]} - {right}"
        raise click.BadParameter(f"it takes an expression, and the run ends where that crosses zero; write `{wanted}`")
    return value or ""


@verb(
    "run",
    "nhc run chaplygin_sleigh -o sleigh.html",
    "nhc run rolling_disk --scene lean --tol 1e-10 --points 501",
    "nhc run rolling_disk --scene lean --set 'R=0.3, w_n=5' --time 60",
)
@spec_argument
@click.option("--scene", metavar="NAME", default="", help="The scene to run; default: the first.")
@scene_set_option
@scene_time_option
@click.option("-o", "output", metavar="FILE", help="A .csv, .npz, .svg or .html file; default: CSV on stdout (`-`).")
@need_option("The columns that are wanted")
@click.option(
    "--points",
    type=click.IntRange(2, 10_000_000),
    help="Number of rows; default: 201, in pictures as many as it takes to draw curves, with --ensemble 2 for each start.",
)
@click.option(
    "--method",
    "-m",
    type=click.Choice((*METHODS, "auto")),
    metavar="M",
    default="auto",
    help=f"The integrator: {', '.join(METHODS)}, or auto, the default, which is explicit until the scene becomes stiff.",
)
@click.option("--tol", "tolerance", type=float, callback=_positive, help="Relative accuracy; default: the scene's.")
@click.option(
    "--step",
    type=float,
    callback=_positive,
    help="Fixed steps of this length; default: adaptive ones, or for a method without them a length found by halving.",
)
@click.option(
    "--until",
    metavar="EXPR",
    callback=_expression,
    help="Stop where this expression in the spec's names crosses zero; default: at the end of the scene.",
)
@click.option(
    "--ensemble",
    metavar="FILE",
    default="",
    help="Run from each row of this CSV table of start values (`-`: stdin).",
)
@formulation_option
@click.option(
    "--project",
    is_flag=True,
    help="Replace initial velocities that violate the constraints by the nearest that do not.",
)
@click.option("--stay", is_flag=True, help="Never change the formulation; fail where it becomes singular.")
@click.option("--drift", is_flag=True, help="Do not bring the state back to the constraints after each step.")
@click.option("--python", "interpreted", is_flag=True, help="Run the emitted Python instead of compiled C; slow.")
@click.option("--force", is_flag=True, help="Overwrite FILE when it exists.")
def command(
    spec: str,
    scene: str,
    values: tuple[str, ...],
    time: str,
    output: str | None,
    needs: tuple[str, ...],
    points: int | None,
    method: str,
    tolerance: float,
    step: float,
    until: str,
    ensemble: str,
    formulation: str | None,
    project: bool,
    stay: bool,
    drift: bool,
    interpreted: bool,
    force: bool,
) -> int:
    """Integrate a scene and write its trajectory.

    Emits C with the integrator beside the equations, compiles it once into the cache, and runs it; without a compiler it runs
    the emitted Python.
    """
    target = _check_target(output, force)
    _check_accuracy(method, tolerance, step)
    if ensemble:
        from nhc.cli.ensemble import check_options, run_starts

        check_options(method, step, until, project, values, target, twice=spec == ensemble == "-")
    source = open_spec(spec)
    from nhc.simulate.changes import Changes
    from nhc.simulate.opening import open_scene
    from nhc.simulate.run import POINTS, Settings

    settings = Settings(method, tolerance, step, points or (2 if ensemble else POINTS), not interpreted)
    if ensemble:
        return run_starts(source, ensemble, scene, time, formulation or "", needs, not drift, stay, settings, target)
    page = target is not None and target.suffix == ".html"
    job = open_scene(
        source,
        scene,
        formulation or "",
        changes=Changes(values, time),
        needs=needs,
        until=until,
        method=method,
        hold=not drift,
        project=project,
        checks=page,
        draw=page,
        stay=stay,
    )
    if not scene:
        say(f"taking the scene `{job.scene.name}`")
    check_steps(step, *job.time)
    drawn = points is None and target is not None and target.suffix in PICTURES
    return _conclude(_integrate(job, settings, drawn), target, until)


def _check_accuracy(method: str, tolerance: float, step: float) -> None:
    """Refuse what contradicts itself."""
    if tolerance >= 1:
        raise click.UsageError("`--tol` is a relative accuracy, such as 1e-8")
    if 0 < tolerance < FINEST_TOLERANCE:
        raise click.UsageError(f"`--tol {tolerance!r}` is finer than doubles are; ask for {FINEST_TOLERANCE!r} or more")
    if step and method.startswith(("scipy", "cvode")):
        raise click.UsageError(f"`{method}` chooses its own steps; leave `--step` out")


def _integrate(job: Job, settings: Settings, drawn: bool) -> Trajectory:
    """The run, with its progress on a terminal; one that is ``drawn`` once more where it needs more rows to look smooth."""
    from nhc.simulate.run import picture_points, run

    bar = Progress(*job.time)
    found = run(job, settings, bar.show)
    bar.clear()
    rows = picture_points(found) if drawn else 0
    if rows <= settings.points:
        return found
    if found.outcome.steps > (LONG if found.compiled else SLOW):
        say(f"note: {len(found.times)} rows may be too few for a smooth picture of this motion; give `--points {rows}`")
        return found
    found = run(job, replace(settings, points=rows), bar.show)
    bar.clear()
    if found.outcome.steps > rows:
        say(
            f"note: {found.outcome.steps} steps in {rows} rows: what is over within a row is not drawn as large as it is; "
            f"`--points {found.outcome.steps + 1}` shows it"
        )
    return found


def _check_target(output: str | None, force: bool) -> Path | None:
    """The file to be written; None for stdout."""
    if output in (None, "-"):
        return None
    assert output is not None
    path = Path(output)
    if path.suffix not in KINDS:
        raise click.UsageError(f"`{output}` should end in {', '.join(KINDS)}")
    if path.is_dir():
        raise Failure(f"`{output}` is a folder", ["name a file after `-o`"])
    refuse_existing(output, force)
    return path


def _conclude(found: Trajectory, target: Path | None, until: str) -> int:
    """Say what is to be said of a run, and write it."""
    for note in found.notes:
        say(f"note: {note}")
    if found.ended not in ("done", "event"):
        return _report(found, target)
    if until and found.ended != "event":
        say("the expression of `--until` does not cross zero before the end of the scene")
    return _deliver(found, target)


def _deliver(found: Trajectory, target: Path | None) -> int:
    """Write the rows; an interrupt meanwhile keeps them, as one during the run keeps those so far."""
    from nhc.report.trajectory import csv_text, make_file

    if found.ended == "event":
        say(f"stopped at t = {found.times[-1]!r}: {found.reason}")
    if target is None:
        put(csv_text(found))
        return Exit.DONE
    try:
        content = make_file(found, target.suffix)
    except KeyboardInterrupt:
        say(f"interrupted after the run; {len(found.times)} rows are kept")
        _keep_part(found, target)
        return Exit.INTERRUPTED
    write_bytes(target, content)
    outcome = found.outcome
    how = "C" if found.compiled else "Python"
    say(
        f"{len(found.times)} rows, {found.method} in {how}: {outcome.steps} steps ({outcome.rejected} rejected), "
        f"{outcome.calls} right-hand sides"
    )
    return Exit.DONE


def _keep_part(found: Trajectory, target: Path) -> None:
    from nhc.report.trajectory import make_file

    write_bytes(target.with_name(f"{target.stem}.partial{target.suffix}"), make_file(found, target.suffix))


def _report(found: Trajectory, target: Path | None) -> int:
    """A run that did not come to its end: what there is goes to a file whose name says so."""
    from nhc.simulate.outcomes import LOST_RANK, describe_state, rank_left

    state = describe_state(found.job, found.outcome)
    where = f"at t = {found.outcome.t!r}"
    if found.ended == "stopped":
        say(
            f"interrupted {where}; "
            + ("nothing was written" if target is None else f"{len(found.times)} rows are kept")
        )
    if target is not None and found.ended == "stopped":
        _keep_part(found, target)
    if found.ended == "stopped":
        return Exit.INTERRUPTED
    scene, method = found.job.scene.name, found.method
    notes = [f"the state there: {state}", "nothing was written"]
    rank = rank_left(found.job, found.outcome)
    if rank is not None:
        notes.append(f"the smallest singular value of the constraints there: {rank:.3g}")
    advice = [*_advise(found, rank is not None and rank < LOST_RANK), *_end_before(found)]
    if not advice and found.job.recipe is not None and found.outcome.t == found.job.time[0]:
        from nhc.program.runs.undetermined import explain_start

        why, advice_there = explain_start(found.job.recipe.equations, found.job.formulation, found.job.start)
        notes, advice = [*notes, *why], [*advice_there]
    failure = f"the scene `{scene}` fails {where} ({method}): {found.reason}"
    raise Failure(failure, advice, exit=Exit.NUMERICAL, notes=notes)


def _end_before(found: Trajectory) -> list[str]:
    """The option that writes what comes before the failure; nothing where a scene fails at its start."""
    start, lost = found.job.start.time[0], found.outcome.t
    end = start + float(f"{0.99 * (lost - start):.3g}")
    if not start < end < lost:
        return []
    time = f"{start:.12g}:{end:.12g}" if start else f"{end:.12g}"
    return [f"`--time {time}` writes the motion until shortly before"]


def _advise(found: Trajectory, lost: bool) -> list[str]:
    """What can be done about a singular place; ``lost``: the constraints have no full rank there."""
    from nhc.simulate.outcomes import find_lost
    from nhc.simulate.peers import PEERS
    from nhc.simulate.task import CROSSED, DONE

    job, outcome = found.job, found.outcome
    if lost and outcome.t == job.start.time[0]:
        return ["there the constraints lose rank, and no formulation has a motion: let the scene start elsewhere"]
    if lost:
        return ["there the constraints lose rank, and no formulation has a motion beyond: end the scene before"]
    if outcome.kind == DONE:  # the motion goes on: it is a column that ends there
        return ["leave it out of what is needed or drawn, or end the scene before with `--time`"]
    if outcome.kind != CROSSED:
        return []
    kind = job.watch.kinds[find_lost(job, outcome)]
    if kind == "edge":
        return ["end the scene before, or give an expression that has values all the way"]
    if kind in ("mass", "whole"):
        return ["look at T there, or take coordinates that are regular, such as a `rotation:` for angles in space"]
    if found.method in PEERS:
        return [f"leave `--method {found.method}` out: nhc's own methods go on with another choice of velocities"]
    if job.recipe is None or not job.recipe.weak:
        return ["leave `--stay` out: the run then goes on with another choice of velocities"]
    if job.formulation.frame is not None and job.system.constraints:
        return [
            "no other choice of velocities is better there; `-f multipliers` keeps all of them and goes on where the coordinates "
            "are regular, and a `rotation:` is regular for all angles in space"
        ]
    return [
        "no choice of velocities is regular there: the coordinates are singular; "
        "take others, such as a `rotation:` for angles in space"
    ]
