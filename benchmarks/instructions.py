"""Instructions per right-hand side: nhc beside hand-written C.  ``python -m benchmarks.instructions [SYSTEM...]``."""

from __future__ import annotations

import sys
from dataclasses import dataclass

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
    """Instructions per call of nhc's C in the spec's variants (style, quasi-velocities given) and of the hand's."""

    system: str
    nhc: dict[tuple[str, bool], float]
    hand: float | None


def measure(system: str, variants: tuple[tuple[str, bool], ...] = VARIANTS) -> Counts:
    """Count nhc in each variant of the spec that is a different text, and the hand-written C where there is one."""
    counts: dict[tuple[str, bool], float] = {}
    seen: dict[str, float] = {}
    values = parameters(system)
    for style, velocities in variants:
        sources = nhc_sources(system, style, velocities=velocities)
        key = "".join(sources.files.values())
        if key not in seen:
            coordinates, kept = names(system, style, velocities=velocities)
            seen[key] = count_instructions(sources, states(system, len(coordinates) + len(kept)), values)
        counts[style, velocities] = seen[key]
    hand = hand_sources(system)
    coordinates, kept = names(system)
    size = len(coordinates) + len(kept)
    return Counts(system, counts, count_instructions(hand, states(system, size), values) if hand else None)


def main(systems: tuple[str, ...] = ()) -> None:
    heads = ["positions", "expanded", "positions, no u", "expanded, no u"]
    print(f"{'system':12}" + "".join(f"{head:>24}" for head in heads) + f"{'hand':>10}   (instructions, ratio to hand)")
    for system in systems or SYSTEMS:
        counts = measure(system)
        cells = []
        for variant in VARIANTS:
            value = counts.nhc[variant]
            ratio = f" {value / counts.hand:6.3f}" if counts.hand else " " * 7
            cells.append(f"{value:17.1f}{ratio}")
        print(f"{system:12}" + "".join(cells) + (f"{counts.hand:10.1f}" if counts.hand else f"{'-':>10}"), flush=True)


if __name__ == "__main__":
    main(tuple(sys.argv[1:]))
