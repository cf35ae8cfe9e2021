"""A compiled run through ctypes; the loop is inside C, one call does it all."""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from nhc.simulate.task import ModelError, News, Outcome, Task

_Doubles = ctypes.POINTER(ctypes.c_double)
Numbers = Any
"""A sequence of floats, an array of C's doubles, or a writable contiguous NumPy array of doubles."""


class _Task(ctypes.Structure):
    _fields_ = (
        ("p", _Doubles),
        ("y", _Doubles),
        ("sizes", _Doubles),
        ("times", _Doubles),
        ("rows", ctypes.c_long),
        ("tolerance", ctypes.c_double),
        ("step", ctypes.c_double),
        ("most", ctypes.c_long),
        ("stops", _Doubles),
        ("stop_count", ctypes.c_long),
        ("ends", _Doubles),
    )


class _News(ctypes.Structure):
    _fields_ = (("t", ctypes.c_double), ("stop", ctypes.c_int), ("done", ctypes.c_long))


class CompiledNews(News):
    """The same values where C sees them."""

    def __init__(self) -> None:
        self.shared = _News()

    @property
    def t(self) -> float:
        return float(self.shared.t)

    @t.setter
    def t(self, value: float) -> None:
        self.shared.t = value

    @property
    def stop(self) -> bool:
        return bool(self.shared.stop)

    @stop.setter
    def stop(self, value: bool) -> None:
        self.shared.stop = int(value)

    @property
    def done(self) -> int:
        return int(self.shared.done)

    @done.setter
    def done(self, value: int) -> None:
        self.shared.done = value


class CompiledModel:
    """``<s>_run.so``: its methods, and the quantities of a run."""

    compiled = True

    def __init__(self, path: Path, system: str, states: int, needed: int) -> None:
        self.path, self.library = path, ctypes.CDLL(str(path))
        self.system, self.states, self.needed = system, states, needed

        class Found(ctypes.Structure):
            _fields_ = (
                ("outcome", ctypes.c_int),
                ("status", ctypes.c_int),
                ("rows", ctypes.c_long),
                ("steps", ctypes.c_long),
                ("rejected", ctypes.c_long),
                ("calls", ctypes.c_long),
                ("jacobians", ctypes.c_long),
                ("t", ctypes.c_double),
                ("y", ctypes.c_double * states),
                ("size", ctypes.c_double * states),
                ("h", ctypes.c_double),
            )

        self._Found = Found

    def news(self) -> CompiledNews:
        return CompiledNews()

    def integrate(self, task: Task, method: str, news: News) -> Outcome:
        """Run one method; the interpreter's lock is free meanwhile, so another thread may read ``news`` and ask to stop."""
        assert isinstance(news, CompiledNews)
        size, count = self.states, len(task.times)
        rows, found = (ctypes.c_double * (count * size))(), self._Found()
        given = self._task(task, task.y, task.p)
        ends = (ctypes.c_double * task.most)() if task.logged else None
        if ends is not None:
            given.ends = ctypes.cast(ends, _Doubles)
        function = getattr(self.library, f"{self.system}_{method}")
        function(ctypes.byref(given), rows, ctypes.byref(found), ctypes.byref(news.shared))
        outcome = self._outcome(found, rows[: found.rows * size])
        outcome.ends = ends[: outcome.steps] if ends is not None else []
        return outcome

    def integrate_each(
        self, task: Task, method: str, starts: Sequence[Sequence[float]], values: Sequence[Sequence[float]], news: News
    ) -> list[Outcome]:
        """The task from each of ``starts`` with its own parameters ``values``, by one call; fewer outcomes where it was stopped."""
        size, rows = self.states, len(task.times)
        many = self.integrate_many(
            task, method, [x for row in starts for x in row], [x for row in values for x in row], news
        )
        each = rows * size
        flat = many.rows
        return [
            self._outcome(found, flat[i * each : i * each + found.rows * size])
            for i, found in enumerate(many.found[: many.done])
        ]

    def integrate_many(self, task: Task, method: str, starts: Numbers, values: Numbers, news: News) -> Many:
        """The same with flat numbers (a C-contiguous NumPy array of doubles or a sequence); nothing is copied out of C's arrays."""
        assert isinstance(news, CompiledNews)
        rows, size = len(task.times), self.states
        state, constants = _doubles(starts), _doubles(values)
        count = len(state) // size if len(starts) else 0
        out, found = (ctypes.c_double * (count * rows * size))(), (self._Found * count)()
        given = self._task(task, state, constants)
        function = getattr(self.library, f"{self.system}_{method}_each")
        function.restype = ctypes.c_long
        width = ctypes.c_long(len(values) // count if count else 0)
        done = function(ctypes.byref(given), ctypes.c_long(count), width, out, found, ctypes.byref(news.shared))
        return Many(int(done), rows, size, out, found)

    def runner(self, task: Task, method: str) -> Runner:
        """A run that is made ready once and done again and again, from other starts where ``start`` is changed."""
        return Runner(self, task, method)

    def _task(self, task: Task, y: Numbers, p: Numbers) -> _Task:
        return _Task(
            ctypes.cast(_doubles(p), _Doubles),  # the pointer keeps its array alive
            ctypes.cast(_doubles(y), _Doubles),
            ctypes.cast(_doubles(task.sizes), _Doubles) if task.sizes else None,
            ctypes.cast(_doubles(task.times), _Doubles),
            len(task.times),
            task.tolerance,
            task.step,
            task.most,
            ctypes.cast(_doubles([x for stop in task.stops for x in stop]), _Doubles),
            len(task.stops),
        )

    def _outcome(self, found: Any, flat: list[float]) -> Outcome:
        return Outcome(
            found.outcome,
            found.status,
            found.t,
            list(found.y),
            found.h,
            found.steps,
            found.rejected,
            found.calls,
            found.jacobians,
            [flat[k : k + self.states] for k in range(0, len(flat), self.states)],
            list(found.size),
        )

    def quantities(
        self, times: Sequence[float], states: Sequence[Sequence[float]], p: Sequence[float]
    ) -> list[list[float]]:
        """The needed columns at each row.

        Raises:
            ModelError: they have no value there.
        """
        width = self.needed
        out = self._needed_rows(times, _doubles([x for state in states for x in state]), p)
        values = list(out[: len(times) * width])
        return [values[k : k + width] for k in range(0, len(values), width)]

    def quantities_array(self, times: Sequence[float], states: Any, p: Sequence[float]) -> Any:
        """The same as a NumPy array of shape (rows, columns), of states in one of shape (rows, NY)."""
        import numpy as np

        flat = np.array(states, dtype=float).reshape(-1)
        out = self._needed_rows(np.array(times, dtype=float), _doubles(flat), p)
        return np.array(out)[: len(times) * self.needed].reshape(len(times), -1)

    def _needed_rows(self, times: Numbers, flat: Any, p: Sequence[float]) -> Any:
        """C's array of all rows' columns."""
        failed, out = ctypes.c_long(0), (ctypes.c_double * max(len(times) * self.needed, 1))()
        function = getattr(self.library, f"{self.system}_needed_rows")
        status = function(ctypes.c_long(len(times)), _doubles(times), flat, _doubles(p), out, ctypes.byref(failed))
        if status:
            raise ModelError(failed.value, status)
        return out


class Many:
    """Runs from many starts as C left them: ``done`` of them ran, in order; ``out`` holds their rows, ``found`` their outcomes."""

    def __init__(self, done: int, rows: int, states: int, out: Any, found: Any) -> None:
        self.done, self.out, self.found, self._shape = done, out, found, (len(found), rows, states)

    @property
    def rows(self) -> list[float]:
        """All rows, flat; where a run failed, its last ones are zeros."""
        return list(self.out)

    def array(self) -> Any:
        """The rows as a NumPy array of shape (starts, times, states) over C's memory."""
        import numpy as np

        return np.ctypeslib.as_array(self.out).reshape(self._shape)

    @property
    def kinds(self) -> list[int]:
        """How each ended."""
        return [found.outcome for found in self.found]


class Runner:
    """One run, ready: ``start`` and ``end`` are arrays of C's doubles, of the state before and after ``run``, which returns how
    it ended.
    """

    def __init__(self, model: CompiledModel, task: Task, method: str) -> None:
        self.start = _doubles(task.y)
        self._given = model._task(task, self.start, task.p)
        self._rows = (ctypes.c_double * (len(task.times) * model.states))()
        self._found, self._news = model._Found(), _News()
        arguments = map(ctypes.byref, (self._given, self._rows, self._found, self._news))
        self.run: Callable[[], int] = partial(getattr(model.library, f"{model.system}_{method}"), *arguments)
        self.end = self._found.y


def _doubles(values: Numbers) -> ctypes.Array[ctypes.c_double]:
    """C's array of the values: an array of C's doubles itself, the memory of a NumPy array, or a copy."""
    if isinstance(values, ctypes.Array):
        return values
    if hasattr(values, "ctypes") and len(values):
        return (ctypes.c_double * len(values)).from_buffer(values)
    return (ctypes.c_double * max(len(values), 1))(*values)
