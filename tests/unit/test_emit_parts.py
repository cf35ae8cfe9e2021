"""Long functions in parts, sweeps over vectors, calls between functions: the same values as one straight function has."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from benchmarks.models import source as spec_source
from nhc.emit import EmitOptions, render
from nhc.emit.c import batch, parts, sweep
from nhc.emit.c.arrange import arrange
from nhc.emit.c.pairs import Pair, pair_angles
from nhc.emit.c.parts import cut, find_crossing
from nhc.emit.text.program import print_program
from nhc.pipeline import Options
from nhc.pipeline import program as build_program
from nhc.program.contents import count_operations
from nhc.program.ir import Guard, Let, Load, Section, Solve, Sweep
from tests.unit.emit_cases import call, let, make_solver, ref, store
from tests.unit.emit_long import LINKS, make_long
from tests.unit.test_emit_c import COMPILERS, FLAGS, doubles, load, load_python, write
from tests.unit.test_emit_c import call as evaluate

Y, P = [0.4, 0.7, -0.3], [1.5]
WIDTHS = (1, 2, 4, 8)


@pytest.fixture(autouse=True)
def short_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Limits that a program of some hundred statements exceeds: compilers take their time over longer ones."""
    for module in (parts, sweep):
        monkeypatch.setattr(module, "choose_lengths", lambda _: (120, 60))
    monkeypatch.setattr(batch, "LONGEST", 120)
    monkeypatch.setattr(batch, "USUAL", 60)


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("machine", ["", "-mavx512f", "-DLONG_CHAIN_LANES=1"])
def test_it_compiles_without_a_warning(compiler: str, machine: str, tmp_path: Path) -> None:
    (source,) = write(make_long(), tmp_path, EmitOptions())
    subprocess.run([compiler, *FLAGS, "-Wshadow", *machine.split(), "-c", source], check=True, cwd=tmp_path)


def test_no_function_is_long(tmp_path: Path) -> None:
    (source,) = write(make_long(), tmp_path, EmitOptions())
    text = source.read_text()
    bodies = dict(re.findall(r"\n[A-Za-z_ ]+ (\w+)\([^{}]*\)\n\{\n(.*?)\n\}", text, re.DOTALL))
    long = [name for name, body in bodies.items() if body.count(";") > LINKS]
    assert not long
    assert "long_chain_rhs_part2" in text and "long_chain_jacobian_sweep1_part2" in text


def test_long_functions_that_are_called_seldom_say_so(tmp_path: Path) -> None:
    (source,) = write(make_long(), tmp_path, EmitOptions())
    slow = re.findall(
        r"^LONG_CHAIN_SLOW\s(?:static )?(?:int|void) long_chain_(\w+)\(", source.read_text(), re.MULTILINE
    )
    assert {name.split("_")[0] for name in slow} == {"accelerations", "jacobian"}
    assert {"jacobian", "jacobian_part1", "jacobian_sweep1_part1", "accelerations"} <= set(slow)
    (text,) = (t for name, t in render(make_long(), "c", EmitOptions(only=("rhs",))).items() if name.endswith(".c"))
    assert "SLOW" not in text


def test_a_part_reads_what_others_left_just_before_it_needs_it(tmp_path: Path) -> None:
    (source,) = write(make_long(), tmp_path, EmitOptions())
    read = re.compile(r"    const \w+ (\w+) = (?:\w+\()?(?:kept|carried|seed|y|p)\b[^;]*;.*\n")
    text = source.read_text().split("static int long_chain_jacobian_part1", 1)[1].split("_rhs_lanes_part1")[0]
    runs = re.findall(rf"((?:{read.pattern})+)([^;]*;)", text)
    assert len(runs) > LINKS / 10
    for names, _, statement in runs:
        assert set(read.findall(names)) <= set(re.findall(r"\w+", statement))


@pytest.mark.parametrize("width", WIDTHS)
def test_c_agrees_with_python_for_every_width_of_vectors(width: int, tmp_path: Path) -> None:
    program = make_long()
    (source,) = write(program, tmp_path, EmitOptions())
    source.write_text(f"#define LONG_CHAIN_LANES {width}\n" + source.read_text())
    library = tmp_path / "model.so"
    quiet = ["-Wno-psabi"]  # vectors wider than the machine's, which no function passes on
    command = [COMPILERS[0], "-std=c99", "-O1", *quiet, "-shared", "-fPIC", "-o", library, source, "-lm"]
    subprocess.run(command, check=True, cwd=tmp_path)
    import ctypes

    loaded, module = ctypes.CDLL(str(library)), load_python(program)
    for name, size in (("rhs", 3), ("accelerations", 1), ("jacobian", 9)):
        status, found = evaluate(getattr(loaded, f"long_chain_{name}"), [Y, P], size)
        expected = module[name](0.0, Y, P)  # type: ignore[operator]
        flat = [x for row in expected for x in row] if name == "jacobian" else expected
        assert status == 0
        assert found == pytest.approx(flat, rel=1e-13, abs=1e-15)


def test_the_sweep_is_the_derivative(tmp_path: Path) -> None:
    library = load(make_long(), tmp_path)
    _, jacobian = evaluate(library.long_chain_jacobian, [Y, P], 9)
    h = 1e-6
    for j in range(3):
        up, down = ([v + s * h * (k == j) for k, v in enumerate(Y)] for s in (1, -1))
        high, low = (evaluate(library.long_chain_rhs, [y, P], 3)[1] for y in (up, down))
        column = [(a - b) / (2 * h) for a, b in zip(high, low, strict=True)]
        assert jacobian[j::3] == pytest.approx(column, abs=1e-8)


def test_a_guard_in_a_later_part_and_behind_a_call_is_a_status(tmp_path: Path) -> None:
    library, rest = load(make_long(), tmp_path), [0.0, 0.0, 0.0]
    for name, size in (("rhs", 3), ("accelerations", 1), ("jacobian", 9)):
        assert evaluate(getattr(library, f"long_chain_{name}"), [rest, P], size)[0] == 1
    out = doubles([0.0] * 6)
    count = __import__("ctypes").c_size_t(2)
    assert (
        library.long_chain_rhs_batch(
            count, doubles([0.0, 0.0]), doubles([0.4, 0.0, 0.7, 0.0, -0.3, 0.0]), doubles(P), out
        )
        == 1
    )


def test_only_brings_what_is_called() -> None:
    files = render(make_long(), "c", EmitOptions(only=("accelerations",)))
    assert set(re.findall(r"int long_chain_(\w+)\(", files["long_chain.h"])) == {"rhs", "accelerations"}
    (text,) = render(make_long(), "python", EmitOptions(only=("accelerations",))).values()
    assert re.findall(r"^def ([a-z]+)\(", text, re.MULTILINE) == ["rhs", "accelerations"]


def test_the_dump_shows_sweeps_and_calls() -> None:
    text = print_program(make_long())
    assert "dydt := rhs at the same arguments" in text
    assert "sweep (e_x, e_v, e_z) from [0, 1, 2]" in text


def test_every_pass_of_a_sweep_is_counted() -> None:
    jacobian = make_long().functions[-1]
    (sweep,) = (s for s in jacobian.body if isinstance(s, Sweep))
    whole, once = count_operations((sweep,)), count_operations(sweep.body)
    assert whole == tuple(3 * n for n in once) and once[0] > LINKS


def test_a_dense_solve_multiplies_and_adds_in_pairs_with_the_cube_of_its_size() -> None:
    pairs = []
    for size in (20, 40):
        (solve,) = (s for s in make_solver(size).functions[0].body if isinstance(s, Solve))
        adds, multiplications, _, calls = count_operations((solve,))
        assert adds == multiplications and calls == size  # the sines of a column
        pairs.append(adds)
    assert 7 * pairs[0] < pairs[1] < 8 * pairs[0]


def test_crossing_names_are_those_that_another_part_uses() -> None:
    body = [
        let("a", ref("x") * 2),
        let("b", ref("a") + ref("x")),
        let("c", ref("b") * ref("a")),
        let("d", ref("c") * 3),
    ]
    assert cut(body, 2, 2) == (tuple(body[:2]), tuple(body[2:]))
    assert find_crossing(cut(body, 2, 2)) == {"a": 0, "b": 1}
    assert cut(body, 4, 1) == (tuple(body),) and find_crossing([body]) == {}
    assert all(isinstance(s, Let | Load | Solve) for s in body)


def test_sines_come_first_in_pairs_and_guards_last() -> None:
    read = (Load("x", "y", 0), Load("z", "y", 1), Load("k", "p", 0))
    guard = Guard(ref("a").node, ref("x").node, 1e-9, 1, "a")
    lets = {
        "a": let("a", ref("k") * 2),
        "s": let("s", call("sin", ref("x"))),
        "late": let("late", call("sin", ref("s"))),
        "d": let("d", ref("x") - ref("z")),
        "cd": let("cd", call("cos", ref("d"))),
        "c": let("c", call("cos", ref("x"))),
        "scaled": let("scaled", call("cos", ref("a") * ref("x"))),
    }
    end = store("dydt", 0, ref("late") + ref("cd") + ref("c") + ref("scaled"))
    body = (*read, lets["a"], guard, lets["s"], lets["late"], lets["d"], lets["cd"], lets["c"], lets["scaled"], end)
    found = arrange(body)
    assert sorted(map(repr, found)) == sorted(map(repr, (*body, Section("sines and cosines"))))
    assert [s.name for s in found if isinstance(s, Let)] == ["a", "d", "s", "c", "cd", "scaled", "late"]
    assert found[-2:] == (end, guard) and found[:3] == read


def test_work_waits_for_the_sines_and_numbers_are_read_when_they_are_needed() -> None:
    x, v, k, g = Load("x", "y", 0), Load("v", "y", 1), Load("k", "p", 0), Load("g", "p", 1)
    fixed, head = (let("sk", call("sin", ref("k"))),), Section("from the state")
    sine, rate = let("sx", call("sin", ref("x"))), let("a", ref("sx") * ref("sk") * ref("g"))
    ends = (store("dydt", 0, ref("v")), store("dydt", 1, ref("a")))
    found = arrange((x, v, k, g, Section("from the parameters alone"), *fixed, head, sine, rate, *ends))
    title, others = Section("sines and cosines"), Section("what else is read")
    assert found == (x, k, title, *fixed, sine, others, v, g, head, rate, *ends)
    assert arrange((x, v, head, sine, ends[0])) == (x, title, sine, others, v, head, ends[0])
    other = let("a", ref("x") * ref("g"))
    assert arrange((x, v, k, g, head, other, *ends)) == (head, x, g, other, v, *ends)


def test_angles_are_paired_with_the_next_that_is_known_in_time() -> None:
    body = (
        Load("x", "y", 0),
        Load("z", "y", 1),
        let("s", call("sin", ref("x"))),  # with z, which is known; d is not
        let("d", ref("z") - ref("s")),
        let("c", call("cos", ref("x"))),
        let("e", call("sin", ref("d")) * call("cos", ref("z"))),
        let("f", call("sin", ref("z") * 2)),  # known when d is needed
    )
    assert pair_angles(body) == [Pair(2, (ref("x").node, ref("z").node)), Pair(5, (ref("d").node, (ref("z") * 2).node))]
    assert pair_angles(body[:3]) == []


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("band", [1, 9])
def test_parts_share_the_filling_of_a_long_dense_solve(
    band: int, compiler: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program, size = make_solver(9, band=band), 9
    y = [0.0, *(0.3 * i for i in range(1, size))]
    whole = evaluate(load(program, tmp_path).solver_rhs, [y, []], size)
    monkeypatch.setattr(parts, "SLOW", frozenset({"rhs"}))
    monkeypatch.setattr(parts, "LENGTHS", (20, 15))
    monkeypatch.setattr(parts, "choose_lengths", lambda _: (20, 15))
    (tmp_path / "parts").mkdir()
    (source,) = write(program, tmp_path / "parts", EmitOptions())
    text = source.read_text()
    assert "solver_rhs_part3" in text and "memset(kept, 0, " in text and "block1" not in text
    subprocess.run([compiler, *FLAGS, "-Wshadow", "-c", source], check=True, cwd=tmp_path)
    library = load(program, tmp_path / "parts")
    assert whole[0] == 0 and evaluate(library.solver_rhs, [y, []], size) == whole
    assert evaluate(library.solver_rhs, [[float("nan")] * size, []], size)[0] == 2


def test_unknowns_of_a_filled_solve_are_found_by_later_parts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parts, "LENGTHS", (60, 50))
    model = build_program(
        spec_source("trailers4"), Options(formulation="multipliers", only=("rhs", "jacobian", "reactions"))
    )
    library, module = load(model, tmp_path), load_python(model)
    assert (tmp_path / "trailers4.c").read_text().count("memset(kept, 0, ") == 2
    size, given = len(model.state), [float(q.default) for q in model.parameters if q.default is not None]
    y = [0.3 - 0.07 * k for k in range(size)]
    for name, count in (("jacobian", size**2), ("reactions", len(model.constraints))):
        status, found = evaluate(getattr(library, f"trailers4_{name}"), [y, given], count)
        expected = module[name](0.0, y)  # type: ignore[operator]
        flat = [x for row in expected for x in row] if name == "jacobian" else expected
        assert status == 0 and found == pytest.approx(flat, rel=1e-13, abs=1e-13)


def test_a_dense_solve_keeps_its_guards_before_it() -> None:
    (rhs,) = make_solver().functions
    assert arrange(rhs.body) == rhs.body
