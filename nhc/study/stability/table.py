"""A laboratory's findings as one table for people, and as a tree for programs."""

from __future__ import annotations

import math

from nhc.records import record
from nhc.study.linearization.field import SINGULAR
from nhc.study.linearization.linearize import Mode, modes, verdict
from nhc.study.linearization.sweep import Sweep
from nhc.study.stability.distance import NEAR, SINGULAR_THERE, judge_distance
from nhc.study.stability.drift import Drift
from nhc.study.stability.laboratory import Laboratory
from nhc.study.stability.motions import Motion


@record
class Row:
    """``what``, its ``value`` as text, and a ``remark``."""

    what: str
    value: str
    remark: str = ""


@record
class Section:
    """Rows under a title."""

    title: str
    rows: tuple[Row, ...]


def sections(lab: Laboratory) -> tuple[Section, ...]:
    """The table in its parts; parts without rows are left out."""
    unit = lab.bench.job.system.spec.time_unit
    per, of = (f" [1/{unit}]", f" [{unit}]") if unit else ("", "")
    parts = [
        Section("steady motion", tuple(_motion(lab.motion, unit)) if lab.motion else ()),
        *_swept(lab, unit),
        Section(f"eigenvalues along the scene{per}", tuple(_spectrum(lab, unit))),
        Section(f"largest stable step{of}: measured, predicted (-: no theory)", tuple(_limits(lab))),
        *(Section(title, tuple(rows)) for title, rows in _drifts(lab)),
        Section("sensitivity to the start", tuple(_sensitivity(lab))),
        Section("distance from singular points (0: singular)", tuple(_distances(lab))),
        Section("what `nhc run` does on this scene", tuple(Row(line, "") for line in lab.conduct)),
        Section("not done", tuple(Row(name, "", why) for name, why in lab.missing)),
    ]
    return tuple(part for part in parts if part.rows)


def lines(lab: Laboratory) -> list[str]:
    """The table as text."""
    bench = lab.bench
    head = f"{bench.equations.system.name}, scene {bench.job.scene.name}, {bench.formulation.name} ({bench.formulation.number})"
    end = time_of(bench.job.time[1], bench.job.system.spec.time_unit)
    found = [head, f"  time {bench.job.time[0]:.6g} to {end}, tolerance {bench.job.tolerance:.3g}"]
    found += [f"  {change}" for change in lab.changes]
    for part in sections(lab):
        found += ["", part.title]
        left = max(len(row.what) for row in part.rows)
        middle = max(len(row.value) for row in part.rows)
        found += [f"  {row.what:<{left}}  {row.value:<{middle}}  {row.remark}".rstrip() for row in part.rows]
    return found


_VERDICTS = {
    "none": "no eigenvalue is left to judge by",
    "marginal": "terms of higher order decide",
}


def time_of(value: float, unit: str, digits: int = 6) -> str:
    """A time with its unit, where the spec has one."""
    return f"{value:.{digits}g} {unit}".rstrip()


def with_unit(lab: Laboratory, name: str) -> str:
    """A parameter or quantity with its unit in brackets, as a title or an axis has it."""
    system = lab.bench.equations.system
    unit = {**{p.name: p.unit for p in system.spec.parameters}, **system.units}.get(name, "")
    return f"{name} [{unit}]" if unit not in ("", "1") else name


def _motion(found: Motion, unit: str) -> list[Row]:
    made = found.linearisation
    kind = "equilibrium" if made.steady.equilibrium else "steady motion"
    state = [
        f"{name} = {value:.6g}"
        for i, (name, value) in enumerate(zip(found.flow.names, made.steady.y, strict=True))
        if i not in found.model.cyclic and abs(value) > 1e-12
    ]
    rows = [Row(kind, "found", ", ".join(state) or "all of the state but the cyclic coordinates is 0")]
    told = verdict(made)
    if found.regularity > SINGULAR:
        rows.append(Row("verdict", "none" if told == "none" else f"{told} to first order", _VERDICTS.get(told, "")))
    eigenvalue = f"eigenvalue [1/{unit}]" if unit else "eigenvalue"
    rows += [Row(eigenvalue, _complex(mode), _kind(mode, unit)) for mode in modes(made) if mode.value.imag >= 0]
    rows.append(Row("found from", found.place))
    if found.lost:
        what = "not the motion of the scene" if found.halted else "taken for a disturbance"
        rows.append(Row("velocities lost", "; ".join(found.lost), f"{what}; `--hold` keeps such a velocity"))
    if found.absent:
        rows.append(Row("left out", ", ".join(found.absent), "parameters that are 0: more is steady without them"))
    if found.regularity <= SINGULAR:
        advice = "the coordinates are singular here (gimbal lock): take others, or another motion"
        rows = [rows[0], Row("verdict", "none", advice), Row("mass matrix", f"{found.regularity:.2g}", "0: singular")]
    if made.family:
        rows.append(Row("structural zeros", str(made.family), "directions of the family of steady motions"))
    return rows


def _complex(mode: Mode) -> str:
    x = mode.value
    real = x.real if mode.grows or mode.decays else 0.0
    return f"{real:.9g} +- {x.imag:.9g} i" if x.imag else f"{real:.9g}"


def _kind(mode: Mode, unit: str) -> str:
    x = mode.value
    period = f", period {time_of(2 * math.pi / x.imag, unit)}" if x.imag else ""
    if not (mode.grows or mode.decays):
        return f"neither grows nor decays{period}"
    return f"{'grows' if mode.grows else 'decays'} e-fold in {time_of(1 / abs(x.real), unit, 4)}{period}"


def _swept(lab: Laboratory, unit: str) -> list[Section]:
    motion = lab.motion
    if motion is None or motion.swept is None:
        return []
    return [Section(f"along {with_unit(lab, motion.along)}", tuple(_sweep(motion.swept, unit)))]


def _sweep(found: Sweep, unit: str) -> list[Row]:
    per = f" rad/{unit}" if unit else ""
    rows = [
        Row(
            f"crossing at {c.value + 0.0:.9g}",
            c.kind,
            f"more grow {'above' if c.unstable_above else 'below'}"
            + (f"; angular frequency {c.frequency:.6g}{per}" if c.frequency else ""),
        )
        for c in found.crossings
    ]
    rows += [
        Row(f"between {low:.6g} and {high:.6g}", "another number of eigenvalues grows", "sweep there more finely")
        for low, high in found.unlocated
    ]
    low, high = found.values[0], found.values[-1]
    rows = rows or [Row(f"from {low:.6g} to {high:.6g}", "no crossing")]
    rows += [
        Row(f"between {inside:.6g} and {outside:.6g}", "the steady motions end", f"none is found at {outside:.6g}")
        for inside, outside in found.ends
    ]
    rows += [Row(f"at {value:.6g}", "no steady motion found", why) for value, why in found.missing]
    left = found.leaves()
    return [*rows, Row(f"first at {left[0]:.6g}", "not the motion asked about", left[1])] if left else rows


def _spectrum(lab: Laboratory, unit: str) -> list[Row]:
    found, stiff = lab.spectrum, lab.stiffness
    if found is None or stiff is None:
        return []
    # adding zero takes the sign off a zero
    return [
        Row("fastest |lambda|", f"{found.fastest:.4g}", f"at t = {time_of(found.when, unit)}"),
        Row("fastest decay", f"{found.decay:.4g}", f"at {len(found.times)} equally spaced times"),
        Row("stiffness ratio", f"{stiff:.4g}", lab.tell_stiffness()),
    ]


def _step(value: float | None) -> str:
    if value is None:
        return "-"
    return "any" if math.isinf(value) else ("none found" if value == 0 else f"{value:.3g}")


def _limits(lab: Laboratory) -> list[Row]:
    return [
        Row(x.method, f"{_step(x.measured)}, {_step(x.predicted)}", f"beyond it {x.why}" if x.why else "")
        for x in lab.limits
    ]


def _drifts(lab: Laboratory) -> list[tuple[str, list[Row]]]:
    found = []
    unit = lab.bench.job.system.spec.time_unit
    for run in lab.runs:
        how = run.method if not run.step else f"{run.method}, steps of {time_of(run.step, unit, 3)}"
        rows = [
            Row(
                d.what,
                f"{_deviation(d.first)}, {_deviation(d.last)}",
                judge(d),
            )
            for d in run.drifts
        ]
        if run.why:
            rows.append(Row("ends", f"at t = {time_of(run.reached, unit)}", run.why))
        found.append((f"drift until t = {time_of(run.wanted, unit)} by {how}: first tenth, last tenth", rows))
    return found


def _deviation(value: float) -> str:
    return f"{value:.1e}" if value else "0"


def judge(drift: Drift) -> str:
    """Last over first in a number: that an error is bounded no run can show."""
    if math.isinf(drift.floor):
        return "not resolved: the power could not be integrated to the end"
    if not drift.resolved:
        return f"not resolved: the integral of the power errs by {drift.floor:.1e} itself"
    if max(drift.first, drift.last) <= drift.floor:
        told = "rounding"
    else:
        told = f"{float(f'{drift.last / drift.first:.2g}'):g} times as large" if drift.first else "from zero"
    return ("grows, " if drift.grows else "") + told + ("" if drift.relative else ", absolute")


def _sensitivity(lab: Laboratory) -> list[Row]:
    found = lab.sensitivity
    if found is None:
        return []
    unit = lab.bench.job.system.spec.time_unit
    law = found.law
    told = f"exp({law.rate:.3g} t)" if law.name == "exponential" else f"t^{law.rate:.2g}"
    told = told if law.rate > 0 else "nothing: it decays"
    told = told if law.name != "none" else "no law: no steady growth"
    horizon = "far beyond the scene" if math.isinf(law.horizon) else f"about t = {time_of(law.horizon, unit, 4)}"
    if math.isnan(law.horizon):
        horizon = "not known without a law" if law.name == "none" else "not known"
    fitted = (
        f"{'fitted' if law.name != 'none' else 'looked for'} from t = {law.since:.4g} to {time_of(law.until, unit, 4)}"
    )
    means = "when rounding of the start alone has grown to 1 % of the motion"
    return [
        Row("largest growth", f"{found.largest:.4g}", f"of relative perturbations, at t = {time_of(found.peak, unit)}"),
        Row("growth at the end", f"{found.norms[-1]:.4g}", f"{found.plain:.4g} in the state's own units"),
        Row("grows like", told, fitted),
        Row(
            "rounding reaches 1 %",
            horizon,
            f"extrapolated: {means}" if math.isfinite(law.horizon) and not law.seen else means,
        ),
    ]


def _distances(lab: Laboratory) -> list[Row]:
    unit = lab.bench.job.system.spec.time_unit
    sound = any(d.kind == "frame" and d.least >= NEAR for d in lab.distances)  # a divisor's scale may be far too large
    return [
        Row(
            d.what,
            "0" if d.least < SINGULAR_THERE else f"{d.least:.4g}",
            f"at t = {time_of(d.t, unit)}{judge_distance(d, sound)}",
        )
        for d in lab.distances
    ]
