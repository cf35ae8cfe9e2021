"""The associated system of Omega as a program: one for all formulations.

A formulation fixes a motion: the velocities w it keeps, the kinematics q' = K(q, w, t), and the vectors e_mu that the
constraints leave free.  Omega = A_mu ^ (omega_mu - w_mu dt), so its interior product with the motion's field X is
A_mu(X) times the contact forms: the rows of the velocities' differentials hold by the kinematics, the rows A_mu(X) =
0 are the equations of motion, and the dt row is their combination with the weights -w_mu (Omega(X, X) = 0), the
theorem of energy.  A_mu(X) is evaluated by directional derivatives of T's velocity forms
(:mod:`nhc.mechanics.energies.kinetic`); no coefficient is ever expanded.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING

from nhc.algebra.calculus import gradient, pullback_gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import Replacement, substitute
from nhc.algebra.rewriting.along import add_along
from nhc.algebra.rewriting.gather import gather
from nhc.algebra.walks import count
from nhc.mechanics.energies.kinetic import Kinetic, exterior_derivative
from nhc.mechanics.motion import Motion
from nhc.mechanics.moving.moved import Moved, Spread, Weights
from nhc.mechanics.pulls import Joined
from nhc.mechanics.rotations.turning import Direction, moving, virtual_work
from nhc.mechanics.rotations.turns import Vector, cross
from nhc.mechanics.system import System
from nhc.records import record

if TYPE_CHECKING:
    from nhc.mechanics.frame import Frame
    from nhc.mechanics.trees.tree import Elimination

Matrix = tuple[tuple[Node, ...], ...]


@record
class Row:
    """A(X) = mass_nu w'_nu - force."""

    mass: tuple[Node, ...]
    force: Node


@record
class Equations:
    """mass @ w' = force over the motion's w; with multipliers, the bordered system for (q'', lambda).

    ``assemble`` makes both, when they are first asked for: a ``tree`` solves for the rates without them.
    ``definite``: the matrix is symmetric and positive wherever the motion is regular, so that LDL^T needs no pivoting.
    ``reactions`` are the rows of the constraints' own vectors (empty for the bordered system, whose unknowns they are);
    ``react`` makes them, and ``sweeps`` the reactions themselves, in other ways.
    ``kinetic`` makes T on the motion where the rows' axes have shorter words for it than the spec, else it gives None.
    ``guards`` are (quantity, scale) pairs that must not vanish for the frame to exist.
    """

    system: System
    formulation: str
    number: str
    motion: Motion
    assemble: Callable[[], tuple[Matrix, tuple[Node, ...]]]
    definite: bool
    multipliers: tuple[Node, ...]
    react: Callable[[], tuple[Row, ...]]
    sweeps: Callable[[], tuple[tuple[Node, ...], ...]]
    kinetic: Callable[[], Node | None]
    guards: tuple[tuple[Node, Node], ...]
    tree: Elimination | None = None

    @cached_property
    def _assembled(self) -> tuple[Matrix, tuple[Node, ...]]:
        return self.assemble()

    @property
    def mass(self) -> Matrix:
        """The mass matrix, row by row."""
        return self._assembled[0]

    @property
    def force(self) -> tuple[Node, ...]:
        """The right side."""
        return self._assembled[1]

    @cached_property
    def reactions(self) -> tuple[Row, ...]:
        """The rows of the constraints' own vectors, made when they are first asked for."""
        return self.react()


class Projector:
    """Contracts the Lagrange expression of one system with vectors along one motion.

    With ``moved``, T's forms are those on moving axes: their values, rates and weights are at hand; those of T's forms that are
    forms of ``frame``, too, are its velocities as they stand.
    """

    def __init__(
        self, system: System, kinetic: Kinetic, motion: Motion, moved: Moved | None, frame: Frame | None = None
    ) -> None:
        kinetic = moved.kinetic if moved else kinetic
        self.system, self.kinetic, self.motion = system, kinetic, motion
        g = system.graph
        self._constants, self._speeds = g.mask(system.p), g.mask(motion.w)
        on_motion = moving(system, motion.velocities)
        self._known = dict(zip(moved.frame.free_vectors, moved.weights, strict=True)) if moved else {}
        self._moved = moved is not None
        self.carried = moved.carried if moved else (False,) * len(kinetic.u)
        self._shared = {} if moved or frame is None else _shared_forms(kinetic, frame)
        self.u = list(moved.u) if moved else substitute(g, kinetic.atoms, on_motion)
        for k, (number, j) in self._shared.items():
            self.u[k] = g.mul_number(number, motion.w[j])
        to_motion = dict(zip(kinetic.u, self.u, strict=True))
        count = len(kinetic.u)
        places = [[(j, h) for j, h in enumerate(row) if h] for row in kinetic.hessian]
        values = iter(substitute(g, [*kinetic.slope, *(h for row in places for _, h in row)], to_motion))
        self.pi = [next(values) for _ in range(count)]
        self.hessian = [[(j, next(values)) for j, _ in row] for row in places]  # what is not zero, with its columns
        self._values = {**on_motion, **to_motion}
        self._to_motion = Replacement(g, self._values)
        self._on_places = Replacement(g, moved.places if moved else {})
        self._along = Direction(system, motion.velocities, g.one)
        self._places = {} if frame is None else {tuple(e): j for j, e in enumerate(motion.vectors)}
        self.columns = [self.components(e) for e in motion.vectors]  # W_k(e_nu)
        drift = moved.drift if moved else tangent(g, self.u, self._along.seeds)
        explicit = self._to_motion.of(self._explicit_rates())
        self.pi_drift = [
            g.add(explicit[k], g.sum([g.mul(h, drift[j]) for j, h in self.hessian[k]])) for k in range(count)
        ]
        self._potential = moved.potential if moved else system.U
        self._gyro = self._add_turning(moved) if moved else []

    def components(self, e: Sequence[Node]) -> list[Node]:
        """W_k(e) for every velocity form."""
        g = self.system.graph
        known = self._known.get(tuple(e))
        if known is not None:
            return list(known.forms)
        found = self._to_motion.of(tangent(g, self.kinetic.atoms, moving(self.system, e)))
        place = self._places.get(tuple(e))
        if place is not None:
            for k, (number, j) in self._shared.items():
                found[k] = g.number(number) if j == place else g.zero
        return found

    def _explicit_rates(self) -> list[Node]:
        """d pi_k / dt at fixed u: only where T's coefficients move."""
        return tangent(self.system.graph, self.kinetic.slope, self._along.seeds)

    def rows(self) -> list[Row]:
        """Those of the motion's own vectors; what is symmetric is made once."""
        made: list[Row] = []
        for k, e in enumerate(self.motion.vectors):
            row = self.row(e, first=k)
            made.append(Row((*(above.mass[k] for above in made), *row.mass), row.force))
        return made

    def row(self, e: Sequence[Node], known: Weights | None = None, first: int = 0) -> Row:
        """A(X) for the vector e: mass_nu w'_nu - force, with the columns of the mass from ``first`` on."""
        g, system = self.system.graph, self.system
        known = known or self._known.get(tuple(e))
        weights = known.forms if known else self.components(e)
        momenta = self._momenta(weights)
        mass, force_terms = [], []
        held = [(k, momentum) for k, momentum in enumerate(momenta) if momentum != g.zero]
        for column in self.columns[first:]:
            mass.append(self._gather([(momentum, column[k]) for k, momentum in held]))
        direction = Direction(system, e)
        for k, weight in enumerate(weights):
            force_terms.append((weight, self.pi_drift[k]))
            if not self.carried[k] and not self.kinetic.is_exact(k):
                turn = exterior_derivative(system, self.kinetic.form(k), self._along, direction)
                force_terms.append((self.pi[k], turn))
        force_terms += self._turning_terms(known.spins if known else ())
        inertial = self._gather(force_terms)
        slopes = self._to_motion.of(tangent(g, [self.kinetic.tau], direction.seeds))[0]
        forces = g.add(slopes, self._joined.work(direction)) if self._joined else self._work(direction, slopes)
        return Row(tuple(mass), g.sub(forces, inertial))

    def _work(self, direction: Direction, slopes: Node) -> Node:
        """Along a vector, that of the potential, of the other forces, and of T's own slopes."""
        g, e = self.system.graph, direction.x
        applied = virtual_work(self.system, *self._applied(), e)
        potential = self._on_places.of(tangent(g, [self._potential], direction.seeds))[0]
        # along a vector of several entries, what both forces have in common are these
        outer = add_along(g, potential, applied, self._constants) if _is_unit(g, e) else None
        return g.add(g.add(slopes, potential), applied) if outer is None else g.add(slopes, outer)

    @cached_property
    def _joined(self) -> Joined | None:
        """The forces by what they act on, where all rows together are shorter with them."""
        g, system = self.system.graph, self.system
        if self._moved or system.pulls is None or g.zero == system.U or "gathered sums" in g.off:
            return None
        joined = Joined(system, system.pulls, self._to_motion.of)
        directions = [Direction(system, e) for e in self.motion.vectors]
        if not joined.meets:
            return None
        together, apart = [joined.work(d) for d in directions], [self._work(d, g.zero) for d in directions]
        return joined if count(g, together) < count(g, apart) else None

    def kinetic_energy(self) -> Node:
        """T on the motion, in the values of its forms."""
        return self._to_motion.of([self.kinetic.tau])[0]

    def work_on_constraints(self, spread: Spread, *, by_columns: bool) -> tuple[Node, ...] | None:
        """lambda_alpha with the rates' symbols, all by one reverse sweep of the virtual power over the constraints' forms.

        Of the rates, the forms' own come by one forward sweep, or ``by_columns``, vector by vector, which may be shorter of few.
        None where forms on moving axes have a term domega of their own; not for systems with rotations.
        """
        g, system = self.system.graph, self.system
        if self._gyro or (self._moved and self._own):
            return None
        rates = self._changes(by_columns)
        momenta = [g.add(a, b) for a, b in zip(self.pi_drift, self._momenta(rates), strict=True)]
        explicit = gradient(g, self.kinetic.tau, system.q), gradient(g, self._potential, system.q)
        slopes = self._to_motion.of(explicit[0]), self._on_places.of(explicit[1])
        applied = [g.sum(parts) for parts in zip(self._applied()[0], *slopes, strict=True)]
        turns = self._turns()
        weighted = [*zip(spread.forms, momenta, strict=True)]
        weighted += [(v, g.sub(turn, force)) for v, turn, force in zip(spread.velocities, turns, applied, strict=True)]
        return tuple(pullback_gradient(g, weighted, spread.held))

    def spread(self, frame: Frame) -> Spread:
        """What the constraints' forms give to T's forms and to the velocities, on the axes of the spec."""
        g, system = self.system.graph, self.system
        velocities = frame.all_kinematics
        forms = substitute(g, self.kinetic.atoms, moving(system, velocities))
        return Spread(tuple(forms), velocities, frame.omega[: system.l])

    def _changes(self, by_columns: bool) -> list[Node]:
        """What the rates of the kept velocities give to those of T's forms."""
        g, w, rates = self.system.graph, self.motion.w, self.motion.rates
        if not by_columns:
            return tangent(g, self.u, dict(zip(w, rates, strict=True)))
        return [
            g.sum([g.mul(column[k], rate) for column, rate in zip(self.columns, rates, strict=True)])
            for k in range(len(self.carried))
        ]

    @cached_property
    def _own(self) -> list[int]:
        """The forms of T with a term domega of their own."""
        return [k for k, carried in enumerate(self.carried) if not carried and not self.kinetic.is_exact(k)]

    def _turns(self) -> list[Node]:
        """pi_k (d/dt dW_k/dq'_i - dW_k/dq_i), the terms pi_k domega_k(X, .) of the forms that have them."""
        g, system = self.system.graph, self.system
        own = self._own
        if not own:
            return [g.zero] * system.n
        held = [g.symbol(f"pi_{k}", "test") for k in own]
        total = g.dot(held, [self.kinetic.atoms[k] for k in own])
        rates = tangent(g, gradient(g, total, system.v), self._along.seeds)
        turns = [g.sub(rate, slope) for rate, slope in zip(rates, gradient(g, total, system.q), strict=True)]
        put = self._values | {symbol: self.pi[k] for symbol, k in zip(held, own, strict=True)}
        return substitute(g, turns, put)

    def _add_turning(self, moved: Moved) -> list[Vector]:
        """Adds omega x p of all that turns, p T's slopes with the points at rest, and the loads, to the rates of the momenta.

        What turns and is no form of T is returned.
        """
        g, kinetic, left = self.system.graph, self.kinetic, list[Vector]()
        at_rest = {u: g.zero for u, inertial in zip(kinetic.u, moved.inertial, strict=True) if inertial}
        slopes = substitute(g, kinetic.slope, {**self._values, **at_rest})
        for turning in moved.turning:
            x, y, z = (g.sum([slopes[k] for k in axis]) for axis in turning.members)
            gyro = cross(g, turning.omega, (x, y, z))
            if turning.forms is None:
                left.append(gyro)
                continue
            for k, node in zip(turning.forms, gyro, strict=True):
                if k >= 0:
                    self.pi_drift[k] = g.add(self.pi_drift[k], node)
        self.pi_drift = [g.sub(rate, load) for rate, load in zip(self.pi_drift, moved.loads, strict=True)]
        return left

    def _turning_terms(self, spins: Sequence[Vector]) -> list[tuple[Node, Node]]:
        """pi_k domega_k(X, e) of the forms that are components of angular velocities; ``spins`` are these along e."""
        return [pair for gyro, spin in zip(self._gyro, spins, strict=True) for pair in zip(gyro, spin, strict=True)]

    def _momenta(self, weights: Sequence[Node]) -> list[Node]:
        """h_jk W_k(e): the slopes of T by its forms, moved along e."""
        g = self.system.graph
        return [g.sum([g.mul(h, weights[j]) for j, h in row if weights[j]]) for row in self.hessian]

    def _gather(self, products: Iterable[Sequence[Node]]) -> Node:
        """The sum of products, with masses and speeds in front."""
        return gather(self.system.graph, products, self._constants, self._speeds)

    def _applied(self) -> tuple[list[Node], list[Node]]:
        """Q and the torques of rotations, on the motion."""
        system = self.system
        flat = [x for torque in system.torques for x in torque]
        values = self._to_motion.of([*system.Q, *flat])
        return values[: system.n], values[system.n :]


def _shared_forms(kinetic: Kinetic, frame: Frame) -> dict[int, tuple[Fraction, int]]:
    """The forms of T that are free forms of the frame: a number, and the place of the velocity that it is so many times of."""
    g, found = frame.graph, dict[int, tuple[Fraction, int]]()
    written = [form.value for form in frame.forms[frame.system.l :]]
    own = {
        rest: (number, j) for j, x in enumerate(written) if x is not None for number, rest in [g.split_coefficient(x)]
    }
    for k, atom in enumerate(kinetic.atoms):
        number, rest = g.split_coefficient(atom)
        if rest in own:
            divisor, j = own[rest]
            found[k] = (Fraction(number) / divisor, j)
    return found


def _is_unit(graph: Graph, e: Sequence[Node]) -> bool:
    """Whether the vector is that of one velocity."""
    return [x for x in e if x != graph.zero] == [graph.one]
