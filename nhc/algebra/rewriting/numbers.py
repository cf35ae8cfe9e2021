"""Powers of two in front of products, taken into what is computed before them: 2 (x y) is x' y where x is used as 2 x alone.

The graph draws numbers out of products, so that the entries 2 (q_i q_j - q_0 q_k)/|q|^2 of a rotation stand as halves with a 2 in
every product that they are in.  Here each expression v gets a size 2^k(v), by which it is computed: a product is without a number
where the sizes of its factors make up that of the product, a term where it has the size of its sum, and a quotient 1/x has any.
These are linear equations for the k, of which as many as possible are to hold; what is left are multiplications.  Powers of two
do not round, so every result is the same to the last bit, unless it leaves the range of doubles.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction

from nhc.algebra.graph import ADD, MUL, NEG, NUM, POW, Graph, Node
from nhc.algebra.nodes import Rational
from nhc.algebra.walks import reachable

_FEW = 3
"""Multiplications by numbers up to which nothing is looked for."""
_RARE = 18
"""Nodes for each of them from which nothing is looked for: equations are made for all."""
_WORTH = 0.7
"""Part of the multiplications that may be left: for fewer, expressions keep the numbers that the spec has."""
_LONG = 6000
"""Nodes beyond which nothing is looked for."""

Equation = tuple[dict[Node, int], int]
"""sum of coefficient * k(v) over the nodes v = the constant."""


def fold_numbers(graph: Graph, roots: Sequence[Node]) -> list[Node]:
    """The same values with fewer multiplications by powers of two.

    The nodes that are made break the graph's rules: they are for printing, and no more to be calculated with.
    """
    nodes = reachable(graph, roots)
    numbers = sum(_is_scaled(graph, node) for node in nodes)
    if numbers <= _FEW or _RARE * numbers < len(nodes) or len(nodes) > _LONG or "folded numbers" in graph.off:
        return list(roots)
    equations = _equations(graph, nodes, roots)
    held, broken = [e for e in equations if not e[1]], [e for e in equations if e[1]]
    # nothing gets a number that had none; or numbers go first, from the results to what they are made of
    ways = [_solve(order) for order in ([*held, *broken], [*broken, *held[::-1]])]
    left = [sum(not _holds(way, equation) for equation in equations) for way in ways]
    best = min(range(len(ways)), key=left.__getitem__)
    if left[best] > _WORTH * len(broken):
        return list(roots)
    return _Sized(graph, ways[best]).roots(nodes, roots)


# --- the equations -----------------------------------------------------------------------------------------------


def _equations(graph: Graph, nodes: Sequence[Node], roots: Iterable[Node]) -> list[Equation]:
    """One for each place where a number may stand."""
    g, found = graph, list[Equation]()

    def add(wanted: Iterable[tuple[int, Node]], factor: Rational) -> None:
        """The equation that a place is free of a power of two, where its number is one: wanted sizes = 1/factor."""
        power = _log2(factor)
        if power is not None:
            sides: dict[Node, int] = {}
            for n, core in wanted:
                if _has_size(g, core):
                    sides[core] = sides.get(core, 0) + n
            found.append(({core: n for core, n in sides.items() if n}, -power))

    used = list[tuple[Rational, Node]]()  # in their own size
    divisors: dict[Node, int] = {}
    for node in nodes:
        if g.op[node] == POW and g.b[node] < 0:
            divisors[g.a[node]] = divisors.get(g.a[node], 0) + 1
    for node in nodes:
        op = g.op[node]
        if op == NEG or _is_scaled(g, node):
            continue
        operands = [g.split_coefficient(kid) for kid in g.kids[node]]
        if op == ADD:
            for k, core in operands:
                if core != g.one:
                    add([(1, node), (-1, core)], k)
        elif op == MUL:
            (k, x), (m, y) = operands
            add([(1, node), (-1, x), (-1, y)], k * m)
        elif op == POW:
            ((k, x),) = operands
            n = g.b[node]
            if n != -1 or divisors[x] > 1 or g.op[x] == "sqrt":  # 2/x for 1/x is as cheap, and 1/x^2 is made of it
                add([(1, node), (-n, x)], Fraction(k) ** n)
        else:
            used += operands
    for k, core in (*used, *(g.split_coefficient(root) for root in roots)):
        if core != g.one:
            add([(-1, core)], k)
    return found


def _has_size(graph: Graph, node: Node) -> bool:
    return graph.op[node] in (ADD, MUL, POW)


def _is_scaled(graph: Graph, node: Node) -> bool:
    return graph.op[node] == MUL and graph.op[graph.a[node]] == NUM


def _log2(factor: Rational) -> int | None:
    """j where the factor is 2^j or -2^j, else None."""
    if factor in (1, -1):
        return 0
    top, bottom = abs(factor.numerator), factor.denominator
    if top & (top - 1) or bottom & (bottom - 1) or not top:
        return None
    return top.bit_length() - bottom.bit_length()


# --- their solution ----------------------------------------------------------------------------------------------


class _Solution:
    """k of each node: a constant and a combination of those that are still free."""

    def __init__(self) -> None:
        self.known: dict[Node, tuple[int, dict[Node, int]]] = {}
        self._users: dict[Node, set[Node]] = {}

    def reduce(self, equation: Equation) -> Equation:
        """The equation in what is free."""
        sides, constant = dict[Node, int](), equation[1]
        for node, n in equation[0].items():
            own, combination = self.known.get(node, (0, {node: 1}))
            constant -= n * own
            for free, m in combination.items():
                sides[free] = sides.get(free, 0) + n * m
        return {free: n for free, n in sides.items() if n}, constant

    def take(self, equation: Equation) -> None:
        """Let it hold, if it can in whole numbers."""
        sides, constant = self.reduce(equation)
        units = [free for free, n in sides.items() if abs(n) == 1]
        if units:
            free = min(units, key=lambda node: len(self._users.get(node, ())))
        elif len(sides) == 1 and constant % next(iter(sides.values())) == 0:
            (free,) = sides
        else:
            return
        n = sides.pop(free)
        self._put(free, constant // n, {other: -m // n for other, m in sides.items()})

    def _put(self, free: Node, constant: int, combination: dict[Node, int]) -> None:
        for node in (free, *self._users.pop(free, ())):
            own, old = self.known.get(node, (0, {free: 1}))
            n = old.pop(free)
            own += n * constant
            for other, m in combination.items():
                total = old.get(other, 0) + n * m
                if total:
                    old[other] = total
                    self._users.setdefault(other, set()).add(node)
                else:
                    del old[other]
                    self._users[other].discard(node)
            self.known[node] = own, old

    def sizes(self) -> dict[Node, int]:
        """With what is still free at 0."""
        return {node: constant for node, (constant, _) in self.known.items() if constant}


def _solve(equations: Iterable[Equation]) -> dict[Node, int]:
    """k of the nodes where it is not 0: each equation in turn holds if it can."""
    solution = _Solution()
    for equation in equations:
        solution.take(equation)
    return solution.sizes()


def _holds(sizes: dict[Node, int], equation: Equation) -> bool:
    return sum(n * sizes.get(node, 0) for node, n in equation[0].items()) == equation[1]


# --- what is printed ---------------------------------------------------------------------------------------------


class _Sized:
    """The nodes in their sizes."""

    def __init__(self, graph: Graph, sizes: dict[Node, int]) -> None:
        self.graph, self.sizes = graph, sizes
        self._made: dict[Node, Node] = {}

    def roots(self, nodes: Iterable[Node], roots: Iterable[Node]) -> list[Node]:
        """The roots, each in its own size."""
        g = self.graph
        for node in nodes:
            if g.op[node] == NEG or _is_scaled(g, node):
                continue
            made = self._made[node] = self._make(node)
            scaled = g.scale(self._size(node), node) if self.sizes.get(node) else node
            g.pass_label(scaled, made)
        return [self._used(root, 1) for root in roots]

    def _size(self, core: Node) -> Rational:
        k = self.sizes.get(core)
        return Fraction(2) ** k if k else 1

    def _make(self, node: Node) -> Node:
        g, op, size = self.graph, self.graph.op[node], self._size(node)
        kids = g.kids[node]
        if not kids:
            return node
        if op == ADD:
            return self._raw(node, ADD, [self._used(kid, size) for kid in kids])
        if op in (MUL, POW):
            cores = [g.split_coefficient(kid) for kid in kids]
            factor = size
            for k, core in cores:
                own = self._size(core)
                if k != own:
                    factor *= (Fraction(k) / own) ** (g.b[node] if op == POW else 1)
            return self._times(factor, self._raw(node, op, [self._made[core] for _, core in cores]))
        return self._raw(node, op, [self._used(kid, 1) for kid in kids])

    def _used(self, node: Node, size: Rational) -> Node:
        """size * node."""
        k, core = self.graph.split_coefficient(node)
        if self.graph.op[node] == NUM:
            return self.graph.number(k * size)
        own = self._size(core)
        return self._times(k * size if own == 1 else Fraction(k * size) / own, self._made[core])

    def _times(self, factor: Rational, node: Node) -> Node:
        g = self.graph
        if factor < 0:
            return self._negative(self._times(-factor, node))
        if factor == 1:
            return node
        number = g.number(factor)
        known = g.scale(factor, node)
        return known if g.kids[known] == (number, node) else g.raw(MUL, number, node)

    def _negative(self, node: Node) -> Node:
        g = self.graph
        return g.a[node] if g.op[node] == NEG else g.neg(node)

    def _raw(self, node: Node, op: str, kids: list[Node]) -> Node:
        g = self.graph
        if tuple(kids) == g.kids[node]:
            return node
        return g.raw(op, kids[0], g.b[node] if len(kids) == 1 else kids[1])
