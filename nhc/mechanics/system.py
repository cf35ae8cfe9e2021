"""A mechanical system as nodes of one graph: what every formulation starts from.

Index conventions are the thesis's: ``i, j, k`` run over the n coordinates, ``alpha, beta`` over the l constraints,
``mu, nu`` over the n - l free velocities, ``r, s`` over coordinates and time.  Q_i of the potential is +dU/dq_i, and
a reaction enters as Q_i + lambda_alpha a_alpha_i.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from functools import cached_property, partial

from nhc.algebra.calculus import derivative
from nhc.algebra.graph import Graph, Node
from nhc.algebra.solving.linear import linear_form
from nhc.language import Spec
from nhc.language.units.derived import derive_units
from nhc.mechanics.rotations.rotation import Rotation
from nhc.records import record


@record
class Line:
    """All that some constraints leave to the velocities in ``columns``: q' = vector omega + carried there, omega the form's value.

    ``square`` is ``dual`` times the vector, a sum of squares, which vanishes only where those constraints lose rank.
    """

    columns: tuple[int, ...]
    vector: tuple[Node, ...]
    """n entries, as of ``dual`` and ``carried``; zero in other columns."""
    dual: tuple[Node, ...]
    """Those of the vector over squares of parameters."""
    carried: tuple[Node, ...]
    square: Node
    over: tuple[Node, ...]
    """Parameters that the vector is divided by."""

    def value(self, graph: Graph, velocities: Sequence[Node]) -> Node:
        """omega times ``square``, by all velocities."""
        return graph.dot(self.dual, [graph.sub(v, u) for v, u in zip(velocities, self.carried, strict=True)])


class Form:
    """A velocity form: coefficients_i * q'_i + constant; as a constraint it is zero, as a quasi-velocity it is omega.

    ``equation`` is f for a holonomic constraint f(q, t) = 0, whose derivative the form is.  ``value`` is the form as
    the spec wrote it, over the velocities' symbols, where it was written: it shares what the coefficients repeat, which
    a written form reads off when they are first asked for (:meth:`written`).  ``line`` is known of a form that was made for it.
    """

    __slots__ = ("_linear", "_read", "equation", "line", "name", "place", "value")

    def __init__(
        self,
        name: str,
        coefficients: tuple[Node, ...],
        constant: Node,
        place: str = "",
        equation: Node | None = None,
        value: Node | None = None,
        line: Line | None = None,
    ) -> None:
        self.name, self.place, self.equation, self.value, self.line = name, place, equation, value, line
        self._linear: tuple[tuple[Node, ...], Node] | None = (coefficients, constant)
        self._read: Callable[[], tuple[tuple[Node, ...], Node]] | None = None

    @classmethod
    def written(
        cls,
        name: str,
        value: Node,
        graph: Graph,
        velocities: tuple[Node, ...],
        place: str,
        equation: Node | None = None,
    ) -> Form:
        """A form by its value, which is linear in the velocities."""
        form = cls(name, (), graph.zero, place, equation, value)
        form._linear, form._read = None, partial(linear_form, graph, value, velocities)
        return form

    def _known(self) -> tuple[tuple[Node, ...], Node]:
        if self._linear is None:
            assert self._read is not None
            self._linear = self._read()
        return self._linear

    @property
    def coefficients(self) -> tuple[Node, ...]:
        """One for each velocity."""
        return self._known()[0]

    @property
    def direction(self) -> tuple[Node, ...]:
        """The coefficients up to a factor: that of a line vanishes, where others would be infinite."""
        return self.line.vector if self.line is not None else self.coefficients

    @property
    def constant(self) -> Node:
        """What is left where all velocities are zero."""
        return self._known()[1]

    def _key(self) -> tuple[object, ...]:
        return (self.name, *self._known(), self.place, self.equation, self.value)

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Form) and self._key() == other._key())

    def __hash__(self) -> int:
        return hash(self._key())


@record
class Pulls:
    """Forces without potential by what they are given on, where these are positions: coordinates and defined positions.

    A spring and a damper between two points pull along one direction: with the potential's slope by the same position they are
    added before they are multiplied by what moves it.
    """

    forces: tuple[tuple[Node, Node], ...]
    """(position, force); coordinates come last."""
    rest: tuple[Node, ...]
    """What of Q_i is not in these."""


Torques = tuple[tuple[Node, Node, Node], ...]
"""By the angular velocity of each rotation."""


@record
class Given:
    """Forces ``on`` velocities of the spec; ``without(names)`` is what Q and the torques are with those on some of them left out.

    It belongs to one ``Q`` with its ``torques``, and says nothing of others.
    """

    Q: tuple[Node, ...]
    torques: Torques
    on: tuple[tuple[Node, Form], ...]
    without: Callable[[Collection[str]], tuple[tuple[Node, ...], Torques]]


@record
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
    torques: Torques = ()
    """Of ``forces``, by the angular velocity of each rotation; ``Q`` holds them by coordinate."""
    pulls: Pulls | None = None
    """``Q`` in another way; None where there are rotations, or Q is not the spec's own."""
    given: Given | None = None

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
    def units(self) -> dict[str, str]:
        """The unit of each name that a trajectory may have, as far as the spec's units tell it."""
        known: dict[str, str] | None = self.graph.memory.get("units")
        if known is None:
            known = self.graph.memory["units"] = derive_units(self.spec)
        return known

    @cached_property
    def q_names(self) -> tuple[str, ...]:
        return tuple(self.symbol_name(node) for node in self.q)

    @property
    def angular(self) -> frozenset[str]:
        """The names of the rotations' angular velocities, which are quasi-velocities as those of the spec are."""
        return frozenset(name for rotation in self.spec.rotations for name in rotation.velocities)

    @property
    def turned(self) -> frozenset[str]:
        """The names of the rotations' quaternions, which are coordinates as those of the spec are."""
        return frozenset(name for rotation in self.spec.rotations for name in rotation.coordinates)

    def symbol_name(self, node: Node) -> str:
        symbol = self.graph.symbol_of(node)
        assert symbol is not None
        return symbol.name

    def force(self, i: int) -> Node:
        """Q_i, all of it: dU/dq_i and the forces that have no potential."""
        return self.graph.add(derivative(self.graph, self.U, self.q[i]), self.Q[i])

    @property
    def energy(self) -> Node:
        """T + V."""
        return self.graph.sub(self.T, self.U)
