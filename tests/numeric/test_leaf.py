"""What motions do on the level f(q, t) = 0 that they are on, and on no other one."""

from __future__ import annotations

import numpy as np
import pytest

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import rank
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.frame import Frame, coordinate_frame
from nhc.mechanics.linearize import hidden_leaf
from nhc.mechanics.properties.conserved import find_conserved
from nhc.mechanics.properties.integrability import classify
from nhc.mechanics.properties.integrals import find_position_integrals
from nhc.mechanics.properties.leaf import Leaf, leaf_of
from nhc.mechanics.regular.regularity import choose_dependent
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.system import System


def build(text: str) -> System:
    return resolve(decode(Source("leaf.yaml", text)))


def frame_of(system: System) -> Frame:
    return coordinate_frame(system, choose_dependent(system).dependent)


NEUMANN = """nhc: 1
system: neumann
coordinates: [x, y, z]
parameters: {a: 1, b: 2, c: 3.5}
T: (x'^2 + y'^2 + z'^2)/2
V: (a*x^2 + b*y^2 + c*z^2)/2
holonomic: [EQUATION]
outputs:
  F: x^2 + (x*y' - y*x')^2/(a - b) + (x*z' - z*x')^2/(a - c)
  G: y^2 + (y*x' - x*y')^2/(b - a) + (y*z' - z*y')^2/(b - c)
  H: z^2 + (x*y' - y*x')^2/(a - b)
"""


@pytest.mark.parametrize(
    ("equation", "outputs"),
    [
        ("x^2 + y^2 + z^2 = 1", ("F", "G")),
        ("1 - x^2 = y^2 + z^2", ("F", "G")),
        ("x^2 + y^2 + z^2 = 2", ()),
        ("(x^2 + y^2 + z^2 - 1)*(x^2 + y^2 + z^2 - 2) = 0", ()),
    ],
)
def test_what_is_constant_on_one_level_of_the_constraints(equation: str, outputs: tuple[str, ...]) -> None:
    """Uhlenbeck's integrals of Neumann's problem, dF/dt = 2 x x' (1 - r^2): constant on the unit sphere only (Moser 1980)."""
    system = build(NEUMANN.replace("EQUATION", equation))
    assert find_conserved(system, frame_of(system)).outputs == outputs


@pytest.mark.parametrize(
    ("coordinates", "equation", "row", "hidden", "texts"),
    [
        ("x, y, th, s", "s = 0", "sin(s*th)*x' - cos(s*th)*y' = 0", 2, ["s", "y"]),
        ("x, y, th, s", "s = 1", "sin(s*th)*x' - cos(s*th)*y' = 0", 1, None),
        ("x, y, z", "x = 0", "y' - x*z' = 0", 2, ["x", "y"]),
        ("x, y, z, s", "s^2 = s", "y' - s*x*z' = 0", 1, None),  # s is 0 or 1: a level of two leaves
        ("x, y, z, s", "s*(s - 1)*(s - 2) = 0", "y' - s*x*z' = 0", 1, None),
        ("x, y, z, s", "s^2 + x^2 = 4", "y' - (s^2 + x^2 - 4)*z*x' = 0", 2, ["x^2 + s^2 - 4", "y"]),
    ],
)
def test_a_level_on_which_rows_are_integrable(
    coordinates: str, equation: str, row: str, hidden: int, texts: list[str] | None
) -> None:
    """A sleigh whose heading is locked goes straight; where a constraint holds on one of two leaves only, it is not claimed."""
    names = coordinates.split(", ")
    squares = " + ".join(f"{name}'^2/2" for name in names)
    system = build(
        f"nhc: 1\nsystem: locked\ncoordinates: [{coordinates}]\nT: {squares}\n"
        f'holonomic: ["{equation}"]\nconstraints: ["{row}"]\n'
    )
    found = classify(system)
    assert found.hidden == hidden
    if texts is not None:
        integrals = find_position_integrals(system, frame_of(system), found.hidden, found.closed)
        assert [i.text for i in integrals] == texts


ENGEL = """nhc: 1
system: engel
coordinates: [x, y, z, w, u]
T: (x'^2 + y'^2 + z'^2 + w'^2 + u'^2)/2
V: (x^2 + y^2)/2
constraints:
  - z' = y*x'
  - w' = z*x'
  - u' = y*x'
"""


def test_a_leaf_is_spanned_by_brackets_of_brackets() -> None:
    """Engel's distribution (2, 3, 4) in five coordinates: u - z is hidden in two rows neither of which is integrable, and w is
    reached by a bracket with a bracket only.
    """
    system = build(ENGEL)
    leaf = hidden_leaf(system, frame_of(system))
    assert (leaf.dimension, leaf.normals) == (4, ())
    g = system.graph
    assert rank(g, leaf.fields) == 4
    values = evaluate(
        g, [x for field in leaf.fields for x in field], dict(zip(system.q, (0.3, 0.7, 0.2, 0.5, 0.4), strict=True))
    )
    rows = np.array([float(x) for x in values]).reshape(-1, system.n)
    assert np.allclose(rows @ [0, 0, 1, 0, -1], 0)


LOOP = """nhc: 1
system: loop
coordinates: [x, y, a, b]
T: (x'^2 + y'^2 + a'^2 + b'^2)/2
define: {X: x + cos(a), Y: x + 2*cos(b)}
constraints: ["-sin(a)*x' + cos(a)*y' = 0"]
holonomic: [X = Y]
"""


def test_a_floating_loop_does_not_contain_its_place() -> None:
    """X - Y holds the coordinate x, which cancels: the equation is not one for it, and no point of a field is on its level."""
    system = build(LOOP)
    frame = frame_of(system)
    assert leaf_of(system) == Leaf(())
    assert classify(system, frame).hidden == 1
