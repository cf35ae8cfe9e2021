"""Emitted bytes depend on the spec's text, the options and nhc's version: not on hash seeds, folders or the name of its file."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support import ROOT, seldom, spec_path

SYSTEMS = [
    *("rolling_disk", "snakeboard"),
    *map(seldom, ("ball_on_table", "n_trailer3", "rattleback")),
]
SCRIPT = """
import sys
from nhc.cli.entry import main
for language, more in (("c", ["--driver"]), ("python", []), ("latex", [])):
    assert main(["emit", sys.argv[1], "--lang", language, "-o", sys.argv[2], *more]) == 0
assert main(["derive", sys.argv[1], "--json", "-o", sys.argv[2] + "/derivation.json"]) == 0
"""


def emitted(spec: str, folder: Path, seed: str) -> dict[str, bytes]:
    folder.mkdir(parents=True)
    environment = {**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-c", SCRIPT, spec, str(folder)]
    done = subprocess.run(command, env=environment, cwd=folder.parent, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


@pytest.mark.sample(2)
@pytest.mark.parametrize("name", SYSTEMS)
def test_same_bytes(name: str, tmp_path: Path) -> None:
    elsewhere = tmp_path / "a folder" / "another name.yml"
    elsewhere.parent.mkdir()
    shutil.copy(spec_path(name), elsewhere)
    first = emitted(str(spec_path(name)), tmp_path / "one" / "out", "0")
    assert len(first) == 6
    for seed, spec, folder in (("1", str(elsewhere), "two"), ("4242", elsewhere.name, "a folder")):
        assert emitted(spec, tmp_path / folder / f"out{seed}", seed) == first
