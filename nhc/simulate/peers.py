"""Solvers from elsewhere over the emitted Python: peers to compare with, and multistep methods.

They need the extras ``sim`` (SciPy: P. Virtanen et al., Nature Methods 17 (2020) 261-272) and ``sundials`` (CVODE:
A. C. Hindmarsh et al., ACM Trans. Math. Softw. 31 (2005) 363-396).  They know nothing of nhc's alarms, but for SciPy's at
determinants that change their sign, and bring no state back to the constraints.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from nhc.simulate.interpreted import InterpretedModel
from nhc.simulate.stepping.watching import watch_start
from nhc.simulate.task import CROSSED, DONE, EVENT, SINGULAR, STOPPED, UNDERFLOW, News, Outcome, Task

SCIPY = {
    "scipy-dop853": "DOP853",
    "scipy-rk45": "RK45",
    "scipy-radau": "Radau",
    "scipy-bdf": "BDF",
    "scipy-lsoda": "LSODA",
}
SUNDIALS = {"cvode-adams": "Adams", "cvode-bdf": "BDF"}
PEERS = (*SCIPY, *SUNDIALS)
WITH_JACOBIAN = ("scipy-radau", "scipy-bdf", "scipy-lsoda", "cvode-bdf")


_SCOUTED, _SCOUTING = 1e-4, 500  # tolerance and steps of the run that tells how large entries become
_ROUNDING = 1e-13  # of the largest entry
_A_LITTLE = 1e-6  # of the run, after which an event that begins at zero has a sign


class _Stopped(Exception):
    """The one who waits asked to stop."""


class PeerModel(InterpretedModel):
    """The emitted Python under a solver from elsewhere, with that solver's own step control and interpolation."""

    def integrate(self, task: Task, method: str, news: News) -> Outcome:
        """Run it; the absolute tolerance of an entry of the state is the relative one times its size along a coarse run.

        Raises:
            ModuleNotFoundError: the library is not installed.
        """
        reached = [task.times[0], list(task.y)]

        def rhs(t: float, y: Any) -> list[float]:
            if news.stop:
                raise _Stopped
            values = self.rhs(t, y, task.p)
            news.t = float(t)
            reached[:] = [news.t, [float(x) for x in y]]
            return values

        absolute = [task.tolerance * size for size in self._find_sizes(task)]
        run = self._scipy if method in SCIPY else self._cvode
        try:
            return run(task, method, rhs, absolute)
        except _Stopped:
            return _leave(STOPPED, 0, reached, task)
        except ArithmeticError as error:
            return _leave(SINGULAR, getattr(error, "status", 0), reached, task)

    def _find_sizes(self, task: Task) -> list[float]:
        """The largest magnitudes of the entries in a run of some hundred steps, as long as it goes; these solvers find none by
        themselves, and an angle beside a far position has none in common with it.  What rounding may have made is held to a
        millionth of the largest entry.
        """
        scout = replace(task, times=(task.times[0], task.times[-1]), tolerance=_SCOUTED, step=0.0, most=_SCOUTING)
        sizes = super().integrate(scout, "dopri5", News()).sizes
        largest = max(sizes, default=0.0)
        return [size if size > _ROUNDING * largest else 1e-6 * (largest or 1.0) for size in sizes]

    def _scipy(self, task: Task, method: str, rhs: Callable[..., Any], absolute: list[float]) -> Outcome:
        from scipy.integrate import solve_ivp

        start = watch_start(self, task.times[0], task.y, task.p, self.events)
        left = self._leave_zero(task, rhs) if 0.0 in start[: self.events] else start

        def watch(place: int) -> Callable[..., float]:
            def value(t: float, y: Any) -> float:
                if t == task.times[0] and start[place] == 0.0 and place < self.events:
                    return left[place]  # a zero at the start is no event, where SciPy sees one
                return self.watch(t, y, task.p)[place]

            value.terminal = True  # type: ignore[attr-defined]
            return value

        def slopes(t: float, y: Any) -> list[list[float]]:
            return self.jacobian(t, y, task.p)

        found = solve_ivp(
            rhs,
            (task.times[0], task.times[-1]),
            list(task.y),
            method=SCIPY[method],
            t_eval=list(task.times),
            rtol=max(task.tolerance, 2.3e-14),
            atol=absolute,
            events=[watch(place) for place in range(min(self.dips, len(self.watch(task.times[0], task.y, task.p))))],
            **({"jac": slopes} if method in WITH_JACOBIAN else {}),
        )
        states = [[float(x) for x in row] for row in found.y.T]
        kind = {0: DONE, 1: EVENT}.get(int(found.status), UNDERFLOW)
        which = 0
        t, y = (float(found.t[-1]), states[-1]) if states else (task.times[0], list(task.y))
        if kind == EVENT:
            which = next(k for k, times in enumerate(found.t_events) if len(times))
            t, y = float(found.t_events[which][0]), [float(x) for x in found.y_events[which][0]]
            kind = EVENT if which < self.events else CROSSED
        return Outcome(kind, which, t, y, 0.0, len(states), 0, int(found.nfev), int(found.njev), states)

    def _leave_zero(self, task: Task, rhs: Callable[..., Any]) -> list[float]:
        """The watched values a little after the start."""
        t, h = task.times[0], _A_LITTLE * (task.times[-1] - task.times[0])
        return self.watch(t + h, [y + h * f for y, f in zip(task.y, rhs(t, task.y), strict=True)], task.p)

    def _cvode(self, task: Task, method: str, rhs: Callable[..., Any], absolute: list[float]) -> Outcome:
        from sksundae.cvode import CVODE

        def fill(t: float, y: Any, slope: Any) -> None:
            slope[:] = rhs(t, y)

        def slopes(t: float, y: Any, slope: Any, jacobian: Any) -> None:
            jacobian[:, :] = self.jacobian(t, y, task.p)

        times = list(task.times)
        if len(times) == 2:  # two times mean "every step" to it
            times.insert(1, 0.5 * (times[0] + times[1]))
        options = {"method": SUNDIALS[method], "rtol": task.tolerance, "atol": absolute, "max_num_steps": 1_000_000}
        solver = CVODE(fill, **({"jacfn": slopes} if method in WITH_JACOBIAN else {}), **options)
        found = solver.solve(times, list(task.y))
        states = [[float(x) for x in row] for row in found.y]
        if len(task.times) == 2 and len(states) == 3:
            del states[1]
        kind = DONE if found.success else UNDERFLOW
        return Outcome(
            kind, 0, float(found.t[-1]), states[-1], 0.0, len(states), 0, int(found.nfev), int(found.njev), states
        )


def _leave(kind: int, status: int, reached: list[Any], task: Task) -> Outcome:
    """SciPy gives nothing back of what it had: the start, and where it was."""
    return Outcome(kind, status, reached[0], reached[1], 0.0, states=[list(task.y)])
