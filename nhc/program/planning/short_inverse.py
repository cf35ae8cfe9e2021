"""Rates whose matrix falls into small blocks with short inverses.

A pair is solved for by Cramer's rule, if its determinant says in few words what L D L^T divides by in many: for a point on a sphere
(1 + x^2/z^2) (1 + y^2/z^2) - (x y/z^2)^2 = l^2/z^2.  A block D + k v v^T with a diagonal D of parameters, as a ball has that rolls
on a surface with normal v, is inverted by rank one: a = D^-1 (f - k (v . D^-1 f)/h v) with h = 1 + k v . D^-1 v (J. Sherman and
W. J. Morrison, Ann. Math. Stat. 21 (1950) 124).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nhc.algebra.exact.modular import are_equal
from nhc.algebra.expand import TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import divisors_in, split_powers, take_out_common
from nhc.algebra.polynomial import polynomial
from nhc.algebra.rewriting.digits import keep_digits
from nhc.algebra.rewriting.shorten import canonical_form, shorten
from nhc.algebra.walks import count
from nhc.mechanics.system import System
from nhc.records import record

Matrix = Sequence[Sequence[Node]]
Pairs = list[tuple[Node, Node]]

_LONG = 150
"""Operations of a matrix that is too long for its inverse to be short."""
_FEWER = 0.75
"""What is left of a determinant's operations where it is short."""


@record
class _Part:
    """The rates of some ``rows``: ``solve`` makes them of the right sides of these."""

    rows: tuple[int, ...]
    pivots: Pairs
    solve: Callable[[Sequence[Node]], list[Node]]


def short_inverse(
    system: System, mass: Matrix, force: Sequence[Node]
) -> tuple[Pairs, Callable[[Sequence[Node]], list[Node]]] | None:
    """(pivot, scale) pairs and x with mass @ x = right, from ``right``; None where some block has no short inverse.

    The matrix is symmetric and positive wherever the motion is regular.  Of several ways the one that is short for the ``force``.
    """
    g, blocks = system.graph, _blocks(system.graph, mass)
    if len(blocks) == len(mass) or "short inverses" in g.off:
        return None
    if not all(_is_full(g, mass, rows) for rows in blocks) or count(g, [x for row in mass for x in row]) > _LONG:
        return None
    parts = list[_Part]()
    for rows in blocks:
        if len(rows) == 1:
            part: _Part | None = _alone(g, mass, rows)
        else:
            part = _pair(g, mass, force, rows) if len(rows) == 2 else _by_rank_one(system, mass, rows)
        if part is None:
            return None
        parts.append(part)

    def solve(right: Sequence[Node]) -> list[Node]:
        found = dict[int, Node]()
        for part in parts:
            found.update(zip(part.rows, part.solve([right[k] for k in part.rows]), strict=True))
        return [found[k] for k in range(len(mass))]

    return [pair for part in parts for pair in part.pivots], solve


def _blocks(g: Graph, mass: Matrix) -> list[tuple[int, ...]]:
    """The rows that are coupled with one another."""
    left, found = list(range(len(mass))), list[tuple[int, ...]]()
    while left:
        block, open_ = list[int](), [left[0]]
        left.remove(left[0])
        while open_:
            i = open_.pop()
            block.append(i)
            near = [j for j in left if mass[i][j] != g.zero]
            open_ += near
            left = [j for j in left if j not in near]
        found.append(tuple(sorted(block)))
    return found


def _is_full(g: Graph, mass: Matrix, rows: Sequence[int]) -> bool:
    return all(mass[i][j] != g.zero for i in rows for j in rows)


def _alone(g: Graph, mass: Matrix, rows: tuple[int, ...]) -> _Part:
    own = mass[rows[0]][rows[0]]
    return _Part(rows, [(own, own)], lambda right: [g.div(right[0], own)])


def _pair(g: Graph, mass: Matrix, force: Sequence[Node], rows: tuple[int, ...]) -> _Part | None:
    """By the numerators of Cramer's rule, or by the entries of the inverse: what is shorter for this force."""
    i, j = rows
    first, second, off = mass[i][i], mass[j][j], mass[i][j]
    whole = g.sub(g.mul(first, second), g.power(off, 2))
    short = canonical_form(g, whole)
    if count(g, [short]) > _FEWER * count(g, [whole]) or keep_digits(g, [whole], [short]) == [whole]:
        return None
    inverse = g.inverse(short)
    own, beside, other = shorten(g, [g.mul(second, inverse), g.neg(g.mul(off, inverse)), g.mul(first, inverse)])

    def by_numerators(right: Sequence[Node]) -> list[Node]:
        x, y = right
        numerators = g.sub(g.mul(second, x), g.mul(off, y)), g.sub(g.mul(first, y), g.mul(off, x))
        return [g.mul(numerator, inverse) for numerator in numerators]

    def by_entries(right: Sequence[Node]) -> list[Node]:
        return [g.dot((own, beside), right), g.dot((beside, other), right)]

    solve = min((by_numerators, by_entries), key=lambda way: count(g, shorten(g, way([force[i], force[j]]))))
    return _Part(rows, [(short, g.mul(first, second))], solve)


def _by_rank_one(system: System, mass: Matrix, rows: tuple[int, ...]) -> _Part | None:
    """Off the diagonal k v_i v_j; on it k v_i^2 and parameters."""
    g, size = system.graph, len(rows)
    m = [[mass[i][j] for j in rows] for i in rows]
    squares = [_square(g, m, k) for k in range(size)]
    diagonal = list[Node]()
    for k in range(size):
        diagonal += shorten(g, [g.sub(m[k][k], squares[k])])
        if g.depends(diagonal[k], ~g.mask(system.p)):
            return None
    direction = take_out_common(g, shorten(g, [squares[0], *m[0][1:]]))[1]
    (k,) = shorten(g, [g.div(m[0][1], g.mul(direction[0], direction[1]))])
    if divisors_in(g, [*direction, k]) - divisors_in(g, [x for row in m for x in row]):
        return None  # they might vanish where the matrix is regular
    if not all(_vanishes_with(g, d, k) for d in diagonal):
        return None
    made = [g.product([k, direction[i], direction[j]]) for i in range(size) for j in range(i)]
    if not are_equal(g, made, [m[i][j] for i in range(size) for j in range(i)]):
        return None
    weighted = [g.div(v, d) for v, d in zip(direction, diagonal, strict=True)]
    (height,) = shorten(g, [g.add(g.one, g.mul(k, g.dot(weighted, direction)))])
    back = g.div(k, height)

    def solve(right: Sequence[Node]) -> list[Node]:
        along = g.mul(back, g.dot(weighted, right))
        return [g.div(g.sub(x, g.mul(along, v)), d) for x, v, d in zip(right, direction, diagonal, strict=True)]

    return _Part(rows, [*((d, d) for d in diagonal), (height, g.one)], solve)


def _vanishes_with(g: Graph, node: Node, k: Node) -> bool:
    """Whether a sum of masses and moments of inertia is zero only where k is, and the matrix with it: I + m a^2 beside -m a^2.

    Beside a diagonal that may have a zero the matrix may be regular, as where of three gears on one shaft one has no inertia.
    """
    try:
        terms = polynomial(g, node)
    except TooLarge:
        return False
    factors = {base for base, n in split_powers(g, k)[1].items() if n > 0}
    return len({c > 0 for c in terms.values()}) == 1 and any(factors.issuperset(f for f, _ in m) for m in terms)


def _square(g: Graph, m: Matrix, k: int) -> Node:
    """k v_k^2 from what stands off the diagonal."""
    i, j = (i for i in range(3) if i != k) if k < 3 else (0, 1)
    return g.div(g.mul(m[k][i], m[k][j]), m[i][j])
