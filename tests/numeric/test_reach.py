"""`auto` does not solve for velocities that a mechanism's motion cannot be solved for somewhere on its way."""

from __future__ import annotations

import math

import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, emit, model
from tests.support import python_model

HEAD = "nhc: 1\nsystem: s\n"
DOUBLE = """coordinates: [x1, y1, x2, y2]
parameters: {l: 1, k: 1, g: 9.81}
T: (x1'^2 + y1'^2 + x2'^2 + y2'^2)/2
V: g*(y1 + y2)
holonomic:
  - x1^2 + y1^2 = l^2
  - (x2 - x1)^2 + (y2 - y1)^2 = k^2
scenes: {a: {initial: {x1: 0.6, y1: -0.8, x2: 1.6, y2: -0.8}, time: [0, 5]}}
"""
SPHERE = """coordinates: [x, y, z]
parameters: {l: 5, g: 9.81}
T: (x'^2 + y'^2 + z'^2)/2
V: g*z
holonomic: [x^2 + y^2 + z^2 = l^2]
dependent: [z]
scenes: {a: {initial: {x: 3, z: -4}, time: [0, 5]}}
"""
ROD = """coordinates: [x1, y1, x2, y2]
parameters: {l: 0.8}
T: (x1'^2 + y1'^2 + x2'^2 + 2*y2'^2)/2
constraints:
  - (x2 - x1)*(y1' + y2') - (y2 - y1)*(x1' + x2') = 0
holonomic:
  - (x2 - x1)^2 + (y2 - y1)^2 = l^2
scenes: {a: {initial: {x2: l}, time: [0, 5]}}
"""
CRANK = """coordinates: [f, b, x]
parameters: {r: 0.2, l: 0.7}
T: (f'^2 + b'^2 + x'^2)/2
holonomic:
  - x = r*cos(f) + l*cos(b)
  - r*sin(f) = l*sin(b)
scenes: {a: {initial: {x: r + l}, time: [0, 5]}}
"""


@pytest.mark.parametrize("text", [DOUBLE, SPHERE])
def test_multipliers_where_every_choice_is_singular_on_the_way(text: str) -> None:
    """A pendulum in Cartesian coordinates hangs straight down where its x' cannot be solved for."""
    formulation = model(Source("s.yaml", HEAD + text)).formulation
    assert formulation.name == "multipliers" and "can reach" in formulation.reason


@pytest.mark.parametrize("text", [ROD, CRANK])
def test_what_stays_regular_on_all_positions_is_kept(text: str) -> None:
    """The rod's determinant is its length squared; a crank shorter than its rod keeps cos(b) from zero."""
    assert model(Source("s.yaml", HEAD + text)).formulation.name in ("euler-lagrange", "voronec", "chaplygin")


def test_the_emitted_double_pendulum_hangs_straight() -> None:
    """At rest below each other with one speed: x1'' = x2'' = 0, and both ends are pulled towards their pivots."""
    (text,) = emit(Source("s.yaml", HEAD + DOUBLE), "python").values()
    module = python_model(text, "hanging")
    u, w = 0.7, -0.4
    y = module.state(0.0, [0, -1, 0, -2], [u, 0, w, 0])
    assert module.accelerations(0.0, y) == pytest.approx([0, u**2, 0, u**2 + (w - u) ** 2], abs=1e-12)
    assert all(map(math.isfinite, module.rhs(0.0, y)))


@pytest.mark.parametrize("count", [5, 9, 12])
@pytest.mark.parametrize("axes", ["xy", "xyz"])
def test_long_chains_of_rods_between_points_hang_at_rest(count: int, axes: str) -> None:
    """Too many coordinates for a walk, and for multipliers: the velocities across each rod are free, and no y' alone."""
    names = [[f"{axis}{k}" for axis in axes] for k in range(count)]
    before = [["0"] * len(axes), *names]
    rods = [
        " + ".join(f"({a} - {b})^2" for a, b in zip(own, last, strict=True))
        for own, last in zip(names, before, strict=False)
    ]
    text = HEAD + "\n".join(
        [
            f"coordinates: [{', '.join(x for own in names for x in own)}]",
            "T: (" + " + ".join(f"{x}'^2" for own in names for x in own) + ")/2",
            f"V: 9.81*({' + '.join(own[1] for own in names)})",
            "holonomic:",
            *(f"  - {rod} = 1" for rod in rods),
            f"scenes: {{a: {{initial: {{{', '.join(f'x{k}: {k + 1}' for k in range(count))}}}, time: [0, 1]}}}}",
            "",
        ]
    )
    source = Source("s.yaml", text)
    free = model(source).formulation.frame
    assert free is not None
    written = python_model(emit(source, "python", Options(only=("rhs",)))["s.py"], "rods")
    hanging = [float(-k - 1) if axis == "y" else 0.0 for k in range(count) for axis in axes]
    rates = written.rhs(0.0, [*hanging, *[0.0] * len(free.free)])
    assert max(map(abs, rates)) == 0.0
