"""The largest stable step of each method on a scene: predicted from its stability function, measured by bisection.

A step h is called stable when errors are not multiplied by more than ``GROWTH`` along the whole scene.  Predicted: for
every eigenvalue of the emitted Jacobian along the scene that does not grow by itself, |R(h lambda)|^(T/h) <= GROWTH, with
R(z) = 1 + z b^T (1 - z A)^-1 e of the method's tableau (Hairer and Wanner 1996, IV.3).  Measured: the run with that fixed
step reaches its end and no component leaves ``GROWTH`` times its size in the scene.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from operator import itemgetter

import numpy as np
from numpy.typing import NDArray

from nhc.records import record
from nhc.simulate.methods import RUNGE_KUTTA, STRUCTURE
from nhc.simulate.methods.tableau import Explicit, Tableau
from nhc.simulate.outcomes import name_outcome
from nhc.simulate.run import list_times
from nhc.simulate.task import DONE
from nhc.study.linearization.units import Matrix
from nhc.study.stability.bench import Bench

GROWTH = 10.0
_PLACES = 25  # Jacobians along the scene
_ROUNDING = 1e-13  # of the fastest rate: a decay that is slower is none
_SEEDS = 50  # and at ends of steps, from the largest of which the largest is sought
_BISECTIONS = 7
_ROWS = 65
_FEWEST = 4  # steps of a scene: longer ones are not looked at
_MOST = 200_000


@record
class StepLimit:
    """``predicted``, ``measured`` in units of time; infinite where no step of at least a quarter of the scene is refused.

    ``predicted`` is None for a method that has no stability function.

    ``measured`` is 0 where no step was found that is stable within the effort; ``why`` says how the next longer step ends.
    """

    method: str
    order: int
    predicted: float | None
    measured: float
    why: str


@record
class Spectrum:
    """Eigenvalues of the Jacobian at ``times``, equally spaced, one row for each; ``fastest``: the largest magnitude that was found
    at any end of a step, at the time ``when``.
    """

    times: tuple[float, ...]
    values: NDArray[np.complex128]
    fastest: float
    when: float

    @property
    def decay(self) -> float:
        """The largest rate of decay."""
        largest = float(np.max(-self.values.real, initial=0.0))
        return largest if largest > _ROUNDING * self.fastest else 0.0

    @property
    def slowest(self) -> float:
        """The smallest magnitude that is clearly no zero; 0 where all are."""
        sizes = np.abs(self.values)
        kept = sizes[sizes > 1e-6 * max(float(np.max(sizes, initial=0.0)), 1e-300)]
        return float(kept.min()) if kept.size else 0.0


def spectrum(bench: Bench) -> Spectrum:
    """Eigenvalues along the scene, at equally spaced times, those left out where the Jacobian has no value.

    Raises:
        ArithmeticError: the scene fails, or the Jacobian has no value at any of them.
    """
    times = list_times(*bench.job.time, _PLACES)
    places = zip(times, bench.follow(times, bench.job.y).states, strict=False)
    found = {t: np.linalg.eigvals(slopes) for t, y in places if (slopes := bench.slopes(t, y)) is not None}
    if not found:
        raise ArithmeticError("the Jacobian has no value along the scene")
    values = np.array(list(found.values()), dtype=complex)
    seen = max(((float(np.max(np.abs(row), initial=0.0)), t) for t, row in found.items()), key=itemgetter(0))
    return Spectrum(tuple(found), values, *max(seen, _find_fastest(bench), key=itemgetter(0)))


def _find_fastest(bench: Bench) -> tuple[float, float]:
    """The largest magnitude of an eigenvalue at ends of steps, and its time: at equal numbers of steps, which are close where the
    motion is fast, and at the shortest steps; from the largest uphill.
    """
    times, states = bench.stations

    @cache
    def look(k: int) -> float:
        slopes = bench.slopes(times[k], states[k])
        return 0.0 if slopes is None else float(np.max(np.abs(np.linalg.eigvals(slopes)), initial=0.0))

    count = len(states)
    apart = max(1, count // _SEEDS)
    shortest = np.argsort(np.diff(times[:count]))[: _SEEDS // 4] + 1
    best = max({*range(0, count, apart), *(int(k) for k in shortest)}, key=look)
    while apart:
        near = max((k for k in (best - apart, best, best + apart) if 0 <= k < count), key=look)
        best, apart = (near, apart) if look(near) > look(best) else (best, apart // 2)
    return look(best), times[best]


def amplification(method: Tableau, z: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """R(z) = det(1 - z A + z e b^T) / det(1 - z A) of a Runge-Kutta method, of z's shape; infinite at its poles.

    Hairer and Wanner 1996, Proposition IV.3.2.
    """
    a, b = coefficients(method)
    scaled, one = np.asarray(z)[..., None, None], np.eye(len(b))
    above, below = np.linalg.det(one + scaled * (b - a)), np.linalg.det(one - scaled * a)
    poles = below == 0.0
    return np.asarray(np.where(poles, np.inf, above / np.where(poles, 1.0, below)))


def coefficients(method: Tableau) -> tuple[Matrix, NDArray[np.float64]]:
    """(A, b) of a tableau."""
    if not isinstance(method, Explicit):
        return np.array(method.rows, dtype=float), np.array(method.advance, dtype=float)
    a = np.zeros((method.stages, method.stages))
    for k, row in enumerate(method.rows[: method.stages - 1]):
        a[k + 1, : len(row)] = row
    b = np.zeros(method.stages)
    last = method.rows[method.stages - 1]
    b[: len(last)] = last
    return a, b


def predict(method: Tableau, values: Sequence[complex] | NDArray[np.complex128], duration: float) -> float:
    """The largest h below which every shorter step is stable; infinite where a quarter of the duration still is."""
    flat = np.ravel(np.asarray(values, dtype=complex))
    kept = flat[(flat.real <= 1e-6 * np.abs(flat)) & (np.abs(flat) * duration > 1e-3)]
    if not kept.size:
        return math.inf
    kept = np.where(np.abs(kept.real) < 1e-9 * np.abs(kept), 1j * kept.imag, kept)
    kept = np.unique(np.round(kept / np.abs(kept).max(), 6)) * np.abs(kept).max()
    low, high = 0.05 / float(np.abs(kept).max()), duration / _FEWEST
    if not low < high:
        return math.inf

    def stable(h: float) -> bool:
        size = np.abs(amplification(method, h * kept))
        return bool(np.all(np.log(np.maximum(size, 1e-300)) * duration / h <= math.log(GROWTH)))

    steps = np.geomspace(low, high, 160)
    bad = next((k for k, h in enumerate(steps) if not stable(float(h))), None)
    if bad is None:
        return math.inf
    low, high = (float(steps[bad - 1]), float(steps[bad])) if bad else (0.0, float(steps[0]))
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if stable(middle) else (low, middle)
    return low


def measure(bench: Bench, method: str, guess: float) -> tuple[float, str]:
    """The largest stable step by bisection (infinite where even the longest is stable), and how the next longer one fails."""
    longest = bench.duration / _FEWEST
    shortest = bench.duration / min(_MOST, bench.most(method))
    limits = GROWTH * np.maximum(bench.sizes, 1e-300)

    def fails(step: float) -> str:
        outcome = bench.integrate(method, _ends_of_steps(*bench.job.time, step), step=step)
        if outcome.kind != DONE:
            return name_outcome(bench.job, outcome)
        states = np.array(outcome.states)
        if not np.all(np.isfinite(states)) or np.any(np.max(np.abs(states), axis=0) > limits):
            return f"the motion leaves {GROWTH:.0f} times its size"
        return ""

    high = min(max(guess, shortest), longest) if math.isfinite(guess) else longest
    why = fails(high)
    if not why:
        low = high
        while not why:
            if high >= longest:
                return math.inf, ""
            low, high = high, min(1.5 * high, longest)
            why = fails(high)
    else:
        low = high
        while True:
            low /= 1.5
            if low < shortest:
                return 0.0, why
            ends = fails(low)
            if not ends:
                break
            high, why = low, ends
    for _ in range(_BISECTIONS):
        middle = math.sqrt(low * high)
        ends = fails(middle)
        low, high, why = (low, middle, ends) if ends else (middle, high, why)
    return low, why


def _ends_of_steps(start: float, end: float, step: float) -> list[float]:
    """At most ``_ROWS`` places where fixed steps end: rows between them are interpolated, which may go astray by itself."""
    count = math.ceil(abs(end - start) / step - 1e-9)
    places = sorted({round(k * count / (_ROWS - 1)) for k in range(_ROWS)})
    return [start, *(start + (end - start) * (k / count) for k in places[1:-1]), end]


def step_limits(bench: Bench, found: Spectrum) -> tuple[StepLimit, ...]:
    """Both numbers for each Runge-Kutta method, the measured one for each structure-preserving method that applies."""
    limits = []
    for name, method in RUNGE_KUTTA.items():
        predicted = predict(method, found.values, bench.duration)
        measured, why = measure(bench, name, predicted)
        limits.append(StepLimit(name, method.order, predicted, measured, why))
    for name in bench.schemes:
        measured, why = measure(bench, name, 2.0 / max(found.fastest, 1e-300))
        limits.append(StepLimit(name, STRUCTURE[name].order, None, measured, why))
    return tuple(limits)
