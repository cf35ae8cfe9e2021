"""The Python back end: run, compared between its three kinds, and held against ruff and mypy."""

from __future__ import annotations

import copy
import math
import pickle
import subprocess
import sys
import types
from pathlib import Path
from typing import Any

import numpy
import pytest
from scipy.integrate import solve_ivp

from nhc.emit import EmitError, EmitOptions, render
from nhc.emit.python.literals import print_docstring, print_float, print_string
from nhc.program.ir import Program
from tests.support import ROOT
from tests.unit.emit_cases import (
    CASES,
    Fraction,
    function,
    let,
    loads,
    make_hostile,
    make_oscillator,
    make_sleigh,
    make_solver,
    quantities,
    ref,
    store,
)
from tests.unit.emit_long import make_long

ARRAYS = ("", "numpy", "jax")
GOOD = [0.0, 0.0, 0.1, 1.0, 0.5]
P = [1.0, 0.3, 0.25]


def emit(program: Program, array: str = "", only: tuple[str, ...] = ()) -> str:
    (text,) = render(program, "python", EmitOptions(array=array, only=only)).values()
    return text


def load(program: Program, array: str = "", only: tuple[str, ...] = ()) -> Any:
    """The module of a program."""
    module = types.ModuleType("emitted")
    exec(compile(emit(program, array, only), "emitted", "exec"), module.__dict__)
    return module


def make_wide(terms: int = 3000) -> Program:
    """A sum of thousands of terms, deep nesting, long names: what breaks lines and recursion."""
    names = tuple(f"a_rather_long_name_of_a_velocity_{i}" for i in range(4))
    total = ref(names[0])
    for i in range(terms):
        total = total + ref(names[i % 4]) * float(i)
    deep = ref(names[1])
    for i in range(60):
        deep = (deep + float(i)) * (ref(names[2]) - deep.__class__(ref(names[3]).node)) / (ref(names[0]) + 1.5)
    body = (
        *loads("y", *names),
        let("total", total),
        store("dydt", 0, ref("total"), "a remark that is much too long for one line of eighty-eight characters " * 2),
        store("dydt", 1, deep),
        store("dydt", 2, (ref(names[0]) + ref(names[1])) * (ref(names[2]) + ref(names[3])) ** 3),
        store("dydt", 3, 1.0),
    )
    rhs = function("rhs", body, (4, 0), ("dydt", 4))
    return Program("wide", "", "newton", "", "", (), quantities(*names), (), (), (), (rhs,))


PROGRAMS = CASES | {"wide": make_wide(), "long_chain": make_long()}


@pytest.mark.parametrize("array", ARRAYS)
def test_the_text_is_as_ruff_would_write_it(array: str, tmp_path: Path) -> None:
    for name, program in PROGRAMS.items():
        (tmp_path / f"{name}.py").write_text(emit(program, array), encoding="utf-8")
    for width in ("88", "120"):
        command = ["ruff", "format", "--isolated", "--diff", "--line-length", width, "."]
        done = subprocess.run([sys.executable, "-m", *command], capture_output=True, text=True, cwd=tmp_path)
        assert done.returncode == 0, done.stdout
    command = ["ruff", "check", "--isolated", "--select", "E,F,W,I,UP,B,SIM,RUF", "--line-length", "120", "."]
    command += ["--ignore", "RUF001,RUF002,RUF003", "--target-version", "py311", "--output-format", "concise"]
    done = subprocess.run([sys.executable, "-m", *command], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stdout


def test_the_text_is_clean_under_strict_mypy(tmp_path: Path) -> None:
    # a sum's terms are all of one type, and NumPy's operators are overloaded: thousands of them take mypy half a minute
    for name, program in (PROGRAMS | {"wide": make_wide(60)}).items():
        for array in ("", "numpy"):
            (tmp_path / f"{name}{array}.py").write_text(emit(program, array), encoding="utf-8")
    # the house's own settings: `make check` has left NumPy's stubs, which take longer than all the rest, in this cache
    settings = (f"--config-file={ROOT / 'pyproject.toml'}", f"--cache-dir={ROOT / '.mypy_cache'}")
    command = [sys.executable, "-m", "mypy", *settings, "."]
    done = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stdout


def test_constants_and_signatures() -> None:
    module = load(make_sleigh())
    assert module.COORDINATES == ("x", "y", "theta")
    assert module.STATE == ("x", "y", "theta", "v", "w")
    assert module.PARAMETERS == ("m", "I", "lambda")
    assert module.DEFAULTS[:2] == (1.0, 0.3) and math.isnan(module.DEFAULTS[2])
    assert module.CONSTRAINTS == ("slip",) and module.OUTPUTS == ("lnv",)
    oscillator = load(make_oscillator())
    assert oscillator.CONSTRAINTS == () and oscillator.OUTPUTS == ()
    assert oscillator.rhs(0.0, [1.0, 2.0]) == [2.0, -1.0]
    assert oscillator.rhs(0.0, [1.0, 2.0], [3.0]) == [2.0, -3.0]
    assert oscillator.energy(0.0, [1.0, 2.0]) == 2.5
    assert oscillator.jacobian(0.0, [1.0, 2.0], [3.0]) == [[0.0, 1.0], [-3.0, 0.0]]
    assert oscillator.reactions(0.0, [1.0, 2.0]) == [] == oscillator.residuals(0.0, [1.0], [2.0])
    assert "(2,)" in oscillator.rhs.__doc__ and "(I.2.15)" in oscillator.rhs.__doc__
    assert "Q_i gains lambda_a a_ai" in oscillator.reactions.__doc__


def test_solve_ivp_takes_rhs_and_jacobian() -> None:
    module = load(make_oscillator())
    done = solve_ivp(module.rhs, (0, 3), [1.0, 0.0], method="Radau", jac=module.jacobian, rtol=1e-8, atol=1e-10)
    assert done.y[0, -1] == pytest.approx(math.cos(3), abs=1e-6)


@pytest.mark.parametrize(
    ("y", "p", "status", "words"),
    [
        (GOOD, [1.0, -1.0, 1.0], 1, "rhs: the moment of inertia is singular"),
        (GOOD, [0.0, 1.0, 1.0], 2, "the mass vanishes"),
        ([*GOOD[:4], 7.0], P, 3, "w is seven"),
        ([*GOOD[:3], math.inf, 0.5], P, 4, "not finite"),
        ([*GOOD[:2], math.inf, 1.0, 0.5], P, 4, "not finite or not defined"),
        (GOOD, [1.0, 0.3, math.nan], 4, "not finite"),
    ],
)
@pytest.mark.parametrize("array", ["", "numpy"])
def test_singular_points_raise_with_the_status_of_c(
    array: str, y: list[float], p: list[float], status: int, words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = load(make_sleigh(), array)
    assert len(module.rhs(0.0, GOOD, P)) == 5
    with pytest.raises(module.SingularModelError, match=words) as caught:
        module.rhs(0.0, y, p)
    assert caught.value.status == status
    monkeypatch.setitem(sys.modules, "emitted", module)  # a pickle names the module of its class
    for again in (copy.copy(caught.value), pickle.loads(pickle.dumps(caught.value))):
        assert (again.status, str(again)) == (status, str(caught.value))
    with pytest.raises(ArithmeticError, match="energy: the mass vanishes"):
        module.energy(0.0, GOOD, [0.0, 1.0, 1.0])


def test_an_overflow_becomes_a_singular_point() -> None:
    module = load(make_sleigh())
    with pytest.raises(module.SingularModelError, match="not finite") as caught:
        module.rhs(0.0, [*GOOD[:4], 1e200], P)
    assert isinstance(caught.value.__cause__, OverflowError)


@pytest.mark.parametrize("y", [[1.5, 0.2], [-0.5, 0.2], [0.5, 0.0], [math.nan, 1.0], [0.0, 0.5]])
def test_errors_of_math_become_singular_points(y: list[float]) -> None:
    for array in ("", "numpy"):
        module = load(CASES["calculator"], array)
        with pytest.raises(module.SingularModelError):
            module.outputs(0.0, y)


def test_solve_pivots_and_refuses_singular_matrices() -> None:
    for array in ("", "numpy"):
        module = load(make_solver(2), array)
        assert module.rhs(0.0, [0.0, 0.0])[0] == pytest.approx(4.0, rel=1e-15)
        for y, status in (([1.0, 0.25], 1), ([math.nan, 1.0], module.NOT_FINITE)):
            with pytest.raises(module.SingularModelError) as caught:
                module.rhs(0.0, y)
            assert caught.value.status == status


@pytest.mark.parametrize("array", ["numpy", "jax"])
@pytest.mark.parametrize(("name", "p"), [("sleigh", P), ("solver", []), ("oscillator", [2.0])])
@pytest.mark.usefixtures("jax_is_numpy")
def test_arrays_agree_with_the_scalar_module(name: str, p: list[float], array: str) -> None:
    program = CASES[name]
    scalar, module = load(program), load(program, array)
    size = len(program.state)
    y = numpy.sin(1.0 + numpy.arange(size * 6)).reshape(size, 2, 3)
    y[-1] = numpy.abs(y[-1])
    if name == "sleigh":
        y[3] = numpy.abs(y[3])
    for item in program.functions:
        if item.name == "residuals":
            assert getattr(module, item.name)(0.0, y[:1], y[1:], p).shape == (0, 2, 3)
            continue
        found = numpy.asarray(getattr(module, item.name)(0.0, y, p))
        for index in numpy.ndindex(2, 3):
            one = getattr(scalar, item.name)(0.0, [float(v) for v in y[(slice(None), *index)]], p)
            assert found[(..., *index)] == pytest.approx(numpy.asarray(one), rel=1e-6 if found.dtype == "f4" else 1e-13)
    assert module.rhs(numpy.zeros((2, 3)), y[:, 0, 0][:, None, None] * numpy.ones((1, 1, 1)), p).shape == (size, 2, 3)


@pytest.mark.usefixtures("jax_is_numpy")
def test_jax_marks_singular_lanes_and_leaves_the_others() -> None:
    sleigh = load(make_sleigh(), "jax")
    y = numpy.array([GOOD, [*GOOD[:4], 7.0], GOOD]).T
    with numpy.errstate(all="ignore"):
        found = numpy.asarray(sleigh.rhs(0.0, y, P))
        assert numpy.isnan(found[:, 1]).all() and numpy.isfinite(found[:, [0, 2]]).all()
        found = numpy.asarray(sleigh.rhs(0.0, numpy.array(GOOD), [0.0, 1.0, 1.0]))
        assert numpy.isnan(found).all()
        assert numpy.isnan(sleigh.energy(0.0, numpy.array(GOOD), [0.0, 1.0, 1.0]))
        solver = load(make_solver(2), "jax")
        found = numpy.asarray(solver.rhs(0.0, numpy.array([[1.0, 0.0], [0.25, 0.0]])))
        assert numpy.isnan(found[:, 0]).all() and numpy.isfinite(found[:, 1]).all()


def test_numpy_raises_when_any_lane_is_singular() -> None:
    module = load(make_sleigh(), "numpy")
    with pytest.raises(module.SingularModelError, match="w is seven"):
        module.rhs(0.0, numpy.array([GOOD, [*GOOD[:4], 7.0]]).T, P)


def test_hostile_names_and_texts_change_no_value() -> None:
    program = make_hostile()
    y = [0.1 * i + 0.05 for i in range(len(program.state))]
    total = y[0]
    for value in y[1:]:
        total = total * 0.5 + value
    text = emit(program)
    assert "{{ 7*7 }}" in text and "\u202e" not in text and "Čaplygin θ" in text
    module = load(program)
    assert module.rhs(0.0, y) == [total * i for i in range(len(y))]
    assert "\\N{BULLET}" in module.__doc__
    keyword = Program("lambda", "", "newton", "", "", (), (), (), (), (), ())
    assert list(render(keyword, "python", EmitOptions())) == ["lambda_.py"]


def test_long_expressions_keep_their_values() -> None:
    y = [0.3, 0.7, -0.2, 1.1]
    found = load(make_wide()).rhs(0.0, y)
    total = y[0]
    for i in range(3000):
        total += y[i % 4] * i
    assert found[0] == total
    assert found[2] == pytest.approx((y[0] + y[1]) * (y[2] + y[3]) ** 3, rel=1e-15)
    assert all(len(line) <= 88 for line in emit(make_wide()).split("\n"))


def test_only_prints_what_is_asked_for() -> None:
    module = load(make_sleigh(), only=("energy",))
    assert hasattr(module, "energy") and not hasattr(module, "rhs") and not hasattr(module, "_finish")
    with pytest.raises(EmitError, match="no function `nothing`"):
        emit(make_sleigh(), only=("nothing",))
    with pytest.raises(EmitError, match="no array library `torch`"):
        emit(make_sleigh(), "torch")


def test_literals() -> None:
    assert [print_float(v) for v in (Fraction(2), Fraction(1, 3), 1e22, 1e-5)] == ["2.0", repr(1 / 3), "1e22", "1e-05"]
    assert print_float(math.nan) == "math.nan" and print_float(-math.inf) == "-math.inf"
    with pytest.raises(EmitError, match="too large"):
        print_float(Fraction(10) ** 400)
    assert print_string("x'\"\\") == "\"x''\\\\\""
    assert print_docstring('a """ \\N{X}\n') == "a ''' \\\\N{X}"
