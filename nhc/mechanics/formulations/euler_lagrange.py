"""The Euler-Lagrange equations in quasi-velocities: Poincaré without constraints (I.2.14), Hamel with them (I.2.15,
III.2).

The sum over i in gamma^i_numu p*_i runs over all n quasi-velocities, also over those that the constraints hold at
zero (erratum E3); T is taken in all of them, and omega_alpha = 0 is used after differentiation: in Omega, never in
theta.
"""

from __future__ import annotations

from collections.abc import Sequence

from nhc.algebra.calculus import gradient, tangent
from nhc.algebra.graph import Node
from nhc.algebra.rebuilding import substitute
from nhc.exterior import Coframe, Form, basis_form, d, general_coframe, one_form, pullback, wedge
from nhc.mechanics.frame import Frame
from nhc.mechanics.rotations.turning import along, moving, virtual_work
from nhc.thesis.tie import equation


def quasi_energy(frame: Frame) -> Node:
    """T(q, omega, t) with all n quasi-velocities."""
    system = frame.system
    return substitute(system.graph, [system.T], moving(system, frame.all_kinematics))[0]


def quasi_forces(frame: Frame) -> list[Node]:
    """P_j = b_ij Q_i, as functions of the quasi-velocities."""
    system, g = frame.system, frame.graph
    if frame.turned:
        torques = [x for torque in system.torques for x in torque]
        done = [virtual_work(system, system.Q, torques, e) for e in frame.vectors]
        total = [g.add(frame.along(system.U, j), work) for j, work in enumerate(done)]
        return substitute(g, total, moving(system, frame.all_kinematics))
    forces = [system.force(i) for i in range(system.n)]
    forces = substitute(g, forces, dict(zip(system.v, frame.all_kinematics, strict=True)))
    return [g.dot(e, forces) for e in frame.vectors]


@equation("I.2.3")
def full_coframe(frame: Frame) -> Coframe:
    """(dpi_1..dpi_n, domega_1..domega_n, dt) with dpi_j = a_jr dq_r, r over the coordinates and the time."""
    system, g, n = frame.system, frame.graph, frame.system.n
    variables = (*system.q, *frame.omega, system.t)
    zeros, size = [g.zero], 2 * n + 1
    unit = [[g.one if r == k else g.zero for r in range(size)] for k in range(size)]
    rows = [[*form.coefficients, *zeros * n, form.constant] for form in frame.forms]
    rows += unit[n:]
    dual = [[*e, *zeros * n, g.zero] for e in frame.vectors]
    dual += unit[n : 2 * n]
    dual.append([*frame.drift, *zeros * n, g.one])
    names = [f"dpi_{form.name}" for form in frame.forms] + [f"domega_{form.name}" for form in frame.forms] + ["dt"]
    if frame.turned:
        return _turned_coframe(frame, variables, names, dual)
    return general_coframe(g, variables, names, rows, dual)


def _turned_coframe(
    frame: Frame, variables: Sequence[Node], names: Sequence[str], dual: Sequence[Sequence[Node]]
) -> Coframe:
    """With the structure equations by gamma and epsilon, which rotations give in closed form: d dpi_k = gamma^k_ts dpi_t ^ dpi_s
    over t < s, less epsilon^k_s dpi_s ^ dt.
    """
    system, g, n = frame.system, frame.graph, frame.system.n
    structure: dict[int, dict[tuple[int, int], Node]] = {}
    for k in range(n):
        terms = {(t, s): frame.gamma(k, t, s) for t in range(n) for s in range(t + 1, n)}
        terms |= {(s, 2 * n): g.neg(frame.epsilon(k, s)) for s in range(n)}
        kept = {pair: node for pair, node in terms.items() if node != g.zero}
        if kept:
            structure[k] = kept
    inner: list[dict[Node, Node]] = [along(system, e) for e in frame.vectors]
    inner += [{} for _ in range(n)] + [along(system, frame.drift)]
    made = tuple(tuple(d) for d in dual)
    return Coframe(g, tuple(names), tuple(variables), made, structure, tuple(inner))


def kinetic_one_form(frame: Frame) -> Form:
    """p*_j dpi_j - (p*_j omega_j - T) dt."""
    g, n = frame.graph, frame.system.n
    energy = quasi_energy(frame)
    momenta = gradient(g, energy, frame.omega)
    hamiltonian = g.sub(g.dot(momenta, frame.omega), energy)
    return one_form(full_coframe(frame), {**dict(enumerate(momenta)), 2 * n: g.neg(hamiltonian)})


@equation("III.2.2", "III.2.3", "III.2.4")
def kinetic_two_form(frame: Frame) -> Form:
    """Omega_c = d(p*_j dpi_j - (p*_j omega_j - T) dt); d(dpi_j) brings the gamma and epsilon terms."""
    return d(kinetic_one_form(frame))


@equation("III.2.1")
def dynamic_two_form(frame: Frame) -> Form:
    """Omega_d = P_j dpi_j ^ dt."""
    coframe = full_coframe(frame)
    work = one_form(coframe, dict(enumerate(quasi_forces(frame))))
    return wedge(work, basis_form(coframe, 2 * frame.system.n))


@equation("III.2.5")
def unconstrained_omega(frame: Frame) -> Form:
    """Omega in all n quasi-velocities."""
    return kinetic_two_form(frame) + dynamic_two_form(frame)


def restrict(frame: Frame, form: Form) -> Form:
    """The form on the constraints: dpi_alpha = 0, omega_alpha = 0, domega_alpha = 0."""
    g, n, lower = frame.graph, frame.system.n, frame.system.l
    keep = [*range(lower, n), *range(n + lower, 2 * n), 2 * n]
    source = form.coframe
    target = Coframe(
        g,
        tuple(source.names[k] for k in keep),
        source.variables,
        tuple(source.dual[k] for k in keep),
    )
    position = {k: m for m, k in enumerate(keep)}
    images = [one_form(target, {position[k]: g.one} if k in position else {}) for k in range(len(source))]
    return pullback(form, target, images, {w: g.zero for w in frame.omega[:lower]})


def omega(frame: Frame) -> Form:
    """Omega on the constraints."""
    return restrict(frame, unconstrained_omega(frame))


@equation("I.2.15", "I.2.14", "III.2.6", "I.2.13")
def printed_rows(frame: Frame, rates: tuple[Node, ...]) -> list[Node]:
    """d/dt dT/domega_mu + (gamma^i_numu omega_nu + epsilon^i_mu) dT/domega_i - dT/dpi_mu - P_mu, omega'_mu =
    ``rates``.
    """
    system, g, lower = frame.system, frame.graph, frame.system.l
    energy = quasi_energy(frame)
    momenta = gradient(g, energy, frame.omega)
    forces = quasi_forces(frame)
    on_constraints = {w: g.zero for w in frame.omega[:lower]}
    momenta_on = substitute(g, momenta, on_constraints)
    seeds = {
        **dict(zip(system.q, frame.kinematics, strict=True)),
        **dict(zip(frame.free, rates, strict=True)),
        system.t: g.one,
    }
    rows = []
    for mu in range(lower, system.n):
        row = tangent(g, [momenta_on[mu]], seeds)[0]
        for i in range(system.n):
            swirl = frame.epsilon(i, mu)
            for nu in range(lower, system.n):
                swirl = g.add(swirl, g.mul(frame.gamma(i, nu, mu), frame.omega[nu]))
            row = g.add(row, g.mul(swirl, momenta_on[i]))
        slope, force = substitute(g, [frame.along(energy, mu), forces[mu]], on_constraints)
        rows.append(g.sub(g.sub(row, slope), force))
    return rows
