"""Which arguments the steps of a run are watched by, from the range that a coordinate is expected in."""

from __future__ import annotations

import pytest

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.planning.planner import Planner
from nhc.program.runs.leaps import find_leaps
from nhc.simulate.stepping.leaping import _LOOKS, _Course


def parts_of(force: str, low: float, high: float) -> tuple[tuple[float, float], ...]:
    text = f"""nhc: 1
system: s
coordinates: {{x: {{range: [{low}, {high}]}}, y: {{}}}}
T: (x'^2 + y'^2)/2
forces: {{x: "{force}", y: "-y"}}
"""
    system = resolve(decode(Source("s.yaml", text)))
    formulation = formulate(system)
    found = find_leaps(Planner(equations_of(system, formulation), formulation))
    return () if found is None else found.parts


@pytest.mark.parametrize(
    ("force", "near", "far", "part"),
    [  # a force, a range in which its argument has a narrow place or bends, one in which it has none, how it is watched
        ("-max(0, x - 1)", (0, 3), (2, 3), (0.0, 0.0)),
        ("-min(2, x)", (0, 3), (3, 9), (0.0, 0.0)),
        ("-abs(x - 1)", (0, 3), (2, 300), (0.0, 0.0)),
        ("-1/(x + 1)", (0, 300), (0, 50), (1.5, 0.0)),
        ("-sqrt(x + 1)", (0, 300), (0, 50), (1.5, 0.0)),
        ("-log(x)", (0.1, 30), (1, 50), (1.5, 0.0)),
        ("-exp(-x)", (0, 3), (0, 1.9), (1.5, 2.0)),
        ("-tanh(x)", (0, 3), (0, 0.9), (0.75, 1.0)),
        ("-cosh(x)", (0, 3), (0, 0.9), (0.75, 1.0)),
    ],
)
def test_only_what_can_be_short_is_watched(
    force: str, near: tuple[float, float], far: tuple[float, float], part: tuple[float, float]
) -> None:
    assert parts_of(force, *near) == (part,)
    assert parts_of(force, *far) == ()


@pytest.mark.parametrize("force", ["-x", "-x^3", "-sin(x)", "-x*y", "-1/(2 + sin(x))", "-sin(x)^6", "-x^60"])
def test_what_is_slow_everywhere_is_not_watched(force: str) -> None:
    assert parts_of(force, -100, 100) == ()


@pytest.mark.parametrize("power", ["1000", "1000.5"])
def test_a_high_power_is_watched_as_an_exponential(power: str) -> None:
    assert (1.5, 2.0) in parts_of(f"-sin(x)^{power}", 0, 3)


@pytest.mark.parametrize(("first", "second"), [(0.3, 0.8), (0.1, 0.6), (-1.0, 0.7), (0.2, 3.0), (-1.0, 2.0)])
def test_an_argument_turns_where_the_cubic_through_a_step_does(first: float, second: float) -> None:
    """Its slope is 3 (x - first) (x - second), and it is zero in the middle."""

    def argument(x: float) -> float:
        return x**3 - 1.5 * (first + second) * x**2 + 3.0 * first * second * x

    course = _Course([argument(x) - argument(0.5) for x in _LOOKS], 0.0, 0.0)
    assert course.find_turns() == pytest.approx([x for x in (first, second) if 0.0 < x < 1.0], abs=1e-4)
    if course.u * course.v < 0.0:
        assert course.find_between(course.find_zero()) == pytest.approx(0.0, abs=1e-9)
    assert course.off < 1e-5
