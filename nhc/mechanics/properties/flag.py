"""The growth vector of a distribution: ranks of D_1 = span(fields), D_{k+1} = D_k + [D_1, D_k] at a generic point.

No bracket is written down.  Along a path with dx/ds = sum of w_i(s) X_i(x), vectors V(x(s)) carried back to its start are the
Chen series of the brackets [X_i, [X_j, ... V]] there (K.-T. Chen, Bull. Amer. Math. Soc. 83 (1977), 831-879).  The coefficient of
s^k is a sum of brackets with r = k, k - 1, ... fields in front of V: each power of s that a weight brings stands for a field that
is not there.  Fields are counted by the power of z and the *missing* ones by that of e, s^k = z^r e^(k-r), so that what belongs to
z^r lies in D_{r+1}.  Weights that are random series make these vectors span D_{r+1} as the powers of e grow; where one generic
field G leads to all brackets, as ad_G^r V, e^0 is enough.

Whether it is enough is known by a bound (no more brackets of r + 1 fields are independent in any Lie algebra), or else by one more
bracket [U, W] of a random U in D_1 with a random sum W of the vectors of D_r.  It is bilinear: if it lies in what was found, with a
probability of 1 - 2/p all of [D_1, D_r] does.  The start of the path is moved along U for it, by a variable whose square is zero.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from functools import cache, cached_property
from itertools import islice
from operator import mul

from nhc.algebra.calculus import tangent
from nhc.algebra.dense import Echelon, extend_echelon, pack, unpack
from nhc.algebra.exact.draw import MOST_DRAWS, draw_points
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.jets import WIDTH, Jets, Series, make_box, plan_jets
from nhc.algebra.exact.modular import enough_points
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.graph import Graph, Node
from nhc.algebra.walks import reachable
from nhc.mechanics.properties.backwards import Backwards, Sweep
from nhc.mechanics.properties.forwards import Forwards

Field = tuple[Node, ...]
Vector = list[int]
Combination = tuple[Field, Sequence[Node]]
"""The sum of symbols times fields, and these symbols."""

_MOST_POINTS = 12
_FIRST_SEED = 9_000_011
_LONG = 4
_MOST_MISSING = 8  # times the number of variables: no system that was met needed a tenth of it


def growth_vector(
    graph: Graph,
    variables: Sequence[Node],
    fields: Sequence[Field],
    settle: Callable[[FieldPoint], object] | None = None,
    combination: Combination | None = None,
) -> tuple[int, ...]:
    """The ranks until they stop growing or fill the space; of several points, where signs occur, the largest.

    ``settle`` puts a point on a leaf that the fields do not leave.  ``combination``: a shorter way to write them.

    One point is enough but where signs occur (the root of a square), which may be the wrong ones at every second point.
    """
    flag = _Flag(graph, variables, fields, combination)
    found: list[tuple[int, ...]] = []
    count = min(_MOST_POINTS, enough_points(graph, flag.nodes))
    seeds = range(_FIRST_SEED, _FIRST_SEED + MOST_DRAWS)
    for _, point in draw_points(graph, flag.plan.nodes, primes_of(graph)[0], seeds, settle=settle):
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


def terminal_rank(
    graph: Graph,
    variables: Sequence[Node],
    fields: Sequence[Field],
    settle: Callable[[FieldPoint], object] | None = None,
    combination: Combination | None = None,
) -> int:
    """The last rank of the growth vector; the others are not asked for where the brackets of one path fill the space."""
    path = Forwards(graph, variables, fields, _mix(graph, fields, combination)[0])
    seeds = range(_FIRST_SEED, _FIRST_SEED + MOST_DRAWS)
    for _, point in islice(draw_points(graph, path.plan.nodes, primes_of(graph)[0], seeds, settle=settle), 1):
        try:
            if path.fills(point):
                return len(variables)
        except Unlucky:
            continue
    return growth_vector(graph, variables, fields, settle, combination)[-1]


@cache
def most_brackets(letters: int, length: int) -> int:
    """Independent brackets of ``length`` letters in the free Lie algebra (Witt 1937): letters^n = sum of d times those of d | n."""
    inner: int = sum(d * most_brackets(letters, d) for d in range(1, length) if length % d == 0)
    return int(letters**length - inner) // length


def _mix(
    graph: Graph, fields: Sequence[Field], combination: Combination | None
) -> tuple[tuple[Node, ...], tuple[Node, ...]]:
    """The fields' combination and its weights."""
    if combination is not None:
        return tuple(combination[0]), tuple(combination[1])
    weights = tuple(graph.symbol(f"weight {k}", "other") for k in range(len(fields)))
    return tuple(graph.dot(weights, column) for column in zip(*fields, strict=True)), weights


class _Flag:
    """The fields, their combination with weights, and its Jacobian matrix."""

    def __init__(
        self, graph: Graph, variables: Sequence[Node], fields: Sequence[Field], combination: Combination | None
    ) -> None:
        self.variables, self.fields = tuple(variables), tuple(fields)
        self.mixed, self.weights = _mix(graph, fields, combination)
        self.nodes = [x for field in (*fields, self.mixed) for x in field]
        self.backwards = Backwards(graph, self.mixed, self.variables)
        self.plan = plan_jets(graph, [*self.nodes, *self.backwards.factors], (*self.variables, *self.weights))
        self.graph, self.moving = graph, graph.mask((*self.variables, *self.weights))

    @cached_property
    def slopes(self) -> list[list[tuple[int, Node]]]:
        """The Jacobian matrix by column, each its entries that are not zero."""
        g = self.graph
        columns = [tangent(g, self.mixed, {variable: g.one}) for variable in self.variables]
        return [[(c, entry) for c, entry in enumerate(column) if entry != g.zero] for column in columns]

    @cached_property
    def weighted(self) -> list[Node]:
        """What depends on the weights, in the order of its making."""
        g, mask, given = self.graph, self.graph.mask(self.weights), set(self.weights)
        entries = [entry for column in self.slopes for _, entry in column]
        nodes = reachable(g, [*self.plan.nodes, *entries])
        return [node for node in nodes if g.deps[node] & mask and node not in given]

    def ranks(self, point: FieldPoint) -> tuple[int, ...]:
        """The growth vector at a point.

        Raises:
            Unlucky: it lies on a pole.
        """
        missing = 0
        while missing <= _MOST_MISSING * len(self.variables):
            found, enough = self._try(_Path(self, point, missing, probed=False))
            if not enough and not self._seems_free(found, missing):
                found, enough = self._try(_Path(self, point, missing, probed=True))
            if enough:
                return found
            missing = self._more(found, missing)
        raise Unlucky

    def _seems_free(self, ranks: Sequence[int], missing: int) -> bool:
        """Whether all brackets were independent for long, and the path is too poor to show more of them."""
        letters, length = len(self.fields), len(ranks) + 1
        wanted = min(len(self.variables) - ranks[-1], most_brackets(letters, length))
        return length > _LONG and (missing + 1) * (letters - 1) < wanted

    def _more(self, ranks: Sequence[int], missing: int) -> int:
        """How many powers of e to try next, after these ranks were found in full.

        Of the vectors that belong to one power all but one may be new, for the combination of the fields that leads along the path
        has no bracket with itself.
        """
        letters, size = len(self.fields), len(self.variables)
        if self._seems_free(ranks, missing):
            length, known = len(ranks), ranks[-1]
            wanted = 0
            while known < size:
                length += 1
                wanted = max(wanted, min(size - known, most_brackets(letters, length)))
                known += most_brackets(letters, length)
            return -(-wanted // (letters - 1))
        before = ranks[-2] if len(ranks) > 1 else 0
        wanted = min(size - ranks[-1], letters * (ranks[-1] - before))
        return max(missing + 1, min(2 * missing + 1, -(-wanted // max(letters - 1, 1))))

    def _try(self, path: _Path) -> tuple[tuple[int, ...], bool]:
        """The ranks that a path shows, and whether they are all there is."""
        size, p = len(self.variables), path.prime
        rows: Echelon = []
        ranks: list[int] = []
        bound, probe = 0, None
        while not ranks or ranks[-1] < size:
            for vector in path.vectors():
                if len(rows) < size:
                    extend_echelon(rows, vector, p)
            bound += most_brackets(len(self.fields), len(ranks) + 1)
            if path.probed:
                if probe is not None and extend_echelon(rows, probe, p):
                    return tuple(ranks), False
                probe = path.probe()
            elif ranks and len(rows) < min(size, bound):
                return tuple(ranks), False
            if ranks and len(rows) == ranks[-1]:
                break
            ranks.append(len(rows))
            if ranks[-1] < size:
                path.extend()
        return tuple(ranks), True


class _Path:
    """The start of a random path, moved along a random U where it is ``probed``, with up to ``missing`` powers of e.

    Series are by monomial e^j (then, probed, those times the small variable) and power of z.  ``back[c]`` are those of the column c
    of the matrix that carries vectors back to the start; a number holds its rows one after another, so that a product with a
    residue is that of all of them (Kronecker 1882).
    """

    def __init__(self, flag: _Flag, point: FieldPoint, missing: int, *, probed: bool) -> None:
        self.flag, self.prime, self.probed, self.missing = flag, point.prime, probed, missing
        self.draw = random.Random(f"path {missing} {probed}")
        self.box = make_box((missing, 1) if probed else (missing,))
        monomials = range(len(self.box.parts))
        place: list[Series] = [[[x if i == 0 else 0] for i in monomials] for x in point.evaluate(flag.variables)]
        own = point.evaluate(flag.weights)
        later = [[self.draw.randrange(self.prime) for _ in range(missing)] for _ in own]
        if probed:
            self.turn = self._turn(point, own)
            for series, speed in zip(place, point.evaluate(flag.mixed), strict=True):
                series[missing + 1] = [speed]
            self._weigh(point, own)
        weights: list[Series] = [
            [[x] for x in (w, *more, *([0] * (missing + 1 if probed else 0)))]
            for w, more in zip(own, later, strict=True)
        ]
        self.place, self.weights = place, weights
        self.jets = Jets(flag.plan, point, [*place, *weights], self.box)
        self.jets.extend(0)
        self.back: list[Series] = [
            [[1 << 8 * WIDTH * c if i == 0 else 0] for i in monomials] for c in range(len(place))
        ]
        self.sweep = Sweep(flag.backwards, self.jets, self.back, self.box, flag.moving)
        self.newest: list[list[Vector]] = []

    def _weigh(self, point: FieldPoint, weights: Vector) -> None:
        point.evaluate([], dict(zip(self.flag.weights, weights, strict=True)))
        entries = [entry for column in self.flag.slopes for _, entry in column]
        point.evaluate(entries)
        point.fill(self.flag.weighted)

    def _turn(self, point: FieldPoint, own: Vector) -> list[list[tuple[int, int]]]:
        """Make the mixed field U at the point; its Jacobian matrix by column, each its entries that are not zero."""
        self._weigh(point, [self.draw.randrange(self.prime) for _ in own])
        return [[(row, point.values[entry]) for row, entry in column] for column in self.flag.slopes]

    def extend(self) -> None:
        """By one power of z."""
        p, series, made = self.prime, self.jets.series, len(self.place[0][0])
        counts = [made + i % (self.missing + 1) for i in range(len(self.box.parts))]  # the power of s
        scales = [pow(count, -1, p) for count in counts]
        carried = self.sweep.extend(made - 1)
        for own, new in zip(self.back, carried, strict=True):
            for powers, rows, scale in zip(own, new, scales, strict=True):
                powers.append(pack([-x * scale % p for x in rows], WIDTH) if rows else 0)
        for own, node in zip(self.place, self.flag.mixed, strict=True):
            for powers, slope, scale in zip(own, series[node], scales, strict=True):
                powers.append(slope[made - 1] * scale % p)
        for own in self.weights:
            for powers in own:
                powers.append(0)
        self.jets.extend(made)

    def _carry(self, column: Sequence[tuple[int, Node]]) -> list[Vector]:
        """The newest coefficients of the matrix ``back`` times a column, by monomial and row."""
        series = self.jets.series
        known = [(self.back[c], series[entry]) for c, entry in column]
        last, size = len(self.place[0][0]) - 1, len(self.place)
        found = []
        for pairs in self.box.parts:
            total = sum(sum(map(mul, x[i], y[j][last::-1])) for x, y in known for i, j in pairs)
            found.append(unpack(total, size, WIDTH) if total else [])
        return found

    def vectors(self) -> list[Vector]:
        """What belongs to the newest power of z, carried back to the start, by field and power of e."""
        p = self.prime
        self.newest = []
        for field in self.flag.fields:
            carried = self._carry(list(enumerate(field)))
            self.newest.append([[x % p for x in rows] or [0] * len(self.place) for rows in carried])
        return [vector for found in self.newest for vector in found[: self.missing + 1]]

    def probe(self) -> Vector:
        """[U, W] for a random sum W of the newest vectors."""
        p, size = self.prime, len(self.place)
        total, moved = [0] * size, [0] * size
        for found in self.newest:
            for vector, change in zip(found[: self.missing + 1], found[self.missing + 1 :], strict=True):
                factor = self.draw.randrange(p)
                total = [(x + factor * y) % p for x, y in zip(total, vector, strict=True)]
                moved = [(x + factor * y) % p for x, y in zip(moved, change, strict=True)]
        for column, x in zip(self.turn, total, strict=True):
            for row, entry in column:
                moved[row] = (moved[row] - entry * x) % p
        return moved
