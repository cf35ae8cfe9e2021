"""What `check --explain` says of terms without velocities, among which is what lost its prime."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source
from nhc.pipeline import check

SPEC = """nhc: 1
system: s
coordinates: [x, y, theta]
parameters: {m: 1, I: 0.3, W: 2}
T: m/2*(x'^2 + y'^2) + I/2*theta'^2
constraints:
  - slip: -sin(theta)*x' + cos(theta)*y' = 0
"""


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("theta'^2", "theta'^2", "T: homogeneous quadratic in the velocities"),
        ("theta'^2", "theta'^2 + I*theta^2", "terms of lower degree (without velocities I*theta^2)"),
        ("theta'^2", "theta'^2 + I*theta'*W", "T: quadratic in the velocities, with terms of lower degree"),
        ("theta'^2", "theta'^2 + exp(x'*W)", "T: no polynomial of degree 2 in the velocities"),
        ("theta)*y' = 0", "theta)*y' = 0", "constraints: homogeneous, scleronomic;"),
        ("theta)*y' = 0", "theta)*y = 0", "constraints: affine (without velocities y*cos(theta) in `slip`);"),
        ("y' = 0", "y' = x*W\n  - x' = 3", "affine (without velocities -W*x in `slip` and in 1 more);"),
    ],
)
def test_terms_without_velocities_are_named(right: str, wrong: str, said: str) -> None:
    assert SPEC.count(right) == 1
    lines = check(Source("s.yaml", SPEC.replace(right, wrong)), explain=True).facts
    assert any(said in line for line in lines), lines
    assert said[-1] in ");" or said in lines
