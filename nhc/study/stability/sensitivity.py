"""How fast neighbouring motions part: the flow's derivative by the start, segment by segment, and a law for its growth.

Each segment's derivative comes from central differences of runs that start beside the reference; their product is the
derivative over the whole scene, also where it is too large for differences at its end.  The law (:mod:`nhc.study.stability.laws`)
is that of several lengths of the scene, as far as that is cheap: what comes later tells an exponential from a power of t.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from itertools import pairwise
from operator import itemgetter

import numpy as np

from nhc.records import record
from nhc.simulate.task import DONE
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench
from nhc.study.stability.laws import Law, find_law

_SEGMENTS = 40
_NUDGE = 3e-6  # of a component's size: central differences of a run at 1e-13 are good to about 1e-7
_INSIDE = 200  # ends of steps that are looked at in each segment
_LONGEST = 10  # lengths of the scene that a law is looked for in
_EFFORT, _EFFORT_INTERPRETED = 1e7, 1e5  # of this look: steps times the square of the state's size
_HUGE = 1e250  # growth that is not followed further


@record
class Sensitivity:
    """``norms`` at ``times``: by how much admissible perturbations of the start are multiplied at most, each component relative to
    its size in the scene; ``plain`` is the last one in the state's own units.  ``largest``, at the time ``peak``, is the largest at
    any end of a step: a motion that jumps is sensitive while it does.

    ``law`` is that of the growth in the scene and beyond it.
    """

    times: tuple[float, ...]
    norms: tuple[float, ...]
    plain: float
    largest: float
    peak: float
    law: Law


def sensitivity(bench: Bench, lengths: float = _LONGEST) -> Sensitivity:
    """The growth of perturbations along the scene, and its law over so many lengths of it, or as many as are cheap.

    Raises:
        ArithmeticError: the scene or a run beside it fails.
    """
    picked = [round(k * (len(bench.times) - 1) / _SEGMENTS) for k in range(_SEGMENTS + 1)]
    basis = admissible(bench)
    scale, product = bench.sizes, basis
    times, norms = [bench.times[0]], [1.0]
    largest = (1.0, times[0])
    for first, last in pairwise(picked):
        looks = _looks(bench, bench.times[first], bench.times[last])
        products = _segment(bench, looks, bench.reference[first]) @ product
        found = _norms(products, basis, scale)
        largest = max(largest, *zip(found, looks[1:], strict=True), key=itemgetter(0))
        product = products[-1]
        times.append(bench.times[last])
        norms.append(found[-1])
    plain = float(np.linalg.norm(product, 2)) if product.size else 0.0
    later = _later(bench, min(lengths, _LONGEST), product, basis)
    whole = [*times, *(t for t, _ in later)]
    law = find_law(whole, [*norms, *(norm for _, norm in later)], bench.duration)
    return Sensitivity(tuple(times), tuple(norms), plain, *largest, law)


def _looks(bench: Bench, start: float, stop: float) -> list[float]:
    """The ends of a segment, with ends of steps between them."""
    inside = bench.ends[bisect_right(bench.ends, start) : bisect_left(bench.ends, stop)]
    return [start, *inside[:: 1 + len(inside) // _INSIDE], stop]


def _later(bench: Bench, lengths: float, product: Matrix, basis: Matrix) -> list[tuple[float, float]]:
    """(time, norm) beyond the scene, for as long as the motion goes on and it is cheap."""
    most = _EFFORT if bench.model.compiled else _EFFORT_INTERPRETED
    lengths = min(lengths, most / (2.0 * len(bench.ends) * len(bench.job.y) ** 2))
    count = int((lengths - 1.0) * _SEGMENTS)
    if count < _SEGMENTS or not product.size:
        return []
    end = bench.times[-1]
    times = [end + bench.duration * k / _SEGMENTS for k in range(count + 1)]
    states = bench.follow(times, bench.reference[-1].tolist()).states
    found = []
    for k, (start, stop) in enumerate(pairwise(times[: len(states)])):
        try:
            product = _segment(bench, (start, stop), np.array(states[k]))[-1] @ product
        except ArithmeticError:
            break
        (norm,) = _norms(product[None], basis, bench.sizes)
        if not norm < _HUGE:
            break
        found.append((stop, norm))
    return found


def _norms(products: Matrix, basis: Matrix, scale: Matrix) -> list[float]:
    """The largest stretching of relative perturbations inside the basis by each of the products."""
    if not products.size:
        return [0.0] * len(products)
    before = basis / scale[:, None]
    _, upper = np.linalg.qr(before)
    stretched = (products / scale[:, None]) @ np.linalg.inv(upper)
    return [float(norm) for norm in np.linalg.norm(stretched, 2, axis=(1, 2))]


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
    rank = int(np.sum(sizes > 1e-7 * max(1.0, float(np.max(sizes, initial=0.0)))))
    return np.asarray(right[rank:].T)


def _segment(bench: Bench, times: Sequence[float], start: Matrix) -> Matrix:
    """d y(t) / d y(t_first) of the motion through ``start``, of shape (later times, NY, NY)."""
    size = len(start)
    found = np.empty((len(times) - 1, size, size))
    for i in range(size):
        nudge = np.zeros(size)
        nudge[i] = _NUDGE * bench.sizes[i]
        reached = []
        for sign in (1.0, -1.0):
            outcome = bench.integrate("dop853", times, (start + sign * nudge).tolist(), tolerance=1e-13)
            if outcome.kind != DONE:
                raise ArithmeticError(f"a run beside the scene fails at t = {outcome.t:.9g}: {bench.reason(outcome)}")
            reached.append(np.array(outcome.states[1:]))
        found[:, :, i] = (reached[0] - reached[1]) / (2 * nudge[i])
    return found
