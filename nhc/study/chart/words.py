"""How charts and their reports spell times, powers of ten, settings and languages."""

from __future__ import annotations

import math

from nhc.study.chart.case import Case, Study

LANGUAGE_NAMES = {
    "c": "C",
    "python": "Python",
    "scipy": "SciPy",
    "sundials": "SUNDIALS",
    "heyoka": "heyoka",
    "diffrax": "diffrax",
}


def describe_question(study: Study) -> str:
    """What is needed, and over which time."""
    return f"Quantities: {', '.join(study.needs)}; t from {study.time[0]:g} to {study.time[1]:g}"


def setting(case: Case) -> str:
    """The tolerance or the step of a case."""
    return f"steps of {case.step:.3g}" if case.step > 0 else f"tolerance {spell_power(case.tolerance)}"


def name_case(case: Case) -> str:
    """Formulation, method, language and setting."""
    return f"{case.formulation}, {case.method}, {LANGUAGE_NAMES.get(case.language, case.language)}, {setting(case)}"


def spell_power(x: float) -> str:
    """A power of ten as an axis spells it: 1e-6."""
    mantissa, exponent = f"{x:.1e}".split("e")
    return f"{mantissa.removesuffix('.0')}e{int(exponent)}"


def duration(seconds: float) -> str:
    """A time with its unit, two or three digits."""
    if not math.isfinite(seconds):
        return "-"
    for size, unit in ((1.0, "s"), (1e-3, "ms"), (1e-6, "µs")):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"
