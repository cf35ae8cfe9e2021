"""Evaluation in a prime field.

The functions of the language are sent to the field so that the identities between them stay true:

- an angle is written as a polynomial; each of its monomials (with the least common denominator of its coefficients) owns a point of
  the circle by the rational parametrisation, and sin and cos of the angle come from the powers of those points (so sin 2x,
  sin(x + y) and shifts by quarter turns agree with sin x, cos x);
- exp, sinh, cosh, tanh likewise, with one invertible generator per monomial;
- sqrt is the square root that is itself a square (points where the argument has none are drawn again), odd roots exist and are
  unique because (p - 1)/2 is prime;
- every other function is an independent generator, fixed by its name and the value of its argument.

Hence equal expressions always have equal values; unequal ones of degree d agree at a random point with probability at most d/p
(Schwartz 1980, Zippel 1979).  p is a safe prime of 61 bits.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from math import lcm

from nhc.algebra.calculus import reachable
from nhc.algebra.expand import Monomial, Polynomial, TooLarge
from nhc.algebra.graph import ADD, MUL, NEG, NUM, PI, POW, SYM, Graph, Node
from nhc.algebra.polynomial import ONE, polynomial

PRIMES = (2305843009213057079, 2305843009178326439, 2305843009101690119, 2305843009045133879)
"""Safe primes below 2**61, all 7 modulo 8, modulo each of which 2, 3, 5, ..., 47 are squares: the roots of the numbers that
occur in specs exist, and sqrt(4*x) is 2*sqrt(x) and not its negative."""

_EXPONENT = 65537
_PERIODIC = ("sin", "cos")
_EXPONENTIAL = ("exp", "sinh", "cosh", "tanh")
_FAMILIES = {**dict.fromkeys(_PERIODIC, "angle"), **dict.fromkeys(_EXPONENTIAL, "exponent")}


class Unlucky(Exception):
    """The point lies on a pole, or a square root has no value there: draw another."""


class FieldPoint:
    """A random point of the field: values for symbols, generators for angles and exponentials."""

    def __init__(self, graph: Graph, seed: int, prime: int = PRIMES[0]) -> None:
        self.graph, self.prime = graph, prime
        self._random = random.Random(seed)
        self._salt = self._random.getrandbits(61)
        self.values: dict[Node, int] = {}
        self._generators: dict[tuple[object, ...], int] = {}
        self._denominators: dict[tuple[str, Monomial], int] = {}
        self._arguments: dict[Node, Polynomial] = graph.memory.setdefault("arguments", {})
        self._used: set[tuple[str, Monomial]] = set()
        self._circles: dict[Node, tuple[int, int]] = {}  # cosine and sine by the angle

    # --- generators ---------------------------------------------------------------------------------------

    def _generator(self, *key: object) -> int:
        """A random nonzero element that belongs to the key; the order of the questions does not matter."""
        value = self._generators.get(key)
        if value is None:
            value = random.Random(repr((self._salt, key))).randrange(2, self.prime - 1)
            self._generators[key] = value
        return value

    def _symbol(self, node: Node) -> int:
        symbol = self.graph.symbol_of(node)
        assert symbol is not None
        return self._generator("symbol", symbol.kind, symbol.name)

    # --- evaluation ---------------------------------------------------------------------------------------

    def evaluate(self, roots: Iterable[Node], fixed: Mapping[Node, int] | None = None) -> list[int]:
        """Residues of the roots.  ``fixed`` gives symbols a value of the caller's choice.

        Raises:
            Unlucky: a reciprocal of zero, or a square root that does not exist at this point.
        """
        roots, values = list(roots), self.values
        if fixed:
            values.update(fixed)
        todo = reachable(self.graph, roots, known=values)  # operands first
        self._prepare(todo)
        g, p = self.graph, self.prime
        op, first, second = g.op, g.a, g.b
        for node in todo:
            kind = op[node]
            if kind == ADD:
                values[node] = (values[first[node]] + values[second[node]]) % p
            elif kind == MUL:
                values[node] = values[first[node]] * values[second[node]] % p
            elif kind == NEG:
                values[node] = -values[first[node]] % p
            else:
                values[node] = self._value(node)
        return [values[root] for root in roots]

    def prepare(self, roots: Iterable[Node]) -> None:
        """Announce what will be evaluated later, in several calls: the points of the circle are then fine enough for all of it.

        Raises:
            Unlucky: something evaluated before needs them finer.
        """
        self._prepare(reachable(self.graph, roots))

    def prepare_like(self, other: FieldPoint) -> None:
        """Announce, before anything is evaluated, what was announced to another point."""
        self._denominators = dict(other._denominators)

    def _prepare(self, nodes: Sequence[Node]) -> None:
        """Least common denominators of the coefficients of each monomial in angles and exponents."""
        kinds = self.graph.op
        for node in nodes:
            op = kinds[node]
            if op not in _FAMILIES:
                continue
            family = _FAMILIES[op]
            argument = self._argument(self.graph.a[node])
            for monomial, c in argument.items():
                key = (family, monomial)
                known = self._denominators.get(key)
                if known is not None and known % c.denominator and key in self._used:
                    raise Unlucky  # a finer point is needed than one already used: the caller draws another
                self._denominators[key] = lcm(known or 1, c.denominator)

    def _argument(self, node: Node) -> Polynomial:
        known = self._arguments.get(node)
        if known is None and self.graph.op[node] == SYM:
            known = self._arguments[node] = {((node, 1),): 1}
        elif known is None:
            try:
                known = polynomial(self.graph, node, limit=60, circle=False)
            except TooLarge:
                known = {((node, 1),): Fraction(1)}
            self._arguments[node] = known
        return known

    def _value(self, node: Node) -> int:
        g, p, op = self.graph, self.prime, self.graph.op[node]
        if op == POW:
            return self._power(self.values[g.a[node]], g.b[node])
        if op == NUM:
            value = g.coefficient[node]
            return (value if isinstance(value, int) else value.numerator * pow(value.denominator, -1, p)) % p
        if op == SYM:
            return self._symbol(node)
        if op == PI:
            return self._generator("pi")
        if op in _PERIODIC:
            angle = g.a[node]
            known = self._circles.get(angle)
            if known is None:
                known = self._circles[angle] = self._circle(self._argument(angle))
            return known[op == "sin"]
        if op in _EXPONENTIAL:
            return self._exponential(op, self._argument(g.a[node]))
        return self._other(op, node)

    def _power(self, base: int, n: int) -> int:
        if n < 0 and base == 0:
            raise Unlucky
        return pow(base, n, self.prime)

    def _circle(self, argument: Polynomial) -> tuple[int, int]:
        c, s = 1, 0
        for monomial, k in argument.items():
            if (
                len(monomial) == 1
                and self.graph.op[monomial[0][0]] == PI
                and monomial[0][1] == 1
                and 2 % k.denominator == 0
            ):
                ck, sk = ((1, 0), (0, 1), (-1, 0), (0, -1))[int(2 * k) % 4]
            else:
                denominator = self._denominator("angle", monomial)
                u = self._generator("angle", *self._key(monomial))
                ck, sk = self._rotation(u, int(k * denominator))
            c, s = (c * ck - s * sk) % self.prime, (s * ck + c * sk) % self.prime
        return c, s

    def _denominator(self, family: str, monomial: Monomial) -> int:
        self._used.add((family, monomial))
        return self._denominators[(family, monomial)]

    def _key(self, monomial: Monomial) -> tuple[object, ...]:
        """A monomial by the values of its atoms, so that two spellings of one atom share a generator."""
        if monomial == ONE:
            return ("one",)
        if len(monomial) == 1:
            ((factor, e),) = monomial
            known = self.values.get(factor)
            return ((self.evaluate([factor])[0] if known is None else known, e),)
        return tuple(sorted(zip(self.evaluate([f for f, _ in monomial]), [e for _, e in monomial], strict=True)))

    def _rotation(self, u: int, k: int) -> tuple[int, int]:
        """k-th power of the point ((1 - u^2)/(1 + u^2), 2u/(1 + u^2)) of the circle; p = 3 mod 4, so 1 + u^2 is never zero."""
        p = self.prime
        scale = pow(1 + u * u, -1, p)
        c, s = (1 - u * u) * scale % p, 2 * u * scale % p
        if k < 0:
            s, k = -s % p, -k
        rc, rs = 1, 0
        while k:
            if k & 1:
                rc, rs = (rc * c - rs * s) % p, (rs * c + rc * s) % p
            c, s = (c * c - s * s) % p, 2 * c * s % p
            k >>= 1
        return rc, rs

    def _exponential(self, op: str, argument: Polynomial) -> int:
        p, e = self.prime, 1
        for monomial, k in argument.items():
            denominator = self._denominator("exponent", monomial)
            e = e * pow(self._generator("exponent", *self._key(monomial)), int(k * denominator), p) % p
        if op == "exp":
            return e
        inverse, half = pow(e, -1, p), (p + 1) // 2
        sinh, cosh = (e - inverse) * half % p, (e + inverse) * half % p
        if op == "tanh":
            return sinh * self._power(cosh, -1) % p
        return sinh if op == "sinh" else cosh

    def _other(self, op: str, node: Node) -> int:
        g, p = self.graph, self.prime
        x = self.values[g.a[node]]
        if op == "sqrt":
            if x and pow(x, (p - 1) // 2, p) != 1:
                raise Unlucky
            return pow(x, (p + 1) // 4, p)
        if op == "sign":
            return self._sign(x)
        if op == "abs":
            return x * self._sign(x) % p
        if op in ("min", "max"):
            y = self.values[g.b[node]]
            distance = (x - y) * self._sign((x - y) % p) % p
            return (x + y + (distance if op == "max" else -distance)) * ((p + 1) // 2) % p
        if op == "powf":
            return self._root_power(x, g.b[node])
        if op == "atan2":
            return self._generator(op, x, self.values[g.b[node]])
        return self._generator(op, x)

    def _sign(self, x: int) -> int:
        """+1 or -1, odd in x."""
        p = self.prime
        if x == 0:
            return 0
        low = min(x, p - x)
        sign = 1 if self._generator("sign", low) & 1 else p - 1
        return sign if x == low else p - sign

    def _root_power(self, x: int, exponent: Node) -> int:
        """x ** exponent, with x**(u + v) = x**u x**v kept for rational multiples of one monomial."""
        p, result = self.prime, 1
        if x == 0:
            raise Unlucky
        for monomial, k in self._argument(exponent).items():
            if monomial != ONE:
                generator = self._generator("powf", x, *self._key(monomial))
                result = result * pow(generator, int(k * 5040), p) % p if 5040 % k.denominator == 0 else generator
                continue
            root = k.denominator
            base = x
            while root % 2 == 0:
                if pow(base, (p - 1) // 2, p) != 1:
                    raise Unlucky
                base, root = pow(base, (p + 1) // 4, p), root // 2
            result = result * pow(base, k.numerator * pow(root, -1, p - 1) if root > 1 else k.numerator, p) % p
        return result


class QuickPoint(FieldPoint):
    """A point for zero tests: its residues are never written down, so that its elements may be drawn faster."""

    def _generator(self, *key: object) -> int:
        """A power of a number that the key and the salt spell: of two keys neither is known from the other."""
        value = self._generators.get(key)
        if value is None:
            spelled = int.from_bytes(repr((self._salt, key)).encode(), "big")
            value = self._generators[key] = pow(spelled, _EXPONENT, self.prime) or 2
        return value
