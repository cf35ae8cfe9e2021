"""The inlined sine and cosine: accuracy against mpmath, large angles, and the models that use them."""

from __future__ import annotations

import ctypes
import math
import random
from pathlib import Path

import mpmath
import pytest

from nhc.language import read
from nhc.pipeline import Options, emit
from tests.support import CModel, c_model, compile_c, doubles, emitted, error


def model(name: str, folder: Path) -> CModel:
    files = emitted(name, "c", Options(trig="inline"))
    return CModel(name, ctypes.CDLL(str(compile_c(files, folder, name, ("-O2",)))), {})


def sizes(header: Path) -> tuple[int, int]:
    """The numbers of states and parameters."""
    lines = header.read_text().splitlines()
    size, count = (next(int(s.split("=")[1].split(",")[0]) for s in lines if f"_{n} =" in s) for n in ("NY", "NP"))
    return size, count


def test_the_inlined_pair_is_within_three_ulps(tmp_path: Path) -> None:
    """x' = v cos(theta), y' = v sin(theta) with v = 1: the sleigh's rhs is the pair itself."""
    sleigh = model("chaplygin_sleigh", tmp_path)
    rng, worst = random.Random(3), 0.0
    with mpmath.workdps(40):
        for k in range(20_000):
            near = rng.randrange(500_000) * math.pi / 16 + rng.choice((0.0, 1e-12, 1e-7, 2e-5, 1e-3)) * rng.uniform(
                -1, 1
            )
            x = rng.choice((-1, 1)) * (10 ** rng.uniform(-8, 5) if k % 2 else near)
            found = sleigh("rhs", 5, 0.0, [0, 0, x, 1, 0], [1, 0.5, 0.7])
            for value, exact in zip(found, (mpmath.cos(x), mpmath.sin(x)), strict=False):
                worst = max(worst, float(abs(value - exact)))
                assert abs(value - exact) < 2.5 * math.ulp(float(exact)) + 1e-19
                if abs(exact) >= 1e-5:  # what the documents promise
                    assert abs(value - exact) < 3 * math.ulp(float(exact))
    assert worst < 2.5e-16


TWO = """\
nhc: 1
system: two_turns
coordinates: [x, y, z, w, a, b]
T: 1/2*(x'^2 + y'^2 + z'^2 + w'^2 + a'^2 + b'^2)
forces: {x: cos(a), y: sin(a), z: cos(b), w: sin(b)}
"""


def test_two_angles_at_once_are_as_accurate(tmp_path: Path) -> None:
    """The accelerations are the cosines and sines themselves; one large angle gives libm's of both."""
    path = tmp_path / "two_turns.yaml"
    path.write_text(TWO)
    files = emit(read(str(path)), "c", Options(trig="inline"))
    assert "two_turns_two_at(a, b, large)" in files["two_turns.c"]
    turns = CModel("two_turns", ctypes.CDLL(str(compile_c(files, tmp_path, "two_turns", ("-O2",)))), {})
    rng = random.Random(5)

    def turn(a: float, b: float) -> list[float]:
        return turns("rhs", 12, 0.0, [0.0] * 4 + [a, b] + [0.0] * 6, [])[6:10]

    with mpmath.workdps(40):
        for _ in range(5_000):
            angles = [rng.choice((-1, 1)) * 10 ** rng.uniform(-8, 5) for _ in range(2)]
            exact = [f(x) for x in angles for f in (mpmath.cos, mpmath.sin)]
            for value, wanted in zip(turn(*angles), exact, strict=True):
                assert abs(value - wanted) < 2.5 * math.ulp(float(wanted)) + 1e-19
    for a, b in ((0.3, 2e5), (-1e7, 1.0)):
        assert turn(a, b) == [math.cos(a), math.sin(a), math.cos(b), math.sin(b)]


def test_the_table_holds_the_sines_to_the_last_digit(root: Path) -> None:
    text = (root / "templates" / "c" / "parts" / "trig.c.jinja").read_text()
    table = [float(word) for word in text.split("_sines[48] = {")[1].split("}")[0].split(",")]
    with mpmath.workdps(40):
        exact = [float(mpmath.sin(mpmath.pi * k / 16)) if k % 16 else 0.0 for k in range(48)]
    assert table == exact


def test_large_angles_fall_back(tmp_path: Path) -> None:
    sleigh = model("chaplygin_sleigh", tmp_path)
    for x in (1.00001e5, 1e9, -1e15):
        found = sleigh("rhs", 5, 0.0, [0, 0, x, 1, 0], [1, 0.5, 0.7])
        assert found[:2] == [math.cos(x), math.sin(x)]
    for x in (math.inf, -math.inf, math.nan):
        with pytest.raises(ArithmeticError):
            sleigh("rhs", 5, 0.0, [0, 0, x, 1, 0], [1, 0.5, 0.7])


@pytest.mark.parametrize("name", ["n_trailer3", "double_pendulum", "snakeboard"])
def test_one_large_angle_gives_the_doubles_of_libm(name: str, tmp_path: Path) -> None:
    """Where one angle is too large, all of the right-hand side is libm's, to the last bit."""
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    inline, libm = model(name, tmp_path / "a"), c_model(name, "", tmp_path / "b")
    size, count = sizes(tmp_path / "a" / f"{name}.h")
    p, rng = libm.defaults(count), random.Random(name)

    def differs(*large: int) -> bool:
        y = [rng.uniform(0.2, 0.8) + 1e5 * (k in large) for k in range(size)]
        return inline("rhs", size, 0.3, y, p) != libm("rhs", size, 0.3, y, p)

    assert any(differs() for _ in range(20)), "small angles do not take the inlined sine and cosine"
    turned = [k for k in range(size // 2) if not any(differs(k) for _ in range(20))]
    assert turned, "no angle takes libm's sine and cosine where it is large"
    assert not any(differs(*turned) for _ in range(20))


@pytest.mark.parametrize("name", ["rolling_disk", "n_trailer3", "rattleback", "pendulum"])
def test_the_same_as_libm(name: str, tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    (tmp_path / "b").mkdir()
    inline, libm = model(name, tmp_path / "a"), c_model(name, "", tmp_path / "b")
    rng = random.Random(name)
    size, count = sizes(tmp_path / "a" / f"{name}.h")
    p = libm.defaults(count)
    states = [[rng.uniform(0.2, 0.8) for _ in range(size)] for _ in range(7)]
    rates = [libm("rhs", size, 0.3, y, p) for y in states]
    for y, expected in zip(states, rates, strict=True):
        assert error(inline("rhs", size, 0.3, y, p), expected) < 1e-13
    # a batch whose last state has a large angle goes through rhs, one by one
    states[-1] = [x + 2e5 * math.pi if k < size // 2 else x for k, x in enumerate(states[-1])]
    expected = [libm("rhs", size, 0.3, y, p) for y in states]
    columns = [y[k] for k in range(size) for y in states]
    out = (ctypes.c_double * (size * 7))()
    call = getattr(inline.library, f"{name}_rhs_batch")
    assert call(ctypes.c_size_t(7), doubles([0.3] * 7), doubles(columns), doubles(p), out) == 0
    for i, rate in enumerate(expected):
        assert error([out[k * 7 + i] for k in range(size)], rate) < 1e-9
