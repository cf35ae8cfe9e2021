"""Newton's equations of free particles (II.1): T = m_i v_i^2 / 2 with constant masses, and no constraint."""

from __future__ import annotations

from nhc.algebra.calculus import gradient
from nhc.algebra.exact.modular import are_zero, is_zero
from nhc.diagnostics import several
from nhc.exterior import Form, basis_form, one_form, wedge
from nhc.mechanics.formulations.lagrange import momenta, phase_coframe
from nhc.mechanics.system import System
from nhc.thesis.tie import equation


def broken_hypotheses(system: System) -> list[str]:
    """Why Newton's form does not apply; empty where it does."""
    g, reasons = system.graph, []
    if system.constraints:
        reasons.append(
            f"the system has {several(system.l, 'constraint')}; Newton's equations (II.1) are for free points"
        )
    moving = g.mask((*system.q, *system.v, system.t))
    p = momenta(system)
    for i, momentum in enumerate(p):
        row = gradient(g, momentum, system.v)
        if any(not zero for j, zero in enumerate(are_zero(g, row)) if j != i):
            reasons.append(f"the kinetic energy couples `{system.q_names[i]}'` to another velocity")
        elif g.depends(row[i], moving):
            reasons.append(f"the inertia of `{system.q_names[i]}` is not constant")
        elif not is_zero(g, g.sub(momentum, g.mul(row[i], system.v[i]))):
            reasons.append(f"T is not homogeneous quadratic in `{system.q_names[i]}'`")
    return reasons


@equation("II.1.3", "II.1.1")
def omega(system: System) -> Form:
    """(m_i dv_i - X_i dt) ^ (dx_i - v_i dt); II.1.1 has the factors in the other order (erratum E9)."""
    g, n = system.graph, system.n
    coframe = phase_coframe(system)
    total = Form(coframe, 2, {})
    for i, momentum in enumerate(momenta(system)):
        mass = gradient(g, momentum, system.v)[i]
        force = one_form(coframe, {n + i: mass, 2 * n: g.neg(system.force(i))})
        contact = basis_form(coframe, i) - basis_form(coframe, 2 * n).scaled(system.v[i])
        total = total + wedge(force, contact)
    return total
