"""The benchmark systems: their specs decode, and the hand-written C agrees with nhc's at random states."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path

import pytest

from benchmarks.chart import draw_scaling
from benchmarks.models import Compiled, difference, hand_sources, names, nhc_sources, parameters, source, states
from benchmarks.systems import STYLES, drop_section, spec
from nhc.language import decode
from nhc.mechanics.resolving.resolve import resolve

SYSTEMS = ("sleigh", "disk", "trailers3", "snake3", "pendulum3", "bicycle")
SIZES = {
    "sleigh": (3, 1),
    "disk": (5, 2),
    "trailers3": (7, 5),
    "snake3": (5, 3),
    "pendulum3": (4, 0),
    "bicycle": (9, 6),
}


@pytest.mark.parametrize("style", STYLES)
@pytest.mark.parametrize("name", SYSTEMS)
def test_spec_decodes_with_the_stated_size(name: str, style: str) -> None:
    for velocities in (True, False):
        system = resolve(decode(source(name, style, velocities=velocities)))
        assert (len(system.q), len(system.constraints)) == SIZES[name]
        assert bool(system.spec.quasi_velocities) == (velocities and name != "pendulum3")


def test_a_section_is_dropped_with_its_lines_and_nothing_else() -> None:
    text = spec("sleigh")
    assert drop_section(text, "quasi_velocities").count("\n") == text.count("\n") - 3
    assert drop_section(text, "coordinates") == text.replace("coordinates: [x, y, theta]\n", "")


@pytest.mark.parametrize("name", SYSTEMS)
def test_hand_written_c_agrees(name: str, tmp_path: Path) -> None:
    hand = hand_sources(name)
    assert hand is not None
    by_hand = Compiled(hand, tmp_path / "hand", ("-std=c99", "-O1", "-Wall", "-Wextra", "-Werror"))
    values = parameters(name)
    size = sum(map(len, names(name)))
    for style in STYLES[:1] if name == "bicycle" else STYLES:
        emitted = Compiled(nhc_sources(name, style), tmp_path / style, ("-std=c99", "-O0"))
        for y in states(name, size):
            assert difference(by_hand(0.0, y, values), emitted(0.0, y, values)) < 1e-12


@pytest.mark.parametrize("name", ["sleigh", "disk", "trailers2", "snake3", "pendulum2"])
def test_peer_kane_agrees(name: str, tmp_path: Path) -> None:
    """The model that SymPy is timed on is the same system: equal accelerations at an admissible state."""
    from benchmarks.peers.kane import derive

    made, values, (coordinates, kept) = derive(name), parameters(name), names(name)
    y = states(name, len(coordinates) + len(kept), 1)[0]
    expected = Compiled(nhc_sources(name), tmp_path, ("-std=c99", "-O0"))(0.0, y, values)
    # SymPy keeps the dependent speeds, too: sideways none, and the rates of the axles or of the disk's centre
    turns = [rate for q, rate in zip(coordinates, expected, strict=False) if q.startswith("theta")]
    dependent = {
        "sleigh": [0.0],
        "disk": expected[:2],
        "trailers2": [0.0, *turns],
        "snake3": [0.0, *turns[1:]],
        "pendulum2": [],
    }[name]
    symbols = [*made.coordinates, *made.speeds, *made.parameters]
    point = dict(zip(symbols, [*y, *dependent, *values], strict=True))
    mass, forcing = made.mass_matrix.xreplace(point).evalf(), made.forcing.xreplace(point).evalf()
    rates = made.rates.xreplace(point).evalf()
    found = [*rates, *mass.LUsolve(forcing)[: len(kept)]]
    assert difference([float(x) for x in found], expected) < 1e-12


def test_names_of_lines_that_end_together_stand_apart() -> None:
    """A family of exactly linear cost ends where the line of linear cost does, and another one on it."""
    sizes = (5, 10, 100)
    drawn = draw_scaling({"one": {n: 2e-3 * n for n in sizes}, "other": {n: 2.01e-3 * n for n in sizes}})
    places = sorted(float(y) for y in re.findall(r'y="([0-9.]+)" fill="#\w+">(?:one|other|linear)<', drawn))
    assert len(places) == 3
    assert min(b - a for a, b in pairwise(places)) >= 15
