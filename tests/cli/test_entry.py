"""The table of verbs, and how exceptions become exit codes."""

from __future__ import annotations

import contextlib
import io
import os
import shlex
import signal
import subprocess
import sys
import time
from importlib import import_module
from pathlib import Path

import click
import pytest

from nhc import language
from nhc.cli import explain, main
from nhc.cli.entry import VERBS
from nhc.cli.options import FINEST_TOLERANCE, FORMULATIONS
from nhc.cli.terminal import Exit, Failure, put_text, wants_colour
from nhc.language.spec import LEAST_TOLERANCE
from nhc.pipeline import STAGES
from tests.support import INTERRUPTIBLE

ROOT = Path(__file__).resolve().parents[2]
MODULES = {path.stem for path in Path(explain.__file__).parent.glob("*.py")}
HELPERS = {
    "__init__",
    "compare_specs",
    "ensemble",
    "fitting",
    "simplify",
    "entry",
    "options",
    "progress",
    "reading",
    "specs",
    "terminal",
    "write",
}


def test_each_verb_has_its_module() -> None:
    assert set(VERBS) == MODULES - HELPERS


@pytest.mark.parametrize("verb", VERBS)
def test_the_table_says_what_the_verb_says(verb: str) -> None:
    command = import_module(f"nhc.cli.{verb}").command
    assert isinstance(command, click.Command)
    assert command.name == verb
    assert (command.help or "").splitlines()[0] == VERBS[verb]


def test_what_is_written_twice_is_that_of_the_language() -> None:
    assert FORMULATIONS == language.FORMULATIONS
    assert float(LEAST_TOLERANCE) == FINEST_TOLERANCE


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("option", ["-h", "--help"])
def test_each_verb_helps(verb: str, option: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([verb, option]) == Exit.DONE
    out, err = capsys.readouterr()
    assert out.startswith(f"Usage: nhc {verb}")
    assert err == ""


def _raise(monkeypatch: pytest.MonkeyPatch, error: BaseException) -> int:
    def fail(code: str) -> str:
        raise error

    monkeypatch.setattr("nhc.diagnostics.page", fail)
    return main(["explain", "E0101"])


def test_a_defect_is_one_line_and_70(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.delenv("NHC_DEBUG", raising=False)
    assert _raise(monkeypatch, KeyError("two\nlines")) == 70
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith("internal error: KeyError: 'two\\nlines'\n")
    assert "please report" in err
    assert "Traceback" not in err


def test_a_defect_shows_its_place_when_asked(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("NHC_DEBUG", "1")
    assert _raise(monkeypatch, KeyError("x")) == 70
    assert "Traceback" in capsys.readouterr().err


@pytest.mark.parametrize("verb", [("emit", "--lang", "c"), ("run",)])
def test_a_number_beyond_doubles_is_the_users(
    verb: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A model that cannot be printed is refused by every verb that prints one."""
    path = tmp_path / "big.yaml"
    path.write_text(
        "nhc: 1\nsystem: big\ncoordinates: [x]\nT: x'^2/2\noutputs: {big: 1e300*(1 + x)^2*1e10}\n"
        "scenes: {go: {time: [0, 1], need: [big]}}\n",
        encoding="utf-8",
    )
    assert main([verb[0], str(path), *verb[1:]]) == 2
    assert "error[E0504]: a number of the spec is too large for a double" in capsys.readouterr().err


@pytest.mark.parametrize(
    "arguments",
    [
        ["check", "NAME"],
        ["new", "NAME"],
        ["schema", "-o", "NAME"],
        ["run", "pendulum", "-o", "NAME.csv"],
        ["emit", "pendulum", "-l", "c", "-o", "NAME"],
    ],
)
def test_a_name_that_no_file_may_have_is_the_users(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main([word.replace("NAME", "a" * 300) for word in arguments]) == Exit.USAGE
    err = capsys.readouterr().err
    assert f"`{'a' * 300}" in err and "file name too long" in err and "  = help: name another" in err


@pytest.mark.parametrize(("module", "package"), [("yaml", "pyyaml"), ("sympy.core", "sympy"), ("scipy", "numpy scipy")])
def test_a_package_that_was_taken_away_is_named(
    module: str, package: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert _raise(monkeypatch, ModuleNotFoundError(f"No module named '{module}'", name=module)) == Exit.USAGE
    assert f"`python -m pip install {package}`" in capsys.readouterr().err


def test_deep_recursion_is_a_defect_not_a_crash(monkeypatch: pytest.MonkeyPatch) -> None:
    assert _raise(monkeypatch, RecursionError("too deep")) == 70


def test_failures_carry_their_code(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    assert _raise(monkeypatch, Failure("no", ["do this"], "E0501", Exit.FAILED)) == 1
    assert capsys.readouterr().err == "error[E0501]: no\n  = help: do this\n"


def test_a_spec_in_place_of_a_verb(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["kart.yaml"]) == 2
    assert "`nhc check kart.yaml`" in capsys.readouterr().err


def test_an_interrupt_is_130(monkeypatch: pytest.MonkeyPatch) -> None:
    assert _raise(monkeypatch, KeyboardInterrupt()) == 130


STARTS = {
    "new": "sled -o {folder}",
    "check": "pendulum --explain",
    "derive": "pendulum",
    "emit": "pendulum --lang c -o {folder}",
    "run": "pendulum -o {folder}/pendulum.csv",
    "chart": "pendulum --methods rk4,dopri5 --tolerances 1e-3 --langs c --no-peers",
    "linearize": "pendulum --about theta=0",
    "stability": "point_mass",
    "reduce": "pendulum",
    "compare": "pendulum",
    "gallery": "",
    "explain": "E0302",
    "cite": "pendulum",
    "schema": "",
    "doctor": "",
}


@pytest.mark.sample(2)
@pytest.mark.parametrize("verb", sorted(VERBS))
def test_each_verb_starts_in_a_process_of_its_own(verb: str, tmp_path: Path) -> None:
    """Transcripts run in one that has imported everything already, in an order of its own."""
    words = STARTS[verb].format(folder=tmp_path).split()
    command = [sys.executable, "-m", "nhc", verb, *words]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr
    assert done.stdout or list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("module", "sent", "before", "code"),
    [
        ("click", "SIGINT", "default_int_handler", 130),
        ("nhc.cli.check", "SIGINT", "default_int_handler", 130),
        ("click", "SIGTERM", "SIG_DFL", 143),
        ("nhc.pipeline", "SIGHUP", "SIG_DFL", 129),
        ("nhc.pipeline", "SIGHUP", "SIG_IGN", 0),  # as nohup has it
    ],
)
def test_an_interrupt_while_modules_are_imported_leaves_no_traceback(
    module: str, sent: str, before: str, code: int
) -> None:
    """The signal comes just when ``module`` is looked for; SIGTERM and SIGHUP clean up as Ctrl-C does."""
    program = (
        "import os, signal, sys\n"
        "from nhc.cli import main\n"
        "class Finder:\n"
        "    def find_spec(self, name, path=None, target=None):\n"
        f"        if name == {module!r}:\n"
        f"            os.kill(os.getpid(), signal.{sent})\n"
        f"signal.signal(signal.{sent}, signal.{before})\n"
        "sys.meta_path.insert(0, Finder())\n"
        "sys.exit(main(['check', 'pendulum']))\n"
    )
    done = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == code and "Traceback" not in done.stderr, done.stderr


def test_an_interrupt_from_outside_is_130() -> None:
    command = [*INTERRUPTIBLE, "check", "-"]
    # seconds until it waits for stdin; a signal before that ends the interpreter itself
    for patience in (0.5, 2, 8, 20):
        with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as child:
            time.sleep(patience)
            child.send_signal(signal.SIGINT)
            _, said = child.communicate(timeout=60)
        if child.returncode != -signal.SIGINT and b"Traceback" not in said:
            break
    assert child.returncode == 130
    assert b"Traceback" not in said and said.endswith(b"interrupted\n")


@pytest.mark.parametrize("arguments", [["explain"], ["gallery", "chaplygin_sleigh"], ["--help"]], ids=" ".join)
def test_a_closed_pipe_is_silent(arguments: list[str]) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    try:
        command = [sys.executable, "-m", "nhc", *arguments]
        done = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, text=True, check=False, timeout=60)
    finally:
        os.close(writer)
    assert (done.returncode, done.stderr) == (141, "")


class Terminal(io.StringIO):
    """A stream that calls itself a terminal."""

    def isatty(self) -> bool:
        return True


def test_colour_is_for_terminals_that_want_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setenv("TERM", "xterm")
    assert wants_colour(Terminal())
    assert not wants_colour(io.StringIO())
    monkeypatch.setenv("TERM", "dumb")
    assert not wants_colour(Terminal())
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setenv("NO_COLOR", "1")
    assert not wants_colour(Terminal())
    monkeypatch.setenv("NO_COLOR", "")  # set but empty counts as not set
    assert wants_colour(Terminal())


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_scripts_are_printed(shell: str) -> None:
    environment = {**os.environ, "_NHC_COMPLETE": f"{shell}_source"}
    done = subprocess.run(
        [sys.executable, "-m", "nhc"], env=environment, capture_output=True, text=True, check=False, timeout=60
    )
    assert done.returncode == 0
    assert "_NHC_COMPLETE" in done.stdout


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        ("nhc ch", "plain,check"),
        ("nhc emit --la", "plain,--lang"),
        ("nhc derive chaplygin_s", "plain,chaplygin_sleigh"),
    ],
)
def test_words_are_completed(typed: str, offered: str) -> None:
    count = len(typed.split()) - 1
    environment = {**os.environ, "_NHC_COMPLETE": "bash_complete", "COMP_WORDS": typed, "COMP_CWORD": str(count)}
    done = subprocess.run(
        [sys.executable, "-m", "nhc"], env=environment, capture_output=True, text=True, check=False, timeout=60
    )
    assert offered in done.stdout.splitlines(), done.stderr


@pytest.mark.parametrize(("no_color", "coloured"), [("", True), ("1", False)])
def test_a_terminal_gets_colour_unless_it_does_not_want_it(tmp_path: Path, no_color: str, coloured: bool) -> None:
    (tmp_path / "bad.yaml").write_text("nhc: 1\nsystem: bad\ncoordinates: [x]\nT: y\n")
    ours, theirs = os.openpty()
    environment = {**os.environ, "TERM": "xterm", "NO_COLOR": no_color}
    command = [sys.executable, "-m", "nhc", "check", str(tmp_path / "bad.yaml")]
    with subprocess.Popen(command, stdout=theirs, stderr=theirs, env=environment) as child:
        os.close(theirs)
        shown = b""
        with contextlib.suppress(OSError):  # EIO ends a terminal that nobody writes to any more
            while part := os.read(ours, 4096):
                shown += part
    os.close(ours)
    assert child.returncode == 1
    assert b"error[E" in shown.replace(b"\x1b[1;31m", b"")
    assert (b"\x1b[" in shown) is coloured


def command_of(verb: str) -> click.Command:
    command = import_module(f"nhc.cli.{verb}").command
    assert isinstance(command, click.Command)
    return command


@pytest.mark.parametrize("verb", VERBS)
def test_examples_of_a_help_text_are_taken_by_its_verb(verb: str) -> None:
    command = command_of(verb)
    examples = [line.strip() for line in (command.epilog or "").splitlines() if line.startswith("  ")]
    assert examples
    for example in examples:
        name, first, *arguments = shlex.split(example)
        assert (name, first) == ("nhc", verb)
        command.make_context(verb, arguments)  # refuses what the verb does not take


@pytest.mark.parametrize("verb", VERBS)
def test_help_fits_a_terminal(verb: str, capsys: pytest.CaptureFixture[str]) -> None:
    main([verb, "-h"])
    text = capsys.readouterr().out.partition("Examples:")[0]  # commands are not broken
    assert [line for line in text.splitlines() if len(line) > 80] == []


def test_help_of_dump_lists_the_stages() -> None:
    (dump,) = [parameter for parameter in command_of("derive").params if parameter.name == "dump"]
    assert isinstance(dump, click.Option)
    *most, last = [stage.name for stage in STAGES]
    assert f"{', '.join(most)} or {last}" in (dump.help or "")


def test_a_terminal_breaks_long_lines_between_words(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    line = "  energy: " + "words of a fact, " * 12 + "l1*l2*sin(a - b)"
    put_text(line, 4)
    assert capsys.readouterr().out == f"{line}\n"
    monkeypatch.setenv("COLUMNS", "60")
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True, raising=False)
    put_text(line, 4)
    first, *rest = capsys.readouterr().out.splitlines()
    assert first.startswith("  energy: words") and rest and all(part.startswith("    ") for part in rest)
    assert all(len(part) <= 60 for part in (first, *rest))
    assert " ".join(part.strip() for part in (first, *rest)) == line.strip()
