"""heyoka's Taylor method on nhc's own right-hand side, one start at a time or a vector of them."""

from __future__ import annotations

from dataclasses import replace
from importlib.util import find_spec
from typing import Any

from nhc.emit.statements import drop_unused
from nhc.program.ir import Guard
from nhc.simulate.prepare import Job
from nhc.study.chart.taylor import translate


def is_installed() -> bool:
    return find_spec("heyoka") is not None


class Taylor:
    """Compiled for one tolerance; ``lanes`` starts at a time, 0: heyoka's scalar integrator."""

    def __init__(self, job: Job, tolerance: float, lanes: int = 0) -> None:
        import heyoka as hy
        import numpy as np

        rhs = next(f for f in job.program.functions if f.name == "rhs")
        plain = tuple(statement for statement in rhs.body if not isinstance(statement, Guard))
        function = replace(rhs, body=drop_unused(plain))  # what only guards read, heyoka may not have
        variables = list(hy.make_vars(*(f"y{k}" for k in range(len(job.y)))))
        system = list(zip(variables, translate(function, hy, variables, list(job.p)), strict=True))
        self.time, self.lanes = job.time, lanes
        self.integrator: Any
        if lanes:
            state = np.repeat(np.array(job.y)[:, None], lanes, axis=1)
            self.integrator = hy.taylor_adaptive_batch(
                sys=system, state=state, time=np.full(lanes, job.time[0]), tol=tolerance
            )
        else:
            self.integrator = hy.taylor_adaptive(system, list(job.y), time=job.time[0], tol=tolerance)

    @staticmethod
    def count_lanes() -> int:
        """As many as heyoka recommends on this machine."""
        import heyoka as hy

        return int(hy.recommended_simd_size())

    def run(self, starts: Any) -> Any:
        """The end of each start, shape (starts, states); a multiple of the lanes."""
        import numpy as np

        ends = np.empty_like(starts)
        integrator, (begin, end) = self.integrator, self.time
        if not self.lanes:
            for i, start in enumerate(starts):
                integrator.time = begin
                integrator.state[:] = start
                integrator.propagate_until(end)
                ends[i] = integrator.state
            return ends
        for i in range(0, len(starts), self.lanes):
            integrator.set_time(begin)
            integrator.state[:] = starts[i : i + self.lanes].T
            integrator.propagate_until(end)
            ends[i : i + self.lanes] = integrator.state.T
        return ends
