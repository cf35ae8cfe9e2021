"""Stdout and stderr that are closed, full or raw."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys

import pytest

from tests.support import needs_full


@pytest.mark.parametrize("where", [">&-", pytest.param("> /dev/full", marks=needs_full)])
def test_a_result_does_not_wait_for_room_for_messages(where: str) -> None:
    command = [sys.executable, "-m", "nhc", "run", "pendulum", "--python", "--points", "2", "--scene", "small"]
    for words, code, lines in ((command, 0, 3), ([*command, "--set", "no=1"], 2, 0)):
        text = f"{shlex.join(words)} 2{where}"
        done = subprocess.run(["sh", "-c", text], stdout=subprocess.PIPE, text=True, check=False, timeout=60)
        assert (done.returncode, len(done.stdout.splitlines())) == (code, lines)


@pytest.mark.parametrize("words", ["--help", "run -h", "--version", "explain E0301"])
def test_a_text_without_a_stdout_is_no_success(words: str) -> None:
    text = f"{shlex.join([sys.executable, '-m', 'nhc', *words.split()])} >&-"
    done = subprocess.run(["sh", "-c", text], stderr=subprocess.PIPE, text=True, check=False, timeout=60)
    assert (done.returncode, done.stderr.splitlines()[0]) == (2, "error: stdout is closed")


def test_a_long_text_is_never_cut_short_in_silence() -> None:
    """A raw stdout, as ``PYTHONUNBUFFERED`` makes it, takes a part of a text and drops the rest."""
    program = "from nhc.cli.terminal import put, set_up_streams; set_up_streams(); put('a' * 10**7)"
    environment = {**os.environ, "PYTHONUNBUFFERED": "1"}
    command = [sys.executable, "-c", program]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        assert process.stdout.read(1) == b"a"
        process.stdout.close()
        assert b"BrokenPipeError" in process.stderr.read()
