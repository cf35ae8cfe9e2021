"""Terminal sessions as tests: commands with what they print, run in an empty folder.

    # a comment
    $ nhc check missing.yaml
    ! error: ...
    [exit 2]

A line ``$ ...`` is a command for bash; the lines after it are its stdout, those with ``! `` its stderr, and a last line
``[exit N]`` its exit code where that is not 0.  An expected line ``...`` stands for any number of lines.
"""

from __future__ import annotations

import os
import shlex
import subprocess
import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from tests.cli.serve import start

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Step:
    """``before``: lines that stand above the command and are no part of it."""

    before: tuple[str, ...]
    command: str
    expected: tuple[str, ...]


def parse(text: str) -> tuple[list[Step], tuple[str, ...]]:
    """Return the steps of a transcript and the lines after the last; a step ends at `$`, or at `#` after a blank."""
    steps: list[Step] = []
    before: list[str] = []
    lines = text.splitlines()
    at = 0
    while at < len(lines):
        if not lines[at].startswith("$ "):
            before.append(lines[at])
            at += 1
            continue
        command, at = lines[at][2:], at + 1
        expected: list[str] = []
        while at < len(lines) and not lines[at].startswith("$ "):
            if lines[at].startswith("# ") and expected and not expected[-1]:
                break
            expected.append(lines[at])
            at += 1
        tail: list[str] = []
        while expected and not expected[-1]:
            tail.append(expected.pop())
        steps.append(Step(tuple(before), command, tuple(expected)))
        before = tail
    return steps, tuple(before)


@cache
def _start(environment: tuple[tuple[str, str], ...]) -> str:
    return start(dict(environment))


def run(command: str, folder: Path, *, merged: bool = False) -> list[str]:
    """Run ``command`` with ``nhc`` on the path and return what it gave, in the form of a transcript.

    With ``merged`` stderr is not marked and stands where the terminal would show it.
    """
    keep = {name: value for name, value in os.environ.items() if name in ("HOME", "LD_LIBRARY_PATH", "CC")}
    keep["NHC_CACHE"] = str(Path(os.environ["NHC_CACHE"]).with_name("optimised"))  # not the user's
    environment = {**keep, "PYTHONPATH": str(ROOT), "PYTHONWARNINGS": "error", "LC_ALL": "C.UTF-8"}
    tools = folder.parent / f"{folder.name}-bin"
    if not tools.exists():
        tools.mkdir()
        (tools / "call.py").write_text(_start(tuple(environment.items())))
        shim = tools / "nhc"
        shim.write_text(
            f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -IS {shlex.quote(str(tools / "call.py"))} "$@"\n'
        )
        shim.chmod(0o755)
    environment["PATH"] = f"{tools}{os.pathsep}{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=folder,
        env=environment,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT if merged else subprocess.PIPE,
        timeout=300,
        check=False,
    )
    lines = done.stdout.decode().splitlines()
    lines += [f"! {line}".rstrip() for line in (done.stderr or b"").decode().splitlines()]
    return [*lines, *([f"[exit {done.returncode}]"] if done.returncode else [])]


def matches(expected: tuple[str, ...], actual: list[str]) -> bool:
    """Compare line by line; an expected ``...`` (or ``! ...``) stands for any number of lines, but for no exit code."""
    codes = [[line for line in lines if line.startswith("[exit ")] for lines in (expected, actual)]
    return codes[0] == codes[1] and _match(expected, actual)


def _match(expected: tuple[str, ...], actual: list[str]) -> bool:
    if not expected:
        return not actual
    head, rest = expected[0], expected[1:]
    if head in ("...", "! ..."):
        return any(_match(rest, actual[skip:]) for skip in range(len(actual) + 1))
    return bool(actual) and actual[0] == head and _match(rest, actual[1:])
