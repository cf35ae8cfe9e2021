"""A mechanical system as nodes of one graph: what every formulation starts from.

Index conventions are the thesis's: ``i, j, k`` run over the n coordinates, ``alpha, beta`` over the l constraints,
``mu, nu`` over the n - l free velocities, ``r, s`` over coordinates and time.  Q_i of the potential is +dU/dq_i, and
a reaction enters as Q_i + lambda_alpha a_alpha_i.
"""

from __future__ import annotations

from dataclasses import dataclass

from nhc.algebra.graph import Graph, Node
from nhc.language import Spec
from nhc.mechanics.rotation import Rotation


@dataclass(frozen=True, slots=True)
class Form:
    """A velocity form: coefficients_i * q'_i + constant; as a constraint it is zero, as a quasi-velocity it is omega.

    ``equation`` is f for a holonomic constraint f(q, t) = 0, whose derivative the form is.  ``value`` is the form as
    the spec wrote it, over the velocities' symbols, where it was written: it shares what the coefficients repeat.
    """

    name: str
    coefficients: tuple[Node, ...]
    constant: Node
    place: str = ""
    equation: Node | None = None
    value: Node | None = None


@dataclass(frozen=True, slots=True)
class System:
    """T, U and Q over q, q', p and t, with l constraint forms (I.1.1) and the spec's quasi-velocities (I.2.1)."""

    spec: Spec
    graph: Graph
    t: Node
    q: tuple[Node, ...]
    v: tuple[Node, ...]
    p: tuple[Node, ...]
    T: Node
    U: Node
    Q: tuple[Node, ...]
    constraints: tuple[Form, ...]
    quasi: tuple[Form, ...]
    dependent: tuple[int, ...]
    outputs: tuple[tuple[str, Node], ...]
    places: dict[str, str]
    rotations: tuple[Rotation, ...] = ()
    torques: tuple[tuple[Node, Node, Node], ...] = ()
    """Of ``forces``, by the angular velocity of each rotation; ``Q`` holds them by coordinate."""

    @property
    def n(self) -> int:
        return len(self.q)

    @property
    def l(self) -> int:  # noqa: E743 - the thesis's letter
        return len(self.constraints)

    @property
    def name(self) -> str:
        return self.spec.system

    @property
    def q_names(self) -> tuple[str, ...]:
        return tuple(self.symbol_name(node) for node in self.q)

    def symbol_name(self, node: Node) -> str:
        symbol = self.graph.symbol_of(node)
        assert symbol is not None
        return symbol.name

    def force(self, i: int) -> Node:
        """Q_i, all of it: dU/dq_i and the forces that have no potential."""
        from nhc.algebra.calculus import derivative

        return self.graph.add(derivative(self.graph, self.U, self.q[i]), self.Q[i])

    @property
    def energy(self) -> Node:
        """T + V."""
        return self.graph.sub(self.T, self.U)
