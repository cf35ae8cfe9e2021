"""Derivatives along the vectors of a system that has rotations: in their closed forms, else in the coordinates themselves."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import NotLinear, linear_form
from nhc.mechanics.rotations.rotation import Rotation, put, square
from nhc.mechanics.rotations.turns import Vector
from nhc.mechanics.system import Form, System

# --- vectors ------------------------------------------------------------------------------------------------


def from_base(system: System, b: Sequence[Node], rotations: Sequence[Rotation]) -> tuple[Node, ...]:
    """The vector with these components along the base coframe."""
    made = list(b)
    for rotation in rotations:
        first, x, y, z = (b[k] for k in rotation.places)
        for k, node in zip(rotation.places, rotation.velocities(system.graph, (first, x, y, z)), strict=True):
            made[k] = node
    return tuple(made)


def along(system: System, x: Sequence[Node]) -> dict[Node, Node]:
    """Seeds of the derivative along a vector x over the coordinates."""
    found = dict(zip(system.q, x, strict=True))
    for rotation in system.rotations:
        rates = [x[k] for k in rotation.places]
        if any(rates):
            found.update(rotation.seeds(system.graph, rates))
    return found


class Direction:
    """A vector (x, time) over the coordinates with what derivatives along it take, each made once.

    ``reach`` are the coordinates that it moves, and the time; ``components`` are those along dq_i, then along the rotations'
    omega.
    """

    def __init__(self, system: System, x: Sequence[Node], time: Node = 0) -> None:
        self.system, self.x, self.time = system, x, time
        g = system.graph
        self.reach = g.mask([q for q, node in zip((*system.q, system.t), (*x, time), strict=True) if node != g.zero])
        self._slopes: dict[tuple[Node, ...], list[Node]] = {}

    @cached_property
    def seeds(self) -> dict[Node, Node]:
        """Of the derivative along it."""
        return {**along(self.system, self.x), self.system.t: self.time}

    @cached_property
    def turns(self) -> list[Vector]:
        """The rotations' omega along it."""
        g = self.system.graph
        turning = (r.turning(g, [self.x[k] for k in r.places]) for r in self.system.rotations)
        return [(a, b, c) for _, a, b, c in turning]

    @cached_property
    def components(self) -> list[Node]:
        return [*self.x, *(w for turn in self.turns for w in turn)]

    def slopes(self, nodes: tuple[Node, ...]) -> list[Node]:
        """Their derivatives along it."""
        if nodes not in self._slopes:
            self._slopes[nodes] = tangent(self.system.graph, nodes, self.seeds)
        return self._slopes[nodes]


def moving(system: System, x: Sequence[Node]) -> dict[Node, Node]:
    """The velocities with the values x, for substitution; for a vector x, the seeds of the derivative by velocities."""
    found = dict(zip(system.v, x, strict=True))
    for rotation in system.rotations:
        found.update(rotation.moving(system.graph, [x[k] for k in rotation.places]))
    return found


def virtual_work(system: System, forces: Sequence[Node], torques: Sequence[Node], e: Sequence[Node]) -> Node:
    """Q_i e_i of the forces without potential: what turns a rotation by its torque and the angular velocity of e."""
    g, terms = system.graph, list(zip(forces, e, strict=True))
    for k, rotation in enumerate(system.rotations):
        omega = rotation.turning(g, [e[i] for i in rotation.places])[1:]
        terms += zip(torques[3 * k : 3 * k + 3], omega, strict=True)
        for i in rotation.places:
            terms[i] = (g.zero, e[i])
    return g.sum([g.mul(q, x) for q, x in terms])


# --- forms --------------------------------------------------------------------------------------------------

Spread = tuple[tuple[Node, ...], Node]
"""Coefficients of a velocity form, and its constant."""


def spread(graph: Graph, v: Sequence[Node], rotations: Sequence[Rotation], value: Node) -> Spread | None:
    """Coefficients of a velocity form by q' and by the rotations' omega, where it is written with these, and its constant."""
    g = graph
    memo: dict[Node, Spread | None] = g.memory.setdefault("forms by angular velocities", {})
    if value not in memo:
        mapping: dict[Node, Node] = {}
        symbols = [g.symbol(f"{r.name}_turn{k}", "test") for r in rotations for k in range(3)]
        nodes = [w for r in rotations for w in r.omega]
        for node, symbol in zip(nodes, symbols, strict=True):
            put(g, mapping, node, symbol)
        try:
            memo[value] = linear_form(g, substitute(g, [value], mapping)[0], (*v, *symbols))
        except NotLinear:
            memo[value] = None
    return memo[value]


def derivative_by_turns(system: System, form: Form, x: Direction, e: Direction) -> Node | None:
    """d form (X, e) = X(f_k) theta_k(e) - e(f_k) theta_k(X) + f_k d theta_k (X, e) for form = f_k theta_k + f_0 dt.

    The theta_k are the dq_i and the rotations' omega.  None where the form's own words are not known.
    """
    g = system.graph
    found = spread(g, system.v, system.rotations, form.value) if form.value is not None else None
    if found is None:
        return None
    coefficients, constant = found
    turned = [g.zero] * system.n
    for rotation, wx, we in zip(system.rotations, x.turns, e.turns, strict=True):
        turned += rotation.curl(g, wx, we) if any(wx) and any(we) else (g.zero,) * 3
    moved = x.slopes(coefficients)
    back = tangent(g, [*coefficients, constant], e.seeds)
    total = g.dot(moved, e.components)
    total = g.sub(total, g.dot(back, (*x.components, x.time)))
    return g.add(total, g.dot(coefficients, turned))


def rows_in_base(system: System, forms: Sequence[Form]) -> list[list[Node]]:
    """The coefficients of velocity forms, one row each, in the base coframe.

    Its forms are q', with (|e|^2)' and the three components of omega in place of the four e' of each rotation.
    """
    g = system.graph
    if not system.rotations:
        return [list(form.coefficients) for form in forms]
    base = [g.symbol(name, "base") for name in system.q_names]
    plain = [g.dot(form.coefficients, system.v) for form in forms]
    own = [plain[k] if form.value is None else form.value for k, form in enumerate(forms)]
    values = substitute(g, own, moving(system, from_base(system, base, system.rotations)))
    columns = [tangent(g, values, {symbol: g.one}) for symbol in base]
    return [list(row) for row in zip(*columns, strict=True)]


def regular_energy(system: System) -> Node:
    """T, with half a weight times (e e')^2 for each rotation: the length of a quaternion is given the inertia of a mean axis.

    The term is zero with its derivatives on every motion, so it changes nothing but the mass matrix, which T itself leaves
    singular along e.
    """
    g, total = system.graph, system.T
    momenta = gradient(g, system.T, system.v) if system.rotations else []
    for rotation in system.rotations:
        trace = g.sum([gradient(g, momenta[k], [system.v[k]])[0] for k in rotation.places])
        weight = g.div(trace, g.mul(g.number(24), square(g, rotation.e)))
        total = g.add(total, g.mul(weight, g.power(rotation.growth, 2)))
    return total


def mass_matrix(system: System) -> list[Node]:
    """d2T/dq'dq', row by row, of :func:`regular_energy`."""
    g = system.graph
    momenta = gradient(g, regular_energy(system), system.v)
    return [entry for p in momenta for entry in gradient(g, p, system.v)]
