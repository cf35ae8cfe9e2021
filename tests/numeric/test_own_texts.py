"""Chains in which one place breaks the pattern that they are recognised by, against equations from nothing but the spec's text."""

from __future__ import annotations

import random

import mpmath
import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from tests.metamorphic.models import formulations_of
from tests.oracle import Oracle
from tests.support import error, python_model, seldom


def rods(count: int, x: str, y: str, base: str = "s", more: str = "", **changes: str) -> str:
    """Point masses on rods that hang from (x, y); ``changes`` gives entries of ``define`` other texts."""
    named: dict[str, str] = {}
    energy, potential, values = [f"M/2*{q}'^2" for q in base.split()], [], {"M": 0.9, "g": 3.1}
    for i in range(1, count + 1):
        named[f"x{i}"] = f"{x} + l{i}*cos(a{i})" if x else f"l{i}*cos(a{i})"
        named[f"y{i}"] = f"{y} + l{i}*sin(a{i})" if y else f"l{i}*sin(a{i})"
        x, y = f"x{i}", f"y{i}"
        energy.append(f"m{i}/2*(x{i}'^2 + y{i}'^2)")
        potential.append(f"m{i}*g*y{i}")
        values |= {f"l{i}": round(0.3 + 0.17 * i, 2), f"m{i}": round(1.2 - 0.11 * i, 2)}
    lines = [
        "nhc: 1",
        "system: rods",
        f"coordinates: [{', '.join([*base.split(), *(f'a{i + 1}' for i in range(count))])}]",
    ]
    lines += [f"parameters: {{{', '.join(f'{k}: {v}' for k, v in values.items())}}}", "define:"]
    lines += [f"  {name}: {text}" for name, text in (named | changes).items()]
    return "\n".join([*lines, f"T: {' + '.join(energy)}", f"V: {' + '.join(potential)}", more]) + "\n"


def assert_right(text: str, seed: int = 0, states: int = 2) -> None:
    """Every formulation at random states, with the spec's parameters and others."""
    oracle, draw = Oracle(text), random.Random(seed)
    models = []
    for formulation in ("", *formulations_of(text)):
        (module,) = emit(Source("spec.yaml", text), "python", Options(formulation=formulation)).values()
        models.append(python_model(module, "own_texts"))
    for k in range(states):
        p = [float(x) * (draw.uniform(0.6, 1.5) if k else 1) for x in oracle.parameters.values()]
        q, v = ([draw.uniform(-1, 1) for _ in oracle.q] for _ in range(2))
        v = oracle.admit([mpmath.mpf(x) for x in q], [mpmath.mpf(x) for x in v], mpmath.mpf(0.4), p)
        truth = oracle.motion([mpmath.mpf(x) for x in q], v, mpmath.mpf(0.4), [mpmath.mpf(x) for x in p])
        for model in models:
            y = model.state(0.4, q, [float(x) for x in v], p)
            assert error(model.accelerations(0.4, y, p), truth.accelerations) < 1e-10
            assert error(model.reactions(0.4, y, p) if oracle.rows else [], truth.reactions) < 1e-10
            assert error([model.energy(0.4, y, p)], [truth.energy]) < 1e-12
            assert error(model.outputs(0.4, y, p), truth.outputs) < 1e-11


@pytest.mark.sample(2)
@pytest.mark.parametrize(("x", "y"), [("s", "s"), ("s", "(-s)"), ("s", "2*s"), ("(-s)", ""), ("s", "s^2/2")])
def test_a_cart_on_a_slope_carries_rods(x: str, y: str) -> None:
    assert_right(rods(4, x, y))


ROWS = ("s' = 0.3*t", "s' = 0", "s' = 0.2", "y1' = 0.3*t", "x2' = s*t")


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    ("count", "row"), [*((4, row) for row in ROWS), (6, ROWS[0]), *(seldom(6, row) for row in ROWS[1:])]
)
def test_a_prescribed_velocity_in_a_chain(count: int, row: str) -> None:
    assert_right(rods(count, "s", "", more=f"constraints:\n  - {row}"))


@pytest.mark.sample(2)
@pytest.mark.parametrize(
    "changes",
    [
        {"x3": "y2 + l3*cos(a3)", "y3": "x2 + l3*sin(a3)"},
        {"x3": "x2 + l3*cos(a3)", "y3": "x2 + l3*sin(a3)"},
        {"y3": "2*y2 + l3*sin(a3)"},
        {"y3": "-y2 + l3*sin(a3)"},
        {"y3": "y2 - l3*sin(a3)"},
        {"y3": "y2 + l2*sin(a3)"},
        {"x3": "x2 + l3*cos(2*a3)", "y3": "y2 + l3*sin(2*a3)"},
        {"x3": "x2 + l3*cos(a3 + a2)", "y3": "y2 + l3*sin(a3 + a2)"},
        {"x3": "x2 + a3*cos(a3)", "y3": "y2 + a3*sin(a3)"},
        {"x3": "x2 + l3*cos(a3 + 2*t)", "y3": "y2 + l3*sin(a3 + 2*t)"},
    ],
)
def test_one_rod_that_is_unlike_the_others(changes: dict[str, str]) -> None:
    assert_right(rods(4, "s", "r", base="s r", **changes))


@pytest.mark.parametrize(
    "more",
    [
        "coordinates: [x, y]\nT: ((x' - Omega*y)^2 + (y' + Omega*x)^2)/2",  # a particle seen from turning axes
        "coordinates: [x, y]\nT: ((x' + Omega*x)^2 + (y' - 2*y)^2)/2 + (y' - 2*Omega*x*y)^2",
        "coordinates: [x, y]\nT: x'^2/2 + w^2\nquasi_velocities: {w: 3*y' + x - x'}",
        "coordinates: [x, y, z]\nT: x'^2/2 + w^2 + z'^2\nquasi_velocities: {w: 3*y' + sin(x)}\nconstraints: [x' = Omega*z' + y]",
        "coordinates: [x, y, z]\nT: (x' + y)^2/2 + (x' - y)^2 + y'^2 + z'^2\nconstraints: [z' = y*x' + z]",
    ],
)
def test_forms_whose_coefficients_are_constant_but_for_a_term_without_velocities(more: str) -> None:
    assert_right(f"nhc: 1\nsystem: turning\nparameters: {{Omega: 0.7}}\n{more}\n")
