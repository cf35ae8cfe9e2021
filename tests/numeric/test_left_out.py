"""Bricard's linkage with another of its six equations left out: the five that are left lose rank where nhc says so.

The six have rank 5 all along the motion: sum c_k d f_k = 0.  Without equation k the rank is 5 where c_k is not zero, and 4 where
it is: there the five allow more motions than one, whatever the formulation.  The motion and the least singular value of the five
are found here by themselves, with all six.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from nhc.diagnostics import Source
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.numeric.test_switching import BRICARD

HEAD, _, REST = BRICARD.partition("holonomic:\n")
BODY, _, SCENES = REST.partition("scenes:\n")
FIVE = [" ".join(text.split()).removesuffix(" = 0") for text in ("\n" + BODY).split("\n  - ")[1:]]
SIX = [*FIVE, "sin(a1)*sin(a3)*cos(a2) - cos(a1)*cos(a3) + cos(a5)"]
CODE = [compile(text, "closure", "eval") for text in SIX]


def closure(q: Any) -> Any:
    names = {f"a{k + 1}": x for k, x in enumerate(q)} | {"sin": np.sin, "cos": np.cos}
    return np.array([eval(code, names) for code in CODE])


def slopes(q: Any) -> Any:
    """By complex steps: exact to rounding."""
    return np.array([closure(q + 1e-30j * unit).imag / 1e-30 for unit in np.eye(6)]).T


def mass(q: Any) -> Any:
    found = np.diag([1.0, 2.0, 2.0 + np.cos(q[1]), 1.0, 3.0, 1.0])
    found[0, 1] = found[1, 0] = np.cos(q[0] - q[1]) / 3
    return found


def potential(q: Any) -> float:
    return float(np.sin(q[0]) / 2 + np.cos(q[2]) / 3)


@cache
def motion() -> tuple[Any, Any]:
    """Times and positions: one degree of freedom, its speed by the energy."""
    q = np.array([1.340199, 1.757925] * 3)
    for _ in range(10):
        rows = np.vstack([slopes(q), np.eye(6)[0]])
        q = q - np.linalg.lstsq(rows, [*closure(q), q[0] - 1.340199], rcond=1e-6)[0]
    assert abs(closure(q)).max() < 1e-12
    ahead = [np.linalg.svd(slopes(q))[2][-1]]
    start = ahead[0] * 2 / ahead[0][0]
    energy, ahead[0] = start @ mass(q) @ start / 2 + potential(q), start

    def rate(_: float, q: Any) -> Any:
        along = np.linalg.svd(slopes(q))[2][-1]
        along = along if along @ ahead[0] > 0 else -along
        ahead[0] = along * np.sqrt(2 * (energy - potential(q)) / (along @ mass(q) @ along))
        return ahead[0]

    times = np.linspace(0, 2.2, 1101)
    found = solve_ivp(rate, (0, 2.2), q, t_eval=times, rtol=1e-10, atol=1e-10, max_step=0.02)
    values = np.array([np.linalg.svd(slopes(x))[1] for x in found.y.T])
    assert values[:, 4].min() > 0.4 and values[:, 5].max() < 1e-8  # rank 5, never less
    return times, found.y.T


def first_loss(left_out: int) -> float:
    """The first time at which the least singular value of the five is nothing."""
    times, places = motion()
    rows = [i for i in range(6) if i != left_out]
    least = np.array([np.linalg.svd(slopes(q)[rows])[1][-1] for q in places])
    k = next(k for k in range(1, len(least) - 1) if least[k] < 0.01 and least[k - 1] >= least[k] <= least[k + 1])
    assert least[k] < 0.01 and np.median(least) > 0.05
    return float(times[k])


@pytest.mark.sample(4)
@pytest.mark.parametrize("formulation", ["voronec", "multipliers"])
@pytest.mark.parametrize(("left_out", "time"), [(0, 0.768), (1, 0.768), (2, 0.768), (4, 2.136)])
def test_a_run_ends_where_the_rest_loses_rank(left_out: int, time: float, formulation: str) -> None:
    assert first_loss(left_out) == pytest.approx(time, abs=0.004)
    equations = "".join(f"  - {text} = 0\n" for k, text in enumerate(SIX) if k != left_out)
    text = f"{HEAD}holonomic:\n{equations}scenes:\n{SCENES}".replace("time: [0, 1]", "time: [0, 3]")
    found = run(open_scene(Source("bricard.yaml", text), formulation=formulation), Settings("dop853", 1e-9, points=31))
    assert found.ended != "done" and found.outcome.t == pytest.approx(time, abs=0.005)
