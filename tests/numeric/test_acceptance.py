"""Systems outside the gallery, against Lagrange's equations with multipliers derived here from the spec's text by SymPy."""

from __future__ import annotations

import ctypes
import random
import re
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath
import pytest
import sympy
import yaml

from nhc.diagnostics import Source
from nhc.language import decode
from nhc.mechanics.choosing.choose import applicable
from nhc.mechanics.resolving.resolve import resolve
from nhc.pipeline import Options, check, emit
from nhc.simulate.opening import open_scene
from nhc.simulate.run import Settings, run
from tests.support import CModel, compile_c, error, python_model

SPECS = {
    "steady_push": """
        coordinates: [x, int, lambda]
        parameters: {F: 3, m: 2, dydt: 0.7, _x: 1.5}
        T: m/2*x'^2 + dydt*int'^2/2 + m*lambda'^2
        V: F*x + lambda/_x
        forces: {int: -F/(dydt + m), lambda: -_x*F*lambda'}
    """,
    "ball_in_cylinder": """
        coordinates: {phi: {}, z: {}, psi: {}, theta: {range: [0.3, 2.8]}, alpha: {}}
        parameters: {m: 1.1, r: 0.1, R: 0.9, g: 9.81}
        define:
          wx: cos(psi)*theta' + sin(theta)*sin(psi)*alpha'
          wy: sin(psi)*theta' - sin(theta)*cos(psi)*alpha'
          wz: psi' + cos(theta)*alpha'
        T: m/2*(R^2*phi'^2 + z'^2) + m*r^2/5*(wx^2 + wy^2 + wz^2)
        V: m*g*z
        constraints: ["R*phi' + r*wz = 0", "z' - r*(-sin(phi)*wx + cos(phi)*wy) = 0"]
    """,
    "roller_walker": """
        coordinates: [x, y, class, double, return]
        parameters: {m: 1, J: 0.1, L: 0.5, l: 0.3, E1: 1.3}
        define:
          beta: class + double
          gamma: class - return
          X1: x + L*cos(class) + l*cos(beta)
          Y1: y + L*sin(class) + l*sin(beta)
          X2: x - L*cos(class) - l*cos(gamma)
          Y2: y - L*sin(class) - l*sin(gamma)
        T: m/2*(x'^2 + y'^2 + X1'^2 + Y1'^2 + X2'^2 + Y2'^2) + J/2*(class'^2 + beta'^2 + gamma'^2)
        forces: {double: 0.7*sin(E1*t), return: -0.2*return'}
        constraints: ["cos(beta)*Y1' - sin(beta)*X1' = 0", "cos(gamma)*Y2' - sin(gamma)*X2' = 0"]
    """,
    "growing_hoop": """
        coordinates: [x, y, u]
        parameters: {R0: 1, nu: 2}
        T: (x'^2 + y'^2 + u'^2 + 0.3*x'*u')/2
        V: 2*y - u*x
        constraints: [u' - y*x' + x*y'*cos(t) = 0.3]
        holonomic: [x^2 + y^2 = (R0 + sin(nu*t)/4)^2]
    """,
    "kinked_particle": """
        coordinates: [x, y, z]
        T: (x'^2 + y'^2 + z'^2)/2 + x'^4/12 + 0.3*z*x' - 0.1*t*y'
        V: (x^2 + y^2)^2/4 + 0.1*abs(z)^3 + exp(-x^2) + 0.02*atan2(y + 3, x + 2) + tanh(x)*log(2 + cos(y))
        forces: {x: -sign(x')*abs(x')^1.5/10, z: -0.1*z'^3 + sqrt(1 + x'^2)}
        constraints: [cos(t)*x' + y*y'/5 + z' = exp(-t)]
    """,
    "ion": """
        coordinates: [x, y, phi]
        parameters: {m: 1e-26, J: 1e-45, a: 1e-10, B: 1.6e-19, F: 1.6e-14}
        define: {X: x + a*cos(phi), Y: y + a*sin(phi)}
        T: m/2*(X'^2 + Y'^2) + J/2*phi'^2 + B/2*(X*Y' - Y*X')
        V: -F*x
        constraints: [-sin(phi)*x' + cos(phi)*y' = 0]
    """,
    "moon": """
        coordinates: {x1: {range: [-1e6, 1e6]}, y1: {}, x2: {range: [2e8, 3e8]}, y2: {range: [2e8, 3e8]}}
        parameters: {m1: 6e24, m2: 7e22, G: 6.67e-11}
        T: m1/2*(x1'^2 + y1'^2) + m2/2*(x2'^2 + y2'^2)
        V: -G*m1*m2/sqrt((x1 - x2)^2 + (y1 - y2)^2)
        constraints: [(x1 - x2)*(x1' - x2') + (y1 - y2)*(y1' - y2') = 0]
    """,
    "wheels_without_inertia": """
        coordinates: [x, y, th, left, right]
        parameters: {m: 3, I: 0.4, r: 0.1, b: 0.2, tau: 0.5, J: 0}
        T: m/2*(x'^2 + y'^2) + I/2*th'^2 + J*left'^2
        forces: {left: tau*cos(t), right: tau - 0.01*right'}
        constraints:
          - x'*sin(th) - y'*cos(th) = 0
          - x'*cos(th) + y'*sin(th) + b*th' - r*right' = 0
          - x'*cos(th) + y'*sin(th) - b*th' - r*left' = 0
        quasi_velocities: {v: cos(th)*x' + sin(th)*y'}
    """,
}
FUNCTIONS = {"abs": sympy.Abs, **{name: getattr(sympy, name) for name in ("sign", "sqrt", "exp", "log", "sin", "cos")}}
FUNCTIONS |= {name: getattr(sympy, name) for name in ("tanh", "atan2")}


class Derived:
    """M q'' + b = A' lambda and A q'' + c = 0, from T, V, the forces and the constraints, at the spec's parameter values."""

    def __init__(self, name: str) -> None:
        tree = yaml.safe_load(_text(name))
        self.coordinates = list(tree["coordinates"])
        plain = isinstance(tree["coordinates"], list)
        self.ranges = [None if plain else tree["coordinates"][c].get("range") for c in self.coordinates]
        self.q = [sympy.Symbol(f"q{k}", real=True) for k in range(len(self.coordinates))]
        self.v = [sympy.Symbol(f"v{k}", real=True) for k in range(len(self.coordinates))]
        self.t = sympy.Symbol("t", real=True)
        self.known: dict[str, Any] = {"t_": self.t, **FUNCTIONS}
        for c, q, v in zip(self.coordinates, self.q, self.v, strict=True):
            self.known |= {f"{c}_": q, f"{c}_dot": v}
        parameters = {f"{p}_": sympy.Rational(str(value)) for p, value in tree.get("parameters", {}).items()}
        self.known |= parameters
        for key, text in tree.get("define", {}).items():
            self.known[f"{key}_"] = self.read(text)
            self.known[f"{key}_dot"] = self.rate(self.known[f"{key}_"])
        T, V = self.read(tree["T"]), self.read(tree.get("V", "0"))
        forces = [self.read(tree.get("forces", {}).get(c, "0")) for c in self.coordinates]
        sides = [str(text).split("=") for text in (*tree.get("constraints", []), *tree.get("holonomic", []))]
        rows = [self.read(left) - self.read(right) for left, right in sides]
        held = len(tree.get("holonomic", []))
        self.positions = rows[len(rows) - held :]
        rows = [*rows[: len(rows) - held], *(self.rate(f) for f in self.positions)]
        p = [sympy.diff(T, v) for v in self.v]
        pairs = zip(p, self.q, forces, strict=True)
        b = [self.rate(x) - sympy.diff(T, q) + sympy.diff(V, q) - f for x, q, f in pairs]
        found = {
            "M": [[sympy.diff(x, v) for v in self.v] for x in p], "b": b, "rows": rows, "E": T + V,
            "A": [[sympy.diff(r, v) for v in self.v] for r in rows], "c": [self.rate(r) for r in rows], "f": self.positions,
        }  # fmt: skip
        self._values = sympy.lambdify([self.t, *self.q, *self.v], list(found.values()), "mpmath", cse=True)
        self._names = list(found)

    def read(self, text: object) -> Any:
        spelled = re.sub(r"([A-Za-z_]\w*)('?)(\(?)", _spell, str(text)).replace("^", "**")
        return sympy.nsimplify(sympy.sympify(spelled, locals=self.known), rational=True)

    def rate(self, node: Any) -> Any:
        return sympy.diff(node, self.t) + sum(sympy.diff(node, q) * v for q, v in zip(self.q, self.v, strict=True))

    def at(self, t: float, q: Any, v: Any) -> dict[str, Any]:
        return dict(zip(self._names, self._values(t, *map(mpmath.mpf, q), *map(mpmath.mpf, v)), strict=True))

    def draw(self, seed: int) -> tuple[float, list[float], list[float]]:
        """A state on the constraints: the nearest to a random one."""
        draw = random.Random(seed)
        t, q = draw.uniform(0.1, 2), [draw.uniform(*(map(float, r or (-1.2, 1.2)))) for r in self.ranges]
        v = [draw.uniform(-1, 1) for _ in q]
        for _ in range(30 * bool(self.positions)):
            at = self.at(t, q, v)
            q = _nearest(at["A"][-len(self.positions) :], at["f"], q)
        at = self.at(t, q, v)
        return t, q, _nearest(at["A"], at["rows"], v) if at["A"] else v

    def solve(self, t: float, q: list[float], v: list[float]) -> tuple[list[float], list[float]]:
        """Accelerations and reactions."""
        at, n = self.at(t, q, v), len(q)
        size = n + len(at["A"])
        matrix, right = mpmath.zeros(size, size), mpmath.zeros(size, 1)
        for i in range(n):
            right[i] = -at["b"][i]
            for j in range(n):
                matrix[i, j] = at["M"][i][j]
        for a, row in enumerate(at["A"]):
            right[n + a] = -at["c"][a]
            for i, entry in enumerate(row):
                matrix[n + a, i], matrix[i, n + a] = entry, -entry
        found = [float(x) for x in mpmath.lu_solve(matrix, right)]
        return found[:n], found[n:]


def _spell(match: re.Match[str]) -> str:
    if match[3] and not match[2]:
        return f"{match[1]}("
    return f"{match[1]}_{'dot' if match[2] else ''}{match[3]}"


def _nearest(rows: Any, values: Any, x: list[float]) -> list[float]:
    matrix = mpmath.matrix(rows)
    step = matrix.T * mpmath.lu_solve(matrix * matrix.T, -mpmath.matrix(values))
    return [float(a + b) for a, b in zip(x, step, strict=True)]


def _text(name: str) -> str:
    return f"        nhc: 1\n        system: {name}{SPECS[name]}"


@cache
def derived(name: str) -> Derived:
    return Derived(name)


@cache
def source(name: str) -> Source:
    return Source(f"{name}.yaml", "\n".join(line[8:] for line in _text(name).splitlines()) + "\n")


@cache
def errors_of(name: str) -> list[str]:
    return [d.code for d in check(source(name)).diagnostics if d.code.startswith("E")]


CASES = [(name, f.name) for name in SPECS for f in applicable(resolve(decode(source(name))))]


def _scaled(found: Any, expected: Any) -> float:
    size = max(map(abs, expected), default=0.0)
    return error([x / size for x in found], [x / size for x in expected]) if size else error(found, expected)


@pytest.mark.sample(2)
@pytest.mark.parametrize(("name", "formulation"), CASES)
def test_it_moves_as_multipliers_say(name: str, formulation: str, tmp_path: Path) -> None:
    assert not errors_of(name)
    options = Options(formulation=formulation)
    (text,) = emit(source(name), "python", options).values()
    model = python_model(text, f"{name}_{formulation.replace('-', '_')}")
    c = CModel(name, ctypes.CDLL(str(compile_c(emit(source(name), "c", options), tmp_path, name))), {})
    p, own = list(model.DEFAULTS), derived(name)
    with mpmath.workdps(110):
        for seed in range(3):
            t, q, v = own.draw(seed)
            accelerations, reactions = own.solve(t, q, v)
            y = model.state(t, q, v)
            expected = {"velocities": v, "accelerations": accelerations, "reactions": reactions}
            for function, values in expected.items():
                assert _scaled(getattr(model, function)(t, y), values) < 1e-9
                assert _scaled(c(function, len(values), t, y, p), values) < 1e-9
            at = own.at(t, q, v)
            assert abs(model.energy(t, y) - at["E"]) <= 1e-9 * abs(at["E"]) and model.rhs(t, y)[
                : len(q)
            ] == pytest.approx(v)
            away = [x + 0.3 * k for k, x in enumerate(v, 1)]
            assert _scaled(model.residuals(t, q, away), [float(x) for x in own.at(t, q, away)["rows"]]) < 1e-9
            _check_jacobian(model, c, t, y, p)


def _check_jacobian(model: ModuleType, c: CModel, t: float, y: list[float], p: list[float]) -> None:
    """Against differences of the right-hand side, column by column."""
    exact = model.jacobian(t, y)
    assert _scaled(c("jacobian", len(y) ** 2, t, y, p), [x for row in exact for x in row]) < 1e-12
    for j, at in enumerate(y):
        h = 1e-5 * max(1.0, abs(at))
        near = [model.rhs(t, [*y[:j], at + k * h, *y[j + 1 :]]) for k in (2, 1, -1, -2)]
        column = [(8 * (b - c) - (a - d)) / (12 * h) for a, b, c, d in zip(*near, strict=True)]
        rounding = [1e-15 * max(map(abs, row)) / h for row in zip(*near, strict=True)]
        for i, found in enumerate(column):
            assert abs(found - exact[i][j]) <= 1e-5 * max(map(abs, exact[i])) + 30 * rounding[i] + 1e-9


def test_a_parameter_of_zero_has_the_same_status_everywhere(tmp_path: Path) -> None:
    """No mass, no inertia, no wheel base: Python says which block is singular, as C does."""
    name = "wheels_without_inertia"
    (text,) = emit(source(name), "python").values()
    module = python_model(text, name)
    c = CModel(name, ctypes.CDLL(str(compile_c(emit(source(name), "c"), tmp_path, name))), {})
    y, seen = [0.3] * len(module.STATE), set()
    for place in range(len(module.PARAMETERS)):
        p = [0.0 if k == place else x for k, x in enumerate(module.DEFAULTS)]
        for function, size in (("rhs", len(y)), ("accelerations", 5), ("reactions", 3)):
            status = 0
            try:
                getattr(module, function)(0.2, y, p)
            except module.SingularModelError as stopped:
                status = stopped.status
            try:
                c(function, size, 0.2, y, p)
                assert status == 0
            except ArithmeticError as stopped:
                assert stopped.args == (status,)
            seen.add(status)
    assert seen >= {0, 2}


@pytest.mark.parametrize("compiled", [True, False])
def test_a_start_where_everything_is_zero(compiled: bool) -> None:
    """The wheels turn as t, the body as t^3: in very short steps its angle is a difference of equal numbers, without a digit."""
    text = source("wheels_without_inertia").text + "scenes: {go: {time: [0, 2], need: [x, y, th]}}\n"
    rows = []
    for tolerance in (1e-8, 1e-12):
        found = run(open_scene(Source("wheels.yaml", text)), Settings("dop853", tolerance, points=2, compiled=compiled))
        assert found.ended == "done"
        rows.append(found.rows[-1])
    assert rows[0] == pytest.approx(rows[1], rel=1e-8)
