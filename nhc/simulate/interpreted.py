"""The same run without a compiler: the emitted Python model under methods in Python.  Slow; also the oracle for the C."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.abc import InspectLoader
from importlib.util import module_from_spec, spec_from_loader
from types import ModuleType
from typing import Any

from nhc.emit import EmitOptions, render
from nhc.program.ir import Program
from nhc.program.runs.hold import SINGULAR_HOLD
from nhc.simulate.methods import RUNGE_KUTTA
from nhc.simulate.stepping.loop import integrate
from nhc.simulate.task import ModelError, News, Outcome, Task


class _Text(InspectLoader):
    """A module whose source is a text that nhc has emitted."""

    def __init__(self, text: str) -> None:
        self.text = text

    def get_source(self, fullname: str) -> str:
        return self.text

    def is_package(self, fullname: str) -> bool:
        return False


def load_text(text: str, name: str) -> ModuleType:
    """The module of an emitted text; it is not entered into ``sys.modules``."""
    loader = _Text(text)
    spec = spec_from_loader(f"emitted_{name}", loader)
    assert spec is not None
    module = module_from_spec(spec)
    loader.exec_module(module)
    return module


class TextModel:
    """A program's emitted Python, as a module; a singular point raises an ArithmeticError with its ``status``."""

    compiled = False

    def __init__(self, program: Program) -> None:
        names = tuple(function.name for function in program.functions)
        (text,) = render(program, "python", EmitOptions(only=names)).values()
        self.module: Any = load_text(text, program.system)

    def news(self) -> News:
        return News()

    def quantities(
        self, times: Sequence[float], states: Sequence[Sequence[float]], p: Sequence[float]
    ) -> list[list[float]]:
        """The needed columns at each row.

        Raises:
            ModelError: they have no value there.
        """
        rows: list[list[float]] = []
        for row, (t, y) in enumerate(zip(times, states, strict=True)):
            try:
                rows.append(self.module.needed(t, y, p))
            except ArithmeticError as error:
                raise ModelError(row, getattr(error, "status", 0)) from error
        return rows


class InterpretedModel(TextModel):
    """The Python counterpart of ``CompiledModel``."""

    def __init__(
        self,
        program: Program,
        events: int,
        holds: Sequence[Sequence[str]] = (),
        dips: int | None = None,
        frames: tuple[int, int] = (0, 0),
    ) -> None:
        super().__init__(program)
        self.events, self.holds = events, tuple(holds)
        self.dips = sys.maxsize if dips is None else dips
        self.frames = frames
        names = {function.name for function in program.functions}
        self.watched = "watch" in names
        self.beating = "beats" in names
        self.parts = program.driving.leaps.parts if program.driving.leaps is not None and "places" in names else ()

    # --- the model as the methods see it

    def rhs(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]:
        values: list[float] = self.module.rhs(t, y, p)
        return values

    def jacobian(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[list[float]]:
        values: list[list[float]] = self.module.jacobian(t, y, p)
        return values

    def watch(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]:
        values: list[float] = self.module.watch(t, y, p) if self.watched else []
        return values

    def places(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]:
        values: list[float] = self.module.places(t, y, p)
        return values

    def beats(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]:
        values: list[float] = self.module.beats(t, y, p) if self.beating else []
        return values

    def hold(self, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]:
        """A state, brought back to the constraints."""
        state = list(y)
        for names in self.holds:
            state = self._held(names, t, state, p)
        return state

    def _held(self, names: Sequence[str], t: float, state: list[float], p: Sequence[float]) -> list[float]:
        """By the first of the functions that is not singular there."""
        for name in names:
            try:
                found: list[float] = getattr(self.module, name)(t, state, p)
            except ArithmeticError as error:
                if name == names[-1] or getattr(error, "status", 0) != SINGULAR_HOLD:
                    raise
            else:
                return found
        return state

    def integrate(self, task: Task, method: str, news: News) -> Outcome:
        """Run one method."""
        return integrate(self, RUNGE_KUTTA[method], task, news)
