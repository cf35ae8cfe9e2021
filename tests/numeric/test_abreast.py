"""Models measured by several processes at once: what comes out is what one process finds, and a request to end ends them all."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from nhc.study.simplify.abreast import measure_abreast
from tests.support import spec_path

MEASURED = """
import os, sys
from nhc.study.simplify import abreast
abreast._processors = lambda: 2
words = [str(k) for k in range(20)]
found = list(abreast.measure_abreast(lambda text: (int(text) ** 2, os.getpid()), words))
assert [square for square, _ in found] == [k * k for k in range(20)]
assert os.getpid() not in {pid for _, pid in found}
"""
LADDER = """
import sys
from nhc.language import read
from nhc.study.simplify import abreast
from nhc.study.simplify.search import simplify
abreast._processors = lambda: int(sys.argv[1])
ladder = simplify(read(sys.argv[2]), "small", 1e-3)
print([(rung.dropped, rung.errors, rung.size) for rung in ladder.rungs], ladder.kept, ladder.runs)
"""
ENDED = """
import os, signal, sys, time
signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored where the tests run in the background
from nhc.cli import _heard
from nhc.study.simplify import abreast
abreast._processors = lambda: 2
def wait(text):
    os.write(1, b"%d\\n" % os.getpid())
    time.sleep(60)
try:
    with _heard(lambda number: None):
        list(abreast.measure_abreast(wait, ["a", "b"]))
except KeyboardInterrupt:
    print("ended")
"""

linux = pytest.mark.skipif(sys.platform != "linux", reason="elsewhere one process measures all")


def run(*arguments: str) -> str:
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", *arguments], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


def test_one_after_another_where_other_threads_are_at_work() -> None:
    assert list(measure_abreast(str.upper, ["a", "b"])) == ["A", "B"]


@linux
def test_results_come_in_the_order_of_the_texts_from_other_processes() -> None:
    run(MEASURED)


@linux
def test_two_processes_find_what_one_does() -> None:
    one, two = (run(LADDER, count, str(spec_path("pendulum"))) for count in "12")
    assert one == two and len(one) > 200


@linux
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_request_to_end_is_heard_by_all_without_a_word(number: signal.Signals) -> None:
    """Ctrl-C reaches the whole group of processes, another signal only the one that waits."""
    with subprocess.Popen(
        [sys.executable, "-c", ENDED], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    ) as started:
        assert started.stdout is not None and started.stderr is not None
        children = [int(started.stdout.readline()) for _ in "ab"]
        (os.killpg if number == signal.SIGINT else os.kill)(started.pid, number)
        assert (started.stdout.read(), started.stderr.read(), started.wait()) == ("ended\n", "", 0)
    end = time.monotonic() + 10
    while any(Path(f"/proc/{child}").exists() for child in children) and time.monotonic() < end:
        time.sleep(0.01)
    assert not any(Path(f"/proc/{child}").exists() for child in children)
