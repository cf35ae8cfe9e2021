"""Lagrange's equations and their 2-form (II.3), without constraints.

theta = p_i dq_i - (p_i q'_i - T) dt is the Poincaré-Cartan form; the thesis's p dq - T dt is the same only for T homogeneous and
quadratic in the velocities (erratum E4).
"""

from __future__ import annotations

from nhc.algebra.calculus import gradient
from nhc.algebra.graph import Node
from nhc.exterior import Coframe, Form, basis_form, coordinate_coframe, d, one_form, wedge
from nhc.mechanics.frame import total_derivative
from nhc.mechanics.system import System
from nhc.thesis.tie import equation


def phase_coframe(system: System) -> Coframe:
    """(dq_1..dq_n, dq'_1..dq'_n, dt)."""
    names = [f"d{name}" for name in system.q_names] + [f"d{name}'" for name in system.q_names] + ["dt"]
    return coordinate_coframe(system.graph, (*system.q, *system.v, system.t), names)


def momenta(system: System) -> list[Node]:
    """p_i = dT/dq'_i."""
    return gradient(system.graph, system.T, system.v)


@equation("II.2.2")
def kinetic_one_form(system: System) -> Form:
    """p_i dq_i - (p_i q'_i - T) dt."""
    g, p = system.graph, momenta(system)
    hamiltonian = g.sub(g.dot(p, system.v), system.T)
    return one_form(phase_coframe(system), {**dict(enumerate(p)), 2 * system.n: g.neg(hamiltonian)})


@equation("II.3.1", "II.1.4")
def kinetic_two_form(system: System) -> Form:
    """Omega_c = d(p_i dq_i - (p_i q'_i - T) dt)."""
    return d(kinetic_one_form(system))


@equation("II.2.3", "II.1.5")
def dynamic_two_form(system: System) -> Form:
    """Omega_d = Q_i dq_i ^ dt."""
    coframe = phase_coframe(system)
    work = one_form(coframe, {i: system.force(i) for i in range(system.n)})
    return wedge(work, basis_form(coframe, 2 * system.n))


@equation("II.3")
def omega(system: System) -> Form:
    """Omega = Omega_c + Omega_d."""
    return kinetic_two_form(system) + dynamic_two_form(system)


@equation("II.3")
def printed_rows(system: System, rates: tuple[Node, ...]) -> list[Node]:
    """d/dt dT/dq'_i - dT/dq_i - Q_i, with q'' = ``rates``."""
    g = system.graph
    acceleration = dict(zip(system.v, rates, strict=True))
    slopes = gradient(g, system.T, system.q)
    rows = []
    for i, p in enumerate(momenta(system)):
        row = g.sub(total_derivative(system, p, system.v, acceleration), slopes[i])
        rows.append(g.sub(row, system.force(i)))
    return rows
