"""Coframes of quasi-velocities and the frames dual to them (I.2.1 - I.2.5), with gamma and epsilon (I.2.11).

A frame has n forms omega_i = a_ij q'_j + a_{i,n+1}; the first l are the constraints.  Its inverse gives the vectors
``e_j`` (columns b_ij) and the drift ``e_0`` (b_{i,n+1} = -b_ik a_{k,n+1}), so that q'_i = b_ij omega_j + b_{i,n+1}.
The coordinate coframe of Čaplygin and Voronec is the one whose free forms are dq_mu.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import cached_property

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.exact.modular import rank
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.algebra.solving.linear import is_clearly_regular, solve_rows
from nhc.algebra.solving.sizes import size_of
from nhc.mechanics.regular.regularity import pivot_weakness
from nhc.mechanics.rotations import turning
from nhc.mechanics.rotations.other_axes import choose_axes, turn_omega
from nhc.mechanics.rotations.rotation import Rotation
from nhc.mechanics.rotations.turning import Direction, along, from_base
from nhc.mechanics.row_factors import common_parameters, strip_factor
from nhc.mechanics.system import Form, System
from nhc.records import fresh, record, structure
from nhc.thesis.tie import equation

Guards = tuple[tuple[Node, Node], ...]


@record
class Frame:
    """A coframe (I.2.1): n velocity forms, the l constraints first, and its inverse, which is solved for on demand.

    ``forms`` are the forms omega_i = a_ij q'_j + a_i,n+1, and ``omega`` their symbols.  ``vectors[j][i]`` is b_ij of the inverse
    q'_i = b_ij omega_j + b_i,n+1 (I.2.4).  ``symbols`` stand for the values of the forms in what ``solve`` returns; they are
    ``omega`` unless the caller gave others.  ``solve(everything)`` returns q' (n nodes) and the guards, which must not vanish.
    Without ``everything`` the constraints' values are put to zero, which is all that the motion needs; reactions need the rest.
    """

    system: System
    forms: tuple[Form, ...]
    omega: tuple[Node, ...]
    symbols: tuple[Node, ...]
    solve: Callable[[bool], tuple[Sequence[Node], Sequence[tuple[Node, Node]]]]
    turned: tuple[Rotation, ...] = ()
    """The rotations whose angular velocity the frame was solved for, not e'."""
    bases: tuple[Rotation, ...] = ()
    """The same on the axes on which it was solved for: the spec's, or the others."""
    rows: Callable[[], tuple[list[Node], list[Node]]] | None = None
    """The rows that vanish on the motion, and the unknowns in which they are linear, one for each coordinate."""

    @property
    def graph(self) -> Graph:
        return self.system.graph

    @property
    def free(self) -> tuple[Node, ...]:
        """omega_mu, the velocities that the constraints leave free."""
        return self.omega[self.system.l :]

    @cached_property
    def _on_constraints(self) -> tuple[tuple[Node, ...], Guards]:
        found, guards = self.solve(False)
        return tuple(found), tuple(guards)

    @cached_property
    def _everywhere(self) -> tuple[Node, ...]:
        return tuple(self.solve(True)[0])

    @property
    def guards(self) -> Guards:
        """(quantity, scale) pairs that must not vanish."""
        return self._on_constraints[1]

    @cached_property
    def free_vectors(self) -> tuple[tuple[Node, ...], ...]:
        """The vectors that the constraints leave free."""
        return self._vectors(self._on_constraints[0], self.symbols[self.system.l :])

    @cached_property
    def vectors(self) -> tuple[tuple[Node, ...], ...]:
        """e_j, those of the constraints first."""
        if not self.system.l:
            return self.free_vectors
        return (*self._vectors(self._everywhere, self.symbols[: self.system.l]), *self.free_vectors)

    def _vectors(self, found: Sequence[Node], symbols: Sequence[Node]) -> tuple[tuple[Node, ...], ...]:
        g = self.graph
        return tuple(self._from_base(tangent(g, found, {w: g.one})) for w in symbols)

    def _from_base(self, b: Sequence[Node]) -> tuple[Node, ...]:
        """The vector with these components, of which the rotations' omega is known on the spec's axes, too."""
        g, made = self.graph, from_base(self.system, b, self.bases)
        for own, base in zip(self.turned, self.bases, strict=True):
            if own is not base:
                first, *omega = (b[k] for k in own.places)
                own.known.setdefault(tuple(made[k] for k in own.places), (first, *turn_omega(g, own, omega)))
        return made

    @cached_property
    def drift(self) -> tuple[Node, ...]:
        """b_{i,n+1}."""
        still = dict.fromkeys(self.symbols, self.graph.zero)
        return self._from_base(substitute(self.graph, self._on_constraints[0], still, named=False))

    @cached_property
    def all_kinematics(self) -> tuple[Node, ...]:
        """q'_i = b_ij omega_j + b_{i,n+1} with all n of them, before the constraints are used."""
        return self._named(self._everywhere if self.system.l else self._on_constraints[0])

    @cached_property
    @equation("I.2.4")
    def kinematics(self) -> tuple[Node, ...]:
        """q'_i = b_imu omega_mu + b_{i,n+1}, on the constraints."""
        return self._named(self._on_constraints[0])

    def _named(self, found: Sequence[Node]) -> tuple[Node, ...]:
        named = {x: w for x, w in zip(self.symbols, self.omega, strict=True) if x != w}
        return self._from_base(substitute(self.graph, found, named) if named else found)

    @equation("I.2.5")
    def along(self, function: Node, j: int) -> Node:
        """d function / d pi_j = b_ij d function / d q_i."""
        return tangent(self.graph, [function], along(self.system, self.vectors[j]))[0]

    @equation("I.2.11")
    def gamma(self, i: int, t: int, j: int) -> Node:
        """gamma^i_tj = (da_ir/dq_s - da_is/dq_r) b_st b_rj; t = n stands for the time index n + 1 (then it is epsilon^i_j)."""
        g, n = self.graph, self.system.n
        if self.turned:
            x = Direction(self.system, self.vectors[t]) if t < n else Direction(self.system, self.drift, g.one)
            closed = turning.derivative_by_turns(self.system, self.forms[i], x, Direction(self.system, self.vectors[j]))
            if closed is not None:
                return closed
        first = (*self.vectors[t], g.zero) if t < self.system.n else (*self.drift, g.one)
        second = self.vectors[j]
        total = g.zero
        for s, bs in enumerate(first):
            if bs == g.zero:
                continue
            for r, br in enumerate(second):
                if br == g.zero or r == s:
                    continue
                total = g.add(total, g.mul(g.mul(self._curl(i)[r][s], bs), br))
        return total

    def epsilon(self, i: int, j: int) -> Node:
        """epsilon^i_j = gamma^i_{n+1,j}; zero for homogeneous quasi-velocities that do not contain the time."""
        return self.gamma(i, self.system.n, j)

    @cached_property
    def _curls(self) -> dict[int, list[list[Node]]]:
        return {}

    def _curl(self, i: int) -> list[list[Node]]:
        """[r][s] = da_ir/dq_s - da_is/dq_r with q_{n+1} = t."""
        if i not in self._curls:
            g, form = self.graph, self.forms[i]
            variables = (*self.system.q, self.system.t)
            slopes = [gradient(g, a, variables) for a in (*form.coefficients, form.constant)]
            size = len(variables)
            self._curls[i] = [[g.sub(slopes[r][s], slopes[s][r]) for s in range(size)] for r in range(size)]
        return self._curls[i]

    def velocity_of(self, form: Form) -> Node:
        """The value of a velocity form on the motion's q'."""
        return self.graph.add(self.graph.dot(form.coefficients, self.kinematics), form.constant)


@equation("I.1.1")
def form_value(system: System, form: Form) -> Node:
    """a_i q'_i + a_0 over the system's velocities, in the spec's own words where there are any."""
    if form.value is not None:
        return form.value
    return system.graph.add(system.graph.dot(form.coefficients, system.v), form.constant)


@equation("I.2.1", "I.2.2")
def make_frame(system: System, free: Sequence[Form], symbols: Sequence[Node], *, known: bool = False) -> Frame:
    """The frame whose forms are the system's constraints and ``free``, in this order; ``known``: that they are a basis.

    Raises:
        nhc.algebra.dense.Singular: the forms are no basis.
    """
    g = system.graph
    forms = (*system.constraints, *free)
    constrained = tuple(g.symbol(f"omega_{form.name}", "quasi") for form in system.constraints)
    omega = (*constrained, *symbols)
    # a kept velocity may be its own symbol: the unknowns get symbols of their own
    unknowns = [g.symbol(name, "unknown") for name in system.q_names]
    turned = tuple(r for r in system.rotations if not set(r.v) & set(symbols))
    written = [form_value(system, form) for form in forms]
    bases, spoken = choose_axes(g, turned, written)

    def rename() -> list[Node]:
        rates = from_base(system, unknowns, bases)
        on = dict(zip(system.v, rates, strict=True))
        for base in (*(r for r in system.rotations if r not in turned), *bases):
            on |= base.moving(g, [rates[k] for k in base.places])
        return substitute(g, spoken, on)

    def list_rows(everything: bool) -> tuple[list[Node], list[Node]]:
        values, sides = rename(), list(omega)
        for k, form in enumerate(forms):
            if form.line is not None:
                sides[k] = g.mul(form.line.square, omega[k])
                values[k] = form.line.value(g, unknowns)
        bare = [] if everything else [strip_factor(g, x, g.mask(system.p)) for x in values[: system.l]]
        rows = [own.row for own in bare]
        rows += [g.sub(x, w) for x, w in zip(values[len(bare) :], sides[len(bare) :], strict=True)]
        return rows, [divisor for own in bare for divisor in own.divisors]

    def solve(everything: bool) -> tuple[Sequence[Node], Sequence[tuple[Node, Node]]]:
        rows, divisors = list_rows(everything)
        led = _follow_lines(system, forms, omega, unknowns, rows if everything else None)
        others = [x for x in unknowns if x not in led.velocities]
        left = substitute(g, [row for k, row in enumerate(rows) if k not in led.rows], led.velocities)
        found, guards = solve_rows(g, left, others, pivot_weakness(system))
        values = {**led.velocities, **dict(zip(others, found, strict=True))}
        return [values[x] for x in unknowns], [*((divisor, divisor) for divisor in divisors), *led.guards, *guards]

    frame = Frame(system, forms, omega, omega, solve, turned, bases, lambda: (list_rows(everything=False)[0], unknowns))
    if not known:
        rows, velocities = (rename(), unknowns) if system.rotations else (written, system.v)
        if not is_clearly_regular(g, rows, velocities):
            frame.kinematics  # noqa: B018 - refuses what is no basis
    return frame


@structure
class _Led:
    """Unknowns that follow from lines, by symbol; the rows of the coframe that say so; what must not vanish for that."""

    velocities: dict[Node, Node] = fresh(factory=dict)
    rows: set[int] = fresh(factory=set)
    guards: list[tuple[Node, Node]] = fresh(factory=list)


def _follow_lines(
    system: System, forms: Sequence[Form], omega: Sequence[Node], unknowns: Sequence[Node], rows: Sequence[Node] | None
) -> _Led:
    """Without ``rows``, which hold the constraints' values, these are zero."""
    g, led = system.graph, _Led()
    for k, line in ((k, form.line) for k, form in enumerate(forms) if form.line is not None):
        closed, own = closed_rows(system, line.columns), [unknowns[j] for j in line.columns]
        across: Sequence[Node] = [line.carried[j] for j in line.columns]
        if rows is not None:
            across, _ = solve_rows(
                g, [*(rows[r] for r in closed), line.value(g, unknowns)], own, pivot_weakness(system)
            )
        for j, x, there in zip(line.columns, own, across, strict=True):
            led.velocities[x] = g.add(g.mul(line.vector[j], omega[k]), there)
        led.rows |= {k, *closed}
        square = g.sum(g.power(x, 2) for x in line.vector)
        led.guards.append((square, size_of(g, square)))
        rows_of = (system.constraints[r].coefficients for r in closed)
        shared = [p for row in rows_of for p in common_parameters(g, row, g.mask(system.p))]
        led.guards += [(p, p) for p in (*line.over, *shared)]
    return led


def closed_rows(system: System, columns: Sequence[int]) -> list[int]:
    """The constraints that hold no other velocities than those in these columns."""
    outside = [j for j in range(system.n) if j not in columns]
    zero = system.graph.zero
    return [r for r, form in enumerate(system.constraints) if all(form.coefficients[j] == zero for j in outside)]


def coordinate_form(system: System, i: int) -> Form:
    """dq_i as a form."""
    g = system.graph
    return Form(
        name=system.q_names[i],
        coefficients=tuple(g.one if j == i else g.zero for j in range(system.n)),
        constant=g.zero,
    )


def complete_basis(system: System, given: Sequence[Form], pool: Iterable[Form]) -> list[Form]:
    """The first forms of the pool that are independent of each other and of those given, until all are as many as coordinates."""
    chosen: list[Form] = []
    rows = [list(form.coefficients) for form in given]
    for form in pool:
        if len(rows) == system.n:
            break
        if rank(system.graph, [*rows, list(form.coefficients)]) > len(rows):
            rows.append(list(form.coefficients))
            chosen.append(form)
    return chosen


def kept_forms(system: System, frame: Frame | None) -> tuple[Form, ...]:
    """The forms of the velocities that a motion keeps: those that the constraints leave free, or without a frame all q'."""
    if frame is None:
        return tuple(coordinate_form(system, i) for i in range(system.n))
    return frame.forms[system.l :]


def velocity_symbol(system: System, form: Form) -> Node:
    """A coordinate's differential has the velocity's own symbol, another form that of a quasi-velocity of its name."""
    if form.name in system.q_names and not any(form is own for own in system.quasi):
        return system.v[system.q_names.index(form.name)]
    return system.graph.symbol(form.name, "quasi")


@equation("I.3.1")
def coordinate_frame(system: System, dependent: Sequence[int]) -> Frame:
    """The coframe (omega_alpha, dq_mu) of Čaplygin and Voronec: (I.1.2) solved for the dependent velocities."""
    independent = [i for i in range(system.n) if i not in dependent]
    return make_frame(system, [coordinate_form(system, i) for i in independent], [system.v[i] for i in independent])


@equation("I.1.2")
def dependent_coefficients(
    frame: Frame, dependent: Sequence[int]
) -> tuple[tuple[tuple[Node, ...], ...], tuple[Node, ...]]:
    """(b_alpha_mu, b_alpha) of q'_alpha = b_alpha_mu q'_mu + b_alpha, read off the coordinate frame."""
    b = tuple(tuple(e[alpha] for e in frame.free_vectors) for alpha in dependent)
    return b, tuple(frame.drift[alpha] for alpha in dependent)


def total_derivative(system: System, node: Node, velocities: Sequence[Node], rates: dict[Node, Node]) -> Node:
    """d/dt along q' = velocities, t' = 1 and the given rates of further symbols."""
    seeds = {**along(system, velocities), system.t: system.graph.one, **rates}
    return tangent(system.graph, [node], seeds)[0]
