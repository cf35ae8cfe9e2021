"""What comments and docstrings of emitted files say of names, units and singular places."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from nhc.diagnostics.source import Source
from nhc.pipeline import Options, emit

SLED = """
nhc: 1
system: sled
parameters: {m: {value: 2, unit: kg}, b: {value: 3, unit: "kg*m^2"}}
coordinates: {x: {unit: m, about: place}, y: {unit: m}, theta: {unit: rad}}
quasi_velocities: {p: "x'*cos(theta) + y'*sin(theta)", w: "theta'"}
constraints:
  - slip: cos(theta)*y' - sin(theta)*x' = 0
T: m/2*(x'^2 + y'^2) + b/2*theta'^2
outputs: {way: x}
"""


def files(language: str, formulation: str = "euler-lagrange") -> dict[str, str]:
    return emit(Source("sled.yaml", SLED), language, Options(formulation=formulation))


def test_what_is_renamed_keeps_its_name_in_the_spec_and_velocities_have_units() -> None:
    source = files("c")["sled.c"]
    assert "const double p_2 = y[3]; /* p [m/s] */" in source
    assert "const double w = y[4]; /* [rad/s] */" in source
    assert "const double x = q[0]; /* place [m] */" in source
    assert "const double y_2 = q[1]; /* y [m] */" in source
    assert "const double x_dot = qdot[0]; /* x' [m/s] */" in source
    (module,) = files("python").values()
    assert "p_2 = float(y[3])  # p [m/s]" in module


def test_what_is_read_is_named_in_the_heading() -> None:
    bodies = files("c")["sled.c"].split("\n}\n")
    state, residuals, rhs = (
        next(b for b in bodies if f"int sled_{name}(" in b) for name in ("state", "residuals", "rhs")
    )
    for body in (state, residuals):
        assert "/* from the coordinates and velocities */" in body and "from the state" not in body
    assert "/* from the state */" in rhs


def test_comments_of_tests_say_what_is_zero() -> None:
    source = files("c")["sled.c"]
    lines = [line.strip() for line in source.split("\n")]
    said = {
        lines[k - 1] for k, line in enumerate(lines) if line.startswith("if (!(fabs(") and line.endswith("> 0.0)) {")
    }
    assert said >= {"/* the mass matrix is singular, if m is 0 */", "/* the mass matrix is singular, if b is 0 */"}
    (module,) = files("python").values()
    assert "# the mass matrix is singular, if b is 0\n        if not abs(b) > 0.0:" in module


def test_c_has_the_names_of_all_that_python_has_with_their_sizes() -> None:
    header, source = files("c").values()
    for kind, size in (
        ("coordinate", "NQ"),
        ("state", "NY"),
        ("parameter", "NP"),
        ("constraint", "NC"),
        ("output", "NOUT"),
    ):
        assert f"extern const char *const sled_{kind}_names[SLED_{size}];" in header
    assert "extern const double sled_parameter_defaults[SLED_NP];" in header
    assert 'sled_constraint_names[SLED_NC] = {\n    "slip"\n};' in source
    bare = "nhc: 1\nsystem: bare\ncoordinates: [x]\nT: x'^2/2\n"
    assert "bare_constraint_names[1];" in emit(Source("bare.yaml", bare), "c")["bare.h"]


@pytest.mark.parametrize("array", ["", "numpy", "jax"])
def test_docstrings_are_sentences(array: str, tmp_path: Path) -> None:
    made = emit(Source("sled.yaml", SLED), "python", Options(array=array))
    path = tmp_path / "sled.py"
    path.write_text(made["sled.py"])
    command = [sys.executable, "-m", "ruff", "check", "--isolated", "--select", "D400,D403,D415", str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
