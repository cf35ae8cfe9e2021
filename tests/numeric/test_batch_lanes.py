"""``rhs_batch`` for every width of vectors and every number of states: the scalar function's values, statuses and refusals."""

from __future__ import annotations

import ctypes
import math
import random
from pathlib import Path

import pytest

from nhc.pipeline import Options
from tests.support import CModel, compile_c, doubles, emitted

COUNTS = (0, 1, 2, 7, 8, 9, 19)
SYSTEMS = {
    "rolling_disk": "",
    "n_trailer3": "",
    "snakeboard": "",
    "pumped_pendulum": "",
    "cvt": "",
    "chaotic": "",
    "rattleback": "",
}


def _model(name: str, trig: str, width: int, folder: Path) -> CModel:
    """GCC takes vectors apart that the machine does not have, so that every width runs everywhere."""
    files = emitted(name, "c", Options(trig=trig, only=("rhs", "rhs_batch")))
    flags = ("-O1", "-Wno-psabi", f"-D{name.upper()}_LANES={width}")
    return CModel(name, ctypes.CDLL(str(compile_c(files, folder, name, flags))), {})


def _sizes(name: str, folder: Path) -> tuple[int, int]:
    text = (folder / f"{name}.h").read_text()
    found = {
        line.split()[0]: int(line.split("=")[1].split(",")[0])
        for line in text.splitlines()
        if "_NY = " in line or "_NP = " in line
    }
    return found[f"{name.upper()}_NY"], found[f"{name.upper()}_NP"]


def _batch(
    model: CModel, times: list[float], states: list[list[float]], p: list[float], size: int
) -> tuple[int, list[list[float]]]:
    count = len(states)
    columns = [state[k] for k in range(size) for state in states]
    out = (ctypes.c_double * max(1, size * count))()
    call = getattr(model.library, f"{model.name}_rhs_batch")
    status = call(ctypes.c_size_t(count), doubles(times), doubles(columns), doubles(p), out)
    return status, [[out[k * count + i] for k in range(size)] for i in range(count)]


@pytest.mark.sample(3)
@pytest.mark.parametrize("trig", ["", "inline"])
@pytest.mark.parametrize("width", [1, 2, 4, 8])
@pytest.mark.parametrize("name", SYSTEMS)
def test_every_state_has_the_scalar_functions_values(name: str, width: int, trig: str, tmp_path: Path) -> None:
    model = _model(name, trig, width, tmp_path)
    size, given = _sizes(name, tmp_path)
    p, rng = model.defaults(given), random.Random(name)
    for count in COUNTS:
        times = [rng.uniform(0, 2) for _ in range(count)]
        states = [[rng.uniform(0.2, 0.8) for _ in range(size)] for _ in range(count)]
        status, found = _batch(model, times, states, p, size)
        assert status == 0
        # the same operations in the same order: the same doubles, as long as nothing is contracted
        assert found == [model("rhs", size, t, y, p) for t, y in zip(times, states, strict=True)]


@pytest.mark.parametrize("width", [4, 8])
def test_a_state_that_is_asked_again_leaves_the_others_alone(width: int, tmp_path: Path) -> None:
    """Large angles go through libm; a singular or a bad state gives the status, and the others have their values."""
    name = "rolling_disk"
    model = _model(name, "inline", width, tmp_path)
    size, given = _sizes(name, tmp_path)
    p, rng = model.defaults(given), random.Random(7)
    states = [[rng.uniform(0.2, 0.8) for _ in range(size)] for _ in range(21)]
    states[3][2] += 2e6 * math.pi
    states[18][2] -= 4e5 * math.pi
    times = [0.0] * len(states)
    expected = [model("rhs", size, 0.0, y, p) for y in states]
    assert _batch(model, times, states, p, size) == (0, expected)
    for place, value, code in ((3, 0.0, 1), (5, math.inf, 3), (6, math.nan, 3), (2, math.inf, 3)):
        changed = [list(y) for y in states]
        changed[12][place] = value  # place 3 is the lean, 0 where the coframe is singular
        with pytest.raises(ArithmeticError) as caught:
            model("rhs", size, 0.0, changed[12], p)
        status, found = _batch(model, times, changed, p, size)
        assert status == caught.value.args[0]
        assert status == code or not math.isfinite(value)
        assert [rate for i, rate in enumerate(found) if i != 12] == [rate for i, rate in enumerate(expected) if i != 12]


def test_parameters_that_are_singular_are_refused_at_once(tmp_path: Path) -> None:
    model = _model("rolling_disk", "inline", 8, tmp_path)
    size, given = _sizes("rolling_disk", tmp_path)
    p = [0.0] * given
    assert _batch(model, [0.0] * 9, [[0.5] * size] * 9, p, size)[0] == 2
