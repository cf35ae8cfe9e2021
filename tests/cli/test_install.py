"""What a wheel holds, that nhc runs from it alone, and what an editable install does beside it."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path


def test_a_wheel_is_complete(root: Path, tmp_path: Path) -> None:
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(tmp_path)]
    subprocess.run(build, cwd=root, check=True, capture_output=True, timeout=120)
    (wheel,) = tmp_path.glob("nhc-*.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "site")
    inside = {
        path.relative_to(tmp_path / "site").as_posix() for path in (tmp_path / "site").rglob("*") if path.is_file()
    }
    for folder in ("templates", "specs"):
        wanted = {path.relative_to(root).as_posix() for path in (root / folder).rglob("*") if path.is_file()}
        assert wanted
        assert {f"nhc/_data/{name}" for name in wanted} <= inside
    assert {path.split("/")[0] for path in inside if ".dist-info" not in path} == {"nhc"}

    environment = {**os.environ, "PYTHONPATH": str(tmp_path / "site")}
    command = [sys.executable, "-P", "-m", "nhc", "emit", "chaplygin_sleigh", "--lang", "c", "-o", "out"]
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["chaplygin_sleigh.c", "chaplygin_sleigh.h"]


def test_an_editable_install_has_bytecode(root: Path, tmp_path: Path) -> None:
    """A start where PYTHONDONTWRITEBYTECODE is set compiles nothing: all that is imported is there to be read."""
    place = tmp_path / "checkout"
    for folder in ("nhc", "templates", "specs"):
        shutil.copytree(root / folder, place / folder, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "hatch_build.py", "README.md", "LICENSE"):
        shutil.copy2(root / name, place)
    build = [sys.executable, "-c", "import hatchling.build as b, sys; b.build_editable(sys.argv[1])", str(tmp_path)]
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(place)}
    subprocess.run(build, cwd=place, env=environment, check=True, capture_output=True, timeout=120)
    command = [sys.executable, "-P", "-v", "-m", "nhc", "emit", "chaplygin_sleigh", "--lang", "c", "-o", "out"]
    done = subprocess.run(
        command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=120, check=False
    )
    assert done.returncode == 0, done.stderr
    assert f"code object from '{place}" in done.stderr  # a file of bytecode, in quotes
    assert f"code object from {place}" not in done.stderr  # a source, which it has compiled itself
