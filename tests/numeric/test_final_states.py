"""The reference's final states, reached by the emitted Python with SciPy and by the emitted C driver."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from scipy.integrate import solve_ivp

from nhc.pipeline import Options
from tests.support import compile_c, emitted, emitted_python, error, reference

FINAL = {entry["system"]: entry for entry in reference("final_states")}
TOLERANCE = 1e-8


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", sorted(FINAL))
def test_python_with_scipy(name: str) -> None:
    entry, model = FINAL[name], emitted_python(name)
    y = model.state(0.0, entry["q0"], [float(v) for v in entry["v0"]])
    run = solve_ivp(model.rhs, (0.0, entry["t_end"]), y, method="DOP853", rtol=2.3e-14, atol=1e-14)
    assert run.success
    found = list(run.y[:, -1])
    n = len(model.COORDINATES)
    assert error(found[:n], entry["q_end"]) < TOLERANCE
    assert error(model.velocities(entry["t_end"], found), entry["v_end"]) < TOLERANCE


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", sorted(FINAL))
def test_the_c_driver(name: str, tmp_path: Path) -> None:
    files = emitted(name, "c", Options(driver=True))
    program = compile_c(files, tmp_path, name, library=False)
    done = subprocess.run([program, "reference", "11", "1e-13"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    header, *rows = done.stdout.splitlines()
    names = header.split(",")
    assert names[0] == "t" and len(rows) == 11
    last = dict(zip(names, map(float, rows[-1].split(",")), strict=True))
    entry = FINAL[name]
    assert last["t"] == entry["t_end"]
    q_names = [c for c in emitted_python(name).COORDINATES if c in last]
    assert q_names, "the scene `reference` should need coordinates"
    q_end = dict(zip(emitted_python(name).COORDINATES, entry["q_end"], strict=True))
    assert error([last[c] for c in q_names], [q_end[c] for c in q_names]) < TOLERANCE
