"""Angles that differ by known parts of a turn: the values stay, and wheels at equal angles have a constant mass matrix."""

from __future__ import annotations

import re
from fractions import Fraction
from itertools import product

import pytest

from nhc.algebra.evaluate import evaluate
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph
from nhc.algebra.walks import reachable
from nhc.diagnostics import Source
from nhc.mechanics.resolving.phases import known_pair, split_turn
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit, model, program

PARTS = [Fraction(k, 12) for k in range(-25, 26)]


@pytest.mark.parametrize(("turns", "beside"), list(product(PARTS, ((), (0,), (Fraction(1, 6), 0)))))
def test_values_stay(turns: Fraction, beside: tuple[Fraction, ...]) -> None:
    """Exactly and in doubles."""
    g = Graph()
    x = g.symbol("x")
    angle = g.add(x, g.mul(g.number(turns), g.pi()))
    assert split_turn(g, angle) == (x, turns)
    made = known_pair(g, x, turns, {"x": {Fraction(other) for other in beside}})
    if made is not None:
        plain = [g.function("sin", angle), g.function("cos", angle)]
        assert are_equal(g, list(made), plain)
        assert evaluate(g, made, {x: 0.7}) == pytest.approx(evaluate(g, plain, {x: 0.7}), abs=1e-15)


def test_constants_stay() -> None:
    """A joint that leans by a constant is read by its sine and cosine."""
    g = Graph()
    assert all(known_pair(g, g.zero, turns, {"0": set(PARTS)}) is None for turns in PARTS)


def test_a_phase_alone_stays() -> None:
    g = Graph()
    x = g.symbol("x")
    for turns in (Fraction(1, 6), Fraction(-1, 6), Fraction(1, 4), Fraction(2, 3), Fraction(2, 5), Fraction(1, 12)):
        assert known_pair(g, x, turns, {"x": {turns}}) is None
    for turns in (Fraction(1, 2), Fraction(1), Fraction(-3, 2)):
        made = known_pair(g, x, turns, {})
        assert made is not None
        assert all(g.op[g.a[node] if g.op[node] == "neg" else node] in ("sin", "cos") for node in made)


def write_omniwheels(wheels: int) -> str:
    rows = [
        f"  - \"-sin(th + {2 * k}*pi/{wheels})*x' + cos(th + {2 * k}*pi/{wheels})*y' + L*th' - r*p{k}' = 0\""
        for k in range(wheels)
    ]
    spins = " + ".join(f"p{k}'^2" for k in range(wheels))
    return "\n".join(
        [
            "nhc: 1",
            f"system: omni{wheels}",
            f"coordinates: [x, y, th, {', '.join(f'p{k}' for k in range(wheels))}]",
            "parameters: {m: 10, I: 0.5, J: 0.01, r: 0.05, L: 0.2, d: 0.02}",
            "define: {X: x + d*cos(th), Y: y + d*sin(th)}",
            f"T: m/2*(X'^2 + Y'^2) + I/2*th'^2 + J/2*({spins})",
            "constraints:",
            *rows,
        ]
    )


@pytest.mark.parametrize("wheels", [3, 4, 6])
def test_wheels_at_equal_angles_call_one_sine_and_one_cosine(wheels: int) -> None:
    """By its symmetry the robot has the same inertia in every direction, and nothing is divided by what moves."""
    source = Source("omni.yaml", write_omniwheels(wheels))
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.calls <= 3  # with the square root of 3
    text = "".join(emit(source, "c", Options(only=("rhs",))).values())
    assert not re.search(r"z\d+ = 1\.0 / |/ z\d+", text)


def test_an_angle_with_a_lone_phase_is_called_as_it_stands() -> None:
    text = "nhc: 1\nsystem: s\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\nV: sin(x + pi/3) + sin(y)\n"
    system = resolve(model(Source("s.yaml", text)).spec)
    g = system.graph
    assert sum(g.op[node] == "sin" for node in reachable(g, [system.U])) == 2
    assert not any(g.op[node] == "sqrt" for node in reachable(g, [system.U]))
