"""Quasi-velocities whose brackets are numbers: the rows of Poincaré and Hamel are those of every other way, and shorter."""

from __future__ import annotations

import random

import pytest

from benchmarks.models import source
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.language import decode
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.moving.structure import move_by_structure
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.model import build_program
from nhc.program.planning.planner import Planner
from tests.numeric.test_detours import assert_slopes
from tests.support import python_model

RULES = ("constant brackets", "orthonormal rows", "detours")

AXES = """
  u: cos(ps)*cos(th)*x' + sin(ps)*cos(th)*y' - sin(th)*z'
  v: (cos(ps)*sin(th)*sin(ph) - sin(ps)*cos(ph))*x' + (sin(ps)*sin(th)*sin(ph) + cos(ps)*cos(ph))*y' + cos(th)*sin(ph)*z'
  w: (cos(ps)*sin(th)*cos(ph) + sin(ps)*sin(ph))*x' + (sin(ps)*sin(th)*cos(ph) - cos(ps)*sin(ph))*y' + cos(th)*cos(ph)*z'
  p: ph' - sin(th)*ps'
  q: cos(ph)*th' + sin(ph)*cos(th)*ps'
  r: -sin(ph)*th' + cos(ph)*cos(th)*ps'"""

AIRCRAFT = """nhc: 1
system: craft
coordinates: [x, y, z, ph, th, ps]
parameters: {m: 9, A: 1.1, B: 2, C: 2.7, D: 0.2, g: 9.81, K: 3, F: 40}
NAMES:AXES
T: m/2*(u^2 + v^2 + w^2) + (A*p^2 + B*q^2 + C*r^2)/2 - D*p*r
V: -m*g*z
forces: {u: F - K*u*abs(u), v: -K*v, w: -K*w*u, p: -p, q: -q - w, r: -r + v, x: 2*sin(y)}
"""
"""An aircraft by yaw, pitch and roll, the wind pushing along an axis of the ground."""

KEELED = """nhc: 1
system: craft
coordinates: [x, y, z, a]
rotation: {R: {velocities: [p, q, r]}}
parameters: {m: 9, A: 1.1, B: 2, C: 2.7, J: 0.3, b: 0.4, g: 9.81, d: 2}
quasi_velocities:
  u: R_x1*x' + R_y1*y' + R_z1*z'
  w: R_x3*x' + R_y3*y' + R_z3*z'
define: {v: R_x2*x' + R_y2*y' + R_z2*z'}
T: m/2*((u + b*q)^2 + (v - b*p)^2 + 1.5*w^2) + (A*p^2 + B*q^2 + C*r^2)/2 + J/2*(p + a')^2 + J*cos(a)*q*a'
V: m*g*(z + b*R_z3) + cos(a)
constraints: [keel: v = 0]
forces: {u: 1 - d*u, w: -d*w, q: -d*q, a: 0.1, z: -y'}
"""
"""A body with a keel and a rotor, whose angle is in its energy; the keel has a momentum, though no velocity (erratum E3)."""


def spec(name: str) -> Source:
    texts = {
        "aircraft": AIRCRAFT.replace("NAMES", "quasi_velocities").replace("AXES", AXES),
        "aircraft by its coordinates": AIRCRAFT.replace("NAMES", "define").replace("AXES", AXES),
        "keeled": KEELED,
    }
    return Source("craft.yaml", texts[name]) if name in texts else source(name)


SYSTEMS = ("submarine", "aircraft", "aircraft by its coordinates", "keeled")


def program_of(found: Source, rules: tuple[str, ...] = (), formulation: str = "") -> tuple[int, object]:
    """The operations of the right-hand side derived without some rules, and the emitted module."""
    made = resolve(decode(found), WithoutRules(rules))
    chosen = formulate(made, formulation)
    program = build_program(
        made, chosen, equations_of(made, chosen), only=("rhs", "jacobian", "accelerations", "reactions")
    )
    rhs = next(f for f in program.functions if f.name == "rhs")
    return rhs.adds + rhs.multiplications, python_model(
        render(program, "python", EmitOptions())[f"{made.name}.py"], "own"
    )


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SYSTEMS)
def test_the_rows_are_those_of_the_multipliers(name: str) -> None:
    """Straight from T, modulo primes, reactions too; and the rates that are emitted solve them."""
    system = resolve(decode(spec(name)))
    assert certify(system).holds
    formulation = formulate(system)
    planner = Planner(equations_of(system, formulation), formulation)
    g, equations = system.graph, planner.equations
    rates = planner.known(equations.motion.rates)
    assert all(
        are_zero(g, [g.sub(g.dot(row, rates), f) for row, f in zip(equations.mass, equations.force, strict=True)])
    )


@pytest.mark.parametrize("name", SYSTEMS)
def test_they_are_shorter_and_have_the_same_values(name: str) -> None:
    fewer, own = program_of(spec(name))
    more, plain = program_of(spec(name), RULES)
    assert fewer < 0.85 * more
    assert_slopes(own, plain, name)
    draw = random.Random(name)
    for _ in range(3):
        y = [draw.uniform(0.3, 1.1) for _ in own.STATE]
        if own.CONSTRAINTS:
            assert own.reactions(0.4, y) == pytest.approx(plain.reactions(0.4, y), rel=1e-10, abs=1e-10)


def test_of_brackets_that_move_nothing_is_made() -> None:
    moving = ("u: x'*(1 + y^2), w: y'", "u: x' + sin(y)*z', w: y'", "u: x'*(2 + sin(t)), w: y'")
    for forms in (*moving, "u: x'*(1 + sqrt(y - 2)), w: y'"):  # the last has no value where brackets are read
        text = f"nhc: 1\nsystem: s\ncoordinates: [x, y, z]\nT: (u^2 + w^2 + z'^2)/2\nquasi_velocities: {{{forms}, c: z'}}\n"
        system = resolve(decode(Source("s.yaml", text)))
        frame = formulate(system, "euler-lagrange").frame
        assert frame is not None and move_by_structure(system, frame) is None


def test_velocities_of_coordinates_alone_are_no_case_for_it() -> None:
    text = "nhc: 1\nsystem: s\ncoordinates: [x, y, z]\nT: (x'^2 + y'^2 + z'^2)/2\nconstraints: [x' - z*y' = 0]\n"
    system = resolve(decode(Source("s.yaml", text)))
    frame = formulate(system, "voronec").frame
    assert frame is not None and move_by_structure(system, frame) is None
