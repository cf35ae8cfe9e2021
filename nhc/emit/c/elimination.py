"""A symmetric dense solve written out as L D L^T, for the right-hand side: with exchanges it takes several times as long.

The masses come first, then the multipliers: where the mass matrix is positive definite, the pivots of the former are positive and
those of the latter negative whatever the order (Vanderbei, SIAM J. Optim. 5 (1995) 100-113), and no exchange is needed.  Of
either kind the next is the one with the fewest entries beside it.  The same entries are solved with exchanges where a pivot has
another sign or has lost its digits, and where the masses would be so much faster without reactions that their accelerations,
which are differences then, have lost theirs: a light wheel on a heavy cart.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from nhc.emit.statements import ZERO
from nhc.program.ir import Expr, Number, Solve

if TYPE_CHECKING:
    from nhc.emit.c.body import BodyPrinter

MOST = 2000
"""Operations that are written out at most: compilers take long over more."""
DIGITS = "1e-6"
"""The part of a pivot's first value that must be left; of the squares of the accelerations without reactions too: three digits."""

Pair = tuple[int, int]


def choose_order(solve: Solve) -> list[int] | None:
    """The unknowns in the order of their elimination; None where the solve is not one for this."""
    size, matrix = len(solve.matrix), solve.matrix
    if len(solve.columns) != 1 or any(matrix[i][i] == ZERO for i in range(solve.masses)):
        return None
    if any(matrix[i][j] != matrix[j][i] for i in range(size) for j in range(i)):
        return None
    beside = [{j for j in range(size) if j != i and matrix[i][j] != ZERO} for i in range(size)]
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


class Elimination:
    """Writes one solve into a printer."""

    def __init__(self, printer: BodyPrinter, solve: Solve, order: list[int]) -> None:
        self.printer, self.solve, self.order = printer, solve, order
        self.entries: dict[Pair, str] = {}
        for i, row in enumerate(solve.matrix):
            self.entries |= {(i, j): self._name(row[j]) for j in range(i, len(row)) if row[j] != ZERO}
        self.right = [self._name(x) for x in solve.columns[0]]

    def list_entries(self) -> list[str]:
        """The matrix beside its right side, row by row."""
        size = len(self.right)
        return [
            text
            for i in range(size)
            for text in (*(self.entries.get(_pair(i, j), "0.0") for j in range(size)), self.right[i])
        ]

    def _name(self, entry: Expr) -> str:
        """The entry itself where it is short, else a new name."""
        text = self.printer.printer.print(entry)
        return text if isinstance(entry, Number) or _is_name(text) else self._let("entry", text)

    def _let(self, prefix: str, text: str) -> str:
        name = self.printer.scope.fresh(prefix)
        self.printer.add(f"const double {name} = {text};")
        return name

    def write(self) -> str:
        """Eliminate and find the unknowns; the condition under which they are good."""
        now, right = dict(self.entries), list(self.right)
        first: dict[int, str] = {}
        conditions: list[str] = []
        factors: dict[int, list[tuple[int, str]]] = {}
        inverses: dict[int, str] = {}
        named: dict[str, str] = {}  # the same by the pivot: masses are often equal
        for number, k in enumerate(self.order):
            if number in (0, self.solve.masses):
                first = {i: now.get((i, i), "0.0") for i in self.order[number:]}
            pivot = now.get((k, k), "0.0")
            sign = ">" if number < self.solve.masses else "<"
            conditions.append(f"{pivot} {sign} {'0.0' if pivot == first[k] else f'{DIGITS} * {first[k]}'}")
            later = [i for i in self.order[number + 1 :] if _pair(i, k) in now]
            if pivot not in named and (later or right[k] != "0.0"):
                named[pivot] = self._let("inverse", f"1.0 / {_factor(pivot)}")
            inverses[k] = named.get(pivot, "0.0")  # which nothing is multiplied by then
            factors[k] = [(i, self._times("factor", now[_pair(i, k)], inverses[k])) for i in later]
            for i, factor in factors[k]:
                for j in later[later.index(i) :]:
                    now[_pair(i, j)] = self._less(now.get(_pair(i, j), "0.0"), factor, now[_pair(j, k)])
                right[i] = self._less(right[i], factor, right[k])
        free, values = list[str](), dict[int, str]()
        for k in reversed(self.order):
            own = self._times("free", right[k], inverses[k])
            text = own
            for i, factor in factors[k]:
                text = _difference(text, _product(factor, values[i]))
            name = self.solve.names[0][k]
            if name in self.printer.used:
                values[k] = self.printer.scope[name]
                self.printer.add(f"double {values[k]} = {text};")
            else:
                values[k] = text if _is_name(text) or text == "0.0" else self._let("unknown", text)
            if k < self.solve.masses:
                free.append(own)
        moved = [values[k] for k in range(self.solve.masses)]
        conditions.append(f"{DIGITS} * {_squares(free)} <= {_squares(moved)}")
        return " && ".join(dict.fromkeys(conditions))

    def _times(self, prefix: str, a: str, b: str) -> str:
        text = _product(a, b)
        return text if _is_name(text) or text == "0.0" else self._let(prefix, text)

    def _less(self, value: str, factor: str, other: str) -> str:
        text = _difference(value, _product(factor, other))
        return text if _is_name(text) or text == "0.0" else self._let("rest", text)


def _squares(texts: list[str]) -> str:
    """The sum of the squares, in brackets."""
    bare = [text.removeprefix("-") for text in texts if text != "0.0"]
    return f"({' + '.join(f'{text} * {text}' for text in bare) or '0.0'})"


def _is_name(text: str) -> bool:
    return text.removeprefix("-").isidentifier()


def _pair(i: int, j: int) -> Pair:
    return (i, j) if i < j else (j, i)


def _negate(text: str) -> str:
    return text[1:] if text.startswith("-") else f"-{text}"


def _factor(text: str) -> str:
    return f"({text})" if text.startswith("-") else text


def _product(a: str, b: str) -> str:
    """Of two names or numbers; one that is 0 or +-1 is not written."""
    if "0.0" in (a, b):
        return "0.0"
    sign = "-" if a.startswith("-") != b.startswith("-") else ""
    a, b = a.lstrip("-"), b.lstrip("-")
    if "1.0" in (a, b):
        return sign + (b if a == "1.0" else a)
    return f"{sign}{a} * {b}"


def _difference(a: str, b: str) -> str:
    if b == "0.0":
        return a
    if a == "0.0":
        return _negate(b)
    return f"{a} + {b[1:]}" if b.startswith("-") else f"{a} - {b}"
