"""Dense solves that are written out in C: the same accelerations as by elimination with exchanges, whatever the pivots are."""

from __future__ import annotations

import ctypes
import random
from pathlib import Path

import numpy as np
import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from tests.support import CModel, c_model, compile_c, emitted_python, error, formulations, python_model

FORM = """\
nhc: 1
system: quadratic
coordinates: [x, y, z, w]
parameters: {a: 1, b: 0.2, c: 2, d: 1.5, e: 0.3, f: 1, k: 1, l: 0.5, h: 2, g: 9.81}
T: (a*x'^2 + 2*b*x'*y' + c*y'^2 + d*z'^2 + 2*e*x'*z' + f*w'^2)/2
U: -g*(x + 2*y - z + w)
constraints:
  - first: k*x' + l*y' + z' = 0
  - second: h*y' - k*w' = 0
formulation: multipliers
"""


def both(text: str, name: str, folder: Path) -> tuple[CModel, object]:
    source = Source(f"{name}.yaml", text)
    files = emit(source, "c", Options())
    assert "inverse1" in files[f"{name}.c"] and f"{name}_solve(" in files[f"{name}.c"]
    library = ctypes.CDLL(str(compile_c(files, folder, name)))
    (module,) = emit(source, "python", Options()).values()
    return CModel(name, library, {}), python_model(module, name)


def test_against_numpy(tmp_path: Path) -> None:
    """Positive definite, indefinite and singular mass matrices."""
    compiled, module = both(FORM, "quadratic", tmp_path)
    rng, kinds = random.Random(5), set()
    y = [0.3, 0.1, -0.2, 0.4, 0.7, 0.2, -0.5, 0.9]
    for k in range(400):
        a, b, c, d, e, f, k1, l1, h = (rng.uniform(-2, 2) for _ in range(9))
        if k % 2:
            a, c, d, f = abs(a) + 0.5, abs(c) + 0.5, abs(d) + 0.5, abs(f)
        if k % 7 == 0:
            a, b, e = 0.0, 0.0, 0.0
        if k % 11 == 0:
            c = b * b / a if a else 0.0
        if k % 13 == 0:
            f = rng.choice((1e-12, -1e-12, 0.0, 1e12))
        p = [a, b, c, d, e, f, k1, l1, h, 9.81]
        mass = np.array([[a, b, e, 0], [b, c, 0, 0], [e, 0, d, 0], [0, 0, 0, f]])
        rows = np.array([[k1, l1, 1, 0], [0, h, 0, -k1]])
        matrix = np.block([[mass, -rows.T], [-rows, np.zeros((2, 2))]])
        if np.linalg.cond(matrix) > 1e9:
            continue
        wanted = np.linalg.solve(matrix, [-9.81, -19.62, 9.81, -9.81, 0, 0])[:4]
        found = compiled("rhs", 8, 0.0, y, p)[4:]
        assert error(found, wanted) < 1e-7
        assert error(found, module.rhs(0.0, y, p)[4:]) < 1e-7  # type: ignore[attr-defined]
        kinds.add(bool(np.linalg.eigvalsh(mass)[0] > 1e-9))
    assert kinds == {True, False}


SCALED = """\
nhc: 1
system: scaled
coordinates: [x, y, z, w]
parameters: {X: 1, Y: 1, Z: 1, W: 1, f: 1}
T: ((X*x')^2 + 0.4*X*Y*x'*y' + 2*(Y*y')^2 + (Z*z')^2 + 0.6*X*Z*x'*z' + f*(W*w')^2)/2
U: X*x + 2*Y*y - Z*z + W*w
constraints:
  - X*x' + 0.5*Y*y' + Z*z' = 0
  - 2*Y*y' - W*w' = 0
formulation: multipliers
"""


@pytest.mark.parametrize("mass", [1.0, 0.0])
def test_no_unit_of_a_coordinate_decides_what_is_singular(mass: float, tmp_path: Path) -> None:
    """A length of 1e9 beside 1: X x, Y y ... move as they do with X = Y = 1, in C and in Python."""
    source = Source("scaled.yaml", SCALED)
    compiled = CModel("scaled", ctypes.CDLL(str(compile_c(emit(source, "c", Options()), tmp_path, "scaled"))), {})
    arrays = {kind: emit(source, "python", Options(array=kind)) for kind in ("", "numpy")}
    modules = [python_model(text, f"scaled_{kind}") for kind, files in arrays.items() for text in files.values()]
    usual = compiled("rhs", 8, 0.0, [0.0] * 8, [1.0, 1.0, 1.0, 1.0, mass])[4:]
    for k in range(4):
        for size in (1e9, 1e-9, 1e60):
            units = [size if i == k else 1.0 for i in range(4)]
            p = [*units, mass]
            for rhs in (
                lambda p: compiled("rhs", 8, 0.0, [0.0] * 8, p),
                *(lambda p, m=m: m.rhs(0.0, [0.0] * 8, p) for m in modules),
            ):
                assert [x * unit for x, unit in zip(rhs(p)[4:], units, strict=True)] == pytest.approx(usual, rel=1e-12)


def test_where_only_the_constraints_hold_a_coordinate(tmp_path: Path) -> None:
    """The mass matrix is singular at r = 0, the motion is not; beyond both nothing is determined."""
    text = FORM.split("coordinates")[0].replace("quadratic", "spool")
    text += "coordinates: [r, th]\nparameters: {m: 1, k: 1}\nT: m/2*(r'^2 + r^2*th'^2)\nU: m*r\n"
    text += "constraints:\n  - wound: r' - k*th' = 0\nformulation: multipliers\n"
    compiled, module = both(text, "spool", tmp_path)
    for r in (0.0, 1e-200, 1e-9, 1e-5, 1e-3, 1.0, 1e5):
        for m in (1.0, -1.0):
            found = compiled("rhs", 4, 0.0, [r, 0.3, 0.5, 0.5], [m, 1.0])
            assert error(found, module.rhs(0.0, [r, 0.3, 0.5, 0.5], [m, 1.0])) < 1e-9  # type: ignore[attr-defined]
    assert compiled("rhs", 4, 0.0, [0.0, 0.3, 0.5, 0.5], [1.0, 1.0])[2:] == pytest.approx([1.0, 1.0])
    for r, p in ((0.0, [1.0, 0.0]), (0.0, [0.0, 1.0]), (float("nan"), [1.0, 1.0]), (1.0, [float("inf"), 1.0])):
        with pytest.raises(ArithmeticError):
            compiled("rhs", 4, 0.0, [r, 0.3, 0.5, 0.5], p)


def test_an_infinite_pivot_of_a_constraint_is_refused(tmp_path: Path) -> None:
    """The square of a coefficient of 1e155 and more is infinite: the multiplier would be taken for zero, and y for free."""
    text = FORM.split("coordinates")[0].replace("quadratic", "steep")
    text += "coordinates: [x, y, z]\nparameters: {m: 1}\nT: m/2*(x'^2 + y'^2 + z'^2)\nforces: {y: 1}\n"
    text += "constraints:\n  - z' - x*y' = 0\nformulation: multipliers\n"
    compiled, module = both(text, "steep", tmp_path)
    (array,) = emit(Source("steep.yaml", text), "python", Options(array="numpy")).values()
    ways = [lambda y, p: compiled("rhs", 6, 0.0, y, p)]
    ways += [lambda y, p, m=m: m.rhs(0.0, y, p) for m in (module, python_model(array, "steep_array"))]
    for x, m, good in (
        (1e100, 1.0, True),
        (1e153, 1.0, True),
        (-1e155, 1.0, False),
        (1e300, 2.0, False),
        (1e153, 1e-5, False),
    ):
        for rhs in ways:
            if good:
                assert abs(rhs([x, 0.2, 0.3, 0.7, 0.0, 0.0], [m])[4]) < 1e-90
            else:
                with pytest.raises(ArithmeticError):
                    rhs([x, 0.2, 0.3, 0.7, 0.0, 0.0], [m])


@pytest.mark.parametrize("other", [0.0, 1.0, 1e6])
def test_a_fast_mass_hides_no_lost_digits_of_another(other: float, tmp_path: Path) -> None:
    """x is light and held by heavy y; z, which has nothing to do with them, may be as fast as x would be by itself."""
    text = FORM.split("coordinates")[0].replace("quadratic", "light")
    text += "coordinates: [x, y, z]\nparameters: {e: 1, M: 1, a: 1, f: 1}\nT: e/2*x'^2 + M/2*y'^2 + e/2*z'^2\n"
    text += "forces: {x: 0.7, z: f}\nconstraints:\n  - x' - a*y' = 0\nformulation: multipliers\n"
    compiled, module = both(text, "light", tmp_path)
    for e in (1e-3, 1e-9, 1e-12, 1e-15):
        p = [e, 1.0, 1.0, other]
        x, y, _ = compiled("rhs", 6, 0.0, [0.0] * 6, p)[3:]
        assert x == pytest.approx(0.7 / (1 + e), rel=1e-9) and x == pytest.approx(y, rel=1e-9)
        assert module.rhs(0.0, [0.0] * 6, p)[3] == pytest.approx(x, rel=1e-9)  # type: ignore[attr-defined]


@pytest.mark.parametrize("name", ["rolling_disk", "bicycle", "snakeboard", "chaplygin_ball", "roller_racer"])
def test_rows_exchanged_or_not_give_one_motion(name: str, tmp_path: Path) -> None:
    """Python exchanges rows, ``rhs`` in C does not, and ``accelerations`` calls it."""
    assert "multipliers" in formulations(name)
    compiled, module = c_model(name, "multipliers", tmp_path), emitted_python(name, "multipliers")
    n, rng = len(module.COORDINATES), random.Random(name)
    p = list(module.DEFAULTS)
    for _ in range(20):
        y = [rng.uniform(0.2, 1.2) for _ in range(2 * n)]
        found = compiled("rhs", 2 * n, 0.0, y, p)
        assert error(found[n:], compiled("accelerations", n, 0.0, y, p)) < 1e-9
        assert error(found, module.rhs(0.0, y, p)) < 1e-9


def test_what_is_neither_asked_for_nor_tested_is_not_computed(tmp_path: Path) -> None:
    """A scene that leaves out a velocity which one constraint holds: the solve still contains its acceleration."""
    text = """\
nhc: 1
system: held
coordinates: [z, x, y, w]
T: (x'^2 + y'^2 + z'^2 + w'^2)/2 + z'*x'*cos(y)/5 + x'*y'*sin(w)/4 + y'*w'*x/7
V: x*y*w
constraints: ["z' = 0", "w' = y*x'"]
formulation: multipliers
scenes: {go: {initial: {x: 1}, time: [0, 1], need: x}}
"""
    options = Options(scene="go")
    files = emit(Source("held.yaml", text), "c", options)
    assert "inverse1" in files["held.c"]
    compiled = CModel("held", ctypes.CDLL(str(compile_c(files, tmp_path, "held"))), {})
    (module,) = emit(Source("held.yaml", text), "python", options).values()
    model = python_model(module, "held")
    y = [0.3, 0.2, 0.5, -0.7, 0.4, 0.1][: len(model.STATE)]
    assert error(compiled("rhs", len(y), 0.0, y, model.DEFAULTS), model.rhs(0.0, y)) < 1e-13
