"""The smallest model of a scene within a tolerance: the search, its result in another way once more, and the ladder to it."""

from __future__ import annotations

from collections.abc import Sequence

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.simulate.changes import UNCHANGED, Changes, changed
from nhc.simulate.requests import find_scene
from nhc.simulate.run import POINTS
from nhc.study.chart.measure import describe_machine
from nhc.study.simplify.candidate import Candidate, name_beyond
from nhc.study.simplify.draft import draft_of
from nhc.study.simplify.elimination import Search, Show, Trial
from nhc.study.simplify.ladder import Kept, Ladder, Rung
from nhc.study.simplify.measure import TIGHTER, Refused, meter_of
from nhc.study.simplify.text import write_draft

MOST_RUNS = 150


def simplify(
    source: Source,
    scene: str,
    tolerance: float,
    formulation: str = "",
    show: Show | None = None,
    changes: Changes = UNCHANGED,
    most: int = MOST_RUNS,
) -> Ladder:
    """The ladder of models of a scene from the full one to the smallest within ``tolerance``.

    ``tolerance``: the largest error of a needed quantity on the output grid, relative to its largest magnitude there; ``changes``:
    other values of the scene and another time, which the smallest model's spec then has.

    Raises:
        nhc.diagnostics.SpecError: the spec has errors.
        nhc.simulate.requests.RunError: no such scene.
        NotMeasured: the full model's run is no reference.
    """
    spec = decode(source)
    draft = draft_of(source, changed(spec, find_scene(spec, scene), changes)[1], changes != UNCHANGED)
    meter = meter_of(source, scene, formulation, tolerance, changes)
    search = Search(draft, meter, most, show)
    search.search(draft.candidates(meter.job.start))
    gone, again = _confirmed(search)
    rungs = _rungs(search, gone)
    names = [parameter.name for parameter in draft.spec.parameters]
    return Ladder(
        system=draft.spec.system,
        scene=draft.scene.name,
        time=meter.job.time,
        points=POINTS,
        method=meter.method,
        compiled=meter.compiled,
        tolerance=tolerance,
        run_tolerance=TIGHTER * tolerance,
        confirmed=f"{meter.second.method} at tolerance {meter.second.tolerance:g}",
        again=again,
        parameters=tuple(zip(names, meter.job.start.p, strict=True)),
        needs=meter.needs,
        ranges=meter.way.ranges(draft.spec),
        rungs=tuple(rungs),
        kept=tuple(Kept(c.about, reason) for c, reason in search.reasons.items() if search.stays(c, gone)),
        runs=search.runs,
        turned_back=search.turned_back,
        most=most,
        bounded=search.bounded,
        machine=describe_machine().line,
        spec=write_draft(draft, draft.change(gone), _about(len(gone), search)),
        notes=meter.notes,
        changes=changes.notes,
    )


def _rungs(search: Search, gone: Sequence[Candidate]) -> list[Rung]:
    """The models on the way to the smallest.

    After an exchange some of them may be no models, or too far off; then what is left out next stands in the same rung.  They are
    measured even where the search has used up its runs.
    """
    search.most += len(gone)
    found = [Rung("", search.meter.own, search.meter.size, search.meter.price(search.text([])))]
    names: list[str] = []
    for k, candidate in enumerate(gone, 1):
        names.append(name_beyond(candidate, gone[: k - 1]))
        trial = search.trial(gone[:k])
        if isinstance(trial, Trial) and search.fits(trial):
            price = search.meter.price(search.text(gone[:k]))
            found.append(Rung(" and ".join(names), trial.errors, trial.size, price))
            names = []
    return found


def _confirmed(search: Search) -> tuple[list[Candidate], tuple[float, ...]]:
    """What goes when the smallest model is measured again in the second way: with what does not stand that, others that it had kept
    from going are tried anew.
    """
    while True:
        gone, errors, failing = _agreed(search)
        if failing is None:
            return gone, errors
        search.forbid(failing, gone)


def _agreed(search: Search) -> tuple[list[Candidate], tuple[float, ...], Candidate | None]:
    """The longest beginning of what is gone that the second way confirms, its errors, and the one that may not follow it."""
    gone, meter, failing = list(search.gone), search.meter, None
    while gone:
        try:
            errors, _ = meter.measure(search.text(gone), again=True)
        except Refused as refused:
            reason = str(refused)
        else:
            if max(errors) + max(meter.own) <= meter.tolerance:
                return gone, errors, failing
            reason = f"the second method finds an error of {max(errors):.2g}"
        failing = gone.pop()
        search.reasons[failing] = f"not confirmed: {reason}"
    return gone, meter.own, failing


def _about(number: int, search: Search) -> str:
    """What is added to what the system is, so that files emitted from the reduced spec say it, too."""
    if not number:
        return ""
    count = "1 part left out" if number == 1 else f"{number} parts left out"
    return f"(approximate: {count}, good to {search.meter.tolerance:g} on the scene {search.draft.scene.name} only)"
