"""Points in space as sums of vectors that are fixed on axes, each with the next point that others share.

Where the spec names the points between, or uses them twice, these are shared.  Otherwise (sums whose factors the graph has put
together, chains written out) points are taken apart to the end, and share what their sums begin with.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import permutations

from nhc.algebra.graph import ADD, NEG, Node
from nhc.algebra.parts import Factor, list_factors, list_terms, split_parameters
from nhc.algebra.walks import reachable
from nhc.mechanics.rotations.turns import Vector, add_vectors, scale_vector
from nhc.mechanics.trees.frames import ROOT, ZERO, Frame, Frames
from nhc.mechanics.trees.sharing import Point, share_beginnings

_FEW = 3  # coordinates of what moves in another way than by turning


class Unread(Exception):
    """A vector that is no sum of vectors fixed on axes."""


Arm = tuple[Frame, Vector, Node]
"""A vector on its axes and the parameters in front of it."""
Components = tuple[int | None, int | None, int | None]
"""Numbers of the forms that are the components of a point's velocity."""


class Points:
    """``places``: the position that each form is the rate of, over the symbols of ``frames.rates``."""

    def __init__(self, frames: Frames, parameters: int, places: Mapping[int, Node]) -> None:
        self.frames, self.graph = frames, frames.graph
        self._mask, self._places = parameters, places
        self._points: dict[Vector, Point] = {}
        self._turned_by: dict[Node, frozenset[tuple[int, Node]]] = {}
        self._summed: dict[Node, list[Node]] = {}
        self._in_space = False
        self._met: dict[int, Frame] = {}
        self._whole: dict[Vector, tuple[list[tuple[Frame, Vector]], Vector]] = {}
        self._uses: dict[Node, int] = {}
        seen, stack = set[Node](), list(places.values())
        while stack:
            node = stack.pop()
            if node in seen or self.graph.op[node] not in (ADD, NEG):
                continue
            seen.add(node)
            for child in self.graph.kids[node]:
                self._uses[child] = self._uses.get(child, 0) + (self.graph.op[node] == ADD)
                stack.append(child)

    def read(self, groups: Sequence[Sequence[int]]) -> list[tuple[Components, Point]]:
        """Neighbours of a group that are the three components of a point, or two in a plane."""
        found = [components for group in groups for components in self._components(group)]
        vectors = [self._vector(components) for components in found]
        points = self._by_sums(vectors)
        try:
            named = [self._by_names(vector) for vector in vectors]
        except Unread:
            pass
        else:
            points = min(named, points, key=_count_parts)
        return list(zip(found, points, strict=True))

    def _components(self, group: Sequence[int]) -> Iterator[Components]:
        first = 0
        while first < len(group):
            near = sorted(group[first : first + 3])
            pair = sorted(group[first : first + 2])
            found = self._choose(permutations(near)) if len(near) == 3 else None
            self._in_space = self._in_space or found is not None
            if found is None and len(pair) == 2:
                orders = (pair, pair[::-1])
                flat: list[tuple[int | None, ...]] = [(*own, None) for own in orders]
                if self._in_space:
                    flat += [order for own in orders for order in ((own[0], None, own[1]), (None, *own))]
                found = self._choose(flat, turning=True)
            if found is None and len(near) == 3:
                found = self._choose(permutations(near), strictly=False)
            first += 1 if found is None else 3 - found.count(None)
            if found is not None:
                yield found

    def _choose(
        self, orders: Iterable[Sequence[int | None]], *, turning: bool = False, strictly: bool = True
    ) -> Components | None:
        """The order of components in which the fewest axes are met that were not before: two components of a point may stand in
        any order in T, and in any plane.

        ``strictly``: nothing but sums of vectors that are fixed on axes, and of what no angle turns; ``turning``: with such
        a vector.
        """
        best, fewest = None, 0
        for x, y, z in orders:
            try:
                arms, loose = self._arms(self._vector((x, y, z)))
            except Unread:
                return None  # nor is it in another order
            if strictly and self._is_turned(loose):
                return None
            new = len({id(frame) for frame, _ in arms} - self._met.keys())
            if (arms or not turning) and (best is None or new < fewest):
                best, fewest = (x, y, z), new
            if best is not None and fewest <= 1:
                break
        if best is not None:
            self._met.update((id(frame), frame) for frame, _ in self._arms(self._vector(best))[0])
        return best

    def _is_turned(self, vector: Vector) -> bool:
        g = self.graph
        return any(g.op[node] in ("sin", "cos") for node in reachable(g, vector, self.frames.moving))

    def _vector(self, components: Components) -> Vector:
        x, y, z = (self.graph.zero if k is None else self._places[k] for k in components)
        return x, y, z

    def _by_names(self, place: Vector) -> Point:
        """A position as the next one that others share, and the rest."""
        stack = [place]
        while stack:
            own = stack[-1]
            x, y, z = (self._shared(node) for node in own)
            standing = any((x, y, z)) and all(b != node for b, node in zip((x, y, z), own, strict=True))
            if standing and (x, y, z) not in self._points:
                stack.append((x, y, z))
                continue
            held = {x, y, z} if standing else set()
            rows = [[term for term in list_terms(self.graph, node, held) if term not in held] for node in own]
            self._points[own] = self._split(self._points[x, y, z] if standing else None, rows)
            stack.pop()
        return self._points[place]

    def _shared(self, place: Node) -> Node:
        """The largest sum within a sum that has a name or is used elsewhere, else such a term; zero where there is none."""
        g, sums, terms, stack = self.graph, list[Node](), list[Node](), [(place, False)]
        while stack:
            node, negative = stack.pop()
            if g.op[node] == NEG:
                stack.append((g.a[node], not negative))
                continue
            signed = g.neg(node) if negative else node
            named, often = node in g.labels or g.neg(node) in g.labels, self._uses.get(node, 0) > 1
            if g.op[node] != ADD:
                if named and often:
                    terms.append(signed)
            elif signed != place and (named or often):
                sums.append(signed)
            else:
                stack += [(child, negative) for child in g.kids[node]]
        return max(sums or terms, key=lambda own: g.a[own] if g.op[own] == NEG else own, default=g.zero)

    def _split(self, base: Point | None, rows: Sequence[Sequence[Node]]) -> Point:
        arms, loose = self._read(rows)
        if self._is_turned(loose):
            arms, loose = self._read([[x for term in row for x in self._terms(term)] for row in rows], apart=True)
        self._check(loose)
        return Point(base, self._total(arms), loose)

    def _read(self, rows: Sequence[Sequence[Node]], *, apart: bool = False) -> tuple[dict[int, list[Arm]], Vector]:
        """By the parameters in front of the terms, then by the axes; with ``apart``, terms of one group may have several."""
        g = self.graph
        groups: dict[tuple[Node, int], list[list[Node]]] = {}
        for axis, row in enumerate(rows):
            seen: dict[tuple[Node, Node], int] = {}
            for term in row:
                outer, rest = self._outer(term)
                key = outer.node(g), rest
                copy = seen[key] = seen.get(key, -1) + 1  # what a turn leaves as it is stands for the body before, too
                groups.setdefault((key[0], copy), [[], [], []])[axis].append(rest)
        arms: dict[int, list[Arm]] = {}
        loose = ZERO
        for (factor, _), found in groups.items():
            own: Vector = (g.sum(found[0]), g.sum(found[1]), g.sum(found[2]))
            frame = self.frames.of(own)
            if frame is not None:
                self._add(arms, frame, own, factor)
                continue
            parts, left = self._peel(found) if apart else ([], own)
            for on, part in parts:
                self._add(arms, on, part, factor)
            loose = add_vectors(g, loose, scale_vector(g, factor, left))
        return arms, loose

    def _outer(self, term: Node) -> tuple[Factor, Node]:
        """The parameters in front of a term, and the rest, with the sines and cosines of constant angles."""
        g, (outer, rest) = self.graph, split_parameters(self.graph, term, self._mask)
        turns = {node: n for node, n in outer.powers.items() if g.op[node] in ("sin", "cos")}
        others = {node: n for node, n in outer.powers.items() if node not in turns}
        return Factor(outer.number, others), g.mul(Factor(powers=turns).node(g), rest)

    def _add(self, arms: dict[int, list[Arm]], frame: Frame, own: Vector, factor: Node) -> None:
        if frame is not ROOT:
            own = self.frames.as_known(own)
            deepest = self._home(arms, frame, own)
            arms.setdefault(id(deepest), []).append((deepest, own, factor))

    def _total(self, arms: dict[int, list[Arm]]) -> list[tuple[Frame, Vector]]:
        made = []
        for parts in arms.values():
            total = ZERO
            for _, own, factor in parts:
                total = add_vectors(self.graph, total, scale_vector(self.graph, factor, own))
            made.append((max((p[0] for p in parts), key=lambda f: f.depth), total))
        return made

    def _home(self, arms: dict[int, list[Arm]], frame: Frame, own: Vector) -> Frame:
        """The axes of an arm that is there already, where both are fixed on one of the two; else the vector's own."""
        for key, parts in list(arms.items()):
            common = self.frames.common([(frame, own), *((f, v) for f, v, _ in parts)])
            if common is not None:
                arms[id(common)] = arms.pop(key)
                return common
        return frame

    def _check(self, loose: Vector) -> None:
        g = self.graph
        moved = sum(any(g.depends(x, g.deps[q]) for x in loose) for q in self.frames.system.q)
        if moved > _FEW or any(self.frames.rates.has_entries(x) for x in loose):
            raise Unread

    # --- without names --------------------------------------------------------------------------------------

    def _by_sums(self, places: Sequence[Vector]) -> list[Point]:
        paths = []
        for place in places:
            arms, loose = self._arms(place)
            path = sorted(reversed(arms), key=lambda arm: arm[0].depth)  # peeled from the end
            paths.append(((None, loose), *path) if any(loose) else tuple(path))
        return share_beginnings(self.frames, paths)

    def _arms(self, place: Vector) -> tuple[list[tuple[Frame, Vector]], Vector]:
        if place not in self._whole:
            arms, loose = self._read([self._terms(node) for node in place], apart=True)
            self._check(loose)
            self._whole[place] = self._total(arms), loose
        return self._whole[place]

    def _terms(self, node: Node) -> list[Node]:
        """All terms, with parameters multiplied into sums."""
        if node not in self._summed:
            g, found, stack = self.graph, list[Node](), [(node, self.graph.one)]
            while stack:
                top, factor = stack.pop()
                for term in reversed(list_terms(g, top)):
                    outer, rest = self._outer(term)
                    own = g.mul(factor, outer.node(g))
                    if g.op[g.a[rest] if g.op[rest] == NEG else rest] == ADD:
                        stack.append((rest, own))
                    else:
                        found.append(g.mul(own, rest))
            self._summed[node] = found
        return self._summed[node]

    def _peel(self, rows: Sequence[Sequence[Node]]) -> tuple[list[tuple[Frame, Vector]], Vector]:
        """Parts of a sum that are fixed on axes, and the rest: each has all the terms in which one angle or rotation stands."""
        g, found, gone = self.graph, list[tuple[Frame, Vector]](), set[tuple[int, int]]()
        turned: dict[tuple[int, Node], list[tuple[int, int]]] = {}
        for axis, row in enumerate(rows):
            for k, term in enumerate(row):
                for turner in self._turners(term):
                    turned.setdefault(turner, []).append((axis, k))

        def total(places: Iterable[tuple[int, int]]) -> Vector:
            kept: tuple[list[Node], list[Node], list[Node]] = ([], [], [])
            for axis, k in places:
                if (axis, k) not in gone:
                    kept[axis].append(rows[axis][k])
            return g.sum(kept[0]), g.sum(kept[1]), g.sum(kept[2])

        waiting = sorted(turned, reverse=True)
        while waiting:
            turner = waiting.pop(0)
            own = total(turned[turner])
            frame = self.frames.of(own) if any(own) else None
            if frame is not None:
                found.append((frame, own))
                gone.update(turned.pop(turner))
                waiting = sorted(turned, reverse=True)
        return found, total((axis, k) for axis, row in enumerate(rows) for k in range(len(row)))

    def _turners(self, term: Node) -> frozenset[tuple[int, Node]]:
        """The angles and the rotations that stand in a product, each as a number and a node."""
        if term not in self._turned_by:
            g = self.graph
            nodes = reachable(g, list_factors(g, term), self.frames.moving)
            angles = {(0, g.a[node]) for node in nodes if g.op[node] in ("sin", "cos")}
            entries = {(1, self.frames.rotation_of(node)) for node in nodes if self.frames.rates.is_entry(node)}
            self._turned_by[term] = frozenset(angles | entries)
        return self._turned_by[term]


def _count_parts(points: Sequence[Point]) -> int:
    """Vectors that are added up on the way to all of them."""
    seen, stack = dict[int, Point](), list(points)
    while stack:
        point = stack.pop()
        if id(point) not in seen:
            seen[id(point)] = point
            stack += [point.base] if point.base is not None else []
    return sum(len(point.arms) + any(point.loose) for point in seen.values())
