"""Moving frames: T's vectors and the constraints on the axes in which they are short.

A vector's square is the same on any axes, and its rate on axes that turn with Omega is d/dt of the components plus Omega x
components.  So each vector of T (:mod:`nhc.mechanics.moving.vectors`) gets a home, the axes on which most of its components are
constraint or quasi-velocity forms: an axle's sideways velocity is then zero and its forward velocity one product.  Everything
follows from bases to what stands on them, as in a hand-written recursion, and every identification is an exact identity.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from functools import cached_property

from nhc.algebra.calculus import Derivation
from nhc.algebra.graph import Graph, Node
from nhc.mechanics.moving.signatures import Signatures
from nhc.mechanics.moving.vectors import Chained, Part, Reader
from nhc.mechanics.rotations.turns import Path, Turn, Vector, add_spin, add_vectors, change_axes, climb, cross
from nhc.mechanics.row_factors import Bare
from nhc.mechanics.system import System
from nhc.records import fresh, record, structure


@record
class Home:
    """A vector's velocity on its home axes, over the velocities' symbols and the held ones.

    ``settled``: some component is a form of the frame; ``known``: every one that is not zero is; ``root``: it
    stands on no other vector.
    """

    path: Path
    velocity: Vector
    settled: bool
    known: bool
    root: bool


@structure
class Setting:
    """What is known while vectors are placed, bases first."""

    system: System
    held: tuple[Node, ...]  # one symbol for each form, the constraints' first
    values: tuple[Node, ...]  # of the forms, over the velocities' symbols
    marks: Signatures
    forms: dict[tuple[int, ...], Node]  # signature of a form or of its negative -> held symbol, signed
    positions: Reader
    velocities: Reader
    bare: tuple[Bare, ...]  # the constraints' rows, which the held symbols stand for, with the factors that they had
    equations: dict[Vector, tuple[Path, Vector]] = fresh(factory=dict)
    homes: dict[tuple[bool, Vector], Home] = fresh(factory=dict)
    paths: list[Path] = fresh(factory=list)
    rows: dict[int, Node] = fresh(factory=dict)  # shorter expressions of forms, by number
    spins: dict[Path, Vector] = fresh(factory=dict)
    meaning: dict[Node, Node] = fresh(factory=dict)  # symbols of turned equations -> turned held symbols
    unknown: dict[Node, Node] = fresh(factory=dict)  # components at home that take the place of velocities
    given: dict[Node, Node] = fresh(factory=dict)  # those velocities, from the components
    dropped: set[int] = fresh(factory=set)  # forms that are among the components
    # the spec's expressions of angular velocities -> the chain's
    replaced: dict[Node, Node] = fresh(factory=dict)
    pairs: set[tuple[bool, Vector]] = fresh(factory=set)  # vectors of which T has two components and no third
    backs: tuple[Turn, ...] = ()  # constant turns to axes on which the spec may have its components

    @cached_property
    def _derivation(self) -> Derivation:
        system = self.system
        return Derivation(self.graph, {**dict(zip(system.q, system.v, strict=True)), system.t: self.graph.one})

    @property
    def graph(self) -> Graph:
        return self.system.graph

    @cached_property
    def symbols(self) -> tuple[Node, ...]:
        """One for each form as the spec wrote it: the held one, where that stands for it."""
        return (*(self._symbol(j) for j in range(len(self.bare))), *self.held[len(self.bare) :])

    def _symbol(self, j: int) -> Node:
        return self.held[j] if self.bare[j].factor == self.graph.one else self.graph.symbol(f"written_{j}", "quasi")

    @cached_property
    def as_written(self) -> dict[Node, Node]:
        """Held symbols of rows that had factors, in terms of ``symbols``."""
        g, pairs = self.graph, zip(self.held, self.symbols, self.bare, strict=False)
        return {x: g.div(symbol, own.factor) for x, symbol, own in pairs if x != symbol}

    def spin(self, path: Path) -> Vector:
        """Angular velocity of the axes, on themselves."""
        g = self.graph
        if not path:
            return g.zero, g.zero, g.zero
        known = self.spins.get(path)
        if known is None:
            rate = self.rate(path[-1].angle)
            known = self.spins[path] = add_spin(g, path[-1], self.spin(path[:-1]), rate)
        return known

    def rate(self, node: Node) -> Node:
        """d node / dt over the velocities' symbols."""
        return self._derivation.of(node)

    def local_velocity(self, part: Part, is_position: bool) -> Vector:
        if not is_position:
            return part.local
        g = self.graph
        rates = tuple(self.rate(x) for x in part.local)
        return add_vectors(g, (rates[0], rates[1], rates[2]), cross(g, self.spin(part.path), part.local))

    # --- homes ------------------------------------------------------------------------------------------------

    def home(self, vector: Chained, is_position: bool) -> Home:
        """The axes and the components of a vector's velocity there."""
        key = (is_position, vector.components)
        found = self.homes.get(key)
        if found is None:
            found = self.homes[key] = self._place(vector, is_position)
        return found

    def _place(self, vector: Chained, is_position: bool) -> Home:
        g = self.graph
        velocity = self.velocity_of(vector, is_position)
        if velocity in self.equations:
            path, local = self.equations[velocity]
            return Home(path, local, True, True, vector.base is None)
        best: tuple[int, Home, dict[int, Node]] | None = None
        for path in self._candidates(vector, is_position):
            components = self.components_in(vector, is_position, path)
            settled, rows = self._settle(components)
            score = len(rows)
            known = score >= sum(x != g.zero for x in components)
            if best is None or score > best[0]:
                best = (score, Home(path, settled, score > 0, known, vector.base is None), rows)
            if known:
                break
        assert best is not None
        _, home, rows = best
        for j, node in rows.items():
            self.rows.setdefault(j, node)
        own = [node for node in velocity if node != g.zero]
        if vector.base is None and home.path and rows and all(v in self.system.v and v not in self.given for v in own):
            return self._take_as_unknowns(home, velocity, rows)
        return home

    def _take_as_unknowns(self, home: Home, velocity: Vector, rows: Iterable[int]) -> Home:
        """A root's velocity in the coordinates is given by its components at home: those that no form settles are unknowns."""
        g, components = self.graph, list(home.velocity)
        for k, node in enumerate(components):
            if node == g.zero or node in self.held or g.neg(node) in self.held:
                continue
            symbol = g.symbol(f"along_{len(self.unknown)}", "unknown")
            self.unknown[symbol] = node
            self.marks.bind({symbol: node})
            components[k] = symbol
        self.dropped |= set(rows)
        at_home = (components[0], components[1], components[2])
        for v, node in zip(velocity, change_axes(g, at_home, home.path, ()), strict=True):
            if v != g.zero:
                self.given[v] = node
        return replace(home, velocity=at_home)

    def velocity_of(self, vector: Chained, is_position: bool) -> Vector:
        if not is_position:
            return vector.components
        rates = [self.rate(x) for x in vector.components]
        return rates[0], rates[1], rates[2]

    def _candidates(self, vector: Chained, is_position: bool) -> list[Path]:
        own = [part.path for part in vector.parts if part.path]
        if not own:
            own = [*self.paths, ()] if vector.base is None else [self.home(vector.base, is_position).path]
        if (is_position, vector.components) not in self.pairs:
            return own
        # on other axes it would have a third component, which is no form of T
        return [path for path in own if all({*turn.plane} == {0, 1} for turn in path)] or [()]

    def components_in(self, vector: Chained, is_position: bool, path: Path) -> Vector:
        """The velocity on the axes of a path: what has the base's axes is added before they are changed."""
        g = self.graph
        base = None if vector.base is None else self.home(vector.base, is_position)
        at, start = ((), (g.zero, g.zero, g.zero)) if base is None else (base.path, base.velocity)
        local = [(part.path, self.local_velocity(part, is_position)) for part in vector.parts]
        return climb(g, start, at, path, local)

    def _settle(self, components: Vector) -> tuple[Vector, dict[int, Node]]:
        """Components that are forms become their held symbols; the forms' numbers with the expression found."""
        g = self.graph
        new, rows = list(components), dict[int, Node]()
        for k, node in enumerate(components):
            if node == g.zero:
                continue
            symbol = self.forms.get(self.marks.of(node))
            if symbol is None:
                continue
            new[k] = symbol
            negative = symbol not in self.held
            rows[self.held.index(g.neg(symbol) if negative else symbol)] = g.neg(node) if negative else node
        return (new[0], new[1], new[2]), rows
