"""heyoka as a peer: the program's right-hand side as its expressions, integrated by Taylor's method."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

from nhc.program.ir import Binary, Call, Expr, Function, Let, Load, Negate, Number, Pi, Power, Ref, Solve, Store
from nhc.study.chart.case import Case, Result
from nhc.study.chart.measure import time_repeats
from nhc.study.chart.single import Rig, judge

LANGUAGE, METHOD = "heyoka", "Taylor"
MOST_OPERATIONS = 2000  # its compiler takes seconds for larger right-hand sides
_SAME = ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "exp", "log", "sqrt")


class NoTaylor(Exception):
    """The right-hand side has no form in heyoka's expressions, or its run fails."""


def run_taylor(rig: Rig, tolerance: float, budget: float) -> Result:
    """heyoka's case at a tolerance; its own compilation is not in the time."""
    case = Case(rig.name, METHOD, LANGUAGE, tolerance)
    try:
        solve = _bind(rig, tolerance)
        rows, steps = solve(True)
        counts = Result(case, steps=steps)
        values = rig.interpreted.quantities(rig.times, rows, rig.job.p)
    except (NoTaylor, ArithmeticError) as error:
        return Result(case, failed=str(error) or "it is singular")
    measured = judge(rig, counts, values)
    if measured.failed:
        return measured

    def repeat(count: int) -> None:
        for _ in range(count):
            solve(False)

    best, middle, repeats = time_repeats(repeat, budget)
    return replace(measured, best=best, median=middle, repeats=repeats)


def _bind(rig: Rig, tolerance: float) -> Callable[[bool], tuple[list[list[float]], int]]:
    import heyoka as hy

    job = rig.job
    function = next(f for f in job.program.functions if f.name == "rhs")
    names = [f"y{k}" for k in range(len(job.y))]
    made = hy.make_vars(*names)
    variables = list(made) if len(names) > 1 else [made]
    slopes = translate(function, hy, variables, list(job.p))
    system = list(zip(variables, slopes, strict=True))
    integrator = hy.taylor_adaptive(system, list(job.y), time=job.time[0], tol=tolerance)

    def solve(rows: bool) -> tuple[list[list[float]], int]:
        integrator.time = job.time[0]
        integrator.state[:] = job.y
        if rows:
            found = integrator.propagate_grid(list(rig.times))
            if len(found[-1]) != len(rig.times):
                raise NoTaylor("it stops before the end")
            return [[float(x) for x in row] for row in found[-1]], int(found[3])
        integrator.propagate_until(job.time[1])
        return [], 0

    return solve


def translate(function: Function, hy: Any, y: Sequence[Any], p: Sequence[float]) -> list[Any]:
    """The stored values of a function as heyoka's expressions; guards are left out.

    Raises:
        NoTaylor: it is too large, or uses what heyoka does not have.
    """
    size = function.adds + function.multiplications + function.divisions
    if size > MOST_OPERATIONS:
        raise NoTaylor(f"{size} operations are more than its compiler takes in good time")
    known: dict[str, Any] = {}
    out: list[Any] = [hy.expression(0.0)] * len(y)
    for statement in function.body:
        match statement:
            case Load(name, "t", _):
                known[name] = hy.time
            case Load(name, array, index):
                known[name] = y[index] if array == "y" else hy.expression(p[index])
            case Let(name, value):
                known[name] = _expression(value, known, hy)
            case Solve():
                _eliminate(statement, known, hy)
            case Store(_, index, value):
                out[index] = _expression(value, known, hy)
            case _:
                continue
    return out


def _expression(e: Expr, known: dict[str, Any], hy: Any) -> Any:
    match e:
        case Number(value):
            return hy.expression(float(value))
        case Pi():
            return hy.pi
        case Ref(name):
            return known[name]
        case Negate(operand):
            return -_expression(operand, known, hy)
        case Binary(op, left, right):
            a, b = _expression(left, known, hy), _expression(right, known, hy)
            return a + b if op == "+" else a - b if op == "-" else a * b if op == "*" else a / b
        case Power(base, exponent):
            return _expression(base, known, hy) ** float(exponent)
        case Call(name, arguments):
            values = [_expression(a, known, hy) for a in arguments]
            if name == "pow":
                return values[0] ** values[1]
            if name in _SAME:
                return getattr(hy, name)(*values)
            raise NoTaylor(f"Taylor's method has no `{name}`")


def _eliminate(solve: Solve, known: dict[str, Any], hy: Any) -> None:
    """Gauss's elimination without pivoting: expressions cannot choose."""
    n, m = len(solve.matrix), len(solve.columns)
    rows = [[_expression(e, known, hy) for e in (*solve.matrix[i], *(c[i] for c in solve.columns))] for i in range(n)]
    for k in range(n):
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k], strict=True)]
    for c in range(m):
        x: list[Any] = [None] * n
        for i in reversed(range(n)):
            rest = rows[i][n + c]
            for j in range(i + 1, n):
                rest = rest - rows[i][j] * x[j]
            x[i] = rest / rows[i][i]
        for name, value in zip(solve.names[c], x, strict=True):
            known[name] = value
