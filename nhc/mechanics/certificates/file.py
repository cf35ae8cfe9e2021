"""A certificate as JSON, and the check of one that was written before.

The text depends on the spec, nhc's version and the options alone.  Double-precision differences are rounded up to a power of
ten, since their last digits belong to a machine's libm; everything else is compared exactly.
"""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Mapping
from typing import Any

from nhc.mechanics.certificates.certificate import POINTS, Certificate, certify
from nhc.mechanics.system import System
from nhc.version import __version__

SCHEMA = "nhc.certificate/1"
_MOST_POINTS = 64  # that are written; more are looked at where signs are multiplied
_LARGEST_DIFFERENCE = 1e-6
"""Double precision may lose this much to a badly conditioned state; more is a defect, whatever the exact test says."""
_OTHER_MACHINE = 1e3  # times as large may the differences be where the certificate was written


def to_data(certificate: Certificate, spec_text: str) -> dict[str, Any]:
    """The certificate as a JSON tree."""
    return {
        "schema": SCHEMA,
        "nhc": __version__,
        "system": certificate.system,
        "spec_sha256": hash_text(spec_text),
        "holds": certificate.holds,
        "reference": "I.4.1",
        "degree": str(certificate.degree),
        "signed": certificate.signed,
        "log10_bound": math.ceil(certificate.log10_bound),
        "seed": certificate.seed,
        "count": len(certificate.points),
        "points": [{"prime": p.prime, "seed": p.seed, "sha256": p.digest} for p in certificate.points[:_MOST_POINTS]],
        "states": certificate.states,
        "formulations": [
            {
                "name": a.name,
                "equation": a.number,
                "accelerations": "equal" if a.accelerations else "different",
                "reactions": "equal" if a.reactions else "different",
                "double": {
                    "accelerations": power_of_ten(a.distance.accelerations),
                    "reactions": power_of_ten(a.distance.reactions),
                    "states": a.distance.states,
                },
            }
            for a in certificate.agreements
        ],
        "wrong_derivations": [
            {
                "name": r.name,
                "erratum": r.erratum,
                "told_apart": r.told_apart,
                "distance": f"{r.distance.accelerations:.1e}" if r.told_apart and certificate.is_far(r) else "0",
            }
            for r in certificate.rejections
        ],
    }


def write(certificate: Certificate, spec_text: str) -> str:
    """The certificate as text."""
    return json.dumps(to_data(certificate, spec_text), indent=2, ensure_ascii=False) + "\n"


def hash_text(text: str) -> str:
    """SHA-256 of a spec's text with line feeds as line ends."""
    return hashlib.sha256("\n".join(text.splitlines()).encode()).hexdigest()


def power_of_ten(x: float) -> str:
    """The least power of ten that is not below x and not below 1e-15 (rounding of a single operation is no finding)."""
    if not math.isfinite(x):
        return "inf"
    return f"1e{max(-15, math.ceil(math.log10(x))) if x > 0 else -15}"


def verify(text: str, system: System, spec_text: str) -> tuple[list[str], Certificate | None]:
    """What is wrong with a written certificate (nothing: it holds), and the certificate computed afresh.

    The points of the file are computed again and must give the same residues; further points, which the file does not know,
    must agree too.
    """
    try:
        old = json.loads(text)
    except (ValueError, RecursionError):  # lists within lists without end
        return ["it is not JSON"], None
    if not isinstance(old, dict) or old.get("schema") != SCHEMA:
        return [f"it is not a certificate of the kind `{SCHEMA}`"], None
    if old.get("spec_sha256") != hash_text(spec_text):
        return ["it was written for another text of the spec"], None
    points, seed = old.get("points"), old.get("seed")
    if not isinstance(points, list) or not 1 <= len(points) <= _MOST_POINTS or type(seed) is not int:
        return ["its points are missing or malformed"], None
    again = certify(system, min(len(points), POINTS), seed)
    fresh = certify(system, 1, seed + 1)
    found = differences(old, to_data(again, spec_text))
    if not is_sound(again) or not is_sound(fresh):
        found.append("the formulations do not agree")
    return found, again


def differences(old: Mapping[str, Any], new: Mapping[str, Any]) -> list[str]:
    """Where two certificates differ, beyond rounding; the version of nhc that wrote them may differ."""
    found = [f"`{key}` is no part of a certificate" for key in old if key not in new]
    if not isinstance(old.get("nhc"), str):
        found.append("`nhc`, the version that wrote it, is missing")
    for key in ("system", "holds", "reference", "degree", "signed", "log10_bound", "count", "points", "states"):
        if old.get(key) != new[key] or type(old[key]) is not type(new[key]):
            found.append(f"`{key}` is not what is found now")
    for key in ("formulations", "wrong_derivations"):
        before, now = old.get(key), new[key]
        if not isinstance(before, list) or len(before) != len(now):
            found.append(f"`{key}` is not the list that is found now")
            continue
        for a, b in zip(before, now, strict=True):
            if not isinstance(a, dict) or not _same(a, b):
                found.append(f"`{key}`: `{b['name']}` is not what is found now")
    return found


def _same(a: Mapping[str, Any], b: Mapping[str, Any]) -> bool:
    """Equal but for the last digits of double precision."""
    exact = [key for key in b if key not in ("double", "distance")]
    if any(a.get(key) != b[key] for key in exact) or a.keys() != b.keys():
        return False
    if "distance" in b:
        return _near(_number(a["distance"]), _number(b["distance"]))
    double, now = a["double"], b["double"]
    if not isinstance(double, dict) or double.keys() != now.keys() or double["states"] != now["states"]:
        return False
    sizes = [(_number(double[key]), _number(now[key])) for key in ("accelerations", "reactions")]
    return all(
        x is not None and y is not None and y <= max(10 * x, 1e-14) and 0 < x <= _OTHER_MACHINE * y for x, y in sizes
    )


def _near(x: float | None, y: float | None) -> bool:
    return x is not None and y is not None and abs(x - y) <= 0.2 * max(abs(x), abs(y))


def _number(text: object) -> float | None:
    try:
        number = float(text) if isinstance(text, str) else math.nan
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def is_sound(certificate: Certificate) -> bool:
    """Exact agreement, and double precision that does not contradict it."""
    sizes = [x for a in certificate.agreements for x in (a.distance.accelerations, a.distance.reactions)]
    return certificate.holds and all(x <= _LARGEST_DIFFERENCE for x in sizes)
