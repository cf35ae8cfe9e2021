"""Long code of chains as loops: the same doubles as straight code gives, in every function; hardly longer for a longer chain."""

from __future__ import annotations

import ctypes
import random
import re
import subprocess
from functools import cache
from pathlib import Path

import pytest

from benchmarks.models import source as spec_source
from nhc.diagnostics import Source
from nhc.emit import EmitOptions, render
from nhc.emit.c import batch, parts, sweep
from nhc.emit.c.rolled import roll
from nhc.emit.c.rolled.cells import Cells, UnfitError, furnish
from nhc.emit.c.rolled.shift import find_orbits, list_pieces, trace
from nhc.pipeline import Options
from nhc.pipeline import program as build_program
from nhc.program.ir import Let, Load, Program, Statement
from tests.support import seldom
from tests.trees import joints
from tests.unit.emit_cases import E, call, let, ref, store
from tests.unit.test_emit_c import COMPILERS, FLAGS, write

CHAINS = ("trailers20", "snake20", "pendulum20", "joints8", "unlike16", "driven12")


def made(name: str) -> Program:
    """The program of a chain."""
    kind, count = re.fullmatch(r"([a-z]+)(\d+)", name).groups()  # type: ignore[union-attr]
    if kind == "joints":
        return build_program(joints(int(count)), Options())
    if kind in ("unlike", "driven"):
        text = _unlike(int(count), driven=kind == "driven")
        return build_program(Source("links.yaml", text), Options())
    return build_program(spec_source(name), Options())


def _unlike(count: int, *, driven: bool) -> str:
    """Pendulums on one another with masses of their own, or links of one mass on a point that is moved."""
    of = range(count)
    lines = ["nhc: 1", "system: links", f"coordinates: [{', '.join(f'a{i}' for i in of)}]", "define:"]
    x, y = ("sin(3*t)", "t/5") if driven else ("0", "0")
    for i in of:
        lines += [f"  x{i}: {x} + l*sin(a{i})", f"  y{i}: {y} - l*cos(a{i})"]
        x, y = f"x{i}", f"y{i}"
    masses = ["m" if driven else f"m{i}" for i in of]
    lines.append("T: " + " + ".join(f"{m}/2*(x{i}'^2 + y{i}'^2)" for i, m in enumerate(masses)))
    lines.append("V: " + " + ".join(f"{m}*g*y{i}" for i, m in enumerate(masses)))
    lines.append("forces: {" + ", ".join(f"a{i}: -d*a{i}'*abs(a{i}')" for i in of) + "}")
    values = {"l": 0.7, "g": 9.81, "d": 0.1} | {m: 1 + i / 11 for i, m in enumerate(masses)}
    lines += ["parameters:", *(f"  {name}: {value}" for name, value in values.items())]
    lines += ["scenes:", "  go: {initial: {a0: 0.5}, time: [0, 1]}"]
    return "\n".join(lines) + "\n"


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Chains that are soon derived shall be long enough."""
    for module in (parts, sweep):
        monkeypatch.setattr(module, "choose_lengths", lambda _: (60, 40))
    monkeypatch.setattr(batch, "LONGEST", 60)
    monkeypatch.setattr(batch, "USUAL", 40)
    monkeypatch.setattr(roll, "WORTH", 0.97)


@cache
def program(name: str) -> Program:
    """Derived once."""
    return made(name)


def compiled(folder: Path, chain: Program, flags: tuple[str, ...], name: str) -> ctypes.CDLL:
    """The functions; gcc may not fuse products with sums, so that the same statements give the same doubles."""
    (source,) = write(chain, folder, EmitOptions())
    library = folder / name
    command = [COMPILERS[0], "-std=c99", "-O0", "-ffp-contract=off", *flags, "-shared", "-fPIC", "-o", library, source]
    subprocess.run([*command, "-lm"], check=True, cwd=folder)
    return ctypes.CDLL(str(library))


def evaluate(library: ctypes.CDLL, chain: Program, y: list[float]) -> dict[str, tuple[int, list[float]]]:
    """Every function that fills an array, at a state; ``rhs_batch`` at five."""
    values = [float(quantity.default or 0.0) for quantity in chain.parameters]
    found: dict[str, tuple[int, list[float]]] = {}
    p = (ctypes.c_double * max(1, len(values)))(*values)
    for function in chain.functions:
        if function.output is None:
            continue
        given = [
            ctypes.c_double(0.3) if a.size < 0 else (ctypes.c_double * a.size)(*y[: a.size]) for a in function.inputs
        ]
        given = [p if a.name == "p" else value for a, value in zip(function.inputs, given, strict=True)]
        out = (ctypes.c_double * max(1, function.output.size))()
        status = getattr(library, f"{chain.system}_{function.name}")(*given, out)
        found[function.name] = status, list(out)
    count = 5
    several = [v * (1 + k / 50) for v in y[: len(chain.state)] for k in range(count)]
    states = (ctypes.c_double * len(several))(*several)
    out = (ctypes.c_double * len(states))()
    status = getattr(library, f"{chain.system}_rhs_batch")(
        ctypes.c_size_t(count), (ctypes.c_double * count)(*[0.3] * count), states, p, out
    )
    found["rhs_batch"] = status, list(out)
    return found


@pytest.mark.sample(4)
@pytest.mark.parametrize(("name", "width"), [*((name, 2) for name in CHAINS), seldom("joints8", 1), ("pendulum20", 4)])
def test_loops_give_the_same_doubles(name: str, width: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    chain = program(name)
    draw = random.Random(name)
    y = [draw.uniform(-1.2, 1.2) for _ in range(3 * len(chain.coordinates))]
    found = {}
    for worth in (0.97, 0.0):  # at nothing at all, no loop is worth it
        monkeypatch.setattr(roll, "WORTH", worth)
        library = compiled(tmp_path, chain, (f"-D{chain.system.upper()}_LANES={width}", "-Wno-psabi"), f"{worth}.so")
        found[worth] = evaluate(library, chain, y)
        assert ("++turn" in (tmp_path / f"{chain.system}.c").read_text()) == bool(worth)
    assert found[0.97] == found[0.0]
    assert all(status == 0 for status, _ in found[0.0].values())


@pytest.mark.sample(2)
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize(("name", "trig"), [("joints8", "plain"), ("driven12", "inline"), ("unlike16", "plain")])
def test_loops_compile_without_a_warning(compiler: str, name: str, trig: str, tmp_path: Path) -> None:
    (source,) = write(program(name), tmp_path, EmitOptions(trig=trig))
    quick = ["-O0"] * (name == "joints8")
    subprocess.run([compiler, *FLAGS, *quick, "-Wshadow", "-c", source], check=True, cwd=tmp_path)


def test_a_longer_chain_is_hardly_longer_code(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    lengths = []
    for count in (40, 80):
        chain = build_program(spec_source(f"pendulum{count}"), Options(only=("jacobian",)))
        text = render(chain, "c", EmitOptions(only=("jacobian",)))[f"pendulum{count}.c"]
        assert "++turn" in text
        lengths.append(text.count(";\n"))
    assert lengths[1] < 1.25 * lengths[0]  # a refusal for each pivot, which has its own status


def test_cells_share_a_room_where_names_stand_in_their_order() -> None:
    cells = Cells([("a1", "a2", "a3", "a4"), ("b1", "b2", "b3")])
    forward, before = cells.ask(("a1", "a2", "a3", "a4")), cells.ask(("base", "a1", "a2", "a3"))
    back, other = cells.ask(("a4", "a3", "a2")), cells.ask(("foot", "a1", "a2"))
    layout = furnish(cells)
    places = {name: where[0] for name, where in layout.places.items()}
    for spot, names in ((forward, "a1 a2"), (before, "base a1"), (back, "a4 a3")):
        first, step = layout.locate(spot)
        assert [first, first + step] == [places[name] for name in names.split()]
    assert other.room is not before.room  # one place cannot hold both `base` and `foot`
    assert len(layout.places["a1"]) == 2 and min(map(min, layout.places.values())) == 0


def test_what_loops_compute_otherwise_is_copied_if_it_is_little() -> None:
    cells = Cells([("a1", "a2", "a3", "a4"), tuple(f"b{k}" for k in range(9))])
    spot = cells.ask(("a2", "x", "y"))
    assert ("a2", spot.room, 0) in cells.list_copied()
    with pytest.raises(UnfitError):
        cells.ask(("b0", "b2", "b1", "b4", "b3", "b6"))


def chain_of(count: int) -> list[Statement]:
    """A recursion from a root and stores of what it gives."""
    lines: list[Statement] = [Load(f"q{k}", "y", k) for k in range(count)]
    lines.append(let("z0", call("sin", ref("q0")) * 3.0))
    lines += [let(f"z{k}", ref(f"z{k - 1}") * 0.5 + ref(f"q{k}")) for k in range(1, count)]
    return [*lines, *(store("dydt", k, ref(f"z{k}") - ref("z0")) for k in range(count))]


def test_the_shift_is_found_from_the_results() -> None:
    body = chain_of(9)
    loads = {s.name: s for s in body if isinstance(s, Load)}
    orbits = find_orbits(list_pieces(body), loads)
    assert [f"z{k}" for k in range(1, 9)] in orbits
    assert len(orbits) == 2 and orbits[1][0].startswith("dydt[")


def test_an_outline_is_built_again() -> None:
    value = E((-(call("atan2", ref("a"), ref("b") / 3.0) - ref("a"))).node)
    outline, names = trace(value.node)
    assert names == ("a", "b", "a")
    assert roll.build(outline, names) == value.node


def test_a_family_that_ends_early_leaves_the_others_their_loop() -> None:
    body = [*chain_of(12), let("extra", ref("z4") * ref("z4")), store("dydt", 12, ref("extra"))]
    loads = {s.name: s for s in body if isinstance(s, Load)}
    made = roll.roll(body, loads)
    assert made is not None and made.is_in_order(())
    made.order.reverse()
    assert not made.is_in_order(())
    made.order.reverse()
    assert made.length < len([s for s in body if isinstance(s, Let)])
    assert "z4" in furnish(made.cells).places
