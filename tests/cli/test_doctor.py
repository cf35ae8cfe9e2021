"""What ``nhc doctor`` says of a whole and of a broken installation."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from nhc.cli import main
from nhc.cli.doctor import EXTRAS, REQUIRED
from nhc.simulate.c import compile as compiling
from tests.conftest import Compile


def test_this_installation_is_well(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["doctor", "--json"]) == 0
    tree = json.loads(capsys.readouterr().out)
    assert (tree["schema"], tree["ok"]) == ("nhc.doctor/1", True)
    needed = {row["name"]: row for row in tree["needed"]}
    assert set(needed) == {"python", *REQUIRED, "templates", "specs"}
    assert all(row["found"] and row["detail"] for row in needed.values())


def test_the_text_names_what_the_tree_names(capsys: pytest.CaptureFixture[str]) -> None:
    main(["doctor", "--json"])
    tree = json.loads(capsys.readouterr().out)
    assert main(["doctor"]) == 0
    text = capsys.readouterr().out
    assert all(row["name"] in text for row in tree["needed"] + tree["optional"])


def test_a_missing_package_says_what_needs_it(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(EXTRAS, "sim", {"no-such-package": "`nhc linearize`"})
    assert main(["doctor"]) == 0
    line = next(line for line in capsys.readouterr().out.splitlines() if "no-such-package" in line)
    assert line.split() == ["missing", "sim:", "no-such-package", "for", "`nhc", "linearize`"]


def test_a_missing_folder_is_said_and_fails(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail() -> Path:
        raise FileNotFoundError("the folder `templates` is not part of this installation")

    monkeypatch.setattr("nhc.resources.find_templates", fail)
    assert main(["doctor"]) == 1
    assert "missing  templates  the folder `templates`" in capsys.readouterr().out


def test_a_missing_tool_is_no_failure(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setenv("PATH", "")
    monkeypatch.setenv("CC", "no-such-compiler")
    assert main(["doctor"]) == 0
    assert "no `no-such-compiler` on the path" in capsys.readouterr().out


def test_a_compiler_that_compiles_nothing_is_missing(
    quick_models: Compile, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(compiling, "_compile", quick_models)
    monkeypatch.setenv("CC", "false")
    assert main(["doctor"]) == 0
    rows = [" ".join(line.split()) for line in capsys.readouterr().out.splitlines() if "missing" in line]
    assert "missing cc `/usr/bin/false --version` fails" in [row.replace("`/bin/", "`/usr/bin/") for row in rows]
    assert any(row.startswith("missing compiler of runs `false` does not compile") for row in rows)


def test_requirements_and_extras_are_those_of_the_package(root: Path) -> None:
    text = (root / "pyproject.toml").read_text()
    for name in (*REQUIRED, *(package for packages in EXTRAS.values() for package in packages)):
        assert f'"{name}>=' in text


def test_the_cache_and_the_compiler_of_runs_are_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("NHC_CACHE", str(tmp_path / "models"))
    assert main(["doctor"]) == 0
    assert f"{tmp_path / 'models'} (0 compiled models, 0 answers, 0.0 MB)" in capsys.readouterr().out
    entry = tmp_path / "models" / "0123"
    entry.mkdir(parents=True)
    (entry / "a_run.so").write_bytes(bytes(1_500_000))
    (entry / "a_run.c").write_bytes(bytes(100_000))
    (tmp_path / "models" / "answers").mkdir()
    (tmp_path / "models" / "answers" / "4567.json").write_bytes(bytes(100_000))
    assert main(["doctor", "--json"]) == 0
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)["optional"]}
    assert rows["cache"]["found"] and "(1 compiled models, 1 answers, 1.7 MB)" in rows["cache"]["detail"]
    monkeypatch.setenv("NHC_CACHE", str(entry / "a_run.so" / "below"))
    assert main(["doctor"]) == 0
    assert "cannot be written" in capsys.readouterr().out
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    assert main(["doctor", "--json"]) == 0
    rows = {row["name"]: row for row in json.loads(capsys.readouterr().out)["optional"]}
    assert not rows["compiler of runs"]["found"] and "runs are in Python" in rows["compiler of runs"]["detail"]
