"""The smallest singular value of the constraints: known values, and numpy's."""

from __future__ import annotations

import math

import numpy as np
import pytest

from nhc.algebra.evaluate import evaluate
from nhc.language import decode, read
from nhc.mechanics.properties.singular import smallest_singular_value
from nhc.mechanics.regular.trials import trial_points
from nhc.mechanics.resolving.resolve import resolve
from tests.support import GALLERY, spec_path


@pytest.mark.parametrize("name", GALLERY)
def test_against_numpy(name: str) -> None:
    system = resolve(decode(read(str(spec_path(name)))))
    if not system.constraints:
        assert smallest_singular_value(system, {}) == math.inf
        return
    flat = [a for form in system.constraints for a in form.coefficients]
    for place in trial_points(system)[-3:]:
        matrix = np.array(evaluate(system.graph, flat, place), float).reshape(system.l, system.n)
        expected = np.linalg.svd(matrix, compute_uv=False)
        assert abs(smallest_singular_value(system, place) - expected[-1]) < 1e-7 * expected[0]


def test_the_snakeboard_loses_rank() -> None:
    system = resolve(decode(read(str(spec_path("snakeboard")))))
    place = trial_points(system)[0]
    turned = dict(zip(system.q_names, system.q, strict=True))
    for angle, expected in ((math.pi / 2, 0.0), (math.pi / 2 - 1e-3, 7.1e-4)):
        place |= {turned["p_b"]: angle, turned["p_f"]: angle}
        assert abs(smallest_singular_value(system, place) - expected) < 1e-5
