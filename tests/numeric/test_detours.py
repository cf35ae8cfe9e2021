"""Lagrange's equations by way of T's own angular velocities: the same accelerations, refused at the same places."""

from __future__ import annotations

import ctypes
import math
import random
from pathlib import Path
from types import ModuleType

import pytest

from benchmarks.models import source
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.rewriting.rules import WithoutRules
from nhc.algebra.show import to_text
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.language import decode, read
from nhc.mechanics.choosing.choose import formulate
from nhc.mechanics.detour import Detour, find_detour
from nhc.mechanics.formulate import equations_of
from nhc.mechanics.frame import form_value, kept_forms
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit
from nhc.program.model import build_program
from nhc.program.planning.planner import Planner
from tests.support import compile_c, doubles, python_model, spec_path

CRAFT = """nhc: 1
system: craft
coordinates: [x, z, yaw, pitch, roll, a]
parameters: {A: 0.02, B: 0.022, C: 0.04, m: 1.2, M: 0.4, l: 1, g: 9.81, F: 15, tq: 0.02, Om: 0.7}
define:
  px: x + l*sin(a)
  pz: z - l*cos(a)
  p: roll' - (yaw' + Om*t)*sin(pitch)
  q: pitch'*cos(roll) + (yaw' + Om*t)*sin(roll)*cos(pitch)
  r: (yaw' + Om*t)*cos(roll)*cos(pitch) - pitch'*sin(roll)
T: (m*(x'^2 + z'^2) + A*p^2 + B*q^2 + C*r^2 + M*(px'^2 + pz'^2))/2
V: g*(m*z + M*pz) + roll^2*a
forces: {x: F*sin(pitch)*cos(yaw), z: F*cos(roll)*cos(pitch), pitch: -tq*pitch', q: tq*t}
"""
"""A body on which a load hangs, seen from a table that turns faster and faster: the forms of T hold the time."""

TWO = """nhc: 1
system: two
coordinates: [a, b, c, d]
parameters: {I: 0.3, J: 0.2, k: 2}
T: (I*(a' + sin(b)*c')^2 + J*b'^2 + I*c'^2 + J*(d' - cos(b)*a')^2)/2
V: k*(1 - cos(b)) + k*a*d
"""
"""Forms that no three of them belong to a body: each holds a velocity that no other has."""

SUSLOV = """nhc: 1
system: gyrostat
coordinates: {ps: {}, th: {range: [0.2, 2.9]}, ph: {}}
parameters: {A: 1, B: 1.6, C: 2, D: 0.2, h: 0.5, e: 1.2, b: 0, c: 0.1}
define:
  w1: ps'*sin(th)*sin(ph) + th'*cos(ph)
  w2: ps'*sin(th)*cos(ph) - th'*sin(ph)
  w3: ps'*cos(th) + ph'
T: (A*w1^2 + B*w2^2 + C*w3^2)/2 + D*w1*w3 + h*w2
V: e*cos(th)
forces: {th: -c*th'}
constraints: [w3*cos(b) + w1*sin(b) = t*sin(t)/9]
"""
"""A body with a wheel inside, which does not turn about a line fixed in it: w2 and w3 are simplest, and singular with sin b."""

COIN = """nhc: 1
system: coin
coordinates: [x, y, phi, th, psi]
parameters: {m: 0.3, R: 0.25, g: 9.81, Om: 0.4}
bodies:
  frame: {at: [x, y, R*sin(th)], turns: [z: phi, x: th]}
  coin: {parent: frame, turns: [z: psi], mass: m, inertia: [m*R^2/4, m*R^2/4, m*R^2/2]}
points:
  P: {parent: frame, of: coin, at: [0, -R, 0]}
gravity: [0, 0, -g]
constraints: [P_vx = -Om*y, P_vy = Om*x]
"""
"""A coin by its angles, on a turntable."""

CYLINDER = """nhc: 1
system: disc_in_a_cylinder
coordinates: {u: {range: [-1.2, 1.2]}, w: {}, ya: {}, th: {range: [0.3, 2.8]}, sp: {}}
parameters: {m: 0.5, R: 0.2, Rc: 2, A: 0.005, C: 0.01, g: 9.81}
bodies:
  K: {at: [Rc*sin(u), w, Rc*cos(u)], turns: [y: u, z: ya]}
  fr: {parent: K, turns: [x: th]}
  disc: {parent: fr, at: [0, R, 0], turns: [z: sp], mass: m, inertia: [A, A, C]}
points:
  P: {parent: K, of: disc, at: [0, 0, 0]}
gravity: [0, 0, -g]
constraints: [P_v1 = 0, P_v2 = 0]
"""
"""Angular velocities that are singular where R cos(ya)^2 = -Rc sin(th), and the mass matrix is not."""


OFF_CENTRE = """nhc: 1
system: off_centre
coordinates: [x, y, z]
rotation: {R: {velocities: [p, q, r]}}
parameters: {m: 3, A: 1, B: 2, C: 2.2, c: 0.1, d: 0.05, g: 9.81}
bodies: {b: {at: [x, y, z], rotation: R, mass: m, centre: [c, 0, d], inertia: [A, B, C]}}
gravity: [0, 0, -g]
forces: {p: -p, x: -0.2*x', r: 0.1*t}
"""
"""A body whose coordinates are those of another point than its centre, which moves by itself."""


def spec(name: str) -> Source:
    texts = {"craft": CRAFT, "two": TWO, "gyrostat": SUSLOV, "coin": COIN, "disc_in_a_cylinder": CYLINDER}
    texts["off_centre"] = OFF_CENTRE
    if name in texts:
        return Source(f"{name}.yaml", texts[name])
    return read(str(spec_path(name))) if spec_path(name).exists() else source(name)


LIMBS = """nhc: 1
system: limbs
coordinates: [x, y, z, yaw, pitch, roll, a1, a2, a3, a4, a5, a6, a7, a8]
parameters: {M: 10, A: 0.1, B: 0.3, C: 0.35, m: 1, I: 0.02, J: 0.001, l: 0.15, d: 0.3, g: 9.81}
bodies:
  trunk: {at: [x, y, z], turns: [z: yaw, y: pitch, x: roll], mass: M, inertia: [A, B, C]}
  limb1: {parent: trunk, at: [d, 0, 0], turns: [x: a1, y: a2], mass: m, centre: [0, 0, -l], inertia: [I, I, J]}
  limb2: {parent: limb1, at: [0, 0, -d], turns: [y: a3], mass: m, centre: [0, 0, -l], inertia: [I, I, J]}
  limb3: {parent: trunk, at: [-d, 0, 0], turns: [x: a4, y: a5], mass: m, centre: [0, 0, -l], inertia: [I, I, J]}
  limb4: {parent: limb3, at: [0, 0, -d], turns: [y: a6], mass: m, centre: [0, 0, -l], inertia: [I, I, J]}
  limb5: {parent: trunk, at: [0, d, 0], turns: [y: a7], mass: m, centre: [0, 0, -l], inertia: [I, I, J]}
  limb6: {parent: trunk, at: [0, -d, 0], turns: [y: a8], mass: m, centre: [0, 0, -l], inertia: [I, I, J]}
gravity: [0, 0, -g]
"""
"""A free body by yaw, pitch and roll with six limbs: more coordinates than a matrix of them should have."""


def test_a_body_with_limbs_is_solved_in_its_angular_velocity() -> None:
    """In fewer operations than from the leaves to the root in space, and with the same rates; in fewest on the bodies' own axes."""
    found = []
    others = ("own axes", "composite inertias")
    for rules in (others, (*others, "detours"), ()):
        made = resolve(decode(Source("limbs.yaml", LIMBS)), WithoutRules(rules))
        formulation = formulate(made)
        program = build_program(made, formulation, equations_of(made, formulation), only=("rhs",))
        (rhs,) = program.functions
        module = python_model(render(program, "python", EmitOptions())["limbs.py"], "limbs")
        found.append((rhs.adds + rhs.multiplications, module.rhs(0.0, [0.3 + 0.05 * k for k in range(28)])))
    assert found[2][0] < 0.7 * found[0][0] < 0.7 * 0.92 * found[1][0]
    assert found[0][1] == pytest.approx(found[1][1], rel=1e-10, abs=1e-10)
    assert found[0][1] == pytest.approx(found[2][1], rel=1e-10, abs=1e-10)


SYSTEMS = ("craft", "two", "heavy_top", "smooth_tippe_top", "satellite2", "gyrostat", "coin", "off_centre")


def detour_of(name: str) -> Detour | None:
    system = resolve(decode(spec(name)))
    formulation = formulate(system)
    return find_detour(equations_of(system, formulation), kept_forms(system, formulation.frame))


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_rates_solve_the_equations_exactly(name: str) -> None:
    """Of the assembled mass matrix, which knows of no detour; modulo primes."""
    system = resolve(decode(spec(name)))
    formulation = formulate(system)
    planner = Planner(equations_of(system, formulation), formulation)
    assert find_detour(planner.equations, kept_forms(system, formulation.frame)) is not None
    g, equations = system.graph, planner.equations
    rates = planner.known(equations.motion.rates)
    residual = [g.sub(g.dot(row, rates), f) for row, f in zip(equations.mass, equations.force, strict=True)]
    assert all(are_zero(g, residual))


def module_of(source: Source, rules: tuple[str, ...] = (), only: tuple[str, ...] = ("rhs", "jacobian")) -> ModuleType:
    """The emitted Python of a spec that is derived without some rules."""
    made = resolve(decode(source), WithoutRules(rules))
    formulation = formulate(made)
    program = build_program(made, formulation, equations_of(made, formulation), only=only)
    return python_model(render(program, "python", EmitOptions())[f"{made.name}.py"], made.name)


def _module(name: str, rules: tuple[str, ...] = ()) -> ModuleType:
    return module_of(spec(name), rules)


def assert_slopes(own: ModuleType, plain: ModuleType, seed: str) -> None:
    """The Jacobian matrix is that of the right-hand side ``plain``, by differences that are exact to 1e-9."""
    draw, size, h = random.Random(seed), len(own.STATE), 1e-4
    y = [draw.uniform(0.3, 1.1) for _ in range(size)]
    rows = own.jacobian(0.4, y)
    assert own.rhs(0.4, y) == pytest.approx(plain.rhs(0.4, y), rel=1e-11, abs=1e-11)
    for j in range(size):
        beside = [plain.rhs(0.4, [x + k * h * (i == j) for i, x in enumerate(y)]) for k in (-2, -1, 1, 2)]
        slopes = [(a - 8 * b + 8 * c - d) / (12 * h) for a, b, c, d in zip(*beside, strict=True)]
        assert [row[j] for row in rows] == pytest.approx(slopes, rel=1e-7, abs=1e-7)


@pytest.mark.parametrize("name", SYSTEMS)
def test_the_jacobian_is_that_of_the_rates(name: str) -> None:
    assert_slopes(_module(name), _module(name, ("detours",)), name)


def test_a_body_off_its_centre_turns_by_itself() -> None:
    """Euler's equations, then what they give to the point: two thirds of what a matrix for all six takes."""
    system = resolve(decode(spec("off_centre")), WithoutRules(["detours"]))
    formulation = formulate(system)
    (plain,) = build_program(system, formulation, equations_of(system, formulation), only=("rhs",)).functions
    system = resolve(decode(spec("off_centre")))
    (rhs,) = build_program(system, formulate(system), equations_of(system, formulate(system)), only=("rhs",)).functions
    assert rhs.adds + rhs.multiplications < 0.67 * (plain.adds + plain.multiplications)


@pytest.mark.parametrize("lean", [0.0, 1e-9, 1e-5])
def test_a_gimbal_lock_is_refused_where_it_is(lean: float, tmp_path: Path) -> None:
    """And as near to it as without a detour, in both languages."""
    y = [0.2, math.pi / 2 - lean, 0.3, 0.1, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8]
    folder = compile_c(emit(spec("satellite2"), "c", Options(only=("rhs",))), tmp_path, "satellite2")
    call = ctypes.CDLL(str(folder)).satellite2_rhs
    out = (ctypes.c_double * len(y))()
    defaults = [float(x) for x in _module("satellite2").DEFAULTS]
    status = call(ctypes.c_double(0.0), doubles(y), doubles(defaults), out)
    for rules in ((), ("detours",)):
        if lean < 1e-7:
            assert status == 2
            with pytest.raises(ArithmeticError, match="the mass matrix is singular"):
                _module("satellite2", rules).rhs(0.0, y)
        else:
            assert status == 0 and all(math.isfinite(x) for x in out)
            assert _module("satellite2", rules).rhs(0.0, y) == pytest.approx(list(out), rel=1e-4)


@pytest.mark.parametrize(
    "name", ["double_pendulum", "spherical_pendulum", "pendulum5", "free_rigid_body_quaternion", "rolling_disk"]
)
def test_no_detour_where_every_form_is_the_rate_of_a_position_or_kept(name: str) -> None:
    assert detour_of(name) is None


def test_under_constraints_a_detour_is_singular_only_where_the_state_is() -> None:
    """With sin b in the determinant a wheel along the third axis, b = 0, could not be moved."""
    found = detour_of("gyrostat")
    assert found is not None
    g = found.graph
    assert [to_text(g, form_value(found.frame.system, form)) for form in found.frame.forms[1:]] == [
        "ps'*sin(th)*sin(ph) + th'*cos(ph)",
        "ps'*sin(th)*cos(ph) - th'*sin(ph)",
    ]
    assert [to_text(g, determinant) for determinant, _ in found.frame.guards] == ["sin(th)", "cos(b)"]


def test_where_a_disc_is_as_bent_as_the_cylinder_both_ways_are_singular() -> None:
    """R cos(ya)^2 = -Rc sin(th): there it rests on a line, and the matrix of the state is singular without any detour."""
    found = detour_of("disc_in_a_cylinder")
    assert found is not None
    assert [to_text(found.graph, determinant) for determinant, _ in found.frame.guards] == ["R*cos(ya)^2 + Rc*sin(th)"]
    plain = _module("disc_in_a_cylinder", ("detours",))
    values = dict(zip(plain.PARAMETERS, plain.DEFAULTS, strict=True))
    lean = -math.asin(values["R"] * math.cos(0.2) ** 2 / values["Rc"])
    for beside in (0.0, 0.1):
        y = [{"ya": 0.2, "th": lean + beside}.get(name, 0.3) for name in plain.STATE]
        if beside:
            assert all(math.isfinite(x) for x in plain.rhs(0.0, y))
        else:
            with pytest.raises(ArithmeticError, match="the mass matrix is singular"):
                plain.rhs(0.0, y)


def test_a_detour_under_constraints_is_shorter() -> None:
    """Than the way without, which canonical forms have made shorter for the coin (71 operations before)."""
    for name, least, most in (("gyrostat", 99, 0.75), ("coin", 56, 0.91)):
        lengths = []
        for rules in ((), ("detours",)):
            made = resolve(decode(spec(name)), WithoutRules(rules))
            formulation = formulate(made)
            (rhs,) = build_program(made, formulation, equations_of(made, formulation), only=("rhs",)).functions
            lengths.append(rhs.adds + rhs.multiplications + rhs.divisions)
        assert lengths[0] <= least and lengths[0] < most * lengths[1]


def test_the_lock_of_a_constrained_body_is_refused_where_it_is() -> None:
    """And beside it the rates are those of the matrix."""
    y = [0.2, 0.0, 0.3, 0.5, 0.6]
    for rules in ((), ("detours",)):
        with pytest.raises(ArithmeticError, match="the mass matrix is singular"):
            _module("gyrostat", rules).rhs(0.0, y)
    near = [y[0], 1e-5, *y[2:]]
    assert _module("gyrostat").rhs(0.0, near) == pytest.approx(
        _module("gyrostat", ("detours",)).rhs(0.0, near), rel=1e-4
    )


@pytest.mark.parametrize("b", [0.0, math.pi / 2])
def test_a_detour_is_refused_nowhere_where_the_matrix_is_regular(b: float) -> None:
    """With a' or d' beside T's two forms it would be singular at sin b = 0 or at cos b = 0; with c' it is not."""
    y = [0.1, b, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8]
    assert _module("two").rhs(0.0, y) == pytest.approx(_module("two", ("detours",)).rhs(0.0, y), rel=1e-12)
