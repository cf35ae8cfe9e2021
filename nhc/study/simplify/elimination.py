"""Greedy backward elimination: leave out what costs the least error for what it saves, and look whether an exchange saves more."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from nhc.records import record
from nhc.study.simplify.abreast import measure_abreast
from nhc.study.simplify.candidate import Candidate
from nhc.study.simplify.draft import Draft
from nhc.study.simplify.ladder import NOT_MEASURED, NOTHING_SAVED, Size
from nhc.study.simplify.measure import Meter, Refused
from nhc.study.simplify.text import NoLimit, write_draft

MOST_EXCHANGES = 8
_NEAR = 1.2  # a stale score that is no more than this much better does not send a fresh one back into the queue
Show = Callable[[int, str], None]  # models measured so far, the candidate


class Bounded(Exception):
    """No more models may be measured."""


@record
class Trial:
    """A model without some candidates: its errors and size."""

    errors: tuple[float, ...]
    size: Size

    @property
    def error(self) -> float:
        return max(self.errors)


@dataclass
class Search:
    """What may go, what has gone, and why the rest stays."""

    draft: Draft
    meter: Meter
    most: int
    show: Show | None
    runs: int = 0
    turned_back: int = 0
    bounded: bool = False
    gone: list[Candidate] = field(default_factory=list)
    waiting: list[Candidate] = field(default_factory=list)
    reasons: dict[Candidate, str] = field(default_factory=dict)
    alone: dict[Candidate, Trial] = field(default_factory=dict)
    known: dict[str, Trial | str] = field(default_factory=dict)

    def search(self, candidates: Sequence[Candidate]) -> None:
        """Measure candidates alone, then drop the best again and again, then exchange.

        Where there are more candidates than may be measured, the dropping gets a third of the runs; what it does not use
        goes to more candidates, and so on.
        """
        self.known[write_draft(self.draft, self.draft.change([]))] = self.full
        try:
            self.waiting = left = self._list_different(candidates)
            while left and self.runs < self.most:
                rest = self.most - self.runs
                batch, left = left[: rest - rest // 3], left[rest - rest // 3 :]
                self.gone = self._drop(self.gone, self._measure_alone(batch))
            self.bounded |= bool(left)
            self._try_again()
            self._exchange()
        except Bounded:
            self.bounded = True
        for candidate in self.waiting if self.bounded else ():
            if candidate not in self.gone:
                again = " again" if candidate in self.alone else ""
                self.reasons.setdefault(candidate, f"{NOT_MEASURED}{again}: the bound on runs is reached")
        self.reasons = {c: reason for c, reason in self.reasons.items() if c not in self.gone}

    def stays(self, candidate: Candidate, gone: Sequence[Candidate]) -> bool:
        """Whether something of it is left behind what is gone."""
        try:
            return self.text([*gone, candidate]) != self.text(gone)
        except NoLimit:
            return True

    @property
    def full(self) -> Trial:
        return Trial(self.meter.own, self.meter.size)

    def text(self, gone: Sequence[Candidate]) -> str:
        return write_draft(self.draft, self.draft.change(gone))

    def trial(self, gone: Sequence[Candidate]) -> Trial | str:
        """The model without these, or why there is none.

        Raises:
            Bounded: it was not measured before, and no more may be.
        """
        try:
            text = self.text(gone)
        except NoLimit as error:
            return str(error)
        if text not in self.known:
            if self.runs >= self.most:
                raise Bounded
            self._count(gone[-1])
            self.known[text] = self._measure(text)
        return self.known[text]

    def _count(self, candidate: Candidate) -> None:
        self.runs += 1
        if self.show is not None:
            self.show(self.runs, candidate.about)

    def _measure(self, text: str) -> Trial | str:
        try:
            return Trial(*self.meter.measure(text))
        except Refused as refused:
            return str(refused)

    def fits(self, trial: Trial) -> bool:
        return trial.error + max(self.meter.own) <= self.meter.tolerance

    def _list_different(self, candidates: Sequence[Candidate]) -> list[Candidate]:
        """Those that leave something out, in the order in which they are measured; of several that leave the same text one."""
        nothing = self.text([])
        # the first of those that leave the same text, with the rank of the best
        alike: dict[str, tuple[int, Candidate]] = {}
        for candidate in candidates:
            try:
                text = self.text([candidate])
            except NoLimit as error:
                self.reasons[candidate] = str(error)
                continue
            if text != nothing:
                rank, same = alike.get(text, (candidate.rank, candidate))
                alike[text] = (min(rank, candidate.rank), same)
        return [candidate for _, candidate in sorted(alike.values(), key=lambda entry: entry[0])]

    def _measure_alone(self, candidates: Sequence[Candidate]) -> list[Candidate]:
        """Those that may go by themselves."""
        found = []
        texts = [self.text([candidate]) for candidate in candidates]
        for candidate, text, trial in zip(candidates, texts, measure_abreast(self._measure, texts), strict=True):
            self._count(candidate)
            self.known[text] = trial
            if isinstance(trial, str):
                self.reasons[candidate] = trial
            elif not self.fits(trial):
                self.reasons[candidate] = f"without it the error is {trial.error:.2g}"
            else:
                self.alone[candidate] = trial
                found.append(candidate)
        return found

    def score(self, trial: Trial, before: Trial) -> float:
        """Error for each operation saved; infinite where nothing is."""
        saved = before.size.work - trial.size.work
        return trial.error / saved if saved > 0 else math.inf

    def _drop(self, gone: list[Candidate], queue: Sequence[Candidate]) -> list[Candidate]:
        """More and more of the queue, the best first; scores are taken again only when they decide."""
        now = self._sure(gone)
        scores = {candidate: self.score(self.alone[candidate], self.full) for candidate in queue}
        idle: list[Candidate] = []
        while scores:
            best = min(scores, key=lambda c: scores[c])
            del scores[best]
            if self.text([*gone, best]) == self.text(gone):  # it went with another one
                continue
            try:
                trial = self.trial([*gone, best])
            except Bounded:
                self.bounded = True
                break
            if isinstance(trial, str) or not self.fits(trial):
                if isinstance(trial, Trial):
                    trial = f"without it after {len(gone)} left out the error is {trial.error:.2g}"
                self.reasons[best] = trial
                continue
            score = self.score(trial, now)
            if score == math.inf:
                idle.append(best)
            elif score > _NEAR * min(scores.values(), default=math.inf):
                scores[best] = score
            else:
                gone, now = [*gone, best], trial
                scores.update((c, self.score(self.alone[c], self.full)) for c in idle)
                idle = []
        for candidate in idle:
            trial = self.alone[candidate]
            self.reasons[candidate] = f"{NOTHING_SAVED} (error {trial.error:.2g})"
        return gone

    def _try_again(self) -> None:
        """What was no model by itself may be one behind what is gone: inertia of a coordinate that is held has nothing to do."""
        for candidate in self.waiting:
            refused = isinstance(self.known.get(self.text([candidate])), str)
            if not refused or candidate in self.gone or not self.stays(candidate, self.gone):
                continue
            trial, now = self.trial([*self.gone, candidate]), self._sure(self.gone)
            if isinstance(trial, str):
                self.reasons[candidate] = trial
            elif not self.fits(trial):
                self.reasons[candidate] = f"without it after {len(self.gone)} left out the error is {trial.error:.2g}"
            elif self.score(trial, now) == math.inf:
                self.reasons[candidate] = f"{NOTHING_SAVED} (error {trial.error:.2g})"
            else:
                self.alone[candidate] = trial
                self.gone = [*self.gone, candidate]

    def forbid(self, candidate: Candidate, gone: list[Candidate]) -> None:
        """Keep one for good; behind what is ``gone`` the rest is dropped anew, as far as the runs go."""
        del self.alone[candidate]
        reason = self.reasons[candidate]
        try:
            self.gone = self._drop(gone, [other for other in self.alone if other not in gone])
        except Bounded:  # what is left of an exchange was never measured by itself
            self.gone, self.bounded = gone, True
        self.reasons = {c: why for c, why in self.reasons.items() if c not in self.gone} | {candidate: reason}

    def _sure(self, gone: Sequence[Candidate]) -> Trial:
        trial = self.trial(gone)
        assert isinstance(trial, Trial)
        return trial

    def _exchange(self) -> None:
        """Put one back, forbid it, and see whether the rest can lose more than it saved; the last ones first."""
        for candidate in list(reversed(self.gone))[:MOST_EXCHANGES]:
            others = [c for c in self.alone if c not in self.gone]
            if not others:
                return
            if candidate not in self.gone:
                continue
            base = [c for c in self.gone if c is not candidate]
            start = self.trial(base)
            if isinstance(start, str) or not self.fits(start):
                continue
            reasons = dict(self.reasons)
            made = self._drop(base, others)
            if self._sure(made).size.work < self._sure(self.gone).size.work:
                self.reasons[candidate] = "put back: others that do not go with it save more"
                self.gone, self.turned_back = made, self.turned_back + 1
            else:
                self.reasons = reasons
