"""One fuzzed input through the reader, the parser and what prints their diagnostics."""

from __future__ import annotations

import io
import random
import signal
import sys
import time
import traceback
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from types import FrameType, SimpleNamespace

import mpmath  # noqa: F401 - what an input may import for the first time must not look as if the input did it

import nhc.language.bodies.write_out  # noqa: F401 - few specs need it
from nhc.diagnostics import Bag, Source, Span, SpecError, render_concise, render_text, to_json
from nhc.language import decode, read
from nhc.language.expressions.parser import parse_equation, parse_expression
from nhc.language.expressions.syntax import same
from nhc.language.expressions.unparse import unparse
from nhc.mechanics.resolving.resolve import resolve
from tests.fuzz.inputs import draw_expression, draw_spec
from tests.fuzz.watch import Watch

SLOW = 2.0  # seconds of the processor for one input, so that a busy machine makes none slow
HANG = 20  # of these, after which it is interrupted
EXPRESSIONS = 0.4  # share of inputs that go to the expression parser alone
RESOLVED = 0.1  # share of valid specs that are resolved too


class Hang(Exception):
    """An input took too long."""


@dataclass
class Tally:
    """What was counted; ``failures`` hold the number of the input with what happened."""

    inputs: int = 0
    valid: int = 0
    refused: int = 0
    resolved: int = 0
    slowest: float = 0.0
    slowest_input: int = -1
    failures: list[str] = field(default_factory=list)

    def add(self, other: Tally) -> None:
        self.inputs += other.inputs
        self.valid += other.valid
        self.refused += other.refused
        self.resolved += other.resolved
        self.failures += other.failures
        if other.slowest > self.slowest:
            self.slowest, self.slowest_input = other.slowest, other.slowest_input


def rng_of(seed: int, index: int) -> random.Random:
    return random.Random(f"{seed}/{index}")


@contextmanager
def time_limit(seconds: int) -> Iterator[None]:
    def stop(number: int, frame: FrameType | None) -> None:
        raise Hang

    previous = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, previous)


def try_expression(text: str, equation: bool) -> bool:
    """Parse; a tree is written and parsed again, a mistake is rendered. Says whether it is valid."""
    source = Source("fuzz", text)
    bag = Bag(source)
    trees = parse_equation(text, Span, bag) if equation else parse_expression(text, Span, bag)
    show(source, bag)
    assert (trees is None) == bag.has_errors
    for tree in trees if isinstance(trees, tuple) else [trees]:
        if tree is not None:
            again = parse_expression(unparse(tree), Span, bag)
            assert again is not None and same(tree, again), "written and read again it is another tree"
    return trees is not None


def show(source: Source, bag: Bag) -> None:
    assert all(found.help for found in bag.diagnostics)
    render_text(source, bag.diagnostics, False)
    render_text(source, bag.diagnostics, True)
    render_concise(source, bag.diagnostics)
    to_json(source, bag.diagnostics)


def try_spec(data: bytes, deep: bool) -> tuple[bool, bool]:
    """Read (from standard input) and decode, resolve where ``deep``; whether it is valid, and whether it was resolved."""
    before, sys.stdin = sys.stdin, SimpleNamespace(buffer=io.BytesIO(data))  # type: ignore[assignment]
    try:
        spec = decode(read("-"))
        if deep:
            resolve(spec)
        return True, deep
    except SpecError as error:
        assert error.diagnostics
        assert all(found.help for found in error.diagnostics)
        for render in (render_text, render_concise, to_json):
            render(error.source, error.diagnostics, *([False] if render is render_text else []))
        return False, False
    finally:
        sys.stdin = before


def try_input(seed: int, index: int, tally: Tally, watch: Watch) -> None:
    """Draw the input of a number, run it and count it."""
    rng = rng_of(seed, index)
    is_expression = rng.random() < EXPRESSIONS
    drawn = draw_expression(rng) if is_expression else draw_spec(rng)
    deep, resolved = rng.random() < RESOLVED, False
    start = time.process_time()
    try:
        with time_limit(HANG), watch.watching():
            if isinstance(drawn, str):
                valid = try_expression(drawn, deep)
            else:
                valid, resolved = try_spec(drawn, deep)
        tally.valid += valid
        tally.refused += not valid
    except Hang:
        tally.failures.append(f"input {index}: no answer in {HANG} s: {drawn[:300]!r}")
    except Exception:
        tally.failures.append(f"input {index}: {traceback.format_exc(limit=-3)}\n{drawn[:2000]!r}")
    elapsed = time.process_time() - start
    tally.inputs += 1
    tally.resolved += resolved
    if elapsed > tally.slowest:
        tally.slowest, tally.slowest_input = elapsed, index
    if elapsed > SLOW:
        tally.failures.append(f"input {index}: {elapsed:.1f} s: {drawn[:300]!r}")
    if watch.seen:
        tally.failures.append(f"input {index}: {watch.seen}: {drawn[:300]!r}")
        watch.seen.clear()


def warm_up(watch: Watch) -> None:
    """Import what is imported late, so that nothing is left to do but reading."""
    scratch = Tally()
    for index in range(60):
        try_input(-1, index, scratch, watch)
