"""Steady motions along a number: followed from value to value, and where they end."""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence
from dataclasses import replace

from nhc.study.linearization.field import Hold, SteadyModel
from nhc.study.linearization.found import NotSteady
from nhc.study.linearization.linearize import Linearisation, linearise_at
from nhc.study.linearization.steady import find_motion, find_steady

_HALVINGS = 20
"""Of the way between a value with a steady motion and one without."""


class Branch:
    """Steady motions along one number, each found from the nearest one before."""

    def __init__(self, model: Callable[[float], tuple[SteadyModel, tuple[Hold, ...]]], guess: Sequence[float]) -> None:
        self.model = model
        self._known: dict[float, tuple[float, ...]] = {}
        self._guess = tuple(guess)
        self.family: int | None = None
        self._turns: int | None = None  # how many, which tells the group

    def __call__(self, value: float) -> Linearisation:
        """The linearisation at a value.

        Raises:
            NotSteady: the branch ends before.
        """
        model, holds = self.model(value)
        near = min(self._known, key=lambda known: abs(known - value), default=None)
        if self._turns is not None:
            model = replace(model, symmetries=tuple(g for g in ((), *model.symmetries) if len(g) == self._turns))
        if near is None:
            steady = find_motion(model, self._guess, holds)
        else:  # nothing but the branch itself, which may end
            steady = find_steady(model, self._known[near], holds)
        self._known[value], self._turns = steady.y, len(steady.turns)
        return linearise_at(model, steady, self.family)


def follow(
    branch: Branch, values: Sequence[float], name: str, own: float
) -> tuple[dict[float, Linearisation], tuple[tuple[float, str], ...]]:
    """The linearisations from the value of the guess outwards, where there are any, and why there are no others.

    What is not found at once is looked for once more from its neighbours.

    Raises:
        NotSteady: there are none.
    """
    found, missing = dict[float, Linearisation](), dict[float, NotSteady]()
    order = sorted(values, key=lambda value: abs(value - own))
    for value in (*order, *order):
        if value in found or (value in missing and not found):
            continue
        try:
            found[value] = branch(value)
            missing.pop(value, None)
        except NotSteady as error:
            missing[value] = error
    if not found:
        first = missing[order[0]]
        raise NotSteady(f"at {name} = {order[0]:.10g}: {first}", first.residual, entries=first.entries)
    return found, tuple((value, str(missing[value])) for value in values if value in missing)


def runs_of(values: Sequence[float], found: Container[float]) -> list[list[float]]:
    """Neighbours with a motion at each."""
    runs = [[]] if values else list[list[float]]()
    for value in values:
        if value in found:
            runs[-1].append(value)
        elif runs[-1]:
            runs.append([])
    return [run for run in runs if run]


def find_end(branch: Branch, inside: float, outside: float) -> tuple[float, float]:
    """Where a branch ends, by halving."""
    for _ in range(_HALVINGS):
        middle = (inside + outside) / 2
        try:
            branch(middle)
            inside = middle
        except NotSteady:
            outside = middle
    return inside, outside
