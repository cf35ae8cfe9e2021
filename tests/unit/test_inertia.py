"""Which matrices of inertia are those of bodies: every cloud of masses has one, and none is beyond a cloud by a sign."""

from __future__ import annotations

import random

import pytest

from nhc.diagnostics import Source
from nhc.pipeline import check

SPEC = """
nhc: 1
system: cloud
coordinates: [x, y, z]
rotation: {{R: {{velocities: [p, q, r]}}}}
bodies:
  cloud: {{at: [x, y, z], rotation: R, mass: 1, inertia: {{xx: {xx}, yy: {yy}, zz: {zz}, yz: {yz}, xz: {xz}, xy: {xy}}}}}
"""


def _second_moments(draw: random.Random, points: int) -> list[list[float]]:
    """sum of m x x^T of masses anywhere; of one or two of them it is singular, as of a rod or a plate."""
    places = [[draw.gauss(0, 1) for _ in range(3)] for _ in range(points)]
    masses = [draw.uniform(0.1, 2) for _ in range(points)]
    return [[sum(m * x[i] * x[j] for m, x in zip(masses, places, strict=True)) for j in range(3)] for i in range(3)]


def _codes(moments: list[list[float]]) -> list[str]:
    trace = sum(moments[i][i] for i in range(3))
    entries = {
        f"{'xyz'[i]}{'xyz'[j]}": repr((trace if i == j else 0) - moments[i][j]) for i in range(3) for j in range(i, 3)
    }
    return [d.code for d in check(Source("cloud.yaml", SPEC.format(**entries)), explain=False).diagnostics]


@pytest.mark.parametrize("points", [1, 2, 3, 8])
@pytest.mark.parametrize("seed", range(5))
def test_masses_anywhere_make_a_body(points: int, seed: int) -> None:
    moments = _second_moments(random.Random(f"{seed} of {points}"), points)
    assert "W0427" not in _codes(moments)
    k = seed % 3
    moments[k][k] -= 1.01 * moments[k][k]  # no sum of m x^2 is negative
    assert "W0427" in _codes(moments)
