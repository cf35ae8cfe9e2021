"""The laboratory's numbers as a tree for JSON."""

from __future__ import annotations

import math
from typing import Any

from nhc.study.linearization.field import SINGULAR
from nhc.study.linearization.linearize import eigenvalues, verdict
from nhc.study.stability.drift import LongRun
from nhc.study.stability.laboratory import Laboratory
from nhc.study.stability.motions import Motion
from nhc.study.stability.sensitivity import Sensitivity


def tree(lab: Laboratory) -> dict[str, Any]:
    """All numbers; infinite ones are null."""
    bench = lab.bench
    return {
        "system": bench.equations.system.name,
        "scene": bench.job.scene.name,
        "formulation": bench.formulation.name,
        "compiled": bench.model.compiled,
        "time": list(bench.job.time),
        "changes": list(lab.changes),
        "steady": _motion_tree(lab.motion) if lab.motion else None,
        "spectrum": _spectrum_tree(lab),
        "steps": [
            {
                "method": x.method,
                "order": x.order,
                "measured": _finite(x.measured),
                "predicted": _finite(x.predicted),
                "why": x.why,
            }
            for x in lab.limits
        ],
        "drift": [_drift_tree(run) for run in lab.runs],
        "sensitivity": _growth_tree(lab.sensitivity),
        "distances": [{"what": d.what, "kind": d.kind, "least": d.least, "t": d.t} for d in lab.distances],
        "conduct": list(lab.conduct),
        "missing": [{"study": name, "why": why} for name, why in lab.missing],
    }


def _spectrum_tree(lab: Laboratory) -> dict[str, float | None] | None:
    found = lab.spectrum
    if found is None:
        return None
    sizes = {"decay": found.decay, "slowest": found.slowest, "stiffness": lab.stiffness}
    return {"fastest": found.fastest, "when": found.when, **sizes}


def _drift_tree(run: LongRun) -> dict[str, Any]:
    quantities = [
        {"what": d.what, "kind": d.kind, "relative": d.relative, "first": d.first, "last": d.last, "grows": d.grows}
        | {"resolved": d.resolved}
        for d in run.drifts
    ]
    return {
        "method": run.method,
        "step": run.step,
        "reached": run.reached,
        "wanted": run.wanted,
        "why": run.why,
        "quantities": quantities,
    }


def _growth_tree(found: Sensitivity | None) -> dict[str, Any] | None:
    if found is None:
        return None
    return {
        "growth": found.norms[-1],
        "largest": found.largest,
        "peak": found.peak,
        "plain": found.plain,
        "law": found.law.name,
        "rate": _finite(found.law.rate),
        "since": found.law.since,
        "until": found.law.until,
        "horizon": _finite(found.law.horizon),
        "seen": found.law.seen,
    }


def _finite(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None


def _motion_tree(found: Motion) -> dict[str, Any]:
    made = found.linearisation
    data: dict[str, Any] = {
        "kind": "equilibrium" if made.steady.equilibrium else "steady motion",
        "formulation": found.formulation.name,
        "state": dict(zip(found.flow.names, made.steady.y, strict=True)),
        "verdict": verdict(made) if found.regularity > SINGULAR else None,
        "regularity": found.regularity,
        "lost": list(found.lost),
        "structural_zeros": made.family,
        "eigenvalues": [{"real": x.real, "imag": x.imag} for x in eigenvalues(made)],
    }
    if found.swept is not None:
        data["crossings"] = [
            {"value": c.value, "kind": c.kind, "frequency": c.frequency, "up": c.unstable_above}
            for c in found.swept.crossings
        ]
        data["unlocated"] = [{"low": low, "high": high} for low, high in found.swept.unlocated]
        data["missing"] = [{"value": value, "reason": why} for value, why in found.swept.missing]
        data["ends"] = [{"with": inside, "without": outside} for inside, outside in found.swept.ends]
        left = found.swept.leaves()
        data["left"] = {"value": left[0], "what": left[1]} if left else None
    return data
