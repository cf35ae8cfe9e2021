"""Sums of parameters and the time stay whole in canonical forms where that is shorter."""

from __future__ import annotations

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph
from nhc.algebra.polynomial import normalise
from nhc.algebra.walks import count
from nhc.diagnostics import Source
from nhc.mechanics.certificates.certificate import certify
from nhc.pipeline import Options, model, program

HOOP = """nhc: 1
system: hoop
about: two beads joined by a spring on a hoop that swells, and turns about its vertical diameter
coordinates: [a, b]
parameters: {m: 1, n: 2, R: 1, e: 0.1, w: 2, O: 3, g: 9.81, k: 5, c: 0.1}
define:
  r: R*(1 + e*sin(w*t))
  X: r*sin(a)*cos(O*t)
  Y: r*sin(a)*sin(O*t)
  Z: -r*cos(a)
  X2: r*sin(b)*cos(O*t)
  Y2: r*sin(b)*sin(O*t)
  Z2: -r*cos(b)
T: m/2*(X'^2 + Y'^2 + Z'^2) + n/2*(X2'^2 + Y2'^2 + Z2'^2)
V: m*g*Z + n*g*Z2 + k/2*((X - X2)^2 + (Y - Y2)^2 + (Z - Z2)^2)
forces: {a: -c*a', b: -c*b'}
"""


def test_a_length_that_changes_with_the_time_is_a_factor() -> None:
    g = Graph()
    t, e, w = g.symbol("t", "time"), g.symbol("e", "parameter"), g.symbol("w", "parameter")
    x, y = g.symbol("x", "coordinate"), g.symbol("y", "coordinate")
    length = g.add(g.one, g.mul(e, g.function("sin", g.mul(w, t))))
    node = g.mul(g.power(length, 2), g.add(y, g.mul(x, g.power(length, 2))))
    made = normalise(g, node)
    assert are_equal(g, [made], [node])
    assert count(g, [made]) <= count(g, [node])  # multiplied out it has 9 terms


def test_a_hoop_that_swells_takes_few_operations() -> None:
    source = Source("hoop.yaml", HOOP)
    (rhs,) = program(source, Options(only=("rhs",))).functions
    assert rhs.adds + rhs.multiplications + rhs.divisions <= 51
    assert all(agreement.accelerations for agreement in certify(model(source).system, points=1).agreements)
