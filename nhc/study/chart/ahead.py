"""Everything that a chart compiles, side by side, before anything is timed."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from functools import partial
from pathlib import Path

from nhc.simulate.c.compile import CompileError
from nhc.simulate.prepare import Job
from nhc.study.chart.model import compile_chart, compile_long, compile_natural
from nhc.study.chart.reference import METHODS as REFERENCE_METHODS
from nhc.study.chart.structure import choose_schemes

Show = Callable[[float, str], None]
AHEAD = 0.5  # of the time of a chart: what compiling takes, about


def compile_ahead(
    full: Job,
    jobs: Sequence[Job],
    methods: Sequence[str],
    natural: Job | None,
    schemes: Sequence[str],
    show: Show | None = None,
) -> None:
    """Fill the cache by as many compilers as there are processors; what does not compile is met again where it is needed.

    ``full``: the reference's job; ``jobs`` with ``methods``, ``natural`` with those of ``schemes`` that apply: what is charted.
    ``show`` is told which part of the whole chart is done, of which compiling is ``AHEAD``.
    """
    work: list[Callable[[], Path]] = [partial(compile_long, full, REFERENCE_METHODS)]
    work += [partial(compile_chart, job, method) for job in jobs for method in methods]
    if natural is not None:
        work += [partial(compile_natural, natural, scheme) for scheme in choose_schemes(natural, schemes)[0]]

    def make(one: Callable[[], Path]) -> None:
        with suppress(CompileError):
            one()

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for count, _ in enumerate(pool.map(make, work), 1):
            if show is not None:
                show(AHEAD * count / len(work), f"{count} of {len(work)} models compiled")
