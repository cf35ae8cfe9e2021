"""Rates whose matrix has a short inverse: the same rates and slopes as by L D L^T, in fewer operations, and singular with it."""

from __future__ import annotations

import random

import pytest

from benchmarks.systems import spec
from nhc.algebra.exact.modular import are_equal
from nhc.algebra.graph import Graph
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.resolving.resolve import resolve
from nhc.program.planning.planner import Planner
from nhc.program.planning.short_inverse import short_inverse
from tests.numeric.test_detours import assert_slopes, module_of
from tests.numeric.test_squares import operations, program_of
from tests.property.test_rules import transplant

RULE = "short inverses"
HEAD = "nhc: 1\nsystem: s\nparameters: {m: 1.3, a: 0.2, b: 2.5, k: 0.3, c: 2, g: 9.81, d: 2.7, B: 0.7, I1: 0.1, I2: 0.2, I3: 0.3}\n"
OMEGA = "rotation: {R: {velocities: [wx, wy, wz], frame: space}}\n"
ROLLING = 'constraints: ["x\' - a*(wy*nz - wz*ny) = 0", "y\' - a*(wz*nx - wx*nz) = 0"]\n'
BALL = f"{OMEGA}T: m/2*(x'^2 + y'^2 + z'^2) + k*m*a^2*(wx^2 + wy^2 + wz^2)\nV: m*g*z\n{ROLLING}"
SYSTEMS = {
    "point on a sphere": (
        f"{HEAD}coordinates: [x, y]\ndefine: {{z: sqrt(b^2 - x^2 - y^2)}}\nT: m/2*(x'^2 + y'^2 + z'^2)\nV: m*g*z\n",
        0.85,
    ),
    "point at half the speed of light": (
        f"{HEAD}coordinates: [x, y]\nT: -m*c^2*sqrt(1 - (x'^2 + y'^2)/(4*c^2)) + B*(x*y' - y*x')\nV: -g*x\n",
        0.92,
    ),
    "ball on a ball": (
        f"{HEAD}coordinates: [x, y]\ndefine: {{z: sqrt(d^2 - x^2 - y^2), nx: x/d, ny: y/d, nz: z/d}}\n{BALL}",
        0.65,
    ),
    "ball in a bowl of revolution": (
        f"{HEAD}coordinates: [x, y]\ndefine: {{h: sqrt(1 + 4*(x^2 + y^2)), nx: -2*x/h, ny: -2*y/h, nz: 1/h, z: x^2 + y^2}}\n{BALL}",
        0.95,
    ),
    "body with three moments in a ball": (
        f"{HEAD}coordinates: [x, y]\nrotation: {{R: {{velocities: [w1, w2, w3]}}}}\n"
        "define: {u: R_x1*w1 + R_x2*w2 + R_x3*w3, v: R_y1*w1 + R_y2*w2 + R_y3*w3}\n"
        "T: m/2*(x'^2 + y'^2) + (I1*w1^2 + I2*w2^2 + I3*w3^2)/2\nconstraints: [x' = a*v, y' = -a*u]\n",
        1.0,
    ),
}


def model(text: str, graph: Graph) -> Planner:
    system = resolve(decode(Source("s.yaml", text)), graph)
    formulation = formulate(system)
    return Planner(equations_of(system, formulation), formulation)


@pytest.mark.parametrize("name", SYSTEMS)
def test_rates_are_those_of_the_whole_matrix(name: str) -> None:
    text, most = SYSTEMS[name]
    with_all, without = Graph(), WithoutRules([RULE])
    short, long = ([t.node for t in model(text, g).rhs().targets] for g in (with_all, without))
    assert are_equal(without, transplant(short, with_all, without), long)
    source = Source("s.yaml", text)
    own, plain = (operations(program_of(resolve(decode(source), g))) for g in (Graph(), WithoutRules([RULE])))
    assert own <= most * plain


@pytest.mark.parametrize("name", SYSTEMS)
def test_slopes_are_those_of_the_rates(name: str) -> None:
    source = Source("s.yaml", SYSTEMS[name][0])
    assert_slopes(module_of(source), module_of(source, (RULE,)), name)


@pytest.mark.parametrize("name", ["chaplygin_ball", "dome"])
def test_the_solver_solves_for_any_right_side(name: str) -> None:
    """M x = r by exact test, for symbols r."""
    system = resolve(decode(Source("s.yaml", spec(name))))
    equations, g = equations_of(system, formulate(system)), system.graph
    found = short_inverse(system, equations.mass, equations.force)
    assert found is not None
    right = [g.symbol(f"r{k}", "test") for k in range(len(equations.mass))]
    solved = found[1](right)
    assert are_equal(g, [g.dot(row, solved) for row in equations.mass], right)


GEARS = (
    "nhc: 1\nsystem: gears\ncoordinates: [a, b, c]\nparameters: {J1: 1, J2: 2, J3: 3, J: 0.5, k: 2}\n"
    "T: (J1*a'^2 + J2*b'^2 + J3*c'^2 + J*(a' + b' + c')^2)/2\nV: k*(a^2 + b^4 + a*c^3)\n"
)


def test_a_gear_without_inertia_of_its_own_turns_with_the_others() -> None:
    """J J2 J3 is the determinant then: nothing may be divided by the first gear's own inertia."""
    own = module_of(Source("gears.yaml", GEARS), only=("rhs",))
    a, b, c, p = 0.3, 0.5, 0.7, [0.0, 2.0, 3.0, 0.5, 2.0]
    rates = own.rhs(0.0, [a, b, c, 0.1, 0.2, 0.3], p)[3:]
    torques = [-2 * (2 * a + c**3), -2 * 4 * b**3, -2 * 3 * a * c**2]
    whole = 0.5 * sum(rates)
    assert [own_inertia * rate + whole for own_inertia, rate in zip(p, rates, strict=False)] == pytest.approx(torques)


@pytest.mark.parametrize("value", ["I: {I1: 0, I2: 0, I3: 0}", "J: {m: 0, I2: 0}"])
def test_what_has_no_inertia_is_singular(value: str) -> None:
    """Of a ball without moments of inertia the spin is not determined, of one without mass a turn about one axis."""
    own = module_of(Source("s.yaml", spec("chaplygin_ball")), only=("rhs",))
    draw = random.Random(value)
    y = [draw.uniform(0.3, 1.1) for _ in own.STATE]
    zeros = [name for name in ("I1", "I2", "I3", "m") if f"{name}: 0" in value]
    p = [0.0 if name in zeros else 0.5 for name in own.PARAMETERS]
    assert own.rhs(0.0, y, [0.5] * len(p))
    with pytest.raises(own.SingularModelError):
        own.rhs(0.0, y, p)
