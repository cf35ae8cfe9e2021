"""Instructions per right-hand side: nhc beside hand-written C, CasADi's C and PyDy's C (where those are installed).

``python -m benchmarks.instructions [SYSTEM...]``
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from importlib.util import find_spec

from benchmarks.capped import CAP, run_capped
from benchmarks.counting import count_instructions
from benchmarks.models import hand_sources, names, nhc_sources, parameters, states

SYSTEMS = (
    "sleigh",
    "disk",
    "trailers5",
    "trailers10",
    "trailers20",
    "snake5",
    "snake10",
    "snake20",
    "pendulum5",
    "pendulum10",
    "pendulum20",
    "bicycle",
)
VARIANTS = (("positions", True), ("expanded", True), ("positions", False), ("expanded", False))


@dataclass(frozen=True)
class Counts:
    """Instructions per call of nhc's C in the spec's variants (style, quasi-velocities given) and of the others' C;
    None where there is none (not written, not installed, not done within the cap).
    """

    system: str
    nhc: dict[tuple[str, bool], float]
    hand: float | None
    casadi: float | None
    pydy: float | None

    @property
    def main(self) -> float:
        return self.nhc["positions", True]


def measure(system: str, variants: tuple[tuple[str, bool], ...] = VARIANTS) -> Counts:
    """Count nhc in each variant of the spec, and what stands beside it."""
    values = parameters(system)
    counts: dict[tuple[str, bool], float] = {}
    seen: dict[str, float] = {}
    for style, velocities in variants:
        sources = nhc_sources(system, style, velocities=velocities)
        key = "".join(sources.files.values())
        if key not in seen:
            size = sum(map(len, names(system, style, velocities=velocities)))
            seen[key] = count_instructions(sources, states(system, size), values)
        counts[style, velocities] = seen[key]
    points = states(system, sum(map(len, names(system))))
    hand = hand_sources(system)
    return Counts(
        system,
        counts,
        count_instructions(hand, points, values) if hand else None,
        _count_casadi(system, points, values) if find_spec("casadi") else None,
        _count_pydy(system, values) if find_spec("pydy") else None,
    )


def _count_casadi(system: str, points: list[list[float]], values: list[float]) -> float:
    from benchmarks.peers.casadi_c import casadi_sources

    return count_instructions(casadi_sources(system), points, values)


def _count_pydy(system: str, values: list[float]) -> float | None:
    from benchmarks.peers.kane_bicycle import VALUES
    from benchmarks.peers.pydy_c import pydy_sources

    made = run_capped(lambda: pydy_sources(system), CAP).result
    if made is None:
        return None
    sources, coordinates, speeds = made
    # its bicycle has other coordinates and parameters; small lean, pitch and steer are regular there
    given = list(VALUES) if system == "bicycle" else values
    points = states(system, coordinates + speeds)
    if system == "bicycle":
        points = [[x / 4 for x in point] for point in points]
    return count_instructions(sources, points, given)


def main(systems: tuple[str, ...] = ()) -> None:
    heads = ["positions", "expanded", "positions, no u", "expanded, no u"]
    print(f"{'instructions':12}" + "".join(f"{head:>18}" for head in [*heads, "hand", "CasADi", "PyDy + LU"]))
    for system in systems or SYSTEMS:
        counts = measure(system)
        base = counts.hand
        cells = [counts.nhc[variant] for variant in VARIANTS] + [counts.hand, counts.casadi, counts.pydy]
        print(f"{system:12}" + "".join(_cell(value, base) for value in cells), flush=True)


def _cell(value: float | None, base: float | None) -> str:
    if value is None:
        return f"{'-':>18}"
    return f"{value:10.1f}" + (f" {value / base:7.3f}" if base else " " * 8)


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
