"""Instructions per right-hand side of the whole gallery, nhc beside CasADi on the same spec.

``python -m benchmarks.gallery [SPEC...]``
"""

from __future__ import annotations

import random
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.counting import count_instructions
from benchmarks.models import Compiled, Sources, difference
from benchmarks.systems import GALLERY
from nhc.language import read
from nhc.mechanics.values import parameter_value
from nhc.pipeline import Model, Options, emit, model
from nhc.program.planning.planner import Planner

_STATES = 8
_NEAR = 1e-9  # what nhc and the peer may differ by


@dataclass(frozen=True)
class Count:
    """Instructions per call."""

    name: str
    nhc: float
    casadi: float

    @property
    def ratio(self) -> float:
        return self.nhc / self.casadi


def measure(paths: Sequence[Path] = ()) -> Iterator[Count]:
    """Specs whose velocities are independent, one after the other.

    Raises:
        RuntimeError: the peer's values are others.
    """
    from benchmarks.peers.casadi_spec import casadi_sources

    for path in paths or tuple(GALLERY.values()):
        source = read(str(path))
        made = model(source)
        if made.formulation.name == "multipliers":
            continue
        ours = Sources(f"{made.system.name}_rhs", emit(source, "c", Options(only=("rhs",))))
        theirs = casadi_sources(made)
        points, values = _points(made), [parameter_value(parameter.value) for parameter in made.spec.parameters]
        _compare(made.system.name, ours, theirs, points, values)
        counts = (count_instructions(sources, points, values) for sources in (ours, theirs))
        yield Count(made.system.name, *counts)


def _points(made: Model) -> list[list[float]]:
    """Random states, away from zero."""
    draw = random.Random(f"nhc {made.system.name}")
    size = made.system.n + len(Planner(made.equations, made.formulation).kept_forms())
    return [[draw.uniform(0.2, 1.2) for _ in range(size)] for _ in range(_STATES)]


def _compare(name: str, ours: Sources, theirs: Sources, points: list[list[float]], values: list[float]) -> None:
    with tempfile.TemporaryDirectory() as folder:
        first, second = Compiled(ours, Path(folder) / "ours"), Compiled(theirs, Path(folder) / "theirs")
        worst = max(difference(second(0.0, y, values), first(0.0, y, values)) for y in points)
    if not worst < _NEAR:
        raise RuntimeError(f"{name}: nhc and CasADi differ by {worst:.2g}")


def main(names: Sequence[str] = ()) -> None:
    for made in measure([Path(name) if name.endswith(".yaml") else GALLERY[name] for name in names]):
        print(f"{made.name:28}{made.nhc:9.1f}{made.casadi:9.1f}{made.ratio:8.3f}", flush=True)


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
