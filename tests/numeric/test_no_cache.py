"""Runs where the user's cache folder cannot be used, as in a container: compiled for one process, and nothing is left."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from nhc.simulate.c import compile as compiling
from nhc.simulate.c.compile import CacheError, build
from tests.support import COMPILER, spec_path

pytestmark = pytest.mark.skipif(not COMPILER, reason="no C compiler")

UNIT = {"one.c": "int one(void);\nint one(void) { return 1; }\n"}


def start(tmp_path: Path, *arguments: str, **settings: str) -> subprocess.CompletedProcess[str]:
    """A process whose cache folder lies below a file, and whose temporary folder is ours."""
    (tmp_path / "file").touch()
    (tmp_path / "passing").mkdir()
    keep = {name: value for name, value in os.environ.items() if name != "NHC_CACHE"}
    keep |= {"XDG_CACHE_HOME": str(tmp_path / "file"), "TMPDIR": str(tmp_path / "passing"), **settings}
    command = [sys.executable, "-m", "nhc", *arguments]
    return subprocess.run(command, capture_output=True, text=True, env=keep, check=False)


@pytest.mark.parametrize("verb", ["run", "ensemble"])
def test_models_are_compiled_for_one_run(tmp_path: Path, verb: str) -> None:
    table = tmp_path / "starts.csv"
    table.write_text("w\n1\n2\n")
    more = ["--ensemble", str(table)] if verb == "ensemble" else []
    done = start(tmp_path, "run", str(spec_path("chaplygin_sleigh")), "--points", "2", *more)
    assert done.returncode == 0, done.stderr
    assert "note: cannot write into the cache" in done.stderr and "; compiled for this run only\n" in done.stderr
    assert "Python" not in done.stderr
    assert list((tmp_path / "passing").iterdir()) == []


def test_a_folder_that_was_named_must_do(tmp_path: Path) -> None:
    done = start(tmp_path, "run", str(spec_path("chaplygin_sleigh")), "--points", "2", NHC_CACHE=str(tmp_path / "file"))
    assert done.returncode == 0
    assert "cannot write into the cache" in done.stderr and "running the emitted Python" in done.stderr


def test_where_nothing_can_be_run_is_no_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NHC_CACHE", str(tmp_path))
    assert build(UNIT, "one.c").exists()
    monkeypatch.setattr(compiling, "runs_from", lambda place: False)
    with pytest.raises(CacheError, match="mounted `noexec`"):
        build(UNIT, "one.c")


def test_without_any_place_the_first_reason_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(**_: str) -> str:
        raise OSError(28, "No space left on device")

    (tmp_path / "file").touch()
    monkeypatch.delenv("NHC_CACHE", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    monkeypatch.setattr("tempfile.mkdtemp", refuse)
    with pytest.raises(CacheError, match="cannot write into the cache"):
        build(UNIT, "one.c")
