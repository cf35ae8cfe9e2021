"""Files on disk: guarded, atomic, all or none."""

from __future__ import annotations

import errno
import os
from pathlib import Path

import pytest

from nhc.cli import main, write
from nhc.cli.terminal import Exit, Failure
from nhc.stamp import PLACEHOLDER, stamp


def _emitted(body: str) -> str:
    return stamp(f"# {PLACEHOLDER}\n{body}\n")


def test_several_files_go_into_a_folder_and_one_may_be_named(tmp_path: Path) -> None:
    two = {"a.h": "", "a.c": ""}
    assert set(write.place_files(two, None)) == {Path("a.h"), Path("a.c")}
    assert set(write.place_files(two, str(tmp_path / "new"))) == {tmp_path / "new/a.h", tmp_path / "new/a.c"}
    assert set(write.place_files({"a.py": ""}, str(tmp_path / "b.py"))) == {tmp_path / "b.py"}
    assert set(write.place_files({"a.py": ""}, str(tmp_path / "b"))) == {tmp_path / "b/a.py"}
    assert set(write.place_files(two, str(tmp_path / "a.c"))) == {tmp_path / "a.h", tmp_path / "a.c"}
    (tmp_path / "file").write_text("")
    with pytest.raises(Failure, match="names one file"):
        write.place_files(two, str(tmp_path / "file"))


def test_what_cannot_be_written_leaves_no_folder_behind(tmp_path: Path) -> None:
    (tmp_path / "old").mkdir()
    for folder in ("new/inner", "old"):
        with pytest.raises(Failure, match="file name too long"):
            write.write_files({tmp_path / folder / "a.h": "", tmp_path / folder / f"{'a' * 300}.c": ""})
    assert [*tmp_path.rglob("*")] == [tmp_path / "old"]


def test_a_file_that_cannot_be_written_is_named_as_the_user_named_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In a folder that takes no files, what cannot be made is the temporary file."""

    def refuse(path: Path, content: bytes) -> int:
        raise PermissionError(errno.EACCES, "Permission denied", str(path))

    monkeypatch.setattr(Path, "write_bytes", refuse)
    with pytest.raises(Failure) as failure:
        write.write_files({tmp_path / "a.h": "", tmp_path / "a.c": ""})
    assert failure.value.message == f"cannot write `{tmp_path / 'a.h'}`: permission denied"


def test_a_file_in_place_of_a_folder_is_named_as_the_user_named_it(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(Failure, match=r"cannot write `[^`]*/file/a\.csv`: "):
        write.write_bytes(tmp_path / "file/a.csv", b"")


@pytest.mark.parametrize(
    "arguments",
    [
        ["run", "pendulum", "-o", "PLACE/a.csv"],
        ["chart", "pendulum", "-o", "PLACE/a.svg"],
        ["chart", "pendulum", "-o", "PLACE/a"],
        ["reduce", "pendulum", "--scene", "small", "--tol", "1e-3", "-o", "PLACE/a.yaml"],
        ["compare", "pendulum", "--certificate", "PLACE/a.json"],
        ["stability", "pendulum", "-o", "PLACE/a.html"],
    ],
)
def test_a_place_that_takes_no_file_is_refused_before_the_work(
    arguments: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("nhc.pipeline.decode", lambda source: pytest.fail("the work is begun"))
    (tmp_path / "file").write_text("")
    assert main([word.replace("PLACE", str(tmp_path / "file")) for word in arguments]) == Exit.USAGE
    assert f"`{tmp_path / 'file'}` is no folder" in capsys.readouterr().err
    monkeypatch.setattr(os, "access", lambda *_: False)
    assert main([word.replace("PLACE", str(tmp_path / "new")) for word in arguments]) == Exit.USAGE
    assert "permission denied" in capsys.readouterr().err
    assert not (tmp_path / "new").exists()


def test_own_files_are_replaced_and_edited_ones_are_not(tmp_path: Path) -> None:
    path = tmp_path / "model.py"
    path.write_text(_emitted("old"))
    write.refuse_to_overwrite({path: _emitted("new")})
    path.write_text(_emitted("old") + "# mine\n")
    with pytest.raises(Failure, match="edited") as caught:
        write.refuse_to_overwrite({path: _emitted("new")})
    assert (caught.value.code, caught.value.exit) == ("E0501", Exit.FAILED)
    path.write_text("no mark at all")
    with pytest.raises(Failure, match="E0501"):
        write.refuse_to_overwrite({path: _emitted("new")})
    path.write_bytes(b"\xff\xfe no text at all")
    with pytest.raises(Failure, match="E0501"):
        write.refuse_to_overwrite({path: _emitted("new")})


def test_written_files_have_the_bytes_and_nothing_is_left_beside_them(tmp_path: Path) -> None:
    files = {tmp_path / "deep/a.c": "θ\n", tmp_path / "deep/a.h": "x"}
    write.write_files(files)
    assert {path.name: path.read_bytes() for path in (tmp_path / "deep").iterdir()} == {
        "a.c": "θ\n".encode(),
        "a.h": b"x",
    }


def test_unchanged_files_are_not_touched(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.c"
    path.write_text("same")
    os.utime(path, (1, 1))
    write.write_files({path: "same", tmp_path / "b.c": "new"})
    assert path.stat().st_mtime == 1
    assert capsys.readouterr().err == f"unchanged {path}\nwrote {tmp_path / 'b.c'}\n"


def test_mode_and_link_survive(tmp_path: Path) -> None:
    real, link = tmp_path / "real.c", tmp_path / "link.c"
    real.write_text("old")
    real.chmod(0o640)
    link.symlink_to(real)
    write.write_files({link: "new"})
    assert link.is_symlink()
    assert real.read_text() == "new"
    assert real.stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize("failing", [1, 2, 3])
def test_all_or_none_when_a_rename_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, failing: int) -> None:
    names = ["a", "b", "c"]
    (tmp_path / "a").write_text("old a")
    (tmp_path / "b").write_text("old b")
    replace, count = os.replace, 0

    def fail_once(source: Path, target: Path) -> None:
        nonlocal count
        count += 1
        if count == failing:
            raise PermissionError(13, "Permission denied", str(target))
        replace(source, target)

    monkeypatch.setattr(os, "replace", fail_once)
    with pytest.raises(Failure, match=r"cannot write .*permission denied"):
        write.write_files({tmp_path / name: f"new {name}" for name in names})
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {"a": "old a", "b": "old b"}


def test_compare_names_what_is_missing_or_differs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a").write_text("a")
    (tmp_path / "b").write_text("b")
    assert write.compare_files({tmp_path / "a": "a"}) == Exit.DONE
    assert write.compare_files({tmp_path / name: "a" for name in "abc"}) == Exit.FAILED
    assert capsys.readouterr().err == f"differs: {tmp_path / 'b'}\nmissing: {tmp_path / 'c'}\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b"]


@pytest.mark.parametrize(
    ("system", "says", "of_c"),
    [
        ("errno", "finds Python's own module", "hides C's own `<errno.h>`"),
        ("random", "hides Python's own module", ""),
        ("float", "", "hides C's own `<float.h>`"),
        ("sleigh", "", ""),
    ],
)
def test_names_of_the_languages_own_modules(
    system: str, says: str, of_c: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = tmp_path / "spec.yaml"
    spec.write_text(f"nhc: 1\nsystem: {system}\ncoordinates: [x]\nparameters: {{m: 1}}\nT: m/2*x'^2\n")
    for language, words in (("python", says), ("c", of_c)):
        assert main(["emit", str(spec), "--lang", language, "-o", str(tmp_path)]) == 0
        told = capsys.readouterr().err
        assert ("note:" in told and words in told) if words else "note:" not in told
    assert main(["emit", str(spec), "--lang", "python", "-o", str(tmp_path / "model.py")]) == 0
    assert "note:" not in capsys.readouterr().err


def test_a_pipe_is_written_to_and_neither_read_nor_replaced(tmp_path: Path) -> None:
    """`-o >(less)`; of a device such as `/dev/zero`, all that it gives was read, and `--force` put a file in its place."""
    pipe = tmp_path / "pipe.json"
    os.mkfifo(pipe)
    for wanted in (b"from text\n", b"from bytes"):
        reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
        try:
            if wanted.endswith(b"\n"):
                write.deliver(wanted.decode(), str(pipe), force=False)
            else:
                write.write_bytes(pipe, wanted)
            assert os.read(reader, 100) == wanted
        finally:
            os.close(reader)
        assert pipe.is_fifo() and os.listdir(tmp_path) == [pipe.name]
