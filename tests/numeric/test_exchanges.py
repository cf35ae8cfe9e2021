"""Emitted functions where a pivot of their order of elimination vanishes and the constraints do not care.

Held against the multiplier equations in NumPy, which choose their pivots.
"""

from __future__ import annotations

import ctypes
import random
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from nhc.algebra.evaluate import evaluate
from nhc.algebra.graph import Node
from nhc.algebra.solving.blocks import find_eliminated
from nhc.diagnostics import Source
from nhc.pipeline import Options, check, emit, model
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.support import CModel, compile_c, error, python_model, seldom

CASES = ((1, 5, 2, "voronec"), (2, 5, 2, "euler-lagrange"), (3, 6, 2, "voronec"), (4, 7, 1, "euler-lagrange"))


@dataclass(frozen=True)
class Dense:
    """``rows`` constraints whose coefficients are c0 + c1 sin(q_k) or with a cosine, and a full mass matrix."""

    rows: int
    coefficients: tuple[tuple[tuple[float, float, bool, int], ...], ...]
    mass: Any
    weights: tuple[float, ...]

    @property
    def size(self) -> int:
        return len(self.weights)

    def matrix(self, q: Any, rates: Any = None) -> Any:
        """A, or its derivative along q' = ``rates``."""
        found = np.zeros((self.rows, self.size))
        for i, row in enumerate(self.coefficients):
            for j, (c0, c1, sine, k) in enumerate(row):
                if rates is None:
                    found[i, j] = c0 + c1 * (np.sin(q[k]) if sine else np.cos(q[k]))
                else:
                    found[i, j] = c1 * (np.cos(q[k]) if sine else -np.sin(q[k])) * rates[k]
        return found

    def motion(self, q: Any, kept: tuple[int, ...], w: Any) -> tuple[Any, Any, Any]:
        """q', q'' and lambda where the velocities ``kept`` are ``w``."""
        a, n = self.matrix(q), self.size
        v = np.linalg.solve(np.vstack([a, np.eye(n)[list(kept)]]), [*np.zeros(self.rows), *w])
        whole = np.block([[self.mass, -a.T], [a, np.zeros((self.rows, self.rows))]])
        force = np.array(self.weights) * np.sin(q)
        found = np.linalg.solve(whole, [*force, *(-self.matrix(q, v) @ v)])
        return v, found[:n], found[n:]


@cache
def make(seed: int, rows: int, free: int) -> Dense:
    rng, n = random.Random(seed), rows + free
    number = lambda: round(rng.uniform(-1.5, 1.5), 2)  # noqa: E731
    coefficients = tuple(
        tuple((number(), number(), rng.random() < 0.5, rng.randrange(n)) for _ in range(n)) for _ in range(rows)
    )
    lower = np.array([[number() if j < i else 1.0 + (i == j) if i == j else 0.0 for j in range(n)] for i in range(n)])
    return Dense(rows, coefficients, np.round(lower @ lower.T, 4), tuple(number() for _ in range(n)))


def write(dense: Dense, formulation: str, scenes: str = "") -> Source:
    """The spec; the last velocities are its quasi-velocities."""
    n, q = dense.size, [f"q{i}" for i in range(dense.size)]
    mass = [f"{float(dense.mass[i][j])!r}/{1 + (i == j)}*{q[i]}'*{q[j]}'" for i in range(n) for j in range(i + 1)]
    lines = ["nhc: 1", "system: dense", f"coordinates: [{', '.join(q)}]", f"T: {' + '.join(mass)}"]
    lines += [f"V: {' + '.join(f'({c!r})*cos({x})' for c, x in zip(dense.weights, q, strict=True))}", "constraints:"]
    for row in dense.coefficients:
        terms = [
            f"({c0!r} + ({c1!r})*{'sin' if sine else 'cos'}({q[k]}))*{q[j]}'" for j, (c0, c1, sine, k) in enumerate(row)
        ]
        lines.append(f"  - {' + '.join(terms)} = 0")
    lines += ["quasi_velocities:", *(f"  w{j}: q{j}'" for j in range(dense.rows, n))]
    lines += [f"outputs: {{o: {q[0]}'*{q[1]}' + {q[2]}}}", f"formulation: {formulation}", scenes]
    return Source("dense.yaml", "\n".join(lines) + "\n")


@dataclass(frozen=True)
class Made:
    """``pivots``: of all blocks that are eliminated, the last one left out, which is the determinant over the others."""

    dense: Dense
    source: Source
    kept: tuple[int, ...]
    pivots: tuple[Node, ...]
    symbols: tuple[Node, ...]
    graph: Any

    def pivot(self, number: int, y: Any) -> float:
        place = dict(zip(self.symbols, map(float, y), strict=True))
        try:
            return float(evaluate(self.graph, [self.pivots[number]], place)[0])
        except ZeroDivisionError:  # at a zero of another one
            return 0.0

    def wanted(self, y: Any) -> tuple[list[float], Any, Any, Any]:
        n = self.dense.size
        v, a, forces = self.dense.motion(y[:n], self.kept, y[n:])
        return [*v, *(a[k] for k in self.kept)], v, a, forces


@cache
def case(seed: int, rows: int, free: int, formulation: str) -> Made:
    dense = make(seed, rows, free)
    source = write(dense, formulation)
    found = model(source)
    g, w = found.system.graph, found.equations.motion.w
    names = [symbol.name for x in w if (symbol := g.symbol_of(x)) is not None]
    pivots = tuple(x for x, _ in found.equations.guards)
    assert len(pivots) == rows and len(find_eliminated(g)) >= rows
    return Made(dense, source, tuple(int(name[1:]) for name in names), pivots[:-1], (*found.system.q, *w), g)


def crossings(made: Made, seed: int) -> list[tuple[Any, Any]]:
    """For each pivot a state where it vanishes and the coframe is regular, with a direction across."""
    rng, n, found = np.random.default_rng(seed), made.dense.size, []
    for number in range(len(made.pivots)):
        for _ in range(200):
            begin, move = rng.uniform(-3, 3, n + len(made.kept)), rng.uniform(-0.5, 0.5, n + len(made.kept))
            low, high = 0.0, 1.0
            if made.pivot(number, begin) * made.pivot(number, begin + move) >= 0:
                continue
            while high - low > 1e-16 and (middle := (low + high) / 2) not in (low, high):
                same = made.pivot(number, begin) * made.pivot(number, begin + middle * move) > 0
                low, high = (middle, high) if same else (low, middle)
            y = begin + low * move
            frame = np.vstack([made.dense.matrix(y), np.eye(n)[list(made.kept)]])
            if abs(made.pivot(number, y)) < 1e-12 and np.linalg.cond(frame) < 300:
                found.append((y, move))
                break
    assert len(found) >= len(made.pivots) - 1  # a pivot may be one that never vanishes
    return found


def libraries(made: Made, folder: Path) -> tuple[CModel, list[ModuleType]]:
    files = emit(made.source, "c", Options())
    compiled = CModel("dense", ctypes.CDLL(str(compile_c(files, folder, "dense"))), {})
    texts = [
        text for array in ("", "numpy", "jax") for text in emit(made.source, "python", Options(array=array)).values()
    ]
    return compiled, [python_model(text, f"dense_{k}") for k, text in enumerate(texts)]


@pytest.mark.sample(2)
@pytest.mark.parametrize("chosen", [*CASES[:-2], *map(seldom, CASES[-2:])])
@pytest.mark.usefixtures("jax_is_numpy")
def test_functions_at_and_near_a_pivots_zero(chosen: tuple[int, int, int, str], tmp_path: Path) -> None:
    """All were refused, or lost as many digits twice over as the pivot was small."""
    made = case(*chosen)
    compiled, modules = libraries(made, tmp_path)
    n, size = made.dense.size, len(made.symbols)
    for place, move in crossings(made, chosen[0]):
        for step in (0.0, 1e-12, -1e-9, 1e-6, 1e-4, 1e-2, 0.1):
            y = [float(x) for x in place + step * move]
            rates, v, a, forces = made.wanted(y)
            kinetic = v @ made.dense.mass @ v / 2 + np.array(made.dense.weights) @ np.cos(y[:n])
            assert error(compiled("rhs", size, 0.0, y, []), rates) < 1e-9
            assert error(compiled("velocities", n, 0.0, y, []), v) < 1e-10
            assert error(compiled("accelerations", n, 0.0, y, []), a) < 1e-9
            assert error(compiled("reactions", made.dense.rows, 0.0, y, []), forces) < 1e-6
            assert compiled("outputs", 1, 0.0, y, [])[0] == pytest.approx(v[0] * v[1] + y[2], rel=1e-9, abs=1e-9)
            assert compiled.energy(0.0, y, []) == pytest.approx(kinetic, rel=1e-9)
            for module in modules:
                with np.errstate(all="ignore"):
                    assert error(module.rhs(0.0, y, []), rates) < 1e-9
                    assert error(module.reactions(0.0, y, []), forces) < 1e-6
                    assert float(module.energy(0.0, y, [])) == pytest.approx(kinetic, rel=1e-9)


@pytest.mark.sample(2)
@pytest.mark.parametrize("chosen", CASES[:2])
@pytest.mark.usefixtures("jax_is_numpy")
def test_jacobians_there(chosen: tuple[int, int, int, str], tmp_path: Path) -> None:
    made = case(*chosen)
    compiled, modules = libraries(made, tmp_path)
    size = len(made.symbols)
    for place, move in crossings(made, chosen[0])[:3]:
        for step in (0.0, 1e-9, 1e-3, 0.3):
            y, columns = place + step * move, []
            for unit in np.eye(size) * 1e-5:
                ahead, behind = (np.array(made.wanted(y + sign * unit)[0]) for sign in (1, -1))
                columns.append((ahead - behind) / 2e-5)
            wanted = np.array(columns).T.ravel()
            tolerance = 1e-6 * max(1.0, float(abs(wanted).max()))
            with np.errstate(all="ignore"):
                each = [module.jacobian(0.0, [float(x) for x in y], []) for module in modules]
            for found in (compiled("jacobian", size * size, 0.0, y, []), *each):
                assert np.array(found).ravel() == pytest.approx(wanted, abs=tolerance)


@pytest.mark.sample(2)
@pytest.mark.parametrize("chosen", CASES)
def test_no_ordinary_state_is_refused(chosen: tuple[int, int, int, str], tmp_path: Path) -> None:
    """Bounds of a pivot's terms without their signs grow with each pivot before it: of seven rows a third was refused.

    All states at once, too, in vectors.
    """
    made = case(*chosen)
    files = emit(made.source, "c", Options(only=("rhs", "rhs_batch")))
    compiled = CModel("dense", ctypes.CDLL(str(compile_c(files, tmp_path, "dense", ("-O1",)))), {})
    rng, n, size, states = np.random.default_rng(5), made.dense.size, len(made.symbols), []
    while len(states) < 400:
        y = rng.uniform(-3, 3, size)
        if np.linalg.cond(np.vstack([made.dense.matrix(y), np.eye(n)[list(made.kept)]])) < 1e4:
            states.append(y)
    states += [place for place, _ in crossings(made, chosen[0])]
    wanted = [made.wanted(y)[0] for y in states]
    for y, rates in zip(states, wanted, strict=True):
        assert error(compiled("rhs", size, 0.0, y, []), rates) < 1e-8
    count = len(states)
    out, times = (ctypes.c_double * (size * count))(), (ctypes.c_double * count)()
    flat = (ctypes.c_double * (size * count))(*np.array(states).T.ravel())
    none = (ctypes.c_double * 1)()
    assert compiled.library.dense_rhs_batch(ctypes.c_size_t(count), times, flat, none, out) == 0
    found = np.array(out).reshape(size, count).T
    for mine, rates in zip(found, wanted, strict=True):
        assert error(mine, rates) < 1e-8


@pytest.mark.usefixtures("jax_is_numpy")
def test_what_is_singular_is_refused_as_before(tmp_path: Path) -> None:
    """The kept velocities follow from the others: no order of elimination helps."""
    dense = make(1, 5, 2)
    rows = [*dense.coefficients[:4], tuple((0.0, 1.0 if j == 6 else 0.0, True, 0) for j in range(7))]
    made = Dense(5, tuple(rows), dense.mass, dense.weights)
    text = write(made, "euler-lagrange").text.replace("  w6: q6'", "  w6: q6' + 0.5*q0'")
    source = Source("dense.yaml", text)
    compiled = CModel("dense", ctypes.CDLL(str(compile_c(emit(source, "c", Options()), tmp_path, "dense"))), {})
    modules = [
        python_model(next(iter(emit(source, "python", Options(array=a)).values())), a) for a in ("", "numpy", "jax")
    ]
    y = [0.0, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.1, 0.2]  # sin(q0) is before the whole last row
    nothing = [0.5, 0.3, float("nan"), *y[3:]]
    for state, status in ((y, 1), (nothing, 3)):
        with pytest.raises(ArithmeticError) as caught:
            compiled("rhs", 9, 0.0, state, [])
        assert caught.value.args[0] == status
        for module in modules[:2]:
            with pytest.raises(module.SingularModelError) as raised:
                module.rhs(0.0, state, [])
            assert raised.value.status == status
        with np.errstate(all="ignore"):
            assert np.isnan(modules[2].rhs(0.0, np.array(state), [])).all()


SCENES = """\
scenes:
  long:
    initial: {q0: 0.3, q1: 0.2, w6: 0.4, w7: 0.5}
    time: [0, 1.8]
    need: [q0, q5', o]
  pushed:
    initial: {w6: 0.4, w7: -0.5}
    time: [0, 2]
    need: [q0, reactions]
"""


@pytest.mark.slow
def test_scenes_drivers_and_runs_pass_by(tmp_path: Path) -> None:
    """None of them ends or changes the formulation for a pivot; the smallest models have what stands in, too."""
    source = write(make(3, 6, 2), "voronec", SCENES)
    for scene in ("long", "pushed"):
        exact = run(open_scene(source, scene, formulation="multipliers"), Settings("dop853", 1e-10, points=21))
        found = run(open_scene(source, scene), Settings("dop853", 1e-10, points=21))
        assert found.ended == "done" and not any("multipliers" in note for note in found.notes)
        assert np.array(found.rows) == pytest.approx(np.array(exact.rows), rel=1e-6, abs=1e-7)
        options = Options(scene=scene, reduce=True)
        (text,) = emit(source, "python", options).values()
        reduced, whole = (
            python_model(text, "reduced"),
            python_model(next(iter(emit(source, "python").values())), "whole"),
        )
        rng = random.Random(1)
        for _ in range(20):
            y = [rng.uniform(-2, 2) for _ in whole.STATE]
            kept = [whole.STATE.index(name) for name in reduced.STATE]
            rates = whole.rhs(0.0, y)
            assert (
                error(reduced._rhs_exchanged(0.0, [y[k] for k in kept], reduced.DEFAULTS), [rates[k] for k in kept])
                < 1e-7
            )
            outputs = reduced.outputs(0.0, [y[k] for k in kept])
            assert error(reduced._outputs_exchanged(0.0, [y[k] for k in kept], reduced.DEFAULTS), outputs) < 1e-5


@pytest.mark.slow
def test_a_warning_names_the_determinant_once() -> None:
    found = check(case(*CASES[1]).source)
    assert [d.code for d in found.diagnostics].count("W0408") <= 1
