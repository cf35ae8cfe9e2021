"""Which formulation and method a chart recommends for which accuracy, and why, in words."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

from nhc.records import record
from nhc.study.chart.case import Cost, Result, Study
from nhc.study.chart.words import LANGUAGE_NAMES, duration, setting, spell_power

EQUAL = 1.05
"""Times whose ratio is less than this count as equal."""
TARGETS = (1e-3, 1e-6, 1e-9, 1e-12)


@record
class Advice:
    """``best`` is the fastest case that reaches ``target`` (None: none does); ``text`` says it with its reasons."""

    target: float
    best: Result | None
    text: str


def advise(study: Study, targets: Sequence[float] = TARGETS) -> tuple[Advice, ...]:
    """One recommendation for each accuracy, from the study's own numbers alone."""
    return tuple(_advise(study, target) for target in targets)


def fastest(results: Iterable[Result], target: float, floor: float) -> Result | None:
    """The fastest case that reaches the target together with the reference's own error ``floor``; of equals the first line's.

    A case that reaches it by luck does not count: all tighter cases of its line must reach it as well.
    """
    lines: dict[tuple[str, str, str], list[Result]] = {}
    for result in results:
        if not result.failed:
            lines.setdefault(result.case.series, []).append(result)
    good: list[Result] = []
    for line in lines.values():
        for result in sorted(line, key=lambda r: r.case.tolerance):
            if not result.error + floor <= target:
                break
            good.append(result)
    least = min((r.best for r in good), default=0.0)
    return next((r for r in results_in_order(lines, good) if r.best <= EQUAL * least), None)


def results_in_order(lines: Mapping[tuple[str, str, str], object], good: Sequence[Result]) -> list[Result]:
    """By the order in which the study has its lines, the fastest of each first: of equals the study's first is taken."""
    order = {series: k for k, series in enumerate(lines)}
    return sorted(good, key=lambda r: (order[r.case.series], r.best, r.error))


def _advise(study: Study, target: float) -> Advice:
    floor = study.reference.error
    own = [r for r in study.results if r.case.language in ("c", "python")]
    best = fastest(own, target, floor)
    if all(r.error == 0.0 for r in own if not r.failed) and best is not None:
        return Advice(target, None, "nothing to choose by: every run gives what is needed without any error")
    if best is None:
        return Advice(
            target, None, f"no case of this chart reaches {spell_power(target)}{_why_none(study, own, target)}"
        )
    text = (
        f"{_spell_case(best)}: error {_spell_error(best, floor)}, {duration(best.best)} ({best.calls} right-hand sides)"
    )
    return Advice(target, best, "; ".join([text, *_reasons(study, best, target)]))


def _spell_case(result: Result) -> str:
    case = result.case
    return f"{case.formulation} with {case.method} in {LANGUAGE_NAMES[case.language]} at {setting(case)}"


def _spell_error(result: Result, floor: float) -> str:
    """The error, or a bound where the reference does not resolve it."""
    return f"at most {result.error + floor:.1e}" if result.unresolved else f"{result.error:.1e}"


def _why_none(study: Study, own: Sequence[Result], target: float) -> str:
    """The reference, or what comes nearest; and how many runs there is nothing of."""
    floor = study.reference.error
    if not floor < target:
        return f": the reference itself is known to {floor:.1e} only"
    nearest = min((r for r in own if not r.failed), key=lambda r: r.error, default=None)
    reason = ""
    if nearest is not None:
        reason = f": the least error is {_spell_error(nearest, floor)}, of {_spell_case(nearest)}"
        if nearest.error + floor <= target:
            reason += ", and not all finer runs of that line reach it"
    failed = sum(bool(r.failed) for r in study.results)
    return reason + (f" ({failed} of {len(study.results)} cases failed)" if failed else "")


def _reasons(study: Study, best: Result, target: float) -> list[str]:
    """Against the best other method, formulation, language and peer, one change at a time."""
    case, floor = best.case, study.reference.error

    def rival(same: tuple[bool, bool, bool]) -> Result | None:
        """The fastest among the cases that share with the best what ``same`` marks and differ in the rest."""
        chosen = [
            r
            for r in study.results
            if r.case.language in ("c", "python")
            and all((a == b) == s for a, b, s in zip(r.case.series, case.series, same, strict=True))
        ]
        return fastest(chosen, target, floor)

    twins = [cost.formulation for cost in study.costs if cost.twin == case.formulation]
    reasons = [f"{_list_words(twins)} {'have' if len(twins) > 1 else 'has'} the same code"] if twins else []
    method = rival((True, False, True))
    if method is not None:
        work = f"{method.calls} right-hand sides" if method.calls != best.calls else "as many right-hand sides"
        reasons.append(f"{method.case.method} takes {_times(method, best)} ({work})")
    form = rival((False, True, True))
    if form is not None:
        reasons.append(f"{form.case.formulation} takes {_times(form, best)}{_why(study.costs, best, form)}")
    language = rival((True, True, False))
    if language is not None:
        reasons.append(f"{LANGUAGE_NAMES[language.case.language]} takes {_times(language, best)}")
    for name in dict.fromkeys(r.case.language for r in study.results if r.case.language not in ("c", "python")):
        peer = fastest([r for r in study.results if r.case.language == name], target, floor)
        if peer is not None:
            whose = f"{LANGUAGE_NAMES.get(name, name)}'s {peer.case.method}"
            reasons.append(
                f"{whose}{' on the same C' if name in ('scipy', 'sundials') else ''} takes {_times(peer, best)}"
            )
    return reasons


def _why(costs: Sequence[Cost], best: Result, other: Result) -> str:
    """The price of one right-hand side and their number, where they differ; what speaks for the slower one is said to do so."""
    known = {cost.formulation: cost for cost in costs}
    a, b = known.get(best.case.formulation), known.get(other.case.formulation)
    if a is None or b is None:
        return ""
    c = best.case.language == "c"
    first, second = (a.c, b.c) if c else (a.python, b.python)
    parts = []
    if math.isfinite(first) and math.isfinite(second):
        less = other.calls * second * EQUAL < best.calls * first and other.best > best.best
        parts.append(f"{'though ' * less}a right-hand side takes {duration(second)} against {duration(first)}")
    if a.states != b.states:
        parts.append(f"{b.states} states against {a.states}")
    if other.calls != best.calls:
        parts.append(f"{other.calls} right-hand sides")
    return f" ({', '.join(parts)})" if parts else ""


def _times(a: Result, b: Result) -> str:
    ratio = a.best / b.best
    if ratio * EQUAL < 1:
        return f"{ratio:.2f} times as long"
    if ratio < EQUAL:
        return "as long"
    return f"{ratio:.0f} times as long" if ratio >= 9.95 else f"{ratio:.1f} times as long"


def _list_words(words: list[str]) -> str:
    """As ``a, b and c``."""
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)
