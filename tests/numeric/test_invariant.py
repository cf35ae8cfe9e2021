"""T counted from one of its angles, where it does not depend on their directions: the same rates as without, by other means."""

from __future__ import annotations

import pytest

from benchmarks.systems import spec
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.mechanics.invariant import at_zero
from nhc.pipeline import compare
from tests.numeric.test_squares import operations, program_of, system_of
from tests.support import python_model

RODS = """nhc: 1
system: rods
coordinates: [a, b]
parameters: {m: 1.2, M: 0.8, l: 0.6, k: 0.9, c: 0.1}
define:
  x: l*sin(a)
  y: -l*cos(a)
  X: x + k*sin(b)
  Y: y - k*cos(b)
T: m/2*(x'^2 + y'^2) + M/2*(X'^2 + Y'^2)
V: 3*(1 - cos(b - a))
forces: {a: -c*a'}
"""
"""Absolute angles: T depends on their difference."""

SLIDER = """nhc: 1
system: rods
coordinates: [a, r]
parameters: {m: 1.2, I: 0.3, k: 2}
define: {x: r*cos(a), y: r*sin(a)}
T: m/2*(x'^2 + y'^2) + I/2*a'^2
V: k/2*(r - 1)^2 + k*r*cos(a)
"""
"""Only one angle, and a potential that does depend on it."""


@pytest.mark.parametrize(
    "text", [spec("flat_arm2"), spec("flat_arm3"), RODS, SLIDER], ids=["arm", "longer arm", "rods", "slider"]
)
def test_the_rates_are_the_same(text: str) -> None:
    text = text.replace("flat_arm2", "rods").replace("flat_arm3", "rods")
    assert at_zero(system_of(text)) is not None
    _, kept = compare(Source("rods.yaml", text))
    assert {holds for functions in kept.values() for holds in functions.values()} == {True}
    found, without = (program_of(system_of(text, WithoutRules(off))) for off in ([], ["directions"]))
    calls = [rhs.calls for program in (found, without) for rhs in program.functions]
    assert calls[0] <= calls[1] and operations(found) <= operations(without) + 20 * (calls[1] - calls[0])
    first, second = (
        python_model(render(program, "python", EmitOptions())["rods.py"], "rods") for program in (found, without)
    )
    y = [0.4 + 0.17 * k for k in range(len(first.STATE))]
    assert second.rhs(0.3, y) == pytest.approx(first.rhs(0.3, y), rel=1e-11, abs=1e-11)


def test_a_flat_arm_needs_the_angle_between_its_links_alone() -> None:
    (rhs,) = program_of(system_of(spec("flat_arm2"))).functions
    assert rhs.calls == 2


@pytest.mark.parametrize(
    "energy",
    [
        "(x'^2 + a'^2)/2 + cos(a)*x'*a'/3",  # a cart: the rail is a direction
        "(x'^2 + a'^2 + cos(a - x)^2*x'^2)/2 + cos(x)*x'*a'/3",
        "(1 + sin(a)^2)*x'^2 + a'^2",
        "x'^2 + a'^2",
    ],
)
def test_others_stay_as_they_are(energy: str) -> None:
    system = system_of(f"nhc: 1\nsystem: other\ncoordinates: [x, a]\nT: {energy}\n")
    assert at_zero(system) is None


def test_the_energy_is_the_same() -> None:
    system = system_of(RODS)
    turned = at_zero(system)
    assert turned is not None and are_equal(system.graph, [turned.T], [system.T])
