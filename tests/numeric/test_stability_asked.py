"""The laboratory studies the motion of the scene: in the velocities in which it is steady, and as far as it grows."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from nhc.diagnostics import Source
from nhc.pipeline import Options, linearize, stability
from nhc.study.linearization.linearize import eigenvalues
from nhc.study.linearization.motion import Request
from nhc.study.linearization.units import Vector
from nhc.study.stability.laboratory import Laboratory, Question
from nhc.study.stability.table import lines

TROLLEY = """nhc: 1
system: trolley
coordinates: {x: {}, y: {}, th: {}, de: {range: [-pi, pi]}}
parameters: {m: 20, J: 2, mc: 0.5, Jc: 0.01, b: 0.6, a: 0.3, tr: 0.05, c: 0.02}
bodies:
  body: {at: [x, y], turns: [z: th], mass: m, centre: [a, 0], inertia: J}
  fork: {parent: body, at: [b, 0], turns: [z: de], mass: mc, centre: [-tr, 0], inertia: Jc}
points:
  rear: {parent: body, at: [0, 0]}
  wheel: {parent: fork, at: [-tr, 0]}
constraints: [rear_v2 = 0, wheel_v2 = 0]
forces: {de: -c*de'}
quasi_velocities: {u: rear_v1, dd: de'}
scenes:
  pull: {initial: {u: -1, de: 0.1}, time: [0, 2]}
"""
"""Its caster swings round, on the way the quasi-velocities fail: the scene is run with multipliers."""

SKATE = """nhc: 1
system: skate
coordinates: [x, y, theta]
parameters: {m: 1, I: 0.3, F: 1, c: 1, M: 0.5, d: 0.5}
define: {v: cos(theta)*x' + sin(theta)*y'}
T: m/2*(x'^2 + y'^2) + I/2*theta'^2
forces: {v: F - c*v, theta: M - d*theta'}
constraints: ["-sin(theta)*x' + cos(theta)*y' = 0"]
quasi_velocities: {u: x', w: theta'}
scenes:
  bend: {initial: {theta: 0.2, u: 1, w: 1}, time: [0, 2]}
"""
"""x' is no velocity in which a bend is steady."""

CART = """nhc: 1
system: cart
coordinates: [x, y, th, fl, fr, be]
parameters: {r: 0.15, b: 0.28, lp: 0.2, d: 0.02}
bodies:
  axle: {at: [x, y, r], turns: [{z: th}], mass: 12, inertia: [0.1, 0.1, 0.7]}
  left: {parent: axle, at: [0, b, 0], turns: [{y: fl}], mass: 1.1, inertia: [0.006, 0.012, 0.006]}
  right: {parent: axle, at: [0, -b, 0], turns: [{y: fr}], mass: 1.1, inertia: [0.006, 0.012, 0.006]}
  load: {parent: axle, at: [0, 0, 0.8], turns: [{x: be}], mass: 0.8, centre: [0, 0, -lp]}
points:
  pl: {parent: axle, of: left, at: [0, b, -r]}
  pr: {parent: axle, of: right, at: [0, -b, -r]}
gravity: [0.5, 0, -9.8]
constraints: [pl_v1 = 0, pr_v1 = 0, pl_v2 = 0]
forces: {fl: -d*fl', fr: -d*fr', be: -d*be'}
scenes: {go: {initial: {th': 0.3, be: 0.4, fl: 0, x': 0}, time: [0, 2]}}
"""
"""Of the start that keeps to its constraints x' is zero but for rounding."""

TURNTABLE = """nhc: 1
system: turntable
coordinates: [x, y, th]
parameters: {m: 1, J: 0.2, Om: 0.8}
T: m/2*(x'^2 + y'^2) + J/2*th'^2
constraints: ["-sin(th)*(x' + Om*y) + cos(th)*(y' - Om*x) = 0"]
scenes:
  s: {initial: {x: 0.5, th: 0.2, th': 0.4, x': 0.3}, time: [0, 8]}
"""
"""A knife edge that the table throws out: after ten lengths of the scene it is 1e22 times as far away."""

KEPLER = """nhc: 1
system: kepler
coordinates: [x, y]
T: (x'^2 + y'^2)/2
V: -1/sqrt(x^2 + y^2)
scenes:
  near: {initial: {x: 1, y: 0, y': 0.01}, time: [0, 2]}
"""

SLOPE = """nhc: 1
system: slope
coordinates: [s]
parameters: {m: 1, k: 3, c: 1}
T: m/2*s'^2
V: k/2*s^2
forces: {s: -c*s'}
scenes: {down: {initial: {s: 0, s': 2}, time: [0, 3]}}
"""

HOOP = """nhc: 1
system: hoop
coordinates: [phi, psi, al]
parameters: {M: 1, m: 0.4, r: 0.2, d: 0.8, l: 0.15, g: 9.81}
define:
  X: d*sin(phi)
  Y: -d*cos(phi)
  px: X + l*sin(al)
  py: Y - l*cos(al)
T: M/2*(X'^2 + Y'^2) + M*r^2/2*psi'^2 + m/2*(px'^2 + py'^2)
V: M*g*Y + m*g*py
constraints: ["r*psi' + d*phi' = 0"]
scenes: {s: {initial: {phi: 0.3, al: 0.2}, time: [0, 2]}}
"""
"""It rolls inside a cylinder, and a weight hangs from its centre: T holds phi."""

HILL = """nhc: 1
system: hill
coordinates: [x, y]
T: (x'^2 + y'^2)/2
forces: {x: 4*x + y, y: -y}
scenes: {s: {initial: {x: 1e-3, y: 1}, time: [0, 5]}}
"""

MATHIEU = """nhc: 1
system: mathieu
coordinates: [x]
T: x'^2/2
forces: {x: "-(1 + cos(2*t)/2)*x"}
scenes: {s: {initial: {x: 1}, time: [0, 20]}}
"""


def look(text: str, question: Question | None = None, formulation: str = "") -> Laboratory:
    return stability(Source("spec.yaml", text), question or Question(), Options(formulation=formulation))


@pytest.mark.slow
def test_the_motion_is_that_of_the_velocities_that_the_scene_begins_with() -> None:
    """Voronec's equations, which stand for multipliers, have an equilibrium nearby."""
    found = look(TROLLEY)
    assert found.bench.formulation.name == "multipliers" and found.motion is not None
    state = dict(zip(found.motion.flow.names, found.motion.linearisation.steady.y, strict=True))
    assert state["u"] == pytest.approx(-1) and found.motion.lost == ()
    alone = linearize(Source("spec.yaml", TROLLEY), Request("pull")).linearisation
    assert eigenvalues(found.motion.linearisation) == pytest.approx(eigenvalues(alone))
    swept = look(TROLLEY, Question(sweep=("u", -2.0, -0.5, 4)))
    assert swept.motion is not None and swept.motion.swept is not None


def test_what_of_the_motion_has_gone_is_said() -> None:
    found = look(SLOPE)
    assert found.motion is not None and found.motion.halted
    assert any("s' = 2 has become 0" in line and "not the motion of the scene" in line for line in lines(found))


def test_a_zero_that_was_given_has_not_gone() -> None:
    found = look(CART)
    assert found.motion is not None
    assert [text.split(" has")[0] for text in found.motion.lost] == ["th' = 0.3"]


def test_a_bend_is_found_in_axes_that_turn_with_it() -> None:
    """Also where the quasi-velocities of the spec are no help."""
    alone = linearize(Source("spec.yaml", SKATE), Request("bend")).linearisation
    found = look(SKATE).motion
    assert found is not None
    for made in (alone, found.linearisation):
        assert eigenvalues(made) == pytest.approx([-1, -0.5 / 0.3])


@pytest.mark.parametrize(
    ("text", "rate"),
    [
        (TURNTABLE, 0.8 * math.sqrt(3) / 2),  # th stays nearly; e^(0.8 t) but for the edge
        (HILL, 2.0),
        (MATHIEU, 0.1241),  # by Floquet's multipliers
    ],
)
def test_the_law_of_what_outgrows_its_scene(text: str, rate: float) -> None:
    found = look(text).sensitivity
    assert found is not None and found.law.name == "exponential"
    assert found.law.rate == pytest.approx(rate, rel=0.01)


def test_the_distance_is_that_of_the_velocities_that_are_solved_for() -> None:
    """Čaplygin's equations need psi', though phi' is the better conditioned choice."""
    found = look(HOOP)
    choice = found.bench.formulation.dependent
    assert choice is not None and found.bench.formulation.name == "chaplygin"
    (solved,) = (d for d in found.distances if d.kind == "dependent")
    names = [found.bench.equations.system.q_names[i] for i in choice.dependent]
    assert solved.what == f"solving for {', '.join(f'{name}{chr(39)}' for name in names)}"
    assert solved.least == pytest.approx(0.2 / math.hypot(0.2, 0.8), rel=1e-3)


def test_a_zero_that_rounding_has_parted_is_zero() -> None:
    found = linearize(Source("spec.yaml", TURNTABLE), Request("s"), Options(formulation="voronec")).linearisation
    assert [x.imag for x in eigenvalues(found)] == [0, 0, 0]
    assert eigenvalues(found) == pytest.approx([0, 0, 0], abs=1e-12)


@pytest.mark.slow
def test_the_top_of_a_growth_that_shrinks_again() -> None:
    """Past a near collision, 2e8 times as large for a moment: the variational equations with the emitted Jacobian say so, too."""
    found = look(KEPLER)
    assert found.sensitivity is not None
    bench, size = found.bench, len(found.bench.job.y)

    def slopes(t: float, z: Vector) -> Vector:
        y, flow = z[:size].tolist(), z[size:].reshape(size, size)
        x, near = y[:2], math.hypot(*y[:2])
        return np.concatenate([y[2:], [-x[0] / near**3, -x[1] / near**3], (bench.jacobian(t, y) @ flow).ravel()])

    start = np.concatenate([bench.job.y, np.eye(size).ravel()])
    solved = solve_ivp(slopes, bench.job.time, start, method="DOP853", rtol=1e-11, atol=1e-14)
    scale = bench.sizes
    norms = [np.linalg.norm(z[size:].reshape(size, size) / scale[:, None] * scale, 2) for z in solved.y.T]
    assert found.sensitivity.largest == pytest.approx(max(norms), rel=0.03)
    assert found.sensitivity.peak == pytest.approx(solved.t[int(np.argmax(norms))], abs=1e-4)
