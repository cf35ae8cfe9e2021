"""One kinetic energy in the ways in which people and programs write it: the same rates, in about as many operations."""

from __future__ import annotations

import random
import re
from fractions import Fraction

import pytest
import sympy
from sympy.simplify.fu import TR8

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.polynomial import to_node
from nhc.emit import EmitOptions, render
from nhc.mechanics.energies.angles import are_products, take_apart
from nhc.mechanics.energies.arms import linear_root
from nhc.mechanics.energies.entries import Quadratic
from nhc.mechanics.energies.kinetic import energy_as_squares
from tests.numeric.test_squares import arm, operations, program_of, rewritten, system_of
from tests.support import python_model

SYSTEMS = {
    # the cart's place is the last term of its pendulums' places
    "cart": """
coordinates: [x, a, b]
parameters: {M: 1.3, m: 0.7, n: 0.4, l: 0.6, r: 0.5, g: 9.81}
define: {ax: l*sin(a) + x, ay: -l*cos(a), bx: l*sin(a) + r*sin(b) + x, by: -l*cos(a) - r*cos(b)}
T: M/2*x'^2 + m/2*(ax'^2 + ay'^2) + n/2*(bx'^2 + by'^2)
V: m*g*ay + n*g*by
""",
    "spherical": """
coordinates: [a, b, c, d]
parameters: {m: 0.7, n: 0.4, l: 0.6, r: 0.5, g: 9.81}
define:
  ax: l*sin(a)*cos(b)
  ay: l*sin(a)*sin(b)
  az: -l*cos(a)
  bx: l*sin(a)*cos(b) + r*sin(c)*cos(d)
  by: l*sin(a)*sin(b) + r*sin(c)*sin(d)
  bz: -l*cos(a) - r*cos(c)
T: m/2*(ax'^2 + ay'^2 + az'^2) + n/2*(bx'^2 + by'^2 + bz'^2)
V: m*g*az + n*g*bz
""",
    "springs": """
coordinates: [r, a, s, b]
parameters: {m: 0.7, n: 0.4, l: 0.6, k: 20, g: 9.81}
define: {ax: r*sin(a), ay: -r*cos(a), bx: r*sin(a) + s*sin(b), by: -r*cos(a) - s*cos(b)}
T: m/2*(ax'^2 + ay'^2) + n/2*(bx'^2 + by'^2)
V: m*g*ay + n*g*by + k/2*((r - l)^2 + (s - l)^2)
""",
    "top": """
coordinates: [a, b, c]
parameters: {A: 0.3, B: 0.4, C: 0.5, w: 2}
T: A/2*(a'*sin(b)*sin(c) + b'*cos(c))^2 + B/2*(a'*sin(b)*cos(c) - b'*sin(c))^2 + C/2*(c' + a'*cos(b))^2
V: w*cos(b)
""",
    # an arm of three links, its coordinates from the hand to the shoulder
    "arm": """
coordinates: [q3, q2, q1]
parameters: {g: 9.81, m: 0.8, l: 0.8, c: 0.2, I: 0.1, M: 1.2, L: 0.6, d: 0.3, J: 0.2, n: 1.4, e: 0.3, K: 0.3}
define:
  ax: (l - c)*sin(q1)
  ay: -(l - c)*cos(q1)
  bx: l*sin(q1) + d*sin(q1 + q2)
  by: -l*cos(q1) - d*cos(q1 + q2)
  cx: l*sin(q1) + L*sin(q1 + q2) + e*sin(q1 + q2 + q3)
  cy: -l*cos(q1) - L*cos(q1 + q2) - e*cos(q1 + q2 + q3)
T: >-
  m/2*(ax'^2 + ay'^2) + M/2*(bx'^2 + by'^2) + n/2*(cx'^2 + cy'^2)
  + I/2*q1'^2 + J/2*(q1' + q2')^2 + K/2*(q1' + q2' + q3')^2
V: m*g*ay + M*g*by + n*g*cy
""",
    # a tree by its joints
    "tree": """
coordinates: [q1, q2, q3, q4]
parameters: {m: 0.7, n: 0.4, M: 1, l: 0.6, r: 0.5, h: 0.3, g: 9.81}
define:
  ax: l*sin(q1)
  ay: -l*cos(q1)
  bx: ax + r*sin(q1 + q2)
  by: ay - r*cos(q1 + q2)
  cx: ax + h*sin(q1 + q3)
  cy: ay - h*cos(q1 + q3)
  dx: cx + r*sin(q1 + q3 + q4)
  dy: cy - r*cos(q1 + q3 + q4)
T: m/2*(ax'^2 + ay'^2) + n/2*(bx'^2 + by'^2) + M/2*(cx'^2 + cy'^2) + m/2*(dx'^2 + dy'^2)
V: m*g*ay + n*g*by + M*g*cy + m*g*dy
""",
    # the trailer's mass stands between its axle and its hitch
    "trailer": """
coordinates: [x, y, a, b]
parameters: {m: 1.3, n: 0.7, I: 0.3, J: 0.2, l: 0.9, c: 0.35, e: 0.2}
define:
  ax: x + e*cos(a)
  ay: y + e*sin(a)
  bx: x - l*cos(b) + c*cos(b)
  by: y - l*sin(b) + c*sin(b)
T: m/2*(ax'^2 + ay'^2) + n/2*(bx'^2 + by'^2) + I/2*a'^2 + J/2*b'^2
constraints:
  - y'*cos(a) - x'*sin(a) = 0
  - (y' - l*cos(b)*b')*cos(b) - (x' + l*sin(b)*b')*sin(b) = 0
""",
}
WAYS = {
    "velocities": lambda energy: energy,
    "multiplied out": sympy.expand,
    "simplified": lambda energy: sympy.expand(sympy.trigsimp(sympy.expand(energy))),
    "products as sums": lambda energy: sympy.expand(TR8(sympy.expand(energy))),
}


def text_of(name: str) -> str:
    return f"nhc: 1\nsystem: {name}{SYSTEMS[name]}"


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", SYSTEMS)
def test_it_costs_what_positions_do(name: str, way: str) -> None:
    plain, system = system_of(text_of(name)), system_of(rewritten(text_of(name), WAYS[way]))
    assert are_equal(system.graph, [energy_as_squares(system)], [system.T])
    expected, found = program_of(plain), program_of(system)
    assert operations(found) <= 1.06 * operations(expected)
    assert found.functions[0].calls <= expected.functions[0].calls
    first, second = (
        python_model(render(made, "python", EmitOptions())[f"{name}.py"], name) for made in (expected, found)
    )
    draw = random.Random(f"{name} {way}")
    for _ in range(3):
        y = [draw.uniform(0.3, 1.1) for _ in first.STATE]
        assert second.rhs(0.3, y) == pytest.approx(first.rhs(0.3, y), rel=1e-10, abs=1e-10)


SKEW = f"""nhc: 1
system: skew
coordinates: [x, y, a, b]
parameters: {{m: 1.3, n: 0.7, I: 0.3, J: 0.2, l: 0.9, c: 0.35, d: 0.15, e: 0.2}}
define:
  ax: x + e*cos(a)
  ay: y + e*sin(a)
  bx: x - l*cos(b) + c*cos(b) + d*sin(b)
  by: y - l*sin(b) + c*sin(b) - d*cos(b)
T: m/2*(ax'^2 + ay'^2) + n/2*(bx'^2 + by'^2) + I/2*a'^2 + J/2*b'^2
constraints:
{SYSTEMS["trailer"].partition("constraints:")[2].lstrip(chr(10))}"""
"""A trailer whose mass stands beside its axle and its middle: no square of one sum of parameters is before b'^2."""
COLLECTED = """T: >-
  a'^2*(I/2 + e^2*m/2) + b'^2*(J/2 + c^2*n/2 - c*l*n + d^2*n/2 + l^2*n/2) + (x'^2 + y'^2)*(m/2 + n/2)
  + x'*(-c*n*b'*sin(b) + d*n*b'*cos(b) - e*m*a'*sin(a) + l*n*b'*sin(b))
  + y'*(c*n*b'*cos(b) + d*n*b'*sin(b) + e*m*a'*cos(a) - l*n*b'*cos(b))
"""


@pytest.mark.parametrize("way", ["multiplied out", "simplified", "products as sums", "collected"])
def test_a_point_that_several_velocities_move_at_right_angles(way: str) -> None:
    """Whatever arms it has is in the rows of x' and y'."""
    if way == "collected":
        text = re.sub(r"(?m)^T:.*\n", COLLECTED, SKEW)
    else:
        text = rewritten(SKEW, WAYS[way])
    plain, system = system_of(SKEW), system_of(text)
    assert are_equal(system.graph, [energy_as_squares(system)], [system.T])
    expected, found = program_of(plain), program_of(system)
    assert operations(found) <= operations(expected)
    first, second = (
        python_model(render(made, "python", EmitOptions())["skew.py"], "skew") for made in (expected, found)
    )
    y = [0.3 + 0.1 * k for k in range(len(first.STATE))]
    assert second.rhs(0.0, y) == pytest.approx(first.rhs(0.0, y), rel=1e-10, abs=1e-10)


@pytest.mark.parametrize("name", ["arm", "tree"])
def test_numbers_cost_no_more_than_parameters(name: str) -> None:
    """What a number stands before tells no longer which mass it is of."""
    text = text_of(name)
    values = {k: v for k, v in re.findall(r"(\w+): ([\d.]+)", text.partition("parameters")[2].partition("}")[0])}
    head, tail = re.sub(r"(?m)^parameters.*\n", "", text).split("define:")
    put_in = re.sub(r"(?<![\w'])[a-zA-Z]\w*(?=[*/) ])", lambda m: values.get(m[0], m[0]), tail)
    plain, numbers = program_of(system_of(text)), program_of(system_of(f"{head}define:{put_in}"))
    assert not numbers.parameters
    assert operations(numbers) <= operations(plain)
    first, second = (
        python_model(render(made, "python", EmitOptions())[f"{name}.py"], name) for made in (plain, numbers)
    )
    y = [0.3 + 0.1 * k for k in range(len(first.STATE))]
    assert second.rhs(0.0, y) == pytest.approx(first.rhs(0.0, y), rel=1e-10, abs=1e-10)


ORDERS = {
    "y first": ("(y' - f*cos(b)*b' + h*sin(b)*b')", "(x' + f*sin(b)*b' + h*cos(b)*b')"),
    "mixed": ("(b'*sin(b)*h - f*cos(b)*b' + y')", "(b'*f*sin(b) + h*cos(b)*b' + x')"),
    "the rate outside": ("(b'*(sin(b)*h - f*cos(b)) + y')", "(x' + b'*(f*sin(b) + h*cos(b)))"),
}


@pytest.mark.parametrize("order", ORDERS)
def test_the_order_of_velocities_does_not_matter(order: str) -> None:
    """Components of one velocity are found in whatever order they and their terms stand."""
    text = """nhc: 1
system: skew
coordinates: [x, y, a, b]
parameters: {m: 1.3, n: 0.7, I: 0.3, J: 0.2, e: 0.2, f: 0.55, h: 0.1, l: 0.9}
T: n/2*FIRST^2 + m/2*((x' - a'*sin(a)*e)^2 + (y' + a'*cos(a)*e)^2) + n/2*SECOND^2 + I/2*a'^2 + J/2*b'^2
constraints:
  - y'*cos(a) - x'*sin(a) = 0
  - (y' - l*cos(b)*b')*cos(b) - (x' + l*sin(b)*b')*sin(b) = 0
"""
    first, second = ORDERS[order]
    wanted = "(x' + f*sin(b)*b' + h*cos(b)*b')", "(y' - f*cos(b)*b' + h*sin(b)*b')"
    plain, other = (
        program_of(system_of(text.replace("FIRST", one).replace("SECOND", two)))
        for one, two in (wanted, (first, second))
    )
    assert operations(other) == operations(plain)


def test_the_order_of_terms_does_not_matter() -> None:
    """A chain is the same from its root to its end as in any other order."""
    other = (
        text_of("cart")
        .replace("l*sin(a) + x", "x + l*sin(a)")
        .replace("l*sin(a) + r*sin(b) + x", "r*sin(b) + x + l*sin(a)")
    )
    assert operations(program_of(system_of(other))) == operations(program_of(system_of(text_of("cart"))))


def one(energy: str) -> str:
    return f"nhc: 1\nsystem: one\ncoordinates: [a, b, c]\nparameters: {{w: 2, k: 3}}\nT: (a'^2 + b'^2 + c'^2)/2 + {energy}\n"


@pytest.mark.parametrize(
    ("energy", "wanted"),
    [
        ("cos(2*a)*b'^2/5", True),
        ("(cos(a - b) + cos(a + b))*a'*b'/5", True),
        ("(cos(a + 2*b) - cos(a - 2*b))*a'*b'/5", True),
        ("cos(a - b)*a'*b'/5", False),
        ("cos(a + b)*a'*b'/5 + cos(b + c)*b'*c'/5", False),  # of joints
        ("cos(a - b)*a'*b'/5 + cos(b - a)*b'*c'/5", False),
        ("cos(a/2)*b'^2/5", False),
        ("cos(w*t)*b'^2/5", False),
    ],
)
def test_which_sines_look_as_products(energy: str, wanted: bool) -> None:
    assert are_products(system_of(one(energy))) == wanted


@pytest.mark.parametrize(
    "energy",
    ["cos(2*a - b)*b'^2/5", "sin(-a - b - 2*c)*b'*c'/5", "cos(3*a + w*t)*b'^2/5", "sin(a - (b - c) + k)*a'*c'/5"],
)
def test_what_is_taken_apart_keeps_its_value(energy: str) -> None:
    system = system_of(one(energy))
    made = take_apart(system, every=True)
    assert made != system.T
    assert are_equal(system.graph, [made], [system.T])


@pytest.mark.parametrize(
    ("square", "parts"),
    [
        ("(k - w)^2", 2),
        ("3/2*(k + 2*w)^2", 2),
        ("(k*w - w/3)^2", 2),
        ("(w - k - 1/k*w*k^2/3 + w*k)^2", 3),
        ("k^2 + w^2", 0),
        ("k^2 + 3*k*w + w^2", 0),
        ("2*k^2 + 4*k*w + w^2", 0),
        ("k^2*w^2", 0),
        ("-(k + w)^2", 0),
    ],
)
def test_squares_of_sums_of_parameters(square: str, parts: int) -> None:
    system = system_of(f"nhc: 1\nsystem: one\ncoordinates: [b]\nparameters: {{w: 2, k: 3}}\nT: ({square})*b'^2\n")
    g, p = system.graph, Quadratic(system).plus({}, system.T, Fraction(1))[0, 0]
    found = linear_root(p)
    assert len(found) == parts
    if parts:
        assert found[0][1] == 1
        first, _ = found[0]
        number = Fraction(p[tuple((f, 2 * e) for f, e in first)])
        whole = g.mul_number(number, g.power(to_node(g, dict(found)), 2))
        assert are_equal(g, [whole], [to_node(g, p)])


def test_arms_by_joints_are_no_products() -> None:
    assert not are_products(system_of(arm(4, by="cosines")))
