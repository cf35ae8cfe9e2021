"""Multiplier equations from a spec's own text: its expressions evaluated with 100 digits, every derivative a central difference.

Nothing of nhc is used, so what agrees with this was read, derived and emitted right.  The equations are those of d'Alembert with
reactions, M q'' = f + A^T lambda and A q'' = -(A' q' + a'), for specs without ``rotation``.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import mpmath
import yaml

_TOKEN = re.compile(r"\s*(\d+\.?\d*(?:[eE][-+]?\d+)?|[^\W\d]\w*|\*\*|[-+*/^()',])")
_DIGITS, _STEP, _WIDE = 100, mpmath.mpf(10) ** -15, mpmath.mpf(10) ** -12  # two steps, for derivatives of derivatives
Tree = tuple[Any, ...]
Values = Sequence[Any]


class _Parser:
    """The language of expressions, by descent."""

    def __init__(self, text: str) -> None:
        self.tokens, self.at = [*_TOKEN.findall(text), ""], 0
        assert "".join(self.tokens) == "".join(text.split()), text

    def take(self, *wanted: str) -> str:
        token = self.tokens[self.at]
        if wanted and token not in wanted:
            return ""
        self.at += 1
        return token

    def sum(self) -> Tree:
        total = self.product()
        while sign := self.take("+", "-"):
            total = (sign, total, self.product())
        return total

    def product(self) -> Tree:
        total = self.signed()
        while sign := self.take("*", "/"):
            total = (sign, total, self.signed())
        return total

    def signed(self) -> Tree:
        return ("neg", self.signed()) if self.take("-") else self.power()

    def power(self) -> Tree:
        base = self.atom()
        while self.take("'"):
            base = ("rate", base)
        return ("^", base, self.signed()) if self.take("^", "**") else base

    def atom(self) -> Tree:
        if self.take("("):
            inside = self.sum()
            assert self.take(")")
            return inside
        token = self.take()
        if token[0].isdigit():
            return ("number", mpmath.mpf(token))
        if not self.take("("):
            return ("name", token)
        arguments = [self.sum()]
        while self.take(","):
            arguments.append(self.sum())
        assert self.take(")")
        return ("call", token, *arguments)


def _parse(text: object) -> Tree:
    parser = _Parser(str(text))
    found = parser.sum()
    assert not parser.take(), text
    return found


@dataclass
class _At:
    """A state; ``known`` are the values of names and rates there."""

    q: Values
    v: Values
    t: Any
    p: Values
    known: dict[Any, Any] = field(default_factory=dict)

    def along(self, step: Any) -> _At:
        """A step of time later, by the velocities."""
        return _At([x + step * y for x, y in zip(self.q, self.v, strict=True)], self.v, self.t + step, self.p)

    def beside(self, j: int, step: Any) -> _At:
        return _At([x + step * (i == j) for i, x in enumerate(self.q)], self.v, self.t, self.p)

    def faster(self, j: int, step: Any) -> _At:
        return _At(self.q, [x + step * (i == j) for i, x in enumerate(self.v)], self.t, self.p)


@dataclass(frozen=True)
class Motion:
    """What the equations say at a state, in 100 digits."""

    accelerations: list[Any]
    reactions: list[Any]
    energy: Any
    outputs: list[Any]


class Oracle:
    """A spec's mechanics; states are lists of coordinates, velocities, the time, and the parameters in the spec's order."""

    def __init__(self, text: str) -> None:
        mpmath.mp.dps = _DIGITS
        data = yaml.safe_load(text)
        self.q = list(data["coordinates"])
        self.parameters = dict(data.get("parameters") or {})
        self.named = {
            name: _parse(x) for part in ("define", "quasi_velocities") for name, x in data.get(part, {}).items()
        }
        self.T = _parse(data["T"])
        self.V = _parse(data["V"]) if "V" in data else ("neg", _parse(data.get("U", "0")))
        self.forces = {name: _parse(x) for name, x in data.get("forces", {}).items()}
        self.rows = [self._row(entry) for entry in data.get("constraints", ())]
        self.rows += [("rate", self._row(entry)) for entry in data.get("holonomic", ())]
        self.outputs = [_parse(x) for x in data.get("outputs", {}).values()]

    @staticmethod
    def _row(entry: str | dict[str, str]) -> Tree:
        text = entry if isinstance(entry, str) else next(iter(entry.values()))
        left, right = text.split("=")
        return ("-", _parse(left), _parse(right))

    # --- values ---------------------------------------------------------------------------------------------------

    def value(self, tree: Tree, at: _At) -> Any:
        kind, *parts = tree
        if kind == "number":
            return parts[0]
        if kind in ("name", "rate"):
            if tree not in at.known:
                at.known[tree] = self._named(parts[0], at) if kind == "name" else self._rate(parts[0], at)
            return at.known[tree]
        if kind == "call":
            name, *arguments = parts
            function = {"abs": abs, "min": min, "max": max}.get(name) or getattr(mpmath, name)
            return function(*(self.value(x, at) for x in arguments))
        x, *others = (self.value(part, at) for part in parts)
        if kind == "neg":
            return -x
        (y,) = others
        return {"+": lambda: x + y, "-": lambda: x - y, "*": lambda: x * y, "/": lambda: x / y, "^": lambda: x**y}[
            kind
        ]()

    def _named(self, name: str, at: _At) -> Any:
        if name in self.q:
            return at.q[self.q.index(name)]
        if name in self.parameters:
            return at.p[list(self.parameters).index(name)]
        return self.value(self.named[name], at) if name in self.named else {"t": at.t, "pi": mpmath.pi}[name]

    def _rate(self, tree: Tree, at: _At) -> Any:
        if tree[0] == "name" and tree[1] in self.q:
            return at.v[self.q.index(tree[1])]
        later, sooner = (at.known.setdefault(("along", s), at.along(s * _STEP)) for s in (1, -1))
        return (self.value(tree, later) - self.value(tree, sooner)) / (2 * _STEP)

    # --- equations ------------------------------------------------------------------------------------------------

    def constraints(self, q: Values, t: Any, p: Values) -> tuple[Any, list[Any]]:
        """(A, a) of A q' + a = 0."""
        n = len(self.q)
        still = _At(q, [mpmath.mpf(0)] * n, t, p)
        at_rest = [self.value(row, still) for row in self.rows]
        matrix = mpmath.matrix(len(self.rows), n)
        for j in range(n):
            one = still.faster(j, 1)
            for k, row in enumerate(self.rows):
                matrix[k, j] = self.value(row, one) - at_rest[k]
        return matrix, at_rest

    def admit(self, q: Values, v: Values, t: Any, p: Values) -> list[Any]:
        """The nearest velocities that the constraints allow, in doubles."""
        if not self.rows:
            return list(v)
        matrix, rest = self.constraints(q, t, p)
        short = mpmath.lu_solve(matrix * matrix.T, matrix * mpmath.matrix(v) + mpmath.matrix(rest))
        return [mpmath.mpf(float(x - y)) for x, y in zip(v, matrix.T * short, strict=True)]

    def _momenta(self, at: _At) -> list[Any]:
        ends = [(at.faster(j, _STEP), at.faster(j, -_STEP)) for j in range(len(self.q))]
        return [(self.value(self.T, a) - self.value(self.T, b)) / (2 * _STEP) for a, b in ends]

    def motion(self, q: Values, v: Values, t: Any, p: Values) -> Motion:
        """Raises ZeroDivisionError where the equations are singular."""
        n, rows, h, at = len(self.q), len(self.rows), _WIDE, _At(q, v, t, p)
        whole, right = mpmath.zeros(n + rows), mpmath.zeros(n + rows, 1)
        later, sooner = at.along(h), at.along(-h)
        moved = zip(self._momenta(later), self._momenta(sooner), strict=True)
        for i, (x, y) in enumerate(moved):
            column = zip(self._momenta(at.faster(i, h)), self._momenta(at.faster(i, -h)), strict=True)
            for j, (a, b) in enumerate(column):
                whole[j, i] = (a - b) / (2 * h)
            ahead, behind = at.beside(i, _STEP), at.beside(i, -_STEP)
            lagrangian = [self.value(self.T, end) - self.value(self.V, end) for end in (ahead, behind)]
            right[i] = (lagrangian[0] - lagrangian[1]) / (2 * _STEP) - (x - y) / (2 * h)
            right[i] += self.value(self.forces[self.q[i]], at) if self.q[i] in self.forces else 0
        matrix, _ = self.constraints(q, t, p)
        for k, row in enumerate(self.rows):
            for j in range(n):
                whole[n + k, j], whole[j, n + k] = matrix[k, j], -matrix[k, j]
            right[n + k] = (self.value(row, sooner) - self.value(row, later)) / (2 * h)
        with mpmath.workdps(_DIGITS // 2):
            found = list(mpmath.lu_solve(whole, right))
        energy = self.value(self.T, at) + self.value(self.V, at)
        return Motion(found[:n], found[n:], energy, [self.value(x, at) for x in self.outputs])
