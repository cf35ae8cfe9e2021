"""The methods' coefficients obey their own laws, and the methods in Python have their orders."""

from __future__ import annotations

import math
from dataclasses import dataclass

import pytest

from nhc.cli.run import METHODS as OFFERED
from nhc.simulate.interpreted import InterpretedModel, load_text
from nhc.simulate.methods import METHODS, RUNGE_KUTTA, STRUCTURE, is_adaptive
from nhc.simulate.methods.linear import solve
from nhc.simulate.methods.tableau import Collocation, Explicit
from nhc.simulate.peers import PEERS
from nhc.simulate.stepping.loop import integrate
from nhc.simulate.task import CROSSED, DONE, EVENT, NO_SOLUTION, SINGULAR, STOPPED, TOO_MANY, UNDERFLOW, News, Task

EXPLICIT = [m for m in RUNGE_KUTTA.values() if isinstance(m, Explicit)]
IMPLICIT = [m for m in RUNGE_KUTTA.values() if isinstance(m, Collocation)]


def test_the_command_line_offers_exactly_the_methods() -> None:
    assert (*METHODS, *PEERS) == OFFERED


def test_every_method_has_a_file_with_its_citation() -> None:
    for name in METHODS:
        method = RUNGE_KUTTA.get(name) or STRUCTURE[name]
        assert any(character.isdigit() for character in method.citation)


@pytest.mark.parametrize("method", EXPLICIT, ids=lambda m: m.name)
def test_explicit_coefficients(method: Explicit) -> None:
    rows = ((), *method.rows)
    assert len(rows) == len(method.nodes)
    for node, row in zip(method.nodes, rows, strict=True):
        assert math.isclose(sum(row), node, abs_tol=2e-14)
    advance = method.rows[method.stages - 1]
    for k in range(1, method.order + 1):  # quadrature conditions
        moment = sum(b * c ** (k - 1) for b, c in zip(advance, method.nodes, strict=False))
        assert math.isclose(moment, 1 / k, rel_tol=1e-13)
    for row in method.errors:
        assert abs(sum(row)) < 1e-14
    for row in method.dense:  # they vanish on polynomials that Hermite's cubic has
        assert len(row) == len(method.nodes) or not method.dense
        assert abs(sum(row)) < 1e-12


@pytest.mark.parametrize("method", IMPLICIT, ids=lambda m: m.name)
def test_collocation_coefficients(method: Collocation) -> None:
    count = len(method.nodes)
    for k in range(1, count + 1):  # C(s): collocation
        for node, row in zip(method.nodes, method.rows, strict=True):
            assert math.isclose(
                sum(a * c ** (k - 1) for a, c in zip(row, method.nodes, strict=True)), node**k / k, abs_tol=1e-15
            )
    for k in range(1, method.order + 1):  # B(p)
        moment = sum(b * c ** (k - 1) for b, c in zip(method.advance, method.nodes, strict=True))
        assert math.isclose(moment, 1 / k, rel_tol=1e-14)


def test_the_estimate_of_radau_is_that_of_its_pole() -> None:
    """The weights are -pole times those that make the embedded formula exact to order 3 (Hairer and Wanner, eq. IV.8.18)."""
    method = RUNGE_KUTTA["radau5"]
    assert isinstance(method, Collocation)
    gamma = 1 / method.pole
    # b^ with gamma f0: sum b^ c^(k-1) = 1/k for k = 1..3, then e = (b^ - b) A^-1
    moments = [[c ** (k - 1) for c in method.nodes] for k in (1, 2, 3)]
    hat = solve(moments, [1 - gamma, 1 / 2, 1 / 3])
    difference = [x - b for x, b in zip(hat, method.advance, strict=True)]
    weights = solve([list(column) for column in zip(*method.rows, strict=True)], difference)
    # (hat step - step) = gamma h f0 + h sum (b^ - b) f = gamma (h f0 + e z), so e = weights / gamma
    assert all(math.isclose(w / gamma, e, rel_tol=1e-12) for w, e in zip(weights, method.errors, strict=True))


@dataclass
class Oscillator:
    """x'' = -x + cos(t/2)/2: it depends on time, and its solution is known."""

    events: int = 0
    watched: bool = False
    holds: tuple[str, ...] = ()
    dips: int = 1
    frames: tuple[int, int] = (0, 0)
    parts: tuple[tuple[float, float], ...] = ()

    def rhs(self, t: float, y: list[float], p: list[float]) -> list[float]:
        return [y[1], -y[0] + 0.5 * math.cos(0.5 * t)]

    def jacobian(self, t: float, y: list[float], p: list[float]) -> list[list[float]]:
        return [[0.0, 1.0], [-1.0, 0.0]]

    def watch(self, t: float, y: list[float], p: list[float]) -> list[float]:
        return [y[0] - 1.0] if self.watched else []

    def beats(self, t: float, y: list[float], p: list[float]) -> list[float]:
        return []

    def hold(self, t: float, y: list[float], p: list[float]) -> list[float]:
        return y


def solution(t: float) -> float:
    """With x(0) = 1, x'(0) = 0."""
    return math.cos(t) / 3 + 2 / 3 * math.cos(t / 2)


def rows(name: str, step: float, tolerance: float = 0.0, count: int = 11) -> list[float]:
    """The error of position and velocity together, at each row."""
    times = [2.0 * k / (count - 1) for k in range(count)]
    found = integrate(Oscillator(), RUNGE_KUTTA[name], Task((), [1.0, 0.0], times, tolerance, step), News())
    assert found.kind == DONE and found.t == 2.0
    return [
        math.hypot(state[0] - solution(t), state[1] + math.sin(t) / 3 + math.sin(t / 2) / 3)
        for t, state in zip(times, found.states, strict=True)
    ]


@pytest.mark.parametrize("name", RUNGE_KUTTA)
def test_order_at_the_end_by_slope(name: str) -> None:
    steps = {"dop853": (0.5, 0.25), "gauss6": (0.5, 0.25)}.get(name, (0.1, 0.05))
    coarse, fine = (abs(rows(name, h)[-1]) for h in steps)
    assert math.log2(coarse / fine) == pytest.approx(RUNGE_KUTTA[name].order, abs=0.1)


@pytest.mark.parametrize(
    ("name", "order"),
    [("rk4", 4), ("dopri5", 5), ("dop853", 8), ("gauss4", 4), ("gauss6", 6), ("radau5", 4), ("midpoint", 2)],
)
def test_order_of_the_interpolant(name: str, order: int) -> None:
    """Its local error is h^(q+1) at a fixed place of the step, with q + 1 the order here (dop853: 7 + 1)."""

    def error(h: float) -> float:
        s = integrate(Oscillator(), RUNGE_KUTTA[name], Task((), [1.0, 0.0], [0.0, 0.3 * h, h], 0.0, h), News())
        return abs(s.states[1][0] - solution(0.3 * h))

    h = {"dop853": 1.0, "gauss6": 0.8}.get(name, 0.2)
    assert math.log2(error(h) / error(h / 2)) > order - 0.2


@pytest.mark.parametrize("name", [name for name in RUNGE_KUTTA if is_adaptive(name)])
def test_tolerance_is_honoured(name: str) -> None:
    for tolerance in (1e-4, 1e-7, 1e-10):
        assert max(map(abs, rows(name, 0.0, tolerance, 41))) < 30 * tolerance


def test_an_event_is_found_where_it_is() -> None:
    model = Oscillator(events=1, watched=True)
    start = [0.0, 1.5]
    found = integrate(model, RUNGE_KUTTA["dop853"], Task((), start, [0.0, 1.0, 9.0], 1e-12), News())
    # x = a cos t + 1.5 sin t + 2/3 cos(t/2) with a = -2/3
    x = -2 / 3 * math.cos(found.t) + 1.5 * math.sin(found.t) + 2 / 3 * math.cos(found.t / 2)
    assert found.kind == EVENT and x == pytest.approx(1.0, abs=1e-11) and found.t < 1.5
    assert found.y[0] == pytest.approx(1.0, abs=1e-12)


def test_what_is_no_event_is_an_alarm() -> None:
    model = Oscillator(events=0, watched=True)
    assert integrate(model, RUNGE_KUTTA["rk4"], Task((), [0.0, 1.5], [0.0, 9.0], 0.0, 0.1), News()).kind == CROSSED


class Explosion(Oscillator):
    """x' = x^2 blows up at t = 1; beyond 1e6 the model calls itself singular where ``limit`` says so."""

    limit = math.inf

    def rhs(self, t: float, y: list[float], p: list[float]) -> list[float]:
        if y[0] > self.limit:
            error = ArithmeticError("singular")
            error.status = 2  # type: ignore[attr-defined]
            raise error
        return [y[0] * y[0]]

    def jacobian(self, t: float, y: list[float], p: list[float]) -> list[list[float]]:
        return [[2 * y[0]]]


def test_failures_say_where() -> None:
    task = Task((), [1.0], [0.0, 2.0], 1e-8)
    found = integrate(Explosion(), RUNGE_KUTTA["dop853"], task, News())
    assert found.kind == UNDERFLOW and found.t == pytest.approx(1.0, abs=1e-6) and len(found.states) == 1
    limited = Explosion()
    limited.limit = 1e6
    found = integrate(limited, RUNGE_KUTTA["dopri5"], task, News())
    assert found.kind == SINGULAR and found.status == 2 and found.t == pytest.approx(1 - 1e-6, abs=1e-6)
    assert (
        integrate(Oscillator(), RUNGE_KUTTA["rk4"], Task((), [1.0, 0.0], [0, 1], 0, 0.1, most=3), News()).kind
        == TOO_MANY
    )
    news = News()
    news.stop = True
    assert integrate(Oscillator(), RUNGE_KUTTA["rk4"], Task((), [1.0, 0.0], [0, 1], 0, 0.1), news).kind == STOPPED
    found = integrate(Explosion(), RUNGE_KUTTA["gauss4"], Task((), [1.0], [0.0, 10.0], 0.0, 5.0), News())
    assert found.kind in (NO_SOLUTION, UNDERFLOW)


def test_emitted_text_becomes_a_module_without_a_trace() -> None:
    import sys

    module = load_text("VALUE = 6 * 7\n", "example")
    assert module.VALUE == 42 and module.__name__ not in sys.modules
    assert InterpretedModel.compiled is False
