"""The growth vector of a distribution: ranks of D_1 = span(fields), D_{k+1} = D_k + [D_1, D_k] at a generic point.

No bracket is written down.  The one of X with V is the derivative of V, carried back, along the flow of X (R. Abraham, J. E.
Marsden and T. Ratiu, Manifolds, Tensor Analysis, and Applications, 2nd ed. (1988), thm. 4.2.19), so [X_1, [X_2, ... [X_r, V]]] at a
point is read off the Taylor coefficients of the fields where the flows lead from it.  One field is replaced by a random combination
G of all: nearly all brackets that are needed are then ad_G^k, and one curve gives them for every k.  Each run of
another field costs a variable (:mod:`nhc.algebra.exact.jets`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import mul

from nhc.algebra.calculus import tangent
from nhc.algebra.dense import Echelon, extend_echelon
from nhc.algebra.exact.draw import MOST_DRAWS, draw_points
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.jets import JetPlan, Jets, Series, make_box, plan_jets
from nhc.algebra.exact.modular import enough_points
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.graph import Graph, Node
from nhc.records import record

Field = tuple[Node, ...]
Vector = list[int]

_Matrix = list[list[tuple[int, list[int]]]]
"""Rows of entries that are not zero: column, packed series by monomial."""

_MOST_POINTS = 12
_FIRST_SEED = 9_000_011
_BYTES = 20  # of a coefficient of a product: two residues of 61 bits, summed over powers, components and monomials


@record
class Word:
    """ad_X^e ... ad_G^power X_base by runs of (number of X, e), the outermost first; number 0 is G."""

    runs: tuple[tuple[int, int], ...]
    power: int
    base: int

    def under(self, letter: int) -> Word:
        """The bracket of a field with it."""
        if self.runs and self.runs[0][0] == letter:
            return Word(((letter, self.runs[0][1] + 1), *self.runs[1:]), self.power, self.base)
        if not letter and not self.runs:
            return Word((), self.power + 1, self.base)
        return Word(((letter, 1), *self.runs), self.power, self.base)


def growth_vector(
    graph: Graph,
    variables: Sequence[Node],
    fields: Sequence[Field],
    settle: Callable[[FieldPoint], object] | None = None,
) -> tuple[int, ...]:
    """The ranks until they stop growing or fill the space; of several points, where signs occur, the largest.

    ``settle`` puts a point on a leaf that the fields do not leave.

    One point is enough but where signs occur (the root of a square), which may be the wrong ones at every second point.
    """
    flag = _Flag(graph, variables, fields)
    found: list[tuple[int, ...]] = []
    count = min(_MOST_POINTS, enough_points(graph, flag.nodes, 1))
    seeds = range(_FIRST_SEED, _FIRST_SEED + MOST_DRAWS)
    for _, point in draw_points(graph, flag.closed, primes_of(graph)[0], seeds, settle=settle):
        try:
            found.append(flag.ranks(point))
        except Unlucky:
            continue
        if len(found) == count:
            break
    if not found:
        raise Unlucky
    length = max(map(len, found))
    return tuple(max(ranks[min(k, len(ranks) - 1)] for ranks in found) for k in range(length))


class _Flag:
    """The fields with G in the first one's place, and their Jacobian matrices."""

    def __init__(self, graph: Graph, variables: Sequence[Node], fields: Sequence[Field]) -> None:
        self.graph, self.variables = graph, tuple(variables)
        weights = [graph.symbol(f"weight {k}", "other") for k in range(len(fields))]
        mixed = tuple(graph.dot(weights, column) for column in zip(*fields, strict=True))
        self.fields = (mixed, *fields[1:])
        self.slopes = [self._differentiate(field) for field in self.fields]
        self.nodes = [x for field in self.fields for x in field]
        entries = [[x for row in rows for _, x in row] for rows in self.slopes]
        self.steps = [
            plan_jets(graph, [*field, *own], self.variables) for field, own in zip(self.fields, entries, strict=True)
        ]
        self.flow = plan_jets(graph, [*self.nodes, *entries[0]], self.variables)
        self.closed = [node for plan in (self.flow, *self.steps) for node in plan.nodes]

    def _differentiate(self, field: Field) -> list[list[tuple[int, Node]]]:
        """The rows of the Jacobian matrix, each as its entries that are not zero."""
        g = self.graph
        columns = [tangent(g, field, {variable: g.one}) for variable in self.variables]
        return [[(b, entry) for b, entry in enumerate(row) if entry != g.zero] for row in zip(*columns, strict=True)]

    def ranks(self, point: FieldPoint) -> tuple[int, ...]:
        """The growth vector at a point.

        Raises:
            Unlucky: it lies on a pole.
        """
        brackets = _Brackets(self, point)
        size, p = len(self.variables), point.prime
        rows: Echelon = []
        newest = [
            Word((), 0, j) for j in range(len(self.fields)) if extend_echelon(rows, brackets.value(Word((), 0, j)), p)
        ]
        letters = [word.base for word in newest]
        ranks = [len(rows)]
        while ranks[-1] < size:
            grown = []
            for letter in letters:
                for word in newest:
                    if word == Word((), 0, letter):
                        continue
                    bracket = word.under(letter)
                    if len(rows) < size and extend_echelon(rows, brackets.value(bracket), p):
                        grown.append(bracket)
            if not grown:
                break
            ranks.append(len(rows))
            newest = grown
        return tuple(ranks)


class _Brackets:
    """Values of words at one point; those that differ in the length of the first run, the power of G and the base at once."""

    def __init__(self, flag: _Flag, point: FieldPoint) -> None:
        self.flag, self.point, self.prime = flag, point, point.prime
        self.start = point.evaluate(flag.variables)
        self.longest = len(self.start) - len(flag.fields) + 1
        self._known: dict[tuple[object, ...], list[list[list[Vector]]]] = {}

    def value(self, word: Word) -> Vector:
        """Components modulo the prime."""
        letter, length = word.runs[0] if word.runs else (0, 0)
        key = (letter, *word.runs[1:]) if word.runs else ()
        known = self._known.get(key, [])
        if len(known) <= length or len(known[0]) <= word.power:
            power = max(word.power, len(known[0]) - 1 if known else 0)
            if known and word.power == len(known[0]):  # farther at once, lest each step be a new start
                power = min(2 * power, max(power, self.longest))
            runs = ((letter, max(length, len(known) - 1)), *word.runs[1:]) if word.runs else ()
            known = self._known[key] = self._compute(runs, power)
        return known[length][word.power][word.base]

    def _compute(self, runs: Sequence[tuple[int, int]], order: int) -> list[list[list[Vector]]]:
        """By length of the first run, power of G and base."""
        flag = self.flag
        place: list[Series] = [[[x]] for x in self.start]
        lengths: tuple[int, ...] = ()
        turns = []
        for letter, length in runs:
            jets = self._move(flag.steps[letter], letter, place, lengths, length)
            turns.append(self._read_slopes(jets, letter))
            place = [[[coefficients[k]] for k in range(length + 1) for coefficients in series] for series in place]
            lengths = (*lengths, length)
        jets = self._move(flag.flow, 0, place, lengths, order)
        vectors = [[jets.series[x] for x in field] for field in flag.fields]
        table = [self._carry(vectors, self._read_slopes(jets, 0), lengths, order)]
        for (_, length), turn in zip(reversed(runs), reversed(turns), strict=True):
            lengths = lengths[:-1]
            carried = [
                self._carry([self._fold(vector, length) for vector in bases], turn, lengths, length)
                for bases in table[0]
            ]
            table = [[powers[e] for powers in carried] for e in ((length,) if lengths else range(length + 1))]
        return [[[[x[0] for x in vector] for vector in bases] for bases in powers] for powers in table]

    def _move(self, plan: JetPlan, letter: int, place: list[Series], lengths: tuple[int, ...], order: int) -> Jets:
        """The plan's series along the flow of a field from the place, whose own series grow up to the order."""
        p, field = self.prime, self.flag.fields[letter]
        jets = Jets(plan, self.point, place, make_box(lengths))
        for k in range(order + 1):
            jets.extend(k)
            if k < order:
                scale = pow(k + 1, -1, p)
                for series, x in zip(place, field, strict=True):
                    for own, slope in zip(series, jets.series[x], strict=True):
                        own.append(slope[k] * scale % p)
        return jets

    def _read_slopes(self, jets: Jets, letter: int) -> _Matrix:
        return [[(b, [_pack(c) for c in jets.series[x]]) for b, x in row] for row in self.flag.slopes[letter]]

    def _fold(self, vector: list[list[int]], length: int) -> list[Series]:
        """Series in the last variable of the box in the place of s."""
        size = len(vector[0]) // (length + 1)
        return [[x[i::size] for i in range(size)] for x in vector]

    def _carry(
        self, vectors: list[list[Series]], matrix: _Matrix, lengths: tuple[int, ...], order: int
    ) -> list[list[list[list[int]]]]:
        """ad_X^e of the vectors, for e up to the order, where the flow of X starts: by e, vector, component and monomial."""
        parts, found = make_box(lengths).parts, []
        for left in range(order, -1, -1):
            found.append([[[c[0] for c in x] for x in vector] for vector in vectors])
            vectors = [self._carry_back(vector, matrix, parts, left) for vector in vectors] if left else []
        return found

    def _carry_back(
        self, vector: list[Series], matrix: _Matrix, parts: Sequence[Sequence[tuple[int, int]]], length: int
    ) -> list[Series]:
        """d vector/ds minus matrix times vector, the first ``length`` coefficients."""
        p = self.prime
        packed = [[_pack(c[:length]) for c in series] for series in vector]
        weights = range(1, length + 1)
        carried = []
        for series, row in zip(vector, matrix, strict=True):
            new = []
            for own, pairs in zip(series, parts, strict=True):
                total = sum(entry[i] * packed[b][j] for b, entry in row for i, j in pairs)
                slope = map(mul, weights, own[1:])
                new.append([(x - y) % p for x, y in zip(slope, _unpack(total, length), strict=True)])
            carried.append(new)
        return carried


def _pack(coefficients: Sequence[int]) -> int:
    """A polynomial as one number, whose products are those of the polynomials (Kronecker 1882)."""
    return int.from_bytes(b"".join([c.to_bytes(_BYTES, "little") for c in coefficients]), "little")


def _unpack(number: int, count: int) -> list[int]:
    """The first coefficients of a packed polynomial."""
    size = max(count * _BYTES, (number.bit_length() + 7) // 8)
    text = number.to_bytes(size, "little")
    return [int.from_bytes(text[k : k + _BYTES], "little") for k in range(0, count * _BYTES, _BYTES)]
