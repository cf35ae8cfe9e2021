"""What is light, or has no mass, and is carried by constraints: no digits are lost, and nothing regular is called singular.

Held against the multiplier equations, solved by LAPACK with pivoting: they are well conditioned whatever the mass.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy
import pytest

from nhc import compile as compile_spec
from tests.support import python_model

LINKS = 6
LENGTHS = [0.6, 0.7, 0.5, 0.8, 0.4, 0.9]


def chain(last: float) -> str:
    """A cart and rods without inertia, the end of which is pinned: the last rod's mass is ``last``."""
    masses = [1.0 + 0.2 * k for k in range(LINKS - 1)] + [last]
    x, y, lines = "x", "0", []
    for k in range(1, LINKS + 1):
        lines += [f"  X{k}: {x} + {LENGTHS[k - 1]}*sin(th{k})", f"  Y{k}: {y} - {LENGTHS[k - 1]}*cos(th{k})"]
        x, y = f"X{k}", f"Y{k}"
    kinetic = " + ".join(f"m{k}/2*(X{k}'^2 + Y{k}'^2)" for k in range(1, LINKS + 1))
    given = ", ".join(f"m{k}: {mass!r}" for k, mass in enumerate(masses, 1))
    return "\n".join(
        (
            "nhc: 1",
            "system: pinned_chain",
            f"coordinates: [x, {', '.join(f'th{k}' for k in range(1, LINKS + 1))}]",
            f"parameters: {{{given}}}",
            "define:",
            *lines,
            f"T: x'^2/2 + {kinetic}",
            "U: -9.81*(" + " + ".join(f"m{k}*Y{k}" for k in range(1, LINKS + 1)) + ")",
            f"holonomic: [X{LINKS} - 1 = 0, Y{LINKS} + 1 = 0]",
        )
    )


def multiplier_accelerations(th: numpy.ndarray, rates: numpy.ndarray, masses: numpy.ndarray) -> numpy.ndarray:
    """q'' of the chain from M q'' = f + A^T lambda, A q'' = -A' q'; J_k is the Jacobian of point k, h_k = J_k' q'."""
    jacobians = numpy.zeros((LINKS, 2, LINKS + 1))
    turning = numpy.zeros((LINKS, 2))
    for k in range(LINKS):
        jacobians[k, 0, 0] = 1.0
        for j in range(k + 1):
            jacobians[k, :, j + 1] = LENGTHS[j] * numpy.array([numpy.cos(th[j]), numpy.sin(th[j])])
            turning[k] += LENGTHS[j] * rates[j + 1] ** 2 * numpy.array([-numpy.sin(th[j]), numpy.cos(th[j])])
    mass, force = numpy.zeros((LINKS + 1, LINKS + 1)), numpy.zeros(LINKS + 1)
    mass[0, 0] = 1.0
    for k in range(LINKS):
        mass += masses[k] * jacobians[k].T @ jacobians[k]
        force += masses[k] * jacobians[k].T @ (numpy.array([0.0, -9.81]) - turning[k])
    rows = jacobians[-1]
    whole = numpy.block([[mass, -rows.T], [rows, numpy.zeros((2, 2))]])
    return numpy.linalg.solve(whole, numpy.concatenate([force, -turning[-1]]))[: LINKS + 1]


def draw_state(rng: numpy.random.Generator) -> tuple[numpy.ndarray, numpy.ndarray]:
    """Angles, and rates at which the pinned end is at rest."""
    th = rng.uniform(-1.2, 1.2, LINKS)
    rows = numpy.zeros((2, LINKS + 1))
    rows[0, 0] = 1.0
    rows[:, 1:] = numpy.array(LENGTHS) * numpy.array([numpy.cos(th), numpy.sin(th)])
    rates = rng.normal(size=LINKS + 1)
    rates -= numpy.linalg.pinv(rows) @ rows @ rates
    return th, rates


@pytest.mark.sample(2)
@pytest.mark.parametrize("formulation", ["voronec", "multipliers"])
@pytest.mark.parametrize("last", [0.0, 1e-12, 1e-8, 0.5])
def test_a_light_rod_that_is_pinned(last: float, formulation: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    path = tmp_path_factory.mktemp("light") / "chain.yaml"
    path.write_text(chain(last))
    (text,) = compile_spec(path, "python", formulation=formulation, only=("state", "accelerations")).values()
    model = python_model(text, "pinned_chain")
    rng = numpy.random.default_rng(4)
    th, rates = draw_state(rng)
    y = model.state(0.0, [0.3, *th], list(rates))
    expected = multiplier_accelerations(th, rates, numpy.array(model.DEFAULTS))
    assert numpy.allclose(model.accelerations(0.0, y), expected, rtol=1e-11, atol=1e-11 * abs(expected).max())


def is_refused(
    model: Any, q: list[float], v: list[float], p: list[float], expected: numpy.ndarray, error: float
) -> bool:
    """Whether the accelerations are called singular; else they are right to ``error``, relative to the largest too."""
    try:
        found = model.accelerations(0.0, model.state(0.0, q, v, p), p)
    except model.SingularModelError as singular:
        assert singular.status == 2
        return True
    assert numpy.allclose(found, expected, rtol=error, atol=error * abs(expected).max())
    return False


def test_digits_that_are_lost_have_a_status(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Emitted for a last rod that is heavy, called with one that is light: right to six digits, or refused."""
    path = tmp_path_factory.mktemp("light") / "chain.yaml"
    path.write_text(chain(0.5))
    (text,) = compile_spec(path, "python", formulation="voronec", only=("state", "accelerations")).values()
    model = python_model(text, "pinned_chain_heavy")
    rng = numpy.random.default_rng(7)
    refused = []
    for last in (1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 0.0):
        masses = [*model.DEFAULTS[:-1], last]
        th, rates = draw_state(rng)
        expected = multiplier_accelerations(th, rates, numpy.array(masses))
        if is_refused(model, [0.3, *th], list(rates), masses, expected, 1e-5):
            refused.append(last)
    assert len(refused) >= 2 and max(refused) < 1e-8


HITCHED = """nhc: 1
system: hitched
coordinates: [x, y, a, b, c]
parameters: {m: 1, n: 0.5, J: 0.3, K: 0.1, l: 0.7, d: 0.2, e: 0.4}
define:
  X1: x - d*cos(a) - l*cos(b)
  Y1: y - d*sin(a) - l*sin(b)
  X2: X1 - d*cos(b) - e*cos(c)
  Y2: Y1 - d*sin(b) - e*sin(c)
T: m/2*(x'^2 + y'^2) + J/2*a'^2 + n/2*(X1'^2 + Y1'^2) + K/2*(b'^2 + c'^2) + n/2*(X2'^2 + Y2'^2)
constraints:
  - "-sin(a)*x' + cos(a)*y' = 0"
  - "-sin(b)*X1' + cos(b)*Y1' = 0"
  - "-sin(c)*X2' + cos(c)*Y2' = 0"
"""


@pytest.mark.parametrize("formulation", ["euler-lagrange", "voronec"])
def test_a_short_trailer_is_right_to_what_is_left_or_refused(formulation: str, tmp_path: Path) -> None:
    """K/e^2 swamps the other masses, and rounding relative to it is the error; the multiplier equations are well conditioned."""
    path = tmp_path / "hitched.yaml"
    path.write_text(HITCHED)
    only = ("state", "velocities", "accelerations")
    named = {kind: compile_spec(path, "python", formulation=kind, only=only) for kind in (formulation, "multipliers")}
    one, other = (
        python_model(text, f"hitched_{k}") for k, files in enumerate(named.values()) for text in files.values()
    )
    q, refused = [0.1, 0.2, 0.3, 0.5, 0.4], []
    for length in (1e-2, 1e-4, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10):
        p = [*one.DEFAULTS[:-1], length]
        v = one.velocities(0.0, [*q, 0.7, 0.4], p)
        expected = numpy.array(other.accelerations(0.0, other.state(0.0, q, v, p), p))
        if is_refused(one, q, v, p, expected, 1e-11 + 1e-18 / length**2):
            refused.append(length)
    assert len(refused) >= 2 and max(refused) < 1e-7
