"""Greedy backward elimination: leave out what costs the least error for what it saves, for as long as the tolerance lasts."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.simulate.methods import DEFAULT
from nhc.simulate.opening import find_scene
from nhc.simulate.run import POINTS
from nhc.study.simplify.draft import Candidate, Draft, draft_of
from nhc.study.simplify.ladder import Kept, Ladder, Rung, Size
from nhc.study.simplify.measure import TIGHTER, Meter, Refused, meter_of, ranges_of

MOST_RUNS = 60
Show = Callable[[int, str], None]  # models measured so far, the candidate


@dataclass(frozen=True)
class _Trial:
    candidate: Candidate
    errors: tuple[float, ...]
    size: Size
    saved: int

    @property
    def score(self) -> float:
        return max(self.errors) / self.saved


@dataclass
class _Search:
    draft: Draft
    meter: Meter
    most: int
    show: Show | None
    runs: int = 0
    bounded: bool = False
    gone: list[Candidate] = field(default_factory=list)
    rungs: list[Rung] = field(default_factory=list)
    reasons: dict[Candidate, str] = field(default_factory=dict)

    def climb(self) -> None:
        """Measure every candidate, drop the best, and begin again with those that may still go.

        What exceeds the tolerance when it goes stays for good: that later errors may cancel its own is no reason to drop it.
        """
        self.rungs.append(Rung("", self.meter.own, self.meter.size))
        left = self.draft.candidates()
        while left:
            trials = self._measure_all(left)
            if not trials:
                break
            best = min(trials, key=lambda trial: trial.score)  # the first of equals
            self.gone.append(best.candidate)
            self.rungs.append(Rung(best.candidate.about, best.errors, best.size))
            left = [trial.candidate for trial in trials if trial is not best]
            if self.bounded:
                self.reasons.update((c, "not measured again: the bound on runs is reached") for c in left)
                break

    def _measure_all(self, left: list[Candidate]) -> list[_Trial]:
        seen = {self.draft.without(self.gone)}
        found = []
        for candidate in left:
            text = self.draft.without([*self.gone, candidate])
            if text in seen:  # it went with another one, or is the same as another one
                continue
            seen.add(text)
            if self.runs >= self.most:
                self.bounded = True
                self.reasons[candidate] = "not measured: the bound on runs is reached"
                continue
            trial = self._measure(candidate, text)
            if trial is not None:
                found.append(trial)
        return found

    def _measure(self, candidate: Candidate, text: str) -> _Trial | None:
        """The trial of a candidate, or None with the reason why it stays."""
        self.runs += 1
        if self.show is not None:
            self.show(self.runs, candidate.about)
        try:
            errors, size = self.meter.measure(text)
        except Refused as refused:
            self.reasons[candidate] = str(refused)
            return None
        last = self.rungs[-1].size
        saved = max(last.operations - size.operations, last.states - size.states)
        error = max(errors)
        if error + max(self.meter.own) > self.meter.tolerance:
            after = f" after {len(self.gone)} left out" if self.gone else ""
            self.reasons[candidate] = f"without it{after} the error is {error:.2g}"
            return None
        if saved <= 0:
            self.reasons[candidate] = f"nothing is saved without it (error {error:.2g})"
            return None
        return _Trial(candidate, errors, size, saved)


def simplify(
    source: Source,
    scene: str,
    tolerance: float,
    formulation: str = "",
    most: int = MOST_RUNS,
    show: Show | None = None,
) -> Ladder:
    """The ladder of models of a scene from the full one to the smallest within ``tolerance``.

    ``tolerance``: the largest error of a needed quantity on the output grid, relative to its largest magnitude there.

    Raises:
        nhc.diagnostics.SpecError: the spec has errors.
        nhc.simulate.opening.RunError: no such scene.
        NotMeasured: the full model's run is no reference.
    """
    draft = draft_of(source, find_scene(decode(source), scene))
    meter = meter_of(source, scene, formulation, tolerance)
    search = _Search(draft, meter, most, show)
    search.climb()
    ranges = ranges_of(source, draft.spec, meter)
    names = [parameter.name for parameter in draft.spec.parameters]
    return Ladder(
        system=draft.spec.system,
        scene=draft.scene.name,
        time=meter.job.time,
        points=POINTS,
        method=DEFAULT,
        compiled=meter.compiled,
        tolerance=tolerance,
        run_tolerance=TIGHTER * tolerance,
        parameters=tuple(zip(names, meter.job.start.p, strict=True)),
        needs=meter.needs,
        ranges=ranges,
        rungs=tuple(search.rungs),
        kept=tuple(Kept(candidate.about, reason) for candidate, reason in search.reasons.items()),
        runs=search.runs,
        most=most,
        bounded=search.bounded,
        spec=draft.without(search.gone, _about(search)),
        notes=meter.notes,
    )


def _about(search: _Search) -> str:
    """What is added to what the system is, so that files emitted from the reduced spec say it, too."""
    if not search.gone:
        return ""
    number = len(search.gone)
    count = "1 term or parameter left out" if number == 1 else f"{number} terms or parameters left out"
    return f"(approximate: {count}, good to {search.meter.tolerance:g} on the scene {search.draft.scene.name} only)"
