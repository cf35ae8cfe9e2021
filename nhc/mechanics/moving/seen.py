"""Vectors on the axes of a rotation, over one row of its matrix."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from fractions import Fraction

from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.algebra.expand import Monomial, Polynomial, TooLarge
from nhc.algebra.graph import Graph, Node
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.algebra.terms import add_term, put
from nhc.algebra.walks import count
from nhc.mechanics.rotations.rotation import Rotation, Spelled
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.records import record

_TERMS = 120
"""Terms of a component that is written by fewer entries."""


@record
class Seen:
    """A rotation by symbols; ``kept`` is the mask of all velocities that the motion keeps."""

    rotation: Rotation
    spelled: Spelled
    kept: int

    @property
    def rows(self) -> tuple[Vector, ...]:
        """The symbols of the entries."""
        x = self.spelled.entries
        return tuple((x[k], x[k + 1], x[k + 2]) for k in (0, 3, 6))

    def fits(self, graph: Graph, components: Sequence[Node]) -> bool:
        """Whether these are the components by their axes as vector products have them: there are no entries of an axis's own row
        beside those of others, but along the normal.
        """
        g, named = graph, substitute(graph, components, self.spelled.words, named=False)
        rows = [g.mask(row) for row in self.rows]
        mixed = [g.depends(x, rows[i]) and g.depends(x, rows[i - 1] | rows[i - 2]) for i, x in enumerate(named)]
        return sum(mixed) <= 1

    def normals(self, graph: Graph, components: Vector) -> list[tuple[int, Vector]]:
        """The axes of space along which a vector has no entries of the matrix but that axis's own, the last one first; with the
        components where this one is written by them.
        """
        g, found = graph, list[tuple[int, Vector]]()
        named = substitute(g, components, self.spelled.words, named=False)
        across = [g.mask([x for i, row in enumerate(self.rows) if i != k for x in row]) for k in range(3)]
        for k in (2, 0, 1):
            own = list(components)
            if g.depends(named[k], across[k]):
                crossed = self._crossed(g, named[k], k)
                if crossed is None or g.depends(crossed, across[k]):
                    continue
                (own[k],) = substitute(g, [crossed], self.spelled.meaning, named=False)
            found.append((k, (own[0], own[1], own[2])))
        return found

    def _crossed(self, g: Graph, node: Node, k: int) -> Node | None:
        """A sum of products of the other two rows' entries by those of the row k, which is their cross product."""
        first, second, own = (self.rows[(k + n) % 3] for n in (1, 2, 0))
        product = {
            (first[(c + 2) % 3], second[(c + 1) % 3]): c for c in range(3)
        }  # less own[c] where 1 and 2 change places
        rows, made = {*first, *second}, Polynomial()
        try:
            terms = polynomial(g, node, _TERMS)
        except TooLarge:
            return None
        for m, c in terms.items():
            held = [f for f, e in m if f in rows for _ in range(e)]
            pair = next((pair for pair in product if held and {*pair} == {*held}), None)
            rest = tuple(x for x in m if x[0] not in rows)
            if pair is None or len(held) != 2:
                add_term(made, m, c)
                continue
            place = product[pair]
            for more, sign in (((first[(place + 1) % 3], second[(place + 2) % 3]), 1), ((own[place],), -1)):
                powers = dict(rest)
                for x in more:
                    powers[x] = powers.get(x, 0) + 1
                add_term(made, tuple(sorted(powers.items())), sign * c)
        return to_node(g, made)

    def read(
        self, graph: Graph, components: Vector, k: int, *, oriented: bool = False
    ) -> tuple[Vector, list[int]] | None:
        """V on the body's axes of a vector with these components in space, over the row ``k`` of the matrix, and the signs with
        which these are those of V: 1 if ``oriented``.  None where there is no V.

        The rows i and j say what V is across gamma, and the component k is what it is along it.
        """
        g = graph
        named = substitute(g, components, self.spelled.words, named=False)
        i, j = (k + 1) % 3, (k + 2) % 3
        first, second = (self._by_rows(g, named[axis], i, j) for axis in (i, j))
        if first is None or second is None:
            return None
        x, y, z = substitute(
            g, add_vectors(g, first[0], cross(g, first[1], self.rows[k])), self.spelled.meaning, named=False
        )
        local, matrix, signs = (x, y, z), self.rotation.matrix, (1,) if oriented else (1, -1)
        chosen, still = [1, 1, 1], [g.zero] * 3
        sign = self._sign(g, g.dot(matrix[j], local), g.sub(components[j], second[2]), signs)
        if sign is None:
            return None
        still[i], still[j], chosen[j] = first[2], g.scale(sign, second[2]), sign
        x, y, z = (g.dot(column, still) for column in zip(*matrix, strict=True))
        ways, along = list[tuple[int, Vector]](), g.dot(matrix[k], local)
        sign = self._sign(g, along, components[k], signs)
        if sign is not None:
            chosen[k] = sign
            return add_vectors(g, local, (x, y, z)), chosen
        for sign in signs:
            across = g.sub(g.scale(sign, components[k]), along)
            own = add_vectors(g, local, scale_vector(g, across, matrix[k]))
            ways.append((sign, self._shorten(g, add_vectors(g, own, (x, y, z)), k)))
        chosen[k], local = min(ways, key=lambda way: count(g, way[1]))
        return local, chosen

    def _shorten(self, g: Graph, vector: Vector, k: int) -> Vector:
        """The vector with one square of the row's entries by the others, whose squares have the sum 1, if that is shorter."""
        row, best = self.rows[k], vector
        named = substitute(g, vector, self.spelled.words, named=False)
        with suppress(TooLarge):
            parts = [polynomial(g, x, _TERMS) for x in named]
            for last in row:
                others = [x for x in row if x != last]
                short = [_without_square(p, last, others) for p in parts]
                for written in ([to_node(g, p) for p in short], [self._by_velocities(g, p) for p in short]):
                    made = substitute(g, written, self.spelled.meaning, named=False)
                    if count(g, made) < count(g, best):
                        best = made[0], made[1], made[2]
        return best

    def _by_velocities(self, g: Graph, p: Polynomial) -> Node:
        """The polynomial with what stands before each product of velocities together."""
        groups = dict[Monomial, Polynomial]()
        for m, c in p.items():
            moved = tuple(x for x in m if g.deps[x[0]] & self.kept)
            put(groups, moved, tuple(x for x in m if x not in moved), c)
        one = Fraction(1)
        return g.sum([g.mul(to_node(g, own), to_node(g, {moved: one})) for moved, own in groups.items()])

    def _sign(self, g: Graph, x: Node, y: Node, signs: Sequence[int]) -> int | None:
        """The sign with which x = y, exactly; None where there is none."""
        return next((sign for sign in signs if is_zero(g, g.sub(x, g.scale(sign, y)))), None)

    def _by_rows(self, g: Graph, node: Node, i: int, j: int) -> tuple[Vector, Vector, Node] | None:
        """What stands before the rows i and j of the matrix in a sum of their entries, and what else there is, as on a turntable
        that moves by itself; None where that moves with the velocities.
        """
        try:
            parts, rest = linear_form(g, node, (*self.rows[i], *self.rows[j]))
        except NotLinear:
            return None
        if g.depends(rest, self.kept | g.mask(self.rotation.e)):
            return None
        found = (
            g.zero if zero else part for part, zero in zip((*parts, rest), are_zero(g, [*parts, rest]), strict=True)
        )
        a, b, c, x, y, z, still = found
        return (a, b, c), (x, y, z), substitute(g, [still], self.spelled.meaning, named=False)[0]


def _without_square(p: Polynomial, last: Node, others: Sequence[Node]) -> Polynomial:
    """The polynomial modulo last^2 = 1 - others^2."""
    while any(f == last and e > 1 for m in p for f, e in m):
        made: Polynomial = {}
        for m, c in p.items():
            powers = dict(m)
            if powers.get(last, 0) < 2:
                add_term(made, m, c)
                continue
            powers[last] -= 2
            add_term(made, tuple(sorted((f, e) for f, e in powers.items() if e)), c)
            for x in others:
                again = {**powers, x: powers.get(x, 0) + 2}
                add_term(made, tuple(sorted((f, e) for f, e in again.items() if e)), -c)
        p = made
    return p
