"""Rows that are long as they are written, and floors that move uniformly: the equations are the same, and as short as by hand."""

from __future__ import annotations

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.frame import form_value
from nhc.mechanics.resolving.resolve import resolve
from nhc.mechanics.resolving.short_rows import short_row
from nhc.mechanics.system import Form, System
from nhc.pipeline import Model, Options, emit, model
from nhc.program.planning.planner import Planner
from tests.support import error, python_model

COIN = """nhc: 1
system: coin
coordinates: [x, y, phi, th, psi]
parameters: {{m: 0.3, R: 0.25, g: 9.81, v: 0.5, b: 0.2, n: 3}}
bodies:
  frame: {{at: [x, y, R*sin(th)], turns: [z: phi, x: th]}}
  {coin}
  ground: {{at: [x, y, R*sin(th)], turns: [z: phi]}}
points:
  P: {{parent: {parent}, of: coin, at: {at}}}
gravity: [0, 0, -g]
constraints:
{rows}
"""
ON_FRAME = "coin: {parent: frame, turns: [z: psi], mass: m, inertia: [m*R^2/4, m*R^2/4, m*R^2/2]}"
ALONE = "coin: {at: [x, y, R*sin(th)], turns: [z: phi, x: th, z: psi], mass: m, inertia: [m*R^2/4, m*R^2/4, m*R^2/2]}"
BY_FRAME, BY_GROUND = ("frame", "[0, -R, 0]"), ("ground", "[0, -R*cos(th), -R*sin(th)]")


def coin(rows: str, point: tuple[str, str] = BY_FRAME, body: str = ON_FRAME) -> str:
    text = "\n".join(f"  - {row}" for row in rows.split("; "))
    return COIN.format(coin=body, parent=point[0], at=point[1], rows=text)


def made(text: str) -> Model:
    return model(Source("coin.yaml", text))


def operations(text: str) -> int:
    found = made(text)
    planner = Planner(found.equations, found.formulation)
    return count(found.system.graph, planner.route.values)


STYLES = {
    "on the ground's axes": coin("P_v1 = 0; P_v2 = 0", BY_GROUND),
    "turned by hand": coin("cos(phi)*P_vx + sin(phi)*P_vy = 0; cos(phi)*P_vy - sin(phi)*P_vx = 0"),
    "beside the frame": coin("P_vx = 0; P_vy = 0", BY_GROUND, ALONE),
}


@pytest.mark.parametrize("style", STYLES)
def test_how_a_row_is_written_makes_no_difference(style: str) -> None:
    """215 operations against 47."""
    plain = operations(coin("P_vx = 0; P_vy = 0"))
    assert operations(STYLES[style]) <= 1.2 * plain


@pytest.mark.parametrize("style", ["on the ground's axes", "beside the frame"])
def test_rows_keep_their_values(style: str) -> None:
    """Modulo primes: the row as it was written equals the one that the system has, which is shorter."""
    spec = decode(Source("coin.yaml", STYLES[style]))
    g = WithoutRules({"short rows"})
    long = resolve(spec, g)
    for form in long.constraints:
        without = form_value(long, form)
        short = _short(long, form)
        assert are_equal(g, [form_value(long, short)], [without])
        assert 2 * count(g, [form_value(long, short)]) <= count(g, [without])


def _short(system: System, form: Form) -> Form:
    system.graph.off = frozenset()
    return short_row(system.graph, system.q, system.v, form)


@pytest.mark.parametrize("row", ["P_vx = v; P_vy = 0", "P_vx = v; P_vy = -2*v"])
def test_a_belt_that_moves_uniformly(row: str) -> None:
    """What changes is where the coin is, by one addition each (Galilei)."""
    belt, still = made(coin(row)), made(coin("P_vx = 0; P_vy = 0"))
    g = belt.system.graph
    speed = belt.system.p[[p.name for p in belt.system.spec.parameters].index("v")]
    entries = [*(x for line in belt.equations.mass for x in line), *belt.equations.force]
    assert not any(g.depends(x, g.deps[speed]) for x in entries)
    assert operations(coin(row)) <= operations(coin("P_vx = 0; P_vy = 0")) + 4
    assert len(still.equations.force) == len(belt.equations.force)


def test_a_belt_that_is_accelerated_is_felt() -> None:
    found = made(coin("P_vx = b*sin(n*t); P_vy = 0"))
    g = found.system.graph
    assert any(g.depends(x, g.deps[found.system.t]) for x in found.equations.force)


TURNTABLE = coin("P_vx + v*y = 0; P_vy - v*x = 0")


def test_a_turntable_is_no_uniform_motion() -> None:
    found = made(TURNTABLE)
    g = found.system.graph
    speed = found.system.p[[p.name for p in found.system.spec.parameters].index("v")]
    assert any(g.depends(x, g.deps[speed]) for x in found.equations.force)


def test_the_belt_against_the_multipliers() -> None:
    text, state = coin("P_vx = v; P_vy = -2*v", BY_GROUND), [0.1, 0.2, 0.7, 1.1, 0.4]
    found = []
    for name in ("auto", "multipliers", "euler-lagrange"):
        (source,) = emit(
            Source("coin.yaml", text), "python", Options(formulation="" if name == "auto" else name)
        ).values()
        own = python_model(source, f"belt_{name.replace('-', '_')}")
        start = own.state(0.0, state, [*_velocities(state), 0.3, -0.5, 2.0])
        found.append(own.accelerations(0.0, start))
    assert error(found[0], found[1]) < 1e-12
    assert error(found[2], found[1]) < 1e-12


def _velocities(q: list[float]) -> list[float]:
    """x' and y' from the rows, with phi' = 0.3, th' = -0.5, psi' = 2."""
    text = coin("P_vx = v; P_vy = -2*v", BY_GROUND)
    (source,) = emit(Source("coin.yaml", text), "python", Options(formulation="chaplygin")).values()
    own = python_model(source, "belt_rows")
    return list(own.velocities(0.0, [*q, 0.3, -0.5, 2.0])[:2])
