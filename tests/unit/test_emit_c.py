"""The C back end: compiled with warnings as errors, called through ctypes, compared with the Python back end."""

from __future__ import annotations

import csv
import ctypes
import io
import math
import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy
import pytest

from nhc.diagnostics import Source
from nhc.emit import EmitError, EmitOptions, render
from nhc.emit.c.literals import PI, print_comment, print_double, print_float, print_string
from nhc.pipeline import Options, emit
from nhc.program.ir import Program, SceneData
from tests.support import CModel, compile_c
from tests.unit.emit_cases import (
    CASES,
    Fraction,
    function,
    loads,
    make_oscillator,
    make_sleigh,
    make_solver,
    quantities,
    ref,
    store,
)

FLAGS = (
    "-std=c99",
    "-O2",
    "-Wall",
    "-Wextra",
    "-Wpedantic",
    "-Wconversion",
    "-Wdouble-promotion",
    "-Wshadow",
    "-Werror",
)
FOUND = {os.path.realpath(path): c for c in ("clang-14", "clang", "gcc") if (path := shutil.which(c))}  # each once
COMPILERS = [*reversed(FOUND.values())] or ["cc"]


def write(program: Program, folder: Path, options: EmitOptions) -> list[Path]:
    """The C files of a program, the sources first."""
    files = render(program, "c", options)
    for name, text in files.items():
        (folder / name).write_text(text, encoding="ascii")
    return [folder / name for name in files if name.endswith(".c")]


def load(program: Program, folder: Path, options: EmitOptions = EmitOptions()) -> ctypes.CDLL:  # noqa: B008 - frozen
    """The compiled functions of a program."""
    sources = write(program, folder, options)
    library = folder / "model.so"
    subprocess.run([COMPILERS[0], *FLAGS, "-shared", "-fPIC", "-o", library, *sources, "-lm"], check=True, cwd=folder)
    return ctypes.CDLL(str(library))


def doubles(values: list[float]) -> ctypes.Array[ctypes.c_double]:
    return (ctypes.c_double * max(len(values), 1))(*values)


def call(function: object, arguments: list[list[float]], size: int) -> tuple[int, list[float]]:
    """Status and output of an ``int`` function at t = 0."""
    out = doubles([0.0] * size)
    status = function(ctypes.c_double(0.0), *(doubles(a) for a in arguments), out)  # type: ignore[operator]
    return int(status), list(out)[:size]


def load_python(program: Program) -> dict[str, object]:
    """The names of the Python module of the same program."""
    (text,) = render(program, "python", EmitOptions()).values()
    names: dict[str, object] = {"__name__": "emitted"}
    exec(compile(text, "emitted", "exec"), names)
    return names


def run_driver(program: Program, folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """The driver's run."""
    sources = write(program, folder, EmitOptions(driver=True))
    subprocess.run([COMPILERS[0], *FLAGS, *sources, "-lm", "-o", folder / "run"], check=True, cwd=folder)
    return subprocess.run([folder / "run", *arguments], capture_output=True, text=True, timeout=60)


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("name", CASES)
def test_every_program_compiles_without_a_warning(name: str, compiler: str, tmp_path: Path) -> None:
    program = CASES[name]
    sources = write(program, tmp_path, EmitOptions(driver=bool(program.scenes)))
    for dialect in ("-std=c99", "-std=gnu17"):
        flags = [*FLAGS[1:], "-Wshadow", dialect]
        subprocess.run([compiler, *flags, "-c", *sources], check=True, cwd=tmp_path)


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("only", [("rhs",), ("rhs_batch",), ("energy",), ("outputs", "velocities")])
def test_only_prints_what_is_asked_for_and_still_compiles(name: str, only: tuple[str, ...], tmp_path: Path) -> None:
    program = CASES[name]
    known = {function.name for function in program.functions}
    if not {"rhs" if item == "rhs_batch" else item for item in only} <= known:
        with pytest.raises(EmitError, match="no function"):
            render(program, "c", EmitOptions(only=only))
        return
    (source,) = write(program, tmp_path, EmitOptions(only=only))
    subprocess.run([COMPILERS[0], *FLAGS, "-c", source], check=True, cwd=tmp_path)
    declared = re.findall(rf"{program.system}_(\w+)\(", (tmp_path / f"{program.system}.h").read_text())
    expected = set(only) | ({"rhs"} if "rhs_batch" in only else set())
    assert set(declared) == expected


def test_the_header_works_in_cpp(tmp_path: Path) -> None:
    write(make_sleigh(), tmp_path, EmitOptions())
    (tmp_path / "user.cpp").write_text('#include "sleigh.h"\n#include "sleigh.h"\nint n = SLEIGH_NY;\n')
    subprocess.run(["g++", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-c", "user.cpp"], check=True, cwd=tmp_path)


@pytest.mark.parametrize("point", [(0.3, 0.7), (0.9, -0.4), (0.5, 0.5), (0.25, 2.5)])
def test_both_languages_compute_the_same_values(point: tuple[float, float], tmp_path: Path) -> None:
    program = CASES["calculator"]
    size = len(program.outputs)
    y = list(point)
    if y[0] <= 0:
        y[0] = 0.1
    status, ours = call(load(program, tmp_path).calculator_outputs, [y, []], size)
    theirs = load_python(program)["outputs"](0.0, y)  # type: ignore[operator]
    assert status == 0
    assert ours == pytest.approx(theirs, rel=1e-14, abs=1e-15)
    a, b = y
    facts = [math.sin(a), math.cos(a), math.tan(a), math.asin(a)]
    assert ours[:4] == pytest.approx(facts, rel=1e-14)
    tail = [a - (b - a), a - (b + a), a / (b / a), a / (b * a), -(a + b), -(a * b), a, a + b, a - b * a]
    tail += [a * -b, a * a, -(a * a), (a + b) ** 3, 1 / a**2, -8 * a, math.sin(a) ** 2, a * (b * a), 1.0, 2 / 3, 1e22]
    assert ours[20:] == pytest.approx(tail, rel=1e-14)
    assert ours[18:20] == [min(a, b, 0.25), max(a, b, 0.25)]


def test_a_value_outside_of_a_domain_is_a_status(tmp_path: Path) -> None:
    program = CASES["calculator"]
    library = load(program, tmp_path)
    for y in ([1.5, 0.2], [-0.5, 0.2], [0.5, 0.0], [math.nan, 1.0], [0.5, math.nan], [math.inf, 1.0]):
        assert call(library.calculator_outputs, [y, []], len(program.outputs))[0] == 1


def test_the_root_of_rhs_is_that_of_libm(tmp_path: Path) -> None:
    """Where the machine's is taken, and where the compiler is told that nobody asks for errno."""
    text = (
        "nhc: 1\nsystem: far\ncoordinates: [x, y]\nT: (x'^2 + y'^2)/2\nV: sqrt(x^2 + y^2 + 1)\nforces: {x: sqrt(y)}\n"
    )
    files = emit(Source("far.yaml", text), "c", Options(only=("rhs", "energy")))
    source = files["far.c"]
    assert source.count("far_root(") == 3 and source.count(" sqrt(") == 2
    found = []
    for flags in ((), ("-fno-math-errno",)):
        folder = tmp_path / str(len(flags))
        folder.mkdir()
        model = CModel("far", ctypes.CDLL(str(compile_c(files, folder, "far", ("-O2", *flags)))), {})
        found.append([model("rhs", 4, 0.0, [0.1 * k, 0.3 * k, 0.0, 0.0], []) for k in range(1, 9)])
        with pytest.raises(ArithmeticError):
            model("rhs", 4, 0.0, [0.1, -0.3, 0.0, 0.0], [])
    assert found[0] == found[1]
    for k, slope in enumerate(found[0], 1):
        assert slope[2] == pytest.approx(math.sqrt(0.3 * k) - 0.1 * k / math.sqrt(0.1 * k * k + 1), rel=1e-14)


def test_guards_leave_with_their_own_status(tmp_path: Path) -> None:
    library = load(make_sleigh(), tmp_path)
    good = [0.0, 0.0, 0.1, 1.0, 0.5]

    def status(y: list[float], p: list[float]) -> int:
        return call(library.sleigh_rhs, [y, p], 5)[0]

    assert status(good, [1.0, 0.3, 0.25]) == 0
    assert status(good, [1.0, -1.0, 1.0]) == 1
    assert status(good, [0.0, 1.0, 1.0]) == 2
    assert status([*good[:4], 7.0], [1.0, 0.3, 0.25]) == 3
    assert status([*good[:3], math.inf, 0.5], [1.0, 0.3, 0.25]) == 4
    assert status(good, [1.0, 0.3, math.nan]) == 4
    library.sleigh_energy.restype = ctypes.c_double
    assert math.isnan(library.sleigh_energy(ctypes.c_double(0), doubles(good), doubles([0.0, 1.0, 1.0])))
    defaults = (ctypes.c_double * 3).in_dll(library, "sleigh_parameter_defaults")
    assert list(defaults)[:2] == [1.0, 0.3] and math.isnan(defaults[2])


@pytest.mark.parametrize("size", [1, 2, 3, 5])
def test_solve_pivots_and_refuses_singular_matrices(size: int, tmp_path: Path) -> None:
    program = make_solver(size)
    function = load(program, tmp_path).solver_rhs
    y = [0.0 if size > 1 else 2.0, *(0.3 * i for i in range(1, size))]
    status, found = call(function, [y, []], size)
    assert status == 0
    python = load_python(program)
    assert found == pytest.approx(python["rhs"](0.0, y), rel=1e-14)  # type: ignore[operator]
    matrix = [[y[i] if i == j else 1.0 / (1 + i + j) for j in range(size)] for i in range(size)]
    first, second = (numpy.linalg.solve(matrix, b) for b in ([i + 1.0 for i in range(size)], numpy.sin(y)))
    assert found == pytest.approx([first[0], *(first + second)[1:]], rel=1e-12)
    if size == 2:
        assert call(function, [[1.0, 0.25], []], 2)[0] == 1  # [[1, 1/2], [1/2, 1/4]]
    if size == 1:
        assert call(function, [[0.0], []], 1)[0] == 1
    assert call(function, [[math.nan] * size, []], size)[0] == 2


def test_a_sparse_matrix_is_set_to_zero_at_once(tmp_path: Path) -> None:
    program, size = make_solver(7, band=1), 7
    (source,) = write(program, tmp_path, EmitOptions())
    text = source.read_text()
    assert "memset(block1, 0, 63 * sizeof *block1);" in text and "block1[2] =" not in text
    assert len(re.findall(r"block1\[\d+\] = ", text)) == 3 * size - 2 + 2 * size
    y = [0.0, *(0.3 * i for i in range(1, size))]
    matrix = [[y[i] if i == j else (abs(i - j) == 1) / (1 + i + j) for j in range(size)] for i in range(size)]
    first, second = (numpy.linalg.solve(matrix, b) for b in ([i + 1.0 for i in range(size)], numpy.sin(y)))
    status, found = call(load(program, tmp_path).solver_rhs, [y, []], size)
    assert status == 0 and found == pytest.approx([first[0], *(first + second)[1:]], rel=1e-12)


@pytest.mark.parametrize(
    ("program", "p"), [(make_sleigh(), [1.0, 0.3, 0.25]), (make_solver(), []), (make_oscillator(), [2.0])]
)
def test_the_batch_is_the_scalar_function(program: Program, p: list[float], tmp_path: Path) -> None:
    library, name, size, count = load(program, tmp_path), program.system, len(program.state), 5
    states = [[math.sin(1.0 + 3 * i + k) for k in range(size)] for i in range(count)]
    flat = doubles([states[i][k] for k in range(size) for i in range(count)])
    out = doubles([0.0] * (size * count))
    batch = getattr(library, f"{name}_rhs_batch")
    times = doubles([0.0] * count)
    assert batch(ctypes.c_size_t(count), times, flat, doubles(p), out) == 0
    for i in range(count):
        status, one = call(getattr(library, f"{name}_rhs"), [states[i], p], size)
        assert status == 0
        assert [out[k * count + i] for k in range(size)] == one
    flat[(size - 1) * count + 2] = math.nan
    assert batch(ctypes.c_size_t(count), times, flat, doubles(p), out) != 0
    assert batch(ctypes.c_size_t(0), times, flat, doubles(p), out) == 0
    if name == "sleigh":
        flat[(size - 1) * count + 2] = 7.0
        assert batch(ctypes.c_size_t(count), times, flat, doubles(p), out) == 3
        assert batch(ctypes.c_size_t(count), times, flat, doubles([0.0, 1.0, 1.0]), out) == 2


def test_empty_arrays_and_entries_that_are_never_stored(tmp_path: Path) -> None:
    library = load(make_oscillator(), tmp_path)
    for empty in (library.oscillator_reactions, library.oscillator_outputs):
        assert call(empty, [[1.0, 2.0], [3.0]], 0) == (0, [])
    assert call(library.oscillator_residuals, [[1.0], [2.0], [3.0]], 0) == (0, [])
    assert call(library.oscillator_jacobian, [[1.0, 2.0], [3.0]], 4) == (0, [0.0, 1.0, -3.0, 0.0])
    names = (ctypes.c_char_p * 2).in_dll(library, "oscillator_state_names")
    assert list(names) == [b"x", b"x'"]


def test_hostile_names_and_texts_change_no_value(tmp_path: Path) -> None:
    program = CASES["hostile"]
    size = len(program.state)
    y = [0.1 * i + 0.05 for i in range(size)]
    status, found = call(load(program, tmp_path).hostile_rhs, [y, []], size)
    total = y[0]
    for value in y[1:]:
        total = total * 0.5 + value
    assert status == 0
    assert found == pytest.approx([total * i for i in range(size)], rel=1e-14)
    text = (tmp_path / "hostile.h").read_text()
    assert "{{ 7*7 }}" in text and "<<name>>" in text and "Caplygin theta" in text and "??" not in text


def test_the_driver_meets_a_closed_form_and_every_output_time(tmp_path: Path) -> None:
    done = run_driver(make_oscillator(), tmp_path, "swing", "27")
    rows = list(csv.reader(io.StringIO(done.stdout)))
    assert (done.returncode, done.stderr, rows[0]) == (0, "", ["t", "x", "x'", "energy"])
    assert len(rows) == 28
    for i, row in enumerate(rows[1:]):
        t, x, speed, energy = map(float, row)
        assert t == 6.5 * (i / 26)
        assert (x, speed, energy) == pytest.approx((math.cos(t), -math.sin(t), 0.5), abs=1e-9)
        assert row[1] == f"{x:.17g}"
    assert float(rows[-1][0]) == 6.5


def test_the_drivers_arguments(tmp_path: Path) -> None:
    assert run_driver(make_oscillator(), tmp_path).stdout.count("\n") == 202
    program = tmp_path / "run"

    def run(*arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([program, *arguments], capture_output=True, text=True)

    rest = run("rest", "2")
    assert rest.stdout == "t,x\n1,0\n2,0\n"
    for wrong in (["nowhere"], ["swing", "1"], ["swing", "x"], ["swing", "5", "0"], ["swing", "5", "1e-9", "6"]):
        done = run(*wrong)
        assert (done.returncode, done.stdout) == (2, "") and "usage: oscillator" in done.stderr
    assert run("--help").stdout.startswith("usage:")
    errors = [
        abs(float(run("swing", "2", tolerance).stdout.split("\n")[2].split(",")[1]) - math.cos(6.5))
        for tolerance in ("1e-3", "1e-6", "1e-12")
    ]
    assert errors[0] < 1e-2 and errors[1] < 1e-5 and errors[2] < 1e-11 and errors[2] < errors[0]


def test_the_driver_prints_every_kind_of_quantity(tmp_path: Path) -> None:
    done = run_driver(make_sleigh(), tmp_path)
    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    assert list(rows[0]) == ["t", "y", "theta'", "v", "lnv", "lambda_slip", "energy"]
    last = {name: float(value) for name, value in rows[-1].items()}
    assert last["t"] == 20.0
    assert last["energy"] == pytest.approx(0.5453125, rel=1e-8)
    assert last["lnv"] == pytest.approx(math.log(last["v"]), rel=1e-14)
    assert last["lambda_slip"] == pytest.approx(last["v"] * last["theta'"], rel=1e-12)


def test_the_driver_stops_at_a_singular_point_with_status_3(tmp_path: Path) -> None:
    done = run_driver(CASES["hostile"], tmp_path)  # its scene starts where the guard fails
    assert done.returncode == 3
    assert "stops at t = 0" in done.stderr
    assert "nan" not in done.stdout.lower()


def test_the_driver_stops_at_a_blow_up_with_status_3(tmp_path: Path) -> None:
    """x' = x^2 from 1 leaves every bound at t = 1."""
    rhs = function("rhs", (*loads("y", "x"), store("dydt", 0, ref("x") * ref("x"))), (1, 0), ("dydt", 1))
    x = quantities("x")
    scene = SceneData("burst", "", (1.0,), (), (0.0, 2.0), (), 1e-9)
    program = Program("burst", "", "newton", "", "", x, x, (), (), (), (rhs,), (scene,))
    done = run_driver(program, tmp_path, "burst", "5")
    assert done.returncode == 3
    assert float(done.stdout.split("\n")[2].split(",")[1]) == pytest.approx(2.0, rel=1e-8)
    assert re.search(r"stops at t = (0\.99999\d+|1(\.0000\d+)?):", done.stderr), done.stderr
    assert not re.search("nan|inf", done.stdout)


def test_only_with_a_driver_keeps_what_the_driver_calls() -> None:
    files = render(make_sleigh(), "c", EmitOptions(only=("rhs",), driver=True, scene="glide"))
    declared = set(re.findall(r"sleigh_(\w+)\(", files["sleigh.h"]))
    assert declared == {"rhs", "velocities", "reactions", "outputs", "energy"}
    with pytest.raises(EmitError, match="no scene `dive`"):
        render(make_sleigh(), "c", EmitOptions(driver=True, scene="dive"))
    with pytest.raises(EmitError, match="none"):
        render(make_solver(), "c", EmitOptions(driver=True))


def read_table(text: str, name: str) -> list[float]:
    """The numbers of one of the driver's tables."""
    found = re.search(rf"double {name}(?:\[STAGES\])+ = \{{(.*?)\n\}};", text, re.S)
    assert found
    return [float(number) for number in re.findall(r"-?\d[\d.]*(?:e-?\d+)?", found[1])]


def test_the_tableau_obeys_its_laws() -> None:
    text = render(make_oscillator(), "c", EmitOptions(driver=True))["oscillator_main.c"]
    nodes, weights = read_table(text, "NODES"), read_table(text, "ADVANCE")
    entries = read_table(text, "WEIGHTS")
    rows = [entries[:1]]
    rest = entries[1:]
    for i in range(1, 12):
        rows.append(rest[:i])
        rest = rest[i:]
    assert rest == [] and len(nodes) == len(weights) == 12
    for row, node in zip(rows, nodes, strict=True):
        assert math.fsum(row) == pytest.approx(node, abs=1e-14)
    for k in range(8):  # quadrature of order 8
        assert math.fsum(b * c**k for b, c in zip(weights, nodes, strict=True)) == pytest.approx(1 / (k + 1), abs=1e-14)
    inner = [math.fsum(a * c for a, c in zip(row, nodes, strict=False)) for row in rows]
    assert math.fsum(b * c * s for b, c, s in zip(weights, nodes, inner, strict=True)) == pytest.approx(
        1 / 8, abs=1e-14
    )
    for name, order in (("ERROR5", 5), ("ERROR3", 3)):
        estimate = read_table(text, name)
        for k in range(order):
            assert math.fsum(e * c**k for e, c in zip(estimate, nodes, strict=True)) == pytest.approx(0, abs=1e-14)


def test_literals() -> None:
    assert print_double(Fraction(2)) == "2.0"
    assert print_double(Fraction(1, 3)) == repr(1 / 3)
    assert print_double(Fraction(10) ** 22) == "1e22"
    assert print_double(Fraction(1, 10**30)) == "1e-30"
    assert float(PI) == math.pi
    with pytest.raises(EmitError, match="too large"):
        print_double(Fraction(10) ** 400)
    assert print_float(math.nan) == "(double)NAN" and print_float(-math.inf) == "-(double)INFINITY"
    assert print_string('a"\\??ř') == '"a\\"\\\\\\?\\?\\305\\231"'
    for text in ("*/", "/*", "/*/", "??/", "???/", "x \\", "a\\\nb", "\u202e"):
        comment = print_comment(text)
        assert not any(bad in comment for bad in ("*/", "/*", "??")) and not comment.endswith("\\")
