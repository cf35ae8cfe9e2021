"""The benchmark of simulations: its interpolation, its systems, and its solvers against one another."""

from __future__ import annotations

import math

import numpy as np
import pytest

from benchmarks import simulation


def test_the_time_is_interpolated_geometrically() -> None:
    assert simulation.interpolate([(1e-8, 1.0), (1e-10, 4.0)]) == pytest.approx(2.0)
    assert simulation.interpolate([(1e-6, 1.0), (1e-8, 2.0), (1e-9, 3.0)]) == pytest.approx(3.0)
    assert simulation.interpolate([(1e-10, 5.0), (1e-12, 6.0)]) == 5.0
    assert simulation.interpolate([(1e-8, 1.0), (math.nan, 2.0)]) is None
    assert simulation.interpolate([]) is None


def test_the_error_is_the_worst_starts() -> None:
    reference = np.array([[1.0, 2.0], [4.0, -8.0]])
    assert simulation.find_error(reference + np.array([[0.0, 0.2], [0.4, 0.0]]), reference) == pytest.approx(0.1)


@pytest.mark.parametrize("system", ["sleigh", "trailers5"])
def test_solvers_agree(system: str, tmp_path: object, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NHC_CACHE", str(tmp_path))
    job = simulation.open_system(system)
    starts = np.array([job.y, [x + 0.01 for x in job.y]])
    ours = simulation.solve_nhc(simulation.load_model(job), job, 1e-12)(starts)
    for method in simulation.SCIPY:
        peer = simulation.solve_scipy(job, method, 1e-11)(starts)
        assert simulation.find_error(peer, ours) < 1e-7
