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

from nhc.algebra.known_values import known_value
from nhc.algebra.nodes import (
    ADD,
    BINARY,
    MUL,
    NEG,
    NUM,
    PI,
    POW,
    SYM,
    UNARY,
    Node,
    NodeStore,
    Rational,
    Symbol,
    exact_power,
)

__all__ = ["ADD", "BINARY", "MUL", "NEG", "NUM", "PI", "POW", "SYM", "UNARY", "Graph", "Node", "Symbol"]

_ODD = frozenset({"sin", "asin", "atan", "sinh", "tanh", "sign"})
_EVEN = frozenset({"cos", "cosh", "abs"})


class Graph(NodeStore):
    """A growing set of expressions.  Every method that builds returns a node; equal expressions are the same node."""

    # --- sums ---------------------------------------------------------------------------------------------
    # A pair of operands that has its node already needs no rule: had one applied, the node would not be there.

    def add(self, x: Node, y: Node) -> Node:
        if not x:
            return y
        if not y:
            return x
        px, py = self.core[x], self.core[y]
        if px == py:  # k P + l P
            return self.scale(self.coefficient[x] + self.coefficient[y], px)
        if px > py:
            x, y, px, py = y, x, py, px
        pair = x, y
        known = self._adds.get(pair)
        if known is not None:
            return known
        kx = self.coefficient[x]
        if kx < 0:  # the sign of a sum is that of its first term
            return self.neg(self.add(self.neg(x), self.neg(y)))
        ky = self.coefficient[y]
        if kx != 1 and (ky == kx or ky == -kx):  # k P + k Q
            return self.mul_number(kx, self.add(px, py) if ky == kx else self.sub(px, py))
        op, a = self.op, self.a
        ux = a[x] if op[x] == NEG else x
        uy = a[y] if op[y] == NEG else y
        kind, other = op[ux], op[uy]
        if kind == MUL and other == MUL:
            shorter = self._common_factor(x, y, ux, uy)
            if shorter is not None:
                return shorter
        if other == ADD:
            shorter = self._cancel_terms(x, y, uy)
            if shorter is not None:
                return shorter
        if kind == ADD:
            shorter = self._cancel_terms(y, x, ux)
            if shorter is not None:
                return shorter
        if kx == self.coefficient[y] and op[px] == POW and self._is_circle(px, py):  # k sin^2 + k cos^2
            return self.number(kx)
        node = self._adds[pair] = self._append(ADD, x, y, self.deps[x] | self.deps[y], pair)
        return node

    def _is_circle(self, p: Node, q: Node) -> bool:
        """p + q = sin^2 + cos^2 of one angle."""
        if self.op[p] != POW or self.op[q] != POW or self.b[p] != 2 or self.b[q] != 2:
            return False
        f, g = self.a[p], self.a[q]
        return {self.op[f], self.op[g]} == {"sin", "cos"} and self.a[f] == self.a[g]

    def _common_factor(self, x: Node, y: Node, ux: Node, uy: Node) -> Node | None:
        """k P + l P -> (k + l) P for a factor P that stands in both products (ux, uy are x, y without their signs)."""
        a, b = self.a, self.b
        ax, bx, ay, by = a[ux], b[ux], a[uy], b[uy]
        if ax != ay and ax != by and bx != ay and bx != by:
            return None
        for factor, k in ((ax, bx), (bx, ax)):
            for match, m in ((ay, by), (by, ay)):
                if factor == match and self.op[factor] != NUM:
                    total = self.add(k if x == ux else self.neg(k), m if y == uy else self.neg(m))
                    return self.mul(total, factor)
        return None

    def _cancel_terms(self, x: Node, y: Node, total: Node) -> Node | None:
        """x + (u - x) -> u, for the terms of a y that is a sum or the negative of one (``total`` is the sum)."""
        negative = total != y
        wanted = x if negative else self.known_negative(x)  # what is no node yet is no operand
        first, second = self.a[total], self.b[total]
        if wanted in (first, second):
            rest = second if wanted == first else first
            return self.neg(rest) if negative else rest
        return None

    def neg(self, x: Node) -> Node:
        node = self._negs.get(x)
        if node is not None:
            return node
        op = self.op[x]
        if op == NUM:
            return self.number(-self.coefficient[x])
        if op == NEG:
            return self.a[x]
        node = self._negs[x] = self._append(NEG, x, 0, self.deps[x], (x,))
        self.coefficient[node] = -self.coefficient[x]
        self.core[node] = self.core[x]
        return node

    def sub(self, x: Node, y: Node) -> Node:
        return self.add(x, self.neg(y)) if y else x

    def sum(self, terms: Iterable[Node]) -> Node:
        total = self.zero
        for term in terms:
            total = self.add(total, term)
        return total

    def dot(self, xs: Iterable[Node], ys: Iterable[Node]) -> Node:
        """The sum of the products of corresponding terms, of which there must be as many (most pairs hold a zero)."""
        return self.sum([self.mul(x, y) for x, y in zip(xs, ys, strict=True) if x and y])

    # --- products -----------------------------------------------------------------------------------------

    def scale(self, k: Rational, x: Node) -> Node:
        """k*x for a rational k and an x without a rational factor in front."""
        if k == 1:
            return x
        if k == 0:
            return self.zero
        if k < 0:
            return self.neg(x if k == -1 else self.scale(-k, x))
        if self.op[x] == NUM:
            return self.number(k * self.coefficient[x])
        if self.op[x] == ADD:
            first, second = self.a[x], self.b[x]
            if abs(k * self.coefficient[first]) == 1 and abs(k * self.coefficient[second]) == 1:  # 2 (x/2 + y/2)
                return self.add(self.mul_number(k, first), self.mul_number(k, second))
        number = self.number(k)
        pair = number, x
        node = self._muls.get(pair)
        if node is None:
            node = self._muls[pair] = self._append(MUL, number, x, self.deps[x], pair)
            self.coefficient[node] = self.coefficient[number]
            self.core[node] = x
        return node

    def mul(self, x: Node, y: Node) -> Node:
        if x <= 1:
            return y if x else 0
        if y <= 1:
            return x if y else 0
        px, py = self.core[x], self.core[y]
        k: Rational = 1
        if px != x or py != y:
            k = self.coefficient[x] * self.coefficient[y]
        if px == 1 or py == 1:
            return self.scale(k, py if px == 1 else px)
        if px > py:
            px, py = py, px
        pair = px, py
        product = self._muls.get(pair)
        if product is None:
            op = self.op
            kind, other = op[px], op[py]
            bx, ex = (self.a[px], self.b[px]) if kind == POW else (px, 1)
            by, ey = (self.a[py], self.b[py]) if other == POW else (py, 1)
            if bx == by:
                return self.mul_number(k, self.power(bx, ex + ey))
            if (ex > 0) != (ey > 0):
                joined = self._join_root(bx, ex, by, ey)
                if joined is not None:
                    return self.mul_number(k, joined)
            if kind == MUL or other == MUL:
                cancelled = self._cancel(px, by, ey) or self._cancel(py, bx, ex)
                if cancelled is not None:
                    return self.mul_number(k, cancelled)
            product = self._muls[pair] = self._append(MUL, px, py, self.deps[px] | self.deps[py], pair)
        if k == 1:
            return product
        return self.neg(product) if k == -1 else self.scale(k, product)

    def mul_number(self, k: Rational, x: Node) -> Node:
        """k*x for a rational k and any x."""
        return self.scale(k * self.coefficient[x], self.core[x])

    def _cancel(self, product: Node, base: Node, exponent: int) -> Node | None:
        """(u * base^m) * base^exponent, where m and exponent have opposite signs: one factor less."""
        if self.op[product] != MUL:
            return None
        first, second = self.a[product], self.b[product]
        for factor, other in ((first, second), (second, first)):
            if self.op[factor] == POW:
                b, e = self.a[factor], self.b[factor]
            else:
                b, e = factor, 1
            if (e > 0) != (exponent > 0):
                joined = self.power(base, e + exponent) if b == base else self._join_root(b, e, base, exponent)
                if joined is not None:
                    return self.mul(other, joined)
        return None

    def _join_root(self, x: Node, m: int, y: Node, n: int) -> Node | None:
        """x^m * sqrt(k x)^n, in either order, as one power of the root; None where neither is the other's root.

        x^2/sqrt(x) would be 0/0 at x = 0, where sqrt(x)^3 is 0.  So would max(0, u)^2/sqrt(|u|), which is sqrt(max(0, u))^3.
        The slope of log|u|, sign(u)/|u|, is 1/u.
        """
        if self.op[x] == "sqrt" or self.op[y] == "sign":
            x, m, y, n = y, n, x, m
        if self.op[x] == "sign" and self.op[y] == "abs" and self.a[x] == self.a[y]:
            return self.power(self.a[x], n) if m == 1 and n % 2 else None
        if self.op[y] != "sqrt":
            return None
        inner = self.a[y]
        if self.core[inner] == x:
            return self.mul_number(exact_power(Fraction(self.coefficient[inner]), -m), self.power(y, 2 * m + n))
        if m > 0 and 2 * m + n > 0 and self.size_of_part(x) == inner:
            return self.power(self.function("sqrt", x), 2 * m + n)
        return None

    def size_of_part(self, x: Node) -> Node | None:
        """|u| where x = max(0, u), else None.

        Slopes that are infinite at x = 0 are taken at |u|: the same where u > 0, and finite where u < 0, so that the slope of max,
        which is 0 there, makes them 0.
        """
        if self.op[x] != "max" or self.zero not in self.kids[x]:
            return None
        first, second = self.kids[x]
        return self.function("abs", second if first == self.zero else first)

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
        known = self._cache.get((POW, x, n))
        if known is not None:
            return known
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
        known = self._cache.get((name, x, 0))
        if known is not None:
            return known
        value = self.value(x)
        if value is not None:
            exact = known_value(name, value)
            if exact is not None:
                return self.number(exact)
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

    def _quarter_turns(self, x: Node) -> int | None:
        """k where x is k*pi/2, else None."""
        k, base = self.split_coefficient(x)
        if self.op[base] == PI and (2 * k).denominator == 1:
            return int(2 * k)
        return None
