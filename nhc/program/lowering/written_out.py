"""A symmetric dense solve written out as L D L^T, for languages that can fall back to exchanges of rows.

The masses come first, then the multipliers: where the mass matrix is positive definite, the pivots of the former are positive and
those of the latter negative whatever the order (Vanderbei, SIAM J. Optim. 5 (1995) 100-113), and no exchange is needed.  Of
either kind the next is the one with the fewest entries beside it.  The same entries are solved with exchanges where a pivot has
another sign or has lost its digits, and where one of the masses would be so much faster without reactions that its acceleration,
which is a difference then, has lost its own: a light wheel on a heavy cart.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterable, Sequence
from dataclasses import replace
from fractions import Fraction

from nhc.program.contents import walk
from nhc.program.ir import Binary, Expr, Let, Negate, Number, Ref, Solve
from nhc.records import record

MOST = 2000
"""Operations that are written out at most: compilers take long over more."""
DIGITS = Number(Fraction(1, 10**6))
"""The part of a pivot's first value that must be left; of the square of an acceleration without reactions too: three digits."""

LEAST = Number(-Fraction(10**300))
"""No pivot of a multiplier is below: an infinite one would leave its constraint out, and all that is found would be finite."""

_ZERO, _ONE = Number(Fraction(0)), Number(Fraction(1))

Pair = tuple[int, int]


@record
class Test:
    """``left relation right``; the relation is one of ``< > <=``."""

    left: Expr
    relation: str
    right: Expr


@record
class WrittenOut:
    """``lets`` bind the unknowns, and temporaries called ``prefix:number``, which no spec can; good where all ``tests`` hold.

    ``solve`` is the system, its entries as names, for an elimination with exchanges where they do not.
    """

    solve: Solve
    lets: tuple[Let, ...]
    tests: tuple[Test, ...]


def write_out(solve: Solve, used: Container[str]) -> WrittenOut | None:
    """The solve without exchanges; None where it is long or not symmetric.  Of the unknowns only those ``used`` get their names."""
    order = choose_order(solve)
    return None if order is None else _Elimination(solve, order, used).write()


def choose_order(solve: Solve) -> list[int] | None:
    """The unknowns in the order of their elimination; None where the solve is not one for this."""
    size, matrix = len(solve.matrix), solve.matrix
    if len(solve.columns) != 1 or any(matrix[i][i] == _ZERO for i in range(solve.masses)):
        return None
    if any(matrix[i][j] != matrix[j][i] for i in range(size) for j in range(i)):
        return None
    beside = [{j for j in range(size) if j != i and matrix[i][j] != _ZERO} for i in range(size)]
    order: list[int] = []
    work = 0
    for kind in (range(solve.masses), range(solve.masses, size)):
        left = set(kind)
        while left:
            k = min(left, key=lambda i: (len(beside[i]), i))
            left.remove(k)
            order.append(k)
            near = beside[k]
            work += 1 + len(near) * (len(near) + 7)
            for i in near:
                beside[i] = (beside[i] | near) - {i, k}
    return order if work <= MOST else None


class _Elimination:
    """One solve's lets, as they come."""

    def __init__(self, solve: Solve, order: list[int], used: Container[str]) -> None:
        self.solve, self.order, self.used = solve, order, used
        self.lets: list[Let] = []
        self.numbers: Counter[str] = Counter()
        self.entries: dict[Pair, Expr] = {}
        for i, row in enumerate(solve.matrix):
            self.entries |= {(i, j): self._name("entry", row[j]) for j in range(i, len(row)) if row[j] != _ZERO}
        self.right = [self._name("entry", x) for x in solve.columns[0]]

    def _name(self, prefix: str, value: Expr) -> Expr:
        """The value itself where it is short, else a new name for it."""
        if isinstance(value, Number | Ref) or (isinstance(value, Negate) and isinstance(value.operand, Ref)):
            return value
        self.numbers[prefix] += 1
        self.lets.append(Let(f"{prefix}:{self.numbers[prefix]}", value))
        return Ref(self.lets[-1].name)

    def _list_named(self) -> Solve:
        """The system with the names of its entries."""
        size = range(len(self.right))
        matrix = tuple(tuple(self.entries.get(_pair(i, j), _ZERO) for j in size) for i in size)
        return replace(self.solve, matrix=matrix, columns=(tuple(self.right),))

    def write(self) -> WrittenOut:
        """Eliminate and find the unknowns."""
        named, now, right = self._list_named(), dict(self.entries), list(self.right)
        first: dict[int, Expr] = {}
        tests: list[Test] = []
        factors: dict[int, list[tuple[int, Expr]]] = {}
        inverses: dict[int, Expr] = {}
        known: dict[Expr, Expr] = {}  # the same by the pivot: masses are often equal
        for number, k in enumerate(self.order):
            if number in (0, self.solve.masses):
                first = {i: now.get((i, i), _ZERO) for i in self.order[number:]}
            pivot = now.get((k, k), _ZERO)
            bound = _ZERO if pivot == first[k] else Binary("*", DIGITS, first[k])
            tests.append(Test(pivot, ">" if number < self.solve.masses else "<", bound))
            if number >= self.solve.masses and bound == _ZERO:
                tests.append(Test(pivot, ">", LEAST))
            later = [i for i in self.order[number + 1 :] if _pair(i, k) in now]
            if pivot not in known and (later or right[k] != _ZERO):
                known[pivot] = self._name("inverse", Binary("/", _ONE, pivot))
            inverses[k] = known.get(pivot, _ZERO)  # which nothing is multiplied by then
            factors[k] = [(i, self._name("factor", multiply(now[_pair(i, k)], inverses[k]))) for i in later]
            for i, factor in factors[k]:
                for j in later[later.index(i) :]:
                    less = subtract(now.get(_pair(i, j), _ZERO), multiply(factor, now[_pair(j, k)]))
                    now[_pair(i, j)] = self._name("rest", less)
                right[i] = self._name("rest", subtract(right[i], multiply(factor, right[k])))
        values = dict[int, Expr]()
        held = {row.index(entry) for row in named.matrix[self.solve.masses :] for entry in _single(row)}
        for k in reversed(self.order):
            own = value = self._name("free", multiply(right[k], inverses[k]))
            for i, factor in factors[k]:
                value = subtract(value, multiply(factor, values[i]))
            name = self.solve.names[0][k]
            if name in self.used:
                self.lets.append(Let(name, value))
                values[k] = Ref(name)
            else:
                values[k] = self._name("unknown", value)
            # what a row holds alone may well be at rest
            if k < self.solve.masses and factors[k] and own != _ZERO and k not in held:
                tests.append(Test(multiply(DIGITS, multiply(own, own)), "<=", multiply(values[k], values[k])))
        return WrittenOut(named, self._list_needed(named, tests), tuple(dict.fromkeys(tests)))

    def _list_needed(self, named: Solve, tests: Sequence[Test]) -> tuple[Let, ...]:
        """The lets without those that nothing uses: an acceleration that is not asked for, and not tested either."""
        read = [x for test in tests for x in (test.left, test.right)]
        needed = _list_names([*read, *(entry for row in named.matrix + named.columns for entry in row)])
        kept = []
        for let in reversed(self.lets):
            if let.name in needed or let.name in self.used:
                kept.append(let)
                needed |= _list_names([let.value])
        return tuple(reversed(kept))


def _list_names(expressions: Iterable[Expr]) -> set[str]:
    return {part.name for expression in expressions for part in walk(expression) if isinstance(part, Ref)}


def _single(row: Sequence[Expr]) -> list[Expr]:
    """The entry that is not zero, where there is but one."""
    found = [entry for entry in row if entry != _ZERO]
    return found if len(found) == 1 else []


def _pair(i: int, j: int) -> Pair:
    return (i, j) if i < j else (j, i)


def negate(value: Expr) -> Expr:
    """-value; signs do not pile up."""
    if isinstance(value, Number):
        return Number(-value.value)
    return value.operand if isinstance(value, Negate) else Negate(value)


def multiply(a: Expr, b: Expr) -> Expr:
    """a*b with its sign in front; a factor of 0 or 1 is not written."""
    if _ZERO in (a, b):
        return _ZERO
    negative = _is_negative(a) != _is_negative(b)
    a, b = (negate(x) if _is_negative(x) else x for x in (a, b))
    product = b if a == _ONE else a if b == _ONE else Binary("*", a, b)
    return negate(product) if negative else product


def subtract(a: Expr, b: Expr) -> Expr:
    """a - b; zero is not written, and minus a negative one is plus."""
    if b == _ZERO:
        return a
    if a == _ZERO:
        return negate(b)
    return Binary("+", a, negate(b)) if _is_negative(b) else Binary("-", a, b)


def _is_negative(value: Expr) -> bool:
    return isinstance(value, Negate) or (isinstance(value, Number) and value.value < 0)
