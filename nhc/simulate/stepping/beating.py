"""Whether a step passes over what a clock does in it, as ``templates/c/methods/beats.c.jinja`` has it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from math import copysign, inf, isfinite, sin
from typing import Protocol

from nhc.simulate.methods.step import Model, Step
from nhc.simulate.task import Task

_WEIGHTS = (1.0, -6.0, 15.0, -20.0, 15.0, -6.0, 1.0)


class Beating(Model, Protocol):
    """A model that knows how fast its clocks go: :class:`nhc.program.ir.Beats`."""

    def beats(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]: ...


def find_turn(step: Step, model: Beating, task: Task, radians: float) -> float:
    """How long the step after the one that was tried may be; 0 where that one passes over many radians of a clock that matter."""
    if task.step > 0:
        return inf
    try:
        looks = [model.beats(step.t + x * step.h, step.y, step.p) for x in (0.0, 0.5, 1.0)]
    except ArithmeticError:
        return inf
    most, h = inf, abs(step.h)
    for i, rates in enumerate(zip(*looks, strict=True)):
        rate = max(map(abs, rates))
        if not isfinite(rate):
            continue
        turn, known = rate * h, step.push.get(i, 0.0)
        if _is_due(step, i, turn, radians):
            step.push[i] = known = _find_push(step, rate)
        if turn > radians and known * h > 1.0:
            return 0.0
        if rate > 0.0 and known > 0.0:
            most = min(most, 0.999 * max(radians / rate, 1.0 / known))
    return most


def _is_due(step: Step, i: int, turn: float, radians: float) -> bool:
    """Whether it is asked again what a clock moves: it may change in the course of a run."""
    far = turn > radians
    if (far and step.push.get(i, 0.0) * abs(step.h) > 0.1) or not turn > 0.9 * radians:
        return far
    asked = step.asked.get(i, 0)
    step.asked[i] = asked + 1
    return asked % 4 == 0 if far else asked % 32 == 31


def _find_push(s: Step, rate: float) -> float:
    """How much the slopes turn with a clock over the step, beside what each entry may err by, times the step's length.

    By sixth differences, in which what is slow beside the clock cancels; two of them, for one may meet a zero.
    """
    widest = abs(s.h) / len(_WEIGHTS)
    apart = min(2.0 / rate, widest)
    factor = (2.0 * sin(0.5 * rate * apart)) ** 6
    try:
        slopes = [s.slope, *(s.rhs(s.t + copysign(j * apart, s.h), s.y) for j in range(1, len(_WEIGHTS) + 1))]
    except ArithmeticError:
        return sys.float_info.max
    push = 0.0
    for allowed, *values in zip(s.allowed(s.reached), *slopes, strict=True):
        found = [sum(w * v for w, v in zip(_WEIGHTS, part, strict=True)) for part in (values[:-1], values[1:])]
        noise = 64.0 * sys.float_info.epsilon * max(map(abs, values[:-1]))
        push = max(push, (max(map(abs, found)) - noise) / (factor * allowed))
    return push
