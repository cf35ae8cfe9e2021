"""The expression graph: integer nodes, hash-consed, children before parents.

A node is an index into three parallel lists (operation, first operand, second operand), so an expression that occurs twice is one
node and every pass over the graph is a loop over increasing indices.  Numbers are exact rationals.  Sums and products are binary
and are never flattened or expanded: what the user wrote once, and named under ``define:``, stays one node from the spec to the
emitted code.

Rewriting is local: a rule looks at a new node and its operands, never further.  Each rule keeps the value (``tests/property``
checks every one of them modulo a prime).  Division is multiplication by ``x**-1``, so that quotients share their reciprocal.

Supported: ``+ * -x x**n`` (n a nonzero integer), the language's functions, ``pow`` with any exponent, pi.
Not supported: relations, piecewise expressions, complex numbers.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from math import isqrt

from nhc.algebra.nodes import ADD, BINARY, MUL, NEG, NUM, ONE, PI, POW, SYM, UNARY, Node, NodeStore, Symbol, exact_power

__all__ = ["ADD", "BINARY", "MUL", "NEG", "NUM", "PI", "POW", "SYM", "UNARY", "Graph", "Node", "Symbol"]

_ODD = frozenset({"sin", "asin", "atan", "sinh", "tanh", "sign"})
_EVEN = frozenset({"cos", "cosh", "abs"})
# value at zero, where it is rational
_AT_ZERO = {
    "sin": 0,
    "cos": 1,
    "asin": 0,
    "atan": 0,
    "sinh": 0,
    "cosh": 1,
    "tanh": 0,
    "exp": 1,
    "sqrt": 0,
    "abs": 0,
    "sign": 0,
}


class Graph(NodeStore):
    """A growing set of expressions.  Every method that builds returns a node; equal expressions are the same node."""

    # --- sums ---------------------------------------------------------------------------------------------

    def add(self, x: Node, y: Node) -> Node:
        if x == self.zero:
            return y
        if y == self.zero:
            return x
        (kx, px), (ky, py) = self.split_coefficient(x), self.split_coefficient(y)
        if px == py:  # k P + l P
            return self.scale(kx + ky, px)
        if (px, kx) > (py, ky):
            x, y, kx, ky, px, py = y, x, ky, kx, py, px
        if kx < 0:  # the sign of a sum is that of its first term
            return self.neg(self.add(self.neg(x), self.neg(y)))
        shorter = self._common_factor(x, y) or self._cancel_terms(x, y) or self._cancel_terms(y, x)
        if shorter is not None:
            return shorter
        if kx == ky and self._is_circle(px, py):  # k sin^2 + k cos^2
            return self.number(kx)
        return self._make(ADD, x, y, self.deps[x] | self.deps[y])

    def _is_circle(self, p: Node, q: Node) -> bool:
        """p + q = sin^2 + cos^2 of one angle."""
        if self.op[p] != POW or self.op[q] != POW or self.b[p] != 2 or self.b[q] != 2:
            return False
        f, g = self.a[p], self.a[q]
        return {self.op[f], self.op[g]} == {"sin", "cos"} and self.a[f] == self.a[g]

    def _common_factor(self, x: Node, y: Node) -> Node | None:
        """k P + l P -> (k + l) P for a factor P that stands in both products."""
        nx, ny = self.op[x] == NEG, self.op[y] == NEG
        ux, uy = (self.a[x] if nx else x), (self.a[y] if ny else y)
        if self.op[ux] != MUL or self.op[uy] != MUL:
            return None
        fx, fy = (self.a[ux], self.b[ux]), (self.a[uy], self.b[uy])
        for i in (0, 1):
            for j in (0, 1):
                if fx[i] == fy[j] and self.op[fx[i]] != NUM:
                    k, m = fx[1 - i], fy[1 - j]
                    total = self.add(self.neg(k) if nx else k, self.neg(m) if ny else m)
                    return self.mul(total, fx[i])
        return None

    def _cancel_terms(self, x: Node, y: Node) -> Node | None:
        """x + (u - x) -> u, for the terms of a sum y or of -y."""
        negative = self.op[y] == NEG
        total = self.a[y] if negative else y
        if self.op[total] != ADD:
            return None
        wanted = x if negative else self.neg(x)
        first, second = self.a[total], self.b[total]
        if wanted in (first, second):
            rest = second if wanted == first else first
            return self.neg(rest) if negative else rest
        return None

    def neg(self, x: Node) -> Node:
        op = self.op[x]
        if op == NUM:
            return self.number(-self._numbers[self.a[x]])
        if op == NEG:
            return self.a[x]
        return self._make(NEG, x, 0, self.deps[x])

    def sub(self, x: Node, y: Node) -> Node:
        return self.add(x, self.neg(y))

    def sum(self, terms: Iterable[Node]) -> Node:
        total = self.zero
        for term in terms:
            total = self.add(total, term)
        return total

    # --- products -----------------------------------------------------------------------------------------

    def scale(self, k: int | Fraction, x: Node) -> Node:
        """k*x for a rational k and an x without a rational factor in front."""
        if k == 0:
            return self.zero
        if k < 0:
            return self.neg(self.scale(-k, x))
        if k == 1:
            return x
        if self.op[x] == NUM:
            return self.number(k * self._numbers[self.a[x]])
        return self._make(MUL, self.number(k), x, self.deps[x])

    def mul(self, x: Node, y: Node) -> Node:
        if x == self.zero or y == self.zero:
            return self.zero
        if x == self.one:
            return y
        if y == self.one:
            return x
        (kx, px), (ky, py) = self.split_coefficient(x), self.split_coefficient(y)
        k = ky if kx is ONE else kx if ky is ONE else kx * ky
        if px == self.one or py == self.one:
            return self.scale(k, py if px == self.one else px)
        (bx, ex), (by, ey) = self.split_power(px), self.split_power(py)
        if bx == by:
            return self.mul_number(k, self.power(bx, ex + ey))
        if self.op[px] == MUL or self.op[py] == MUL:
            cancelled = self._cancel(px, by, ey) or self._cancel(py, bx, ex)
            if cancelled is not None:
                return self.mul_number(k, cancelled)
        if px > py:
            px, py = py, px
        product = self._make(MUL, px, py, self.deps[px] | self.deps[py])
        return product if k is ONE else self.scale(k, product)

    def mul_number(self, k: Fraction, x: Node) -> Node:
        """k*x for a rational k and any x."""
        kx, px = self.split_coefficient(x)
        return self.scale(k if kx is ONE else k * kx, px)

    def _cancel(self, product: Node, base: Node, exponent: int) -> Node | None:
        """(u * base^m) * base^exponent, where m and exponent have opposite signs: one factor less."""
        if self.op[product] != MUL:
            return None
        for factor, other in ((self.a[product], self.b[product]), (self.b[product], self.a[product])):
            b, e = self.split_power(factor)
            if b == base and (e > 0) != (exponent > 0):
                return self.mul(other, self.power(base, e + exponent))
        return None

    def split_power(self, node: Node) -> tuple[Node, int]:
        return (self.a[node], self.b[node]) if self.op[node] == POW else (node, 1)

    def product(self, factors: Iterable[Node]) -> Node:
        result = self.one
        for factor in factors:
            result = self.mul(result, factor)
        return result

    def power(self, x: Node, n: int) -> Node:
        if n == 0:
            return self.one
        if n == 1:
            return x
        op = self.op[x]
        if op == NUM:
            value = self._numbers[self.a[x]]
            if value == 0 and n < 0:
                raise ZeroDivisionError("a constant expression divides by zero")
            return self.number(exact_power(value, n))
        if op == NEG:
            inner = self.power(self.a[x], n)
            return self.neg(inner) if n % 2 else inner
        if op == POW:
            return self.power(self.a[x], self.b[x] * n)
        if op == MUL and self.op[self.a[x]] == NUM:
            return self.mul(self.number(exact_power(self._numbers[self.a[self.a[x]]], n)), self.power(self.b[x], n))
        if op == "sqrt" and n % 2 == 0:
            return self.power(self.a[x], n // 2)
        if op == "exp":
            return self.function("exp", self.mul(self.number(n), self.a[x]))
        return self._make(POW, x, n, self.deps[x])

    def inverse(self, x: Node) -> Node:
        return self.power(x, -1)

    def div(self, x: Node, y: Node) -> Node:
        return self.mul(x, self.inverse(y))

    # --- functions ----------------------------------------------------------------------------------------

    def function(self, name: str, *arguments: Node) -> Node:
        if name == "tan":  # shares its pair with sin and cos of the same angle
            return self.div(self.function("sin", *arguments), self.function("cos", *arguments))
        if name in BINARY:
            return self._binary_function(name, *arguments)
        (x,) = arguments
        value = self.value(x)
        if value is not None:
            known = self._known(name, value)
            if known is not None:
                return known
        if name in ("sin", "cos"):
            quarter = self._quarter_turns(x)
            if quarter is not None:
                return self.number((0, 1, 0, -1)[(quarter + (name == "cos")) % 4])
        if self.op[x] == NEG or (value is not None and value < 0):
            if name in _ODD:
                return self.neg(self.function(name, self.neg(x)))
            if name in _EVEN:
                return self.function(name, self.neg(x))
        if name == "abs" and self.op[x] in ("abs", "exp", "sqrt", "cosh"):
            return x
        if name == "exp" and self.op[x] == "log":
            return self.a[x]
        if name == "log" and self.op[x] == "exp":
            return self.a[x]
        return self._make(name, x, 0, self.deps[x])

    def _binary_function(self, name: str, x: Node, y: Node) -> Node:
        vx, vy = self.value(x), self.value(y)
        if name == "powf":
            if vy is not None and vy.denominator == 1:
                return self.power(x, int(vy))
            if vy is not None and vy.denominator == 2:
                return self.power(self.function("sqrt", x), vy.numerator)
        elif name in ("min", "max"):
            if x == y:
                return x
            if vx is not None and vy is not None:
                return self.number(min(vx, vy) if name == "min" else max(vx, vy))
        return self._make(name, x, y, self.deps[x] | self.deps[y])

    def _known(self, name: str, value: Fraction) -> Node | None:
        if value == 0 and name in _AT_ZERO:
            return self.number(_AT_ZERO[name])
        if name == "log" and value == 1:
            return self.zero
        if name == "sqrt" and value > 0:
            top, bottom = isqrt(value.numerator), isqrt(value.denominator)
            if top * top == value.numerator and bottom * bottom == value.denominator:
                return self.number(Fraction(top, bottom))
        if name == "abs":
            return self.number(abs(value))
        if name == "sign":
            return self.number((value > 0) - (value < 0))
        return None

    def _quarter_turns(self, x: Node) -> int | None:
        """k where x is k*pi/2, else None."""
        k, base = self.split_coefficient(x)
        if self.op[base] == PI and (2 * k).denominator == 1:
            return int(2 * k)
        return None
