"""Evaluation in a prime field.

The functions of the language are sent to the field so that the identities between them stay true:

- an angle is written as a polynomial; each of its monomials (with the least common denominator of its coefficients) owns a point of
  the circle by the rational parametrisation, and sin and cos of the angle come from the powers of those points (so sin 2x and
  sin(x + y) agree with sin x, cos x); multiples of pi/2520 are the points that divide the circle so, and their sines
  the radicals that they are (sin(pi/3) = sqrt(3)/2);
- exp, sinh, cosh, tanh likewise, with one invertible generator per monomial;
- an argument that holds velocities owns one point or generator by its value, for on the motion a velocity equals expressions that
  no polynomial shows: tanh(x') is tanh(v cos(theta)); such arguments know their signs, and no addition theorem;
- sin and cos of asin, acos, atan and atan2 are the algebraic functions that they are, and so is exp of log;
- sqrt is the square root that is itself a square (points where the argument has none are drawn again), odd roots exist and are
  unique because (p - 1)/2 is prime; the sign of a square is 1 and of other numbers -1, which is odd and multiplicative as signs
  are, so that sqrt(x^2) is abs(x); constants have their own signs; acos is a quarter turn less asin;
- every other function is an independent generator, fixed by its name and the value of its argument.

Hence equal expressions always have equal values; unequal ones of degree d agree at a random point with probability at most d/p
(Schwartz 1980, Zippel 1979).  p is a safe prime of 61 bits.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Mapping, Sequence
from copy import copy
from math import lcm

from nhc.algebra.arguments import argument_terms
from nhc.algebra.evaluate import sign_of_constant
from nhc.algebra.exact.residues import FULL_TURN, PRIMES, circle_point, part_of_turn, square_root, turn
from nhc.algebra.expand import Monomial, Polynomial
from nhc.algebra.graph import ADD, MUL, NEG, NUM, PI, POW, SYM, Graph, Node
from nhc.algebra.polynomial import ONE, leading_size
from nhc.algebra.walks import reachable

_HALF_TURN = FULL_TURN // 2
_PERIODIC, _EXPONENTIAL = ("sin", "cos"), ("exp", "sinh", "cosh", "tanh")
_FAMILIES = {**dict.fromkeys(_PERIODIC, "angle"), **dict.fromkeys(_EXPONENTIAL, "exponent")}
INVERSE = ("asin", "acos", "atan", "atan2")


def _is_atom(monomial: Monomial) -> bool:
    return len(monomial) == 1 and monomial[0][1] == 1


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
        todo = reachable(self.graph, roots, known=values)
        self._prepare(todo)
        self.fill(todo)
        return [values[root] for root in roots]

    def _at(self, node: Node) -> int:
        known = self.values.get(node)
        return self.evaluate([node])[0] if known is None else known

    def fill(self, nodes: Iterable[Node]) -> None:
        """Residues of these nodes, which have been announced; operands come first, and what they have already is overwritten."""
        g, p, values = self.graph, self.prime, self.values
        op, first, second = g.op, g.a, g.b
        for node in nodes:
            kind = op[node]
            if kind == ADD:
                values[node] = (values[first[node]] + values[second[node]]) % p
            elif kind == MUL:
                values[node] = values[first[node]] * values[second[node]] % p
            elif kind == NEG:
                values[node] = -values[first[node]] % p
            else:
                values[node] = self._value(node)

    def prepare(self, roots: Iterable[Node]) -> None:
        """Announce what will be evaluated later, in several calls: the points of the circle are then fine enough for all of it.

        Raises:
            Unlucky: something evaluated before needs them finer.
        """
        self._prepare(reachable(self.graph, roots))

    def prepare_like(self, other: FieldPoint) -> None:
        """Announce, before anything is evaluated, what was announced to another point."""
        self._denominators = dict(other._denominators)

    def beside(self, stale: Iterable[Node]) -> FieldPoint:
        """The same point with its own copy of the values but the stale ones: some are changed, what depends on them filled in."""
        other = copy(self)
        other.values, other._circles = dict(self.values), {}
        for node in stale:
            del other.values[node]
        return other

    def redraw(self, symbol: Node, value: int, moved: Iterable[Node]) -> None:
        """Another value of a symbol, and of the announced nodes that hold it; others under these have theirs."""
        self._circles.clear()
        self.values[symbol] = value
        self.fill(moved)

    def _prepare(self, nodes: Sequence[Node]) -> None:
        """Least common denominators of the coefficients of each monomial in angles and exponents."""
        kinds = self.graph.op
        for node in nodes:
            op = kinds[node]
            if op not in _FAMILIES:
                continue
            family = _FAMILIES[op]
            if self._moves(self.graph.a[node]):
                continue
            argument = self._argument(self.graph.a[node])
            for monomial, c in argument.items():
                key = (family, monomial)
                known = self._denominators.get(key)
                if known is not None and known % c.denominator and key in self._used:
                    raise Unlucky  # a finer point is needed than one already used: the caller draws another
                self._denominators[key] = lcm(known or 1, c.denominator)

    def _moves(self, argument: Node) -> bool:
        """Whether an argument holds velocities, rates or multipliers."""
        return bool(self.graph.deps[argument] & self.graph.moving)

    def _argument(self, node: Node) -> Polynomial:
        known = self._arguments.get(node)
        if known is None:
            alone = self.graph.op[node] == SYM
            known = self._arguments[node] = {((node, 1),): 1} if alone else argument_terms(self.graph, node)
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
                known = self._circles[angle] = self._circle_of(angle)
            return known[op == "sin"]
        if op in _EXPONENTIAL:
            return self._exponential(op, g.a[node])
        return self._other(op, node)

    def _circle_of(self, angle: Node) -> tuple[int, int]:
        """(cosine, sine)."""
        if not self._moves(angle):
            return self._circle(self._argument(angle))
        point = self.known_point(angle)
        if point is not None:
            return point
        if not self.values[angle]:
            return 1, 0
        generator, sign = self._signed("angle", self.values[angle])
        return turn(*self._point(generator), sign, self.prime)

    def _point(self, generator: int) -> tuple[int, int]:
        """The point of the circle that belongs to a generator."""
        return circle_point(generator, self.prime)

    def known_point(self, atom: Node) -> tuple[int, int] | None:
        """(cosine, sine) of an inverse function's value; None for anything else."""
        g, p, op = self.graph, self.prime, self.graph.op[atom]
        if op not in INVERSE:
            return None
        x = self._at(g.a[atom])
        if op in ("asin", "acos"):
            other = self._root((1 - x * x) % p)
            return (other, x) if op == "asin" else (x, other)
        along = self._at(g.b[atom]) if op == "atan2" else 1
        scale = self._power(self._root((along * along + x * x) % p), -1)
        return along * scale % p, x * scale % p

    def _root(self, x: int) -> int:
        root = square_root(x, self.prime)
        if root is None:
            raise Unlucky
        return root

    def _signed(self, family: str, value: int) -> tuple[int, int]:
        """A generator that belongs to a value up to its sign, and the sign."""
        low = min(value, self.prime - value)
        return self._generator(family, low, 1), 1 if low == value else -1

    def _power(self, base: int, n: int) -> int:
        if n < 0 and base == 0:
            raise Unlucky
        return pow(base, n, self.prime)

    def _circle(self, argument: Polynomial) -> tuple[int, int]:
        c, s = 1, 0
        for monomial, k in argument.items():
            if _is_atom(monomial) and self.graph.op[monomial[0][0]] == PI and _HALF_TURN % k.denominator == 0:
                ck, sk = part_of_turn(int(_HALF_TURN * k) % FULL_TURN, self.prime)
            elif not all(self._at(factor) for factor, _ in monomial):
                continue  # a symbol in it was given the value 0
            else:
                denominator = self._denominator("angle", monomial)
                point = self.known_point(monomial[0][0]) if denominator == 1 and _is_atom(monomial) else None
                if point is None:
                    u, sign = self._monomial("angle", monomial)
                    ck, sk = turn(*self._point(u), sign * int(k * denominator), self.prime)
                else:
                    ck, sk = turn(*point, int(k), self.prime)
            c, s = (c * ck - s * sk) % self.prime, (s * ck + c * sk) % self.prime
        return c, s

    def _denominator(self, family: str, monomial: Monomial) -> int:
        self._used.add((family, monomial))
        return self._denominators[(family, monomial)]

    def _monomial(self, family: str, monomial: Monomial) -> tuple[int, int]:
        """The generator of a monomial, and the sign that its coefficient takes."""
        if _is_atom(monomial):
            return self._signed(family, self._at(monomial[0][0]))
        return self._generator(family, *self._key(monomial)), 1

    def _key(self, monomial: Monomial) -> tuple[object, ...]:
        """A monomial by the values of its atoms, so that two spellings of one atom share a generator."""
        if monomial == ONE:
            return ("one",)
        if len(monomial) == 1:
            ((factor, e),) = monomial
            return ((self._at(factor), e),)
        return tuple(sorted(zip(self.evaluate([f for f, _ in monomial]), [e for _, e in monomial], strict=True)))

    def _exponential(self, op: str, argument: Node) -> int:
        p, e = self.prime, 1
        if self._moves(argument):
            if self.values[argument]:
                generator, sign = self._signed("exponent", self.values[argument])
                e = pow(generator, sign, p)
        else:
            for monomial, k in self._argument(argument).items():
                if not all(self._at(factor) for factor, _ in monomial):
                    continue
                denominator = self._denominator("exponent", monomial)
                if denominator == 1 and _is_atom(monomial) and self.graph.op[monomial[0][0]] == "log":
                    e = e * self._power(self._at(self.graph.a[monomial[0][0]]), int(k)) % p
                    continue
                generator, sign = self._monomial("exponent", monomial)
                e = e * pow(generator, sign * int(k * denominator), p) % p
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
            return self._root(x)
        if op == "sign":
            return self._sign(x, g.a[node])
        if op == "abs":
            return x * self._sign(x, g.a[node]) % p
        if op in ("min", "max"):
            y = self.values[g.b[node]]
            distance = (x - y) * self._sign((x - y) % p, g.a[node], g.b[node]) % p
            return (x + y + (distance if op == "max" else -distance)) * ((p + 1) // 2) % p
        if op in ("asin", "acos"):
            generator, sign = self._signed("asin", x)
            value = generator * sign if x else 0
            return value % p if op == "asin" else (self._at(g.pi()) * ((p + 1) // 2) - value) % p
        if op == "powf":
            return self._root_power(x, g.b[node])
        if op == "atan2":
            return self._generator(op, x, self.values[g.b[node]])
        return self._generator(op, x)

    def _sign(self, x: int, first: Node, second: Node | None = None) -> int:
        """+1 or -1, odd in x, the value of a node or of the difference of two; of a constant its own.

        Positive factors say nothing: some large ones are no squares, and would turn the signs of all values at once.
        """
        g, p = self.graph, self.prime
        if x == 0:
            return 0
        if not g.deps[first] and (second is None or not g.deps[second]):
            known = sign_of_constant(g, first, second)
            if known:
                return known % p
        size = leading_size(self._argument(first), {} if second is None else self._argument(second))
        return 1 if pow(x * size.numerator * size.denominator, (p - 1) // 2, p) == 1 else p - 1

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
                base, root = self._root(base), root // 2
            result = result * pow(base, k.numerator * pow(root, -1, p - 1) if root > 1 else k.numerator, p) % p
        return result
