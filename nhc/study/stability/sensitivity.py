"""How fast neighbouring motions part: the flow's derivative by the start, segment by segment, and a law for its growth.

Each segment's derivative comes from central differences of runs that start beside the reference; their product is the
derivative over the whole scene, also where it is too large for differences at its end.  The law (:mod:`nhc.study.stability.laws`)
is that of several lengths of the scene, as far as that is cheap: what comes later tells an exponential from a power of t.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from operator import itemgetter

import numpy as np

from nhc.records import record
from nhc.simulate.task import DONE
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench
from nhc.study.stability.laws import Law, find_law

_SEGMENTS = 40
_TOLERANCE = 1e-13
_NUDGE = 3e-6  # of a component's size: central differences of a run at 1e-13 are good to about 1e-7
_FINE = 1e-4  # of a difference: errors up to which its nudge is not changed
_ROUNDING = 10.0 * _TOLERANCE  # of the state
_TRIALS = 5
_LOST = 0.1  # of a difference: beyond the scene nothing is followed further then
_APART = 0.3  # of the growth: what errors of the differences may make of it
_LEAST_ERROR = 1e-9
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
    times, norms, flow = [bench.times[0]], [1.0], _Flow(bench)
    shadow = basis
    largest = (1.0, times[0])
    for first, last in pairwise(picked):
        looks = _looks(bench, bench.times[first], bench.times[last])
        products = flow.segment(looks, bench.reference[first]) @ product
        found = _norms(products, basis, scale)
        largest = max(largest, *zip(found, looks[1:], strict=True), key=itemgetter(0))
        shadow = flow.disturbed() @ shadow
        product = products[-1]
        times.append(bench.times[last])
        norms.append(found[-1])
        if _are_apart(product, shadow, basis, scale):
            raise ArithmeticError(
                f"what has grown shrinks again by more than differences of runs tell, at t = {bench.times[last]:.6g}"
            )
    plain = float(np.linalg.norm(product, 2)) if product.size else 0.0
    later, cut = _later(flow, min(lengths, _LONGEST), product, shadow, basis)
    whole = [*times, *(t for t, _ in later)]
    law = find_law(whole, [*norms, *(norm for _, norm in later)], bench.duration)
    if cut and not law.seen and math.isfinite(law.horizon):
        law = replace(law, horizon=math.nan)  # it may turn just there
    return Sensitivity(tuple(times), tuple(norms), plain, *largest, law)


def _looks(bench: Bench, start: float, stop: float) -> list[float]:
    """The ends of a segment, with ends of steps between them."""
    inside = bench.ends[bisect_right(bench.ends, start) : bisect_left(bench.ends, stop)]
    return [start, *inside[:: 1 + len(inside) // _INSIDE], stop]


def _later(
    flow: _Flow, lengths: float, product: Matrix, shadow: Matrix, basis: Matrix
) -> tuple[list[tuple[float, float]], bool]:
    """(time, norm) beyond the scene, for as long as the motion goes on and it is cheap; whether it ends where the growth is told
    no further.
    """
    bench = flow.bench
    most = _EFFORT if bench.model.compiled else _EFFORT_INTERPRETED
    lengths = min(lengths, most / (2.0 * len(bench.ends) * len(bench.job.y) ** 2))
    count = int((lengths - 1.0) * _SEGMENTS)
    if count < _SEGMENTS or not product.size:
        return [], False
    end = bench.times[-1]
    times = [end + bench.duration * k / _SEGMENTS for k in range(count + 1)]
    states = bench.follow(times, bench.reference[-1].tolist()).states
    found = list[tuple[float, float]]()
    for k, (start, stop) in enumerate(pairwise(times[: len(states)])):
        try:
            product = flow.segment((start, stop), np.array(states[k]))[-1] @ product
        except ArithmeticError:
            break
        shadow = flow.disturbed() @ shadow
        (norm,) = _norms(product[None], basis, bench.sizes)
        if flow.noise > _LOST or _are_apart(product, shadow, basis, bench.sizes):
            return found, True
        if not norm < _HUGE:
            break
        found.append((stop, norm))
    return found, False


def _are_apart(product: Matrix, shadow: Matrix, basis: Matrix, scale: Matrix) -> bool:
    """Whether the growth is another one with other errors: contracting what grew before leaves what was wrong with it."""
    if not product.size:
        return False
    one, other = _norms(np.stack([product, shadow]), basis, scale)
    return abs(one - other) > _APART * one


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


class _Flow:
    """The flow's derivative by the state, from central differences.

    A nudge is small where the motion bends within it, as beside a separatrix, and large where the state has outgrown its sizes in
    the scene and would drown it in rounding; it stays from one segment to the next.
    """

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.nudges = _NUDGE * bench.sizes
        self.noise = 0.0
        self._last: tuple[Matrix, Matrix] | None = None
        self._draw = np.random.default_rng(1)

    def segment(self, times: Sequence[float], start: Matrix) -> Matrix:
        """d y(t) / d y(t_first) of the motion through ``start``, of shape (later times, NY, NY); ``noise`` is what rounding has in
        the worst column at the end, relative to it.

        Raises:
            ArithmeticError: a run fails.
        """
        size, middle = len(start), self._run(times, start)
        found, errors = np.empty((len(times) - 1, size, size)), np.zeros(size)
        self.noise = 0.0
        for i in range(size):
            found[:, :, i], bend, noise = self._column(times, start, middle, i)
            self.noise, errors[i] = max(self.noise, noise), max(bend, noise, _LEAST_ERROR)
        self._last = found[-1], errors
        return found

    def disturbed(self) -> Matrix:
        """The derivative over the last segment with other errors, of the size that its columns have."""
        assert self._last is not None
        derivative, errors = self._last
        sizes = self.bench.sizes[:, None]
        largest = np.max(np.abs(derivative) / sizes, axis=0)
        return np.asarray(derivative + sizes * largest * errors * self._draw.uniform(-1.0, 1.0, derivative.shape))

    def _column(self, times: Sequence[float], start: Matrix, middle: Matrix, i: int) -> tuple[Matrix, float, float]:
        nudge, tried = np.zeros(len(start)), dict[float, tuple[Matrix, float, float]]()
        sizes = self.bench.sizes
        for _ in range(_TRIALS):
            h = nudge[i] = self.nudges[i]
            above, below = (self._run(times, start + sign * nudge) for sign in (1.0, -1.0))
            bend, noise = _errors(above / sizes, middle / sizes, below / sizes)
            tried[h] = (above - below) / (2.0 * h), bend, noise
            other = h / 10.0 if bend > noise else h * 10.0
            if max(bend, noise) <= _FINE or other in tried:
                break
            self.nudges[i] = other
        best = min(tried, key=lambda h: max(tried[h][1], tried[h][2]))
        self.nudges[i] = best
        return tried[best]

    def _run(self, times: Sequence[float], start: Matrix) -> Matrix:
        """The states at the later times."""
        outcome = self.bench.integrate("dop853", times, start.tolist(), tolerance=_TOLERANCE)
        if outcome.kind != DONE:
            raise ArithmeticError(f"a run beside the scene fails at t = {outcome.t:.9g}: {self.bench.reason(outcome)}")
        return np.array(outcome.states[1:])


def _errors(above: Matrix, middle: Matrix, below: Matrix) -> tuple[float, float]:
    """How far a difference is off, relative to it: for the motion bends within it, and by rounding.

    At its end, and where it is largest on the way: the tops of what grows and shrinks again may be sharp.
    """
    change = np.max(np.abs(above - below), axis=1)
    bent = np.max(np.abs(above + below - 2.0 * middle), axis=1)
    rounding = _ROUNDING * np.max(np.abs(middle), axis=1)
    looks = [k for k in {len(change) - 1, int(np.argmax(change))} if change[k]]
    return max(((bent[k] / change[k]) ** 2 for k in looks), default=0.0), max(
        (rounding[k] / change[k] for k in looks), default=0.0
    )
