"""Vectors hidden in the components that a spec writes: which of them turn together, about what, and what they share.

The user writes x_k = x_{k-1} + l cos(theta_k), y_k = y_{k-1} + l sin(theta_k), or their rates.  Here such a pair (or a triple in
space) is read as base + a local vector on turned axes.  The reading is exact: a component is linear in sin and cos of one angle,
and its coefficients are those of a turn, which is tested as an identity.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import are_zero
from nhc.algebra.graph import Graph, Node
from nhc.algebra.parts import list_factors, list_terms
from nhc.algebra.rebuilding import substitute
from nhc.algebra.rewriting.digits import normalise_kept
from nhc.algebra.walks import reachable
from nhc.mechanics.rotations.turns import Path, Turn, Vector, add_vectors, change_axes, turn_in, turn_out
from nhc.records import fresh, identity_record, record, structure

_PLANES = ((0, 1), (1, 2), (2, 0))
_FEW_ANGLES = 2  # a link and its neighbour: fewer cannot be hoped for
_LOOK_BACK = 4


@record
class Part:
    """A local vector on the axes of a path."""

    path: Path
    local: Vector


@identity_record
class Chained:
    """base + the parts; ``components`` are as the spec has them."""

    components: Vector
    base: Chained | None
    parts: tuple[Part, ...]

    @property
    def turned(self) -> bool:
        return any(part.path for part in self.parts) or (self.base is not None and self.base.turned)


def _goes_on(path: Path, longer: Path) -> bool:
    return len(longer) > len(path) and longer[: len(path)] == path


@structure
class Reader:
    """Reads vectors of one kind, positions or velocities, in the order in which they come."""

    graph: Graph
    moving: int  # mask of the coordinates and the time
    known: dict[Vector, Chained] = fresh(factory=dict)
    _sums: dict[Node, dict[Node, Fraction]] = fresh(factory=dict)
    _angles: dict[Node, frozenset[Node]] = fresh(factory=dict)
    _at: tuple[dict[Node, list[Chained]], ...] = fresh(factory=lambda: ({}, {}, {}))

    def read(self, components: Vector) -> Chained:
        """The vector as base and parts; the base is one that was read before, where its components share one."""
        found = self.known.get(components)
        if found is not None:
            return found
        base, rest = self._take_base(components)
        parts: tuple[Part, ...] = ()
        if any(x != self.graph.zero for x in rest):
            parts = tuple(self._peel(rest, ()))
            remainder = next((part for part in parts if not part.path), None)
            if base is None and len(parts) > 1 and remainder is not None:
                # what does not turn is a vector of its own, shared by all that stands on it
                base = self._keep(Chained(remainder.local, None, (remainder,)))
                parts = tuple(part for part in parts if part.path)
        return self._keep(self._nested(components, base, parts))

    def _nested(self, components: Vector, base: Chained | None, parts: tuple[Part, ...]) -> Chained:
        """Parts on axes that others turn further are a vector of their own, on which bodies may share."""
        inner = next((p for p in parts if any(_goes_on(p.path, q.path) for q in parts)), None)
        if inner is None or base is None or len(parts) < 2:
            return Chained(components, base, parts)
        g = self.graph
        out = change_axes(g, inner.local, inner.path, ())
        middle = add_vectors(g, base.components, out)
        point = self.known.get(middle) or self._keep(Chained(middle, base, (inner,)))
        return self._nested(components, point, tuple(p for p in parts if p is not inner))

    def has_base(self, components: Vector) -> bool:
        """Whether it is known, or stands on one that is."""
        return components in self.known or self._take_base(components)[0] is not None

    def stands_on_known(self, components: Vector) -> bool:
        """Whether all components of a vector that is known are terms of these."""
        return bool(self._list_fitting(self._terms_of(components)))

    def _keep(self, vector: Chained) -> Chained:
        known = self.known.get(vector.components)
        if known is not None:
            return known
        self.known[vector.components] = vector
        for slot, node in zip(self._at, vector.components, strict=True):
            if node != self.graph.zero:
                slot.setdefault(node, []).append(vector)
        return vector

    def _take_base(self, components: Vector) -> tuple[Chained | None, Vector]:
        """The newest known vector whose components are terms of these, and what is left."""
        terms = self._terms_of(components)
        fitting = self._list_fitting(terms)
        base = self.known[max(fitting)] if fitting else None
        rest = components if base is None else self._without(terms, base.components)
        if len(self.angles_of(rest)) > _FEW_ANGLES:
            return self._nearest(components, base, rest)
        return base, rest

    def _terms_of(self, components: Vector) -> list[list[Node]]:
        return [list_terms(self.graph, x, known) for x, known in zip(components, self._at, strict=True)]

    def _list_fitting(self, terms: Sequence[list[Node]]) -> list[Vector]:
        """Components of the known vectors that the terms contain."""
        found: dict[Vector, None] = {}
        for at, list_of in zip(self._at, terms, strict=True):
            found.update((v.components, None) for term in list_of for v in at.get(term, ()))
        zero = self.graph.zero
        return [key for key in found if all(x == zero or x in own for x, own in zip(key, terms, strict=True))]

    def _without(self, terms: Sequence[list[Node]], base: Vector) -> Vector:
        rest = []
        for x, list_of in zip(base, terms, strict=True):
            left = list(list_of)
            if x != self.graph.zero:
                left.remove(x)
            rest.append(self.graph.sum(left))
        return rest[0], rest[1], rest[2]

    def _nearest(self, components: Vector, base: Chained | None, rest: Vector) -> tuple[Chained | None, Vector]:
        """For sums that were written out: the newest of the last vectors from which fewer angles lead here."""
        best = (len(self.angles_of(rest)), base, rest)
        mine = [self._counted(x) for x in components]
        for vector in list(self.known.values())[: -_LOOK_BACK - 1 : -1]:
            theirs = [self._counted(x) for x in vector.components]
            left = [self._difference(m, t) for m, t in zip(mine, theirs, strict=True)]
            angles = len(self.angles_of(left))
            if angles < best[0]:
                best = (angles, vector, (left[0], left[1], left[2]))
        return best[1], best[2]

    def _counted(self, node: Node) -> dict[Node, Fraction]:
        """The terms of a sum without their rational factors, and those."""
        if node not in self._sums:
            found: dict[Node, Fraction] = {}
            for term in list_terms(self.graph, node):
                factor, body = self.graph.split_coefficient(term)
                found[body] = found.get(body, Fraction(0)) + factor
            self._sums[node] = found
        return self._sums[node]

    def _difference(self, mine: dict[Node, Fraction], theirs: dict[Node, Fraction]) -> Node:
        g = self.graph
        bodies = dict.fromkeys([*mine, *theirs])
        left = [(body, mine.get(body, Fraction(0)) - theirs.get(body, Fraction(0))) for body in bodies]
        return g.sum(g.mul_number(factor, body) for body, factor in left if factor)

    # --- turns ------------------------------------------------------------------------------------------------

    def unturn(self, components: Vector) -> Part:
        """The vector on the axes that its terms were turned from, one turn after the other, whatever else contains their angles."""
        path: Path = ()
        found = self._outer_turn(components, path)
        while found is not None:
            turn, components = found
            path = (*path, turn)
            found = self._outer_turn(components, path)
        return Part(path, components)

    def _outer_turn(self, components: Vector, path: Path) -> tuple[Turn, Vector] | None:
        """A turn of two whole components: (cos l_i - sin l_j, sin l_i + cos l_j)."""
        g = self.graph
        seen = {turn.angle for turn in path}
        for i, j in _PLANES:
            split = [self._by_angle(components[axis]) for axis in (i, j)]
            for angle in sorted((split[0].keys() & split[1].keys()) - seen):
                (xc, xs), (yc, ys) = split[0][angle], split[1][angle]
                for sign, plane in ((1, (i, j)), (-1, (j, i))):
                    if xc == (ys if sign > 0 else g.neg(ys)) and yc == (g.neg(xs) if sign > 0 else xs):
                        inner = list(components)
                        inner[i], inner[j] = xc, yc
                        return Turn(plane, angle), (inner[0], inner[1], inner[2])
        return None

    def _by_angle(self, node: Node) -> dict[Node, tuple[Node, Node]]:
        """Factors of cosine and sine of the angles by which the whole node is turned."""
        g, found = self.graph, dict[Node, tuple[Node, Node]]()
        terms = list_terms(g, node)
        for angle in sorted({g.a[f] for term in terms for f in list_factors(g, term) if g.op[f] in ("sin", "cos")}):
            sides = {"cos": g.zero, "sin": g.zero}
            for term in terms:
                factors = list_factors(g, term)
                own = next((f for f in factors if g.op[f] in sides and g.a[f] == angle), None)
                if own is None:
                    break
                factors.remove(own)
                sides[g.op[own]] = g.add(sides[g.op[own]], g.product(factors))
            else:
                found[angle] = sides["cos"], sides["sin"]
        return found

    def peel(self, components: Vector) -> list[Part]:
        """The vector as parts on turned axes."""
        return list(self._peel(components, ()))

    def _peel(self, components: Vector, path: Path) -> Iterator[Part]:
        """Parts whose sum is the vector: on turned axes where it turns as a whole."""
        for angle in self.angles_of(components):
            if not self.graph.deps[angle] & self.moving:
                continue
            found = self._try(components, angle)
            if found is None:
                continue
            turn, inner, outer = found
            yield from self._peel(inner, (*path, turn))
            if any(x != self.graph.zero for x in outer):
                yield from self._peel(outer, path)
            return
        tilted = self._tilt(components)
        if tilted is None:
            yield Part(path, components)
            return
        tilt, turn, inner, outer = tilted
        yield from self._peel(inner, (*path, tilt, turn))
        if any(x != self.graph.zero for x in outer):
            yield Part(path, outer)

    def _tilt(self, components: Vector) -> tuple[Turn, Turn, Vector, Vector] | None:
        """A turn about an axis that stands askew by a constant angle: (tilt, turn, what turns, what does not, untilted)."""
        g = self.graph
        angles = self.angles_of(components)
        fixed = [a for a in angles if not g.deps[a] & self.moving]
        turning = [a for a in angles if g.deps[a] & self.moving]
        if not fixed or not turning or components[2] == g.zero:
            return None
        for angle in fixed:
            for plane in (*_PLANES, *((j, i) for i, j in _PLANES)):
                tilt = Turn(plane, angle)
                leaned = self._short(turn_in(g, tilt, components))
                for about in turning:
                    found = self._try(leaned, about)
                    if found is not None:
                        turn, inner, outer = found
                        back = self._short(turn_out(g, tilt, outer))
                        return tilt, turn, self._short(inner), back
        return None

    def _short(self, vector: Vector) -> Vector:
        x, y, z = (normalise_kept(self.graph, node, 60) for node in vector)
        return x, y, z

    def angles_of(self, components: Sequence[Node]) -> list[Node]:
        """Angles whose sine or cosine the components contain, the newest first."""
        return sorted(set[Node]().union(*map(self._angles_in, components)), reverse=True)

    def _angles_in(self, node: Node) -> frozenset[Node]:
        known = self._angles.get(node)
        if known is None:
            g = self.graph
            turned = (inner for inner in reachable(g, [node]) if g.op[inner] in ("sin", "cos"))
            known = self._angles[node] = frozenset(map(g.a.__getitem__, turned))
        return known

    def _try(self, components: Vector, angle: Node) -> tuple[Turn, Vector, Vector] | None:
        g = self.graph
        c, s = g.function("cos", angle), g.function("sin", angle)
        if all(angle in self._angles_in(x) for x in components):
            return None  # an axis of the turn, whose component it leaves as it is, is none of the three
        C, S = g.symbol("cosine", "test"), g.symbol("sine", "test")
        mask = g.mask((C, S))
        marked = substitute(g, components, {c: C, s: S}, named=False)
        for i, j in _PLANES:
            k = 3 - i - j
            if g.depends(marked[k], mask) or not (g.depends(marked[i], mask) or g.depends(marked[j], mask)):
                continue
            xc, xs = gradient(g, marked[i], (C, S))
            yc, ys = gradient(g, marked[j], (C, S))
            if any(g.depends(node, mask) for node in (xc, xs, yc, ys)):
                continue
            sign = self._orientation(xc, xs, yc, ys)
            if sign == 0:
                continue
            still = {C: g.zero, S: g.zero}
            x0, y0 = substitute(g, (marked[i], marked[j]), still, named=False)
            inner, outer = list(components), [g.zero] * 3
            inner[i], inner[j] = xc, yc
            outer[i], outer[j] = x0, y0
            turn = Turn((i, j) if sign > 0 else (j, i), angle)
            return turn, (inner[0], inner[1], inner[2]), (outer[0], outer[1], outer[2])
        return None

    def _orientation(self, xc: Node, xs: Node, yc: Node, ys: Node) -> int:
        """1 where the coefficients are those of a turn from x to y, -1 from y to x, else 0.

        From x to y: x = c l_x - s l_y, y = s l_x + c l_y, so that ys = xc and xs = -yc.
        """
        g = self.graph
        for sign in (1, -1):
            signed = [g.sub(ys, xc), g.add(xs, yc)] if sign > 0 else [g.add(ys, xc), g.sub(xs, yc)]
            if all(are_zero(g, signed)):
                return sign
        return 0
