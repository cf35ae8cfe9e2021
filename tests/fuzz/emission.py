"""Random specs through every formulation and both back ends: what the tests and ``make fuzz`` share.

Many models go into one shared library, so that hundreds of specs compile in seconds.
"""

from __future__ import annotations

import ctypes
import math
import random
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from nhc.language import decode
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, emit
from tests.generate import write_spec
from tests.metamorphic.models import State, accelerations, distance, draw_state, reactions, source_of
from tests.support import COMPILER, STRICT, doubles, python_model

AGREE = 1e-9  # between formulations
SAME = 1e-12  # between C and Python
TAME = 1e3


@dataclass(frozen=True)
class Case:
    """One random spec with its emitted Python in every formulation; C is emitted in ``formulation``."""

    name: str
    text: str
    formulation: str
    models: tuple[tuple[str, ModuleType], ...]
    files: dict[str, str]

    @property
    def model(self) -> ModuleType:
        return dict(self.models)[self.formulation]


def make_case(seed: int) -> Case:
    """The spec of a seed, emitted; every failure tells the spec's text."""
    rng, name = random.Random(seed), f"random_{seed}"
    text = write_spec(rng, name)
    try:
        source = source_of(text, name)
        names = [f.name for f in applicable(resolve(decode(source)))]
        chosen = rng.choice(names)
        models = []
        for formulation in names:
            only = () if formulation == chosen else ("state", "residuals", "velocities", "accelerations", "reactions")
            (module,) = emit(source, "python", Options(formulation=formulation, only=only)).values()
            models.append((formulation, python_model(module, name)))
        return Case(name, text, chosen, tuple(models), emit(source, "c", Options(formulation=chosen)))
    except Exception as error:
        raise AssertionError(f"seed {seed}: {type(error).__name__}: {error}\n{text}") from error


def states_of(model: ModuleType, seed: int, count: int) -> list[State]:
    """Random admissible states away from singular ones."""
    rng, found = random.Random(seed), list[State]()
    for _ in range(30):
        state = draw_state(model, model.DEFAULTS, rng)
        try:
            values = accelerations(model, model.DEFAULTS, state) + reactions(model, model.DEFAULTS, state)
        except ArithmeticError:
            continue
        if max([abs(x) for x in values], default=0.0) < TAME:
            found.append(state)
    assert len(found) >= count
    return found[:count]


def check_formulations(case: Case, states: Sequence[State]) -> float:
    """Every formulation against the first (multipliers); the largest difference."""
    worst = 0.0
    _, first = case.models[0]
    p = first.DEFAULTS
    for name, model in case.models[1:]:
        for state in states:
            y = model.state(state.t, state.q, state.v)
            error = max(
                distance(model.velocities(state.t, y), state.v),
                distance(accelerations(model, p, state), accelerations(first, p, state)),
                distance(reactions(model, p, state), reactions(first, p, state)),
            )
            assert error < AGREE, f"{name} differs by {error:.1e} at {state}\n{case.text}"
            worst = max(worst, error)
    return worst


def compile_cases(cases: Sequence[Case], folder: Path, flags: tuple[str, ...] = ("-O0",)) -> ctypes.CDLL:
    """One shared library of all cases, compiled strictly."""
    sources = []
    for case in cases:
        for file, text in case.files.items():
            (folder / file).write_text(text, encoding="ascii")
        sources.append(f"{case.name}.c")
    target = folder / "cases.so"
    command = [COMPILER, *STRICT, *flags, "-shared", "-fPIC", "-o", target.name, *sources, "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=folder)
    assert done.returncode == 0, done.stderr
    return ctypes.CDLL(str(target))


def call(library: ctypes.CDLL, name: str, size: int, t: float, *arrays: Sequence[float]) -> list[float]:
    """An ``int`` function of a case; a nonzero status raises."""
    out = doubles([math.nan] * size)
    status = getattr(library, name)(ctypes.c_double(t), *(doubles(a) for a in arrays), out)
    if status:
        raise ArithmeticError(status)
    return list(out)[:size]


def check_c(case: Case, library: ctypes.CDLL, states: Sequence[State]) -> float:
    """Every function of the C against the Python at the states; the largest difference."""
    m, name, worst = case.model, case.name, 0.0
    p = list(m.DEFAULTS)
    n, size, rows, outputs = len(m.COORDINATES), len(m.STATE), len(m.CONSTRAINTS), len(m.OUTPUTS)
    energy = getattr(library, f"{name}_energy")
    energy.restype = ctypes.c_double
    for state in states:
        t, q, v = state.t, state.q, state.v
        y = m.state(t, q, v)
        flat = [x for row in m.jacobian(t, y) for x in row]
        pairs: list[tuple[str, Sequence[float], list[float]]] = [
            ("state", y, call(library, f"{name}_state", size, t, q, v, p)),
            ("residuals", m.residuals(t, q, v), call(library, f"{name}_residuals", rows, t, q, v, p)),
            ("rhs", m.rhs(t, y), call(library, f"{name}_rhs", size, t, y, p)),
            ("velocities", m.velocities(t, y), call(library, f"{name}_velocities", n, t, y, p)),
            ("accelerations", m.accelerations(t, y), call(library, f"{name}_accelerations", n, t, y, p)),
            ("reactions", m.reactions(t, y), call(library, f"{name}_reactions", rows, t, y, p)),
            ("jacobian", flat, call(library, f"{name}_jacobian", size * size, t, y, p)),
            ("outputs", m.outputs(t, y), call(library, f"{name}_outputs", outputs, t, y, p)),
            ("energy", [m.energy(t, y)], [energy(ctypes.c_double(t), doubles(y), doubles(p))]),
            ("batch", m.rhs(t, y), call_batch(library, name, t, y, p)),
        ]
        for function, expected, found in pairs:
            error = distance(found, expected)
            assert error < SAME, f"{function} of C and Python differ by {error:.1e}\n{case.text}"
            worst = max(worst, error)
    return worst


def call_batch(library: ctypes.CDLL, name: str, t: float, y: Sequence[float], p: Sequence[float]) -> list[float]:
    """rhs_batch on three copies of one state (its parameters are one set, its states a structure of arrays)."""
    count = 3
    out = doubles([math.nan] * (count * len(y)))
    states = [x for x in y for _ in range(count)]
    run = getattr(library, f"{name}_rhs_batch")
    status = run(ctypes.c_size_t(count), doubles([t] * count), doubles(states), doubles(p), out)
    if status:
        raise ArithmeticError(status)
    values = list(out)
    assert all(values[i * count + k] == values[i * count] for i in range(len(y)) for k in range(count))
    return [values[i * count] for i in range(len(y))]


def run_batch(seeds: Sequence[int], folder: Path) -> tuple[float, float]:
    """Emit, compile and compare; the largest differences between formulations and between C and Python."""
    cases = [make_case(seed) for seed in seeds]
    library = compile_cases(cases, folder)
    between, back_ends = 0.0, 0.0
    for seed, case in zip(seeds, cases, strict=True):
        states = states_of(case.models[0][1], seed, 3)
        between = max(between, check_formulations(case, states))
        back_ends = max(back_ends, check_c(case, library, states))
    return between, back_ends
