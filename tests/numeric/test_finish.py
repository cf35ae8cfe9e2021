"""The test at the end of emitted C functions decides as one of every entry and every pivot would: as Python's does."""

from __future__ import annotations

import ctypes
import math
import random
from fractions import Fraction
from pathlib import Path

import pytest

from nhc.diagnostics import Source
from nhc.emit.c.finish import Finish, choose_finish
from nhc.pipeline import Options, emit
from nhc.program.ir import Binary, Call, Expr, Guard, Let, Load, Negate, Number, Power, Ref, Section, Statement, Store
from tests.support import GALLERY, CModel, compile_c, emitted, emitted_python, error, python_model

ZERO, ONE = Number(Fraction(0)), Number(Fraction(1))
X, V, K, D = Ref("x"), Ref("v"), Ref("k"), Ref("d")
LOADS = (Load("x", "y", 0), Load("v", "y", 1), Load("k", "p", 0))


def _guard(value: Expr, scale: Expr = ZERO) -> Guard:
    return Guard(value, scale, 1e-12, 1, "singular")


def _stores(*values: Expr) -> tuple[Store, ...]:
    return tuple(Store("dydt", index, value) for index, value in enumerate(values))


@pytest.mark.parametrize(
    ("body", "entries", "guards"),
    [
        # a copy, and a product with a cosine, of what a rate was computed from
        ((Let("c", Call("cos", (X,))), *_stores(V, Binary("*", Ref("c"), V), Binary("*", K, Power(V, 5)))), (1, 2), 0),
        # v*cos(x) does not prove k*v finite, which may overflow
        ((Let("c", Call("cos", (X,))), *_stores(Binary("*", Ref("c"), V), Binary("*", K, V))), (0, 1), 0),
        # a quotient that is finite has a denominator, and factors of it, that are not zero
        ((Let("d", Binary("*", K, X)), _guard(D), _guard(X), *_stores(Binary("/", V, D))), (0,), 0),
        # but not one that is large enough beside something else
        ((Let("d", Binary("*", K, X)), _guard(D, ONE), *_stores(Binary("/", V, D))), (0,), 1),
        # nor may a sum of it be zero
        ((Let("d", Binary("+", K, X)), _guard(X), *_stores(Binary("/", V, D))), (0,), 1),
        # infinities end in exponentials and arctangents
        ((Let("e", Call("exp", (V,))), *_stores(V, Binary("+", Ref("e"), X))), (0, 1), 0),
        ((Let("e", Call("atan", (Binary("/", V, X),))), _guard(X), *_stores(Ref("e"))), (0,), 1),
        # and in denominators
        (_stores(V, Binary("/", X, V)), (0, 1), 0),
    ],
)
def test_what_is_proved_is_not_tested(body: tuple[Statement, ...], entries: tuple[int, ...], guards: int) -> None:
    found = choose_finish((*LOADS, Section("state"), *body))
    assert isinstance(found, Finish) and (found.entries, len(found.guards)) == (entries, guards)


@pytest.mark.parametrize(
    ("body", "factors"),
    [
        # x divides a finite rate: k alone may still be zero, in a named product as in one without a name
        ((Let("d", Binary("*", K, X)), _guard(D), *_stores(V, Binary("/", V, X))), (K,)),
        ((_guard(Binary("*", Binary("*", K, X), X)), *_stores(V, Binary("/", V, X))), (K,)),
        # each factor once, though two blocks have it
        ((_guard(K), _guard(Binary("*", Negate(K), Power(V, 2))), *_stores(V, X)), (K, V)),
        # a product that is there already costs less than its factors
        ((Let("d", Binary("*", K, X)), _guard(D), *_stores(V, D)), (D,)),
        # neither a sum nor a root nor a quotient says anything about its parts
        ((Let("d", Binary("+", K, X)), _guard(D), *_stores(V, Binary("/", V, X))), (D,)),
        ((_guard(Call("sqrt", (X,))), *_stores(V)), (Call("sqrt", (X,)),)),
        ((_guard(Binary("/", K, X)), *_stores(V)), (Binary("/", K, X),)),
        # what must be large enough beside something else is compared with that
        ((_guard(K, ONE), _guard(X), *_stores(V)), (X,)),
    ],
)
def test_blocks_are_tested_by_one_product(body: tuple[Statement, ...], factors: tuple[Expr, ...]) -> None:
    found = choose_finish((*LOADS, Section("state"), *body))
    assert isinstance(found, Finish) and found.factors == factors


def test_long_outputs_are_summed_in_a_loop() -> None:
    loads = [Load(f"v{k}", "y", k) for k in range(80)]
    assert choose_finish((*loads, *_stores(*(Ref(load.name) for load in loads)))) is None


HOSTILE = (0.0, math.inf, -math.inf, math.nan, 1e200, -1e-320, 1.7e308, -1.7e308)


@pytest.mark.sample(3)
@pytest.mark.parametrize("name", GALLERY)
def test_statuses_are_those_of_testing_everything(name: str, tmp_path: Path) -> None:
    """Every entry of state and parameters in turn made hostile: C refuses where Python does, and all that passes is finite."""
    functions = ("rhs", "velocities", "accelerations")
    files = emitted(name, "c", Options(only=functions))
    model = CModel(name, ctypes.CDLL(str(compile_c(files, tmp_path, name))), {})
    module = emitted_python(name)
    draw = random.Random(7)
    y = [draw.uniform(0.2, 0.9) for _ in module.STATE]
    p = [float(x) if x is not None and math.isfinite(x) else 1.0 for x in module.DEFAULTS]
    seen = {0: 0, 1: 0}
    for function in functions:
        size = len(module.STATE) if function == "rhs" else len(module.COORDINATES)
        for array, place in [(y, k) for k in range(len(y))] + [(p, k) for k in range(len(p))]:
            kept = array[place]
            for value in HOSTILE:
                array[place] = value
                bad, out = _run(model, function, size, y, p)
                assert bad == _python_refuses(module, function, y, p), (function, y, p)
                assert bad or all(map(math.isfinite, out))
                seen[bad] += 1
            array[place] = kept
    assert all(seen.values())


def _run(model: CModel, function: str, size: int, y: list[float], p: list[float]) -> tuple[bool, list[float]]:
    try:
        return False, model(function, size, 0.3, y, p)
    except ArithmeticError:
        return True, []


def _python_refuses(module: object, function: str, y: list[float], p: list[float]) -> bool:
    try:
        getattr(module, function)(0.3, y, p)
    except module.SingularModelError:  # type: ignore[attr-defined]
        return True
    return False


FUNCTIONS = Source(
    "functions.yaml",
    """
nhc: 1
system: functions
coordinates: [x, y]
parameters: [k]
T: (x'^2 + y'^2)/2
forces: {x: "max(0, -k*x)", y: "min(1, k*y)"}
outputs:
  soft: 1/(1 + exp(-1000*x))
  hyperbolic: 1/cosh(1000*x) + 1/(2 + sinh(1000*x)^2)
  most: "max(2, max(x, y))"
  least: "min(-2, min(x, y))"
""",
)


def test_functions_of_python_are_those_of_c(tmp_path: Path) -> None:
    """A NaN does not get lost in ``min`` and ``max``, a forgotten parameter neither; an infinity on the way is no failure."""
    model = CModel("functions", ctypes.CDLL(str(compile_c(emit(FUNCTIONS, "c", Options()), tmp_path, "functions"))), {})
    (text,) = emit(FUNCTIONS, "python", Options()).values()
    module = python_model(text, "functions")
    for y in ([-1.0, 0.3], [1.0, -3.0], [math.nan, 0.5], [0.5, math.nan], [0.4, 0.4]):
        state = [*y, 0.0, 0.0]
        assert _run(model, "outputs", 4, state, [1.0])[0] == math.isnan(sum(y))
        assert _python_refuses(module, "outputs", state, [1.0]) == math.isnan(sum(y))
        if not math.isnan(sum(y)):
            expected = [y[0] > 0, 0, max(2, *y), min(-2, *y)]
            assert error(module.outputs(0.0, state, [1.0]), expected) < 1e-15
            assert error(model("outputs", 4, 0.0, state, [1.0]), expected) < 1e-15
        assert _python_refuses(module, "rhs", state, module.DEFAULTS)
        assert _run(model, "rhs", 4, state, module.DEFAULTS)[0]
