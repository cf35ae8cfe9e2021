"""One status everywhere: what is no number is never called singular, by C (scalar, batch, inlined sines), Python, NumPy or JAX."""

from __future__ import annotations

import ctypes
import itertools
import math
import random
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy
import pytest

from nhc.diagnostics import Source
from nhc.pipeline import Options, emit
from tests.support import CModel, cases, compile_c, doubles, emitted, emitted_python, python_model

NAMES = ["chaplygin_sleigh", "snakeboard", "diff_drive", "heavy_top_quaternion", "suslov"]
OF_VELOCITIES = ("state", "residuals", "positions")  # functions of t, q, q', p or t, q, p


def load_c(name: str, formulation: str, trig: str, folder: Path) -> CModel:
    files = emitted(name, "c", Options(formulation=formulation, trig=trig))
    folder.mkdir()
    return CModel(name, ctypes.CDLL(str(compile_c(files, folder, name, ("-O0",)))), {})


def list_functions(module: ModuleType) -> dict[str, int]:
    """The functions of the module that return lists, with their sizes."""
    ny, nq, nc = len(module.STATE), len(module.COORDINATES), len(module.CONSTRAINTS)
    sizes = {"rhs": ny, "velocities": nq, "accelerations": nq, "state": ny, "residuals": nc, "reactions": nc}
    sizes |= {"jacobian": ny * ny, "outputs": len(module.OUTPUTS), "energy": 1}
    return {name: size for name, size in sizes.items() if hasattr(module, name)}


def make_start(module: ModuleType, function: str, rng: random.Random) -> list[Any]:
    """Arguments where the model is regular."""
    n = len(module.COORDINATES)
    ys = [n, n] if function in OF_VELOCITIES else [len(module.STATE)]
    return [0.3, *([rng.uniform(0.2, 0.9) for _ in range(k)] for k in ys), list(module.DEFAULTS)]


def spoil(start: list[Any], values: tuple[float, ...]) -> list[list[Any]]:
    """The arguments with one of their numbers replaced, one after the other."""
    found: list[list[Any]] = []
    for value, (k, argument) in itertools.product(values, enumerate(start)):
        if isinstance(argument, float):
            found.append([*start[:k], value, *start[k + 1 :]])
            continue
        for i in range(len(argument)):
            found.append([*start[:k], [*argument[:i], value, *argument[i + 1 :]], *start[k + 1 :]])
    return found


def ask_c(model: CModel, function: str, size: int, arguments: list[Any]) -> int:
    if function == "energy":
        return 0 if math.isfinite(model.energy(*arguments)) else -1
    try:
        model(function, size, *arguments)
    except ArithmeticError as stopped:
        return int(stopped.args[0])
    return 0


def ask_batch(model: CModel, size: int, t: float, y: list[float], p: list[float]) -> int:
    """Two equal states at once."""
    out = (ctypes.c_double * (2 * size))()
    batch = getattr(model.library, f"{model.name}_rhs_batch")
    return int(batch(ctypes.c_size_t(2), doubles([t, t]), doubles([x for x in y for _ in range(2)]), doubles(p), out))


def ask_python(module: ModuleType, function: str, arguments: list[Any]) -> int:
    try:
        getattr(module, function)(*arguments)
    except module.SingularModelError as stopped:
        return int(stopped.status)
    return 0


@pytest.mark.sample(3)
@pytest.mark.parametrize(("name", "formulation"), cases(NAMES))
def test_no_number_has_the_same_status_everywhere(name: str, formulation: str, tmp_path: Path) -> None:
    compiled = [load_c(name, formulation, trig, tmp_path / f"c{trig}") for trig in ("", "inline")]
    module, array = (emitted_python(name, formulation, kind) for kind in ("", "numpy"))
    seen: set[int] = set()
    for function, size in list_functions(module).items():
        start = make_start(module, function, random.Random(function))
        assert ask_python(module, function, start) == 0
        for arguments in spoil(start, (math.nan,)):
            status = ask_python(module, function, arguments)
            assert status in (0, module.NOT_FINITE)
            found = [ask_c(model, function, size, arguments) for model in compiled]
            if function == "energy":
                found = [status if code else 0 for code in found]
            if function == "rhs":
                found += [ask_batch(model, size, *arguments) for model in compiled]
            found.append(ask_python(array, function, [numpy.array(argument) for argument in arguments]))
            assert found == [status] * len(found), (function, arguments)
            seen.add(status)
        for arguments in [twice for once in spoil(start, (0.0,)) for twice in spoil(once, (math.nan,))][::7]:
            status = ask_python(module, function, arguments)
            code = ask_c(compiled[0], function, size, arguments)
            assert code == status or (function == "energy" and status), (function, arguments)
    assert seen == {0, module.NOT_FINITE}


@pytest.mark.parametrize(("name", "formulation"), cases(["chaplygin_sleigh"]))
def test_an_infinite_state_is_no_singular_block(name: str, formulation: str, tmp_path: Path) -> None:
    """Python's sine raises there, before anything is divided by; C computes on with a NaN."""
    compiled = load_c(name, formulation, "", tmp_path / "c")
    module, array = (emitted_python(name, formulation, kind) for kind in ("", "numpy"))
    for function, size in list_functions(module).items():
        if function == "energy":
            continue
        for arguments in spoil(make_start(module, function, random.Random(function))[:-1], (math.inf, -math.inf)):
            arguments.append(list(module.DEFAULTS))
            status = ask_python(module, function, arguments)
            assert status in (0, module.NOT_FINITE)
            assert ask_c(compiled, function, size, arguments) == status
            assert ask_python(array, function, [numpy.array(argument) for argument in arguments]) == status


@pytest.mark.parametrize("formulation", ["chaplygin", "voronec"])
@pytest.mark.usefixtures("jax_is_numpy")
def test_an_energy_is_refused_where_the_rates_are(formulation: str, tmp_path: Path) -> None:
    """At a right angle in doubles, whose cosine is not zero: T divides by it, and what comes of that is finite and wrong."""
    name, t, y, p = "chaplygin_sleigh", 0.0, [0.1, 0.2, math.pi / 2, 0.3, 0.4], [1.0, 0.5, 0.7]
    compiled = load_c(name, formulation, "", tmp_path / "c")
    module, array, traced = (emitted_python(name, formulation, kind) for kind in ("", "numpy", "jax"))
    arrays = [numpy.array(argument) for argument in (t, y, p)]
    for function, size in (("rhs", 5), ("energy", 1), ("outputs", 3)):
        status = ask_python(module, function, [t, y, p])
        assert status == 1
        assert ask_c(compiled, function, size, [t, y, p]) in ((-1,) if function == "energy" else (status,))
        assert ask_python(array, function, arrays) == status
        assert not numpy.isfinite(getattr(traced, function)(*arrays)).any()


@pytest.mark.parametrize("array", ["", "numpy"])
def test_an_energy_without_divisors_has_its_value_wherever_the_coframe_is_singular(array: str) -> None:
    module = emitted_python("suslov", "euler-lagrange", array)
    y, p = numpy.array([0.1, 0.0, 0.2, 0.3, 0.4]), numpy.array(module.DEFAULTS)
    assert module.energy(0.0, y, p) == pytest.approx(0.5 * (p[0] * 0.09 + p[1] * 0.16))
    with pytest.raises(module.SingularModelError):
        module.rhs(0.0, y, p)


@pytest.mark.parametrize("formulation", ["euler-lagrange", "multipliers"])
@pytest.mark.usefixtures("jax_is_numpy")
def test_what_jax_does_not_give_is_what_the_others_refuse(formulation: str) -> None:
    module, traced = (emitted_python("chaplygin_sleigh", formulation, kind) for kind in ("", "jax"))
    for function in list_functions(module):
        start = make_start(module, function, random.Random(function))
        for arguments in spoil(start, (math.nan,)):
            found = numpy.asarray(getattr(traced, function)(*map(numpy.array, arguments)))
            assert bool(numpy.isnan(found).any()) == (ask_python(module, function, arguments) != 0)


LIFT = """nhc: 1
system: lift
coordinates: [x, y, psi, delta]
parameters: {M: 12, I: 6, J: 0.4, b: 1.6}
T: M/2*(x'^2 + y'^2) + I/2*psi'^2 + J/2*(psi' + delta')^2
constraints:
  - y'*cos(psi) - x'*sin(psi) = 0
  - (y' - b*psi'*cos(psi))*cos(psi + delta) - (x' + b*psi'*sin(psi))*sin(psi + delta) = 0
dependent: [y, psi]
"""
"""The determinant -b cos(psi) cos(delta) vanishes with b, by which is divided ahead of all that depends on the state."""


@pytest.mark.parametrize("array", ["", "numpy"])
def test_a_parameter_in_front_of_a_determinant_has_its_status(array: str, tmp_path: Path) -> None:
    source, seen = Source("lift.yaml", LIFT), set[int]()
    (text,) = emit(source, "python", Options(formulation="voronec", array=array)).values()
    module = python_model(text, f"lift_{array}")
    files = emit(source, "c", Options(formulation="voronec"))
    model = CModel("lift", ctypes.CDLL(str(compile_c(files, tmp_path, "lift"))), {})
    for function, size in list_functions(module).items():
        for once in (
            spoil(make_start(module, function, random.Random(function)), (0.0,)) if function != "energy" else ()
        ):
            for arguments in (once, *spoil(once, (math.nan,))):
                given = [numpy.array(argument) for argument in arguments] if array else arguments
                status = ask_python(module, function, given)
                assert ask_c(model, function, size, arguments) == status, (function, arguments)
                seen.add(status)
    assert seen == {0, 1, 2, module.NOT_FINITE}


ENTRIES = """nhc: 1
system: two_masses
coordinates: [x, y, z]
parameters: {a: 2, b: 3, c: 1, d: 0.5}
T: (a*x'^2 + b*y'^2 + c*z'^2)/2 + d*(x'*y' + y'*z')
constraints:
  - hold: x' + (1 + x^2)*z' = 0
"""


@pytest.mark.parametrize("array", ["", "numpy"])
def test_a_matrix_with_no_number_is_not_singular_wherever_it_stands(array: str, tmp_path: Path) -> None:
    """A largest entry is no number where one of them is none, first or last in its row."""
    source, options = Source("two_masses.yaml", ENTRIES), Options(formulation="multipliers")
    (text,) = emit(source, "python", Options(formulation="multipliers", array=array)).values()
    module = python_model(text, "two_masses")
    files = emit(source, "c", options)
    model = CModel("two_masses", ctypes.CDLL(str(compile_c(files, tmp_path, "two_masses"))), {})
    y = [0.1, 0.2, 0.3, 1.0, 0.4, -1.0]
    for place in range(4):
        p = [math.nan if k == place else x for k, x in enumerate(module.DEFAULTS)]
        for function, size in (("rhs", 6), ("accelerations", 3), ("reactions", 1), ("jacobian", 36)):
            given = [numpy.array(x) for x in (0.0, y, p)] if array else [0.0, y, p]
            assert ask_python(module, function, given) == module.NOT_FINITE
            assert ask_c(model, function, size, [0.0, y, p]) == module.NOT_FINITE


SWINGING = """nhc: 1
system: swinging_mass
coordinates: [r, theta]
parameters: {M: 3, m: 1, g: 9.81}
T: (M + m)/2*r'^2 + m/2*r^2*theta'^2
V: M*g*r - m*g*r*cos(theta)
quasi_velocities: {h: r^2*theta'/(1 + r^2)}
"""


@pytest.mark.parametrize("array", ["", "numpy"])
def test_a_coframe_is_singular_before_the_mass_that_it_divides(array: str, tmp_path: Path) -> None:
    """At r = 0 the mass m/h_theta^2 of h is infinite: Python must not divide before it looks."""
    source = Source("swinging_mass.yaml", SWINGING)
    (text,) = emit(source, "python", Options(array=array)).values()
    module = python_model(text, "swinging_mass")
    files = emit(source, "c", Options())
    model = CModel("swinging_mass", ctypes.CDLL(str(compile_c(files, tmp_path, "swinging_mass"))), {})
    y, p = [0.0, 0.3, 0.1, 0.2], list(module.DEFAULTS)
    for function, size in (("rhs", 4), ("velocities", 2), ("accelerations", 2), ("jacobian", 16)):
        assert ask_c(model, function, size, [0.0, y, p]) == 1
        assert ask_python(module, function, [numpy.array(x) for x in (0.0, y, p)] if array else [0.0, y, p]) == 1


TYRE = """nhc: 1
system: tyre
coordinates: [x, y, th, f]
parameters: {m: 1, J: 0.3, s: 0.4, V: 2}
T: m/2*(x'^2 + y'^2) + J/2*th'^2
forces: {y: -3*f*cos(th), x: 3*f*sin(th)}
constraints:
  - relax: s*f' + V*f - (-sin(th)*x' + cos(th)*y') = 0
"""


@pytest.mark.parametrize("length", [0.4, 1e-300, 0.0])
def test_many_states_are_refused_where_one_is(length: float, tmp_path: Path) -> None:
    """m s^2 is zero to a double where s is 1e-300, and the rates are numbers all the same."""
    files = emit(Source("tyre.yaml", TYRE), "c", Options(formulation="euler-lagrange"))
    library = compile_c(files, tmp_path, "tyre", ("-O0",))
    model = CModel("tyre", ctypes.CDLL(str(library)), {})
    y, p = [0.0] * 7, [1.0, 0.3, length, 2.0]
    assert ask_batch(model, 7, 0.0, y, p) == ask_c(model, "rhs", 7, [0.0, y, p]) == (2 if length == 0.0 else 0)
