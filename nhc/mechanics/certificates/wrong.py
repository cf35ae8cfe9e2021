"""Derivations that tempt and are wrong, kept so that their distance from the truth can be measured.  Nothing is emitted from here.

Each function returns rows as the ``printed_rows`` of the right formulations do: expressions that this way of thinking would put to
zero, with the rates of the free velocities as given symbols.  The errata they belong to stand in ``docs/thesis/errata.md``.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from nhc.algebra.calculus import derivative, gradient
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.mechanics.formulations import euler_lagrange
from nhc.mechanics.formulations.voronec import Reduced, applied_force, motion_rate
from nhc.mechanics.frame import Frame, total_derivative
from nhc.records import record

Rows = list[Node]


# --- in the coordinates' own velocities -------------------------------------------------------------------


def lagrange_of_T_star(reduced: Reduced, rates: tuple[Node, ...]) -> Rows:
    """Lagrange's equations of T*: the constraints are put into T before it is varied (the other way round the diagram of III.3)."""
    return _voronec_rows(reduced, rates, lambda a, k: reduced.graph.zero)


def boxed_I_3_sign(reduced: Reduced, rates: tuple[Node, ...]) -> Rows:
    """The boxed line of I.3: the constraints' curl with the opposite sign (erratum E1)."""
    return _voronec_rows(reduced, rates, lambda a, k: reduced.graph.neg(_turning(reduced, rates, a, k)))


def noaffine(reduced: Reduced, rates: tuple[Node, ...]) -> Rows:
    """(I.4.9) as it stands, outside its hypothesis b_alpha = 0: the bracket differentiates b_alphanu q'_nu alone."""
    g = reduced.graph

    def turning(a: int, k: int) -> Node:
        lower = reduced.system.l
        return g.add(_turning(reduced, rates, a, k), reduced.frame.along(reduced.b_0[a], lower + k))

    return _voronec_rows(reduced, rates, turning)


def I_4_9_mu_thrice(reduced: Reduced, rates: tuple[Node, ...]) -> Rows:
    """The last line of III.4: one index thrice, b_betanu d_beta b_alphanu where b_betamu belongs, and no b_alpha (erratum E7)."""
    g, system = reduced.graph, reduced.system

    def turning(a: int, k: int) -> Node:
        total = motion_rate(reduced, reduced.b[a][k], rates)
        for m, v in enumerate(reduced.v_mu):
            entry = reduced.b[a][m]
            slope = derivative(g, entry, system.q[reduced.mu[k]])
            for c, alpha in enumerate(reduced.alpha):
                slope = g.add(slope, g.mul(reduced.b[c][m], derivative(g, entry, system.q[alpha])))
            total = g.sub(total, g.mul(v, slope))
        return total

    return _voronec_rows(reduced, rates, turning)


def _voronec_rows(reduced: Reduced, rates: tuple[Node, ...], turning: Callable[[int, int], Node]) -> Rows:
    """d/dt dT*/dq'_mu - (d_mu + b_betamu d_beta) T* - Q_mu - b_betamu Q_beta - p_alpha turning(alpha, mu)."""
    g, lower = reduced.graph, reduced.system.l
    rows = []
    for k, momentum in enumerate(gradient(g, reduced.T_star, reduced.v_mu)):
        right = g.add(reduced.frame.along(reduced.T_star, lower + k), applied_force(reduced, k))
        for a, p in enumerate(reduced.p_alpha):
            right = g.add(right, g.mul(p, turning(a, k)))
        rows.append(g.sub(motion_rate(reduced, momentum, rates), right))
    return rows


def _turning(reduced: Reduced, rates: tuple[Node, ...], a: int, k: int) -> Node:
    """b'_alphamu - (d_mu + b_betamu d_beta)(b_alphanu q'_nu + b_alpha): what belongs there."""
    change = motion_rate(reduced, reduced.b[a][k], rates)
    return reduced.graph.sub(change, reduced.frame.along(reduced.velocity(a), reduced.system.l + k))


# --- in quasi-velocities ----------------------------------------------------------------------------------


def III_2_6_as_printed(frame: Frame, rates: tuple[Node, ...]) -> Rows:
    """(III.2.6): gamma and epsilon are contracted with the momenta of the free quasi-velocities only (erratum E3)."""
    return _hamel_rows(frame, rates, range(frame.system.l, frame.system.n), 1)


def III_2_4_doubled_gamma(frame: Frame, rates: tuple[Node, ...]) -> Rows:
    """(III.2.4), (III.2.5): the sum over all index pairs in place of that over increasing ones, gamma twice (erratum E2)."""
    return _hamel_rows(frame, rates, range(frame.system.n), 2)


def _hamel_rows(frame: Frame, rates: tuple[Node, ...], upper: Sequence[int], times: int) -> Rows:
    """(I.2.15) with the momenta of ``upper`` and gamma ``times`` over."""
    system, g, lower = frame.system, frame.graph, frame.system.l
    energy = euler_lagrange.quasi_energy(frame)
    forces = euler_lagrange.quasi_forces(frame)
    on = {w: g.zero for w in frame.omega[:lower]}
    momenta = substitute(g, gradient(g, energy, frame.omega), on)
    moving = dict(zip(frame.free, rates, strict=True))
    rows = []
    for mu in range(lower, system.n):
        row = total_derivative(system, momenta[mu], frame.kinematics, moving)
        for i in upper:
            swirl = [g.mul(frame.gamma(i, nu, mu), frame.omega[nu]) for nu in range(lower, system.n)]
            turn = g.add(frame.epsilon(i, mu), g.mul(g.number(times), g.sum(swirl)))
            row = g.add(row, g.mul(turn, momenta[i]))
        slope, force = substitute(g, [frame.along(energy, mu), forces[mu]], on)
        rows.append(g.sub(g.sub(row, slope), force))
    return rows


# --- all of them ------------------------------------------------------------------------------------


@record
class OnReduced:
    """A wrong derivation in the independent velocities; ``erratum`` is empty where the text itself does not err."""

    name: str
    erratum: str
    about: str
    rows: Callable[[Reduced, tuple[Node, ...]], Rows]


@record
class OnFrame:
    """A wrong derivation in quasi-velocities."""

    name: str
    erratum: str
    about: str
    rows: Callable[[Frame, tuple[Node, ...]], Rows]


REDUCED = (
    OnReduced("lagrange_of_T_star", "", "constraints put into T before it is varied", lagrange_of_T_star),
    OnReduced("boxed_I_3_sign", "E1", "the boxed line of I.3, its bracket with the wrong sign", boxed_I_3_sign),
    OnReduced("I_4_9_mu_thrice", "E7", "the last line of III.4, one index three times", I_4_9_mu_thrice),
    OnReduced("noaffine", "", "b_alpha left out of the bracket of I.4.9", noaffine),
)
FRAME = (
    OnFrame("III_2_6_as_printed", "E3", "III.2.6, momenta of the free quasi-velocities only", III_2_6_as_printed),
    OnFrame("III_2_4_doubled_gamma", "E2", "III.2.4, the gamma terms counted twice", III_2_4_doubled_gamma),
)
