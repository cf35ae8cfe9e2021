"""Spec texts to callable models, and random states that the constraints admit."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from types import ModuleType

import numpy

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit
from tests.support import python_model

ONLY = ("state", "rhs", "velocities", "accelerations", "residuals", "reactions")


def source_of(text: str, name: str = "spec") -> Source:
    return Source(f"{name}.yaml", text)


def formulations_of(text: str) -> tuple[str, ...]:
    """The formulations that apply, the reference (multipliers) first."""
    return tuple(f.name for f in applicable(resolve(decode(source_of(text)))))


def load_python(text: str, formulation: str, only: tuple[str, ...] = ONLY) -> ModuleType:
    """The emitted Python of a spec's text."""
    (module,) = emit(source_of(text), "python", Options(formulation=formulation, only=only)).values()
    return python_model(module, "metamorphic")


@dataclass(frozen=True)
class State:
    """A time, coordinates and velocities."""

    t: float
    q: tuple[float, ...]
    v: tuple[float, ...]


def draw_state(model: ModuleType, p: Sequence[float], rng: random.Random) -> State:
    """A random state; its velocities are projected onto the constraints (affine in q', so the rows are differences)."""
    n = len(model.COORDINATES)
    t = rng.uniform(0.1, 1.0)
    q = [rng.uniform(-0.9, 0.9) for _ in range(n)]
    v = numpy.array([rng.uniform(-1.0, 1.0) for _ in range(n)])
    if model.CONSTRAINTS:
        at_rest = numpy.array(model.residuals(t, q, [0.0] * n, p))
        rows = numpy.array([model.residuals(t, q, list(unit), p) for unit in numpy.eye(n)]).T - at_rest[:, None]
        for _ in range(2):  # the second takes off what rounding left
            v = v - numpy.linalg.pinv(rows) @ (rows @ v + at_rest)
    return State(t, tuple(q), tuple(float(x) for x in v))


def accelerations(model: ModuleType, p: Sequence[float], state: State) -> list[float]:
    """q'' at an admissible state, through the formulation's own state."""
    y = model.state(state.t, state.q, state.v, p)
    return list(model.accelerations(state.t, y, p))


def reactions(model: ModuleType, p: Sequence[float], state: State) -> list[float]:
    return list(model.reactions(state.t, model.state(state.t, state.q, state.v, p), p))


def default_parameters(model: ModuleType, rng: random.Random) -> list[float]:
    """The spec's values; a value that each scene must give is drawn."""
    return [x if x == x else rng.uniform(0.5, 1.5) for x in model.DEFAULTS]


def distance(found: Sequence[float], expected: Sequence[float]) -> float:
    """The largest difference over 1 or the largest entry."""
    assert len(found) == len(expected)
    scale = max([1.0, *(abs(x) for x in expected)])
    return max([abs(a - b) / scale for a, b in zip(found, expected, strict=True)], default=0.0)
