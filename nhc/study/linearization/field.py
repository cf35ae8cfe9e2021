"""The field of a model as numbers: rates and their slopes at a point, conditions on it, and what a steady motion may go along."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import Node
from nhc.algebra.walks import reachable
from nhc.mechanics.flow import Flow
from nhc.mechanics.frame import Frame, form_value
from nhc.mechanics.linearize import HiddenLeaf
from nhc.mechanics.properties.symmetry import Generator
from nhc.records import record
from nhc.study.linearization.tape import Tapes
from nhc.study.linearization.turns import Turn, turn_of
from nhc.study.linearization.units import Matrix, Units, Vector, beside, choose_units, cleaned, trials

RANK = 1e-9
"""Singular values below this part of the largest one count as zero."""
SINGULAR = 1e-6
"""Where the coordinates are less regular than this they fail themselves (gimbal lock), and nothing can be said."""

_PART = 0.1  # of a velocity in a direction that nothing holds


@record
class Hold:
    """A quantity that a steady motion shall have: ``node`` over the state equals ``value``."""

    name: str
    node: Node
    value: float


@dataclass(frozen=True)
class SteadyModel:
    """A field with its parameters' values; ``rest`` are the entries of the state that are not cyclic.

    ``symmetries`` are groups of turns and shifts that a steady motion may go along: it stands still in axes that move with
    it, by ``turning``; ``generators`` are they as functions of the parameters.  ``units``: those of every state and rate that goes
    in or comes out, where they are not the spec's.  ``leaf_holds``: what hidden holonomic constraints hold, see
    :mod:`nhc.study.linearization.leaf`.  ``in_doubles``: a search need not tell a root that is multiple to its last digit.
    """

    flow: Flow
    frame: Frame | None
    leaf: HiddenLeaf
    cyclic: tuple[int, ...]
    p: tuple[float, ...]
    tapes: Tapes
    symmetries: tuple[tuple[Turn, ...], ...] = ()
    generators: tuple[tuple[Generator, ...], ...] = ()
    turning: Turn | None = None
    units: Units | None = None
    leaf_holds: tuple[Hold, ...] = ()
    in_doubles: bool = False

    @cached_property
    def rest(self) -> tuple[int, ...]:
        return tuple(i for i in range(len(self.flow.y)) if i not in self.cyclic)

    @cached_property
    def angles(self) -> tuple[int, ...]:
        """Entries of the state that are angles in radians, for sines and cosines are taken of them."""
        flow, g = self.flow, self.flow.graph
        count = len(flow.velocities)
        heads = [*flow.velocities, *flow.right, *(x for row in flow.matrix for x in row)]
        turned = dict.fromkeys(g.a[node] for node in reachable(g, heads) if g.op[node] in ("sin", "cos"))
        slopes = [gradient(g, angle, flow.y[:count]) for angle in turned]
        return tuple(k for k in range(count) if any(abs(g.value(row[k]) or 0) == 1 for row in slopes))

    def with_parameter(self, index: int, value: float) -> SteadyModel:
        return self.with_parameters((*self.p[:index], value, *self.p[index + 1 :]))

    def with_parameters(self, p: tuple[float, ...]) -> SteadyModel:
        """The model at other values, in the spec's units."""
        flow, values = self.flow, dict(zip(self.flow.system.p, p, strict=True))
        groups = ((turn_of(flow.graph, one, len(flow.y), values) for one in group) for group in self.generators)
        return replace(self, p=p, symmetries=tuple(map(tuple, groups)))

    def values(self, y: Sequence[float]) -> dict[Node, float]:
        """Each symbol of the state, the parameters and the time with its value, in the spec's units."""
        system = self.flow.system
        y = self.outside(y)
        return {
            system.t: 0.0,  # the field does not depend on it
            **dict(zip(system.p, self.p, strict=True)),
            **{node: float(x) for node, x in zip(self.flow.y, y, strict=True)},
        }

    def field(self, y: Sequence[float]) -> tuple[Vector, Matrix]:
        """f(y) of shape (NY,) and df/dy of shape (NY, NY) on turning axes, exact but for rounding.

        Raises:
            ArithmeticError: the model is singular at y.
        """
        flow, values = self.flow, self.values(y)
        size, unknowns, kept = len(flow.y), len(flow.unknowns), flow.kept
        heads = [*flow.velocities, *flow.right, *(x for row in flow.matrix for x in row)]
        numbers = self.tapes.numbers(heads, values)
        n = len(flow.velocities)
        matrix = numbers[n + unknowns :].reshape(unknowns, unknowns)
        solution = _solve(matrix, numbers[n : n + unknowns])
        values.update(zip(flow.unknowns, (float(x) for x in solution), strict=True))
        tails = [x for row in (*flow.velocity_slopes, *flow.residual_slopes) for x in row]
        slopes = self._slopes(tails, y, values).reshape(n + unknowns, size)
        rates = _solve(matrix, slopes[n:])[:kept]
        field, jacobian = np.concatenate([numbers[:n], solution[:kept]]), np.vstack([slopes[:n], rates])
        if self.units is not None:
            states = np.array(self.units.states)
            field = field * self.units.time / states
            jacobian = jacobian * self.units.time * states / states[:, None]
        if self.turning is not None:
            field, jacobian = field - self.turning.at(y), jacobian - self.turning.matrix
        return field, jacobian

    def _slopes(self, tails: Sequence[Node], y: Sequence[float], values: dict[Node, float]) -> Vector:
        """Derivatives of what is regular at y.  As it is written, that of a drag v*sqrt(v^2) is 0/0 at rest, and on all sides of it
        next to nothing: what the derivatives beside y agree on is theirs at y.
        """
        try:
            return self.tapes.numbers(tails, values)
        except ArithmeticError:
            found = np.array([self.tapes.numbers(tails, values | self.values(near)) for near in beside(y)])
            mean = found.mean(axis=0)
            if not np.max(np.abs(found - mean), initial=0.0) <= RANK * (1.0 + np.max(np.abs(mean), initial=0.0)):
                raise
            return np.asarray(mean)

    def mass(self, y: Sequence[float]) -> Matrix:
        """The matrix of the kept velocities' rates at y (with multipliers: the bordered one)."""
        size = len(self.flow.unknowns)
        flat = [x for row in self.flow.matrix for x in row]
        return self.tapes.numbers(flat, self.values(y)).reshape(size, size)

    def regularity(self, y: Sequence[float]) -> float:
        """How far the coordinates are from being singular at y, in [0, 1]: the mass matrix, bordered by the constraints where these
        are kept (masses may then be zero), scaled to ones on its diagonal.
        """
        matrix, kept = self.mass(y), self.flow.kept
        mass = matrix[:kept, :kept]
        if len(matrix) == kept:
            return scaled_least(mass) if kept else 1.0
        own = np.abs(np.diag(mass))
        lengths = 1.0 / np.sqrt(np.where(own > 0.0, own, 1.0))
        rows = matrix[kept:, :kept] * lengths
        rows = rows / np.maximum(np.linalg.norm(rows, axis=1, keepdims=True), 1e-300)
        none = np.zeros((len(rows), len(rows)))
        bordered = np.block([[mass * np.outer(lengths, lengths), rows.T], [rows, none]])
        return float(np.linalg.svd(bordered, compute_uv=False)[-1])

    def presence(self, y: Sequence[float], guess: Sequence[float]) -> float:
        """The root of the least part that the inertia of a kept velocity has at y of what it has elsewhere, at most 1.

        It vanishes with the circles that an angle goes along, at a pole or a centre.  Elsewhere is where the search began, and all
        around: whichever has less, for a system may be small beside the units it is given in.
        """
        here, around = self._inertias(y), self._around_inertias(y)
        usual = np.minimum(self._inertias(guess), around)
        return math.sqrt(min((a / b for a, b in zip(here, usual, strict=True) if b > a), default=1.0))

    def idle_velocities(self, y: Sequence[float], guess: Sequence[float]) -> tuple[str, ...]:
        """The kept velocities that neither inertia nor a constraint holds at y, while something does all around: beside the inertia
        that they have there, or where the search began.
        """
        usual = np.maximum(self._around_inertias(y), self._inertias(guess))
        lengths = 1.0 / np.sqrt(np.where(usual > 0.0, usual, 1.0))
        here, beside = self._unheld(y, lengths), [self._unheld(near, lengths) for near in _around(y)]
        return tuple(name for name in here if not any(name in names for names in beside))

    def _unheld(self, y: Sequence[float], lengths: Vector) -> tuple[str, ...]:
        """The kept velocities, of these lengths, in directions without inertia that no constraint excludes."""
        try:
            matrix, kept = self.mass(y), self.flow.kept
        except ArithmeticError:
            return ()
        bordered = matrix[:, :kept] * lengths
        bordered[:kept] *= lengths[:, None]
        sizes, right = np.linalg.svd(bordered)[1:]
        least = right[sizes <= SINGULAR * np.max(sizes, initial=0.0)]
        names = self.flow.names[self.flow.system.n :]
        return tuple(name for k, name in enumerate(names) if np.any(np.abs(least[:, k]) > _PART))

    def _around_inertias(self, y: Sequence[float]) -> Vector:
        return np.asarray(np.max([self._inertias(y), *(self._inertias(near) for near in _around(y))], axis=0))

    def _inertias(self, y: Sequence[float]) -> Vector:
        """The diagonal of the kept velocities' mass matrix; zeros where it has no value."""
        try:
            return np.abs(np.diag(self.mass(y)))[: self.flow.kept]
        except ArithmeticError:
            return np.zeros(self.flow.kept)

    def lengths(self, y: Sequence[float]) -> list[float]:
        """What each coordinate moves in a time of 1 with half a unit of kinetic energy, at y or where its mass is larger.

        Places all around y count, for a mass that vanishes at a singular place of the coordinates makes no long ones of them.
        """
        g, system = self.flow.graph, self.flow.system
        momenta = gradient(g, system.T, system.v)
        masses = [gradient(g, p, [v])[0] for p, v in zip(momenta, system.v, strict=True)]
        largest = np.zeros(system.n)
        for near in (list(y), *_around(y)):
            with suppress(ArithmeticError):
                at = self.values(near)
                at.update((v, self.value(near, node)) for v, node in zip(system.v, self.flow.velocities, strict=True))
                largest = np.maximum(largest, self.tapes.numbers(masses, at))
        return [1.0 / math.sqrt(m) if m > 0.0 else 1.0 for m in largest]

    def value(self, y: Sequence[float], node: Node) -> float:
        """A function of the state."""
        return float(self.tapes.numbers([node], self.values(y))[0])

    @cached_property
    def conditions_as_nodes(self) -> tuple[tuple[Node, ...], tuple[tuple[Node, ...], ...]]:
        """Constraints that the state itself has to meet, and their slopes: positions, and velocities where all of them are kept."""
        flow, system = self.flow, self.flow.system
        nodes = [form.equation for form in system.constraints if form.equation is not None]
        if self.frame is None:
            nodes += [form_value(system, form) for form in system.constraints]
        return tuple(nodes), tuple(tuple(gradient(flow.graph, node, flow.y)) for node in nodes)

    def conditions(self, y: Sequence[float]) -> tuple[Vector, Matrix]:
        """Residuals of shape (K,) of the constraints on the state, and their slopes (K, NY)."""
        nodes, slopes = self.conditions_as_nodes
        values = self.values(y)
        flat = self.tapes.numbers([x for row in slopes for x in row], values)
        across = flat.reshape(len(nodes), len(self.flow.y))
        return self.tapes.numbers(nodes, values), across if self.units is None else across * self.units.states

    def held_directions(self, y: Sequence[float]) -> Matrix:
        """The slopes of the conditions, each beside its length here or a little away: one that vanishes at y alone stays small."""
        rows = self.conditions(y)[1]
        lengths = np.linalg.norm(rows, axis=1)
        with suppress(ArithmeticError):
            away = [x + 0.1 * math.cos(k + 1.0) for k, x in enumerate(y)]
            lengths = np.maximum(lengths, np.linalg.norm(self.conditions(away)[1], axis=1))
        return np.asarray(rows / np.maximum(lengths, 1e-300)[:, None])

    def slopes(self, y: Sequence[float], node: Node) -> Vector:
        """The gradient of a function of the state, shape (NY,)."""
        found = self.tapes.slopes(node, self.values(y))
        return found if self.units is None else found * self.units.states

    def normals(self, y: Sequence[float]) -> Matrix | None:
        """Orthonormal rows (over q) across the leaf through y; None where the brackets do not span the leaf there."""
        n, leaf = self.flow.system.n, self.leaf
        if leaf.dimension == n:
            return np.zeros((0, n))
        rows = leaf.normals or leaf.fields
        try:
            flat = self.tapes.numbers([x for row in rows for x in row], self.values(y)).reshape(len(rows), n)
        except ArithmeticError:
            return None
        if self.units is not None:  # normals are slopes, the fields beside them velocities
            states = np.array(self.units.states[:n])
            flat = flat * states if leaf.normals else flat / states
        lengths = np.linalg.norm(flat, axis=1, keepdims=True)
        _, sizes, right = np.linalg.svd(flat / np.maximum(lengths, 1e-300))
        found = int(np.sum(sizes > 1e-8 * sizes[0]))
        if leaf.normals:
            return right[:found] if found == n - leaf.dimension else None
        return right[found:] if found == leaf.dimension else None

    # --- units of the model's own: see nhc.study.linearization.units ---

    def in_units(self, y: Sequence[float]) -> SteadyModel:
        """The model in units in which its numbers at y (in the spec's) are near one; itself where they are.

        Raises:
            ArithmeticError: the model is singular at y.
        """
        try:
            zero = self.flow.graph.zero
            together = [[k for k, slope in enumerate(row) if slope != zero] for row in self.conditions_as_nodes[1]]
            units = choose_units(self.field(y)[1], y, self.rest, together, self.angles)
            if not units.own:  # rounding can look like something slow
                units = choose_units(self.clean_jacobian(y), y, self.rest, together, self.angles)
        except OverflowError:
            return self
        if units.own:
            return self
        states = np.array(units.states)
        turning = None if self.turning is None else self.turning.inside(states, units.time)
        groups = tuple(tuple(turn.inside(states) for turn in group) for group in self.symmetries)
        return replace(self, units=units, turning=turning, symmetries=groups)

    def clean_jacobian(self, y: Sequence[float]) -> Matrix:
        """df/dy without the entries that are rounding alone.

        Raises:
            ArithmeticError: the model is singular at y.
        """
        return cleaned(self.field(y)[1], [jacobian for _, jacobian in self.nearby(y)])

    def nearby(self, y: Sequence[float]) -> list[tuple[Vector, Matrix]]:
        """The field where the state and the parameters are what rounding may have made of them."""
        found = []
        for near, p in trials(y, self.p):
            with suppress(ArithmeticError):
                found.append(replace(self, p=p).field(near))
        return found

    def outside(self, y: Sequence[float] | Vector) -> tuple[float, ...]:
        """A state of the model in the spec's units."""
        states = (1.0,) * len(self.flow.y) if self.units is None else self.units.states
        return tuple(float(x) * unit for x, unit in zip(y, states, strict=False))

    def inside(self, y: Sequence[float] | Vector) -> tuple[float, ...]:
        """A state that is given in the spec's units in those of the model."""
        states = (1.0,) * len(self.flow.y) if self.units is None else self.units.states
        return tuple(float(x) / unit for x, unit in zip(y, states, strict=False))

    @property
    def tick(self) -> float:
        """The unit of time."""
        return 1.0 if self.units is None else self.units.time


def _solve(matrix: Matrix, right: Matrix) -> Matrix:
    if not matrix.size:
        return right
    try:
        return np.asarray(np.linalg.solve(matrix, right))
    except np.linalg.LinAlgError:
        raise ArithmeticError("the accelerations are not determined") from None


def scaled_least(mass: Matrix) -> float:
    """The least size of an eigenvalue of the mass matrix scaled to ones on its diagonal: 0 in a gimbal lock, and not because T is
    negative for some motion.
    """
    scale = np.sqrt(np.abs(np.diag(mass)))
    if not np.all(scale > 0):
        return 0.0
    return float(np.min(np.abs(np.linalg.eigvalsh(mass / np.outer(scale, scale)))))


def _around(y: Sequence[float]) -> list[list[float]]:
    """States all around, far off."""
    return [[x + (1.0 + abs(x)) * math.sin(k * (i + 1.0) ** 1.5) for i, x in enumerate(y)] for k in range(1, 5)]
