"""T on axes that move with the bodies: its squares are no components on fixed axes, though they look like these.

The equations by SymPy, from the same formulas: M q'' = f + A^T lambda, A q'' = -A' q'.
"""

from __future__ import annotations

import random
import re

import numpy as np
import pytest
import sympy as sp

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit
from tests.support import error, python_model

ALONG, ACROSS = "(cos(theta)*x' + sin(theta)*y')", "(-sin(theta)*x' + cos(theta)*y' + a*theta')"
EULER = (
    "(phi'*sin(theta)*sin(psi) + theta'*cos(psi))",
    "(phi'*sin(theta)*cos(psi) - theta'*sin(psi))",
    "(phi'*cos(theta) + psi')",
)
PLANAR, ANGLES = ("x", "y", "theta"), ("phi", "theta", "psi")
SLEIGH_T = f"m/2*({ALONG}^2 + {ACROSS}^2) + J/2*theta'^2"
BODY_T = f"J/2*({EULER[0]}^2 + {EULER[1]}^2) + b/2*{EULER[2]}^2"
PARAMETERS = {"m": 1.2, "a": 0.5, "J": 1.5, "b": 2.0}

CASES = {
    "sleigh": (PLANAR, SLEIGH_T, ("-sin(theta)*x' + cos(theta)*y'",), {}),
    "plate": (PLANAR, SLEIGH_T, (), {"u": ALONG, "w": ACROSS, "r": "theta'"}),
    "suslov": (ANGLES, BODY_T, (f"a*{EULER[0]} + {EULER[2]}",), {}),
    "top": (ANGLES, BODY_T, (), dict(zip("pqr", EULER, strict=True))),
}


def random_case(seed: int) -> tuple[tuple[str, ...], str, tuple[str, ...], dict[str, str]]:
    """Squares with few factors, so that many of them look like pairs, of forms that are exact and forms that are not."""
    rng, names = random.Random(seed), PLANAR
    waves = ("sin(theta)", "cos(theta)", "1", "2*sin(theta)")

    def form() -> str:
        return "(" + " + ".join(f"{rng.choice(waves)}*{name}'" for name in names) + ")"

    exact = ("(x' - a*sin(theta)*theta')", "(y' + a*cos(theta)*theta')", "x'", "theta'")
    squares = [f"{rng.choice('mJ')}/2*{form() if rng.random() < 0.6 else rng.choice(exact)}^2" for _ in range(4)]
    rows = (form(),) if seed % 2 else ()
    return names, " + ".join((*squares, "m/2*(x'^2 + y'^2) + J/2*theta'^2")), rows, {}


def write(case: tuple[tuple[str, ...], str, tuple[str, ...], dict[str, str]]) -> Source:
    names, energy, rows, quasi = case
    lines = ["nhc: 1", "system: own", f"coordinates: [{', '.join(names)}]", "parameters:"]
    lines += [f"  {name}: {value}" for name, value in PARAMETERS.items()]
    lines += [f"T: {energy}"]
    lines += ["constraints:", *(f"  - {row} = 0" for row in rows)] if rows else []
    lines += ["quasi_velocities:", *(f"  {name}: {form}" for name, form in quasi.items())] if quasi else []
    return Source("own.yaml", "\n".join(lines) + "\n")


def by_sympy(
    case: tuple[tuple[str, ...], str, tuple[str, ...], dict[str, str]], state: list[list[float]]
) -> list[list[float]]:
    """An admissible velocity near the state's, and the accelerations."""
    names, energy, rows, _ = case
    q, v = sp.symbols(names), sp.symbols([f"{name}_v" for name in names])
    known = dict(zip((*names, *map(str, v)), (*q, *v), strict=True)) | {k: sp.Float(x) for k, x in PARAMETERS.items()}

    def parse(text: str) -> sp.Expr:
        return sp.sympify(re.sub(r"(\w)'", r"\1_v", text).replace("^", "**"), locals=known)

    kinetic, made = parse(energy), [parse(row) for row in rows]
    momenta = [sp.diff(kinetic, x) for x in v]
    jacobian = sp.Matrix([[sp.diff(row, x) for x in v] for row in made])
    at = dict(zip(q, state[0], strict=True))
    slopes, velocity = np.array(jacobian.subs(at), dtype=float).reshape(len(rows), len(q)), np.array(state[1])
    if rows:
        velocity = velocity - slopes.T @ np.linalg.solve(slopes @ slopes.T, slopes @ velocity)
    at |= dict(zip(v, velocity, strict=True))
    mass = np.array(sp.Matrix([[sp.diff(p, x) for x in v] for p in momenta]).subs(at), dtype=float)
    force = [
        sp.diff(kinetic, y) - sum(sp.diff(p, x) * w for x, w in zip(q, v, strict=True))
        for p, y in zip(momenta, q, strict=True)
    ]
    drift = [-sum(sp.diff(row, x) * w for x, w in zip(q, v, strict=True)) for row in made]
    block = np.block([[mass, -slopes.T], [slopes, np.zeros((len(rows), len(rows)))]])
    right = [float(x.subs(at)) for x in (*map(sp.sympify, force), *map(sp.sympify, drift))]
    return [list(velocity), list(np.linalg.solve(block, right)[: len(q)])]


def assert_right(case: tuple[tuple[str, ...], str, tuple[str, ...], dict[str, str]], seed: int) -> None:
    rng, source = random.Random(seed), write(case)
    q, v = [rng.uniform(0.3, 1.1) for _ in case[0]], [rng.uniform(-1, 1) for _ in case[0]]
    v, wanted = by_sympy(case, [q, v])
    for formulation in applicable(resolve(decode(source))):
        (text,) = emit(source, "python", Options(formulation=formulation.name)).values()
        model = python_model(text, f"own_{seed}_{formulation.name}")
        assert error(model.accelerations(0.0, model.state(0.0, q, v)), wanted) < 1e-10, formulation.name


@pytest.mark.parametrize("name", CASES)
def test_textbook_energies_on_the_bodies_own_axes(name: str) -> None:
    assert_right(CASES[name], 3)


@pytest.mark.sample(2)
@pytest.mark.parametrize("seed", range(8))
def test_squares_that_share_a_factor_are_no_vectors_for_that(seed: int) -> None:
    assert_right(random_case(seed), seed)
