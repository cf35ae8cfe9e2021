"""The reader and the parser under random texts: a Spec or diagnostics, and nothing else (``make fuzz`` runs many more)."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.fuzz.inputs import WORDS, gallery
from tests.fuzz.reader import Hang, Tally, time_limit, try_expression, try_input, try_spec
from tests.fuzz.run import run_inputs
from tests.fuzz.watch import Watch

SIZE = int(os.environ.get("NHC_TEST_SIZE", "1"))
UNHURRIED = settings(
    max_examples=300 * SIZE, derandomize=SIZE == 1, deadline=2000, suppress_health_check=list(HealthCheck)
)


def test_fuzzed_inputs_give_a_spec_or_diagnostics() -> None:
    tally = run_inputs(seed=7, first=0, count=4000 * SIZE)
    assert tally.failures == []
    assert tally.inputs == 4000 * SIZE
    assert min(tally.valid, tally.refused) > tally.inputs // 20
    assert tally.resolved > 0


@UNHURRIED
@given(st.text(max_size=200))
def test_any_text_is_an_expression_or_a_diagnostic(text: str) -> None:
    try_expression(text, equation=False)
    try_expression(text, equation=True)


@UNHURRIED
@given(st.lists(st.sampled_from(WORDS), max_size=30).map("".join))
def test_any_words_are_an_expression_or_a_diagnostic(text: str) -> None:
    try_expression(text, equation=True)


@UNHURRIED
@given(st.binary(max_size=300))
def test_any_bytes_are_a_spec_or_diagnostics(data: bytes) -> None:
    try_spec(data, deep=False)


@UNHURRIED
@given(st.sampled_from(gallery()), st.data())
def test_any_splice_of_the_gallery_is_a_spec_or_diagnostics(text: str, data: st.DataObject) -> None:
    start = data.draw(st.integers(0, len(text)))
    end = data.draw(st.integers(start, min(len(text), start + 80)))
    try_spec((text[:start] + data.draw(st.text(max_size=40)) + text[end:]).encode(), deep=False)


WATCHED = """
import os, sys, subprocess, socket
from tests.fuzz.watch import Watch
os.chdir(sys.argv[1])
watch = Watch()
with watch.watching():
    open("here").read() if os.path.exists("here") else None
    assert watch.seen == []
    {deed}
print(len(watch.seen))
"""
DEEDS = (
    "open('here', 'w').close()",
    "os.open('here', os.O_CREAT | os.O_WRONLY)",
    "eval('1 + 1')",
    "exec('x = 1')",
    "compile('1', 'a', 'eval')",
    "subprocess.run(['true'])",
    "os.system('true')",
    "socket.socket()",
    "os.mkdir('here')",
)


@pytest.mark.parametrize("deed", DEEDS)
def test_the_watch_sees(deed: str, tmp_path: Path, root: Path) -> None:
    """A watch that sees nothing would prove nothing."""
    command = [sys.executable, "-c", WATCHED.format(deed=deed), str(tmp_path)]
    done = subprocess.run(
        command, capture_output=True, text=True, cwd=root, env={**os.environ, "PYTHONPATH": str(root)}
    )
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) > 0


def test_a_hang_and_a_crash_are_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    watch, tally = Watch(), Tally()

    def fail(*_: object) -> None:
        raise RecursionError("deep")

    monkeypatch.setattr("tests.fuzz.reader.try_expression", fail)
    monkeypatch.setattr("tests.fuzz.reader.try_spec", fail)
    try_input(1, 0, tally, watch)
    assert len(tally.failures) == 1
    with pytest.raises(Hang), time_limit(1):
        while True:
            pass


@pytest.mark.parametrize("text", ["Ŀ", "xŀ + 1", "α\u0308", "ǰ", "ϕ", "ﬁ", "ſin(x)"])
def test_a_folded_name_reads_as_itself(text: str) -> None:
    """``Ŀ`` folds to ``L·``, which is no name; a mark may join the last letter of a Greek letter's name."""
    try_expression(text, equation=False)
