"""Integer powers are products that share their parts, with the values of powers."""

from __future__ import annotations

import math
import random
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.models import Compiled, Sources
from nhc.diagnostics import Source
from nhc.pipeline import Options, emit, program
from nhc.program.contents import list_expressions, walk
from nhc.program.ir import Call, Power
from nhc.program.lowering.powers import HIGHEST, chain
from tests.support import python_model

ATOMS = """\
nhc: 1
system: atoms
coordinates: [x, y, a, b]
parameters: {m: 2, e: 0.7, s: 1.3}
define: {r: "sqrt((x - a)^2 + (y - b)^2)"}
T: m/2*(x'^2 + y'^2 + a'^2 + b'^2)
V: 4*e*((s/r)^12 - (s/r)^6)
"""


@given(st.sets(st.integers(1, HIGHEST), min_size=1, max_size=5))
def test_a_chain_makes_each_exponent_from_two_before_it(exponents: set[int]) -> None:
    made = chain(exponents)
    at_hand = {1}
    for n, (a, b) in made.items():
        assert a + b == n
        assert {a, b} <= at_hand
        at_hand.add(n)
    assert exponents <= at_hand
    assert set(made) - exponents <= set(range(2, max(exponents)))


def test_chains_are_as_short_as_known() -> None:
    """Lengths of shortest addition chains: Knuth, section 4.6.3, figure 14."""
    shortest = {2: 1, 3: 2, 4: 2, 5: 3, 6: 3, 7: 4, 8: 3, 9: 4, 10: 4, 11: 5, 12: 4, 16: 4, 24: 5, 32: 5, 64: 6}
    assert {n: len(chain([n])) for n in shortest} == shortest
    assert len(chain([5, 6, 11])) == 5
    assert len(chain([6, 12])) == 4


def monomial_model(power: str) -> Source:
    """x'' = -d V/dx for one term, x'' = a x^n."""
    text = f"nhc: 1\nsystem: one\ncoordinates: [x]\nT: x'^2/2\nforces:\n  x: {power}\n"
    return Source("one.yaml", text)


@pytest.mark.parametrize("n", [3, 4, 5, 6, 7, 11, 12, 23, 63, 64, -2, -3, -4, -7, -12, -64])
@pytest.mark.parametrize(
    "around", ["x^({n})", "x^({n}) + 1/x", "x^2 - x^({n}) + 2/x^3", "sqrt(x)^({n}) - 3/sqrt(x) + 1/x"]
)
def test_a_power_has_its_value(n: int, around: str) -> None:
    source = monomial_model(around.format(n=n))
    (rhs,) = program(source, Options(only=("rhs",))).functions
    parts = [part for statement in rhs.body for e in list_expressions(statement) for part in walk(e)]
    assert not any(isinstance(part, Power) or (isinstance(part, Call) and part.function == "pow") for part in parts)
    rates = python_model(emit(source, "python", Options(only=("rhs",)))["one.py"], "one").rhs
    for x in (0.3, 0.9, 1.7):
        exact = Fraction(x)
        if around.startswith("sqrt"):
            expected = math.sqrt(x) ** n - 3 / math.sqrt(x) + 1 / x
        else:
            values = {"x^({n})": exact**n, "x^({n}) + 1/x": exact**n + 1 / exact}
            expected = float(values.get(around, exact**2 - exact**n + 2 / exact**3))
        assert rates(0.0, [x, 0.0])[1] == pytest.approx(expected, rel=1e-13 * abs(n))


def test_higher_powers_are_left_to_the_library() -> None:
    source = monomial_model(f"x^{HIGHEST + 1}")
    text = emit(source, "c", Options(only=("rhs",)))["one.c"]
    assert "pow(" in text
    made = python_model(emit(source, "python", Options(only=("rhs",)))["one.py"], "one")
    assert made.rhs(0.0, [1.1, 0.0])[1] == pytest.approx(1.1 ** (HIGHEST + 1), rel=1e-12)


def test_a_reciprocal_is_made_once() -> None:
    (rhs,) = program(monomial_model("2/x - 3/x^2 + 5/x^7"), Options(only=("rhs",))).functions
    assert rhs.divisions == 1
    (rhs,) = program(monomial_model("5/x^7"), Options(only=("rhs",))).functions
    assert rhs.divisions == 1


def test_two_atoms_in_c(tmp_path: Path) -> None:
    """F = 24 e (2 (s/r)^12 - (s/r)^6)/r along the line between them."""
    source = Source("atoms.yaml", ATOMS)
    files = emit(source, "c", Options(only=("rhs",)))
    assert "pow(" not in files["atoms.c"]
    compiled = Compiled(Sources("atoms_rhs", files), tmp_path, ("-std=c99", "-O1"))
    draw = random.Random(5)
    for _ in range(20):
        y = [draw.uniform(-2, 2) for _ in range(8)]
        m, e, s = values = [draw.uniform(0.5, 2) for _ in range(3)]
        r = math.hypot(y[0] - y[2], y[1] - y[3])
        force = 24 * e * (2 * (s / r) ** 12 - (s / r) ** 6) / r
        along = [force * (y[0] - y[2]) / r / m, force * (y[1] - y[3]) / r / m]
        expected = [*y[4:], *along, -along[0], -along[1]]
        assert compiled(0.0, y, values) == pytest.approx(expected, rel=1e-12)


def test_a_reciprocal_under_a_root_that_is_divided_by(tmp_path: Path) -> None:
    """1/sqrt(1/z) is the root of z, however z is made; its parts were made of each other, and nhc did not come to an end."""
    path = tmp_path / "roots.yaml"
    outputs = "{a: 1/sqrt(1/x), b: x^2 + (x^(-2))^(-1/2), c: (cos(x)^(-4))^(-3/2)*cos(x)^4, d: 1/sqrt(2/x) + x}"
    path.write_text(f"nhc: 1\nsystem: roots\ncoordinates: [x]\nT: x'^2/2*(1 + 1/sqrt(1/x))\noutputs: {outputs}\n")
    done = subprocess.run(
        [sys.executable, "-m", "nhc", "emit", str(path), "--lang", "python", "--stdout"],
        capture_output=True,
        text=True,
        timeout=60,
        check=True,
    )
    model, x, v = python_model(done.stdout, "roots"), 0.83, 1.7
    expected = [math.sqrt(x), x**2 + x, math.cos(x) ** 10, math.sqrt(x / 2) + x]
    assert model.outputs(0.0, [x, v]) == pytest.approx(expected, rel=1e-13)
    mass, slope = 1 + math.sqrt(x), 0.5 / math.sqrt(x)
    assert model.rhs(0.0, [x, v]) == pytest.approx([v, -slope * v * v / (2 * mass)], rel=1e-13)
