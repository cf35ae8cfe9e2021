"""Each gallery system with x = u + u^3/3 for a coordinate: the same motion by that map, another one by a wrong map."""

from __future__ import annotations

import re
from typing import Any

import pytest
import yaml

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.pairs.verdict import Comparison, compare_systems
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System
from tests.support import GALLERY, spec_path

MODEL = ("define", "T", "U", "V", "forces", "constraints", "holonomic", "quasi_velocities")


def spec_of(name: str) -> dict[str, Any]:
    """What the equations depend on, without scenes, and with the numbers of parameters alone."""
    read = yaml.safe_load(spec_path(name).read_text())
    values = {
        key: entry["value"] if isinstance(entry, dict) else entry
        for key, entry in (read.get("parameters") or {}).items()
    }
    found = {"nhc": 1, "system": name, "coordinates": list(read["coordinates"]), "parameters": values}
    return found | {key: read[key] for key in MODEL if key in read}


def put(part: Any, name: str) -> Any:
    if isinstance(part, dict):
        return {key: put(value, name) for key, value in part.items()}
    if isinstance(part, list):
        return [put(value, name) for value in part]
    return re.sub(rf"(?<!\w){name}(?!\w)", "(other + other^3/3)", str(part))


def in_other_coordinates(spec: dict[str, Any], name: str) -> dict[str, Any]:
    """The work of a force is the same: Q_u = Q_x dx/du."""
    made = {key: put(part, name) if key in MODEL else part for key, part in spec.items()}
    made["coordinates"] = ["other" if q == name else q for q in spec["coordinates"]]
    if name in made.get("forces", {}):
        made["forces"]["other"] = f"(1 + other^2)*({made['forces'].pop(name)})"
    return made


def compare(first: dict[str, Any], second: dict[str, Any], text: str) -> Comparison:
    def system(spec: dict[str, Any]) -> System:
        return resolve(decode(Source("s.yaml", yaml.safe_dump(spec, allow_unicode=True))))

    return compare_systems(system(first), system(second), (text,), ("A", "B"))


@pytest.mark.parametrize("name", [name for name in GALLERY if "rotation:" not in spec_path(name).read_text()])
def test_the_same_motion_in_other_coordinates(name: str) -> None:
    spec = spec_of(name)
    chosen = spec["coordinates"][-1]
    if any(f"d{q}" in str(spec.get("constraints")) for q in spec["coordinates"]):
        chosen = next(q for q in spec["coordinates"] if f"d{q}" not in str(spec["constraints"]))
    other = in_other_coordinates(spec, chosen)
    made = compare(spec, other, f"{chosen}=other + other^3/3")
    assert made.agrees
    assert made.is_sure
    assert made.measured.states >= 8
    assert made.largest < 1e-8
    wrong = compare(spec, other, f"{chosen}=other + other^3/2")
    assert not wrong.agrees
    assert not wrong.is_open
