"""How fast neighbouring motions part: the flow's derivative by the start, segment by segment, and a law for its growth.

Each segment's derivative comes from central differences of runs that start beside the reference; their product is the
derivative over the whole scene, also where it is too large for differences at its end.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from nhc.records import record
from nhc.simulate.task import DONE
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench

_SEGMENTS = 40
_NUDGE = 3e-6  # of a component's size: central differences of a run at 1e-13 are good to about 1e-7
_ROUNDING = 2.0**-53
_EXPLAINED = 0.5  # of the variation of log norm: a line that explains less says nothing of what comes


@record
class Sensitivity:
    """``norms`` at ``times``: by how much admissible perturbations of the start are multiplied at most, each component relative to
    its size in the scene; ``plain`` is the last one in the state's own units.

    ``law`` is "exponential" (norm ~ exp(rate t)), "power" (norm ~ t^rate) or "none"; ``horizon`` the time at which rounding of the
    start has grown to one per cent of the motion, by this law (infinite beyond 1e6 scenes).  Without a law neither is a number.
    """

    times: tuple[float, ...]
    norms: tuple[float, ...]
    plain: float
    law: str
    rate: float
    horizon: float


def sensitivity(bench: Bench) -> Sensitivity:
    """The growth of perturbations along the scene.

    Raises:
        ArithmeticError: the scene or a run beside it fails.
    """
    picked = [round(k * (len(bench.times) - 1) / _SEGMENTS) for k in range(_SEGMENTS + 1)]
    basis = admissible(bench)
    scale, product = bench.sizes, basis
    times, norms = [bench.times[0]], [1.0]
    for first, last in pairwise(picked):
        product = _segment(bench, first, last) @ product
        times.append(bench.times[last])
        norms.append(_norm(product, basis, scale))
    law, rate, horizon = fit(times, norms)
    plain = float(np.linalg.norm(product, 2)) if product.size else 0.0
    return Sensitivity(tuple(times), tuple(norms), plain, law, rate, horizon)


def _norm(product: Matrix, basis: Matrix, scale: Matrix) -> float:
    """The largest stretching of relative perturbations inside the basis."""
    if not product.size:
        return 0.0
    before = basis / scale[:, None]
    _, upper = np.linalg.qr(before)
    return float(np.linalg.norm((product / scale[:, None]) @ np.linalg.inv(upper), 2))


def admissible(bench: Bench) -> Matrix:
    """Columns that span the perturbations of the start which keep to the constraints on the state."""
    size = len(bench.job.y)
    kept = [*bench.group("residual"), *bench.group("position")]
    if not kept:
        return np.eye(size)
    slopes = np.zeros((len(kept), size))
    for i in range(size):
        h = 1e-6 * bench.sizes[i]
        pair = [list(bench.job.y), list(bench.job.y)]
        pair[0][i] -= h
        pair[1][i] += h
        low, high = bench.quantities([bench.times[0]] * 2, pair)[:, kept]
        slopes[:, i] = (high - low) / (2 * h)
    _, sizes, right = np.linalg.svd(slopes)
    rank = int(np.sum(sizes > 1e-7 * max(1.0, float(sizes.max(initial=0.0)))))
    return np.asarray(right[rank:].T)


def _segment(bench: Bench, first: int, last: int) -> Matrix:
    """d y(t_last) / d y(t_first) of shape (NY, NY)."""
    ends = (bench.times[first], bench.times[last])
    size, start = len(bench.job.y), bench.reference[first]
    found = np.empty((size, size))
    for i in range(size):
        nudge = np.zeros(size)
        nudge[i] = _NUDGE * bench.sizes[i]
        reached = []
        for sign in (1.0, -1.0):
            outcome = bench.integrate("dop853", ends, (start + sign * nudge).tolist(), tolerance=1e-13)
            if outcome.kind != DONE:
                raise ArithmeticError(f"a run beside the scene fails at t = {outcome.t:.9g}: {bench.reason(outcome)}")
            reached.append(np.array(outcome.y))
        found[:, i] = (reached[0] - reached[1]) / (2 * nudge[i])
    return found


def fit(times: list[float], norms: list[float]) -> tuple[str, float, float]:
    """(law, rate, horizon): the straight line in t or in log t that lies closer to log norm over the last two thirds.

    Where the norm goes up and down with no more than a slight trend, as beside a periodic motion, there is no law.
    """
    start, duration = times[0], times[-1] - times[0]
    t = np.array([(x - start) / duration for x in times])[len(times) // 3 :]
    y = np.log(np.maximum(np.array(norms), 1e-300))[len(times) // 3 :]
    lines = {}
    for name, x in (("exponential", t), ("power", np.log(t))):
        slope, base = np.polyfit(x, y, 1)
        lines[name] = (float(np.sum((y - slope * x - base) ** 2)), float(slope), float(base))
    law = "exponential" if lines["exponential"][0] < lines["power"][0] and lines["exponential"][1] > 0 else "power"
    rest, slope, base = lines[law]
    if rest > (1.0 - _EXPLAINED) * float(np.sum((y - y.mean()) ** 2)):
        return "none", math.nan, math.nan
    rate = slope / duration if law == "exponential" else slope
    if slope <= 1e-3:
        return law, rate, math.inf
    reach = (math.log(0.01 / _ROUNDING) - base) / slope
    if law == "power":
        reach = math.exp(min(reach, 300.0))
    return law, rate, start + duration * reach if reach < 1e6 else math.inf
