"""Points of a prime field at the positions that a spec's holonomic constraints allow.

A motion never leaves f(q, t) = 0, and some of what it does there no other level of f tells of: Neumann's integrals are constant on
the unit sphere only, and a wheel that is locked straight ahead goes straight.  Each equation is solved for a coordinate in which it
is a polynomial of degree two at most, one after another; where that cannot be, levels of f are not told apart.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nhc.algebra.calculus import derivative
from nhc.algebra.dense import null_space, rank_modulo
from nhc.algebra.exact.draw import MOST_DRAWS, draw_points
from nhc.algebra.exact.field import FieldPoint, Unlucky
from nhc.algebra.exact.modular import is_zero, rank
from nhc.algebra.exact.primes import primes_of
from nhc.algebra.exact.residues import square_root
from nhc.algebra.graph import ADD, MUL, NEG, POW, SYM, Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.walks import reachable
from nhc.mechanics.system import System
from nhc.records import record

_OPEN = frozenset((ADD, MUL, NEG, POW, SYM))
_DRAWS = 200
_POINTS = 4  # that a rank is taken at
_FIRST_SEED = 11_000_027


@record
class Step:
    """c_2 x^2 + c_1 x + c_0 = 0 for one coordinate; of the first degree where c_2 vanishes identically."""

    x: Node
    coefficients: tuple[Node, Node, Node]
    square: bool

    def discriminant(self, point: FieldPoint) -> int:
        """c_1^2 - 4 c_2 c_0 at a point."""
        c0, c1, c2 = point.evaluate(self.coefficients)
        return (c1 * c1 - 4 * c2 * c0) % point.prime

    def settle(self, point: FieldPoint) -> None:
        """Give the coordinate its value; of two the one that is drawn does not matter, for they are conjugates.

        Raises:
            Unlucky: there is none at this point.
        """
        p = point.prime
        c0, c1, c2 = point.evaluate(self.coefficients)
        if not self.square:
            value = -c0 * pow(c1, -1, p) % p
        else:
            root = square_root(self.discriminant(point), p)
            if root is None:
                raise Unlucky
            value = (root - c1) * pow(2 * c2, -1, p) % p
        point.evaluate([], {self.x: value})


@record
class Leaf:
    """How positions on the holonomic equations f(q, t) = 0 are found: each step solves one equation for one coordinate.

    There are no steps where the spec has no such equations, or they could not be solved in this way.
    """

    steps: tuple[Step, ...]

    @property
    def solved(self) -> tuple[Node, ...]:
        """The coordinates that are solved for."""
        return tuple(step.x for step in self.steps)

    @property
    def settling(self) -> Callable[[FieldPoint], None] | None:
        """What draws of points have to do; None where any position will do."""
        return self.settle if self.steps else None

    def settle(self, point: FieldPoint) -> None:
        """Give the solved coordinates their values.

        Raises:
            Unlucky: there is no such position with the other coordinates of this point.
        """
        for step in self.steps:
            step.settle(point)


def leaf_of(system: System, nodes: Sequence[Node] = ()) -> Leaf:
    """The leaf of a system, for the equations that its spec declares: the length of a quaternion means nothing.

    ``nodes`` are to have values there: a coframe that is singular on all of the leaf tells nothing of it.
    """
    declared = {entry.name for entry in system.spec.holonomic}
    left = [f.equation for f in system.constraints if f.equation is not None and f.name in declared]
    steps: list[Step] = []
    while left:
        found = _last_step(system, left)
        if found is None:
            return Leaf(())
        steps.insert(0, found[1])
        left.remove(found[0])
    leaf = Leaf(tuple(steps))
    return leaf if steps and _is_whole(system.graph, leaf) and has_values(system.graph, leaf, nodes) else Leaf(())


def rank_on(graph: Graph, rows: Sequence[Sequence[Node]], leaf: Leaf, prime: int = 0) -> int:
    """The generic rank on a leaf, modulo a prime of choice."""
    if not leaf.steps or not rows:
        return rank(graph, rows)
    prime = prime or primes_of(graph)[0]
    return max(rank_modulo(matrix, prime) for matrix in _matrices(graph, rows, leaf, prime))


def parts_on(graph: Graph, rows: Sequence[Sequence[Node]], first: int, leaf: Leaf) -> list[list[bool]]:
    """For each row after the ``first`` ones, which are independent and which it is a combination of: which of them it needs.

    None where it is no such combination.
    """
    prime = primes_of(graph)[0]
    used = [[False] * first for _ in rows[first:]]
    for matrix in _matrices(graph, rows, leaf, prime):
        for vector in null_space(list(zip(*matrix, strict=True)), len(rows), prime):
            own = max(k for k, x in enumerate(vector) if x) - first
            if own >= 0:
                used[own] = [before or bool(x) for before, x in zip(used[own], vector[:first], strict=True)]
    return used


def _matrices(graph: Graph, rows: Sequence[Sequence[Node]], leaf: Leaf, prime: int) -> list[list[list[int]]]:
    """The rows at some random points of a leaf.

    Raises:
        Unlucky: they have no values on it.
    """
    flat, width, found = [x for row in rows for x in row], len(rows[0]), list[list[list[int]]]()
    seeds = range(_FIRST_SEED, _FIRST_SEED + MOST_DRAWS)
    for _, point in draw_points(graph, flat, prime, seeds, settle=leaf.settling):
        try:
            values = point.evaluate(flat)
        except Unlucky:
            continue
        found.append([values[k : k + width] for k in range(0, len(values), width)])
        if len(found) == _POINTS:
            return found
    raise Unlucky


def _last_step(system: System, equations: Sequence[Node]) -> tuple[Node, Step] | None:
    """An equation and a coordinate that no other one of them contains, in which it is a polynomial of degree two at most."""
    g = system.graph
    for equation in equations:
        others = [other for other in equations if other != equation]
        for x in reversed(system.q):
            if g.depends(equation, g.deps[x]) and not any(g.depends(other, g.deps[x]) for other in others):
                step = _solve(system, equation, x)
                if step is not None:
                    return equation, step
    return None


def _solve(system: System, equation: Node, x: Node) -> Step | None:
    """A polynomial whose leading coefficient contains parameters only, so that no factor of it lacks the coordinate; or None.

    None, too, where the coordinate cancels, as the place of a floating loop does in the equations that close it.
    """
    g = system.graph
    holders = [node for node in reachable(g, [equation], g.mask([x])) if g.depends(node, g.deps[x])]
    if any(g.op[node] not in _OPEN or (g.op[node] == POW and g.b[node] < 0) for node in holders):
        return None
    slope = derivative(g, equation, x)
    bend = derivative(g, slope, x)
    linear = is_zero(g, bend)
    leading = slope if linear else bend
    if g.depends(leading, g.mask((*system.q, system.t))) or is_zero(g, leading):
        return None
    c0, c1, c2 = substitute(g, [equation, slope, bend], {x: g.zero}, named=False)
    return Step(x, (c0, c1, g.div(c2, g.number(2))), not linear)


def _is_whole(g: Graph, leaf: Leaf) -> bool:
    """Whether no discriminant is a square: f = 0 would be several leaves then, and a point tells of one of them only."""
    open_ = {step.x for step in leaf.steps if step.square}
    seen: dict[Node, set[bool]] = {x: set() for x in open_}
    nodes = [node for step in leaf.steps for node in step.coefficients]
    for _, point in draw_points(g, nodes, primes_of(g)[0], range(_FIRST_SEED, _FIRST_SEED + _DRAWS)):
        for step in leaf.steps:
            if step.square:
                seen[step.x].add(pow(step.discriminant(point), (point.prime - 1) // 2, point.prime) == 1)
            try:
                step.settle(point)
            except Unlucky:
                break
        if all(len(found) == 2 for found in seen.values()):
            return True
    return False


def has_values(g: Graph, leaf: Leaf, nodes: Sequence[Node]) -> bool:
    """Whether the nodes have values on a leaf: 1/x and the slope of log(x) have none on x = 0."""
    seeds = range(_FIRST_SEED, _FIRST_SEED + _DRAWS)
    for _, point in draw_points(g, nodes, primes_of(g)[0], seeds, settle=leaf.settling):
        try:
            point.evaluate(nodes)
        except Unlucky:
            continue
        return True
    return False
