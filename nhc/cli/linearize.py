"""``nhc linearize``: a steady motion, the matrix about it, its eigenvalues, and where they cross the axis."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from nhc.cli.options import (
    SweepRange,
    formulation_option,
    hold_option,
    json_option,
    set_option,
    spec_argument,
    sweep_option,
    verb,
)
from nhc.cli.specs import open_spec, take_first_scene
from nhc.cli.terminal import Exit, Failure, put_json, put_text
from nhc.diagnostics import quote, several

if TYPE_CHECKING:
    from nhc.study.linearization.linearize import Mode
    from nhc.study.linearization.motion import Findings
    from nhc.study.linearization.sweep import Sweep


_OTHERS = (
    "velocities that turn with a body (x' and y', rates of a quaternion) are not steady here: leave out `--formulation`"
)
LONGEST = 100  # characters of an entry's expression that are read at a glance


@verb(
    "linearize",
    "nhc linearize rolling_disk --about 'theta=pi/2, w_n=3'",
    "nhc linearize rolling_disk --about theta=pi/2 --sweep w_n=1:4:13",
)
@spec_argument
@click.option(
    "--about",
    metavar="MOTION",
    default="",
    help="Where to start looking: a scene, or values such as `theta=pi/2, w_n=3`; default: the first scene.",
)
@click.option("--scene", metavar="NAME", default="", help="A scene to start from, as `--about NAME`.")
@set_option
@hold_option
@sweep_option()
@formulation_option
@json_option
def command(
    spec: str,
    about: str,
    scene: str,
    settings: tuple[str, ...],
    holds: tuple[str, ...],
    sweep: SweepRange | None,
    formulation: str | None,
    as_json: bool,
) -> int:
    """Linearize about an equilibrium or a steady motion.

    Finds the steady motion of SPEC that is nearest to MOTION, prints the matrix of small perturbations and its
    eigenvalues.  A motion is steady when nothing changes but cyclic coordinates, on which no rate depends, or when it is at
    rest in axes that move along a symmetry, as in a bend.
    """
    source = open_spec(spec)
    if about and scene:
        raise click.UsageError(
            "`--scene` says where to start, and `--about` too: give one of them, and other values by `--set`"
        )
    from nhc.language import decode
    from nhc.mechanics.starts.scenes import check_scene_name
    from nhc.pipeline import Options, linearize
    from nhc.study.linearization.found import NotSteady
    from nhc.study.linearization.motion import Request

    if scene:
        check_scene_name(decode(source), scene)
    about = about or scene or take_first_scene(source, "to start from", "give values, such as `--about x=0`")
    try:
        request = Request(about, settings, holds, sweep)
        found = linearize(source, request, Options(formulation=formulation or ""))
    except NotSteady as error:
        reached = f"; the rates that should vanish reach {error.residual:.3g}" if math.isfinite(error.residual) else ""
        if reached and error.entries:
            reached += f" ({'those' if len(error.entries) > 1 else 'that'} of {quote(error.entries[:3])})"
        advice = [error.advice, *([_OTHERS] if formulation == "voronec" and math.isfinite(error.residual) else [])]
        raise Failure(f"{error}{reached}", advice, exit=Exit.NUMERICAL) from error
    notes = _notes(found, formulation or "")
    if as_json:
        put_json("nhc.linearize/1", describe(found, notes))
    else:
        put_text("\n".join([*_motion_lines(found), "", *_matrix_lines(found), "", *_eigenvalue_lines(found, notes)]))
        if found.swept is not None and sweep is not None:
            put_text("\n".join(["", *_sweep_lines(sweep[0], found.swept)]))
    return 0


def describe(found: Findings, notes: Sequence[str]) -> dict[str, Any]:
    """The findings as a tree: numbers in full, the state by names."""
    from nhc.study.linearization.linearize import eigenvalues, verdict
    from nhc.study.linearization.turns import list_rates

    flow, made = found.flow, found.linearisation
    names = [flow.names[i] for i in made.rest]
    tree: dict[str, Any] = {
        "system": flow.system.name,
        "formulation": found.formulation.name,
        "kind": "equilibrium" if made.steady.equilibrium else "steady motion",
        "state": dict(zip(flow.names, made.steady.y, strict=True)),
        "where": _added(found),
        "parameters": dict(zip((p.name for p in flow.system.spec.parameters), found.model.p, strict=True)),
        "residual": made.steady.residual,
        "steps": made.steady.steps,
        "cyclic": [flow.names[i] for i in found.model.cyclic],
        "along": [{"entries": list(entries), "rate": rate} for entries, rate in list_rates(made.steady.turning, flow)],
        "entries": names,
        "matrix": made.full.tolist(),
        "admissible": made.basis.tolist(),
        "structural_zeros": made.family,
        "turns": made.turns,
        "family": [dict(zip(names, row, strict=True)) for row in made.null.tolist()],
        "eigenvalues": [{"real": x.real, "imag": x.imag} for x in eigenvalues(made)],
        "verdict": verdict(made),
        "symbolic": [list(row) for row in found.paper],
        "symbolic_at": dict(found.held),
        "absent": list(found.absent),
        "notes": [*notes, *([f"no symbolic matrix: {found.why}"] if found.why else [])],
    }
    if found.swept is not None:
        points = zip(found.swept.values, found.swept.points, strict=True)
        tree["sweep"] = [
            {"value": v, "eigenvalues": [{"real": x.real, "imag": x.imag} for x in eigenvalues(p)]} for v, p in points
        ]
        tree["crossings"] = [
            {"value": c.value, "kind": c.kind, "frequency": c.frequency, "error": c.error, "up": c.unstable_above}
            for c in found.swept.crossings
        ]
        tree["unlocated"] = [{"low": low, "high": high} for low, high in found.swept.unlocated]
        tree["missing"] = [{"value": value, "reason": why} for value, why in found.swept.missing]
        tree["ends"] = [{"with": inside, "without": outside} for inside, outside in found.swept.ends]
    return tree


def _added(found: Findings) -> dict[str, str]:
    """What the velocities are that nhc made."""
    from nhc.mechanics.added_forms import describe_added

    return describe_added(found.flow.system, found.formulation.frame)


def _motion_lines(found: Findings) -> list[str]:
    from nhc.study.linearization.turns import list_rates

    flow, steady = found.flow, found.linearisation.steady
    kind = "equilibrium" if steady.equilibrium else "steady motion"
    head = f"{flow.system.name}, {found.formulation.name} ({found.formulation.number}): {kind}"
    lines = [head, f"  the rates that must be zero are zero {_short(steady.residual)}"]
    width = max(len(name) for name in flow.names)
    for i, (name, value) in enumerate(zip(flow.names, steady.y, strict=True)):
        lines.append(
            f"  {name:{width}} = {value if abs(value) > 1e-13 else 0:.15g}{'  (cyclic)' if i in found.model.cyclic else ''}"
        )
    lines += [f"  where {name} = {text}" for name, text in _added(found).items()]
    together: dict[str, list[str]] = {}
    for entries, rate in list_rates(steady.turning, flow):
        together.setdefault(f"{rate:.6g}", []).append(entries[0] if len(entries) == 1 else f"({', '.join(entries)})")
    if together:
        moving = "; ".join(f"{', '.join(names)} at {rate}" for rate, names in together.items())
        lines.append(f"  at rest in axes that move with it: {moving}")
    return lines


def _short(value: float) -> str:
    """A residual: its size matters, its digits are rounding (`--json` has them)."""
    return "to rounding" if value < 1e-11 else f"to {10.0 ** math.ceil(math.log10(value)):.0e}"


def _matrix_lines(found: Findings) -> list[str]:
    made = found.linearisation
    names = [found.flow.names[i] for i in made.rest]
    lines = [f"matrix of perturbations of ({', '.join(names)}), entries that are not zero"]
    entries, long = [], False
    for r, row in enumerate(names):
        for c, column in enumerate(names):
            value = float(made.full[r, c])
            if value:
                paper = found.paper[r][c] if found.paper else ""
                long = long or len(paper) > LONGEST
                shown = f"  {paper}" if 0 < len(paper) <= LONGEST else ""
                entries.append((f"{row} <- {column}", f"{value:.12g}", shown))
    left, right = (max((len(e[k]) for e in entries), default=0) for k in (0, 1))
    lines += [f"  {label:{left}}  {value:>{right}}{paper}".rstrip() for label, value, paper in entries]
    if found.paper:
        lines.append("  as expressions at " + ", ".join(f"{name} = {text}" for name, text in found.held))
        if long:
            lines.append(f"  expressions of more than {LONGEST} characters are left out; `--json` has them")
    else:
        lines.append(f"  no expressions: {found.why}")
    return lines


def _eigenvalue_lines(found: Findings, notes: Sequence[str]) -> list[str]:
    from nhc.study.linearization.linearize import modes, verdict

    made = found.linearisation
    left_out = len(made.rest) - len(made.basis) - made.turns
    lines = ["eigenvalues"]
    for mode in modes(made):
        lines.append("  " + _eigenvalue(mode))
    if made.family:
        lines.append(f"  {several(made.family, 'structural zero')}, left out: the steady motions form a family")
    if left_out:
        lines.append(
            f"  {several(left_out, 'direction')} left out: forbidden by the constraints, including hidden ones"
        )
    if made.turns:
        lines.append(
            f"  {several(made.turns, 'direction')} left out: turns or shifts of the whole motion, on which nothing depends"
        )
    lines += [f"  note: {note}" for note in notes]
    told = {
        "stable": "stable to first order",
        "unstable": "unstable",
        "marginal": "marginal: undecided to first order",
        "none": "none: no eigenvalue is left to judge by",
    }
    return [*lines, f"verdict: {told[verdict(made)]}"]


def _notes(found: Findings, formulation: str) -> list[str]:
    """What could not be told, and that this may not be the motion that was meant; ``formulation`` is what was asked for."""
    from nhc.study.linearization.asked import list_outside

    notes = list(found.linearisation.notes)
    out = [found.flow.names[i] for i in list_outside(found.model, found.linearisation.steady.y)]
    if out:
        notes.append(
            f"outside its range in the spec: {quote(out)}; start nearer to a motion within it, if there is one"
        )
    lost = "; ".join(found.lost)
    if found.absent:
        one = len(found.absent) == 1
        are = "is 0, and is" if one else "are 0, and are"
        notes.append(
            f"{quote(found.absent)} {are} left out of the equations: more is steady for {'this value' if one else 'these values'}"
        )
    if found.halted:
        notes.append(f"not the motion asked about: {lost}; `--hold` keeps such a velocity")
    elif found.lost:
        notes.append(f"taken for a disturbance: {lost}; `--hold` keeps such a velocity")
    left = found.swept.leaves() if found.swept and not found.halted else None
    if left:
        notes.append(
            f"the sweep leaves the motion asked about, first at {left[0]:.10g}: {left[1]}; `--hold` keeps such a velocity"
        )
    system = found.flow.system
    turns = bool(system.rotations) or any(form.equation is None for form in system.constraints)
    if found.halted and formulation == "voronec" and turns:
        notes.append(_OTHERS)
    return notes


def _eigenvalue(mode: Mode) -> str:
    real, x = f"{_clean(mode) + 0.0:.12g}", mode.value
    if x.imag == 0:
        return f"{real:>20}"
    text = f"{real:>20} {'+' if x.imag > 0 else '-'} {abs(x.imag):.12g} i"
    return f"{text}  damping ratio {-_clean(mode) / abs(x) + 0.0:.6g}, period {2 * math.pi / abs(x.imag):.6g}"


def _clean(mode: Mode) -> float:
    """The real part; rounding shows as zero."""
    return mode.value.real if mode.grows or mode.decays else 0.0


def _sweep_lines(name: str, swept: Sweep) -> list[str]:
    from nhc.study.linearization.linearize import modes

    lines = [f"along {name}: number of growing and of all eigenvalues, the largest real part"]
    for value, point in zip(swept.values, swept.points, strict=True):
        found = modes(point)
        largest = f"{max(_clean(mode) for mode in found) + 0.0:.10g}" if found else "none"
        lines.append(f"  {value:<14.10g} {sum(mode.grows for mode in found)} of {len(found)}  {largest}")
    lines += [f"  {value:<14.10g} no steady motion found: {why}" for value, why in swept.missing]
    lines += [
        f"the steady motions end between {name} = {inside:.10g}, where there is one, and {outside:.10g}"
        for inside, outside in swept.ends
    ]
    lines.append("crossings")
    for c in swept.crossings:
        period = f", frequency {c.frequency:.10g}" if c.frequency else ""
        side = "above" if c.unstable_above else "below"
        lines.append(f"  {name} = {c.value:.13g}: {c.kind}{period}; more of them grow {side}")
    lines += [
        f"  between {low:.10g} and {high:.10g}: another number of eigenvalues grows; sweep there more finely"
        for low, high in swept.unlocated
    ]
    return lines if swept.crossings or swept.unlocated else [*lines, "  none"]
