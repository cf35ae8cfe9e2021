"""Kept answers: the same question is derived once, and nothing but the same question finds its answer."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from nhc import answers, pipeline
from nhc.cli.entry import main
from nhc.emit import environment
from nhc.stamp import is_untouched

SPEC = "pendulum"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("NHC_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache" / "answers"


def _list(folder: Path) -> list[Path]:
    return sorted(folder.iterdir())


def _refuse(*_: object) -> None:
    raise AssertionError("derived again")


@pytest.mark.parametrize(
    "verb", [["emit", SPEC, "--lang", "c", "--stdout"], ["derive", SPEC], ["derive", SPEC, "--json"]]
)
def test_the_second_answer_is_the_first_and_is_not_derived(
    verb: list[str], folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    assert main(verb) == 0
    first = capsys.readouterr().out
    monkeypatch.setattr(pipeline, "emit", _refuse)
    monkeypatch.setattr(pipeline, "derive", _refuse)
    assert main(verb) == 0
    assert capsys.readouterr().out == first
    assert len(_list(folder)) == 1
    assert main([*verb, "--anew"]) == 70


def test_every_option_and_every_text_asks_for_itself(folder: Path, tmp_path: Path, root: Path) -> None:
    spec = tmp_path / "pendulum.yaml"
    text = (root / "specs" / f"{SPEC}.yaml").read_text()
    spec.write_text(text)
    emit = ["emit", str(spec), "--stdout", "--lang"]
    asked = [
        [*emit, "c"],
        [*emit, "python"],
        [*emit, "latex"],
        [*emit, "c", "--trig", "inline"],
        [*emit, "c", "--trig", "libm"],
        [*emit, "c", "--only", "rhs"],
        [*emit, "c", "--driver"],
        [*emit, "c", "-f", "multipliers"],
        [*emit, "python", "--array", "numpy"],
        ["derive", str(spec)],
        ["derive", str(spec), "--to", "latex"],
    ]
    for count, arguments in enumerate(asked, 1):
        assert main(arguments) == 0
        assert len(_list(folder)) == count, arguments
    for arguments in asked:
        assert main(arguments) == 0
    assert len(_list(folder)) == len(asked)
    spec.write_text(text + "# one line more\n")
    assert main(asked[0]) == 0
    assert len(_list(folder)) == len(asked) + 1


def test_a_base_that_changes_asks_anew(folder: Path, tmp_path: Path, root: Path) -> None:
    base, spec = tmp_path / "base.yaml", tmp_path / "long.yaml"
    base.write_text((root / "specs" / f"{SPEC}.yaml").read_text())
    spec.write_text("extends: base.yaml\nsystem: long\n")
    arguments = ["emit", str(spec), "--lang", "python", "-o", str(tmp_path / "out")]
    assert main(arguments) == 0
    before = (tmp_path / "out" / "long.py").read_text()
    base.write_text(base.read_text().replace("cos(theta)", "cos(2*theta)"))
    assert main(arguments) == 0
    assert (tmp_path / "out" / "long.py").read_text() != before
    assert len(_list(folder)) == 2


def test_errors_and_what_a_time_limit_decides_are_not_kept(folder: Path, tmp_path: Path) -> None:
    spec = tmp_path / "wrong.yaml"
    spec.write_text("nhc: 1\nsystem: wrong\n")
    assert main(["emit", str(spec), "--lang", "c", "--stdout"]) == 1
    assert main(["emit", SPEC, "--lang", "c", "--stdout", "--only", "nothing"]) == 2
    assert main(["derive", SPEC, "--simplify", "5"]) == 0
    assert main(["derive", SPEC, "--dump", "decode"]) == 0
    assert not folder.exists()


@pytest.mark.parametrize("damage", [b"", b"\xff\xfe", b"{}", b"0" * 64 + b'\n{"a": "b"}'])
def test_a_damaged_answer_is_derived_again(damage: bytes, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["emit", SPEC, "--lang", "python", "--stdout"]
    assert main(arguments) == 0
    text = capsys.readouterr().out
    (path,) = _list(folder)
    path.write_bytes(damage)
    assert main(arguments) == 0
    assert capsys.readouterr().out == text and is_untouched(text)
    assert path.read_bytes() != damage


def test_a_folder_that_cannot_be_written_costs_nothing_but_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("NHC_CACHE", str(tmp_path / "file"))
    assert main(["derive", SPEC]) == 0
    assert capsys.readouterr().out
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_another_nhc_asks_anew(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    templates = tmp_path / "templates"
    (templates / "c").mkdir(parents=True)
    edited = templates / "c" / "source.c"
    edited.write_text("one")
    monkeypatch.setattr(answers, "find_templates", lambda: templates)
    made: list[int] = []

    def make() -> answers.Answer:
        made.append(1)
        return {"a": "b"}

    def ask() -> int:
        assert answers.answer(("question",), make) == {"a": "b"}
        return len(made)

    assert (ask(), ask()) == (1, 1)
    edited.write_text("two!")
    assert (ask(), ask()) == (2, 2)
    os.utime(edited, (1, 1))
    assert ask() == 3
    monkeypatch.setattr(answers, "__version__", "99")
    assert ask() == 4


def test_old_answers_make_room(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(answers, "MOST", 8)

    def ask(number: int) -> None:
        answers.answer((str(number),), lambda: {"": str(number)})

    for number in range(8):
        ask(number)
    for age, path in enumerate(_list(folder)):
        os.utime(path, (age, age))
    kept = _list(folder)[3:]
    ask(8)
    assert len(_list(folder)) == 7
    assert set(kept) < set(_list(folder))


def test_a_huge_answer_is_not_kept(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(answers, "LARGEST", 40)
    assert answers.answer(("short",), lambda: {"": "x" * 9}) == {"": "x" * 9}
    assert answers.answer(("long",), lambda: {"": "x" * 99}) == {"": "x" * 99}
    assert len(_list(folder)) == 1


def test_names_are_no_part_of_their_neighbours(folder: Path) -> None:
    assert answers.answer(("ab", "c"), lambda: {"": "1"}) == {"": "1"}
    assert answers.answer(("a", "bc"), lambda: {"": "2"}) == {"": "2"}
    assert answers.answer(("\ud800",), lambda: {"": "lone half of a pair"}) == {"": "lone half of a pair"}


def test_what_is_left_of_a_kept_template_is_not_used(
    folder: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """At whatever length a crash has cut them, the templates are compiled again."""
    verb = ["emit", SPEC, "--lang", "python", "--stdout", "--anew"]
    environment.create_environment.cache_clear()
    assert main(verb) == 0
    first = capsys.readouterr().out
    kept = {path: path.read_bytes() for path in (folder.parent / "templates").iterdir()}
    assert kept
    for length in range(0, 160, 20):
        for path, content in kept.items():
            path.write_bytes(content[:length])
        environment.create_environment.cache_clear()
        assert main(verb) == 0, length
        assert capsys.readouterr().out == first
        assert {path: path.read_bytes() for path in kept} == kept
    environment.create_environment.cache_clear()


def test_a_user_without_a_home_has_answers_and_no_cache(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def nowhere() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.setattr(Path, "home", nowhere)
    for name in ("NHC_CACHE", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    environment.create_environment.cache_clear()
    assert main(["emit", SPEC, "--lang", "python", "--stdout"]) == 0
    assert main(["run", SPEC, "--points", "2"]) == 0
    assert "no place for a cache: the user has no home folder" in capsys.readouterr().err
    assert main(["doctor"]) == 0
    assert "the user has no home folder; `NHC_CACHE` may name a folder" in capsys.readouterr().out
    environment.create_environment.cache_clear()
