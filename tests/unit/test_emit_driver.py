"""What an emitted driver watches between its steps."""

from __future__ import annotations

import math
import re
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from nhc.emit import EmitOptions
from nhc.program.ir import Driving, Lookout
from tests.unit.emit_cases import call, function, loads, make_oscillator, ref, store, wrap
from tests.unit.test_emit_c import COMPILERS, FLAGS, write


@pytest.mark.parametrize("compiler", COMPILERS)
def test_the_driver_stops_where_a_watched_value_is_lost(compiler: str, tmp_path: Path) -> None:
    """x = cos t; helpers that the model's own file has too come with the watched values."""
    x, slope = ref("x"), ref("x_dot")
    least = call("min", call("sign", x), call("max", x, slope))
    values = (x + wrap(2.0), x * x - wrap(1e-12), wrap(3.0) + least)
    body = (*loads("y", "x", "x_dot"), *(store("out", k, value) for k, value in enumerate(values)))
    watch = Lookout(function("watch", body, (2, 1), ("out", 3)), ("x is far left", 'x is "gone"', "never"), 1)
    sources = write(replace(make_oscillator(), driving=Driving(lookout=watch)), tmp_path, EmitOptions(driver=True))
    done = subprocess.run([compiler, *FLAGS, "-Wshadow", *sources, "-lm", "-o", tmp_path / "run"], cwd=tmp_path)
    assert done.returncode == 0
    swing = subprocess.run([tmp_path / "run", "swing", "14"], capture_output=True, text=True)
    found = re.search(r"stops at t = (\S+): (.*)\n", swing.stderr)
    assert swing.returncode == 3 and found is not None and found[2] == 'x is "gone"'
    assert float(found[1]) == pytest.approx(math.pi / 2, abs=1e-5)
    assert float(swing.stdout.splitlines()[-1].split(",")[0]) == 1.5
    assert subprocess.run([tmp_path / "run", "rest", "2"], stdout=subprocess.DEVNULL).returncode == 0
