"""``make fuzz``: many inputs for the reader and the parser, and random specs through emission.

    python -m tests.fuzz.run --inputs 200000 --specs 300 --jobs 2 --seed 1

Input k of seed s is always the same; ``--first k --inputs 1`` runs it alone.  Exit code 1 where anything was found.
"""

from __future__ import annotations

import argparse
import os
import random
import sys
import tempfile
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from pathlib import Path

from nhc.pipeline import Options, derive
from tests.fuzz.emission import run_batch
from tests.fuzz.reader import SLOW, Tally, try_input, warm_up
from tests.fuzz.watch import Watch
from tests.generate import write_spec
from tests.metamorphic.models import source_of

CHUNK = 5000  # inputs that one task runs
BATCH = 25  # models in one shared library


@cache
def the_watch() -> Watch:
    """The one watch of this process: an audit hook cannot be taken off again."""
    return Watch()


def run_inputs(seed: int, first: int, count: int) -> Tally:
    """Inputs ``first`` to ``first + count`` in an empty folder, watched."""
    tally, here = Tally(), os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            watch = the_watch()
            warm_up(watch)
            for index in range(first, first + count):
                try_input(seed, index, tally, watch)
            left = sorted(os.listdir(folder))
        finally:
            os.chdir(here)
    if left:
        tally.failures.append(f"inputs {first} to {first + count}: files were written: {left}")
    return tally


def run_specs(seeds: Sequence[int]) -> tuple[float, float, list[str]]:
    """Random specs through emission and derivation; the largest differences, and what failed."""
    try:
        with tempfile.TemporaryDirectory() as folder:
            between, back_ends = run_batch(seeds, Path(folder))
        for seed in seeds:
            source = source_of(write_spec(random.Random(seed), f"random_{seed}"))
            for to in ("text", "latex"):
                assert derive(source, Options(to=to)).strip()
        return between, back_ends, []
    except Exception as error:
        return 0.0, 0.0, [f"specs {seeds[0]} to {seeds[-1]}: {type(error).__name__}: {error}"]


def fuzz_reader(seed: int, first: int, inputs: int, jobs: int) -> Tally:
    start, total = time.perf_counter(), Tally()
    ends = range(first, first + inputs, CHUNK)
    with ProcessPoolExecutor(jobs) as pool:
        tasks = [pool.submit(run_inputs, seed, k, min(CHUNK, first + inputs - k)) for k in ends]
        for task in tasks:
            total.add(task.result())
    print(
        f"reader: {total.inputs} inputs in {time.perf_counter() - start:.0f} s: {total.valid} valid ({total.resolved} of "
        f"them resolved), {total.refused} refused with diagnostics, slowest {total.slowest:.2f} s "
        f"(input {total.slowest_input}, bound {SLOW:g} s), {len(total.failures)} failures",
        flush=True,
    )
    return total


def fuzz_emission(seed: int, count: int, jobs: int) -> list[str]:
    start, failures, between, back_ends = time.perf_counter(), list[str](), 0.0, 0.0
    seeds = range(seed * 1_000_000, seed * 1_000_000 + count)
    with ProcessPoolExecutor(jobs) as pool:
        for one, other, failed in pool.map(run_specs, [seeds[k : k + BATCH] for k in range(0, count, BATCH)]):
            between, back_ends = max(between, one), max(back_ends, other)
            failures += failed
    print(
        f"emission: {count} random specs in {time.perf_counter() - start:.0f} s: formulations agree to {between:.1e}, "
        f"C and Python to {back_ends:.1e} (relative), {len(failures)} batches failed"
    )
    return failures


def main() -> int:
    """Run both; print a line each, then what was found."""
    parser = argparse.ArgumentParser(description="fuzz the reader, the parser and the emission")
    parser.add_argument("--inputs", type=int, default=200_000)
    parser.add_argument("--specs", type=int, default=300)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    given = parser.parse_args()
    failures = fuzz_reader(given.seed, given.first, given.inputs, given.jobs).failures if given.inputs else []
    if given.specs:
        failures = failures + fuzz_emission(given.seed, given.specs, given.jobs)
    for text in failures[:20]:
        print(text, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
