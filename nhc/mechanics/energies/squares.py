"""A kinetic energy that was multiplied out, as squares of velocity forms again.

T = 1/2 m (x'^2 + 2 l cos(a) x' a' + l^2 a'^2) does not show that it is 1/2 m |V|^2 with V = (x' + l cos(a) a', l sin(a) a').  The
terms of each mass are a quadratic form P_ij v_i v_j.  Where P_nn is constant, v_n moves a point along a unit vector e that depends
on its own angle q_n, and P_nj = P_nn e . W_j / l, where W_j is what v_j adds to the point's velocity.  No other factor holds q_n at
the end of a chain, so that the components of W_j are read off as the coefficients of those of e, and l e is integrated over q_n to
the arm.  P loses c |V|^2, with it everything of v_n, and the next point is looked for.  A form of rank one without such an entry,
of a moment of inertia, is its row divided by the root of its first entry; what a product of inertia stands at is the product of
two forms that are known by then.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import combinations

from nhc.algebra.calculus import derivative, tangent
from nhc.algebra.expand import Monomial, Polynomial, TooLarge
from nhc.algebra.graph import Node
from nhc.algebra.polynomial import polynomial, to_node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.terms import divide, put, root, root_of_ratio
from nhc.algebra.walks import count
from nhc.mechanics.energies.angles import take_apart
from nhc.mechanics.energies.entries import TERMS, Entries, Mass, Quadratic
from nhc.mechanics.energies.names import Names
from nhc.mechanics.rotations.turning import along
from nhc.mechanics.system import System
from nhc.records import record

_LONGER = 1.25
"""How many times as long squares may be where they say more: that a mass is a point, too."""
_CARRIERS = 8
"""Velocities up to which those that carry a point are looked for."""
_FORMS = 12
"""Forms up to which products of two are looked for."""


@record
class Square:
    """``factor`` times the sum of the forms' squares; ``of`` is the entry of the diagonal that it takes away."""

    factor: Fraction
    forms: tuple[Node, ...]
    of: int


def squares_of(system: System, *, longer: bool = False, all_angles: bool = False) -> tuple[Node, Node] | None:
    """T as a sum of squares, as far as it seems one, and the same with squares of points that masses without products are at; None
    where that is not shorter, or says nothing else, or T is no polynomial of degree two.

    ``all_angles``: sines and cosines of all sums of coordinates are taken apart, not those of differences alone.
    """
    with suppress(TooLarge):
        return _Energy(system, all_angles).complete(_LONGER if longer else 1.0)
    return None


class _Energy:
    """T by masses."""

    def __init__(self, system: System, all_angles: bool = False) -> None:
        self.system, self.graph, self.all_angles = system, system.graph, all_angles
        g = self.graph
        self.terms, self.v = Quadratic(system), [*system.v, g.one]
        self.seeds = {**along(system, system.v), system.t: g.one}
        self.names = Names(system)

    def complete(self, most: float) -> tuple[Node, Node] | None:
        g, system = self.graph, self.system
        energy = polynomial(g, take_apart(system, self.all_angles), TERMS)
        peeled = {mass: self._peel_joined(own) for mass, own in self.terms.by_mass(energy).items()}
        peeled = {mass: ([*map(self._begin_at_one, squares)], rest) for mass, (squares, rest) in peeled.items()}
        made = self._assemble(peeled)
        size, before = count(g, [made]), count(g, [system.T])
        if size > most * before or (size == before and most == 1.0):
            return None
        known = [square for squares, _ in peeled.values() for square in squares]
        begun = {mass: self._begin(mass, rest, known) for mass, (_, rest) in peeled.items()}
        if not any(begun.values()):
            return (made, made) if size < before else None
        whole = {mass: ([*own, *begun[mass]], {} if begun[mass] else rest) for mass, (own, rest) in peeled.items()}
        return made, self._assemble(whole)

    def _assemble(self, peeled: dict[Mass, tuple[list[Square], Entries]]) -> Node:
        g = self.graph
        named = {mass: [[*map(self.names.named, s.forms)] for s in squares] for mass, (squares, _) in peeled.items()}
        forms = list(dict.fromkeys(f for found in named.values() for own in found for f in own))
        parts = []
        for mass, (squares, rest) in peeled.items():
            terms = [
                g.mul_number(square.factor, g.sum([g.power(form, 2) for form in own]))
                for square, own in zip(squares, named[mass], strict=True)
            ]
            left = self.terms.node(rest)
            parts.append(g.mul(g.product(mass), g.add(g.sum(terms), self._as_product(left, forms) or left)))
        return g.sum(parts)

    def _begin_at_one(self, square: Square) -> Square:
        """The square with the number before its forms' first term in its factor, so that equal beginnings are equal nodes."""
        number, g = self.names.leading_number(square.forms[0]), self.graph
        return Square(
            square.factor * number**2, tuple(g.mul_number(1 / number, form) for form in square.forms), square.of
        )

    def _as_product(self, left: Node, forms: Sequence[Node]) -> Node | None:
        """A multiple of the product of two forms, as of a product of inertia; None where it is not."""
        if len(forms) > _FORMS or not self.graph.kids[left]:
            return None
        g, p = self.graph, polynomial(self.graph, left, TERMS)
        for x, y in combinations(forms, 2):
            product = polynomial(g, g.mul(x, y), TERMS)
            if product.keys() == p.keys():
                m, c = next(iter(p.items()))
                ratio = Fraction(c) / product[m]
                if all(c == ratio * product[m] for m, c in p.items()):
                    return g.mul_number(ratio, g.mul(x, y))
        return None

    def _peel_joined(self, entries: Entries) -> tuple[list[Square], Entries]:
        """Squares, and what is left; where a square of a sum of parameters was multiplied out, with one parameter for that sum."""
        joined, back = self.terms.join(entries)
        squares, rest = self._peel(joined)
        if not back:
            return squares, rest
        for symbol, arm in reversed(back):
            put_in = {symbol: arm}
            squares = [Square(s.factor, (*substitute(self.graph, s.forms, put_in),), s.of) for s in squares]
        for square in squares:
            entries = self._without(entries, square)
        return squares, entries

    def _peel(self, entries: Entries) -> tuple[list[Square], Entries]:
        """Squares, and what is left when no other is found."""
        squares = list[Square]()
        while any(i != j for i, j in entries):
            for candidates in self._candidates(entries):
                lefts = [(square, self._without(entries, square)) for square in candidates]
                good = [
                    (len(left), count(self.graph, square.forms), k)
                    for k, (square, left) in enumerate(lefts)
                    if not any(square.of in place for place in left) and self._stays(entries, left)
                ]
                if good:
                    square, entries = lefts[min(good)[2]]
                    squares.append(square)
                    break
            else:
                break
        return squares, entries

    def _begin(self, mass: Mass, rest: Entries, known: Sequence[Square]) -> list[Square]:
        """A mass without products may be on the way to a point of others, the first of a chain; a moment of inertia is not."""
        g, places = self.graph, {i for i, _ in rest}
        if any(i != j for i, j in rest) or (mass and not any(m for p in rest.values() for m in p)):
            return []
        still = {x: g.zero for i, x in enumerate(self.system.v) if i not in places}
        for square in known:
            forms = [form for form in substitute(g, square.forms, still) if form != g.zero]
            whole = self._without({}, Square(Fraction(-1), tuple(forms), square.of))
            ratios = [found for key, p in whole.items() if (found := root_of_ratio(rest.get(key, {}), p)) is not None]
            for factor, arm in ratios[:1] if len(forms) > 1 else ():
                length = to_node(g, {arm: Fraction(1)})
                begun = Square(factor, tuple(g.mul(length, form) for form in forms), square.of)
                if not self._without(rest, begun):
                    return [begun]
        return []

    def _stays(self, entries: Entries, left: Entries) -> bool:
        """Whether no entry of the diagonal moves that did not."""
        diagonal = [(entries.get(key, {}), p) for key, p in left.items() if key[0] == key[1]]
        return all(self.terms.moves(before) for before, p in diagonal if self.terms.moves(p))

    def _without(self, entries: Entries, square: Square) -> Entries:
        return self.terms.plus(
            entries, self.graph.sum([self.graph.power(form, 2) for form in square.forms]), -square.factor
        )

    def _candidates(self, entries: Entries) -> Iterator[list[Square]]:
        """Squares of points first, the ends of chains before what carries them; then of forms of rank one."""
        g, size = self.graph, len(self.system.v)
        own = [n for n in range(size) if (n, n) in entries and any(n in key and key != (n, n) for key in entries)]
        held = {n: self._held(entries, n) for n in own}
        for n in sorted(own, key=lambda n: (held[n], -n)):
            yield self._points(entries, n)
        yield from self._carried(entries)
        for n in own:
            square = root(g, entries[n, n])
            if square is None:
                continue
            factor, monomial = square
            form = self._scalar({j: self._entry(entries, n, j) for j in range(size + 1) if j != n}, n, factor, monomial)
            if form is not None:
                yield [form]

    def _carried(self, entries: Entries) -> Iterator[list[Square]]:
        """Points that several velocities move at right angles everywhere, as x' and y': what else moves them is in their rows."""
        g, one = self.graph, ()
        moved = {n for key, p in entries.items() if key[0] != key[1] and self.terms.moves(p) for n in key}
        plain = [n for n in range(len(self.system.v)) if n in moved and entries.get((n, n), {}).keys() == {one}]
        for size in (3, 2) if len(plain) <= _CARRIERS else ():
            for group in combinations(plain, size):
                factor = Fraction(entries[group[0], group[0]][one])
                alike = all(entries[n, n][one] == factor for n in group)
                if not alike or any(pair in entries for pair in combinations(group, 2)):
                    continue
                others = [j for j in range(len(self.v)) if j not in group]
                rows = [[(j, divide(self._entry(entries, n, j), factor, ()) or {}) for j in others] for n in group]
                if any(p for row in rows for _, p in row):
                    parts = [[g.mul(to_node(g, p), self.v[j]) for j, p in row] for row in rows]
                    yield [
                        Square(
                            factor,
                            tuple(g.sum([self.v[n], *own]) for n, own in zip(group, parts, strict=True)),
                            group[0],
                        )
                    ]

    def _held(self, entries: Entries, n: int) -> int:
        """How many entries outside row n depend on its coordinate."""
        g, q = self.graph, self.graph.deps[self.system.q[n]]
        return sum(n not in key and any(g.deps[f] & q for m in p for f, _ in m) for key, p in entries.items())

    def _entry(self, entries: Entries, i: int, j: int) -> Polynomial:
        return entries.get((min(i, j), max(i, j)), {})

    def _points(self, entries: Entries, n: int) -> list[Square]:
        """The points that v_n may move along a unit vector, the shortest first; none where its entry is not constant."""
        g, system = self.graph, self.system
        if len(entries[n, n]) != 1:
            return []
        ((square, factor),) = entries[n, n].items()
        if any(e % 2 or g.deps[f] & ~self.terms.parameters for f, e in square):
            return []
        arm = tuple((f, e // 2) for f, e in square)
        row = {j: self._entry(entries, n, j) for j in range(len(self.v)) if j != n}
        angles = {g.a[f] for p in row.values() for m in p for f, _ in m if g.deps[f] & g.deps[system.q[n]]}
        if len(angles) > 1:
            return []
        angle = next(iter(angles), system.q[n])
        slopes = [g.value(derivative(g, angle, q)) for q in system.q]
        own = slopes[n]
        if not own:
            return []
        if angles:
            for j, slope in enumerate(slopes):
                if j != n and slope:
                    row[j] = dict(row[j])
                    put(row, j, square, -factor * slope / own)
        turned = [q for q, slope in zip(system.q, slopes, strict=True) if slope]
        beside = [
            q
            for q in system.q
            if q not in turned and any(g.deps[f] & g.deps[q] for p in row.values() for m in p for f, _ in m)
        ]
        found = list[tuple[Node, ...]]()
        if not angles and not any(g.deps[f] & g.deps[system.q[n]] for p in entries.values() for m in p for f, _ in m):
            beside = []  # an axis that turns would bring the coordinate in
        for others in ((), *((q,) for q in beside), *(combinations(beside, 2) if not angles else ())):
            components = self._components(row, g.mask(others), angle, Fraction(factor), arm)
            forms = None if components is None else self._forms(components, angle, own, arm)
            if forms is not None:
                found.append(forms)
        return [Square(Fraction(factor), forms, n) for forms in found]

    def _scalar(self, row: dict[int, Polynomial], n: int, factor: Fraction, arm: Monomial) -> Square | None:
        g = self.graph
        terms = [g.mul(to_node(g, {arm: Fraction(1)}), self.v[n])]
        for j, p in row.items():
            part = divide(p, factor, arm)
            if part is None:
                return None
            terms.append(g.mul(to_node(g, part), self.v[j]))
        return Square(factor, (g.sum(terms),), n)

    def _components(
        self, row: dict[int, Polynomial], beside: int, angle: Node, factor: Fraction, arm: Monomial
    ) -> dict[Monomial, dict[int, Polynomial]] | None:
        """For each component of the unit vector, what the other velocities add to the point's; None where it is no unit vector."""
        g = self.graph
        found: dict[Monomial, dict[int, Polynomial]] = {}
        for j, p in row.items():
            whole = divide(p, factor, arm)
            if whole is None:
                return None
            for m, c in whole.items():
                unit = tuple((f, e) for f, e in m if g.a[f] == angle or g.deps[f] & beside)
                rest = tuple(power for power in m if power not in unit)
                put(found.setdefault(unit, {}), j, rest, c)
        found = {unit: parts for unit, parts in found.items() if any(parts.values())}
        squares = g.sum([g.power(to_node(g, {unit: Fraction(1)}), 2) for unit in found])
        missing = polynomial(g, g.sub(g.one, squares), TERMS)
        if missing:
            last = root(g, missing)
            if last is None or last[0] != 1:
                return None
            found[last[1]] = {}
        return found

    def _forms(
        self, found: dict[Monomial, dict[int, Polynomial]], angle: Node, slope: Fraction | int, arm: Monomial
    ) -> tuple[Node, ...] | None:
        """The components of the point's velocity: the arm's rate and what the other velocities add."""
        g = self.graph
        sine, cosine = g.function("sin", angle), g.function("cos", angle)
        length = to_node(g, {arm: Fraction(1) / Fraction(slope)})
        forms = []
        for unit, parts in found.items():
            powers = dict(unit)
            turned = [f for f in (sine, cosine) if f in powers]
            if (
                len(turned) > 1
                or any(powers[f] != 1 for f in turned)
                or (turned and g.depends(g.product(f for f, _ in unit if f not in turned), g.deps[angle]))
            ):
                return None
            rest = to_node(g, {tuple((f, e) for f, e in unit if f not in turned): Fraction(1)})
            place = g.mul(rest, g.neg(cosine) if turned == [sine] else sine if turned else angle)
            terms = [g.mul(to_node(g, p), self.v[j]) for j, p in sorted(parts.items()) if p]
            terms.append(g.mul(length, tangent(g, [place], self.seeds)[0]))
            still = [p[()] for p in parts.values() if list(p) == [()]]
            forms.append(g.sum(g.neg(term) for term in terms) if still and still[0] < 0 else g.sum(terms))
        return tuple(forms)
