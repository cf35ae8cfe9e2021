"""``nhc run --ensemble``: a scene from each start of a table."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from nhc.cli.options import check_steps
from nhc.cli.progress import Progress
from nhc.cli.reading import MIB, read_bounded
from nhc.cli.terminal import Exit, Failure, put, say

if TYPE_CHECKING:
    from nhc.diagnostics import Source
    from nhc.simulate.ensemble import Ensemble
    from nhc.simulate.run import Settings

SHOWN = 20
"""Failures that are told one by one."""

_TABLE = "name a CSV table with a header of names, or `-` for standard input"

LARGEST_TABLE = 256 * MIB


def check_options(
    method: str, step: float, until: str, project: bool, values: tuple[str, ...], target: Path | None, *, twice: bool
) -> None:
    """Refuse what an ensemble does not do, and stdin that is to be read ``twice``."""
    from nhc.simulate.methods import RUNGE_KUTTA, is_adaptive
    from nhc.simulate.pacing import AUTO

    if twice:
        raise click.UsageError("the spec or the table can come from stdin, not both")
    if until or project:
        raise click.UsageError(f"`--ensemble` and `{'--until' if until else '--project'}` exclude one another")
    if values:
        raise click.UsageError("`--ensemble` takes values from its table; make those of `--set` columns of it")
    if method != AUTO and method not in RUNGE_KUTTA:
        raise click.UsageError(f"`--ensemble` takes one of {', '.join(RUNGE_KUTTA)}, not `{method}`")
    if not step and method != AUTO and not is_adaptive(method):
        raise click.UsageError(f"`--ensemble` with `{method}` needs `--step`")
    if target is not None and target.suffix != ".csv":
        raise click.UsageError("`--ensemble` writes a .csv file")


def run_starts(
    source: Source,
    table: str,
    scene: str,
    time: str,
    formulation: str,
    needs: tuple[str, ...],
    hold: bool,
    stay: bool,
    settings: Settings,
    target: Path | None,
) -> int:
    """Read the table, integrate every start, write one CSV; ``stay``: no start has a run of its own."""
    from nhc.language import decode
    from nhc.simulate.changes import Changes
    from nhc.simulate.ensemble import run_ensemble
    from nhc.simulate.methods import DEFAULT
    from nhc.simulate.opening import open_scene
    from nhc.simulate.pacing import AUTO
    from nhc.simulate.requests import RunError, find_scene
    from nhc.simulate.starts import extreme_scenes, list_starts, read_starts

    together = replace(settings, method=DEFAULT) if settings.method == AUTO else settings
    text = _read_table(table)
    try:
        spec = decode(source)
        chosen = find_scene(spec, scene)
        rows = read_starts(text, spec)
        beside = extreme_scenes(spec, chosen, rows)
        job = open_scene(
            source,
            scene,
            formulation,
            changes=Changes(time=time),
            needs=needs,
            method=together.method,
            hold=hold,
            whole=True,
            beside=beside,
        )
        starts = list_starts(job.system, job.scene, rows)
    except RunError as error:
        raise Failure(str(error), error.help, exit=Exit.FAILED) from error
    if not scene:
        say(f"taking the scene `{job.scene.name}`")
    check_steps(settings.step, *job.time)
    bar = Progress(0.0, 1.0, "")
    try:
        found = run_ensemble(job, starts, together, bar.show, None if stay else settings)
    finally:
        bar.clear()
    for note in found.notes:
        say(f"note: {note}")
    return _deliver(found, target)


def _read_table(path: str) -> str:
    try:
        return read_bounded(path, LARGEST_TABLE, [_TABLE], stdin=True).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise Failure(f"`{path}` is not a text in UTF-8", [_TABLE]) from error


def _deliver(found: Ensemble, target: Path | None) -> int:
    from nhc.cli.write import write_bytes
    from nhc.report.trajectory import ensemble_text

    stopped, failed = len(found.members) < found.starts, found.failed
    if not stopped and not failed:
        if target is None:
            put(ensemble_text(found))
            return Exit.DONE
        write_bytes(target, ensemble_text(found).encode())
        steps = sum(member.outcome.steps for member in found.members)
        say(f"{found.starts} starts, {steps} steps")
        return Exit.DONE
    for number, member in failed[:SHOWN]:
        say(f"start {number} fails at t = {member.outcome.t!r}: {member.reason}")
    if len(failed) > SHOWN:
        say(f"... and {len(failed) - SHOWN} more")
    kept = len(found.members) - len(failed)
    if target is not None and kept:
        partial = target.with_name(f"{target.stem}.partial{target.suffix}")
        write_bytes(partial, ensemble_text(found).encode())
    if stopped:
        say(f"interrupted after {len(found.members)} of {found.starts} starts")
        return Exit.INTERRUPTED
    said = f"the {kept} others are in the partial file" if target is not None and kept else "nothing was written"
    raise Failure(f"{len(failed)} of {found.starts} starts fail", found.advise(), exit=Exit.NUMERICAL, notes=[said])
