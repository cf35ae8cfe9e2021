"""Signs in expressions: what takes the wrong one of two values at every second point of a prime field.

A sign stands in sign, abs, min and max.  It hides in square roots, and in sines and cosines of inverse functions, which are
roots too: sqrt(x^2 y) is x sqrt(y) at every second point.  Roots of arguments that are independent modulo squares hide none:
they generate a field over the rational functions in which what is not zero has a norm that is not zero either.
Products of arguments that are squares are found by their quadratic characters at random points, by elimination modulo 2.

A function of k signs is a polynomial in them, linear in each; one of degree m that is not zero is so for at least 2**-m of
their values: the least distance of the codes of Reed and Muller (1954).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import islice

from nhc.algebra.exact.draw import QuickPoint, draw_points
from nhc.algebra.exact.field import INVERSE, FieldPoint, Unlucky
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.expand import TooLarge
from nhc.algebra.graph import ADD, MUL, NEG, POW, Graph, Node
from nhc.algebra.polynomial import ONE, polynomial
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable

STEPS = ("sign", "abs", "min", "max")
_HOLDERS = frozenset((*STEPS, "sqrt", "powf", *INVERSE))
_WAVES = ("sin", "cos")
_POINTS = 24  # for a sign and for none; a wrong answer is passed with probability e**-24
MOST = 6  # signs multiplied with each other: 1536 points
_SPARE = 24  # characters beyond the roots'
_DRAWS = 4000

Settle = Callable[[FieldPoint], object]
"""Gives the symbols that stand for something else their values at a point.

Raises:
    ArithmeticError, Unlucky: they have none there.
"""


def points_for(degree: int, count: int) -> int:
    """The number of random points for an exact test of something in which up to ``degree`` signs are multiplied.

    ``count`` points are enough without signs.
    """
    return max(count, _POINTS << degree) if degree else count


def may_hold(graph: Graph, nodes: Iterable[Node]) -> bool:
    """Whether signs or roots occur at all."""
    op = graph.op
    return any(op[node] in _HOLDERS for node in reachable(graph, nodes))


class Signs:
    """The signs in some expressions, and the degree of each node in them.

    ``settle`` puts points on the motion, where symbols of the mask ``later`` stand for something else: squares may show there only.
    ``changed`` are symbols one of which at a time is given another value, to be compared with the first.
    """

    def __init__(
        self,
        graph: Graph,
        roots: Sequence[Node],
        settle: Settle | None = None,
        later: int = 0,
        changed: Sequence[Node] = (),
    ) -> None:
        self.graph = graph
        self.arguments: list[tuple[Node, ...]] = []
        """What each sign is the sign of, as nodes; it cannot change where none of these does."""
        self.holders: list[list[Node]] = []
        """The nodes that bring each sign, of those whose degree was asked for."""
        self._keys: dict[tuple[object, ...], int] = {}
        self._known: dict[Node, tuple[int, int]] = {}
        found = [n for n in reachable(graph, roots) if graph.op[n] in _HOLDERS]
        radicals = self._radicals(found, roots)
        self._hidden = _dependent(graph, radicals, settle, later, changed)
        self._arguments_of_roots = tuple(dict.fromkeys(c for n in radicals for c in graph.children(n)))
        self._any = bool(self._hidden) or any(graph.op[n] in (*STEPS, "powf") for n in found)

    def degree(self, nodes: Sequence[Node]) -> int:
        """The largest degree of the nodes in the signs."""
        return self.mask_and_degree(nodes)[1]

    def mask_and_degree(self, nodes: Sequence[Node]) -> tuple[int, int]:
        """All signs in the nodes, and the largest degree."""
        if not self._any:
            return 0, 0
        for node in reachable(self.graph, nodes, known=self._known):
            self._known[node] = self._look(node)
        found = [self._known[node] for node in nodes]
        mask = 0
        for part, _ in found:
            mask |= part
        return mask, max((d for _, d in found), default=0)

    def stand(self, values: Mapping[Node, Node]) -> None:
        """Let symbols stand for nodes."""
        for symbol, node in values.items():
            self._known[symbol] = self.mask_and_degree([node])

    def solve(self, matrix: Sequence[Node], right: Sequence[Node], unknowns: Sequence[Node] = ()) -> tuple[int, int]:
        """All signs in the solution of linear equations, and its degree in them; the unknowns stand for it."""
        inner, outer = self.mask_and_degree(matrix), self.mask_and_degree(right)
        mask = inner[0] | outer[0]
        degree = mask.bit_count() if inner[0] else outer[1]
        self.put(unknowns, mask, degree)
        return mask, degree

    def put(self, symbols: Sequence[Node], mask: int, degree: int) -> None:
        """Let symbols hold these signs."""
        self._known.update(dict.fromkeys(symbols, (mask, degree)))

    def _look(self, node: Node) -> tuple[int, int]:
        g, op = self.graph, self.graph.op[node]
        below = [self._known[c] for c in g.children(node)]
        own, mask = self._own(op, node), 0
        for number in bits_of(own):
            self.holders[number].append(node)
        for part, _ in below:
            mask |= part
        if not own and not mask:
            return 0, 0
        if op == NEG:
            return below[0]
        if op == ADD:
            return mask, max(d for _, d in below)
        if op == MUL:
            return mask, min(mask.bit_count(), sum(d for _, d in below))
        if op == POW and g.b[node] > 0:
            return mask, min(mask.bit_count(), below[0][1] * g.b[node])
        mask |= own  # any function of k signs has a degree of at most k
        return mask, mask.bit_count()

    def _own(self, op: str, node: Node) -> int:
        """The signs that this node brings."""
        g = self.graph
        if op in ("sign", "abs"):
            argument = g.a[g.a[node]] if g.op[g.a[node]] == NEG else g.a[node]
            return self._bit(("sign", argument), (argument,))
        if op in ("min", "max"):
            pair = g.children(node)
            return self._bit(("difference", *sorted(pair)), tuple(pair))
        found = 0
        if node in self._hidden:  # the relation that makes it dependent may hold all roots
            found |= self._bit(("root", self._hidden[node]), (*g.children(node), *self._arguments_of_roots))
        for level in range(1, _halvings(g, node)):  # the characters tell of square roots only
            found |= self._bit(("root", node, level), tuple(g.children(node)))
        return found

    def _bit(self, key: tuple[object, ...], arguments: tuple[Node, ...]) -> int:
        number = self._keys.get(key)
        if number is None:
            number = self._keys[key] = len(self._keys)
            self.arguments.append(arguments)
            self.holders.append([])
        return 1 << number

    def _radicals(self, found: Sequence[Node], roots: Sequence[Node]) -> list[Node]:
        """What takes square roots of something that is no constant: those of constants are the same at all points."""
        g = self.graph
        inverse = [n for n in found if g.op[n] in INVERSE]
        turned = _inverse_in_angles(g, roots) if inverse else set[Node]()
        return [
            n
            for n in found
            if g.deps[n] and (g.op[n] == "sqrt" or n in turned or (g.op[n] == "powf" and _halvings(g, n)))
        ]


def bits_of(mask: int) -> list[int]:
    """The numbers of the signs in a mask."""
    return [k for k in range(mask.bit_length()) if mask >> k & 1]


def degree_in_signs(graph: Graph, nodes: Sequence[Node]) -> int:
    """The largest degree of the nodes in the signs that they hold."""
    return Signs(graph, nodes).degree(nodes) if may_hold(graph, nodes) else 0


def _halvings(graph: Graph, node: Node) -> int:
    """How many square roots a power with a broken exponent takes, one of the other."""
    if graph.op[node] != "powf":
        return 0
    try:
        constant = polynomial(graph, graph.b[node], limit=60, circle=False).get(ONE, 0)
    except TooLarge:
        return 0
    denominator = Fraction(constant).denominator
    return (denominator & -denominator).bit_length() - 1


def _inverse_in_angles(graph: Graph, roots: Sequence[Node]) -> set[Node]:
    """Inverse functions that are angles of sines and cosines, or terms of such."""
    waves = [n for n in reachable(graph, roots) if graph.op[n] in _WAVES]
    stack, seen = [graph.a[n] for n in waves], set[Node]()
    while stack:
        node = stack.pop()
        if node not in seen:
            seen.add(node)
            if graph.op[node] in (ADD, MUL, NEG, POW):
                stack += graph.children(node)
    return {node for node in seen if graph.op[node] in INVERSE}


# --- squares among products of radicands ------------------------------------------------------------------------


def _dependent(
    graph: Graph, radicals: Sequence[Node], settle: Settle | None, later: int, changed: Sequence[Node]
) -> Mapping[Node, Node]:
    """Roots whose radicand is a square times radicands of others, each with the first one of the same value.

    All roots, where too few points are found; without ``settle``, those that hold symbols of the mask.
    """
    if settle is not None:
        return _find_dependent(graph, radicals, settle, later)
    open_ = {n: n for n in radicals if graph.deps[n] & later}
    radicals = [n for n in radicals if n not in open_]
    known: dict[tuple[object, ...], Mapping[Node, Node]] = graph.memory.setdefault("hidden signs", {})
    key = tuple(radicals), tuple(changed)
    if key not in known:
        # sqrt(x^2 y) holds no sign, but where it is divided by its value at another x
        original = {n: n for n in radicals}
        for symbol in changed:
            moved = [n for n in radicals if graph.depends(n, graph.deps[symbol])]
            other = graph.symbol(f"other {symbol}", "other")
            for n, copy in zip(moved, substitute(graph, moved, {symbol: other}), strict=True):
                original.setdefault(copy, n)
        found = _find_dependent(graph, list(original), None, 0)
        known[key] = {original[n]: original[first] for n, first in reversed(list(found.items()))}
    return {**open_, **known[key]}


def _find_dependent(graph: Graph, radicals: Sequence[Node], settle: Settle | None, later: int) -> dict[Node, Node]:
    """Stage by stage: what stands inside other roots, or in the motion, has to exist for these, so that its character is known."""
    found: dict[Node, Node] = {}
    depth: dict[Node, tuple[bool, int]] = {}
    for node in sorted(radicals):
        inner = [depth[n] for n in reachable(graph, graph.children(node)) if n in depth]
        moves = bool(graph.deps[node] & later)
        depth[node] = moves, 1 + max([level for moved, level in inner if moved == moves], default=0)
    for stage in sorted(set(depth.values())):
        known = [n for n in radicals if depth[n] < stage]
        new = [n for n in radicals if depth[n] == stage]
        found.update(_find_new(graph, known, new, found, settle if stage[0] else None, later))
    return found


def _find_new(
    graph: Graph,
    known: Sequence[Node],
    new: Sequence[Node],
    hidden: Mapping[Node, Node],
    settle: Settle | None,
    later: int,
) -> dict[Node, Node]:
    """Those of the new roots that depend on known ones or on each other; also what equals one that is hidden."""
    radicals = [*known, *new]
    operands = [c for n in radicals for c in graph.children(n)]
    drawn = draw_points(
        graph, operands, primes_of(graph)[0], range(5_000_011, 5_000_011 + _DRAWS), later=later, kind=QuickPoint
    )
    first: dict[Node, Node] = {}  # by root the one of the first radicand of the same value
    distinct: list[Node] = []
    characters, seen, most = list[int](), 0, len(radicals) + _SPARE
    for _, point in islice(drawn, 4 * most):
        try:
            if settle is not None:
                settle(point)
            values = {node: _radicand(graph, point, node) for node in radicals}
        except (ArithmeticError, Unlucky):
            continue
        if not all(values.values()):
            continue
        if not first:
            owner = {values[node]: node for node in reversed(radicals)}
            first = {node: owner[value] for node, value in values.items()}
            distinct = list(dict.fromkeys(first.values()))
            characters, most = [0] * len(distinct), len(distinct) + _SPARE
        for k, node in enumerate(distinct):
            characters[k] |= (pow(values[node], (point.prime - 1) // 2, point.prime) != 1) << seen
        seen += 1
        if seen in (len(distinct) + 3, most):
            found = {distinct[k] for k in _reduce(characters, seen)} - set(known)
            if not found or seen == most:
                owners = {**dict.fromkeys(found), **hidden}
                return {node: owners[first[node]] or first[node] for node in new if first[node] in owners}
    return {node: node for node in new}


def _radicand(graph: Graph, point: FieldPoint, node: Node) -> int:
    op, p = graph.op[node], point.prime
    x = point.evaluate([graph.a[node]])[0]
    if op in ("sqrt", "powf"):
        return x
    if op in ("asin", "acos"):
        return (1 - x * x) % p
    y = point.evaluate([graph.b[node]])[0] if op == "atan2" else 1
    return (x * x + y * y) % p


def _reduce(characters: Sequence[int], count: int) -> list[int]:
    """Which of the rows of bits depend on earlier ones; one of equal bits does, which is a constant's."""
    pivots: dict[int, int] = {}
    found = []
    for k, row in enumerate([(1 << count) - 1, *characters], start=-1):
        while row:
            top = row.bit_length()
            if top not in pivots:
                pivots[top] = row
                break
            row ^= pivots[top]
        else:
            found.append(k)
    return found
