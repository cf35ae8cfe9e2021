"""The length of fixed steps that nhc finds by itself, against closed forms of the motion."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from nhc.diagnostics import Source
from nhc.simulate.halving import find_step
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, Trajectory, run
from nhc.simulate.task import DONE, Outcome, Task

METHODS = ("rk4", "gauss4", "gauss6", "midpoint")


def go(method: str, tolerance: float, text: str, until: str = "") -> Trajectory:
    head = "nhc: 1\nsystem: halved\ncoordinates: [x]\nT: x'^2/2\n"
    job = open_scene(Source("halved.yaml", head + text), until=until, method=method)
    found = run(job, Settings(method, tolerance, points=41))
    assert any("reach the tolerance (found by halving)" in note for note in found.notes)
    return found


def worst(found: Trajectory, exact: Callable[[float], float]) -> float:
    """The largest error of all rows beside the largest magnitude."""
    known = [exact(t) for t in found.times]
    return max(abs(row[0] - x) for row, x in zip(found.rows, known, strict=True)) / max(map(abs, known))


@pytest.mark.parametrize("method", METHODS)
def test_a_pulse_between_all_first_steps_is_not_missed(method: str) -> None:
    """Of rest before it and straight motion behind it nothing depends on the step."""
    text = 'forces: {x: "max(0, 0.01 - abs(t - 3.1))"}\nscenes: {go: {time: [0, 10]}}\n'

    def exact(t: float) -> float:
        return sum(w * max(0.0, t - s) ** 3 / 6 for w, s in ((1, 3.09), (-2, 3.1), (1, 3.11)))

    assert worst(go(method, 1e-3, text), exact) <= 2e-3


@pytest.mark.parametrize("method", ["gauss4", "gauss6", "midpoint"])
def test_steps_that_agree_with_each_other_by_chance_are_not_believed(method: str) -> None:
    text = "V: x^2/2\nforces: {x: sign(t - 3.13)}\nscenes: {go: {initial: {x: 1}, time: [0, 10]}}\n"

    def exact(t: float) -> float:
        return 2 * math.cos(t) - 1 + (2 * (1 - math.cos(t - 3.13)) if t > 3.13 else 0.0)

    assert worst(go(method, 1e-4, text), exact) <= 2e-4


@pytest.mark.parametrize("method", METHODS)
def test_a_motion_that_comes_to_rest_is_right_on_the_way(method: str) -> None:
    text = "V: 25*x^2\nforces: {x: -2*x'}\nscenes: {go: {initial: {x: 1}, time: [0, 20]}}\n"

    def exact(t: float) -> float:
        return math.exp(-t) * (math.cos(7 * t) + math.sin(7 * t) / 7)

    found = go(method, 1e-4, text)
    assert worst(found, exact) <= 2e-4
    assert found.step >= 1e-4  # what is left at the end, 1e-9, need not be known to its own tolerance


def test_an_event_ends_the_halving_too() -> None:
    found = go("rk4", 1e-6, "V: x^2/2\nscenes: {go: {initial: {x: 1}, time: [0, 10]}}\n", until="x")
    assert found.ended == "event"
    assert found.times[-1] == pytest.approx(math.pi / 2, abs=1e-5)


@pytest.mark.parametrize("method", ["leapfrog", "dla", "energy", "perlmutter"])
def test_methods_for_natural_systems(method: str) -> None:
    found = go(method, 1e-4, "V: x^2/2\nscenes: {go: {initial: {x: 1}, time: [0, 20]}}\n")
    assert worst(found, math.cos) <= 2e-4


@pytest.mark.sample(2)
@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("method", ["rk4", "gauss6"])
def test_each_column_counts_whatever_its_unit(method: str, unit: float) -> None:
    text = (
        "nhc: 1\nsystem: halved\ncoordinates: [x, z]\n"
        f"parameters: {{u: {unit}}}\nT: x'^2/2 + (z'/u)^2/2\nV: x^2/2 + 18*(z/u)^2\n"
        f"scenes: {{go: {{initial: {{x: 1, z: {unit}}}, time: [0, 10]}}}}\n"
    )
    found = run(open_scene(Source("halved.yaml", text), method=method), Settings(method, 1e-5, points=41))
    assert max(abs(row[1] / unit - math.cos(6 * t)) for t, row in zip(found.times, found.rows, strict=True)) <= 2e-5


def test_what_is_zero_but_for_rounding_keeps_no_step_short() -> None:
    text = (
        "nhc: 1\nsystem: halved\ncoordinates: [x, y]\nT: x'^2/2 + y'^2/2\nV: 0.3*x^2 + 0.7*y^2 + 1.1*(x + y/3)^2\n"
        "define: {a: x + y}\noutputs: {d: 3*(x + y) - 3*x - 3*y}\n"
        "scenes: {go: {initial: {x: 0.3, y: 0.1}, time: [0, 10], need: [x, d]}}\n"
    )
    found = run(open_scene(Source("halved.yaml", text), method="gauss6"), Settings("gauss6", 1e-8, points=41))
    assert any("reach the tolerance (found by halving)" in note for note in found.notes)
    assert found.step >= 1e-3


# --- giving up ----------------------------------------------------------------------------------------------


class _Found:
    """What a run that ends with an error of so many tolerances looks like; infinite: it fails on the way."""

    def __init__(self, task: Task, error: float) -> None:
        self.times, self.rows = task.times, ((1.0,), (1.0 + 1e-6 * error,))
        self.outcome, self.reason = Outcome(DONE, 0, task.times[-1], [1.0], task.step), "lost"
        self.ended = "done" if error < math.inf else "failed"


def search(errors: Callable[[int], float], sure: bool = True) -> tuple[float, str, int]:
    """(steps found, the note, all steps taken on the way) of a method with these errors, by its number of steps."""
    task, taken = Task((), [1.0], (0.0, 1.0), 1e-8, 0.0), list[int]()

    def go(one: Task) -> _Found:
        taken.append(round(1.0 / one.step))
        return _Found(one, errors(taken[-1]))

    found, note = find_step(go, lambda one: _Found(one, 0.0 if sure else math.inf), task, 1e-6)
    return 1.0 / found.step, note, sum(taken)


def test_a_length_that_is_foretold_is_taken_at_once() -> None:
    steps, note, taken = search(lambda n: (n / 5e5) ** -2)
    assert steps == 2**19 and "reach the tolerance" in note and taken < 1.01 * steps


def test_what_would_take_too_many_steps_is_not_begun() -> None:
    steps, note, taken = search(lambda n: (n / 3e7) ** -2)
    assert steps == 2**16 and "that would take about 33554432 steps" in note and taken < 2**17


def test_errors_that_fall_no_more_end_the_search() -> None:
    """Rounding, that grows with the number of steps; the best length is kept."""
    steps, note, taken = search(lambda n: max((n / 5e5) ** -2, 50.0 + n / 1e6))
    assert "do not reach the tolerance, but come to 51 times it" in note and steps == 2**19 and taken < 2**22


def test_where_what_is_foretold_fails_the_longest_that_does_not_is_taken() -> None:
    steps, note, taken = search(lambda n: (n / 5e5) ** -2 if n < 2**18 else math.inf)
    assert steps == 2**17 and "shorter ones fail" in note and taken < 2**20


def test_what_always_fails_ends_soon() -> None:
    for sure in (True, False):
        _, note, taken = search(lambda n: math.inf, sure)
        assert "do not reach the tolerance" in note and taken <= 2**20


def test_a_pulse_between_the_first_steps_does_not_end_the_search() -> None:
    """The same error for every length that leaps over it, and none beyond."""
    steps, note, _ = search(lambda n: 1e5 if n < 40_000 else 0.0)
    assert steps == 2**16 and "reach the tolerance" in note
