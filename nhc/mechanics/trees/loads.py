"""Rigid bodies as loads on a joint: mass, first moments and inertia; and what a joint bears, a force with a moment."""

from __future__ import annotations

from nhc.algebra.graph import Graph, Node
from nhc.mechanics.rotations.turns import Vector, add_vectors, cross, scale_vector
from nhc.mechanics.trees.frames import ZERO
from nhc.mechanics.trees.tensors import NONE, Tensor, add_tensors, move_inertia, times, turn_tensor
from nhc.mechanics.trees.views import Matrix
from nhc.records import structure


@structure
class Load:
    """Mass, first moments and inertia about a link's origin, on its axes."""

    mass: Node = 0
    first: Vector = ZERO
    inertia: Tensor = NONE

    def add_point(self, graph: Graph, mass: Node, place: Vector) -> None:
        """A point mass."""
        self.inertia = move_inertia(graph, self.inertia, mass, ZERO, place)
        self.mass = graph.add(self.mass, mass)
        self.first = add_vectors(graph, self.first, scale_vector(graph, mass, place))

    def add(self, graph: Graph, other: Load) -> None:
        """What is carried, too."""
        self.mass = graph.add(self.mass, other.mass)
        self.first = add_vectors(graph, self.first, other.first)
        self.inertia = add_tensors(graph, self.inertia, other.inertia)

    def turned(self, graph: Graph, matrix: Matrix) -> Load:
        """On other axes."""
        return Load(
            self.mass,
            times(graph, matrix, self.first),
            turn_tensor(graph, (matrix[0], matrix[1], matrix[2]), self.inertia),
        )

    def moved(self, graph: Graph, offset: Vector) -> Load:
        """About a point from which the origin is ``offset``."""
        inertia = move_inertia(graph, self.inertia, self.mass, self.first, offset)
        return Load(self.mass, add_vectors(graph, self.first, scale_vector(graph, self.mass, offset)), inertia)


@structure
class Wrench:
    """Force, and moment about a link's origin, on its axes."""

    force: Vector = ZERO
    moment: Vector = ZERO

    def turned(self, graph: Graph, matrix: Matrix) -> Wrench:
        """On other axes."""
        return Wrench(times(graph, matrix, self.force), times(graph, matrix, self.moment))

    def moved(self, graph: Graph, offset: Vector) -> Wrench:
        """About a point from which the origin is ``offset``."""
        return Wrench(self.force, add_vectors(graph, self.moment, cross(graph, offset, self.force)))

    def add(self, graph: Graph, other: Wrench) -> None:
        """The sum."""
        self.force = add_vectors(graph, self.force, other.force)
        self.moment = add_vectors(graph, self.moment, other.moment)
