"""One step of a method in Python: what ``struct step`` is in C."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

from nhc.program.runs.limits import LIMITS

Vector = list[float]
ASIDE = 1.0 / 1024
"""Of a step: where the Jacobian is taken if it has no value at the start."""


class Model(Protocol):
    """What a method asks of a model; a singular point raises an ArithmeticError."""

    def rhs(self, t: float, y: Sequence[float], p: Sequence[float]) -> Vector: ...

    def jacobian(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[Vector]: ...


class NoSolution(Exception):
    """The equations of an implicit step are not solved by Newton's iteration."""


@dataclass
class Step:
    """A step from (t, y) to (t + h, ``reached``) with the slopes ``slope`` and ``arrived`` there, and what a run carries on.

    ``tolerance`` 0 means fixed steps; ``k`` are the slopes of the stages, ``shape`` is the interpolant.  An entry's error counts
    relative to its size.  An entry that leaves rest has none yet, so that refused steps have to foretell it:

    - ``size``: the largest magnitude of each entry so far;
    - ``foretold``: magnitudes that the ends of refused steps foretell; ``ahead``: length of the longest of these steps, signed;
    - ``expecting``: steps were taken whose errors counted relative to such magnitudes, ``expected``, which must be reached by the
      time ``until``; ``seen``: the largest magnitudes since then, ``summed_errors``: the errors since then, added up; ``returns``:
      how often they were not reached and the run went back;
    - ``noise``: how far rounding may put the slopes off; ``measured_step``: the length of the step at whose end that was measured,
      if it had been taken (else 0); ``longest_since``: that of the longest step since;
    - ``damping``: of an implicit step, ``pole`` - h J in factors, and ``pole``; None for explicit ones;
    - ``refused_square``: the square of the last refused step's error; ``unimproved``: how often in a row a shorter step did not
      lessen it;
    - ``floor_part``: the size of each entry is at least this part of the largest entry's (empty: of none);
    - ``push``, ``asked``: what clocks do to the slopes, and how often that was asked (:mod:`nhc.simulate.stepping.beating`).
    """

    model: Model
    p: Sequence[float]
    t: float
    y: Vector
    tolerance: float
    h: float = 0.0
    slope: Vector = field(default_factory=list)
    reached: Vector = field(default_factory=list)
    arrived: Vector = field(default_factory=list)
    size: Vector = field(default_factory=list)
    foretold: Vector = field(default_factory=list)
    ahead: float = 0.0
    expected: Vector = field(default_factory=list)
    seen: Vector = field(default_factory=list)
    summed_errors: Vector = field(default_factory=list)
    until: float = 0.0
    expecting: bool = False
    returns: int = 0
    errors: Vector = field(default_factory=list)
    noise: Vector = field(default_factory=list)
    measured_step: float = 0.0
    longest_since: float = 0.0
    damping: tuple[tuple[list[Vector], list[int]], float] | None = None
    refused_square: float = 0.0
    unimproved: int = 0
    floor_part: Vector = field(default_factory=list)
    k: list[Vector] = field(default_factory=list)
    shape: list[Vector] | None = None
    first: bool = True
    status: int = 0
    calls: int = 0
    jacobians: int = 0
    push: dict[int, float] = field(default_factory=dict)
    asked: dict[int, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.size = [abs(x) for x in self.y]
        self.foretold, self.noise = [0.0] * len(self.y), [0.0] * len(self.y)

    def rhs(self, t: float, y: Vector, p: Vector | None = None) -> Vector:
        """The slope, with other parameters than the run's where ``p`` gives them."""
        self.calls += 1
        return self.model.rhs(t, y, self.p if p is None else p)

    def jacobian(self, t: float, y: Vector, slope: Vector) -> list[Vector]:
        """The Jacobian at a state with this slope, or right beside it where it has no value: as it is written, a drag v*sqrt(v^2)
        has no derivative at rest.  Newton's iteration and estimates of errors need no more.
        """
        self.jacobians += 1
        try:
            return self.model.jacobian(t, y, self.p)
        except ArithmeticError:
            self.jacobians += 1
            moved = [a + ASIDE * self.h * b for a, b in zip(y, slope, strict=True)]
            return self.model.jacobian(t + ASIDE * self.h, moved, self.p)

    def find_sizes(self, reached: Vector) -> Vector:
        """What the errors of entries are relative to: their own sizes in the run so far, this end included.

        They are no less than what rounding may make.  Of what was asked at the end of a refused step that is a millionth of the
        largest entry at most: past a singular place slopes are so sensitive that it would be anything.  What was asked on the
        motion itself counts in steps up to ``LIMITS.steady`` times as long as the one that was taken there.
        """
        rows = zip(self.size, self.foretold, reached, strict=True)
        sizes = [max(size, foretold, abs(end)) for size, foretold, end in rows]
        largest = max(sizes, default=0.0)
        if self.floor_part:
            sizes = [max(x, part * largest) for x, part in zip(sizes, self.floor_part, strict=True)]
        step = abs(self.h) / (self.tolerance or 1.0)
        sure = min(abs(self.h), LIMITS.steady * self.measured_step) / (self.tolerance or 1.0)
        noises = [max(min(step * noise, 1e-6 * largest), sure * noise) for noise in self.noise]
        return [max(x, noise) for x, noise in zip(sizes, noises, strict=True)]

    def allowed(self, reached: Vector) -> Vector:
        """The error that each entry may make; rounding is none."""
        return [max(self.tolerance * x, sys.float_info.min) for x in self.find_sizes(reached)]

    @property
    def telling(self) -> bool:
        """Whether a refused step tells anything: not where the state grows by a higher power of the time than ``LIMITS.power``.

        Far beyond its stability a method makes anything of a state, and its estimate of the error may be a tenth of that.
        """
        end = max((*self.size, *map(abs, self.reached)), default=0.0)
        speed = max(map(abs, self.arrived), default=0.0)
        return abs(self.h) * speed <= LIMITS.power * end

    @property
    def resting(self) -> bool:
        """Whether the state was next to nothing up to here."""
        return max(self.size, default=0.0) <= 1e-3 * max(map(abs, self.reached), default=0.0)

    def learn_sizes(self, square: float, trust: float) -> None:
        """Foretell the sizes of entries near zero, from the end of a refused step, if its error and those of the steps refused
        after it are at most the part ``trust`` of their ends, or three tenths where some entries have a floor.

        A motion that leaves rest as a power of the time has the same relative error in each step, however short.  ``square``: of
        the error relative to what is allowed.
        """
        tame = trust >= 1.0  # any step that is solved
        self.unimproved = (
            self.unimproved + 1 if self.refused_square > 0.0 and square >= 0.25 * self.refused_square else 0
        )
        self.refused_square = square
        right = square * self.tolerance**2 <= max(trust**2, 0.09 if self.floor_part else 0.0) and (tame or self.telling)
        if not right or self.returns >= LIMITS.returns:
            self.foretold, self.ahead = [0.0] * len(self.y), 0.0
            return
        rows = zip(self.foretold, self.size, map(abs, self.reached), map(abs, self.arrived), strict=True)
        h = abs(self.h)
        told = [
            end if size <= 1e-3 * end and (tame or h * v <= LIMITS.power * end) else 0.0 for _, size, end, v in rows
        ]
        if any(told) and h > abs(self.ahead):
            self.ahead = self.h
        self.foretold = [max(a, b) for a, b in zip(self.foretold, told, strict=True)]

    def set_floors(self) -> None:
        """Where everything rests, or shorter steps do not lessen the errors (of high powers of the time): from here on the error of
        an entry near zero counts relative to a millionth of the largest entry.
        """
        if not self.telling or (self.unimproved < LIMITS.unimproved and not self.resting):
            return
        rows = zip(self.floor_part or [0.0] * len(self.y), self.size, self.reached, strict=True)
        self.floor_part = [1e-6 if size <= 1e-3 * abs(end) else part for part, size, end in rows]

    def move(self, t: float) -> None:
        """The step is taken: the next one begins at its end."""
        self.t, self.y, self.slope, self.first = t, self.reached, self.arrived, False
        self.size = [max(a, b, abs(x)) for a, b, x in zip(self.size, self.foretold, self.y, strict=True)]
        self.foretold, self.refused_square, self.unimproved = [0.0] * len(self.y), 0.0, 0

    def cubic(self) -> list[Vector]:
        """Hermite's cubic through both ends, in the terms of ``interpolate``."""
        difference = [b - a for a, b in zip(self.y, self.reached, strict=True)]
        first = [self.h * f - d for f, d in zip(self.slope, difference, strict=True)]
        rows = zip(difference, self.slope, self.arrived, strict=True)
        return [difference, first, [2 * d - self.h * (f0 + f1) for d, f0, f1 in rows]]

    def interpolate(self, x: float) -> Vector:
        """y + x (f0 + (1 - x) (f1 + x (f2 + ...)))."""
        assert self.shape is not None
        value = [0.0] * len(self.y)
        for j in reversed(range(len(self.shape))):
            factor = x if j % 2 == 0 else 1.0 - x
            value = [(v + f) * factor for v, f in zip(value, self.shape[j], strict=True)]
        return [y + v for y, v in zip(self.y, value, strict=True)]


def combine(weights: Sequence[float], slopes: Sequence[Vector], i: int) -> float:
    """Sum of weight times slope, component i."""
    return sum(w * k[i] for w, k in zip(weights, slopes, strict=False) if w)
