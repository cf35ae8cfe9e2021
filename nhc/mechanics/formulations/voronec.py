"""Voronec's equations (I.4.9, III.4), general: affine and time-dependent constraints, any T, any forces.

    d/dt dT*/dq'_mu = dT*/dq_mu + b_betamu dT*/dq_beta + Q_mu + b_betamu Q_beta
                    + p_alpha { b'_alphamu - (d_mu + b_betamu d_beta)(b_alphanu q'_nu + b_alpha) }

with p_alpha = dT/dq'_alpha from the full T.  (I.4.9) is the case b_alpha = 0 without explicit time.
"""

from __future__ import annotations

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.graph import Graph, Node
from nhc.algebra.rebuilding import substitute
from nhc.exterior import Coframe, Form, basis_form, one_form, wedge
from nhc.mechanics.frame import Frame, dependent_coefficients
from nhc.mechanics.system import System
from nhc.records import record
from nhc.thesis.tie import equation


@record
class Reduced:
    """What the reduced equations are made of: T*, p_alpha, Q on the constraints, b and b_alpha.

    ``mu`` and ``alpha`` are the indices of the independent and the dependent coordinates.
    """

    frame: Frame
    mu: tuple[int, ...]
    alpha: tuple[int, ...]
    b: tuple[tuple[Node, ...], ...]
    b_0: tuple[Node, ...]
    T_star: Node
    p_alpha: tuple[Node, ...]
    slopes: tuple[Node, ...]
    Q: tuple[Node, ...]

    @property
    def system(self) -> System:
        return self.frame.system

    @property
    def graph(self) -> Graph:
        return self.frame.graph

    @property
    def v_mu(self) -> tuple[Node, ...]:
        return self.frame.free

    def velocity(self, a: int) -> Node:
        """q'_alpha = b_alphanu q'_nu + b_alpha for the a-th dependent coordinate."""
        g = self.graph
        return g.add(g.dot(self.b[a], self.v_mu), self.b_0[a])


@equation("I.4.3", "I.3.3")
def reduce(frame: Frame, dependent: tuple[int, ...]) -> Reduced:
    """Put the constraints into T, its momenta, slopes and forces (each after its own differentiation)."""
    system, g = frame.system, frame.graph
    b, b_0 = dependent_coefficients(frame, dependent)
    mu = tuple(i for i in range(system.n) if i not in dependent)
    on = dict(zip(system.v, frame.kinematics, strict=True))
    p = gradient(g, system.T, system.v)
    slopes = gradient(g, system.T, system.q)
    forces = [system.force(i) for i in range(system.n)]
    T_star, *rest = substitute(g, [system.T, *p, *slopes, *forces], on)
    n = system.n
    return Reduced(
        frame=frame,
        mu=mu,
        alpha=tuple(dependent),
        b=b,
        b_0=b_0,
        T_star=T_star,
        p_alpha=tuple(rest[a] for a in dependent),
        slopes=tuple(rest[n : 2 * n]),
        Q=tuple(rest[2 * n :]),
    )


@equation("I.4.9", "I.4.4", "I.4.8", "III.4")
def printed_rows(reduced: Reduced, rates: tuple[Node, ...]) -> list[Node]:
    """d/dt dT*/dq'_mu minus the right side above, with q''_mu = ``rates``."""
    g, frame = reduced.graph, reduced.frame
    rows = []
    for k, momentum in enumerate(gradient(g, reduced.T_star, reduced.v_mu)):
        right = frame.along(reduced.T_star, frame.system.l + k)
        right = g.add(right, applied_force(reduced, k))
        for a, p in enumerate(reduced.p_alpha):
            turning = g.sub(
                motion_rate(reduced, reduced.b[a][k], rates), frame.along(reduced.velocity(a), frame.system.l + k)
            )
            right = g.add(right, g.mul(p, turning))
        rows.append(g.sub(motion_rate(reduced, momentum, rates), right))
    return rows


def applied_force(reduced: Reduced, k: int) -> Node:
    """Q_mu + b_betamu Q_beta."""
    g = reduced.graph
    others = [g.mul(reduced.b[a][k], reduced.Q[alpha]) for a, alpha in enumerate(reduced.alpha)]
    return g.add(reduced.Q[reduced.mu[k]], g.sum(others))


def motion_rate(reduced: Reduced, node: Node, rates: tuple[Node, ...]) -> Node:
    """d/dt on the motion."""
    system = reduced.system
    seeds = {
        **dict(zip(system.q, reduced.frame.kinematics, strict=True)),
        **dict(zip(reduced.v_mu, rates, strict=True)),
        system.t: reduced.graph.one,
    }
    return tangent(reduced.graph, [node], seeds)[0]


def reduced_coframe(reduced: Reduced) -> Coframe:
    """(dq_mu, dq'_mu, dt), functions being differentiated with dq_alpha = b_alphamu dq_mu + b_alpha dt."""
    system, g, frame = reduced.system, reduced.graph, reduced.frame
    m = len(reduced.mu)
    zeros = (g.zero,) * m
    unit = [tuple(g.one if r == k else g.zero for r in range(m)) for k in range(m)]
    dual = [(*e, *zeros, g.zero) for e in frame.free_vectors]
    dual += [(*(g.zero,) * system.n, *u, g.zero) for u in unit]
    dual.append((*frame.drift, *zeros, g.one))
    names = [f"d{system.q_names[i]}" for i in reduced.mu] + [f"d{system.q_names[i]}'" for i in reduced.mu] + ["dt"]
    return Coframe(g, tuple(names), (*system.q, *reduced.v_mu, system.t), tuple(dual))


@equation("III.4", "III.4.1", "III.4.2", "III.4.3", "III.4.4", "III.3.1")
def omega(reduced: Reduced) -> Form:
    """(d(dT*/dq'_mu) - p_alpha db_alphamu - R_mu dt) ^ (dq_mu - q'_mu dt), the master form of ch. III."""
    g, m = reduced.graph, len(reduced.mu)
    coframe = reduced_coframe(reduced)
    dt = basis_form(coframe, 2 * m)
    total = Form(coframe, 2, {})
    for k, momentum in enumerate(gradient(g, reduced.T_star, reduced.v_mu)):
        left = one_form(coframe, coframe.differential(momentum))
        for a, p in enumerate(reduced.p_alpha):
            left = left - one_form(coframe, coframe.differential(reduced.b[a][k])).scaled(p)
        slope = [g.mul(reduced.b[a][k], reduced.slopes[alpha]) for a, alpha in enumerate(reduced.alpha)]
        resultant = g.add(g.add(reduced.slopes[reduced.mu[k]], g.sum(slope)), applied_force(reduced, k))
        left = left - dt.scaled(resultant)
        total = total + wedge(left, basis_form(coframe, k) - dt.scaled(reduced.v_mu[k]))
    return total
