"""Springs and dampers on one position are one force in front of what moves it: the values stay, the work becomes less."""

from __future__ import annotations

from dataclasses import replace

import pytest

from nhc.algebra.exact.modular import are_equal
from nhc.diagnostics import Source
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.formulate import equations_of
from nhc.pipeline import Options, model, program

CAR = """nhc: 1
system: car
coordinates: [z, roll, pitch, z1, z2, z3, z4]
parameters: {M: 1200, A: 500, B: 1800, m: 40, a: 1.2, b: 1.5, w: 0.7, k: 20000, c: 1500, kt: 180000, g: 9.81}
define:
  h1: z + a*sin(pitch) + w*sin(roll)*cos(pitch) - z1
  h2: z + a*sin(pitch) - w*sin(roll)*cos(pitch) - z2
  h3: z - b*sin(pitch) + w*sin(roll)*cos(pitch) - z3
  h4: z - b*sin(pitch) - w*sin(roll)*cos(pitch) - z4
T: M/2*z'^2 + A/2*roll'^2 + B/2*pitch'^2 + m/2*(z1'^2 + z2'^2 + z3'^2 + z4'^2)
V: k/2*(h1^2 + h2^2 + h3^2 + h4^2) + kt/2*(z1^2 + z2^2 + z3^2 + z4^2) + M*g*z
forces: {h1: -c*h1', h2: -c*h2', h3: -c*h3', h4: -c*h4'}
"""
CABLES = """nhc: 1
system: cables
coordinates: [x, y, th]
parameters: {m: 5, I: 0.2, g: 9.81, W: 2, H: 1.5, a: 0.2, b: 0.1, k: 2000, d: 10, L: 1.2}
define:
  l1: sqrt((x + a*cos(th) - b*sin(th) - W)^2 + (y + a*sin(th) + b*cos(th) - H)^2)
  l2: sqrt((x - a*cos(th) - b*sin(th) + W)^2 + (y - a*sin(th) + b*cos(th) - H)^2)
T: m/2*(x'^2 + y'^2) + I/2*th'^2
V: m*g*y + k/2*((l1 - L)^2 + (l2 - L)^2)
forces: {l1: -d*l1', l2: -d*l2', th: -d*th'}
"""
GEAR = """nhc: 1
system: gear
coordinates: [s, c, p, r]
parameters: {Js: 0.01, Jc: 0.1, Jp: 0.002, Jr: 0.2, Rs: 0.05, Rp: 0.03, Rr: 0.11, ts: 1, tc: -2, kr: 100, cr: 1}
T: Js/2*s'^2 + Jc/2*c'^2 + Jp/2*p'^2 + Jr/2*r'^2
V: kr/2*r^2
forces: {s: ts, c: tc, r: -cr*r'}
constraints:
  - sun: Rs*s' + Rp*p' - (Rs + Rp)*c' = 0
  - ring: Rr*r' - Rp*p' - (Rs + Rp)*c' = 0
"""
NESTED = """nhc: 1
system: nested
coordinates: [x, y, z, u]
parameters: {m: 1, k: 3, c: 0.2, e: 0.4}
define:
  d: x*y + z^2 - e*sin(t)
  h: d - u
  same: x*y + z^2 - e*sin(t)
  back: u - d
  place: x
T: m/2*(x'^2 + y'^2 + z'^2 + u'^2)
V: k/2*d^2 + k*h^4/4 + sin(x)
forces: {d: -c*d' + cos(t), h: -c*h'*h^2, same: -c*same', back: t, x: -c*x' - x, place: 3, z: z'*u}
constraints: ["z' - y*x' - e*t = 0", "(1 + t)*u' - x*y' + z = 0"]
"""
"""Positions that are made of others, that have two names, and that are coordinates."""
MOST = {CAR: 92, CABLES: 78, GEAR: 54, NESTED: 112}
"""Operations of the right-hand side."""


@pytest.mark.parametrize("text", MOST)
def test_the_rows_are_the_same_and_the_program_is_short(text: str) -> None:
    source = Source("spec.yaml", text)
    made = model(source)
    system = made.system
    assert system.pulls is not None
    plain = equations_of(replace(system, pulls=None), made.formulation)
    joined = equations_of(system, made.formulation)
    assert are_equal(system.graph, joined.force, plain.force)
    assert are_equal(system.graph, [x for row in joined.mass for x in row], [x for row in plain.mass for x in row])
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.adds + rhs.multiplications + rhs.divisions <= MOST[text]


@pytest.mark.parametrize("text", MOST)
def test_all_formulations_agree(text: str) -> None:
    assert all(
        agreement.accelerations for agreement in certify(model(Source("spec.yaml", text)).system, points=1).agreements
    )
