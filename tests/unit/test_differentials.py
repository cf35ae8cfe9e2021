"""The differential of a defined position is its velocity times dt."""

from __future__ import annotations

import pytest

from nhc.algebra.exact.modular import is_zero
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.resolving.expressions import Resolver, define_names

SPEC = """nhc: 1
system: s
coordinates: [x, y, theta]
rotation: [R]
parameters: {a: 0.3, w: 2}
define: {X: x + a*cos(theta)*sin(w*t), Y: y*X}
T: (x'^2 + y'^2 + theta'^2 + R_w1^2 + R_w2^2 + R_w3^2)/2
"""


@pytest.mark.parametrize(
    ("form", "rate"),
    [
        ("sin(theta)*dX - cos(theta)*dy - a*dt = 0", "sin(theta)*X' - cos(theta)*y' - a"),
        ("(dY + dX)/(2 + x) - a*dtheta = 0", "(Y' + X')/(2 + x) - a*theta'"),
        ("dX - a*dR_z3 = 0", "X' - a*R_z3'"),
    ],
)
def test_a_form_in_defined_positions(form: str, rate: str) -> None:
    source = Source("s.yaml", f'{SPEC}constraints: ["{form}"]\nquasi_velocities: {{u: "{rate}"}}\n')
    build = Resolver(decode(source))
    define_names(build)
    (row,) = build.spec.constraints
    quasi = build.spec.quasi_velocities[0]
    assert row.form == "differential"
    assert is_zero(build.graph, build.graph.sub(build.node(row.left), build.node(quasi.value)))
