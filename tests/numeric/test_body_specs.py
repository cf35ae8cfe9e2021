"""Specs by bodies against the same systems otherwise: by positions and by closed forms."""

from __future__ import annotations

import math
import random
import re
from pathlib import Path
from types import ModuleType

import pytest

from nhc.diagnostics import Source
from nhc.language import decode, read
from nhc.mechanics.certificates.certificate import certify
from nhc.mechanics.pairs.verdict import compare_systems
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit
from tests.support import error, python_model, spec_path

BODIES = Path(__file__).resolve().parents[2] / "specs" / "bodies"
FORMULATIONS = {
    "bicycle": ("multipliers", "euler-lagrange", "voronec"),
    "segway": ("multipliers", "euler-lagrange", "voronec", "chaplygin"),
    "car_trailer": ("multipliers", "euler-lagrange", "voronec"),
}


def model_of(name: str, formulation: str = "auto") -> ModuleType:
    (text,) = emit(read(BODIES / f"{name}.yaml"), "python", Options(formulation=formulation)).values()
    return python_model(text, f"{name}_{formulation.replace('-', '_')}")


def test_every_spec_by_bodies_is_here() -> None:
    assert {path.stem for path in BODIES.glob("*.yaml")} == set(FORMULATIONS)


@pytest.mark.parametrize("name", FORMULATIONS)
def test_all_formulations_agree(name: str) -> None:
    certificate = certify(resolve(decode(read(BODIES / f"{name}.yaml"))))
    assert certificate.holds
    assert {agreement.name for agreement in certificate.agreements} == set(FORMULATIONS[name])


CAR = """
nhc: 1
system: car
coordinates: [x, y, theta, steer, hitch]
parameters: {m: 1200, I: 1700, a: 1.3, b: 2.7, J: 4, M: 500, K: 600, d: 0.8, l: 3.2, e: 0.3, thrust: 3000, drag: 60, k: 900, c: 120}
define:
  X: x + a*cos(theta)
  Y: y + a*sin(theta)
  u: x - d*cos(theta) - (l - e)*cos(theta + hitch)
  v: y - d*sin(theta) - (l - e)*sin(theta + hitch)
  P: x - d*cos(theta) - l*cos(theta + hitch)
  Q: y - d*sin(theta) - l*sin(theta + hitch)
  F: x + b*cos(theta)
  G: y + b*sin(theta)
  s: -drag*(cos(theta + hitch)*P' + sin(theta + hitch)*Q')
T: (m*(X'^2 + Y'^2) + M*(u'^2 + v'^2) + I*theta'^2 + J*(theta + steer)'^2 + K*(theta + hitch)'^2)/2
constraints:
  - -sin(theta)*x' + cos(theta)*y' = 0
  - -sin(theta + steer)*F' + cos(theta + steer)*G' = 0
  - -sin(theta + hitch)*P' + cos(theta + hitch)*Q' = 0
forces:
  x: thrust*cos(theta + steer) + s*cos(theta + hitch)
  y: thrust*sin(theta + steer) + s*sin(theta + hitch)
  theta: thrust*b*sin(steer) + s*d*sin(-hitch)
  hitch: 0
  steer: -k*(steer - 0.2*sin(t)) - c*steer'
"""


def test_a_car_with_a_trailer_is_what_is_written_by_hand() -> None:
    """Forces by their moments: thrust at the front axle, drag at the trailer's, whose arm from its own hitch is along it."""
    first, second = resolve(decode(read(BODIES / "car_trailer.yaml"))), resolve(decode(Source("car.yaml", CAR)))
    made = compare_systems(first, second, (), ("A", "B"))
    assert made.agrees
    assert made.is_sure


def test_the_bicycle_by_bodies_is_the_one_by_positions() -> None:
    first, second = resolve(decode(read(BODIES / "bicycle.yaml"))), resolve(decode(read(spec_path("bicycle"))))
    made = compare_systems(first, second, (), ("A", "B"))
    assert made.agrees
    assert made.is_sure


@pytest.mark.parametrize("formulation", FORMULATIONS["segway"])
@pytest.mark.parametrize("seed", range(4))
def test_a_segway_that_runs_straight_is_a_pendulum_on_a_cart(formulation: str, seed: int) -> None:
    """(M + 2m + 2I/r^2) x'' + M h (cos(a) a'' - sin(a) a'^2) = 2 tau/r,
    (B + M h^2) a'' + M h cos(a) x'' - M g h sin(a) = - 2 tau: each motor acts on its wheel and back on the pendulum.
    """
    chance = random.Random(seed)
    model = model_of("segway", formulation)
    tilt, speed, rate = chance.uniform(-1, 1), chance.uniform(-3, 3), chance.uniform(-2, 2)
    value = {**dict(zip(model.PARAMETERS, model.DEFAULTS, strict=True)), "turn": 0.0}
    p = list(value.values())
    M, h, m, r, g = (value[name] for name in "Mhmrg")
    q = [0.3, -0.2, 0.5, tilt, 0.1, 0.4]
    spin = speed / r - rate
    y = model.state(0.0, q, [speed * math.cos(0.5), speed * math.sin(0.5), 0.0, rate, spin, spin], p)
    found = model.accelerations(0.0, y, p)
    tau = value["k"] * tilt + value["d"] * rate
    along, across = M + 2 * m + 2 * value["I"] / r**2, M * h * math.cos(tilt)
    first, second = 2 * tau / r + M * h * math.sin(tilt) * rate**2, M * g * h * math.sin(tilt) - 2 * tau
    inertia = value["B"] + M * h**2
    det = along * inertia - across**2
    x = (inertia * first - across * second) / det
    turned = (along * second - across * first) / det
    expected = [x * math.cos(0.5), x * math.sin(0.5), 0.0, turned, x / r - turned, x / r - turned]
    assert error(found, expected) < 1e-12


def chain(count: int, axis: str) -> str:
    """Rods that hang on one another by hinges, on a cart in the plane, or on a post that turns."""
    lines = ["nhc: 1", "system: chain", f"coordinates: [x, {', '.join(f'q{k}' for k in range(count))}]"]
    lines += ["parameters: {m: 1, M: 2, l: 1, A: 0.1, B: 0.2, C: 0.3, g: 9.81}", "bodies:"]
    first = "at: [x, 0], mass: M" if axis == "z" else "turns: [z: x], inertia: M"
    lines.append(f"  base: {{{first}}}")
    for k in range(count):
        place = "parent: base" if k == 0 else f"parent: b{k - 1}, at: [l, 0, 0]"
        lines.append(f"  b{k}: {{{place}, turns: [{axis}: q{k}], mass: m, centre: [l/2, 0, 0], inertia: [A, B, C]}}")
    return "\n".join([*lines, "gravity: [g, 0, -g]"]) + "\n"


@pytest.mark.parametrize("axis", ["z", "y"])
def test_a_chain_by_bodies_takes_operations_linear_in_its_length(axis: str) -> None:
    def operations(count: int) -> int:
        files = emit(Source("chain.yaml", chain(count, axis)), "c", Options(only=("rhs",)))
        (found,) = re.findall(r"^ \* rhs: (\d+) \+-, (\d+) \*", files["chain.h"], re.MULTILINE)
        return int(found[0]) + int(found[1])

    four, eight, sixteen = map(operations, (4, 8, 16))
    assert sixteen - eight < 2.2 * (eight - four)
